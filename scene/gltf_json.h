// The JSON of a glTF 2.0 file: found in its container, and read within limits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace hrt {

/// What a file may hold: far above any real scene, to keep a hostile file's memory bounded.
namespace gltf_limits {
inline constexpr std::size_t json_bytes = std::size_t{64} << 20;
inline constexpr std::size_t json_values = 1'000'000;
inline constexpr std::size_t json_depth = 64;
inline constexpr std::size_t nodes = 100'000;
inline constexpr int node_depth = 256;
inline constexpr std::size_t name_bytes = 255;
inline constexpr std::size_t haptic_nodes = 1000;
}  // namespace gltf_limits

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

/// The sections that place nodes, and the addresses of other files. Throws SceneError on what is not JSON,
/// has a key twice in one object, or exceeds gltf_limits; std::bad_alloc, before it begins, unless there is
/// the memory that a model of it may take.
nlohmann::json read_json(std::string_view text, const std::string& file);

}  // namespace hrt
