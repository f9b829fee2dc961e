// The node tree of one scene of a glTF 2.0 file: checked, as scene.cpp needs it. The only file
// that uses tinygltf is gltf_tree.cpp.
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

/// What a file may hold. Each limit is far above any real scene and keeps a hostile file's memory bounded.
namespace gltf_limits {
inline constexpr std::size_t json_bytes = std::size_t{64} << 20;
inline constexpr std::size_t json_values = 1'000'000;
inline constexpr int json_depth = 64;
inline constexpr std::size_t nodes = 100'000;
inline constexpr int node_depth = 256;
inline constexpr std::size_t name_bytes = 255;
inline constexpr std::size_t haptic_nodes = 1000;
}  // namespace gltf_limits

/// A node that carries a haptic role.
struct HapticNode {
  std::string name;  ///< of the node itself; may be empty
  std::string path;  ///< names from the root, joined with '/'; a nameless node is its index in brackets,
                     ///< control characters are '?'
  Vec3 origin_m;     ///< in the world
  Axes axes;  ///< what the node's world transform makes of its axes: not unit, not always perpendicular
  HapticProperties properties;
};

/// The haptic nodes of the file's default scene, parents before children, siblings in the file's order.
/// Throws SceneError.
std::vector<HapticNode> read_haptic_nodes(const std::filesystem::path& file);
std::vector<HapticNode> read_haptic_nodes(std::span<const std::byte> bytes, std::string_view name);

}  // namespace hrt
