#include "samples/study/people/robustness.h"

#include <memory>

#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/study/commands/commands.h"
#include "samples/study/numbers/results.h"
#include "samples/study/people/own_recordings.h"
#include "samples/study/people/person_file.h"

namespace hrt::study {
namespace {

struct Options {
  RobustnessOptions robustness;
  std::vector<double> durations_s;            // empty: not given; robustness.durations_s has the default
  std::vector<const PeopleFamily*> families;  // empty: not given
  std::string person;
  std::string recorded;
  std::string csv;
  Writing writing;
};

// Returns the person of --person; repetitions differ in their random noise. Without --durations, also sets the duration
// of `study` to that of the file, if it has one.
SimulatedPeople take_person(const Options& options, RobustnessStudy& study) {
  const PersonFile file = read_person("--person", options.person);
  if (file.has_duration && options.durations_s.empty()) study.options.durations_s = {file.condition.person.duration_s};
  const auto draw = [condition = file.condition](double duration_s, std::uint64_t, std::uint32_t) {
    PersonCondition person = condition;
    person.person.duration_s = duration_s;
    return person;
  };
  return {.name = "person", .description = "person of --person", .draw = draw};
}

RobustnessStudy simulated(const Options& options) {
  RobustnessStudy study{.options = options.robustness, .people = {}, .rows = {}};
  if (!options.durations_s.empty()) study.options.durations_s = options.durations_s;
  if (!options.person.empty()) study.people.push_back(take_person(options, study));
  if (!options.recorded.empty()) study.people.push_back(people_of_recordings("--recorded", options.recorded));
  for (const PeopleFamily* family : options.families) study.people.push_back(people_of(*family));
  if (study.people.empty())
    for (const PeopleFamily& family : people_families()) study.people.push_back(people_of(family));
  const Output csv("--csv", options.csv);
  Progress progress;
  study.rows = simulate_robustness(study.people, study.options,
                                   [&](std::uint64_t done, std::uint64_t total) { progress.update(done, total); });
  if (!options.csv.empty()) csv.write(csv_of(robustness_results(study)));
  return study;
}

std::string family_list() {
  std::string list;
  for (const PeopleFamily& family : people_families())
    list += fmt::format("  {:16}{}\n", label(people_of(family)), family.description);
  return list;
}

std::string description() {
  return R"(For each family of people: the percentage of reaches that arrive at the real target, the misses, the
perceived-direction errors, and whether the controller flags reaches that fail. Each person reaches
without a controller; with the paper's; --reaches times with ours (the plugin's default), which starts
with the default prior and carries its estimates to the next reach; and once with ours informed of the
person's traits, which shows the cost of not knowing them. All results are simulation; no person took part.

The text has the percentage of reaches that end within 1.5 deg of the real target, and the flags; for one
family it has all numbers. CSV and JSON have a row for each family, duration and controller, each number
with its 95 % interval (percentages: Wilson's score interval; quantiles: order statistics, for any
distribution). People for whom the gap is infeasible are counted separately, in columns that begin with
infeasible_. A missing value is empty (CSV) or null (JSON). Columns, whose names continue with _low or
_high for the ends of the interval, and with the unit (_percent, _mm, _deg):
  near                    reaches that end within 1.5 deg of the real target
  miss_median, miss_95    miss across the real direction: median and 95 % quantile
  peak_felt_error_...     largest perceived-direction error: median and 95 % quantile
  silent_miss             reaches that miss without a flag
  false_alarm             reaches on target that are flagged off target or unreachable
  unreachable_found       gap infeasible: flagged unreachable in this or an earlier reach
  unreachable_false       gap feasible: flagged unreachable
  misfit, off_target      reaches with these flags
  weight_covered, ...     95 % intervals of w_T, bias, habit and miss that contain the true value

Sequential stopping: after each 100 people, a cell ends if half the width of the 95 % interval of its
percentage within 1.5 deg is at most --within points. Its people are the first of --people, so the result
does not depend on threads or other families; summaries weight all rows equally. Because of the repeated
tests, the intervals cover 95 % on average over true percentages (at least 91 %), and the estimates are
biased by up to 0.4 points away from 50 %. --within 0 simulates all people.

Examples:
  hrt-study robustness
  hrt-study robustness --family linear,place --durations 1.5 --people 1000
  hrt-study robustness --family faults --reaches 20
  hrt-study robustness --informed-of weight,curve
  hrt-study robustness --tune gain.mean=12,last_phase=0.9
  hrt-study robustness --people 1000 --format csv > robustness.csv
  hrt-study robustness --csv robustness.csv
  hrt-study robustness --recorded my_lab --durations 1.5 --people 300
  hrt-study robustness --person me.json --people 1000

--recorded simulates people with the paths and speeds of your own recorded reaches. Each .csv file of the
folder has the reaches of one person to one target, in the columns reach, time_s, right_mm and away_mm:
the fingertip from rest to rest, at 40 Hz or more, in any fixed coordinate system. Each simulated reach
uses one of the recorded reaches, scaled to --durations and rotated to the target. The response to touch and the
scatter of the ends (0.9 deg) are simulated as in the families.

--person simulates a person whom you define: JSON, {"tactile_weight": 0.18, "illusion": "sine"}. --people
is then the number of repetitions, each without knowledge from the others. Parameters (missing ones have
their default):
)" + person_parameters() +
         '\n' + tuning_names() +
         R"(
Families (*: held out of the search for our controller's parameters; +: systematic error of tracker
or plate, except placed-touch3; ~: paths and speeds of recorded reaches; w: tactile weight; t: angle from the motion to the
ridge normal):
)" + family_list();
}

}  // namespace

void add_robustness(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = add_command(
      app, "robustness", "Test the controllers on simulated people who differ from the controllers' assumptions.",
      description(),
      [options] { options->writing.write([&] { return simulated(*options); }, robustness_results, robustness_text); });
  RobustnessOptions& robustness = options->robustness;
  add_integer(command, "--people", robustness.people, 1, 100'000,
              "Maximum number of people of each family at each duration.");
  add_integer(command, "--reaches", robustness.reaches, 2, 99,
              "Number of reaches of each person under our controller; the first and the last are reported.");
  add_number(command, "--within", robustness.points, {0.0, 50.0},
             "Stopping rule: half width of the 95 % interval at which a cell ends, in percentage points; 0: no stop.");
  add_numbers(command, "--durations", options->durations_s, {0.3, 20.0}, "Durations of a reach without pauses, s.")
      ->default_str("0.8,1,1.5,2,3, or that of --person");
  add_families(command, options->families, "all, or none with --person or --recorded", "People to simulate.");
  add_path(command, "--person", options->person, "JSON file of a person to simulate, in addition to --family.");
  add_traits(command, "--informed-of", robustness.informed_of, "weight,curve,bias,habit,scatter,log_wander,log_rate",
             "Traits of the person that the informed controller knows.");
  add_tuning(command, robustness.tuning);
  add_path(command, "--recorded", options->recorded,
           "Folder of recorded reaches whose paths and speeds are simulated, in addition to --family.");
  add_seed(command, robustness.seed);
  add_threads(command, robustness.threads);
  add_path(command, "--csv", options->csv, "CSV file for all numbers, in addition to the output.");
  options->writing.add_options(command);
}

}  // namespace hrt::study
