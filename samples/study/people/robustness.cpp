#include "samples/study/people/robustness.h"

#include <algorithm>
#include <cmath>

#include "core/math/distributions.h"
#include "core/simulation/person_trial.h"
#include "samples/study/numbers/parallel.h"

namespace hrt::study {
namespace {

constexpr std::uint64_t people_between_tests = 100;

// Returns w_T at the end of a reach: perceived shift divided by the angle between ridge normal and motion, at 60
// degrees to the side that steers the finger to the real target.
double true_weight(const PersonCondition& condition) {
  SimulatedIllusion illusion = condition.person.illusion;
  illusion.tactile_weight += condition.person.weight_drift;
  const double offset_deg = std::copysign(60.0, condition.virtual_direction_deg - condition.real_direction_deg);
  return felt_shift_deg(illusion, offset_deg) / offset_deg;
}

ReachResult result(const PersonCondition& condition, const PersonOutcome& outcome) {
  const ReachSummary& summary = outcome.summary;
  const double weight_sd = summary.estimate.tactile_weight_sd;
  const double weight_error = summary.estimate.tactile_weight - true_weight(condition);
  const auto covered = [](double error, double sd) { return std::abs(error) <= normal_975 * sd; };
  const auto carried_covers = [&](PersonState::Index trait, double truth) -> std::optional<bool> {
    if (!outcome.learnt) return std::nullopt;
    return covered(outcome.learnt->mean(trait) - truth, trait_sd(*outcome.learnt, trait));
  };
  const Person& person = condition.person;
  const auto if_known = [](bool known, bool covers) { return known ? std::optional(covers) : std::nullopt; };
  return {.is_feasible = gap_is_feasible(condition),
          .bearing_error_deg = outcome.bearing_error_deg,
          .miss_mm = std::abs(outcome.miss_mm),
          .peak_felt_error_deg = outcome.peak_felt_error_deg,
          .unreachable = summary.unreachable,
          .misfit = summary.misfit,
          .off_target = summary.off_target,
          .weight_covered = if_known(summary.person.has_value() && weight_sd > 0.0, covered(weight_error, weight_sd)),
          .bias_covered = carried_covers(PersonState::bias, person.bias_deg - person.own_bias_deg),
          .habit_covered = carried_covers(PersonState::habit, person.habit_deg + mean_habit_deg(person.own_path)),
          .miss_covered =
              if_known(summary.person.has_value() && !summary.miss_unknown,
                       covered(summary.bearing_error_deg - outcome.bearing_error_deg, summary.bearing_error_sd_deg))};
}

// Simulates the reaches of a person up to the one that `kind` reports.
std::vector<ReachResult> simulate(const PersonCondition& condition, ControllerKind kind,
                                  const RobustnessOptions& options, std::uint32_t index) {
  const RetargeterConfig controller = kind == ControllerKind::paper ? paper_controller()
                                      : kind == ControllerKind::informed
                                          ? informed_controller(condition, options.informed_of, options.tuning)
                                          : people_controller(condition, options.tuning);
  std::vector<ReachResult> results;
  bool found = false;
  for (const PersonOutcome& outcome :
       simulate_person(condition, kind == ControllerKind::none ? nullptr : &controller,
                       kind == ControllerKind::last ? static_cast<int>(options.reaches) : 1, options.seed, index)) {
    results.push_back(result(condition, outcome));
    results.back().found = found = found || outcome.summary.unreachable;
  }
  return results;
}

}  // namespace

bool ReachResult::near() const { return std::abs(bearing_error_deg) <= near_deg; }

bool ReachResult::silent() const { return !near() && !unreachable && !misfit && !off_target; }

bool ReachResult::false_alarm() const { return near() && (unreachable || off_target); }

namespace {

ReachGroup summarise(std::span<const ReachResult> results, bool is_feasible) {
  ReachGroup group{};
  std::vector<double> misses_mm;
  std::vector<double> peaks_deg;
  for (const ReachResult& reach : results) {
    if (reach.is_feasible != is_feasible) continue;
    group.near.count(reach.near());
    group.unreachable.count(reach.unreachable);
    group.found.count(reach.found);
    group.silent.count(reach.silent());
    group.false_alarm.count(reach.false_alarm());
    misses_mm.push_back(reach.miss_mm);
    peaks_deg.push_back(reach.peak_felt_error_deg);
  }
  group.miss_median_mm = quantile_of(misses_mm, 0.5);
  group.miss_95_mm = quantile_of(misses_mm, 0.95);
  group.peak_felt_error_median_deg = quantile_of(peaks_deg, 0.5);
  group.peak_felt_error_95_deg = quantile_of(peaks_deg, 0.95);
  return group;
}

}  // namespace

double half_interval(const Share& share) {
  const PercentInterval interval = share.interval();
  return 0.5 * (interval.high - interval.low);
}

RobustnessCell summarise(std::span<const ReachResult> results) {
  RobustnessCell cell{.feasible = summarise(results, true), .infeasible = summarise(results, false)};
  for (const ReachResult& reach : results) {
    cell.misfit.count(reach.misfit);
    cell.off_target.count(reach.off_target);
    const auto count = [](Share& share, std::optional<bool> hit) {
      if (hit) share.count(*hit);
    };
    count(cell.weight_covered, reach.weight_covered);
    count(cell.bias_covered, reach.bias_covered);
    count(cell.habit_covered, reach.habit_covered);
    count(cell.miss_covered, reach.miss_covered);
  }
  return cell;
}

SimulatedPeople people_of(const PeopleFamily& family) {
  return {.name = family.name,
          .description = family.description,
          .tuned = family.tuned,
          .kind = family.kind,
          .draw = [&family](double duration_s, std::uint64_t seed, std::uint32_t index) {
            return draw_person(family, duration_s, seed, index);
          }};
}

std::vector<RobustnessRow> simulate_robustness(
    std::span<const SimulatedPeople> people, const RobustnessOptions& options,
    const std::function<void(std::uint64_t done, std::uint64_t total)>& progress) {
  std::vector<RobustnessRow> rows;
  for (const SimulatedPeople& sort : people)
    for (const double duration_s : options.durations_s)
      rows.push_back({.people = sort, .duration_s = duration_s, .cells = {}});

  constexpr std::size_t columns = all_controllers.size();
  std::vector<std::vector<ReachResult>> results(rows.size() * columns);  // by cell, then person
  for (std::uint64_t before = 0, now = 0; before < options.people; before += now) {
    now = std::min(people_between_tests, options.people - before);
    std::vector<std::size_t> taking;
    for (std::size_t cell = 0; cell < results.size(); ++cell) {
      if (half_interval(rows[cell / columns].cells[cell % columns].feasible.near) <= options.points) continue;
      taking.push_back(cell);
      results[cell].resize(before + now);
    }
    const auto work = [&](std::uint64_t i) {
      const std::size_t cell = taking[i / now];
      const std::uint64_t index = before + i % now;
      const auto is = [&](ControllerKind controller) { return all_controllers[cell % columns] == controller; };
      if (is(ControllerKind::first) && results[cell + 1].size() > index)
        return;  // the column of the last reach also simulates the first
      const RobustnessRow& row = rows[cell / columns];
      const auto person = static_cast<std::uint32_t>(index);
      const std::vector<ReachResult> reached = simulate(row.people.draw(row.duration_s, options.seed, person),
                                                        all_controllers[cell % columns], options, person);
      results[cell][index] = reached.back();
      if (is(ControllerKind::last) && results[cell - 1].size() > index) results[cell - 1][index] = reached.front();
    };
    for_each_part(taking.size() * now, options.threads, work, [&](std::uint64_t done, std::uint64_t) {
      if (progress) progress(before * results.size() + done, options.people * results.size());
    });
    for (const std::size_t cell : taking) rows[cell / columns].cells[cell % columns] = summarise(results[cell]);
  }
  return rows;
}

double mean_near_percent(std::span<const RobustnessRow> rows, ControllerKind controller) {
  double sum = 0.0;
  double count = 0.0;
  for (const RobustnessRow& row : rows) {
    const Share& near = row.cell(controller).feasible.near;
    if (near.of == 0) continue;
    sum += near.percent();
    count += 1.0;
  }
  return sum / count;
}

Share pooled(std::span<const RobustnessRow> rows, ControllerKind controller,
             const std::function<Share(const RobustnessCell&)>& share) {
  double hits = 0.0, of = 0.0, squares = 0.0;
  for (const RobustnessRow& row : rows) {
    const Share counted = share(row.cell(controller));
    if (counted.of == 0) continue;
    const double weight = 1.0 / static_cast<double>(row.cell(controller).people());
    hits += weight * static_cast<double>(counted.hits);
    of += weight * static_cast<double>(counted.of);
    squares += weight * weight * static_cast<double>(counted.of);
  }
  const auto cases = [&](double weighed) {
    return of > 0.0 ? static_cast<std::uint64_t>(std::llround(weighed * of / squares)) : 0;
  };
  return {cases(hits), cases(of)};
}

}  // namespace hrt::study
