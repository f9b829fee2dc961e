#include "scene/gltf.h"

#include <algorithm>
#include <array>
#include <new>
#include <set>
#include <vector>

#include "scene/scene_error.h"

namespace hrt {
namespace {

constexpr std::array sections{"asset", "scene", "scenes", "nodes", "extensionsRequired"};

// Prefixes of the names of required extensions that do not move nodes.
constexpr std::array harmless_extensions{"KHR_materials_",
                                         "KHR_texture_",
                                         "EXT_texture_",
                                         "MSFT_texture_dds",
                                         "KHR_draco_mesh_compression",
                                         "KHR_mesh_quantization",
                                         "KHR_meshopt_compression",
                                         "EXT_meshopt_compression",
                                         "EXT_mesh_features",
                                         "EXT_mesh_gpu_instancing",  // scene.cpp rejects it on a haptic node
                                         "EXT_structural_metadata",
                                         "KHR_animation_pointer",
                                         "KHR_node_visibility",
                                         "KHR_lights_",
                                         "EXT_lights_",
                                         "KHR_xmp"};

std::uint32_t little_endian(std::string_view four_bytes) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(four_bytes[static_cast<std::size_t>(i)]);
  return value;
}

// Makes one pass over the text before it is parsed. Checks the limits, because the parser could exhaust stack or
// memory; checks for repeated keys, of which the parser would use the last; and replaces the value of each section that
// is skipped by 0. Line ends are kept, so that the parser reports the right line numbers.
void prepare(std::string& json, const std::string& file) {
  std::vector<std::set<std::string_view>> keys;  // keys of each open object; empty for an open array
  std::string_view string;                       // the last string, which is a key if ':' follows
  std::string_view section;                      // the last key of the outermost object
  std::size_t section_begin = 0, values = 0, nodes = 0;
  bool is_skipped = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    switch (json[i]) {
      case '"': {
        const std::size_t begin = ++i;
        while (i < json.size() && json[i] != '"') i += json[i] == '\\' ? 2 : 1;
        string = std::string_view(json).substr(begin, i - begin);
        continue;
      }
      case ':':
        if (keys.empty() || is_skipped) continue;
        if (!keys.back().insert(string).second)
          refuse(file, "the JSON has the key {} twice in one object, at byte {}; remove one of the two",
                 in_quotes(string), i);
        if (keys.size() > 1) continue;
        section = string;
        section_begin = i + 1;
        is_skipped = std::find(sections.begin(), sections.end(), section) == sections.end();
        continue;
      case '{':
      case '[':
        if (keys.size() == gltf_limits::json_depth)
          refuse(file, "the JSON is nested too deeply; allowed: up to {} levels", gltf_limits::json_depth);
        if (keys.size() == 2 && section == "nodes" && ++nodes > gltf_limits::nodes)
          refuse(file, "the file has too many nodes; allowed: up to {}", gltf_limits::nodes);
        keys.emplace_back();
        break;
      case ',':
      case '}':
      case ']':
        if (keys.size() == 1 && is_skipped) {
          is_skipped = false;
          const std::size_t value = std::min(json.find_first_not_of('\n', section_begin), i);
          std::replace_if(&json[value], &json[i], [](char c) { return c != '\n'; }, ' ');
          if (value < i) json[value] = '0';
        }
        if (json[i] == ',') break;
        if (!keys.empty()) keys.pop_back();
        continue;
      default:
        continue;
    }
    if (!is_skipped && ++values > gltf_limits::json_values)
      refuse(file, "the JSON has too many values; allowed: up to {}", gltf_limits::json_values);
  }
}

// Returns the reason in an error text of the parser, without the error's name and the last read text.
std::string reason(std::string_view error) {
  const std::size_t name_end = error.find("] ");
  if (name_end != error.npos) error.remove_prefix(name_end + 2);
  error = error.substr(0, error.find("; last read"));
  if (error.ends_with('.')) error.remove_suffix(1);
  return printable(std::string(error.substr(0, error.find('\n'))));
}

}  // namespace

JsonExtent find_json(std::string_view header, std::uint64_t file_bytes, const std::string& file) {
  JsonExtent extent{.offset = 0, .size = 0};
  std::uint64_t json_bytes = file_bytes;
  if (header.starts_with("glTF")) {
    if (header.size() < glb_header_bytes) refuse(file, "the binary glTF header is incomplete; export the file again");
    const std::uint32_t version = little_endian(header.substr(4));
    const std::uint32_t claimed_bytes = little_endian(header.substr(8));
    if (version != 2) refuse(file, "the binary glTF header has version {}; allowed: 2. Export as glTF 2.0", version);
    if (claimed_bytes != file_bytes)
      refuse(file, "the binary glTF header declares {} bytes, but the file has {}; export the file again",
             claimed_bytes, file_bytes);
    if (header.substr(16) != "JSON")
      refuse(file, "the first chunk of the binary glTF is not JSON; export the file again");
    json_bytes = little_endian(header.substr(12));
    if (json_bytes > file_bytes - glb_header_bytes)
      refuse(file, "the JSON chunk declares {} bytes, but only {} remain; export the file again", json_bytes,
             file_bytes - glb_header_bytes);
    extent.offset = glb_header_bytes;
  }
  if (json_bytes > gltf_limits::json_bytes)
    refuse(file, "the JSON is too large; allowed: up to {} bytes", gltf_limits::json_bytes);
  extent.size = static_cast<std::size_t>(json_bytes);
  return extent;
}

tinygltf::Model parse_gltf(std::string json, const std::string& file) {
  prepare(json, file);
  tinygltf::Model model;
  std::string error, warning;
  if (!tinygltf::TinyGLTF().LoadASCIIFromString(&model, &error, &warning, json.c_str(),
                                                static_cast<unsigned>(json.size()), "", tinygltf::REQUIRE_VERSION)) {
    if (error == std::bad_alloc().what()) throw std::bad_alloc();
    refuse(file, "this is not a glTF file: {}; correct it, or export it again", reason(error));
  }
  if (!model.asset.version.starts_with("2."))
    refuse(file, "asset.version is {}; allowed: 2.x. Export as glTF 2.0", in_quotes(model.asset.version));
  if (!model.asset.minVersion.empty() && model.asset.minVersion != "2.0")
    refuse(file, "asset.minVersion is {}; allowed: 2.0. Export as glTF 2.0", in_quotes(model.asset.minVersion));
  for (const std::string& name : model.extensionsRequired) {
    if (std::none_of(harmless_extensions.begin(), harmless_extensions.end(),
                     [&](const char* prefix) { return name.starts_with(prefix); }))
      refuse(file, "extensionsRequired has {}, which is not supported because it may move nodes; export without it",
             in_quotes(name));
  }
  return model;
}

}  // namespace hrt
