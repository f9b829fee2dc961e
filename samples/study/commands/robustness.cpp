// hrt-study robustness: the controllers on simulated people who are not their model.
#include "samples/study/people/robustness.h"

#include <cctype>
#include <cmath>
#include <memory>
#include <set>

#include "samples/app/text/text.h"
#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/study/commands/commands.h"
#include "samples/study/numbers/results.h"
#include "samples/study/people/own_recordings.h"
#include "samples/study/people/person_file.h"
#include "samples/study/people/replay.h"

namespace hrt::study {
namespace {

namespace fs = std::filesystem;

struct Options {
  RobustnessOptions robustness;               // except durations
  std::vector<double> durations_s;            // empty: not given
  std::vector<const PeopleFamily*> families;  // empty: not given
  std::string person;
  std::string recorded;
  std::string replay;
  std::string csv;
  Writing writing;
};

// draw_person() takes durations to the millisecond, and files are named after them.
void check_durations(const RobustnessOptions& options) {
  std::set<long long> seen_ms;
  for (const double duration_s : options.durations_s)
    if (!seen_ms.insert(std::llround(1e3 * duration_s)).second)
      throw UsageError(not_allowed("--durations", number(duration_s), "given once, to the millisecond"));
}

void simulate(RobustnessStudy& study) {
  Progress progress;
  study.rows = simulate_robustness(study.people, study.options,
                                   [&](std::uint64_t done, std::uint64_t total) { progress.update(done, total); });
}

// A file's name, as far as tables and CSV can hold it.
std::string table_name(const std::string& path) {
  std::string name = cut_to(fs::path(path).stem().string(), 13);
  for (char& character : name) {
    const auto byte = static_cast<unsigned char>(character);
    if (byte >= 0x80 || (!std::isalnum(byte) && character != '-')) character = '_';
  }
  return name.empty() ? "person" : name;
}

// The person of the file. Each repetition draws another noise.
SimulatedPeople take_person(const Options& options, RobustnessStudy& study) {
  const PersonFile file = read_person("--person", options.person);
  if (file.has_duration && options.durations_s.empty()) study.options.durations_s = {file.condition.person.duration_s};
  const auto draw = [condition = file.condition](double duration_s, std::uint64_t, std::uint32_t) {
    PersonCondition person = condition;
    person.person.duration_s = duration_s;
    return person;
  };
  SimulatedPeople people{.name = table_name(options.person), .description = "as --person says", .draw = draw};
  if (people_family(people.name.c_str())) people.name += '_';
  return people;
}

RobustnessStudy simulated(const Options& options) {
  RobustnessStudy study{.options = options.robustness, .people = {}, .rows = {}};
  if (!options.durations_s.empty()) study.options.durations_s = options.durations_s;
  check_durations(study.options);
  if (!options.person.empty()) study.people.push_back(take_person(options, study));
  if (!options.recorded.empty()) study.people.push_back(people_of_recordings("--recorded", options.recorded));
  for (const PeopleFamily* family : options.families) study.people.push_back(people_of(*family));
  if (study.people.empty())
    for (const PeopleFamily& family : people_families()) study.people.push_back(people_of(family));
  const Output csv("--csv", options.csv);
  simulate(study);
  if (!options.csv.empty()) csv.write(csv_of(robustness_results(study)));
  return study;
}

void run(const Options& options) {
  if (!options.replay.empty())  // in an open loop
    return options.writing.write([&] { return replay_folder("--replay", options.replay); }, replay_results,
                                 replay_text);
  options.writing.write([&] { return simulated(options); }, robustness_results, robustness_text);
}

std::string family_list() {
  std::string list;
  for (const PeopleFamily& family : people_families())
    list += "  " + left(label(people_of(family)), 16) + family.description + '\n';
  return list;
}

std::string description() {
  return R"(Answers: of the people of a family, how many arrive at the real target, how far off are the others,
how large an error do they feel, and does the controller flag a reach that fails? Each person reaches
without a controller; with the paper's; --reaches times with ours, which starts without knowledge of the
person and carries what it learns; and once with ours informed of traits of the person, which shows
what is lost by not knowing them. All is simulation; there was no human trial.

The text is the share of reaches that end within 1.5 deg, and the flags. CSV and JSON have a row for
each family, duration and controller, each number with its 95 % interval (shares: Wilson's;
quantiles: between two of the reaches, for any distribution): that share, the miss across the real
direction, the largest felt error, unreachable found (in this reach or one before) and false, model
does not fit, off target, silent misses (off target and no flag), false alarms (on target, flagged off
it or unreachable), and how often the 95 % interval of w_T covers the person's, which is 95 if the
interval is honest. People who cannot hold the gap, whatever the plate does, are counted apart. A
field without a value is empty (CSV) or null (JSON). With one sort of people the text has all of it.

After each 100 people a row looks at the 95 % interval of its share within 1.5 deg, and takes no more
once half of that is at most --within points. Its people are the first of --people, so neither threads
nor other families change a number; what sums up rows counts each alike. Of the intervals 95 %
stay true (91 % at worst), and a share moves by up to 0.4 points away from 50 %. --within 0 takes all.

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
  hrt-study robustness --replay recordings --format csv

--replay reads all .csv files of a folder: the plugin's recordings, and calibration data. It passes each
recorded path through our controller and prints what the controller would have believed and commanded.
That is an open loop: the finger could not answer, so it shows neither misses nor felt errors under
our commands. Beside it there are --format and --out.

--recorded takes the path and the pace of recorded reaches in place of their statistics in the families
"recorded". A file .csv of the folder has the reaches of one person to one target, in the columns reach,
time_s, right_mm and away_mm: the fingertip from rest to rest, at 40 Hz or more, in any fixed frame. Each
reach of a simulated person takes one of the file's, stretched to --durations and turned to the target. The
answer to touch, and how the ends scatter (0.9 deg), are simulated as in the other families.

--person simulates a person of your own: JSON, {"tactile_weight": 0.18, "illusion": "sine"}. --people is
then the number of times that the person does it all, each time as a stranger. Parameters (those left out
keep their default):
)" + person_parameters() +
         '\n' + tuning_names() +
         R"(
Families (*: kept apart from the search for our controller's numbers; +: tracker or plate is off;
~: paths and pace of recorded reaches):
)" + family_list();
}

}  // namespace

void add_robustness(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App& command =
      add_command(app, "robustness", "The controllers on simulated people who differ from what they assume.",
                  description(), [options] { run(*options); });
  RobustnessOptions& robustness = options->robustness;
  add_integer(command, "--people", robustness.people, 1, 100'000,
              "People of each family at each duration, at most: 1000 take three minutes of a core.");
  add_integer(command, "--reaches", robustness.reaches, 2, 99,
              "Reaches of a person with ours; the first and the last are shown.");
  add_number(command, "--within", robustness.points, {0.0, 50.0},
             "A cell whose interval is within this many points takes no more people; 0: all do.");
  add_numbers(command, "--durations", options->durations_s, {0.3, 20.0}, "Durations of a reach without its pauses, s.")
      ->default_str("0.8,1,1.5,2,3, or that of --person");
  add_families(command, options->families, "all, or none with --person or --recorded", "People to simulate.");
  add_path(command, "--person", options->person, "A person of your own to simulate, beside the families of --family.");
  add_traits(command, "--informed-of", robustness.informed_of, "weight,curve,bias,habit,scatter,log_wander,log_rate",
             "Traits of the person that the informed controller knows.");
  add_tuning(command, robustness.tuning);
  add_path(command, "--recorded", options->recorded,
           "Folder of recordings, whose paths and paces people have, beside those of --family.");
  CLI::Option* replay =
      add_path(command, "--replay", options->replay,
               "Folder of recorded paths to pass through our controller, in place of simulated people.");
  add_seed(command, robustness.seed);
  add_threads(command, robustness.threads);
  add_path(command, "--csv", options->csv, "File that gets all numbers as well, in one run.");
  replay->excludes("--people", "--reaches", "--within", "--durations", "--family", "--person", "--recorded",
                   "--informed-of", "--tune", "--seed", "--threads", "--csv");
  options->writing.add_options(command);
}

}  // namespace hrt::study
