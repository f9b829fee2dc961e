// Detects successive touches of marks.
#pragma once

#include <array>

#include "core/setup/setup_step.h"
#include "core/tracker/finger_phase.h"

namespace hrt {

struct SetupTouch {
  std::int64_t time_ns;
  Eigen::Vector3d touched_mm;  ///< position in the tracker's frame
  Eigen::Matrix3d joint_rotation;
};

/// A touch is a rest of 0.7 s after a motion of 15 mm or a loss of tracking. Uses no heap, lock or exception.
class MarkTouches {
 public:
  static constexpr int max_touches = 40;

  /// Discards all touches, and waits for `wanted` touches, 1 to max_touches.
  void begin(int wanted);
  void observe(const SetupSample& sample);

  bool complete() const { return count_ == wanted_; }
  int count() const { return count_; }
  int wanted() const { return wanted_; }
  const SetupTouch& operator[](int i) const { return touches_[static_cast<std::size_t>(i)]; }
  /// True if the finger has begun to rest on a mark.
  bool holding() const;
  /// True if the tracker lost the finger while the finger rested on the mark.
  bool lost() const { return lost_; }

 private:
  std::array<SetupTouch, max_touches> touches_{};
  int count_ = 0;
  int wanted_ = 0;
  PhaseDetector<Eigen::Vector3d> finger_;
  std::optional<Eigen::Vector3d> from_mm_;  // position of the finger when the touch was requested
  bool moved_ = false;
  bool lost_ = false;
};

}  // namespace hrt
