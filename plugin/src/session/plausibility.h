// Checks whether times, positions and targets of a reach are plausible. Samples in a wrong unit or with exchanged axes
// may fit the model so well that no other check fails.
#pragma once

#include <cstdint>
#include <optional>

#include "core/reach/finger_sample.h"
#include "core/reach/reach.h"
#include "plugin/src/abi/text.h"

namespace hrt::plugin {

/// The likely mistake in a reach, and the values that reveal it.
struct Implausible {
  enum class Kind : std::uint8_t {
    none,
    radians,           ///< the directions of all targets are at most 1.6, and therefore probably in radians
    target_off_plate,  ///< first: distance of the start or real target from the plate's centre; second: the radius, mm
    time_too_slow,     ///< first: number of samples; second: nanoseconds between two of them
    too_fast,          ///< first: speed in m/s; second: nanoseconds between two samples
    far_away,          ///< first: distance of the finger from the plate's centre; second: the radius, mm
    wrong_way,         ///< first: bearing of the finger; second: direction of the virtual target, degrees
    turns_with_plate,  ///< first: angle by which the finger ends beyond the virtual target; second: the gap, degrees
  };
  Kind kind = Kind::none;
  double first = 0.0, second = 0.0;
};

void write_implausible(const Implausible& found, Text<320>& text);

class Plausibility {
 public:
  Plausibility() = default;
  Plausibility(double plate_radius_mm, const Reach& reach, bool may_be_in_radians);

  /// Ends the checks of directions (wrong_way, turns_with_plate), for example because the targets have moved.
  void skip_directions() { skips_directions_ = true; }
  /// Checks a sample. Pass every sample of the reach in order, before outliers are removed.
  void observe(const FingerSample& sample);
  /// Returns the first finding other than far_away. Without one, returns far_away if all of 20 or more
  /// positions are far away.
  const Implausible& found() const { return found_.kind != Implausible::Kind::none || !is_far() ? found_ : far_; }

 private:
  bool is_far() const { return far_positions_ >= min_far_positions && far_positions_ == positions_; }
  void find(Implausible::Kind kind, double first, double second);

  static constexpr std::int64_t min_far_positions = 20;

  double radius_mm_ = 0.0;
  Reach reach_{};
  bool skips_directions_ = false;
  Implausible found_, far_;
  std::optional<FingerSample> last_;  // last sample with a position
  std::int64_t positions_ = 0;
  std::int64_t far_positions_ = 0;
  int fast_positions_ = 0;                // consecutive positions at an impossible speed
  bool came_from_start_ = false;          // true if a position was in the first half of the path
  int wrong_positions_ = 0;               // consecutive positions that are evidence of wrong_way
  int turned_positions_ = 0;              // consecutive positions that are evidence of turns_with_plate
  std::optional<std::int64_t> first_ns_;  // beginning of the present window of 1 ms
  int samples_ = 0;                       // samples in the present window
};

}  // namespace hrt::plugin
