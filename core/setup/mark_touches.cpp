#include "core/setup/mark_touches.h"

namespace hrt {
namespace {

constexpr int touch_tenths = 7;
constexpr int holding_tenths = 2;
// Until then the finger may rest where it was when it was asked for.
constexpr double min_moved_m = 0.015;
constexpr int moved_samples = 3;  // in a row: not a wild one

}  // namespace

void MarkTouches::begin(int wanted) {
  count_ = 0;
  wanted_ = wanted;
  still_.restart();
  from_m_.reset();
  moved_ = lost_ = false;
  away_ = 0;
}

bool MarkTouches::holding() const { return moved_ && !complete() && still_.rest(holding_tenths).has_value(); }

void MarkTouches::observe(const SetupSample& sample) {
  if (complete()) return;
  if (!sample.tracked_m) {
    lost_ = lost_ || holding();
    moved_ = moved_ || from_m_;  // it may come back anywhere
    still_.restart();
    return;
  }
  if (!from_m_) from_m_ = sample.tracked_m;
  away_ = (*sample.tracked_m - *from_m_).norm() > min_moved_m ? away_ + 1 : 0;
  if (!moved_ && away_ >= moved_samples) {
    moved_ = true;
    still_.restart();
  }
  still_.observe(sample.time_ns, *sample.tracked_m);
  const std::optional<Eigen::Vector3d> rest_m = moved_ ? still_.rest(touch_tenths) : std::nullopt;
  if (!rest_m) return;
  touches_[static_cast<std::size_t>(count_++)] = {sample.time_ns, *rest_m,
                                                  sample.joint_rotation.value_or(Eigen::Matrix3d::Identity())};
  from_m_ = rest_m;
  moved_ = lost_ = false;
  away_ = 0;
  still_.restart();
}

}  // namespace hrt
