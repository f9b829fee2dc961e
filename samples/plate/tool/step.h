// Fit of onset, speed and acceleration to the response of a plate to steps of its command.
#pragma once

#include <optional>
#include <vector>

namespace hrt::plate {

/// Measured value with its standard error.
struct Measured {
  double value = 0.0;
  double deviation = 0.0;
};

/// Returns the mean of at least two values, with its standard error.
Measured mean_of(const std::vector<double>& values);

/// Report during a step: time since the command, and angle from the start in the direction of the step.
struct StepSample {
  double time_s;
  double travel_deg;
};

struct Step {
  double travel_deg;
  std::vector<StepSample> samples;
};

/// Motion that begins onset_s after the command and has a constant acceleration up to a constant speed.
struct StepsFit {
  Measured onset_s;
  Measured speed_deg_s;
  Measured acceleration_deg_s2;
};

/// Fits the motion to the samples of the first 65 % of each step. The sensor has a first-order filter with the time
/// constant filter_s. Requires at least two steps. Returns nullopt if a step has under four samples from 30 to 65 %.
std::optional<StepsFit> fit_steps(const std::vector<Step>& steps, double filter_s);

}  // namespace hrt::plate
