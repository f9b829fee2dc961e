// The node tree of one scene of a glTF 2.0 file, as scene.cpp needs it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/geometry.h"
#include "scene/haptic_properties.h"

namespace hrt {

/// A node that carries a haptic role.
struct HapticNode {
  std::string name;  ///< of the node itself; may be empty
  std::string path;  ///< names from the root, joined with '/'; a nameless node is its index in brackets,
                     ///< control characters are '?'
  Vec3 origin_m;     ///< in the world
  Axes axes;         ///< what the node's world transform makes of its axes: not unit, not always perpendicular
  HapticProperties properties;
};

/// The haptic nodes of the file's default scene, parents before children, siblings in the file's order.
/// Throws SceneError.
std::vector<HapticNode> read_haptic_nodes(const std::filesystem::path& file);
std::vector<HapticNode> read_haptic_nodes(std::span<const std::byte> bytes, std::string_view name);

}  // namespace hrt
