// Which direction the finger is wanted in now.
#pragma once

#include "core/plate_frame.h"

namespace hrt {

enum class GuidanceMode {
  fixed_direction,  ///< the real target's direction from the start (the paper's way)
  line_of_sight,    ///< from where the finger is to where the real target is; needs positions
};

/// Aims one reach. No heap, no lock, no exception. One thread at a time.
class Guidance {
 public:
  /// The real target lies `target_distance_m` > 0 from `start` in `target_direction_deg`.
  Guidance(GuidanceMode mode, const PlatePoint& start, double target_direction_deg, double target_distance_m);

  /// The wanted direction with the finger at `finger`. Line of sight is held once less than a fifth of
  /// the path remains: a bearing over a short distance turns ever faster.
  double aim_deg(const PlatePoint& finger);

  /// The last wanted direction: the fixed one before the first aim_deg().
  double direction_deg() const { return direction_deg_; }

  const PlatePoint& target() const { return target_; }

 private:
  GuidanceMode mode_;
  PlatePoint target_;
  double hold_distance_m_;
  double direction_deg_;
};

}  // namespace hrt
