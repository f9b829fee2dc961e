// Whether the JSON of a glTF 2.0 file has the shape of one, as far as a scene needs it. tinygltf takes what
// has not for absent.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace hrt {

/// Throws SceneError on a version that is not read, a required extension that may move nodes, an address that
/// leaves the file's folder, and on what has not its type, size or range.
void check_shape(const nlohmann::json& document, const std::string& file);

/// A node in messages: its name, or its index if it has none.
std::string node_label(std::string_view name, std::size_t index);

}  // namespace hrt
