// hrt-study trial: one simulated reach as CSV, one row per step; or a trace with one row per sample, and figures.
#include "core/paper_simulation/trial.h"

#include <cmath>
#include <memory>
#include <optional>

#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/study/commands/commands.h"
#include "samples/study/figures/figures.h"

namespace hrt::study {
namespace {

struct TrialOptions {
  Condition condition;
  std::optional<double> fixed_plate_deg;  // nullopt: the controller turns the plate
  std::uint64_t seed = 1;
  std::uint32_t condition_number = 0;
  std::uint32_t trial = 0;
  std::string out;
  std::string trace;  // folder of --trace; empty: simulate a trial of the paper's model
  std::vector<const PeopleFamily*> families{&people_families().front()};
  double duration_s = 1.5;
  int reach = 1;
};

const char* name(ActiveBound bound) {
  static constexpr const char* names[] = {"none", "lower", "upper", "rate_down", "rate_up"};
  return names[static_cast<std::size_t>(bound)];
}

// Returns one row per step, and a last row with the direction after the last step.
std::string csv(const std::vector<TrialStep>& steps, const TrialOutcome& outcome) {
  Results found;
  for (const TrialStep& step : steps)
    found.rows.push_back({{"step", step.step},
                          {"finger_direction_deg", step.finger_direction_deg},
                          {"plate_orientation_deg", step.plate_orientation_deg},
                          {"felt_direction_deg", step.felt_direction_deg},
                          {"perceived_direction_deg", step.perceived_direction_deg},
                          {"gain", step.gain},
                          {"variance_deg2", step.variance_deg2},
                          {"motor_command_deg", step.motor_command_deg},
                          {"noise_deg", step.noise_deg},
                          {"active_bound", name(step.active)}});
  Row last = found.rows.front();
  for (Row& value : last) value = nullptr;
  last["step"] = steps.size();
  last["finger_direction_deg"] = outcome.final_direction_deg;
  found.rows.push_back(last);
  return csv_of(found);
}

void run_trace(const TrialOptions& options) {
  if (options.families.size() != 1) throw UsageError("--family: --trace allows one family only");
  StagingFolder staged("--trace", options.trace);
  PersonCondition condition = draw_person(*options.families.front(), options.duration_s, options.seed, options.trial);
  condition.real_direction_deg = options.condition.real_direction_deg;
  condition.virtual_direction_deg = options.condition.virtual_direction_deg;
  const Results trace = trace_reach(condition, options.reach, options.seed, options.trial);
  staged.write("trace.csv", csv_of(trace));
  staged.draw({{.name = "reach", .title = "", .caption = "", .data = page_of(trace)},
               {.name = "trace",
                .title = "States of the filter over time in s, with +-2 SDs",
                .caption = "",
                .data = page_of(trace)}});
  staged.publish();
}

void run(const TrialOptions& options) {
  Condition condition = options.condition;
  condition.controller.participant = condition.participant;
  if (options.fixed_plate_deg) {
    condition.controller.mode = ControlMode::fixed_plate;
    condition.controller.fixed_plate_orientation_deg = *options.fixed_plate_deg;
  }
  if (std::abs(condition.virtual_direction_deg - condition.real_direction_deg) >= 90.0)
    throw UsageError(not_allowed("--real", fmt::to_string(condition.real_direction_deg),
                                 fmt::format("less than 90 deg from --virtual ({})", condition.virtual_direction_deg)));
  if (!options.trace.empty()) return run_trace(options);
  const Output output("--out", options.out);
  std::vector<TrialStep> steps;
  const TrialOutcome outcome = simulate_trial(
      condition, {.seed = options.seed, .condition = options.condition_number, .trial = options.trial}, &steps);
  output.write(csv(steps, outcome));
}

}  // namespace

void add_trial(CLI::App& app) {
  const auto options = std::make_shared<TrialOptions>();
  CLI::App& command =
      add_command(app, "trial", "Simulate one reach as CSV, one row per step.",
                  R"(Row k has the values of step k. The last row has only the direction in which the finger moves after
the last step. Numbers have full precision. A trial has the same random numbers as the trial of the
same number in a cell of 'table1' with the same seed, if --condition is the row of this cell in the
CSV of 'table1', from 0.

--trace simulates a reach of a person under the plugin's default controller instead: --family, --duration,
--reach, --trial (number of the person), --seed, --real and --virtual select the reach. Files in the folder:
trace.csv, the states of the controller's filter with their SDs at each sample; trace.svg, a figure of the states;
reach.svg, an animation of the reach from above.

Examples:
  hrt-study trial --trace reach --family bias-3 --reach 5
  hrt-study trial --real 0 --virtual 10 --out reach.csv
  hrt-study trial --real 5 --virtual -5 --motor-variance 0.1 --fixed-plate 0)",
                  [options] { run(*options); });
  Condition& condition = options->condition;
  Participant& participant = condition.participant;
  MpcConfig& mpc = condition.controller.mpc;
  add_number(command, "--real", condition.real_direction_deg, direction_range, "Direction of the real target, deg.");
  add_number(command, "--virtual", condition.virtual_direction_deg, direction_range,
             "Direction of the virtual target, deg; less than 90 from the real one.");
  const std::vector<CLI::Option*> of_paper = {
      add_number(command, "--tactile-weight", participant.tactile_weight, tactile_weight_range,
                 "Tactile weight w_T: fraction of touch in the perceived direction."),
      add_number(command, "--motor-variance", participant.motor_variance_deg2, variance_range,
                 "Variance of the motor command in a step (sigma_u^2), deg^2."),
      add_number(command, "--sensory-variance", participant.sensory_variance_deg2, positive_variance_range,
                 "Variance of the combined measurement of touch and proprioception in a step (sigma_h^2), deg^2."),
      add_number(command, "--initial-variance", participant.initial_variance_deg2, variance_range,
                 "Variance of the perceived direction before the first step, deg^2."),
      add_integer(command, "--horizon", mpc.horizon, 1, max_horizon, "Prediction horizon of the controller, steps."),
      add_number(command, "--plate-bound", mpc.plate_bound_deg, plate_bound_range,
                 "Largest angle between plate orientation and virtual direction, deg."),
      add_number(command, "--plate-rate-bound", mpc.plate_rate_bound_deg, {0.0, 360.0, false, true, true},
                 "Largest rotation of the plate in one step, deg; inf: no limit."),
      add_integer(command, "--steps", condition.steps, 1, max_trial_steps, "Model steps of a reach, 0.1 s each."),
      command
          .add_option("--fixed-plate", options->fixed_plate_deg,
                      "No controller: the plate stays at this orientation, deg.")
          ->check(must_be(direction_range)),
      add_integer(command, "--condition", options->condition_number, 0, UINT32_MAX,
                  "Number of the condition; selects the random numbers."),
      add_out(command, options->out)};
  add_seed(command, options->seed);
  add_integer(command, "--trial", options->trial, 0, UINT32_MAX, "Number of the trial; selects the random numbers.");
  CLI::Option* trace =
      add_path(command, "--trace", options->trace, "Folder for the trace of a reach by a simulated person.");
  add_families(command, options->families, "linear", "Family of the person.")->needs(trace);
  add_number(command, "--duration", options->duration_s, {0.3, 10.0}, "Duration of the motion, s.")->needs(trace);
  add_integer(command, "--reach", options->reach, 1, 100, "Number of the reach of this person.")->needs(trace);
  for (CLI::Option* option : of_paper) trace->excludes(option);
}

}  // namespace hrt::study
