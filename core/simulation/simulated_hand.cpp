#include "core/simulation/simulated_hand.h"

namespace hrt {
namespace {

constexpr std::int64_t hand_tick_ns = 1'000'000;
constexpr std::int64_t rest_ticks = 600;

}  // namespace

SimulatedHand::SimulatedHand(double duration_s, std::uint64_t seed)
    : condition_(draw_person(people_families().front(), duration_s, seed, 0)),
      start_share_(condition_.person.start_direction_deg / condition_.virtual_direction_deg),
      seed_(seed) {}

void SimulatedHand::begin(const PlatePoint& start, double virtual_direction_deg, double distance_mm) {
  condition_.person.start_direction_deg = start_share_ * virtual_direction_deg;
  finger_.emplace(condition_.person, start, virtual_direction_deg, distance_mm,
                  Draws(seed_, PersonStream::steering, 0, reach_));
  tracking_.emplace(seed_, PersonStream::tracking, 0, reach_);
  ++reach_;
  ticks_ = 0;
  moved_ = false;
}

PlatePoint SimulatedHand::move(std::int64_t time_ns, double plate_orientation_deg) {
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
  while (ticks_ < ticks && !finger_->done()) {
    plate_.advance(began_ns_ + ++ticks_ * hand_tick_ns);
    if (ticks_ > rest_ticks) finger_->advance(plate_.orientation_deg());
  }
  plate_.advance(time_ns);
  const PlatePoint& at = finger_->position();
  const double noise_mm = condition_.tracker.white_mm;
  const double right_mm = at.right_mm + noise_mm * tracking_->normal();
  return {.right_mm = right_mm, .away_mm = at.away_mm + noise_mm * tracking_->normal()};
}

}  // namespace hrt
