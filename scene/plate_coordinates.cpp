#include "scene/plate_coordinates.h"

#include "core/plate/plate_frame.h"

namespace hrt {
namespace {

constexpr double max_node_coordinate_m = 1e6;

// Returns false for NaN, too.
bool in_range(Vec3 v) {
  return std::abs(v.x) < max_node_coordinate_m && std::abs(v.y) < max_node_coordinate_m &&
         std::abs(v.z) < max_node_coordinate_m;
}

}  // namespace

Bearing bearing_from(Vec3 start_m, Vec3 point_m) {
  const PlatePoint start{mm_per_m * start_m.x, -mm_per_m * start_m.z};
  const PlatePoint point{mm_per_m * point_m.x, -mm_per_m * point_m.z};
  const double far_m = distance_mm(start, point) / mm_per_m;
  return {.direction_deg = bearing_deg(start, point), .distance_m = far_m, .at_start = far_m < min_distance_m};
}

bool is_valid(const Pose& pose) { return in_range(pose.position_m) && is_unit(pose.orientation); }

bool locate_finger(const PlateSurface& surface, const Pose& plate, Vec3 fingertip_m, FingerOnPlate& out) {
  if (!is_valid(plate) || !in_range(fingertip_m)) return false;
  const Transform frame = transform_of({plate.position_m, normalized(plate.orientation)});
  const Vec3 position_m = coordinates_in(frame, fingertip_m);
  out = {.position_m = position_m,
         .off_plate = position_m.x * position_m.x + position_m.z * position_m.z > surface.radius_m * surface.radius_m,
         .lifted = position_m.y > surface.lift_height_m};
  return true;
}

}  // namespace hrt
