// The parameters of a simulated reach except its two directions, one number each: `trial` takes one of each,
// `sweep` a list of each.
#pragma once

#include <array>

#include "core/paper_simulation/trial.h"
#include "samples/study/cli/arguments.h"

namespace hrt::study {

struct Parameter {
  const char* option;
  const char* column;  ///< in CSV, with its unit
  NumberRange range;
  double default_value;  ///< condition 1 of Table I
  const char* help;
};

/// One value for each of `parameters`, in their order.
using ParameterValues = std::array<double, 11>;

extern const std::array<Parameter, std::tuple_size_v<ParameterValues>> parameters;

/// Adds the option for one value, or for a list of values.
void add_parameter(CLI::App& app, const Parameter& parameter, double* value);
void add_parameter(CLI::App& app, const Parameter& parameter, std::vector<double>* values);

ParameterValues default_values();

/// The reach of these values. The assumed tactile weight may be NaN: the participant's own is assumed.
Condition make_condition(const ParameterValues& values, double real_direction_deg, double virtual_direction_deg);

/// As condition 1 of Table I, except for the person's motor variance and tactile weight, which the controller
/// knows.
Condition make_condition(double motor_variance_deg2, double tactile_weight, double real_direction_deg,
                         double virtual_direction_deg);

/// The values of a condition, with an assumed weight of NaN replaced.
ParameterValues values_of(const Condition& condition);

}  // namespace hrt::study
