// What a glTF file may hold. Each limit is far above any real scene and keeps a hostile file's memory
// bounded.
#pragma once

#include <cstddef>

namespace hrt::gltf_limits {

inline constexpr std::size_t json_bytes = std::size_t{64} << 20;
inline constexpr std::size_t json_values = 1'000'000;
inline constexpr std::size_t json_depth = 64;
inline constexpr std::size_t nodes = 100'000;
inline constexpr int node_depth = 256;
inline constexpr std::size_t name_bytes = 255;
inline constexpr std::size_t haptic_nodes = 1000;

}  // namespace hrt::gltf_limits
