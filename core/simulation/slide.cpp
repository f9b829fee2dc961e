#include "core/simulation/slide.h"

#include "core/simulation/random.h"
#include "core/simulation/sliding_finger.h"
#include "core/simulation/tracker.h"

namespace hrt {
namespace {

constexpr double start_deviation_deg = 2.0;
constexpr double slide_tail_s = 0.1;  // time of tracking at rest after the motion
// Random streams that people.h does not use.
constexpr std::uint32_t tracking_stream = 16;
constexpr std::uint32_t steering_stream = 17;

}  // namespace

CalibrationTrial simulate_slide(const PersonCondition& condition, double plate_orientation_deg, std::uint64_t seed,
                                std::uint32_t person, std::uint32_t slide) {
  const PlatePoint start{0.0, 0.0};
  Draws draws(seed, tracking_stream, person, slide);
  const double rest_s = 0.4 + 0.2 * draws.uniform();
  Person sliding = condition.person;
  sliding.start_direction_deg += start_deviation_deg * draws.normal();
  Tracker tracker(condition.tracker, start, draws);
  SlidingPerson finger(sliding, start, 0.0, condition.distance_mm, Draws(seed, steering_stream, person, slide));
  CalibrationTrial trial{.plate_orientation_deg = plate_orientation_deg, .samples = {}, .plate_deg = {}};
  double ended_s = -1.0;
  for (std::int64_t now_ns = 0;; now_ns += 1'000'000) {
    const double now_s = 1e-9 * static_cast<double>(now_ns);
    if (now_s > rest_s && !finger.done()) finger.advance(plate_orientation_deg);
    if (finger.done() && ended_s < 0.0) ended_s = now_s;
    if (ended_s >= 0.0 && now_s > ended_s + slide_tail_s + condition.tracker.latency_s) break;
    tracker.sample_if_due(now_s, finger.position());
    while (const auto sample = tracker.arrived(now_ns))
      if (sample->observation == Observation::position)
        trial.samples.push_back({1e-9 * static_cast<double>(sample->time_ns), sample->position});
  }
  return trial;
}

}  // namespace hrt
