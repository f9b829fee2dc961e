#include "core/simulation/simulated_hand.h"

#include <algorithm>

namespace hrt {
namespace {

constexpr std::int64_t hand_tick_ns = 1'000'000;
constexpr std::int64_t rest_ticks = 600;
constexpr std::int64_t max_guided_ticks = 60'000;
constexpr double touch_sd_mm = 1.5;

}  // namespace

SimulatedHand::SimulatedHand(double duration_s, std::uint64_t seed)
    : condition_(draw_person(people_families().front(), duration_s, seed, 0)),
      start_share_(condition_.person.start_direction_deg / condition_.virtual_direction_deg),
      seed_(seed) {}

void SimulatedHand::restart() {
  tracking_.emplace(seed_, PersonStream::tracking, 0, reach_);
  ++reach_;
  ticks_ = 0;
  moved_ = false;
}

void SimulatedHand::begin(const PlatePoint& start, double virtual_direction_deg, double distance_mm) {
  condition_.person.start_direction_deg = start_share_ * virtual_direction_deg;
  finger_.emplace(condition_.person, start, virtual_direction_deg, distance_mm,
                  Draws(seed_, PersonStream::steering, 0, reach_));
  guided_.reset();
  restart();
}

void SimulatedHand::begin_setup() {
  condition_.person.start_direction_deg = 0.0;
  finger_.reset();
  guided_.emplace(condition_.person, touch_sd_mm, seed_, reach_);
  restart();
}

// Advances in milliseconds to `time_ns`; advance() returns true when the motion is over.
template <class Advance>
void SimulatedHand::pass(std::int64_t time_ns, double plate_orientation_deg, const Advance& advance) {
  if (!moved_) {
    moved_ = true;
    began_ns_ = now_ns_ = time_ns;
    commanded_deg_ = plate_orientation_deg;
    plate_ = PlateModel(condition_.plate, plate_orientation_deg);
    plate_.advance(time_ns);
  }
  commanded_deg_ = nearest_equivalent_deg(plate_orientation_deg, commanded_deg_, {});
  plate_.command(commanded_deg_);
  now_ns_ = time_ns;
  const std::int64_t ticks = (time_ns - began_ns_) / hand_tick_ns;
  while (ticks_ < ticks && !advance()) {
  }
  plate_.advance(time_ns);
}

PlatePoint SimulatedHand::move(std::int64_t time_ns, double plate_orientation_deg) {
  pass(time_ns, plate_orientation_deg, [&] {
    if (finger_->done()) return true;
    plate_.advance(began_ns_ + ++ticks_ * hand_tick_ns);
    if (ticks_ > rest_ticks) finger_->advance(plate_.orientation_deg());
    return false;
  });
  const PlatePoint& at = finger_->position();
  const double right_mm = at.right_mm + noise_mm();
  return {.right_mm = right_mm, .away_mm = at.away_mm + noise_mm()};
}

Eigen::Vector3d SimulatedHand::follow(std::int64_t time_ns, double plate_orientation_deg,
                                      const std::optional<SetupStep>& step) {
  if (step) guided_->ask(*step);
  pass(time_ns, plate_orientation_deg, [&] {
    // After a long pause of the host, only the last minute is simulated.
    ticks_ = std::max(ticks_ + 1, (time_ns - began_ns_) / hand_tick_ns - max_guided_ticks);
    plate_.advance(began_ns_ + ticks_ * hand_tick_ns);
    guided_->advance(plate_.orientation_deg());
    return false;
  });
  const double right_mm = noise_mm(), up_mm = noise_mm();
  return guided_->skin_mm() + Eigen::Vector3d(right_mm, up_mm, noise_mm());
}

}  // namespace hrt
