// hrt-study power: how many people a first trial needs.
#include <algorithm>
#include <memory>

#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/study/commands/commands.h"
#include "samples/study/paper/power_study.h"

namespace hrt::study {
namespace {

struct Options {
  PowerOptions power;
  std::string against = "none";
  Writing writing;
};

void run(Options options) {
  PowerOptions& power = options.power;
  power.pool.against = options.against == "paper" ? Against::paper : Against::none;
  if (power.families.empty())
    for (const PeopleFamily& family : people_families())
      if (!family.misplaced) power.families.push_back(&family);
  for (std::vector<double>* list : {&power.reaches, &power.people, &power.effects_deg}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  power.pool.reaches = static_cast<std::uint64_t>(power.reaches.back());
  options.writing.write([&] { return simulate_power(power); }, power_results, power_text);
}

}  // namespace

void add_power(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = add_command(
      app, "power", "How many people a first trial needs to show an effect of the controller.",
      R"(Simulated people reach with our controller and without one (or with the paper's). Trials draw people
from them, and a paired t test compares the sizes of each person's errors of the real target's
bearing. The text names every assumption; effects of 0 show whether the test is exact for these
people. All is simulation; there was no human trial.

Examples:
  hrt-study power
  hrt-study power --against paper --effect 0.5,1 --reaches 10
  hrt-study power --scatter 3 --format csv --out power.csv)",
      [options] { run(*options); });
  PowerOptions& power = options->power;
  add_choice(command, "--against", &options->against, {"none", "paper"},
             "Compare with no controller (the plate at 0), or with the paper's.");
  add_numbers(command, "--effect", &power.effects_deg, {0.0, 90.0, false},
              "Mean decreases of a person's error to be shown, deg.");
  add_numbers(command, "--reaches", &power.reaches, {.low = 1.0, .high = 200.0, .whole = true},
              "Reaches of a person under each condition.");
  add_numbers(command, "--people", &power.people, {.low = 2.0, .high = 1000.0, .whole = true},
              "People in a trial.");
  add_number(command, "--scatter", &power.pool.scatter_deg, {0.0, 45.0},
             "Scatter of a reach's error beyond the simulation's, standard deviation, deg.");
  add_families(command, &power.families, "all except those marked + in robustness --help",
               "People to simulate.");
  add_integer(command, "--pool", &power.pool.people, 2, 10'000, "Simulated people of each family.");
  add_integer(command, "--trials", &power.trials, 100, 1'000'000, "Simulated trials of each number.");
  add_seed(command, &power.pool.seed);
  add_threads(command, &power.pool.threads);
  options->writing.add_options(command);
}

}  // namespace hrt::study
