// When a moving finger has come to rest, and where.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

namespace hrt {

/// Means over tenths of a second, in which a tracker's noise averages out: the finger rests while they stay
/// together. No heap, no lock, no exception.
class StillFinger {
 public:
  static constexpr int max_tenths = 20;

  /// True if another tenth of a second begins: rest() may have changed, as at no other place.
  bool observe(std::int64_t time_ns, const Eigen::Vector3d& place_mm);
  /// The finger was lost or lifted.
  void restart() { tenths_ = 0; }

  /// Root mean square distance of the means from their own; and from the first half of them to the second,
  /// whose middles are half of the time apart.
  static constexpr double max_spread_mm = 4.0;
  static constexpr double max_drift_mm_s = 8.6;

  /// Where it has rested for so many tenths of a second, 2 to max_tenths: the mean over the second half, as
  /// it may have come in the first. None if it moves.
  std::optional<Eigen::Vector3d> rest(int tenths, double drifting_mm_s = max_drift_mm_s) const;

 private:
  struct Mean {
    double count;
    Eigen::Vector3d place_mm;
  };
  const Mean& back(int tenths) const;

  std::array<Mean, max_tenths + 1> means_{};  // the last one is not whole yet
  int last_ = 0;
  int tenths_ = 0;  // that are whole or begun
  std::int64_t began_ns_ = 0;
};

}  // namespace hrt
