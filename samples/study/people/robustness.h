// Tests the controllers on people who differ from their models: each family of core/simulation/people.h at several
// durations, without a controller, with the paper's and with ours. All results are simulation.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/simulation/controllers.h"
#include "core/simulation/people.h"
#include "samples/study/numbers/results.h"
#include "samples/study/numbers/statistics.h"

namespace hrt::study {

/// The controller of a reach.
enum class Leading {
  none,      ///< no controller: the plate stays at 0
  paper,     ///< the paper's controller, which assumes w_T = 0.15
  first,     ///< ours, on the first reach of an unknown person
  last,      ///< ours, on the last of several reaches, with the estimates from those before
  informed,  ///< ours, given some of the person's traits before the first reach
};
inline constexpr std::array leadings{Leading::none, Leading::paper, Leading::first, Leading::last, Leading::informed};

/// Names of the controllers in CSV and JSON, and in text.
inline constexpr const char* leading_names[] = {"none", "paper", "first", "last", "informed"};
inline constexpr const char* leading_titles[] = {"no controller", "the paper's", "ours, first reach",
                                                 "ours, last reach", "ours, informed"};

/// The result of one reach. Angles in degrees.
struct ReachResult {
  bool can_hold;               ///< as gap_is_feasible() of the person
  double bearing_error_deg;    ///< true bearing error of the end
  double miss_mm;              ///< true distance of the end across the real direction; >= 0
  double peak_felt_error_deg;  ///< largest perceived-direction error, ground truth
  bool unreachable = false;    ///< flags of the reach's summary
  bool found = false;          ///< unreachable in this reach or an earlier one of the person
  bool misfit = false;
  bool off_target = false;
  // True if the 95 % interval of the estimate contains the truth; none without an estimate.
  std::optional<bool> weight_covered;  ///< w_T at the end of the reach
  std::optional<bool> bias_covered;    ///< mean of the person's reaches, as carried to the next reach
  std::optional<bool> habit_covered;   ///< the same of the habit, to this target
  std::optional<bool> miss_covered;    ///< error of the bearing at the end

  bool near() const;         ///< ends within near_deg of the real target's bearing
  bool silent() const;       ///< misses, and no flag is raised
  bool false_alarm() const;  ///< is near, and flagged unreachable or off target
};

/// Statistics of many reaches, with 95 % intervals.
struct ReachGroup {
  Share near;
  Quantile miss_median_mm;
  Quantile miss_95_mm;  ///< 95 % quantile of the misses
  Quantile peak_felt_error_median_deg;
  Quantile peak_felt_error_95_deg;
  Share unreachable;  ///< unreachable in this reach
  Share found;        ///< unreachable in this reach or one before
  Share silent;       ///< a miss without a flag
  Share false_alarm;  ///< near, and flagged unreachable or off target
};

struct RobustnessCell {
  ReachGroup can_hold;     ///< of people who can hold the gap
  ReachGroup cannot_hold;  ///< of those who cannot
  // Percentages of all people.
  Share misfit;
  Share off_target;
  Share weight_covered, bias_covered, habit_covered, miss_covered;  ///< percentage among estimates

  std::uint64_t people() const { return can_hold.near.of + cannot_hold.near.of; }
  /// The people who can hold the gap, or those who cannot.
  const ReachGroup& group(bool holds) const { return holds ? can_hold : cannot_hold; }
};

RobustnessCell summarise(std::span<const ReachResult> results);

/// Source of the people of a row.
struct SimulatedPeople {
  std::string name;
  std::string description;
  bool tuned = false;  ///< as in PeopleFamily
  FamilyKind kind = FamilyKind::invented;
  std::function<PersonCondition(double duration_s, std::uint64_t seed, std::uint32_t index)> draw;
};

SimulatedPeople people_of(const PeopleFamily& family);

/// One kind of people at one duration.
struct RobustnessRow {
  SimulatedPeople people;
  double duration_s;
  std::array<RobustnessCell, leadings.size()> cells;  ///< in the order of `leadings`

  const RobustnessCell& cell(Leading leading) const { return cells[static_cast<std::size_t>(leading)]; }
};

/// Returns half the width of the interval, in percentage points; NaN without cases.
double half_interval(const Share& share);

struct RobustnessOptions {
  std::uint64_t people = 100;  ///< maximum number of people of each kind at each duration
  std::uint64_t reaches = 5;   ///< successive reaches under the controller for people, >= 2
  double points = 4.0;         ///< a cell whose share within near_deg has such a half_interval() takes no more people
  std::vector<double> durations_s{0.8, 1.0, 1.5, 2.0, 3.0};
  std::uint64_t seed = 1;
  std::uint64_t threads = 1;
  std::vector<PersonState::Index> informed_of{std::begin(informed_traits), std::end(informed_traits)};
  Tuning tuning;  ///< of the controller for people
};

/// Simulates all people at all durations; the durations of one kind are adjacent rows. Person i of a kind and duration
/// is the same with each controller. A cell takes people in order and tests the stopping rule after each 100, so the
/// result depends neither on threads nor on other rows. `progress` is called on this thread.
std::vector<RobustnessRow> simulate_robustness(
    std::span<const SimulatedPeople> people, const RobustnessOptions& options,
    const std::function<void(std::uint64_t done, std::uint64_t total)>& progress = {});

/// Returns the unweighted mean over rows of the percentage within near_deg; NaN if no gap is feasible.
double mean_near_percent(std::span<const RobustnessRow> rows, Leading leading);

/// Returns one percentage of all rows with equal weights. Its number of cases is Kish's effective sample size, which is
/// the sum if all rows have the same number of people.
Share pooled(std::span<const RobustnessRow> rows, Leading leading,
             const std::function<Share(const RobustnessCell&)>& share);

struct RobustnessStudy {
  RobustnessOptions options;
  std::vector<SimulatedPeople> people;
  std::vector<RobustnessRow> rows;  ///< simulate_robustness() of both
};

/// Returns the name of the people with a mark: * held out, + misplaced, ~ recorded.
std::string label(const SimulatedPeople& people);

std::string robustness_text(const RobustnessStudy& study);
/// Returns one row per family, duration and controller.
Results robustness_results(const RobustnessStudy& study);

}  // namespace hrt::study
