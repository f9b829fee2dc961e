#include "scene/scene.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <utility>

#include "core/math/elementary.h"
#include "scene/gltf.h"
#include "scene/haptic_properties.h"

namespace hrt {
namespace {

// Largest absolute cosine of the angle between a plate's +Y and -Z, for rounding errors of single-precision files.
constexpr double max_shear = 1e-4;
constexpr double max_plate_coordinate_m = 1000.0;  // range of hrt_session_plate::position_m
// Smallest length of an axis of a transform, and smallest volume between the directions of its axes.
constexpr double min_length = 1e-9, min_volume = 1e-9;

// Returns true if the transform maps space onto a plane, a line or a point, or nearly so.
bool is_degenerate(const Transform& t) {
  const bool has_lengths = length(t.x) > min_length && length(t.y) > min_length && length(t.z) > min_length;
  return !(has_lengths && std::abs(dot(cross(unit(t.x), unit(t.y)), unit(t.z))) > min_volume);
}

// Converts a rotation matrix to a quaternion with w >= 0. Each of 4x^2, 4y^2, 4z^2, 4w^2 is 1 plus a signed sum of the
// diagonal elements; dividing by the root of the largest one avoids cancellation.
Quaternion quaternion_of(const Transform& axes) {
  const double xx = axes.x.x;
  const double yy = axes.y.y;
  const double zz = axes.z.z;
  const double four_w2 = 1.0 + xx + yy + zz;
  const double four_x2 = 1.0 + xx - yy - zz;
  const double four_y2 = 1.0 - xx + yy - zz;
  const double four_z2 = 1.0 - xx - yy + zz;
  const double max = std::max({four_w2, four_x2, four_y2, four_z2});
  Quaternion q;
  if (max == four_w2)
    q = {axes.y.z - axes.z.y, axes.z.x - axes.x.z, axes.x.y - axes.y.x, four_w2};
  else if (max == four_x2)
    q = {four_x2, axes.y.x + axes.x.y, axes.z.x + axes.x.z, axes.y.z - axes.z.y};
  else if (max == four_y2)
    q = {axes.y.x + axes.x.y, four_y2, axes.z.y + axes.y.z, axes.z.x - axes.x.z};
  else
    q = {axes.z.x + axes.x.z, axes.z.y + axes.y.z, four_z2, axes.x.y - axes.y.x};
  const double scale = (q.w < 0.0 ? -0.5 : 0.5) / std::sqrt(max);
  return {q.x * scale, q.y * scale, q.z * scale, q.w * scale};
}

// Walks the default scene of a model, or its only scene, and fills a Scene.
class SceneReader {
 public:
  SceneReader(const tinygltf::Model& model, const std::string& file)
      : model_(model), file_(file), is_visited_(model.nodes.size()) {}

  Scene read() {
    const std::size_t count = model_.scenes.size();
    if (count == 0) refuse(file_, "the file has no scene; export it with a scene");
    if (model_.defaultScene < 0 && count != 1)
      refuse(file_, "the file has {} scenes and no default scene; set `scene` to the index of a scene", count);
    const auto index = static_cast<std::size_t>(std::max(model_.defaultScene, 0));
    if (index >= count) refuse(file_, "scene is {}; allowed: below {}, the number of scenes", index, count);
    visit_all(model_.scenes[index].nodes);
    if (haptic_nodes_ == 0) refuse(file_, "no node has a haptic role; set extras.haptic.role or extras.haptic_role");
    if (scene_.plate.node_path.empty())
      refuse(file_, "no node has the haptic role \"plate\"; set the role of one node to \"plate\"");
    locate_start();
    for (SceneTarget& target : scene_.targets) {
      target.position_m = coordinates_in(plate_frame_, target.world_position_m);
      check_position(target.node_path, target.position_m, "the plate");
      if (distance_m(scene_, target) < min_distance_m)
        refuse(where(target.node_path),
               "the target is at the start and has no direction; move the target or the start");
    }
    for (std::size_t i = 0; i < scene_.targets.size(); ++i)
      if (!scene_.targets[i].is_real) scene_.targets[i].served_by = real_target_of(i);
    return std::move(scene_);
  }

 private:
  // Visits parents before their children, and siblings in the order of the file. The depth of recursion is limited.
  void visit_all(const std::vector<int>& siblings) {
    for (const int index : siblings) {
      if (index < 0 || static_cast<std::size_t>(index) >= model_.nodes.size())
        refuse(path_.empty() ? file_ : where(),
               "refers to node {}, but the file has only {} nodes; export the file again", index, model_.nodes.size());
      const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(index)];
      path_.push_back(index);
      if (is_visited_[static_cast<std::size_t>(index)])
        refuse(where(), "the node appears twice in the scene; list it once, as a root or as child of one other node");
      is_visited_[static_cast<std::size_t>(index)] = true;
      if (path_.size() > gltf_limits::node_depth)
        refuse(where(), "the node has too many ancestors; allowed: up to {} levels", gltf_limits::node_depth);
      if (is_haptic(node.extras)) take(node, haptic_properties(node.extras, where()));
      visit_all(node.children);
      path_.pop_back();
    }
  }

  // Returns the first `depth` nodes of path_, joined with '/': names or, of nodes without a name, indices in brackets.
  std::string path(std::size_t depth) const {
    std::string result;
    for (std::size_t i = 0; i < depth; ++i) {
      const std::string& name = model_.nodes[static_cast<std::size_t>(path_[i])].name;
      if (name.size() > gltf_limits::name_bytes)
        refuse(file_, "node {}: name is too long; allowed: up to {} bytes", in_quotes(name), gltf_limits::name_bytes);
      result += (i == 0 ? "" : "/") + (name.empty() ? fmt::format("[{}]", path_[i]) : printable(name));
    }
    return result;
  }
  std::string path() const { return path(path_.size()); }

  std::string where(std::string_view node_path) const {
    return fmt::format("{}: node {}", file_, in_quotes(node_path));
  }
  std::string where() const { return where(path()); }

  // Returns the transform of the last node of path_: the product of the transforms of all nodes of path_.
  Transform world_transform() const {
    Transform world;
    for (std::size_t depth = 0; depth < path_.size(); ++depth) {
      const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(path_[depth])];
      const auto node_is_refused = [&](const std::string& what) { refuse(where(path(depth + 1)), "{}", what); };
      const auto check_size = [&](const char* key, const std::vector<double>& values, std::size_t size) {
        if (!values.empty() && values.size() != size)
          node_is_refused(fmt::format("{} is not an array of {} numbers; export the file again", key, size));
      };
      check_size("matrix", node.matrix, 16);
      check_size("translation", node.translation, 3);
      check_size("rotation", node.rotation, 4);
      check_size("scale", node.scale, 3);
      Transform local;
      if (const std::vector<double>& m = node.matrix; !m.empty()) {  // column by column
        if (m[3] != 0.0 || m[7] != 0.0 || m[11] != 0.0 || m[15] != 1.0)
          node_is_refused("matrix has a fourth row other than 0 0 0 1; export an affine transform");
        local = {.x{m[0], m[1], m[2]}, .y{m[4], m[5], m[6]}, .z{m[8], m[9], m[10]}, .origin{m[12], m[13], m[14]}};
      } else {
        Pose pose;
        if (const std::vector<double>& p = node.translation; !p.empty()) pose.position_m = {p[0], p[1], p[2]};
        if (const std::vector<double>& q = node.rotation; !q.empty()) pose.orientation = {q[0], q[1], q[2], q[3]};
        if (!is_unit(pose.orientation))
          node_is_refused("rotation is not a unit quaternion; allowed: length 1 within 0.001");
        local = transform_of({pose.position_m, normalized(pose.orientation)});
        if (const std::vector<double>& s = node.scale; !s.empty()) {
          local.x = local.x * s[0];
          local.y = local.y * s[1];
          local.z = local.z * s[2];
        }
      }
      if (is_degenerate(local))
        node_is_refused(node.matrix.empty() ? "scale is 0 or too small in an axis; set it to another value"
                                            : "matrix has no inverse; allowed: invertible matrices");
      world = world * local;
    }
    return world;
  }

  void take(const tinygltf::Node& node, const HapticProperties& properties) {
    constexpr const char* instancing = "EXT_mesh_gpu_instancing";
    if (++haptic_nodes_ > gltf_limits::haptic_nodes)
      refuse(file_, "too many nodes have a haptic role; allowed: up to {}", gltf_limits::haptic_nodes);
    const std::vector<std::string>& required = model_.extensionsRequired;
    if (node.extensions.contains(instancing) &&
        std::find(required.begin(), required.end(), instancing) != required.end())
      refuse(where(), "{} repeats a haptic node; remove this extension from the node", instancing);
    const Transform world = world_transform();
    check_position(path(), world.origin, "the world's origin");
    if (properties.role == HapticRole::plate) {
      check_is_first(scene_.plate.node_path);
      const Vec3 up = unit(world.y), back = unit(world.z);
      if (!(std::abs(dot(up, back)) < max_shear))
        refuse(where(),
               "the transform is sheared: the plate's normal (+Y) and mid-line (-Z) are not perpendicular; remove the "
               "shear");
      const Vec3 right = unit(cross(up, back));
      plate_frame_ = {.x = right, .y = up, .z = cross(right, up), .origin = world.origin};
      scene_.plate = {.pose = {world.origin, quaternion_of(plate_frame_)},
                      .radius_m = properties.radius_m.value(),
                      .max_speed_deg_s = properties.max_speed_deg_s,
                      .node_path = path()};
    } else if (properties.role == HapticRole::start) {
      check_is_first(scene_.start_path.value_or(""));
      scene_.start_path = path();
      scene_.start_m = world.origin;
    } else {
      const std::string& name = properties.name.value_or(node.name.empty() ? path() : printable(node.name));
      const auto [same, is_new] = index_of_.emplace(name, scene_.targets.size());
      if (!is_new)
        refuse(where(), "the target's name {} is also the name of {}; set another haptic property name for one of them",
               in_quotes(name), in_quotes(scene_.targets[same->second].node_path));
      scene_.targets.push_back({.is_real = properties.role == HapticRole::real,
                                .name = name,
                                .world_position_m = world.origin,
                                .position_m = {},
                                .radius_m = properties.radius_m,
                                .served_by = {},
                                .node_path = path()});
      served_by_.push_back(properties.served_by);
    }
  }

  void check_position(std::string_view node_path, Vec3 p, const char* origin) const {
    for (const double coordinate_m : {p.x, p.y, p.z})
      if (!(std::abs(coordinate_m) < max_plate_coordinate_m))
        refuse(where(node_path), "a coordinate is 1000 m or more from {}; check that the file is in metres", origin);
  }

  void check_is_first(const std::string& other_path) const {
    if (!other_path.empty())
      refuse(where(), "the haptic role is the same as that of {}; remove the role of one of the two nodes",
             in_quotes(other_path));
  }

  void locate_start() {
    if (!scene_.start_path) {
      scene_.start_m = {0.0, 0.0, scene_.plate.radius_m * 2.0 / 3.0};
      return;
    }
    scene_.start_m = coordinates_in(plate_frame_, scene_.start_m);
    scene_.start_m.y = 0.0;
    const double from_centre_m = length(scene_.start_m);
    if (from_centre_m > scene_.plate.radius_m) {
      refuse(where(*scene_.start_path),
             "the start is {:g} m from the centre of the plate; allowed: up to the plate's radius_m, {:g}",
             from_centre_m, scene_.plate.radius_m);
    }
  }

  std::size_t real_target_of(std::size_t virtual_index) const {
    const std::vector<SceneTarget>& targets = scene_.targets;
    const SceneTarget& target = targets[virtual_index];
    if (const std::optional<std::string>& wanted = served_by_[virtual_index]) {
      const auto found = index_of_.find(*wanted);
      if (found == index_of_.end() || !targets[found->second].is_real)
        refuse(where(target.node_path), "the haptic property served_by is {}; allowed: the name of a real target",
               in_quotes(*wanted));
      return found->second;
    }
    // A real target may be assigned to several virtual ones. The nearest in direction has the smallest gap.
    std::optional<std::size_t> nearest;
    double min_gap_deg = 0.0;
    for (std::size_t i = 0; i < targets.size(); ++i) {
      if (!targets[i].is_real) continue;
      const double gap_deg =
          std::abs(wrap_deg(direction_deg(scene_, targets[i]) - direction_deg(scene_, target), 360.0));
      if (!nearest || gap_deg < min_gap_deg) {
        nearest = i;
        min_gap_deg = gap_deg;
      }
    }
    if (!nearest) refuse(where(target.node_path), "the file has no real target for this virtual target; add one");
    return *nearest;
  }

  const tinygltf::Model& model_;
  const std::string& file_;
  std::vector<bool> is_visited_;  // by index of the node
  std::vector<int> path_;         // indices of the present node's ancestors, the root first, and of the node itself
  std::size_t haptic_nodes_ = 0;
  Scene scene_{};
  Transform plate_frame_;
  std::vector<std::optional<std::string>> served_by_;  // name in the file, for each of Scene::targets
  std::map<std::string, std::size_t> index_of_;        // index in Scene::targets, by name
};

Scene scene_of(std::string json, const std::string& file) {
  const tinygltf::Model model = parse_gltf(std::move(json), file);
  return SceneReader(model, file).read();
}

}  // namespace

double direction_deg(const Scene& scene, const SceneTarget& target) {
  return bearing_deg(plate_point(scene.start_m), plate_point(target.position_m));
}

double distance_m(const Scene& scene, const SceneTarget& target) {
  return hrt::distance_mm(plate_point(scene.start_m), plate_point(target.position_m)) / mm_per_m;
}

Scene load_scene(const std::filesystem::path& path) {
  const std::string file = printable(path.string());
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) refuse(file, "the file does not exist; check its path");
  // Reading from a device or a pipe may never end.
  if (!std::filesystem::is_regular_file(status))
    refuse(file, "the path is not a regular file that can be read; name a .gltf or .glb file");
  const std::uintmax_t file_bytes = std::filesystem::file_size(path, error);
  std::ifstream stream(path, std::ios::binary);
  if (error || !stream) refuse(file, "the file cannot be read; check its permissions");
  std::string json(static_cast<std::size_t>(std::min<std::uintmax_t>(file_bytes, glb_header_bytes)), '\0');
  stream.read(json.data(), static_cast<std::streamsize>(json.size()));
  const JsonExtent extent = find_json(json, file_bytes, file);
  json.resize(extent.size);
  stream.seekg(static_cast<std::streamoff>(extent.offset));
  if (!stream.read(json.data(), static_cast<std::streamsize>(json.size())))
    refuse(file, "the file became shorter while it was read; load it again");
  return scene_of(std::move(json), file);
}

Scene load_scene(std::string_view bytes, const std::string& name) {
  const JsonExtent extent = find_json(bytes.substr(0, glb_header_bytes), bytes.size(), name);
  return scene_of(std::string(bytes.substr(extent.offset, extent.size)), name);
}

}  // namespace hrt
