#include "core/calibrate/slide_model.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "core/math/elementary.h"

namespace hrt {
namespace {

// Tangent for angles within max_direction_deg, by a continued fraction; error below 1e-5.
double tangent(double angle_deg) {
  const double x = rad_per_deg * angle_deg;
  const double xx = x * x;
  return x / (1.0 - xx / (3.0 - xx / (5.0 - xx / (7.0 - xx / 9.0))));
}

// Fraction of the path at an index that may be between two steps.
double share_at(const SlideTrack& track, double step) {
  const auto last = static_cast<double>(track.steps.size() - 1);
  const double place = std::clamp(step, 0.0, last);
  const auto below = static_cast<std::size_t>(place);
  const auto above = std::min(below + 1, track.steps.size() - 1);
  const double rest = place - static_cast<double>(below);
  return (1.0 - rest) * track.steps[below].share + rest * track.steps[above].share;
}

// Delay of the steering law: stores perceived directions, and returns the one to which the person responds now.
class SteeringDelay {
 public:
  static constexpr double max_steps = 62.0;
  // Below this speed in the direction of the target, no direction of motion is perceived.
  static constexpr double min_felt_speed_mm_s = 2.0;

  // `steps`: delay in steps, 0 to max_steps. Between steps, the perceived direction is interpolated.
  explicit SteeringDelay(double steps)
      : whole_(steps > 0.0 ? static_cast<std::size_t>(steps) : 0), part_(steps - static_cast<double>(whole_)) {}

  struct Answer {
    double felt_deg;
    // Fraction of the step during which the person responds; below 1 only in the first step after the delay.
    double share;
  };
  // Stores `felt_deg`, and returns the response of this step; nullopt during the delay.
  std::optional<Answer> feel(double felt_deg) {
    felt_deg_[felt_ % felt_deg_.size()] = felt_deg;
    const std::size_t now = felt_++;
    if (now < whole_) return std::nullopt;
    const double late_deg = felt_deg_[(now - whole_) % felt_deg_.size()];
    if (now == whole_) return Answer{late_deg, part_ > 0.0 ? 1.0 - part_ : 1.0};
    const double later_deg = felt_deg_[(now - whole_ - 1) % felt_deg_.size()];
    return Answer{(1.0 - part_) * late_deg + part_ * later_deg, 1.0};
  }

  // At rest, no direction is perceived, and earlier directions have no effect.
  void rest() { felt_ = 0; }

 private:
  std::size_t whole_;
  double part_;
  std::array<double, 64> felt_deg_{};
  std::size_t felt_ = 0;
};

}  // namespace

SlideDirections predicted_directions(const SlideTrack& track, const SlidingPersonModel& person) {
  SteeringDelay steering(std::clamp(person.delay_s / track.step_s, 0.0, SteeringDelay::max_steps));
  const double gain = std::min(exponential(person.log_gain) * track.step_s, 1.0);
  const double min_advance_mm = SteeringDelay::min_felt_speed_mm_s * track.step_s;
  SlideDirections left_mm = SlideDirections::Zero();
  double direction_deg = person.start_deg + person.start_share * settled_direction_deg(track.direction_deg);
  double here_mm = 0.0;
  const double goal_delay = person.goal_delay_s / track.step_s;
  for (std::size_t i = 0; i < track.steps.size(); ++i) {
    const SlideTrack::Step& step = track.steps[i];
    const double across_mm = step.advance_mm * tangent(direction_deg);
    if (step.samples > 0.0) left_mm(step.window) += step.samples * (here_mm + 0.5 * across_mm);
    here_mm += across_mm;
    if (step.advance_mm < min_advance_mm) {
      steering.rest();
      continue;
    }
    const double felt_deg = direction_deg + (1.0 + person.curve_drift * (2.0 * step.share - 1.0)) *
                                                curve_shift_deg(person.curve, track.plate_deg - direction_deg);
    const double goal_deg =
        person.bias_deg + person.habit_deg * (1.0 - 2.0 * share_at(track, static_cast<double>(i) - goal_delay));
    if (const auto answer = steering.feel(felt_deg))
      direction_deg = std::clamp(direction_deg - gain * answer->share * (answer->felt_deg - goal_deg),
                                 -max_direction_deg, max_direction_deg);
  }
  left_mm = left_mm.cwiseQuotient(track.window_samples);
  SlideDirections directions;
  for (int part = 0; part < slide_parts; ++part)
    directions(part) = atan2_deg(left_mm(part) - (part > 0 ? left_mm(part - 1) : 0.0), track.advance_mm(part));
  return directions;
}

}  // namespace hrt
