#include "core/setup/mark_touches.h"

namespace hrt {
namespace {

constexpr double touch_s = 0.7;
constexpr double holding_s = 0.2;
// A finger this far from its position at the request has moved.
constexpr double min_moved_mm = 15.0;

}  // namespace

void MarkTouches::begin(int wanted) {
  count_ = 0;
  wanted_ = wanted;
  finger_.lift();
  from_mm_.reset();
  moved_ = lost_ = false;
}

bool MarkTouches::holding() const { return moved_ && !complete() && finger_.rest_s() >= holding_s; }

void MarkTouches::observe(const SetupSample& sample) {
  if (complete()) return;
  if (!sample.tracked_mm) {
    lost_ = lost_ || holding();
    moved_ = moved_ || from_mm_;  // the next position may be that of another mark
    finger_.lift();
    return;
  }
  if (!from_mm_) from_mm_ = sample.tracked_mm;
  finger_.observe(sample.time_ns, *sample.tracked_mm);
  if (!moved_ && (finger_.smoothed() - *from_mm_).norm() > min_moved_mm) {
    moved_ = true;
    finger_.lift();  // a rest before the motion must not continue after it
  }
  if (!moved_ || finger_.rest_s() < touch_s) return;
  touches_[static_cast<std::size_t>(count_++)] = {sample.time_ns, finger_.rest_place(),
                                                  sample.joint_rotation.value_or(Eigen::Matrix3d::Identity())};
  from_mm_ = finger_.rest_place();
  moved_ = lost_ = false;
}

}  // namespace hrt
