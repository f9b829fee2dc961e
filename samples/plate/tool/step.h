// Steps of a plate: when they began, how fast they were.
#pragma once

#include <optional>
#include <vector>

namespace hrt::plate {

/// A mean, and its standard error: of the spread, and where reports repeat exactly, of their step.
struct Measured {
  double value = 0.0;
  double deviation = 0.0;
};

Measured mean_of(const std::vector<double>& values);

/// A report: seconds since the command, and the way from the place before, in the step's direction.
struct StepSample {
  double time_s;
  double way_deg;
};

struct Step {
  double way_deg;
  std::vector<StepSample> samples;
};

/// Motions that begin after onset_s, and accelerate evenly to their speed.
struct StepsFit {
  Measured onset_s;
  Measured speed_deg_s;
  Measured acceleration_deg_s2;
};

/// Fits them to the samples up to 65 % of each way, as a sensor shows them that smooths by a filter of first
/// order with this time constant. Takes two steps or more; nothing if one has fewer than four samples from 30
/// %.
std::optional<StepsFit> fit_steps(const std::vector<Step>& steps, double filter_s);

}  // namespace hrt::plate
