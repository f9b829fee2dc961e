// Marks on the plate, or on what stands still around it, that a person touches to register it.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "samples/reach/scene/targets.h"

namespace hrt::reach {

struct Mark {
  std::string name;                  ///< as a person knows it
  std::array<double, 3> position_m;  ///< in plate coordinates
};

/// The scene's start and five places on the rim of its plate, as seen from the user.
std::vector<Mark> marks_of(const TargetSet& targets);

/// A CSV file with the columns name, x_m, y_m, z_m first and a header: samples/plate/model/marks.csv is one.
/// At least 3 marks, each within 1 m, at most 8. Throws Failure (ExitCode::registration) naming the line.
std::vector<Mark> read_marks(const std::filesystem::path& file);

}  // namespace hrt::reach
