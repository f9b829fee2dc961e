// The scene: pose of the plate, real target assigned to each virtual target, and marks that a person touches.
#pragma once

#include <openxr/openxr.h>

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "samples/app/base/plugin.h"

namespace hrt::app {

/// A virtual target and the real target assigned to it. Directions are seen from the start, in degrees from the
/// mid-line; positions are in plate coordinates.
struct TargetPair {
  std::string virtual_name;
  std::string real_name;
  double virtual_direction_deg;
  double real_direction_deg;
  double real_distance_m;  ///< distance from the start, along the plate
  double real_radius_m;    ///< 0 if the scene gives none
  std::array<double, 3> virtual_position_m;
  std::array<double, 3> real_position_m;
  hrt_target virtual_target;
  hrt_target real_target;
};

/// A scene whose targets are registered in a session of the plugin.
struct TargetSet {
  XrPosef plate_pose;  ///< in world coordinates of the scene, whose floor is at y = 0
  double plate_radius_m;
  std::array<double, 3> start_m;  ///< in plate coordinates
  hrt_session session;
  std::vector<TargetPair> pairs;  ///< one for each virtual target, in the scene's order
};

XrPosef to_xr(const double (&position_m)[3], const double (&rotation)[4]);

/// Loads the scene, creates a session from `config`, and sets the session's plate, start and targets from the scene.
/// Throws Failure: ExitCode::scene if the scene cannot be loaded, ExitCode::plugin if another call of the plugin fails.
TargetSet load_targets(const Plugin& plugin, const std::filesystem::path& scene_file, const hrt_session_config& config);

struct Mark {
  std::string name;                  ///< name for the user
  std::array<double, 3> position_m;  ///< in plate coordinates
};

/// True if `text` has no control characters.
bool is_printable(const std::string& text);

std::vector<std::string> names_of(std::span<const Mark> marks);

/// Returns marks at the scene's start and at five positions on the plate's rim, with names for the user.
std::vector<Mark> marks_of(const TargetSet& targets);

/// Reads 3 to 8 marks, with coordinates from -1 to 1 m, from a CSV file whose first columns are name, x_m, y_m and z_m,
/// such as samples/plate/model/marks.csv. Throws Failure (ExitCode::registration).
std::vector<Mark> read_marks(const std::filesystem::path& file);

}  // namespace hrt::app
