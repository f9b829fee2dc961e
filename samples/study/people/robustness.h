// Tests the controllers on simulated people who differ from the controllers' models: without a controller, with the
// paper's, and with the plugin's default controller ("ours" in this folder).
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

/// Column of the results: a controller, and how much it knows about the person.
enum class ControllerKind {
  none,      ///< no controller: the plate stays at 0
  paper,     ///< the paper's controller, which assumes w_T = 0.15
  first,     ///< ours, on the first reach of an unknown person
  last,      ///< ours, on the last of several reaches, with the estimates from the earlier ones
  informed,  ///< ours, on the first reach, with some of the person's true traits
};
inline constexpr std::array all_controllers{ControllerKind::none, ControllerKind::paper, ControllerKind::first,
                                            ControllerKind::last, ControllerKind::informed};

/// Names of the controllers in CSV and JSON, and in text.
inline constexpr const char* controller_names[] = {"none", "paper", "first", "last", "informed"};
inline constexpr const char* controller_titles[] = {"no controller", "the paper's", "ours, first reach",
                                                    "ours, last reach", "ours, informed"};

struct ReachResult {
  bool is_feasible;            ///< the gap is feasible for this person, by gap_is_feasible()
  double bearing_error_deg;    ///< true bearing error of the end
  double miss_mm;              ///< true distance of the end from the line to the real target, >= 0
  double peak_felt_error_deg;  ///< largest perceived-direction error, ground truth
  bool unreachable = false;    ///< flag of the reach's summary, as are misfit and off_target
  bool found = false;          ///< flagged unreachable in this reach or an earlier one of the person
  bool misfit = false;
  bool off_target = false;
  // True if the 95 % interval of the estimate contains the true value; nullopt without an estimate.
  std::optional<bool> weight_covered;  ///< w_T at the end of the reach
  std::optional<bool> bias_covered;    ///< mean bias over the person's reaches, as carried to the next reach
  std::optional<bool> habit_covered;   ///< mean habit over the person's reaches to this target
  std::optional<bool> miss_covered;    ///< bearing error at the end

  bool near() const;         ///< ends within near_deg (1.5) of the real target's bearing
  bool silent() const;       ///< is not near, and no flag is raised
  bool false_alarm() const;  ///< is near, and flagged unreachable or off target
};

/// Statistics of the members of ReachResult.
struct ReachGroup {
  Share near;
  Quantile miss_median_mm;
  Quantile miss_95_mm;  ///< 95 % quantile of the misses
  Quantile peak_felt_error_median_deg;
  Quantile peak_felt_error_95_deg;
  Share unreachable;
  Share found;
  Share silent;
  Share false_alarm;
};

struct RobustnessCell {
  ReachGroup feasible;  ///< reaches of people for whom the gap is feasible
  ReachGroup infeasible;
  // Over all people.
  Share misfit;
  Share off_target;
  Share weight_covered, bias_covered, habit_covered, miss_covered;  ///< among the reaches with an estimate

  std::uint64_t people() const { return feasible.near.of + infeasible.near.of; }
  const ReachGroup& group(bool is_feasible) const { return is_feasible ? feasible : infeasible; }
};

RobustnessCell summarise(std::span<const ReachResult> results);

struct SimulatedPeople {
  std::string name;
  std::string description;
  bool tuned = false;  ///< the family was used to tune our controller
  FamilyKind kind = FamilyKind::invented;
  std::function<PersonCondition(double duration_s, std::uint64_t seed, std::uint32_t index)> draw;
};

SimulatedPeople people_of(const PeopleFamily& family);

struct RobustnessRow {
  SimulatedPeople people;
  double duration_s;
  std::array<RobustnessCell, all_controllers.size()> cells;  ///< in the order of `all_controllers`

  const RobustnessCell& cell(ControllerKind controller) const { return cells[static_cast<std::size_t>(controller)]; }
};

/// Returns half the width of share.interval(), in percentage points; NaN without cases.
double half_interval(const Share& share);

struct RobustnessOptions {
  std::uint64_t people = 100;  ///< maximum number of people of each kind at each duration
  std::uint64_t reaches = 5;   ///< successive reaches under our controller, >= 2
  double points = 4.0;         ///< a cell stops if half_interval() of its percentage within near_deg is at most this
  std::vector<double> durations_s{0.8, 1.0, 1.5, 2.0, 3.0};
  std::uint64_t seed = 1;
  std::uint64_t threads = 1;
  std::vector<PersonState::Index> informed_of{std::begin(informed_traits), std::end(informed_traits)};
  Tuning tuning;
};

/// Simulates all people at all durations; the durations of one kind are adjacent rows. Person i of a kind and duration
/// is the same with each controller. A cell takes people in order and tests the stopping rule after each 100, so the
/// result does not depend on threads or on other rows. `progress` is called on the caller's thread.
std::vector<RobustnessRow> simulate_robustness(
    std::span<const SimulatedPeople> people, const RobustnessOptions& options,
    const std::function<void(std::uint64_t done, std::uint64_t total)>& progress = {});

/// Returns the unweighted mean over rows of the percentage within near_deg; NaN if no gap is feasible.
double mean_near_percent(std::span<const RobustnessRow> rows, ControllerKind controller);

/// Pools one percentage over all rows. Each case weighs 1 / (number of people of its row), so that rows with more
/// people do not dominate. The number of cases of the result is the effective sample size of such weighted data (Kish):
/// the sum of the cases, if all rows have the same number of people.
Share pooled(std::span<const RobustnessRow> rows, ControllerKind controller,
             const std::function<Share(const RobustnessCell&)>& share);

struct RobustnessStudy {
  RobustnessOptions options;
  std::vector<SimulatedPeople> people;
  std::vector<RobustnessRow> rows;
};

/// Returns the name of the people with a mark: + for FamilyKind::misplaced, ~ for recorded, * for invented people that
/// were not used to tune the controller.
std::string label(const SimulatedPeople& people);

std::string robustness_text(const RobustnessStudy& study);
/// Returns one row per family, duration and controller.
Results robustness_results(const RobustnessStudy& study);

}  // namespace hrt::study
