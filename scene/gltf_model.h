// The nodes of a glTF 2.0 file, as tinygltf reads them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

// IWYU pragma: begin_exports
#include <tiny_gltf.h>
// IWYU pragma: end_exports

namespace hrt {

struct GltfModel {
  tinygltf::Model model;   ///< of its sections, nodes and scenes; the nodes are a forest
  std::vector<int> roots;  ///< of the default scene, or of the only one
};

/// From the JSON of a file. No other file is opened, and no image is decoded. Throws SceneError.
GltfModel read_model(std::string_view json, const std::string& file);

}  // namespace hrt
