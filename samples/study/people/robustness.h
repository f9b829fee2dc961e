// How the controllers do on people who are not their model: every family of core/simulation/people.h, at
// several paces, without a controller, with the paper's and with ours. Results are of simulation.
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
  last,      ///< ours, on the last of some reaches, with the knowledge of those before it
  informed,  ///< ours, given some of the person's traits before the first reach
};
inline constexpr std::array leadings{Leading::none, Leading::paper, Leading::first, Leading::last, Leading::informed};

/// Name of each, in CSV and JSON, and in text.
inline constexpr const char* leading_names[] = {"none", "paper", "first", "last", "informed"};
inline constexpr const char* leading_titles[] = {"no controller", "the paper's", "ours, first reach",
                                                 "ours, last reach", "ours, informed"};

/// The result of one reach. Angles in degrees.
struct ReachResult {
  bool can_hold;               ///< as gap_is_feasible() of the person
  double bearing_error_deg;    ///< true, of the end
  double miss_mm;              ///< true, across the real direction; >= 0
  double peak_felt_error_deg;  ///< the simulated person's
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

/// Many reaches. Intervals are 95 %.
struct ReachGroup {
  Share near;
  Quantile miss_median_mm;
  Quantile miss_95_mm;  ///< 95 % of reaches miss by no more
  Quantile peak_felt_error_median_deg;
  Quantile peak_felt_error_95_deg;
  Share unreachable;  ///< in this reach
  Share found;        ///< unreachable in this reach or one before
  Share silent;       ///< a miss without a flag
  Share false_alarm;  ///< near, and flagged unreachable or off target
};

struct RobustnessCell {
  ReachGroup can_hold;     ///< of people who can hold the gap
  ReachGroup cannot_hold;  ///< of those who cannot
  // Shares of all people.
  Share misfit;
  Share off_target;
  Share weight_covered, bias_covered, habit_covered, miss_covered;  ///< of those who were estimated

  std::uint64_t people() const { return can_hold.near.of + cannot_hold.near.of; }
  /// The people who can hold the gap, or those who cannot.
  const ReachGroup& group(bool holds) const { return holds ? can_hold : cannot_hold; }
};

RobustnessCell summarise(std::span<const ReachResult> results);

/// The source of the people of a row.
struct SimulatedPeople {
  std::string name;
  std::string description;
  bool tuned = false;  ///< as in PeopleFamily
  FamilyKind kind = FamilyKind::invented;
  std::function<PersonCondition(double duration_s, std::uint64_t seed, std::uint32_t index)> draw;
};

SimulatedPeople people_of(const PeopleFamily& family);

/// One sort of people at one pace.
struct RobustnessRow {
  SimulatedPeople people;
  double duration_s;
  std::array<RobustnessCell, leadings.size()> cells;  ///< in the order of `leadings`

  const RobustnessCell& cell(Leading leading) const { return cells[static_cast<std::size_t>(leading)]; }
};

/// Half the width of its interval, in points; NaN of no cases.
double half_interval(const Share& share);

struct RobustnessOptions {
  std::uint64_t people = 100;  ///< of each sort at each duration, at most
  std::uint64_t reaches = 5;   ///< of the controller for people, one after another: 2 or more
  double points = 4.0;         ///< a cell whose share within near_deg has such a half_interval() takes no more people
  std::vector<double> durations_s{0.8, 1.0, 1.5, 2.0, 3.0};
  std::uint64_t seed = 1;
  std::uint64_t threads = 1;
  std::vector<PersonState::Index> informed_of{std::begin(informed_traits), std::end(informed_traits)};
  Tuning tuning;  ///< of the controller for people
};

/// All people at every duration, the durations of one sort one after another.
/// Person i of a sort and duration is the same with every controller; a cell takes them in order, and looks at
/// its interval after each 100. The same for any number of threads, and whatever else is simulated.
/// `progress` is called on this thread.
std::vector<RobustnessRow> simulate_robustness(
    std::span<const SimulatedPeople> people, const RobustnessOptions& options,
    const std::function<void(std::uint64_t done, std::uint64_t total)>& progress = {});

/// Mean over rows of the percentage within near_deg, each row the same; NaN without any who can hold.
double mean_near_percent(std::span<const RobustnessRow> rows, Leading leading);

/// One share, of all rows together, each counted as if it had taken as many people as the others: of Kish's
/// effective number of cases, which is their sum if they have.
Share pooled(std::span<const RobustnessRow> rows, Leading leading,
             const std::function<Share(const RobustnessCell&)>& share);

struct RobustnessStudy {
  RobustnessOptions options;
  std::vector<SimulatedPeople> people;
  std::vector<RobustnessRow> rows;  ///< simulate_robustness() of both
};

/// The name of the people, with the mark of their sort: * kept apart, + misplaced, ~ recorded.
std::string label(const SimulatedPeople& people);

std::string robustness_text(const RobustnessStudy& study);
/// A row a family, duration and controller.
Results robustness_results(const RobustnessStudy& study);

}  // namespace hrt::study
