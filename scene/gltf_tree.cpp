#include "scene/gltf_tree.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <memory>
#include <utility>

#include "scene/gltf_json.h"
#include "scene/gltf_model.h"
#include "scene/gltf_shape.h"
#include "scene/scene_error.h"

namespace hrt {
namespace {

// A map that flattens space: nodes below it have no place.
bool is_degenerate(const Axes& axes) {
  constexpr double min_length = 1e-9;
  constexpr double min_volume = 1e-9;
  const double x = length(axes.x);
  const double y = length(axes.y);
  const double z = length(axes.z);
  if (!(x > min_length && y > min_length && z > min_length)) return true;
  const double volume = dot(cross(axes.x * (1.0 / x), axes.y * (1.0 / y)), axes.z * (1.0 / z));
  return !(std::abs(volume) > min_volume);
}

// What a node does to what is below it. `where` is the node in messages.
Transform local_of(const tinygltf::Node& node, const std::string& file, const std::string& where) {
  if (!node.matrix.empty()) {
    const std::vector<double>& m = node.matrix;  // column by column
    if (m[3] != 0.0 || m[7] != 0.0 || m[11] != 0.0 || m[15] != 1.0)
      refuse(file, "{}: matrix has a fourth row other than 0 0 0 1", where);
    return {{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}, {m[12], m[13], m[14]}};
  }
  Axes axes;
  if (const std::vector<double>& q = node.rotation; !q.empty()) {
    const double squared_norm = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    if (!(std::abs(squared_norm - 1.0) < 2e-3)) refuse(file, "{}: rotation is not a quaternion of unit length", where);
    const double to_unit = 1.0 / std::sqrt(squared_norm);
    axes = axes_of({q[0] * to_unit, q[1] * to_unit, q[2] * to_unit, q[3] * to_unit});
  }
  if (const std::vector<double>& scale = node.scale; !scale.empty())
    axes = {axes.x * scale[0], axes.y * scale[1], axes.z * scale[2]};
  const std::vector<double>& p = node.translation;
  return {axes, p.empty() ? Vec3{} : Vec3{p[0], p[1], p[2]}};
}

// Walks one scene from its roots, and keeps the haptic nodes. Indices are in range and the nodes are a
// forest: read_model() has seen to it.
class Walk {
 public:
  Walk(const GltfModel& gltf, const std::string& file) : gltf_(gltf), file_(file) {
    for (const tinygltf::Node& node : gltf.model.nodes)
      locals_.push_back(local_of(node, file, node_label(node.name, locals_.size())));
  }

  std::vector<HapticNode> run() {
    push_reversed(gltf_.roots, {}, 0);
    while (!pending_.empty()) {
      const Pending next = pending_.back();
      pending_.pop_back();
      visit(next);
    }
    return std::move(found_);
  }

 private:
  struct Pending {
    std::size_t node;
    int depth;
    Transform parent;
  };

  void push_reversed(const std::vector<int>& nodes, const Transform& parent, int depth) {
    std::transform(nodes.rbegin(), nodes.rend(), std::back_inserter(pending_),
                   [&](int node) { return Pending{static_cast<std::size_t>(node), depth, parent}; });
  }

  const tinygltf::Node& node(std::size_t index) const { return gltf_.model.nodes[index]; }

  void visit(const Pending& pending) {
    ancestors_.resize(static_cast<std::size_t>(pending.depth));
    ancestors_.push_back(pending.node);
    if (pending.depth >= gltf_limits::node_depth) refuse(where(), "lies deeper than {} nodes", gltf_limits::node_depth);
    const Transform world = pending.parent * locals_[pending.node];
    const std::string& extras = node(pending.node).extras_json_string;
    if (const auto json = nlohmann::json::parse(extras, nullptr, false); is_haptic(json))
      keep(world, haptic_properties(json, where()));
    push_reversed(node(pending.node).children, world, pending.depth + 1);
  }

  void keep(const Transform& world, const HapticProperties& properties) {
    if (found_.size() == gltf_limits::haptic_nodes)
      refuse(file_, "more than {} nodes have a haptic role", gltf_limits::haptic_nodes);
    for (std::size_t depth = 0; depth < ancestors_.size(); ++depth) {
      if (is_degenerate(locals_[ancestors_[depth]].axes)) {
        refuse(file_, "node {}: its {} has a zero-length axis or flattens space{}", in_quotes(path(depth + 1)),
               node(ancestors_[depth]).matrix.empty() ? "scale" : "matrix",
               depth + 1 == ancestors_.size() ? "" : fmt::format(", and {} is below it", in_quotes(path())));
      }
    }
    found_.push_back({node(ancestors_.back()).name, path(), world.origin, world.axes, properties});
  }

  std::string path(std::size_t depth) const {
    std::string result;
    for (std::size_t i = 0; i < depth; ++i) {
      const std::string& name = node(ancestors_[i]).name;
      result += i == 0 ? "" : "/";
      result += name.empty() ? fmt::format("[{}]", ancestors_[i]) : printable(name);
    }
    return result;
  }
  std::string path() const { return path(ancestors_.size()); }

  std::string where() const { return fmt::format("{}: node {}", file_, in_quotes(path())); }

  const GltfModel& gltf_;
  const std::string& file_;
  std::vector<Transform> locals_;  // of each node
  std::vector<Pending> pending_;
  std::vector<std::size_t> ancestors_;  // of the node being visited, root first, itself last
  std::vector<HapticNode> found_;
};

// Not by a stream of the C++ library, which brings its locales.
using OpenFile = std::unique_ptr<std::FILE, decltype([](std::FILE* file) { std::fclose(file); })>;

}  // namespace

std::vector<HapticNode> read_haptic_nodes(std::span<const std::byte> bytes, std::string_view name) {
  const std::string file(name);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const JsonExtent json = json_extent(text.substr(0, glb_head_bytes), bytes.size(), file);
  return Walk(read_model(text.substr(json.offset, json.size), file), file).run();
}

std::vector<HapticNode> read_haptic_nodes(const std::filesystem::path& path) {
  const std::string file = printable(path.string());
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) refuse(file, "no such file");
  // A device or a pipe may have no end.
  if (!std::filesystem::is_regular_file(status)) refuse(file, "not a regular file");
  const std::uintmax_t file_bytes = std::filesystem::file_size(path, error);
#if defined(_WIN32)
  const OpenFile stream(_wfopen(path.c_str(), L"rb"));
#else
  const OpenFile stream(std::fopen(path.c_str(), "rb"));
#endif
  if (error || !stream) refuse(file, "cannot be read");
  std::string json(glb_head_bytes, '\0');
  json.resize(std::fread(json.data(), 1, json.size(), stream.get()));
  const JsonExtent extent = json_extent(json, file_bytes, file);

  json.resize(extent.size);
  if (std::fseek(stream.get(), static_cast<long>(extent.offset), SEEK_SET) != 0 ||
      std::fread(json.data(), 1, json.size(), stream.get()) != json.size())
    refuse(file, "ended while it was read");
  return Walk(read_model(json, file), file).run();
}

}  // namespace hrt
