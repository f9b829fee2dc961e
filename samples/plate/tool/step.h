// Fit of the onset, speed and acceleration of a plate's steps.
#pragma once

#include <optional>
#include <vector>

namespace hrt::plate {

/// Mean with its standard error, which is at least that of the resolution of the reports.
struct Measured {
  double value = 0.0;
  double deviation = 0.0;
};

/// Returns the mean with the standard error of the spread.
Measured mean_of(const std::vector<double>& values);

/// Report in a step: time since the command, and angle from the start, in the direction of the step.
struct StepSample {
  double time_s;
  double way_deg;
};

struct Step {
  double way_deg;
  std::vector<StepSample> samples;
};

/// Motion that begins at onset_s and has a constant acceleration up to its speed.
struct StepsFit {
  Measured onset_s;
  Measured speed_deg_s;
  Measured acceleration_deg_s2;
};

/// Fits the motion to the samples of the first 65 % of each step. The sensor has a first-order filter with the time
/// constant filter_s. Requires at least two steps. Returns nullopt if a step has fewer than four samples from 30 % on.
std::optional<StepsFit> fit_steps(const std::vector<Step>& steps, double filter_s);

}  // namespace hrt::plate
