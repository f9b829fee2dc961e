#include "samples/study/people/robustness.h"

#include <algorithm>
#include <cmath>

#include "core/math/distributions.h"
#include "core/simulation/controllers.h"
#include "core/simulation/person_trial.h"
#include "samples/study/numbers/parallel.h"

namespace hrt::study {
namespace {

constexpr int reaches = 5;

using PersonResults = std::array<ReachResult, leadings.size()>;

// w_T at the end of a reach, as commands define it: the felt shift over the offset, at 60 degrees to the side
// that leads to the real target.
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
  return {.can_hold = can_hold(condition),
          .bearing_error_deg = outcome.bearing_error_deg,
          .miss_mm = 1e3 * std::abs(outcome.miss_m),
          .peak_felt_error_deg = outcome.peak_felt_error_deg,
          .unreachable = summary.unreachable,
          .found = summary.unreachable,
          .misfit = summary.misfit,
          .off_target = summary.off_target,
          .weight_estimated = summary.person.has_value() && weight_sd > 0.0,
          .weight_covered = std::abs(weight_error) <= normal_975 * weight_sd};
}

PersonResults simulate(const PersonCondition& condition, std::uint64_t seed, std::uint32_t index) {
  const auto lead = [&](const RetargeterConfig* controller, int count) {
    return simulate_person(condition, controller, count, seed, index);
  };
  const RetargeterConfig paper = paper_controller();
  const RetargeterConfig ours = people_controller(condition);
  const RetargeterConfig informed = informed_controller(condition);
  const std::vector<PersonOutcome> carried = lead(&ours, reaches);
  ReachResult fifth = result(condition, carried.back());
  for (const PersonOutcome& outcome : carried) fifth.found = fifth.found || outcome.summary.unreachable;
  return {result(condition, lead(nullptr, 1).front()), result(condition, lead(&paper, 1).front()),
          result(condition, carried.front()), fifth, result(condition, lead(&informed, 1).front())};
}

}  // namespace

const char* leading_name(Leading leading) {
  static constexpr const char* names[] = {"none", "paper", "first", "fifth", "informed"};
  return names[static_cast<std::size_t>(leading)];
}

const char* leading_title(Leading leading) {
  static constexpr const char* titles[] = {"no controller", "the paper's", "ours, first reach", "ours, fifth reach",
                                           "ours, informed"};
  return titles[static_cast<std::size_t>(leading)];
}

bool ReachResult::near() const { return std::abs(bearing_error_deg) <= near_deg; }

bool ReachResult::silent() const { return !near() && !unreachable && !misfit && !off_target; }

bool ReachResult::false_alarm() const { return near() && (unreachable || off_target); }

namespace {

ReachGroup summarise(std::span<const ReachResult> results, bool can_hold) {
  ReachGroup group{};
  std::vector<double> misses_mm;
  std::vector<double> peaks_deg;
  for (const ReachResult& reach : results) {
    if (reach.can_hold != can_hold) continue;
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

RobustnessCell summarise(std::span<const ReachResult> results) {
  RobustnessCell cell{.can_hold = summarise(results, true), .cannot_hold = summarise(results, false)};
  for (const ReachResult& reach : results) {
    cell.misfit.count(reach.misfit);
    cell.off_target.count(reach.off_target);
    if (reach.weight_estimated) cell.weight_covered.count(reach.weight_covered);
  }
  return cell;
}

SimulatedPeople people_of(const PeopleFamily& family) {
  return {.name = family.name,
          .says = family.says,
          .tuned = family.tuned,
          .misplaced = family.misplaced,
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
  rows = options.part.of(rows);

  std::vector<PersonResults> reached(rows.size() * options.people);
  const auto work = [&](std::uint64_t i) {
    const RobustnessRow& row = rows[i / options.people];
    const auto index = static_cast<std::uint32_t>(i % options.people);
    reached[i] = simulate(row.people.draw(row.duration_s, options.seed, index), options.seed, index);
  };
  for_each_part(reached.size(), options.threads, work, progress);

  std::vector<ReachResult> results(options.people);
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t column = 0; column < leadings.size(); ++column) {
      for (std::size_t i = 0; i < results.size(); ++i) results[i] = reached[row * options.people + i][column];
      rows[row].cells[column] = summarise(results);
    }
  return rows;
}

std::vector<RobustnessRow> at_duration(std::span<const RobustnessRow> rows, double duration_s) {
  std::vector<RobustnessRow> found;
  for (const RobustnessRow& row : rows)
    if (row.duration_s == duration_s) found.push_back(row);
  return found;
}

double mean_near_percent(std::span<const RobustnessRow> rows, Leading leading) {
  double sum = 0.0;
  double count = 0.0;
  for (const RobustnessRow& row : rows) {
    const Share& near = row.cell(leading).can_hold.near;
    if (near.of == 0) continue;
    sum += near.percent();
    count += 1.0;
  }
  return sum / count;
}

Share pooled(std::span<const RobustnessRow> rows, Leading leading,
             const std::function<Share(const RobustnessCell&)>& share) {
  Share total;
  for (const RobustnessRow& row : rows) total.add(share(row.cell(leading)));
  return total;
}

double widest_near_interval(std::span<const RobustnessRow> rows) {
  double widest = 0.0;
  for (const RobustnessRow& row : rows)
    for (const RobustnessCell& cell : row.cells) {
      if (cell.can_hold.near.of == 0) continue;
      const PercentInterval interval = cell.can_hold.near.interval();
      widest = std::max(widest, 0.5 * (interval.high - interval.low));
    }
  return widest;
}

}  // namespace hrt::study
