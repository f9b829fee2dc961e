#include "core/setup/carried_finger.h"

#include <array>

#include "core/math/time.h"

namespace hrt {
namespace {

// Turns by 10 to 40 degrees at uneven times: turns that repeat would fit several latencies.
struct Turn {
  double at_s;
  double to_deg;
};
constexpr std::array<Turn, 14> turns{{{0.7, 18.0},
                                      {1.25, -12.0},
                                      {2.05, 5.0},
                                      {2.4, 20.0},
                                      {3.1, -20.0},
                                      {3.45, -8.0},
                                      {4.4, 15.0},
                                      {4.85, -5.0},
                                      {5.2, 8.0},
                                      {6.0, -18.0},
                                      {6.35, 12.0},
                                      {7.15, 0.0},
                                      {7.45, 16.0},
                                      {8.1, 0.0}}};
constexpr double all_s = 8.6;
constexpr double max_away_s = 0.3;
constexpr double min_apart_s = 0.0039;

}  // namespace

CarriedFinger::CarriedFinger() { samples_.reserve(static_cast<std::size_t>(all_s / min_apart_s) + 2); }

int CarriedFinger::of_s() { return static_cast<int>(all_s); }

void CarriedFinger::begin(std::int64_t time_ns, double plate_orientation_deg) {
  samples_.clear();
  began_ns_ = seen_ns_ = time_ns;
  middle_deg_ = now_deg_ = plate_orientation_deg;
  done_s_ = 0;
  complete_ = false;
  problem_ = SetupProblem::none;
}

void CarriedFinger::observe(const SetupSample& sample) {
  const double time_s = elapsed_s(began_ns_, sample.time_ns);
  now_deg_ = middle_deg_;
  for (const Turn& turn : turns)
    if (time_s >= turn.at_s) now_deg_ = middle_deg_ + turn.to_deg;
  done_s_ = static_cast<int>(time_s);
  complete_ = time_s >= all_s;
  const bool lifted = sample.on_plate.observation == Observation::lifted;
  if (sample.tracked_m && !lifted) {
    seen_ns_ = sample.time_ns;
    const bool due = samples_.empty() || time_s - samples_.back().time_s >= min_apart_s;
    if (due && sample.on_plate.plate_orientation_deg && samples_.size() < samples_.capacity())
      samples_.push_back({time_s, *sample.tracked_m, *sample.on_plate.plate_orientation_deg});
  } else if (elapsed_s(seen_ns_, sample.time_ns) > max_away_s) {
    problem_ = lifted ? SetupProblem::left_plate : SetupProblem::lost;
  }
}

}  // namespace hrt
