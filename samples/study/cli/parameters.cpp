#include "samples/study/cli/parameters.h"

#include <cmath>
#include <limits>

namespace hrt::study {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr NumberRange whole(double low, double high) { return {.low = low, .high = high, .whole = true}; }

// An open value is filled in by make_condition().
void describe(CLI::Option* option, const Parameter& parameter) {
  if (std::isnan(parameter.default_value)) show_default(option, "that of --tactile-weight");
}

}  // namespace

const std::array<Parameter, std::tuple_size_v<ParameterValues>> parameters{{
    {"--tactile-weight", "tactile_weight", tactile_weight_range, 0.15,
     "Share of touch in the direction that the participant feels (w_T)."},
    {"--assumed-tactile-weight", "assumed_tactile_weight", tactile_weight_range, nan,
     "The share that the controller takes the participant's to be."},
    {"--motor-variance", "motor_variance_deg2", variance_range, 0.5,
     "Variance of the motor command in a step (sigma_u^2), deg^2."},
    {"--sensory-variance", "sensory_variance_deg2", positive_variance_range, 0.1,
     "Variance of what touch and proprioception report (sigma_h^2), deg^2."},
    {"--initial-variance", "initial_variance_deg2", variance_range, 0.0,
     "Variance of the perceived direction before the first step, deg^2."},
    {"--horizon", "horizon", whole(1, max_horizon), 3.0, "Steps that the controller looks ahead."},
    {"--perceived-weight", "perceived_weight", positive_weight_range, 1.0,
     "Weight of the perceived direction's error in the controller's cost."},
    {"--actual-weight", "actual_weight", weight_range, 1.0,
     "Weight of the actual direction's error in the controller's cost."},
    {"--plate-bound", "plate_bound_deg", plate_bound_range, 84.5,
     "How far the plate turns from the virtual direction, deg."},
    {"--plate-rate-bound", "plate_rate_bound_deg", plate_rate_bound_range, infinity,
     "How far the plate turns in one step, deg; inf: no limit."},
    {"--steps", "steps", whole(1, max_trial_steps), 30.0, "Model steps of a reach, 0.1 s each."},
}};

void add_parameter(CLI::App& app, const Parameter& parameter, double* value) {
  describe(add_number(app, parameter.option, value, parameter.range, parameter.help), parameter);
}

void add_parameter(CLI::App& app, const Parameter& parameter, std::vector<double>* values) {
  describe(add_numbers(app, parameter.option, values, parameter.range, parameter.help), parameter);
}

ParameterValues default_values() {
  ParameterValues values;
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = parameters[i].default_value;
  return values;
}

Condition make_condition(const ParameterValues& values, double real_direction_deg, double virtual_direction_deg) {
  const auto [tactile_weight, assumed_tactile_weight, motor_variance_deg2, sensory_variance_deg2, initial_variance_deg2,
              horizon, perceived_weight, actual_weight, plate_bound_deg, plate_rate_bound_deg, steps] = values;
  Condition condition{
      .participant = {.tactile_weight = tactile_weight,
                      .motor_variance_deg2 = motor_variance_deg2,
                      .sensory_variance_deg2 = sensory_variance_deg2,
                      .initial_variance_deg2 = initial_variance_deg2},
      .controller = {.mpc = {.horizon = static_cast<int>(horizon),
                             .perceived_weight = perceived_weight,
                             .actual_weight = actual_weight,
                             .plate_bound_deg = plate_bound_deg,
                             .plate_rate_bound_deg = plate_rate_bound_deg}},
      .real_direction_deg = real_direction_deg,
      .virtual_direction_deg = virtual_direction_deg,
      .steps = static_cast<int>(steps),
  };
  condition.controller.participant = condition.participant;
  if (!std::isnan(assumed_tactile_weight)) condition.controller.participant.tactile_weight = assumed_tactile_weight;
  return condition;
}

Condition make_condition(double motor_variance_deg2, double tactile_weight, double real_direction_deg,
                         double virtual_direction_deg) {
  Condition condition = make_condition(default_values(), real_direction_deg, virtual_direction_deg);
  condition.participant.motor_variance_deg2 = motor_variance_deg2;
  condition.participant.tactile_weight = tactile_weight;
  condition.controller.participant = condition.participant;
  return condition;
}

ParameterValues values_of(const Condition& condition) {
  const Participant& participant = condition.participant;
  const MpcConfig& mpc = condition.controller.mpc;
  return {participant.tactile_weight,
          condition.controller.participant.tactile_weight,
          participant.motor_variance_deg2,
          participant.sensory_variance_deg2,
          participant.initial_variance_deg2,
          static_cast<double>(mpc.horizon),
          mpc.perceived_weight,
          mpc.actual_weight,
          mpc.plate_bound_deg,
          mpc.plate_rate_bound_deg,
          static_cast<double>(condition.steps)};
}

}  // namespace hrt::study
