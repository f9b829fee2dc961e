#include "scene/gltf_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "scene/gltf_limits.h"
#include "scene/refuse.h"

namespace hrt {
namespace {

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

std::uint32_t little_endian(std::string_view four_bytes) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i)
    value = value << 8 | static_cast<unsigned char>(four_bytes[static_cast<std::size_t>(i)]);
  return value;
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& file)
      : file_(file), gltf_{.json = JsonDocument(text, file), .nodes = {}, .roots = {}} {}

  Gltf run() {
    const JsonValue document = gltf_.json.root();
    if (!document.is_object()) refuse(file_, "not a glTF file: its JSON is not an object");
    check_version(document.find("asset"));
    check_required_extensions(document.find("extensionsRequired"));
    check_addresses(document, "buffers");
    check_addresses(document, "images");
    read_nodes(document);
    read_scenes(document);
    return std::move(gltf_);
  }

 private:
  // An array of objects, or nothing; anything else is refused.
  JsonValue objects(JsonValue document, const char* section) const {
    const JsonValue found = document.find(section);
    const bool all_objects =
        std::all_of(found.begin(), found.end(), [](JsonValue o) { return o.is_object(); });
    if (found.exists() && !(found.is_array() && all_objects))
      refuse(file_, "{} is not an array of objects", section);
    return found;
  }

  void check_version(JsonValue asset) const {
    const JsonValue version = asset.find("version");
    if (!version.is_string()) refuse(file_, "not a glTF file: asset.version is missing");
    if (!version.string().starts_with("2."))
      refuse(file_, "asset.version is {}; glTF 2 is read", in_quotes(version.string()));
  }

  void check_required_extensions(JsonValue required) const {
    if (required.exists() && !required.is_array()) refuse(file_, "extensionsRequired is not an array");
    for (const JsonValue entry : required) {
      if (!entry.is_string()) refuse(file_, "extensionsRequired holds something that is not a string");
      const std::string_view name = entry.string();
      const bool is_harmless = std::any_of(harmless_prefixes.begin(), harmless_prefixes.end(),
                                           [&](const char* prefix) { return name.starts_with(prefix); });
      if (!is_harmless) {
        refuse(file_, "extensionsRequired names {}, which may move nodes and is not understood here",
               in_quotes(name));
      }
    }
  }

  void check_addresses(JsonValue document, const char* section) const {
    std::size_t i = 0;
    for (const JsonValue object : objects(document, section)) {
      const std::string where = fmt::format("{}[{}].uri", section, i++);
      const JsonValue uri = object.find("uri");
      if (uri.exists() && !uri.is_string()) refuse(file_, "{} is not a string", where);
      if (const char* reason = uri.exists() ? why_uri_is_refused(uri.string()) : nullptr)
        refuse(file_, "{} is {}, which {}", where, in_quotes(uri.string()), reason);
    }
  }

  std::string node_label(std::size_t index) const {
    const std::string_view name = gltf_.nodes[index].name;
    return fmt::format("node {}", name.empty() ? fmt::format("[{}]", index) : in_quotes(name));
  }

  // Each is an integer in [0, number of nodes).
  std::vector<std::size_t> node_indices(JsonValue indices, const std::string& where) const {
    if (!indices.is_array()) refuse(file_, "{} is not an array", where);
    std::vector<std::size_t> result;
    result.reserve(indices.size());
    for (const JsonValue index : indices) {
      if (!index.is_whole())
        refuse(file_, "{} holds {}, which is not an index", where, in_quotes(index.shown()));
      if (!(index.number() < static_cast<double>(gltf_.nodes.size())))
        refuse(file_, "{} holds {}, and there are {} nodes", where, index.shown(), gltf_.nodes.size());
      result.push_back(static_cast<std::size_t>(index.number()));
    }
    return result;
  }

  // True if the member is there.
  template <std::size_t count>
  bool read_numbers(JsonValue node, const char* key, const std::string& where,
                    std::array<double, count>* out) const {
    const JsonValue found = node.find(key);
    if (!found.exists()) return false;
    if (!found.is_array() || found.size() != count ||
        !std::all_of(found.begin(), found.end(), [](JsonValue number) { return number.is_number(); }))
      refuse(file_, "{}: {} is not an array of {} numbers", where, key, count);
    std::transform(found.begin(), found.end(), out->begin(),
                   [](JsonValue number) { return number.number(); });
    return true;
  }

  void read_transform(JsonValue json, const std::string& where, GltfNode* node) const {
    std::array<double, 16> m{};  // column by column
    std::array<double, 3> translation{}, scale{1.0, 1.0, 1.0};
    std::array<double, 4> rotation{};
    node->has_matrix = read_numbers(json, "matrix", where, &m);
    const bool has_translation = read_numbers(json, "translation", where, &translation);
    const bool has_rotation = read_numbers(json, "rotation", where, &rotation);
    const bool has_scale = read_numbers(json, "scale", where, &scale);
    if (node->has_matrix) {
      if (has_translation || has_rotation || has_scale) {
        refuse(file_, "{}: matrix is given beside translation, rotation or scale; glTF allows one form",
               where);
      }
      if (m[3] != 0.0 || m[7] != 0.0 || m[11] != 0.0 || m[15] != 1.0)
        refuse(file_, "{}: matrix has a fourth row other than 0 0 0 1", where);
      node->local = {{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}, {m[12], m[13], m[14]}};
      return;
    }
    Axes axes;
    if (has_rotation) {
      const auto [x, y, z, w] = rotation;
      const double squared_norm = x * x + y * y + z * z + w * w;
      if (!(std::abs(squared_norm - 1.0) < 2e-3))
        refuse(file_, "{}: rotation is not a quaternion of unit length", where);
      const double to_unit = 1.0 / std::sqrt(squared_norm);
      axes = axes_of({x * to_unit, y * to_unit, z * to_unit, w * to_unit});
    }
    node->local = {{axes.x * scale[0], axes.y * scale[1], axes.z * scale[2]},
                   {translation[0], translation[1], translation[2]}};
  }

  void read_nodes(JsonValue document) {
    const JsonValue nodes = objects(document, "nodes");
    if (nodes.size() > gltf_limits::nodes) refuse(file_, "has more than {} nodes", gltf_limits::nodes);
    gltf_.nodes.reserve(nodes.size());
    for (const JsonValue node : nodes) {
      gltf_.nodes.push_back(
          {.name = node.find("name").string(), .extras = node.find("extras"), .local = {}, .children = {}});
    }
    parent_of_.assign(nodes.size(), no_parent);
    std::size_t i = 0;
    for (const JsonValue node : nodes) read_node(node, i++);
    check_for_cycles();
  }

  void read_node(JsonValue json, std::size_t i) {
    GltfNode& node = gltf_.nodes[i];
    const std::string where = node_label(i);
    const JsonValue name = json.find("name");
    if (name.exists() && !(name.is_string() && node.name.size() <= gltf_limits::name_bytes))
      refuse(file_, "{}: name is not a string of at most {} bytes", where, gltf_limits::name_bytes);
    read_transform(json, where, &node);
    const JsonValue children = json.find("children");
    if (!children.exists()) return;
    node.children = node_indices(children, where + ": children");
    for (const std::size_t child : node.children) {
      std::size_t& parent = parent_of_[child];
      if (parent != no_parent) {
        refuse(file_, "{}: children of both {} and {} name it; a node has one parent", node_label(child),
               node_label(parent), where);
      }
      parent = i;
    }
  }

  // Every node has at most one parent, so a node not reached from a root is on a cycle or below one.
  void check_for_cycles() const {
    std::vector<std::size_t> reached;
    for (std::size_t i = 0; i < parent_of_.size(); ++i)
      if (parent_of_[i] == no_parent) reached.push_back(i);
    std::vector<bool> is_reached(parent_of_.size(), false);
    for (std::size_t next = 0; next < reached.size(); ++next) {
      is_reached[reached[next]] = true;
      for (const std::size_t child : gltf_.nodes[reached[next]].children) reached.push_back(child);
    }
    const auto missed = std::find(is_reached.begin(), is_reached.end(), false);
    if (missed != is_reached.end()) {
      refuse(file_, "{}: children of the nodes below it lead back to it: a cycle",
             node_label(static_cast<std::size_t>(missed - is_reached.begin())));
    }
  }

  void read_scenes(JsonValue document) {
    const JsonValue scenes = objects(document, "scenes");
    const JsonValue scene = document.find("scene");
    if (scene.exists() && !(scene.is_whole() && scene.number() < static_cast<double>(scenes.size())))
      refuse(file_, "scene is {}, and there are {} scenes", in_quotes(scene.shown()), scenes.size());
    std::size_t i = 0;
    for (const JsonValue json : scenes) {
      std::vector<std::size_t> roots = roots_of(json, fmt::format("scenes[{}].nodes", i));
      if (static_cast<double>(i++) == scene.number())  // 0 unless it is given
        gltf_.roots = std::move(roots);
    }
    if (!scene.exists() && scenes.size() != 1)
      refuse(file_, "has {} scenes and no default: `scene` must name one", scenes.size());
  }

  std::vector<std::size_t> roots_of(JsonValue scene, const std::string& where) const {
    const JsonValue nodes = scene.find("nodes");
    if (!nodes.exists()) return {};
    std::vector<std::size_t> roots = node_indices(nodes, where);
    std::vector<bool> is_root(parent_of_.size(), false);
    for (const std::size_t root : roots) {
      if (parent_of_[root] != no_parent)
        refuse(file_, "{} holds {}, which is not a root but the child of another node", where, root);
      if (is_root[root]) refuse(file_, "{} holds {} twice", where, root);
      is_root[root] = true;
    }
    return roots;
  }

  // Why an address is not that of a file beside this one; null if it may be.
  static const char* why_uri_is_refused(std::string_view uri);

  static constexpr std::size_t no_parent = static_cast<std::size_t>(-1);
  const std::string& file_;
  Gltf gltf_;
  std::vector<std::size_t> parent_of_;
};

std::string percent_decoded(std::string_view uri) {
  std::string result;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const std::string_view digits = uri.substr(i + 1, 2);
    if (uri[i] == '%' && digits.size() == 2 &&
        digits.find_first_not_of("0123456789abcdefABCDEF") == digits.npos) {
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
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? c - 32 : c; });
  while (name.ends_with(' ')) name.pop_back();
  if (name.size() == 4 && (name.starts_with("COM") || name.starts_with("LPT")))
    return name[3] >= '0' && name[3] <= '9';
  return name == "CON" || name == "PRN" || name == "AUX" || name == "NUL" || name == "CONIN$" ||
         name == "CONOUT$";
}

const char* Reader::why_uri_is_refused(std::string_view uri) {
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

}  // namespace

JsonExtent json_extent(std::string_view head, std::uint64_t file_bytes, const std::string& file) {
  const bool is_binary = head.starts_with("glTF");
  JsonExtent extent{.offset = 0, .size = 0};
  std::uint64_t json_bytes = file_bytes;
  if (is_binary) {
    if (head.size() < glb_head_bytes) refuse(file, "the binary glTF header is cut short");
    const std::uint32_t version = little_endian(head.substr(4));
    const std::uint32_t claimed_bytes = little_endian(head.substr(8));
    if (version != 2) refuse(file, "the binary glTF header has version {}; glTF 2 is read", version);
    if (claimed_bytes != file_bytes)
      refuse(file, "the binary glTF header claims {} bytes, and there are {}", claimed_bytes, file_bytes);
    if (head.substr(16) != "JSON") refuse(file, "the first chunk of a binary glTF must be JSON");
    json_bytes = little_endian(head.substr(12));
    if (json_bytes > file_bytes - glb_head_bytes) {
      refuse(file, "the JSON chunk claims {} bytes, and {} are left", json_bytes,
             file_bytes - glb_head_bytes);
    }
    extent.offset = glb_head_bytes;
  }
  if (json_bytes > gltf_limits::json_bytes)
    refuse(file, "its JSON is larger than {} bytes", gltf_limits::json_bytes);
  extent.size = static_cast<std::size_t>(json_bytes);
  return extent;
}

Gltf read_gltf(std::string_view json, const std::string& file) {
  return Reader(json, file).run();
}

}  // namespace hrt
