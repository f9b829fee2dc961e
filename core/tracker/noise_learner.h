// A tracker's white noise, from positions as they come.
#pragma once

#include <optional>

#include "core/plate/plate_frame.h"

namespace hrt {

/// Learns from how a position departs from the line through its neighbours in time: slow motion cancels,
/// white noise stays. No heap, no lock, no exception.
class NoiseLearner {
 public:
  /// `known_mm`: standard deviation of a coordinate; 0: learn it.
  explicit NoiseLearner(double known_mm = 0.0);

  /// To be called with every position, also of a finger at rest. One with the time of the last is left out.
  void observe(double time_s, const PlatePoint& position);

  double variance_mm2() const { return variance_mm2_; }
  /// Standard deviation of a coordinate.
  double noise_mm() const;

 private:
  bool is_known_;
  double variance_mm2_;
  double weight_ = 1.0;  // samples that variance_mm2_ stands for
  std::optional<TimedPoint> last_;
  std::optional<TimedPoint> last_but_one_;
};

}  // namespace hrt
