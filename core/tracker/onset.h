// When a finger at rest starts to move.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "core/plate/plate_frame.h"

namespace hrt {

/// Watches noisy positions for the start of a motion. No heap, no lock, no exception.
class Onset {
 public:
  /// `averaged`: the mean of three positions decides and not a single one, which comes off by chance where
  /// the noise is not known yet.
  explicit Onset(bool averaged = true) : averaged_(averaged) {}

  /// Takes one position in; `noise_mm` is the standard deviation of its coordinates as far as it is
  /// known. Returns true once the finger is four of them, and at least `min_travel_mm`, from where it
  /// rested; more while there are few samples.
  bool observe(double time_s, const PlatePoint& position, double noise_mm);

  /// The last time at which the finger was still at rest, as far as the noise shows.
  double time_s() const { return rest_s_; }

  /// Where it rested.
  const PlatePoint& place() const { return place_; }

  static constexpr double min_travel_mm = 0.2;

 private:
  PlatePoint mean_of_last() const;

  bool averaged_;
  int samples_ = 0;
  int rested_ = 0;    // of the samples, those that place_ is made of
  PlatePoint place_;  // mean of the positions at rest
  std::array<PlatePoint, 3> last_{};
  double rest_s_ = 0.0;
};

/// The onset in recorded positions, of a tracker whose noise is learnt from all of them. None without a
/// motion, or of fewer than eight positions.
std::optional<Onset> find_onset(std::span<const TimedPoint> samples);

}  // namespace hrt
