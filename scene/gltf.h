// Parses the JSON of a glTF 2.0 file by tinygltf, within limits.
#pragma once

// IWYU pragma: begin_exports
#include <tiny_gltf.h>
// IWYU pragma: end_exports

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace hrt {

/// Limits that bound the memory that a hostile file takes. Sections that parse_gltf() skips count for json_bytes and
/// json_depth only.
namespace gltf_limits {
inline constexpr std::size_t json_bytes = std::size_t{64} << 20;
inline constexpr std::size_t json_values = 1'000'000;
inline constexpr std::size_t json_depth = 64;
inline constexpr std::size_t nodes = 100'000;
inline constexpr std::size_t node_depth = 256;
inline constexpr std::size_t name_bytes = 255;
inline constexpr std::size_t haptic_nodes = 1000;
}  // namespace gltf_limits

/// Position and size of the JSON in a file, in bytes.
struct JsonExtent {
  std::size_t offset;
  std::size_t size;
};

/// Number of bytes at the beginning of a file that find_json() needs.
inline constexpr std::size_t glb_header_bytes = 20;

/// Finds the JSON: the first chunk of a binary file, which is recognised by its magic number, or the whole of a text
/// file. `header` is the first glb_header_bytes bytes, or all of a shorter file. Throws SceneError.
JsonExtent find_json(std::string_view header, std::uint64_t file_bytes, const std::string& file);

/// Parses the sections asset, scene, scenes, nodes and extensionsRequired. Other sections are skipped, so that no
/// buffer or image is opened or decoded. Throws SceneError if the text is not glTF 2.0, requires an extension that may
/// move nodes, has a repeated key outside the skipped sections, or exceeds json_values, json_depth or nodes.
///
/// The model is not validated further: indices may be out of range and nodes may form cycles. tinygltf ignores values
/// of a wrong type, and truncates integers to 32 bits.
tinygltf::Model parse_gltf(std::string json, const std::string& file);

}  // namespace hrt
