// Paths of simulated trials, as gnuplot draws them.
#pragma once

#include <string>
#include <vector>

#include "core/paper_simulation/trial.h"

namespace hrt::study {

inline constexpr double path_length_mm = 100.0;

struct PathPoint {
  double right_mm;
  double forward_mm;
};
using Path = std::vector<PathPoint>;

PathPoint ahead(PathPoint from, double direction_deg, double distance_mm);

/// Equal distances along the direction of each step, path_length_mm in all.
Path path_of(const std::vector<TrialStep>& steps, double TrialStep::* direction_deg);

/// The median of paths with the same steps, step by step.
Path median_path(const std::vector<Path>& paths);

/// A block of data with that name; a blank line between paths breaks the curve.
std::string path_block(const std::string& name, const std::vector<Path>& paths);

}  // namespace hrt::study
