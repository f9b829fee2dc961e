// glTF files in memory, for tests of the scene loader.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

#include "scene/scene.h"

namespace hrt {

/// JSON whose members keep their order; nlohmann's default type sorts them.
using Json = nlohmann::ordered_json;

inline Json haptic(const char* role, Json more = Json::object()) {
  more["role"] = role;
  return {{"haptic", std::move(more)}};
}

inline Json node(const char* name, Json extras, Json more = Json::object()) {
  more["name"] = name;
  if (!extras.empty()) more["extras"] = std::move(extras);
  return more;
}

/// Returns a file with one scene, whose roots are the nodes that are not children of another node.
inline Json document(Json nodes) {
  std::set<Json> children;
  for (const Json& parent : nodes)
    for (const Json& child : parent.value("children", Json::array())) children.insert(child);
  Json roots = Json::array();
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (!children.contains(i)) roots.push_back(i);
  return {{"asset", {{"version", "2.0"}}},
          {"scene", 0},
          {"scenes", Json::array({{{"nodes", std::move(roots)}}})},
          {"nodes", std::move(nodes)}};
}

inline Json plate(Json more = Json::object()) {
  return node("Plate", haptic("plate", {{"radius_m", 0.075}}), std::move(more));
}

/// Returns a real target, by default 100 mm straight ahead of the default start.
inline Json real(Json more = {{"translation", {0.0, 0.0, -0.05}}}) {
  return node("Real", haptic("real"), std::move(more));
}

/// Returns a virtual target 100 mm to the left of the default start.
inline Json virtual_on_the_left() { return node("Left", haptic("virtual"), {{"translation", {-0.1, 0.0, 0.05}}}); }

inline Scene load(const std::string& bytes, const char* name = "test.gltf") { return load_scene(bytes, name); }
inline Scene load(const Json& document) { return load(document.dump()); }

/// Loads a file and returns the error text; empty if the file is accepted.
inline std::string refusal(const std::string& bytes) {
  try {
    load(bytes);
    return "";
  } catch (const SceneError& error) {
    return error.what();
  }
}
inline std::string refusal(const Json& document) { return refusal(document.dump()); }

inline std::string little_endian(std::size_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
  return bytes;
}

/// Converts a file to binary glTF. `data`: the binary chunk, of a multiple of 4 bytes; empty: no chunk.
inline std::string glb(const Json& document, const std::string& data = "") {
  std::string json = document.dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string chunks = little_endian(json.size()) + "JSON" + json;
  if (!data.empty()) chunks += little_endian(data.size()) + std::string("BIN\0", 4) + data;
  return "glTF" + little_endian(2) + little_endian(12 + chunks.size()) + chunks;
}

}  // namespace hrt
