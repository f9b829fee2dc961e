#include "core/setup/mark_touches.h"

namespace hrt {
namespace {

constexpr int touch_tenths = 7;
constexpr int holding_tenths = 2;
// Until then the finger may rest where it was when it was asked for.
constexpr double min_moved_mm = 15.0;
constexpr int moved_samples = 3;  // in a row: not a wild one

}  // namespace

void MarkTouches::begin(int wanted) {
  count_ = 0;
  wanted_ = wanted;
  still_.restart();
  from_mm_.reset();
  moved_ = lost_ = false;
  away_ = 0;
}

bool MarkTouches::holding() const { return moved_ && !complete() && still_.rest(holding_tenths).has_value(); }

void MarkTouches::observe(const SetupSample& sample) {
  if (complete()) return;
  if (!sample.tracked_mm) {
    lost_ = lost_ || holding();
    moved_ = moved_ || from_mm_;  // it may come back anywhere
    still_.restart();
    return;
  }
  if (!from_mm_) from_mm_ = sample.tracked_mm;
  away_ = (*sample.tracked_mm - *from_mm_).norm() > min_moved_mm ? away_ + 1 : 0;
  if (!moved_ && away_ >= moved_samples) {
    moved_ = true;
    still_.restart();
  }
  still_.observe(sample.time_ns, *sample.tracked_mm);
  const std::optional<Eigen::Vector3d> rest_mm = moved_ ? still_.rest(touch_tenths) : std::nullopt;
  if (!rest_mm) return;
  touches_[static_cast<std::size_t>(count_++)] = {sample.time_ns, *rest_mm,
                                                  sample.joint_rotation.value_or(Eigen::Matrix3d::Identity())};
  from_mm_ = rest_mm;
  moved_ = lost_ = false;
  away_ = 0;
  still_.restart();
}

}  // namespace hrt
