#include "scene/gltf_shape.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "scene/gltf_json.h"
#include "scene/scene_error.h"

namespace hrt {
namespace {

using nlohmann::json;

// Required extensions that leave every node where it is; their content is ignored.
constexpr std::array harmless_prefixes{"KHR_materials_",
                                       "KHR_texture_",
                                       "EXT_texture_",
                                       "KHR_draco_mesh_compression",
                                       "KHR_mesh_quantization",
                                       "EXT_meshopt_compression",
                                       "KHR_lights_",
                                       "EXT_lights_",
                                       "KHR_xmp"};

std::string percent_decoded(std::string_view uri) {
  std::string result;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const std::string_view digits = uri.substr(i + 1, 2);
    if (uri[i] == '%' && digits.size() == 2 && digits.find_first_not_of("0123456789abcdefABCDEF") == digits.npos) {
      result += static_cast<char>(std::stoi(std::string(digits), nullptr, 16));
      i += 2;
    } else {
      result += uri[i];
    }
  }
  return result;
}

// Names of devices on Windows, with any extension.
bool is_device(std::string name) {
  name = name.substr(0, name.find('.'));
  std::transform(name.begin(), name.end(), name.begin(), [](char c) { return c >= 'a' && c <= 'z' ? c - 32 : c; });
  while (name.ends_with(' ')) name.pop_back();
  if (name.size() == 4 && (name.starts_with("COM") || name.starts_with("LPT"))) return name[3] >= '0' && name[3] <= '9';
  return name == "CON" || name == "PRN" || name == "AUX" || name == "NUL" || name == "CONIN$" || name == "CONOUT$";
}

// Why an address is not that of a file beside this one; null if it may be.
const char* why_uri_is_refused(std::string_view uri) {
  if (uri.starts_with("data:")) return nullptr;
  std::string path = percent_decoded(uri);
  std::replace(path.begin(), path.end(), '\\', '/');
  if (path.empty() || path.find('\0') != path.npos) return "is not a file name";
  if (path.find(':') != path.npos) return "is an address or a drive, not a file beside this one";
  if (path.front() == '/') return "is an absolute path";
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    const std::string segment = path.substr(begin, end - begin);
    if (segment == "..") return "climbs out of the file's folder";
    if (is_device(segment)) return "names a device";
    begin = end + 1;
  }
  return nullptr;
}

// A member; null if there is none.
const json* find(const json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

// For messages: as written, or what it is.
std::string shown(const json& value) {
  if (value.is_array()) return "an array";
  if (value.is_object()) return "an object";
  if (value.is_boolean()) return "a boolean";
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

class Check {
 public:
  Check(const json& document, const std::string& file) : document_(document), file_(file) {}

  void run() {
    if (!document_.is_object()) refuse(file_, "not a glTF file: its JSON is not an object");
    check_version();
    check_required_extensions();
    check_addresses("buffers");
    check_addresses("images");
    node_count_ = objects("nodes").size();
    if (node_count_ > gltf_limits::nodes) refuse(file_, "has more than {} nodes", gltf_limits::nodes);
    std::size_t i = 0;
    for (const json& node : objects("nodes")) check_node(node, i++);
    check_scenes();
  }

 private:
  // An array of objects, or nothing; anything else is refused.
  const json& objects(const char* section) const {
    static const json none;  // null, without elements: an array would hold memory for good
    const json* found = find(document_, section);
    if (!found) return none;
    if (!found->is_array() ||
        !std::all_of(found->begin(), found->end(), [](const json& each) { return each.is_object(); }))
      refuse(file_, "{} is not an array of objects", section);
    return *found;
  }

  void check_version() const {
    const json* asset = find(document_, "asset");
    const json* version = asset && asset->is_object() ? find(*asset, "version") : nullptr;
    if (!version || !version->is_string()) refuse(file_, "not a glTF file: asset.version is missing");
    const auto& text = version->get_ref<const std::string&>();
    if (!text.starts_with("2.")) refuse(file_, "asset.version is {}; glTF 2 is read", in_quotes(text));
    const json* needed = find(*asset, "minVersion");
    if (needed && *needed != "2.0") refuse(file_, "asset.minVersion is {}; glTF 2.0 is read", needed->dump());
  }

  void check_required_extensions() const {
    const json* required = find(document_, "extensionsRequired");
    if (!required) return;
    if (!required->is_array()) refuse(file_, "extensionsRequired is not an array");
    for (const json& entry : *required) {
      if (!entry.is_string()) refuse(file_, "extensionsRequired holds something that is not a string");
      const auto& name = entry.get_ref<const std::string&>();
      const bool is_harmless = std::any_of(harmless_prefixes.begin(), harmless_prefixes.end(),
                                           [&](const char* prefix) { return name.starts_with(prefix); });
      if (!is_harmless) {
        refuse(file_, "extensionsRequired names {}, which may move nodes and is not understood here", in_quotes(name));
      }
    }
  }

  void check_addresses(const char* section) const {
    std::size_t i = 0;
    for (const json& object : objects(section)) {
      const std::string where = fmt::format("{}[{}].uri", section, i++);
      const json* uri = find(object, "uri");
      if (!uri) continue;
      if (!uri->is_string()) refuse(file_, "{} is not a string", where);
      const auto& text = uri->get_ref<const std::string&>();
      if (const char* reason = why_uri_is_refused(text))
        refuse(file_, "{} is {}, which {}", where, in_quotes(text), reason);
    }
  }

  // Each is an integer in [0, number of nodes).
  void check_indices(const json* indices, const std::string& where) const {
    if (!indices) return;
    if (!indices->is_array()) refuse(file_, "{} is not an array", where);
    for (const json& index : *indices) {
      if (!index.is_number_unsigned())
        refuse(file_, "{} holds {}, which is not an index", where, in_quotes(shown(index)));
      if (index.get<std::uint64_t>() >= node_count_)
        refuse(file_, "{} holds {}, and there are {} nodes", where, shown(index), node_count_);
    }
  }

  void check_numbers(const json& node, const char* key, std::size_t count, const std::string& where) const {
    const json* found = find(node, key);
    if (found && (!found->is_array() || found->size() != count ||
                  !std::all_of(found->begin(), found->end(), [](const json& each) { return each.is_number(); })))
      refuse(file_, "{}: {} is not an array of {} numbers", where, key, count);
  }

  void check_node(const json& node, std::size_t i) const {
    const json* name = find(node, "name");
    const bool has_text = name && name->is_string();
    const std::string where = node_label(has_text ? name->get_ref<const std::string&>() : "", i);
    if (name && !(has_text && name->get_ref<const std::string&>().size() <= gltf_limits::name_bytes))
      refuse(file_, "{}: name is not a string of at most {} bytes", where, gltf_limits::name_bytes);
    check_numbers(node, "matrix", 16, where);
    check_numbers(node, "translation", 3, where);
    check_numbers(node, "rotation", 4, where);
    check_numbers(node, "scale", 3, where);
    if (node.contains("matrix") &&
        (node.contains("translation") || node.contains("rotation") || node.contains("scale")))
      refuse(file_, "{}: matrix is given beside translation, rotation or scale; glTF allows one form", where);
    check_indices(find(node, "children"), where + ": children");
  }

  void check_scenes() const {
    const json& scenes = objects("scenes");
    const json* scene = find(document_, "scene");
    if (scene && !(scene->is_number_unsigned() && scene->get<std::uint64_t>() < scenes.size()))
      refuse(file_, "scene is {}, and there are {} scenes", in_quotes(shown(*scene)), scenes.size());
    std::size_t i = 0;
    for (const json& each : scenes) check_indices(find(each, "nodes"), fmt::format("scenes[{}].nodes", i++));
    if (!scene && scenes.size() != 1)
      refuse(file_, "has {} scenes and no default: `scene` must name one", scenes.size());
  }

  const json& document_;
  const std::string& file_;
  std::size_t node_count_ = 0;
};

}  // namespace

std::string node_label(std::string_view name, std::size_t index) {
  return fmt::format("node {}", name.empty() ? fmt::format("[{}]", index) : in_quotes(name));
}

void check_shape(const json& document, const std::string& file) { Check(document, file).run(); }

}  // namespace hrt
