#include "core/tracker/still_finger.h"

#include <algorithm>
#include <cmath>

#include "core/math/time.h"

namespace hrt {
namespace {

constexpr std::uint64_t tenth_ns = 100'000'000;
constexpr double half_a_tenth_s = 0.05;

}  // namespace

const StillFinger::Mean& StillFinger::back(int tenths) const {
  const int at = last_ - tenths;
  return means_[static_cast<std::size_t>(at < 0 ? at + max_tenths + 1 : at)];
}

bool StillFinger::observe(std::int64_t time_ns, const Eigen::Vector3d& place_m) {
  const std::uint64_t elapsed = tenths_ > 0 ? elapsed_ns(began_ns_, time_ns) : 0;
  if (tenths_ == 0 || elapsed >= 3 * tenth_ns) {  // a gap of more than a whole tenth
    tenths_ = 1;
    began_ns_ = time_ns;
    means_[static_cast<std::size_t>(last_)] = {1.0, place_m};
    return true;
  }
  if (elapsed >= tenth_ns) {
    began_ns_ += static_cast<std::int64_t>(tenth_ns * (elapsed / tenth_ns));
    tenths_ = std::min(tenths_ + 1, max_tenths + 1);
    last_ = (last_ + 1) % (max_tenths + 1);
    means_[static_cast<std::size_t>(last_)] = {1.0, place_m};
    return true;
  }
  Mean& mean = means_[static_cast<std::size_t>(last_)];
  mean.count += 1.0;
  mean.place_m += (place_m - mean.place_m) / mean.count;
  return false;
}

std::optional<Eigen::Vector3d> StillFinger::rest(int tenths, double drifting_m_s) const {
  if (tenths_ <= tenths) return std::nullopt;
  const int late = tenths / 2;
  Eigen::Vector3d early_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d late_m = Eigen::Vector3d::Zero();
  for (int i = 1; i <= tenths; ++i) (i <= late ? late_m : early_m) += back(i).place_m;
  const Eigen::Vector3d mean_m = (early_m + late_m) / tenths;
  double squares_m2 = 0.0;
  for (int i = 1; i <= tenths; ++i) squares_m2 += (back(i).place_m - mean_m).squaredNorm();
  late_m /= late;
  early_m /= tenths - late;
  if (std::sqrt(squares_m2 / tenths) > max_spread_m ||
      (late_m - early_m).norm() > drifting_m_s * half_a_tenth_s * tenths)
    return std::nullopt;
  return late_m;
}

}  // namespace hrt
