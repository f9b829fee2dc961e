// The JSON of a glTF 2.0 file, checked before a glTF library sees it: found in its container, bounded,
// stripped to the needed sections, every index, size and type right, its nodes a forest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

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

/// The file's asset, extensionsUsed, extensionsRequired, nodes, scenes and scene, as JSON text. Buffers'
/// addresses are checked though no buffer is read. Throws SceneError.
std::string checked_gltf_json(std::string_view json, const std::string& file);

}  // namespace hrt
