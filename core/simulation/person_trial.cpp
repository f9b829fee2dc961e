#include "core/simulation/person_trial.h"
#include "core/retargeter.h"

#include <algorithm>
#include <cmath>

#include "core/learning.h"
#include "core/math/elementary.h"

namespace hrt {
namespace {

constexpr std::int64_t tick_ns = 1'000'000;
constexpr double reach_tail_s = 0.3;  // time of tracking at rest after the motion
constexpr PlatePoint start{0.0, 0.0};

PersonOutcome simulate_reach(const PersonCondition& condition, Retargeter* controller, const TouchedFrame& frame,
                             std::uint64_t seed, std::uint32_t index, std::uint32_t reach_number,
                             const PersonWatch& watch) {
  Draws draws(seed, PersonStream::tracking, index, reach_number);
  const double rest_s = 0.4 + 0.4 * draws.uniform();
  Tracker tracker(condition.tracker, start, draws);
  SlidingPerson person(condition.person, start, condition.virtual_direction_deg, condition.distance_mm,
                       Draws(seed, PersonStream::steering, index, reach_number));
  PlateModel plate(condition.plate, 0.0);
  plate.advance(0);
  if (controller) {
    controller->begin({.real_direction_deg = condition.real_direction_deg,
                       .virtual_direction_deg = condition.virtual_direction_deg,
                       .plate_orientation_deg = 0.0,
                       .start = start,
                       .real_distance_mm = condition.distance_mm});
    plate.command(controller->command().plate_orientation_deg);
  }
  double peak_deg = 0.0;
  double ended_s = -1.0;
  for (std::int64_t now_ns = 0;; now_ns += tick_ns) {
    const double now_s = 1e-9 * static_cast<double>(now_ns);
    plate.advance(now_ns);
    if (now_s > rest_s && !person.done()) {
      person.advance(plate.orientation_deg() + condition.plate_offset_deg);
      if (person.elapsed_s() > 0.05 && person.speed_mm_s() > 10.0)
        peak_deg = std::max(peak_deg, std::abs(person.felt_error_deg()));
    }
    if (person.done() && ended_s < 0.0) ended_s = now_s;
    if (ended_s >= 0.0 &&
        (!controller || now_s > ended_s + reach_tail_s + condition.tracker.latency_s + condition.tracker.late_s))
      break;
    if (!controller) continue;
    tracker.sample_if_due(now_s, person.position());
    while (auto sample = tracker.arrived(now_ns)) {
      sample->position = corrected(frame, sample->position);
      const PlateCommand command = controller->update(*sample);
      plate.command(command.plate_orientation_deg);
      if (watch)
        watch(static_cast<int>(reach_number), {now_s, person.position(), person.felt_position(),
                                               plate.orientation_deg(), command, controller->person_filter()});
    }
  }
  const double error_deg = bearing_deg(start, person.position()) - condition.real_direction_deg;
  return {.bearing_error_deg = error_deg,
          .miss_mm = distance_mm(start, person.position()) * sin_deg(error_deg),
          .finger = person.position(),
          .peak_felt_error_deg = peak_deg,
          .summary = controller ? controller->summary() : ReachSummary{},
          .learnt = std::nullopt};
}

// Simulates a contact with an object at the final position of the finger.
void touch(const PersonOutcome& outcome, const Retargeter& retargeter, double sd_mm, Draws& draws,
           RetargeterConfig& config) {
  const std::optional<FingerPosition> seen = retargeter.finger();
  if (!seen) return;
  Contact contact{.finger = seen->place, .place = outcome.finger, .variance_mm2 = sd_mm * sd_mm + seen->variance_mm2};
  contact.place.right_mm += sd_mm * draws.normal();
  contact.place.away_mm += sd_mm * draws.normal();
  config = carried(config, contact, outcome.learnt.has_value());
}

}  // namespace

std::vector<PersonOutcome> simulate_person(const PersonCondition& condition, const RetargeterConfig* controller,
                                           int reaches, std::uint64_t seed, std::uint32_t index,
                                           const PersonWatch& watch) {
  std::vector<PersonOutcome> outcomes;
  RetargeterConfig config = controller ? *controller : RetargeterConfig{};
  Draws touching(seed, PersonStream::touching, index, 0);
  for (int i = 0; i < reaches; ++i) {
    Retargeter retargeter(config);
    const auto number = static_cast<std::uint32_t>(i);
    PersonCondition now = condition;
    Draws faults(seed, PersonStream::faults, index, number);
    if (condition.faulty) draw_fault(now, faults);
    if (condition.random_side && faults.uniform() < 0.5)
      now.real_direction_deg = 2.0 * now.virtual_direction_deg - now.real_direction_deg;
    outcomes.push_back(
        simulate_reach(now, controller ? &retargeter : nullptr, config.touched, seed, index, number, watch));
    if (const auto learnt = retargeter.learnt()) {
      const ReachSummary& summary = outcomes.back().summary;
      config.person = carried(config.person, *learnt, summary.unreachable || summary.off_target,
                              unknown_person(0.2, 0.05, 0.0, config.tuning), config.tuning);
      outcomes.back().learnt = config.person;
    }
    if (controller && condition.contact_sd_mm > 0.0)
      touch(outcomes.back(), retargeter, condition.contact_sd_mm, touching, config);
  }
  return outcomes;
}

}  // namespace hrt
