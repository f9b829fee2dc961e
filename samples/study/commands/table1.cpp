#include "samples/study/paper/table1.h"

#include <memory>

#include "samples/study/cli/arguments.h"
#include "samples/study/commands/commands.h"
#include "samples/study/numbers/results.h"

namespace hrt::study {

void add_table1(CLI::App& app) {
  struct CommandOptions {
    Table1Options table;
    Writing writing;
  };
  const auto options = std::make_shared<CommandOptions>();
  CLI::App& command = add_command(
      app, "table1", "Compare the paper's Table I and its other claims with the model.",
      R"(A cell agrees if the model's percentage lies in Wilson's 95 % interval of the paper's 50 trials.
Chi-squared compares all 24 cells together; if they agree, its expected value is 24.

Examples:
  hrt-study table1
  hrt-study table1 --plate-bound 90
  hrt-study table1 --trials 1000000 --format json --out table1.json)",
      [options] {
        options->writing.write([options] { return simulate_table1(options->table); }, table1_results, table1_text);
      });
  add_trials(command, options->table.trials, "Number of trials in each cell.");
  add_seed(command, options->table.seed);
  add_integer(command, "--horizon", options->table.horizon, 1, max_horizon,
              "Prediction horizon of the controller, steps.");
  add_number(command, "--sensory-variance", options->table.sensory_variance_deg2, positive_variance_range,
             "Variance of the combined measurement of touch and proprioception, deg^2; the paper does not give it.");
  add_number(command, "--plate-bound", options->table.plate_bound_deg, plate_bound_range,
             "Largest angle between plate orientation and virtual direction, deg; the paper has 90.");
  add_integer(command, "--steps", options->table.steps, 1, max_trial_steps, "Model steps of a reach.");
  add_threads(command, options->table.threads);
  options->writing.add_options(command);
}

}  // namespace hrt::study
