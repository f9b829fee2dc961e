// The scene: the plate's place, the real target that serves each virtual one, and marks that a person
// touches.
#pragma once

#include <openxr/openxr.h>

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "samples/app/base/plugin.h"

namespace hrt::app {

/// A virtual target and the real one that serves it. Directions from the start, in degrees from the
/// mid-line; positions in plate coordinates.
struct TargetPair {
  std::string virtual_name;
  std::string real_name;
  double virtual_direction_deg;
  double real_direction_deg;
  double real_distance_m;  ///< from the start, along the plate
  double real_radius_m;    ///< 0 if the scene gives none
  std::array<double, 3> virtual_position_m;
  std::array<double, 3> real_position_m;
  hrt_target virtual_target;
  hrt_target real_target;
};

/// A scene whose targets are registered in a session of the plugin.
struct TargetSet {
  XrPosef plate_pose;  ///< in the world of the scene, whose floor is at y = 0
  double plate_radius_m;
  std::array<double, 3> start_m;  ///< in plate coordinates
  hrt_session session;
  std::vector<TargetPair> pairs;  ///< one a virtual target, in the scene's order
};

/// A pose of the plugin's, as OpenXR has it.
XrPosef to_xr(const double (&position_m)[3], const double (&rotation)[4]);

/// Loads the scene and makes the session from `config`, in which the scene sets the start and the plate.
/// Throws Failure: ExitCode::scene, ExitCode::plugin.
TargetSet load_targets(const Plugin& plugin, const std::filesystem::path& scene_file, const hrt_session_config& config);

struct Mark {
  std::string name;                  ///< as a person knows it
  std::array<double, 3> position_m;  ///< in plate coordinates
};

/// Without control characters.
bool is_printable(const std::string& text);

std::vector<std::string> names_of(std::span<const Mark> marks);

/// The scene's start and five places on the rim of its plate, as seen from the user.
std::vector<Mark> marks_of(const TargetSet& targets);

/// A CSV file with the columns name, x_m, y_m, z_m first and a header: samples/plate/model/marks.csv is one.
/// At least 3 marks, each within 1 m, at most 8. Throws Failure (ExitCode::registration) naming the line.
std::vector<Mark> read_marks(const std::filesystem::path& file);

}  // namespace hrt::app
