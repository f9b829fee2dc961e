#include "core/guidance.h"

namespace hrt {

Guidance::Guidance(GuidanceMode mode, const PlatePoint& start, double target_direction_deg,
                   double target_distance_m)
    : mode_(mode),
      target_(point_ahead(start, target_direction_deg, target_distance_m)),
      hold_distance_m_(0.2 * target_distance_m),
      direction_deg_(target_direction_deg) {}

double Guidance::aim_deg(const PlatePoint& finger) {
  if (mode_ == GuidanceMode::line_of_sight && distance_m(finger, target_) >= hold_distance_m_) {
    direction_deg_ = bearing_deg(finger, target_);
  }
  return direction_deg_;
}

}  // namespace hrt
