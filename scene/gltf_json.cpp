#include "scene/gltf_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "scene/gltf_tree.h"
#include "scene/scene_error.h"

namespace hrt {
namespace {

using nlohmann::json;

constexpr std::array needed_sections{"asset", "extensionsRequired", "extensionsUsed", "nodes", "scene",
                                     "scenes"};

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
  for (int i = 3; i >= 0; --i) {
    value = value << 8 | static_cast<unsigned char>(four_bytes[static_cast<std::size_t>(i)]);
  }
  return value;
}

// Reads JSON without keeping any of it, and refuses what is not JSON or would take too much memory or stack
// once kept. (A callback given to json::parse() could do the same, in time quadratic in the length of
// arrays.)
class LimitCheck : public nlohmann::json_sax<json> {
 public:
  explicit LimitCheck(const std::string& file) : file_(file) {}

  void run(std::string_view text) { json::sax_parse(text, this); }

  bool null() override { return count(); }
  bool boolean(bool) override { return count(); }
  bool number_integer(number_integer_t) override { return count(); }
  bool number_unsigned(number_unsigned_t) override { return count(); }
  bool number_float(number_float_t, const string_t&) override { return count(); }
  bool string(string_t&) override { return count(); }
  bool binary(binary_t&) override { return count(); }
  bool key(string_t&) override { return true; }
  bool start_object(std::size_t) override { return descend(); }
  bool end_object() override { return ascend(); }
  bool start_array(std::size_t) override { return descend(); }
  bool end_array() override { return ascend(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) override {
    throw SceneError(file_ + ": not a glTF file: " + error.what());
  }

 private:
  bool count() {
    if (++values_ > gltf_limits::json_values) {
      throw SceneError(file_ + ": its JSON has more than " + std::to_string(gltf_limits::json_values) +
                       " values");
    }
    return true;
  }
  bool descend() {
    if (++depth_ > gltf_limits::json_depth) {
      throw SceneError(file_ + ": its JSON is nested deeper than " + std::to_string(gltf_limits::json_depth) +
                       " levels");
    }
    return count();
  }
  bool ascend() {
    --depth_;
    return true;
  }

  const std::string& file_;
  std::size_t values_ = 0;
  int depth_ = 0;
};

class Checker {
 public:
  explicit Checker(const std::string& file) : file_(file) {}

  std::string run(std::string_view text) {
    LimitCheck(file_).run(text);
    const json document = json::parse(text);
    if (!document.is_object()) {
      fail("not a glTF file: its JSON is not an object");
    }
    check_version(document);
    check_required_extensions(document);
    check_buffers(document);
    check_nodes(document);
    check_scenes(document);
    json needed;
    for (const char* section : needed_sections) {
      if (const auto found = document.find(section); found != document.end()) {
        needed[section] = *found;
      }
    }
    return needed.dump();
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw SceneError(file_ + ": " + what); }

  // An array of objects, or nothing; anything else is refused.
  const json& objects(const json& document, const char* section) const {
    const auto found = document.find(section);
    if (found == document.end()) {
      return none_;
    }
    if (!found->is_array() ||
        !std::all_of(found->begin(), found->end(), [](const json& o) { return o.is_object(); })) {
      fail(std::string(section) + " is not an array of objects");
    }
    return *found;
  }

  void check_version(const json& document) const {
    const auto asset = document.find("asset");
    if (asset == document.end() || !asset->is_object() || !asset->contains("version") ||
        !(*asset)["version"].is_string()) {
      fail("not a glTF file: asset.version is missing");
    }
    const auto& version = (*asset)["version"].get_ref<const std::string&>();
    if (!version.starts_with("2.")) {
      fail("asset.version is " + in_quotes(version) + "; glTF 2 is read");
    }
  }

  void check_required_extensions(const json& document) const {
    const auto required = document.find("extensionsRequired");
    if (required == document.end()) {
      return;
    }
    if (!required->is_array()) {
      fail("extensionsRequired is not an array");
    }
    for (const json& entry : *required) {
      if (!entry.is_string()) {
        fail("extensionsRequired holds something that is not a string");
      }
      const auto& name = entry.get_ref<const std::string&>();
      const bool is_harmless = std::any_of(harmless_prefixes.begin(), harmless_prefixes.end(),
                                           [&](const char* prefix) { return name.starts_with(prefix); });
      if (!is_harmless) {
        fail("extensionsRequired names " + in_quotes(name) +
             ", which may move nodes and is not understood here");
      }
    }
  }

  void check_buffers(const json& document) const {
    const json& buffers = objects(document, "buffers");
    for (std::size_t i = 0; i < buffers.size(); ++i) {
      const auto uri = buffers[i].find("uri");
      if (uri == buffers[i].end()) {
        continue;
      }
      const std::string where = "buffers[" + std::to_string(i) + "].uri ";
      if (!uri->is_string()) {
        fail(where + "is not a string");
      }
      const auto& text = uri->get_ref<const std::string&>();
      if (const char* reason = why_uri_is_refused(text)) {
        fail(where + "is " + in_quotes(text) + ", which " + reason);
      }
    }
  }

  std::string node_label(const json& nodes, std::size_t index) const {
    const auto name = nodes[index].find("name");
    return "node " +
           (name != nodes[index].end() && name->is_string() && !name->get_ref<const std::string&>().empty()
                ? in_quotes(name->get_ref<const std::string&>())
                : "[" + std::to_string(index) + "]");
  }

  // Each is an integer in [0, count).
  void check_indices(const json& indices, std::size_t count, const std::string& where) const {
    if (!indices.is_array()) {
      fail(where + " is not an array");
    }
    for (const json& index : indices) {
      if (!index.is_number_unsigned()) {
        fail(where + " holds " + in_quotes(index.dump()) + ", which is not an index");
      }
      if (index.get<std::uint64_t>() >= count) {
        fail(where + " holds " + index.dump() + ", and there are " + std::to_string(count) + " nodes");
      }
    }
  }

  void check_numbers(const json& node, const char* key, std::size_t count, const std::string& where) const {
    const auto found = node.find(key);
    if (found == node.end()) {
      return;
    }
    if (!found->is_array() || found->size() != count ||
        !std::all_of(found->begin(), found->end(), [](const json& number) { return number.is_number(); })) {
      fail(where + key + " is not an array of " + std::to_string(count) + " numbers");
    }
  }

  void check_transform(const json& node, const std::string& where) const {
    check_numbers(node, "matrix", 16, where);
    check_numbers(node, "translation", 3, where);
    check_numbers(node, "rotation", 4, where);
    check_numbers(node, "scale", 3, where);
    if (const auto matrix = node.find("matrix"); matrix != node.end()) {
      if (node.contains("translation") || node.contains("rotation") || node.contains("scale")) {
        fail(where + "matrix is given beside translation, rotation or scale; glTF allows one form");
      }
      const json& m = *matrix;
      if (m[3] != 0.0 || m[7] != 0.0 || m[11] != 0.0 || m[15] != 1.0) {
        fail(where + "matrix has a fourth row other than 0 0 0 1");
      }
    }
    if (const auto rotation = node.find("rotation"); rotation != node.end()) {
      double squared_norm = 0.0;
      for (const json& component : *rotation) {
        squared_norm += component.get<double>() * component.get<double>();
      }
      if (!(std::abs(squared_norm - 1.0) < 2e-3)) {
        fail(where + "rotation is not a quaternion of unit length");
      }
    }
  }

  void check_nodes(const json& document) {
    const json& nodes = objects(document, "nodes");
    if (nodes.size() > gltf_limits::nodes) {
      fail("has more than " + std::to_string(gltf_limits::nodes) + " nodes");
    }
    parent_of_.assign(nodes.size(), no_parent);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const json& node = nodes[i];
      const std::string where = node_label(nodes, i) + ": ";
      if (const auto name = node.find("name"); name != node.end()) {
        if (!name->is_string() || name->get_ref<const std::string&>().size() > gltf_limits::name_bytes) {
          fail(where + "name is not a string of at most " + std::to_string(gltf_limits::name_bytes) +
               " bytes");
        }
      }
      check_transform(node, where);
      const auto children = node.find("children");
      if (children == node.end()) {
        continue;
      }
      check_indices(*children, nodes.size(), where + "children");
      for (const json& child : *children) {
        std::size_t& parent = parent_of_[child.get<std::size_t>()];
        if (parent != no_parent) {
          fail(node_label(nodes, child.get<std::size_t>()) + ": children of both " +
               node_label(nodes, parent) + " and " + node_label(nodes, i) +
               " name it; a node has one parent");
        }
        parent = i;
      }
    }
    check_for_cycles(nodes);
  }

  // Every node has at most one parent, so a node not reached from a root is on a cycle or below one.
  void check_for_cycles(const json& nodes) const {
    std::vector<std::size_t> reached;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (parent_of_[i] == no_parent) {
        reached.push_back(i);
      }
    }
    std::vector<bool> is_reached(nodes.size(), false);
    for (std::size_t next = 0; next < reached.size(); ++next) {
      is_reached[reached[next]] = true;
      if (const auto children = nodes[reached[next]].find("children");
          children != nodes[reached[next]].end()) {
        for (const json& child : *children) {
          reached.push_back(child.get<std::size_t>());
        }
      }
    }
    const auto missed = std::find(is_reached.begin(), is_reached.end(), false);
    if (missed != is_reached.end()) {
      fail(node_label(nodes, static_cast<std::size_t>(missed - is_reached.begin())) +
           ": children of the nodes below it lead back to it: a cycle");
    }
  }

  void check_scenes(const json& document) const {
    const json& scenes = objects(document, "scenes");
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const auto roots = scenes[i].find("nodes");
      if (roots == scenes[i].end()) {
        continue;
      }
      const std::string where = "scenes[" + std::to_string(i) + "].nodes";
      check_indices(*roots, parent_of_.size(), where);
      std::vector<bool> is_root(parent_of_.size(), false);
      for (const json& root : *roots) {
        const auto node = root.get<std::size_t>();
        if (parent_of_[node] != no_parent) {
          fail(where + " holds " + std::to_string(node) +
               ", which is not a root but the child of another node");
        }
        if (is_root[node]) {
          fail(where + " holds " + std::to_string(node) + " twice");
        }
        is_root[node] = true;
      }
    }
    const auto scene = document.find("scene");
    if (scene != document.end() &&
        (!scene->is_number_unsigned() || scene->get<std::uint64_t>() >= scenes.size())) {
      fail("scene is " + in_quotes(scene->dump()) + ", and there are " + std::to_string(scenes.size()) +
           " scenes");
    }
  }

  // Why an address is not that of a file beside this one; null if it may be.
  static const char* why_uri_is_refused(const std::string& uri);

  static constexpr std::size_t no_parent = static_cast<std::size_t>(-1);
  const std::string& file_;
  const json none_ = json::array();  // not static: memory goes back to the plugin's host with the loader
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
  while (name.ends_with(' ')) {
    name.pop_back();
  }
  if (name.size() == 4 && (name.starts_with("COM") || name.starts_with("LPT"))) {
    return name[3] >= '0' && name[3] <= '9';
  }
  return name == "CON" || name == "PRN" || name == "AUX" || name == "NUL" || name == "CONIN$" ||
         name == "CONOUT$";
}

const char* Checker::why_uri_is_refused(const std::string& uri) {
  if (uri.starts_with("data:")) {
    return nullptr;
  }
  std::string path = percent_decoded(uri);
  std::replace(path.begin(), path.end(), '\\', '/');
  if (path.empty() || path.find('\0') != path.npos) {
    return "is not a file name";
  }
  if (path.find(':') != path.npos) {
    return "is an address or a drive, not a file beside this one";
  }
  if (path.front() == '/') {
    return "is an absolute path";
  }
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    const std::string segment = path.substr(begin, end - begin);
    if (segment == "..") {
      return "climbs out of the file's folder";
    }
    if (is_device(segment)) {
      return "names a device";
    }
    begin = end + 1;
  }
  return nullptr;
}

}  // namespace

JsonExtent json_extent(std::string_view head, std::uint64_t file_bytes, const std::string& file) {
  const auto fail = [&](const std::string& what) { throw SceneError(file + ": " + what); };
  const bool is_binary = head.starts_with("glTF");
  JsonExtent extent{.offset = 0, .size = 0};
  std::uint64_t json_bytes = file_bytes;
  if (is_binary) {
    if (head.size() < glb_head_bytes) {
      fail("the binary glTF header is cut short");
    }
    const std::uint32_t version = little_endian(head.substr(4));
    const std::uint32_t claimed_bytes = little_endian(head.substr(8));
    if (version != 2) {
      fail("the binary glTF header has version " + std::to_string(version) + "; glTF 2 is read");
    }
    if (claimed_bytes != file_bytes) {
      fail("the binary glTF header claims " + std::to_string(claimed_bytes) + " bytes, and there are " +
           std::to_string(file_bytes));
    }
    if (head.substr(16) != "JSON") {
      fail("the first chunk of a binary glTF must be JSON");
    }
    json_bytes = little_endian(head.substr(12));
    if (json_bytes > file_bytes - glb_head_bytes) {
      fail("the JSON chunk claims " + std::to_string(json_bytes) + " bytes, and " +
           std::to_string(file_bytes - glb_head_bytes) + " are left");
    }
    extent.offset = glb_head_bytes;
  }
  if (json_bytes > gltf_limits::json_bytes) {
    fail("its JSON is larger than " + std::to_string(gltf_limits::json_bytes) + " bytes");
  }
  extent.size = static_cast<std::size_t>(json_bytes);
  return extent;
}

std::string checked_gltf_json(std::string_view json, const std::string& file) {
  return Checker(file).run(json);
}

}  // namespace hrt
