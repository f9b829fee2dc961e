#include "core/simulation/slide.h"

#include "core/plate/plate_model.h"
#include "core/simulation/random.h"
#include "core/simulation/sliding_finger.h"
#include "core/simulation/tracker.h"

namespace hrt {
namespace {

// Streams of Draws, apart from those of people.cpp.
constexpr std::uint32_t tracking_stream = 16;
constexpr std::uint32_t steering_stream = 17;
constexpr double start_deviation_deg = 2.0;
constexpr double slide_tail_s = 0.1;  // tracked at rest after the motion

// Without `turns` the plate rests.
CalibrationTrial slide_of(const PersonCondition& condition, double plate_orientation_deg, bool turns,
                          std::uint64_t seed, std::uint32_t person, std::uint32_t slide) {
  const PlatePoint start{0.0, 0.0};
  Draws draws(seed, tracking_stream, person, slide);
  const double rest_s = 0.4 + 0.2 * draws.uniform();
  Person sliding = condition.person;
  sliding.start_direction_deg += start_deviation_deg * draws.normal();
  Tracker tracker(condition.tracker, start, draws);
  SlidingPerson finger(sliding, start, 0.0, condition.distance_m,
                       Draws(seed, steering_stream, person, slide));
  PlateModel plate(condition.plate, plate_orientation_deg);
  CalibrationTrial trial{.plate_orientation_deg = plate_orientation_deg, .samples = {}};
  double ended_s = -1.0;
  for (std::int64_t now_ns = 0;; now_ns += 1'000'000) {
    const double now_s = 1e-9 * static_cast<double>(now_ns);
    plate.advance(now_ns);
    if (turns) {
      const bool across = plate_is_across(distance_m(start, finger.position()) / condition.distance_m);
      plate.command(across ? -plate_orientation_deg : plate_orientation_deg);
    }
    if (now_s > rest_s && !finger.done()) finger.advance(plate.orientation_deg());
    if (finger.done() && ended_s < 0.0) ended_s = now_s;
    if (ended_s >= 0.0 && now_s > ended_s + slide_tail_s + condition.tracker.latency_s) break;
    tracker.look(now_s, finger.position());
    while (const auto sample = tracker.arrived(now_ns)) {
      if (sample->observation != Observation::position) continue;
      trial.samples.push_back({sample->time_ns, sample->position});
      if (turns) trial.plate_deg.push_back(plate.orientation_deg());
    }
  }
  return trial;
}

}  // namespace

CalibrationTrial simulate_slide(const PersonCondition& condition, double plate_orientation_deg,
                                std::uint64_t seed, std::uint32_t person, std::uint32_t slide) {
  return slide_of(condition, plate_orientation_deg, false, seed, person, slide);
}

CalibrationTrial simulate_turning_slide(const PersonCondition& condition, double plate_orientation_deg,
                                        std::uint64_t seed, std::uint32_t person, std::uint32_t slide) {
  return slide_of(condition, plate_orientation_deg, true, seed, person, slide);
}

}  // namespace hrt
