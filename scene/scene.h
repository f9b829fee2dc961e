// Reads a plate, a start and targets from a glTF 2.0 file. scene/README.md describes the conventions and the properties
// of nodes. Buffers and images to which the file refers are not opened. load_scene() may be called concurrently.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/geometry.h"
#include "scene/scene_error.h"

namespace hrt {

struct ScenePlate {
  Pose pose;  ///< in the world; +Y is the plate's normal, -Z its mid-line away from the user
  double radius_m;
  std::optional<double> max_speed_deg_s;  ///< maximum speed of the servo; unset: not in the file
  /// names of the nodes from the root to the plate, joined with '/'; a node without a name: its index in brackets
  std::string node_path;
};

struct SceneTarget {
  bool is_real;      ///< true: the hand is steered to it; false: a virtual target, which the user sees and reaches for
  std::string name;  ///< unique among the targets
  Vec3 world_position_m;                 ///< origin of the node
  Vec3 position_m;                       ///< origin of the node in plate coordinates; y is the height above the plate
  std::optional<double> radius_m;        ///< unset: not in the file
  std::optional<std::size_t> served_by;  ///< of a virtual target: index in Scene::targets of its real target
  std::string node_path;                 ///< as in ScenePlate
};

struct Scene {
  ScenePlate plate;
  Vec3 start_m;                           ///< in plate coordinates, on the plate: y = 0
  std::optional<std::string> start_path;  ///< node_path of the start; unset: not in the file
  std::vector<SceneTarget> targets;       ///< in the order of the file's node tree
};

/// Returns the direction of a target from the start, in degrees counter-clockwise from the mid-line, in [-180, 180].
double direction_deg(const Scene& scene, const SceneTarget& target);

/// Returns the distance of a target from the start along the plate; at least min_distance_m.
double distance_m(const Scene& scene, const SceneTarget& target);

/// Reads a .gltf or .glb file, recognised by content. Throws SceneError, std::bad_alloc.
Scene load_scene(const std::filesystem::path& file);

/// Reads the content of a file. `name` is the file's name in error texts.
Scene load_scene(std::string_view bytes, const std::string& name);

}  // namespace hrt
