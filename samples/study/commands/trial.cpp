// hrt-study trial: one simulated reach as CSV, a row a step; or traced, a row a sample, with pictures.
#include "core/paper_simulation/trial.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <limits>
#include <memory>

#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/study/cli/parameters.h"
#include "samples/study/commands/commands.h"
#include "samples/study/figures/figures.h"
#include "samples/study/figures/workshop.h"

namespace hrt::study {
namespace {

struct TrialOptions {
  ParameterValues values = default_values();
  double real_direction_deg = -5.0;
  double virtual_direction_deg = 5.0;
  double plate_start_deg = 0.0;
  double fixed_plate_deg = std::numeric_limits<double>::quiet_NaN();  // the controller turns it
  std::uint64_t seed = 1;
  std::uint64_t condition = 0;
  std::uint64_t trial = 0;
  std::string out;
  std::string trace;  // a folder; empty: the paper's person, by steps
  std::vector<const PeopleFamily*> families{&people_families().front()};
  double duration_s = 1.5;
  std::uint64_t reach = 1;
};

const char* name(ActiveBound bound) {
  static constexpr const char* names[] = {"none", "lower", "upper", "rate_down", "rate_up"};
  return names[static_cast<std::size_t>(bound)];
}

std::string csv(const std::vector<TrialStep>& steps, const TrialOutcome& outcome) {
  std::string page =
      "step,finger_direction_deg,plate_orientation_deg,felt_direction_deg,perceived_direction_deg,gain,"
      "variance_deg2,motor_command_deg,noise_deg,active_bound\n";
  for (const TrialStep& step : steps) {
    page += std::to_string(step.step);
    for (const double value :
         {step.finger_direction_deg, step.plate_orientation_deg, step.felt_direction_deg, step.perceived_direction_deg,
          step.gain, step.variance_deg2, step.motor_command_deg, step.noise_deg})
      page += ',' + number(value);
    page += std::string(",") + name(step.active) + '\n';
  }
  return page + std::to_string(steps.size()) + ',' + number(outcome.final_direction_deg) + ",,,,,,,,\n";
}

void run_trace(const TrialOptions& options) {
  if (options.families.size() != 1) throw UsageError("--family: one family is traced at a time");
  Workshop workshop("--trace", options.trace);
  const auto index = static_cast<std::uint32_t>(options.trial);
  PersonCondition condition = draw_person(*options.families.front(), options.duration_s, options.seed, index);
  condition.real_direction_deg = options.real_direction_deg;
  condition.virtual_direction_deg = options.virtual_direction_deg;
  const Trace trace = trace_reach(condition, static_cast<int>(options.reach), options.seed, index);
  workshop.write("trace.csv", trace_csv(trace));
  workshop.write("reach.svg", moving_picture(trace));
  workshop.draw(trace_figure(trace));
  workshop.publish();
}

void run(const TrialOptions& options) {
  Condition condition = make_condition(options.values, options.real_direction_deg, options.virtual_direction_deg);
  condition.plate_orientation_deg = options.plate_start_deg;
  if (!std::isnan(options.fixed_plate_deg)) {
    condition.controller.mode = ControlMode::fixed_plate;
    condition.controller.fixed_plate_orientation_deg = options.fixed_plate_deg;
  }
  if (std::abs(options.virtual_direction_deg - options.real_direction_deg) >= gap_range.high)
    throw UsageError(not_allowed("--real", number(options.real_direction_deg),
                                 "less than 90 deg from --virtual (" + number(options.virtual_direction_deg) + ")"));
  if (!options.trace.empty()) return run_trace(options);
  const Output output("--out", options.out);
  std::vector<TrialStep> steps;
  const TrialOutcome outcome = simulate_trial(condition,
                                              {.seed = options.seed,
                                               .condition = static_cast<std::uint32_t>(options.condition),
                                               .trial = static_cast<std::uint32_t>(options.trial)},
                                              &steps);
  output.write(csv(steps, outcome));
}

}  // namespace

void add_trial(CLI::App& app) {
  const auto options = std::make_shared<TrialOptions>();
  CLI::App& command =
      add_command(app, "trial", "One simulated reach as CSV, a row a step.",
                  R"(Row k holds what happened in step k. The last row holds only the direction in which the finger
moves after the last step. Numbers have full precision. The same seed, condition and trial
number give the random numbers of that trial in a batch.

With --trace the reach is one of a person led by our controller: --family, --duration, --reach, --trial (the
person's number), --seed, --real and --virtual say which. The folder gets trace.csv, every state of the filter
with its deviation at each sample, trace.svg, their picture, and reach.svg, the reach from above, moving.

Examples:
  hrt-study trial --trace reach --family bias-3 --reach 5
  hrt-study trial --real 0 --virtual 10 --out reach.csv
  hrt-study trial --real 5 --virtual -5 --motor-variance 0.1 --fixed-plate 0)",
                  [options] { run(*options); });
  add_number(command, "--real", &options->real_direction_deg, direction_range, "Direction of the real target, deg.");
  add_number(command, "--virtual", &options->virtual_direction_deg, direction_range,
             "Direction of the virtual target, deg; less than 90 from the real one.");
  for (std::size_t i = 0; i < parameters.size(); ++i) add_parameter(command, parameters[i], &options->values[i]);
  add_number(command, "--plate-start", &options->plate_start_deg, direction_range,
             "Orientation of the plate before the first step, deg; matters with a rate bound.");
  show_default(add_number(command, "--fixed-plate", &options->fixed_plate_deg, direction_range,
                          "No controller: the plate stays at this orientation, deg."),
               "");
  add_seed(command, &options->seed);
  const auto max = std::numeric_limits<std::uint32_t>::max();
  add_integer(command, "--condition", &options->condition, 0, max, "Which condition's random numbers to take.");
  add_integer(command, "--trial", &options->trial, 0, max, "Which trial's random numbers to take.");
  add_out(command, &options->out);
  CLI::Option* trace = add_path(command, "--trace", &options->trace, "a folder", "Traces a reach of a person there.");
  add_families(command, &options->families, "linear", "The person's family, with --trace.");
  add_number(command, "--duration", &options->duration_s, {0.3, 10.0}, "Of the motion in s, with --trace.");
  add_integer(command, "--reach", &options->reach, 1, 100, "Of the person, in a row, with --trace.");
  for (const char* of_trace : {"--family", "--duration", "--reach"}) command.get_option(of_trace)->needs(trace);
  for (const auto& of_paper : parameters) trace->excludes(command.get_option(of_paper.option));
  trace->excludes("--plate-start", "--fixed-plate", "--condition", "--out");
}

}  // namespace hrt::study
