// The JSON of a glTF 2.0 file: found in its container, and read into what a scene needs of it, every index,
// size and type checked, its nodes a forest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/geometry.h"
#include "scene/json_document.h"

namespace hrt {

/// Where the JSON lies in a file.
struct JsonExtent {
  std::size_t offset;
  std::size_t size;
};

/// Bytes of a file's head that json_extent() needs.
inline constexpr std::size_t glb_head_bytes = 20;

/// Of a .glb (recognised by its magic number) the JSON chunk, else the whole file. `head` is the file's first
/// glb_head_bytes bytes, or all of a shorter one. Throws SceneError.
JsonExtent json_extent(std::string_view head, std::uint64_t file_bytes, const std::string& file);

struct GltfNode {
  std::string_view name;  ///< empty if it has none
  JsonValue extras;       ///< may not exist
  Transform local;
  bool has_matrix = false;  ///< in place of translation, rotation and scale
  std::vector<std::size_t> children;
};

struct Gltf {
  JsonDocument json;  ///< to which the nodes refer
  std::vector<GltfNode> nodes;
  std::vector<std::size_t> roots;  ///< of the default scene, or of the only one
};

/// Addresses of buffers and images are checked though none is read. Throws SceneError.
Gltf read_gltf(std::string_view json, const std::string& file);

}  // namespace hrt
