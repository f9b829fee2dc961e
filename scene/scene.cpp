#include "scene/scene.h"

#include <cmath>
#include <map>

#include "core/math/trigonometry.h"
#include "scene/gltf_tree.h"

namespace hrt {
namespace {

// Between a plate's +Y and -Z, as a cosine: the rounding of single-precision files.
constexpr double max_shear = 1e-4;
constexpr double max_plate_coordinate_m = 1000.0;  // as of a session

class SceneBuilder {
 public:
  SceneBuilder(const std::vector<HapticNode>& nodes, const std::string& file) : nodes_(nodes), file_(file) {}

  Scene build() {
    if (nodes_.empty()) refuse(file_, "no node has a haptic role (extras.haptic.role, or extras.haptic_role)");
    for (const HapticNode& node : nodes_) check_position(node, node.origin_m, "the world's origin");
    const HapticNode* plate = only(HapticRole::plate);
    if (plate == nullptr) refuse(file_, "no node has extras.haptic.role \"plate\"");
    place_plate(*plate);
    place_start(only(HapticRole::start));
    for (const HapticNode& node : nodes_) {
      const HapticRole role = node.properties.role;
      if (role == HapticRole::real || role == HapticRole::virtual_target) add_target(node);
    }
    for (std::size_t i = 0; i < scene_.targets.size(); ++i)
      if (scene_.targets[i].kind == TargetKind::virtual_object)
        scene_.targets[i].served_by = real_target_of(*target_nodes_[i], scene_.targets[i].direction_deg);
    return std::move(scene_);
  }

 private:
  std::string where(const HapticNode& node) const { return fmt::format("{}: node {}", file_, in_quotes(node.path)); }

  void check_position(const HapticNode& node, Vec3 p, const char* whence) const {
    for (const double coordinate_m : {p.x, p.y, p.z})
      if (!(std::abs(coordinate_m) < max_plate_coordinate_m))
        refuse(where(node), "it is further than 1000 m from {}", whence);
  }

  // The node of a role that a file has at most once; null if it has none.
  const HapticNode* only(HapticRole role) const {
    const HapticNode* found = nullptr;
    for (const HapticNode& node : nodes_) {
      if (node.properties.role != role) continue;
      if (found != nullptr) {
        refuse(where(node), "extras.haptic.role is the same as that of {}, and there may be one only",
               in_quotes(found->path));
      }
      found = &node;
    }
    return found;
  }

  void place_plate(const HapticNode& node) {
    const Vec3 up = node.axes.y * (1.0 / length(node.axes.y));
    const Vec3 back = node.axes.z * (1.0 / length(node.axes.z));
    if (!(std::abs(dot(up, back)) < max_shear)) {
      refuse(where(node), "its transform is sheared: the plate's normal (+Y) and mid-line (-Z) are not perpendicular");
    }
    const Vec3 sideways = cross(up, back);
    plate_axes_.x = sideways * (1.0 / length(sideways));
    plate_axes_.y = up;
    plate_axes_.z = cross(plate_axes_.x, up);
    scene_.plate = {.pose = {node.origin_m, quaternion_of(plate_axes_)},
                    .radius_m = node.properties.radius_m.value(),
                    .max_speed_deg_s = node.properties.max_speed_deg_s,
                    .node_path = node.path};
  }

  Vec3 in_plate_coordinates(const HapticNode& node) const {
    return along(plate_axes_, node.origin_m - scene_.plate.pose.position_m);
  }

  void place_start(const HapticNode* node) {
    if (node == nullptr) {
      scene_.start_m = {0.0, 0.0, scene_.plate.radius_m * 2.0 / 3.0};
      return;
    }
    scene_.start_m = in_plate_coordinates(*node);
    scene_.start_m.y = 0.0;
    scene_.start_path = node->path;
    const double from_centre_m = length(scene_.start_m);
    if (from_centre_m > scene_.plate.radius_m) {
      refuse(where(*node), "the start lies off the plate, {:g} m from its centre; the plate's radius_m is {:g}",
             from_centre_m, scene_.plate.radius_m);
    }
  }

  void add_target(const HapticNode& node) {
    const std::string& name = node.properties.name.value_or(node.name.empty() ? node.path : printable(node.name));
    const auto [same, is_new] = index_of_.emplace(name, scene_.targets.size());
    if (!is_new) {
      refuse(where(node), "its name {} is also that of {}; targets need names of their own (extras.haptic.name)",
             in_quotes(name), in_quotes(target_nodes_[same->second]->path));
    }
    const Vec3 position_m = in_plate_coordinates(node);
    check_position(node, position_m, "the plate");
    const Bearing bearing = bearing_from(scene_.start_m, position_m);
    if (bearing.at_start) refuse(where(node), "the target lies at the start point, so it has no direction");
    scene_.targets.push_back({
        .kind = node.properties.role == HapticRole::real ? TargetKind::real_object : TargetKind::virtual_object,
        .name = name,
        .world_position_m = node.origin_m,
        .position_m = position_m,
        .direction_deg = bearing.direction_deg,
        .distance_m = bearing.distance_m,
        .radius_m = node.properties.radius_m,
        .served_by = std::nullopt,
        .node_path = node.path,
    });
    target_nodes_.push_back(&node);
  }

  std::size_t real_target_of(const HapticNode& node, double direction_deg) const {
    if (node.properties.served_by) {
      const std::string& wanted = *node.properties.served_by;
      const auto found = index_of_.find(wanted);
      if (found == index_of_.end() || scene_.targets[found->second].kind != TargetKind::real_object) {
        refuse(where(node), "extras.haptic.served_by is {}, which is not the name of a real target", in_quotes(wanted));
      }
      return found->second;
    }
    // Any real target may serve many: the gap is smallest with the one that is nearest in direction.
    std::optional<std::size_t> nearest;
    double min_gap_deg = 0.0;
    for (std::size_t i = 0; i < scene_.targets.size(); ++i) {
      if (scene_.targets[i].kind != TargetKind::real_object) continue;
      const double gap_deg = std::abs(wrap_deg(scene_.targets[i].direction_deg - direction_deg, 360.0));
      if (!nearest || gap_deg < min_gap_deg) {
        nearest = i;
        min_gap_deg = gap_deg;
      }
    }
    if (!nearest) refuse(where(node), "the file has no real target that could serve this virtual one");
    return *nearest;
  }

  const std::vector<HapticNode>& nodes_;
  const std::string& file_;
  Scene scene_;
  Axes plate_axes_;
  std::vector<const HapticNode*> target_nodes_;  // as Scene::targets
  std::map<std::string, std::size_t> index_of_;  // into Scene::targets, by name
};

}  // namespace

PlateSurface surface_of(const Scene& scene) { return {.radius_m = scene.plate.radius_m}; }

Scene load_scene(const std::filesystem::path& file) {
  return SceneBuilder(read_haptic_nodes(file), printable(file.string())).build();
}

Scene load_scene(std::span<const std::byte> bytes, std::string_view name) {
  return SceneBuilder(read_haptic_nodes(bytes, name), std::string(name)).build();
}

}  // namespace hrt
