// A step of a plate: when it began, how fast it was.
#pragma once

#include <optional>
#include <vector>

namespace hrt::plate {

/// A report: seconds since the command, and the way from the place before, in the step's direction.
struct StepSample {
  double time_s;
  double way_deg;
};

/// A motion that begins at onset_s and accelerates evenly to its speed.
struct StepFit {
  double onset_s;
  double speed_deg_s;
  double acceleration_deg_s2;
};

/// Fits it to the samples up to 65 % of `way_deg`, as a sensor shows it that smooths by a filter of first
/// order with this time constant. Nothing if there are fewer than four samples from 35 to 65 %.
std::optional<StepFit> fit_step(const std::vector<StepSample>& samples, double way_deg, double filter_s);

}  // namespace hrt::plate
