// Fig. 1c of the paper: slides straight ahead over a plate that rests at each of five angles.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "samples/study/figures/figures.h"
#include "samples/study/numbers/results.h"

namespace hrt::study {

struct RidgeOptions {
  std::vector<double> plate_angles_deg{-60.0, -30.0, 0.0, 30.0, 60.0};  ///< those of the paper's [2]
  double tactile_weight = 0.15;
  double motor_variance_deg2 = 0.5;
  std::uint64_t trials = 50;
  std::uint64_t seed = 1;
};

struct RidgeAngle {
  double plate_deg;
  double rest_deg;  ///< where what is felt is straight ahead: -w T / (1 - w)
  double mean_deg;  ///< of the final directions
  double sd_deg;
  std::vector<std::vector<double>> directions_deg;  ///< of the finger in each step of each trial
};

struct Ridges {
  RidgeOptions options;
  std::vector<RidgeAngle> angles;
};

Ridges simulate_ridges(const RidgeOptions& options);

std::string ridges_text(const Ridges& ridges);
Results ridges_results(const Ridges& ridges);
Figure ridges_figure(const Ridges& ridges);

}  // namespace hrt::study
