#include "scene/gltf_tree.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "scene/gltf_json.h"
#include "scene/scene_error.h"

namespace hrt {
namespace {

// An affine map: the images of the axes and of the origin.
struct Transform {
  Axes axes;
  Vec3 origin;
};

Transform operator*(const Transform& a, const Transform& b) {
  return {a.axes * b.axes, a.axes * b.origin + a.origin};
}

Transform local_transform(const tinygltf::Node& node) {
  if (!node.matrix.empty()) {
    const std::vector<double>& m = node.matrix;  // column by column
    return {{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}, {m[12], m[13], m[14]}};
  }
  Transform result;
  if (!node.rotation.empty()) {
    Quaternion q{node.rotation[0], node.rotation[1], node.rotation[2], node.rotation[3]};
    const double scale = 1.0 / std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    result.axes = axes_of({q.x * scale, q.y * scale, q.z * scale, q.w * scale});
  }
  if (!node.scale.empty()) {
    result.axes.x = result.axes.x * node.scale[0];
    result.axes.y = result.axes.y * node.scale[1];
    result.axes.z = result.axes.z * node.scale[2];
  }
  if (!node.translation.empty()) {
    result.origin = {node.translation[0], node.translation[1], node.translation[2]};
  }
  return result;
}

// A map that flattens space: nodes below it have no place.
bool is_degenerate(const Axes& axes) {
  constexpr double least_length = 1e-9;
  constexpr double least_volume = 1e-9;
  const double x = length(axes.x);
  const double y = length(axes.y);
  const double z = length(axes.z);
  if (!(x > least_length && y > least_length && z > least_length)) {
    return true;
  }
  const double volume = dot(cross(axes.x * (1.0 / x), axes.y * (1.0 / y)), axes.z * (1.0 / z));
  return !(std::abs(volume) > least_volume);
}

// tinygltf must never decode one; the images are taken out of what it reads besides.
bool ignore_image(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*,
                  int, void*) {
  return true;
}

tinygltf::Model load_model(const std::string& json, const std::string& file) {
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(ignore_image, nullptr);
  loader.SetStoreOriginalJSONForExtrasAndExtensions(true);
  tinygltf::Model model;
  std::string error;
  std::string warning;
  const bool loaded = loader.LoadASCIIFromString(&model, &error, &warning, json.data(),
                                                 static_cast<unsigned int>(json.size()), "");
  if (!loaded || !error.empty()) {
    std::replace(error.begin(), error.end(), '\n', ' ');
    throw SceneError(file + ": " + error);
  }
  return model;
}

// Walks one scene from its roots, and keeps the haptic nodes. Indices are in range and the nodes are a
// forest: checked_gltf_json() has seen to it.
class Walk {
 public:
  Walk(const tinygltf::Model& model, const std::string& file) : model_(model), file_(file) {}

  std::vector<HapticNode> run(const tinygltf::Scene& scene) {
    push_reversed(scene.nodes, {}, 0);
    while (!pending_.empty()) {
      const Pending next = pending_.back();
      pending_.pop_back();
      visit(next);
    }
    return std::move(found_);
  }

 private:
  struct Pending {
    int node;
    int depth;
    Transform parent;
  };

  void push_reversed(const std::vector<int>& nodes, const Transform& parent, int depth) {
    std::transform(nodes.rbegin(), nodes.rend(), std::back_inserter(pending_), [&](int node) {
      return Pending{node, depth, parent};
    });
  }

  void visit(const Pending& pending) {
    const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(pending.node)];
    ancestors_.resize(static_cast<std::size_t>(pending.depth));
    ancestors_.push_back(pending.node);
    if (pending.depth >= gltf_limits::node_depth) {
      throw SceneError(where() + "lies deeper than " + std::to_string(gltf_limits::node_depth) + " nodes");
    }
    const Transform world = pending.parent * local_transform(node);
    if (!node.extras_json_string.empty()) {
      const nlohmann::json extras = nlohmann::json::parse(node.extras_json_string);
      if (is_haptic(extras)) {
        keep(node, world, haptic_properties(extras, where()));
      }
    }
    push_reversed(node.children, world, pending.depth + 1);
  }

  void keep(const tinygltf::Node& node, const Transform& world, const HapticProperties& properties) {
    if (found_.size() == gltf_limits::haptic_nodes) {
      throw SceneError(file_ + ": more than " + std::to_string(gltf_limits::haptic_nodes) +
                       " nodes have a haptic role");
    }
    for (std::size_t depth = 0; depth < ancestors_.size(); ++depth) {
      const tinygltf::Node& above = model_.nodes[static_cast<std::size_t>(ancestors_[depth])];
      if (is_degenerate(local_transform(above).axes)) {
        throw SceneError(
            file_ + ": node " + in_quotes(path(depth + 1)) + ": its " +
            (above.matrix.empty() ? "scale" : "matrix") + " has a zero-length axis or flattens space" +
            (depth + 1 == ancestors_.size() ? "" : ", and " + in_quotes(path()) + " is below it"));
      }
    }
    found_.push_back({node.name, path(), world.origin, world.axes, properties});
  }

  std::string path(std::size_t depth) const {
    std::string result;
    for (std::size_t i = 0; i < depth; ++i) {
      const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(ancestors_[i])];
      result += i == 0 ? "" : "/";
      result += node.name.empty() ? "[" + std::to_string(ancestors_[i]) + "]" : printable(node.name);
    }
    return result;
  }
  std::string path() const { return path(ancestors_.size()); }

  std::string where() const { return file_ + ": node " + in_quotes(path()) + ": "; }

  const tinygltf::Model& model_;
  const std::string& file_;
  std::vector<Pending> pending_;
  std::vector<int> ancestors_;  // of the node being visited, root first, itself last
  std::vector<HapticNode> found_;
};

std::vector<HapticNode> haptic_nodes_of(std::string_view json, const std::string& file) {
  const tinygltf::Model model = load_model(checked_gltf_json(json, file), file);
  int scene = model.defaultScene;
  if (scene < 0) {
    if (model.scenes.size() != 1) {
      throw SceneError(file + ": has " + std::to_string(model.scenes.size()) +
                       " scenes and no default: `scene` must name one");
    }
    scene = 0;
  }
  return Walk(model, file).run(model.scenes[static_cast<std::size_t>(scene)]);
}

}  // namespace

std::vector<HapticNode> read_haptic_nodes(std::span<const std::byte> bytes, std::string_view name) {
  const std::string file(name);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const JsonExtent json = json_extent(text.substr(0, glb_head_bytes), bytes.size(), file);
  return haptic_nodes_of(text.substr(json.offset, json.size), file);
}

std::vector<HapticNode> read_haptic_nodes(const std::filesystem::path& path) {
  const std::string file = printable(path.string());
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    throw SceneError(file + ": no such file");
  }
  // A device or a pipe may have no end.
  if (!std::filesystem::is_regular_file(status)) {
    throw SceneError(file + ": not a regular file");
  }
  const std::uintmax_t file_bytes = std::filesystem::file_size(path, error);
  std::ifstream stream(path, std::ios::binary);
  if (error || !stream) {
    throw SceneError(file + ": cannot be read");
  }
  std::string head(glb_head_bytes, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  const JsonExtent extent = json_extent(head, file_bytes, file);

  std::string json(extent.size, '\0');
  stream.clear();
  stream.seekg(static_cast<std::streamoff>(extent.offset));
  stream.read(json.data(), static_cast<std::streamsize>(json.size()));
  if (static_cast<std::size_t>(stream.gcount()) != json.size()) {
    throw SceneError(file + ": ended while it was read");
  }
  return haptic_nodes_of(json, file);
}

}  // namespace hrt
