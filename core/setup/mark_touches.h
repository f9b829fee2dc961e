// Touches of marks, one after another.
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

/// A touch is a rest of 0.7 s of a finger that has moved since the last one. Uses no heap, lock or exception.
class MarkTouches {
 public:
  static constexpr int max_touches = 40;

  /// Discards the touches so far and waits for `wanted` touches, from 1 to max_touches.
  void begin(int wanted);
  void observe(const SetupSample& sample);

  bool complete() const { return count_ == wanted_; }
  int count() const { return count_; }
  int wanted() const { return wanted_; }
  const SetupTouch& operator[](int i) const { return touches_[static_cast<std::size_t>(i)]; }
  /// The finger has begun to rest.
  bool holding() const;
  /// The tracker lost the finger while it was on the mark.
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
