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

bool StillFinger::observe(std::int64_t time_ns, const Eigen::Vector3d& place_mm) {
  const std::uint64_t elapsed = tenths_ > 0 ? elapsed_ns(began_ns_, time_ns) : 0;
  if (tenths_ == 0 || elapsed >= 3 * tenth_ns) {  // a gap of more than a whole tenth
    tenths_ = 1;
    began_ns_ = time_ns;
    means_[static_cast<std::size_t>(last_)] = {1.0, place_mm};
    return true;
  }
  if (elapsed >= tenth_ns) {
    began_ns_ += static_cast<std::int64_t>(tenth_ns * (elapsed / tenth_ns));
    tenths_ = std::min(tenths_ + 1, max_tenths + 1);
    last_ = (last_ + 1) % (max_tenths + 1);
    means_[static_cast<std::size_t>(last_)] = {1.0, place_mm};
    return true;
  }
  Mean& mean = means_[static_cast<std::size_t>(last_)];
  mean.count += 1.0;
  mean.place_mm += (place_mm - mean.place_mm) / mean.count;
  return false;
}

std::optional<Eigen::Vector3d> StillFinger::rest(int tenths, double drifting_mm_s) const {
  if (tenths_ <= tenths) return std::nullopt;
  const int late = tenths / 2;
  Eigen::Vector3d early_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d late_mm = Eigen::Vector3d::Zero();
  for (int i = 1; i <= tenths; ++i) (i <= late ? late_mm : early_mm) += back(i).place_mm;
  const Eigen::Vector3d mean_mm = (early_mm + late_mm) / tenths;
  double squares_mm2 = 0.0;
  for (int i = 1; i <= tenths; ++i) squares_mm2 += (back(i).place_mm - mean_mm).squaredNorm();
  late_mm /= late;
  early_mm /= tenths - late;
  if (std::sqrt(squares_mm2 / tenths) > max_spread_mm ||
      (late_mm - early_mm).norm() > drifting_mm_s * half_a_tenth_s * tenths)
    return std::nullopt;
  return late_mm;
}

}  // namespace hrt
