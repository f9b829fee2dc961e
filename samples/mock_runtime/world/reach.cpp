#include "samples/mock_runtime/world/reach.h"

#include <algorithm>
#include <cmath>

namespace hrt::mock {
namespace {

constexpr XrDuration millisecond_ns = 1'000'000;
// peak_felt_error_deg() omits the first 50 ms of the motion and slow motion, in which people perceive no direction.
constexpr double min_elapsed_s = 0.05;
constexpr double min_speed_mm_s = 10.0;
// Largest angle between the plate orientation and the direction of motion for outermost_direction_deg().
constexpr double plate_bound_deg = 75.0;

Eigen::Vector2d on_plate(const PlatePoint& point) { return {point.right_mm / mm_per_m, -point.away_mm / mm_per_m}; }

}  // namespace

Reach::Reach(const DrawnPerson& drawn, const ReachInstruction& instruction, std::uint64_t seed, std::uint32_t number,
             XrTime start)
    : simulated_(drawn.towards(instruction.goal_direction_deg)),
      person_(simulated_, {mm_per_m * instruction.start_m.x(), -mm_per_m * instruction.start_m.y()},
              instruction.goal_direction_deg, mm_per_m * instruction.path_length_m, noise_of_reach(seed, number)),
      goal_direction_deg_(instruction.goal_direction_deg),
      onset_(start + drawn.reaction_ns),
      path_{instruction.start_m} {}

double Reach::outermost_direction_deg(double sign) const {
  // In the outermost direction, the plate is at its bound on the opposite side, and the user feels no error.
  const double shift_deg = max_shift_deg(simulated_.illusion, plate_bound_deg, -sign);
  return goal_direction_deg_ + simulated_.bias_deg - simulated_.own_bias_deg + std::copysign(shift_deg, sign);
}

XrTime Reach::millisecond_end(std::size_t millisecond) const {
  return onset_ + static_cast<XrDuration>(millisecond + 1) * millisecond_ns;
}

XrTime Reach::ended() const { return onset_ + static_cast<XrDuration>(path_.size() - 1) * millisecond_ns; }

void Reach::advance(XrTime time, const PlateModel& plate) {
  for (XrTime end = millisecond_end(path_.size() - 1); !done() && end <= time; end += millisecond_ns) {
    person_.advance(plate.orientation_at_deg(end));
    path_.push_back(on_plate(person_.position()));
    if (person_.elapsed_s() > min_elapsed_s && person_.speed_mm_s() > min_speed_mm_s)
      peak_felt_error_deg_ = std::max(peak_felt_error_deg_, std::abs(person_.felt_error_deg()));
  }
}

Eigen::Vector2d Reach::position_m(XrTime time, const PlateModel& plate) const {
  const std::size_t simulated = path_.size() - 1;
  const XrDuration elapsed = time - onset_;
  if (elapsed < 0) return path_.front();
  const auto millisecond = static_cast<std::size_t>(elapsed / millisecond_ns);
  Eigen::Vector2d from = path_[std::min(millisecond, simulated)];
  Eigen::Vector2d to = path_[std::min(millisecond + 1, simulated)];
  if (millisecond >= simulated) {
    SlidingPerson predicted = person_;
    for (std::size_t i = simulated; i <= millisecond && !predicted.done(); ++i) {
      from = to;
      predicted.advance(plate.orientation_at_deg(millisecond_end(i)));
      to = on_plate(predicted.position());
      if (predicted.done() && i < millisecond) from = to;
    }
  }
  constexpr double millisecond_s = 1e-3;
  return from + static_cast<double>(elapsed % millisecond_ns) * 1e-9 * ((to - from) / millisecond_s);
}

}  // namespace hrt::mock
