// Plausibility of the times, positions and targets of a reach. Hosts confuse units and axes, and the model can fit such
// data so well that the reach seems to be without an error.
#pragma once

#include <cstdint>
#include <optional>

#include "core/reach/finger_sample.h"
#include "core/reach/reach.h"
#include "plugin/src/abi/text.h"

namespace hrt::plugin {

/// The likely mistake in a reach, and the numbers that show it.
struct Implausible {
  enum class Kind : std::uint8_t {
    none,
    radians,           ///< the directions of all targets are within a right angle in radians
    place_off_plate,   ///< first: distance of the start or a target from the plate's centre in mm; second: the radius
    time_stands,       ///< first: number of samples; second: nanoseconds between two of them
    too_fast,          ///< first: speed in m/s; second: nanoseconds between two samples
    far_away,          ///< first: distance of the finger from the plate's centre in mm; second: the radius
    wrong_way,         ///< first: bearing of the finger from the start; second: of the virtual target
    turns_with_plate,  ///< first: degrees that the finger ends beyond the virtual target; second: the gap
  };
  Kind kind = Kind::none;
  double first = 0.0, second = 0.0;
};

/// Writes the observation and the likely mistake, for the log.
void write_implausible(const Implausible& found, Text<320>& text);

/// Checks one reach. Uses no heap, lock or exception.
class Plausibility {
 public:
  Plausibility() = default;
  Plausibility(double plate_radius_mm, const Reach& reach, bool may_be_in_radians);

  /// The targets have moved: from now on, only times and positions are checked.
  void retarget() { retargeted_ = true; }
  /// Every sample in turn, as the host gave it.
  void observe(const FingerSample& sample);
  /// First finding; a finger that is far away only while it is.
  const Implausible& found() const { return found_.kind != Implausible::Kind::none || !is_far() ? found_ : far_; }

 private:
  bool is_far() const { return far_positions_ >= min_far_positions && far_positions_ == positions_; }
  void judge_time(std::int64_t time_ns);
  void judge_speed(const FingerSample& sample);
  void judge_place(const PlatePoint& place);
  void judge_direction(const PlatePoint& place);
  void find(Implausible::Kind kind, double first, double second);

  static constexpr std::int64_t min_far_positions = 20;

  double radius_mm_ = 0.0;
  Reach reach_{};
  bool retargeted_ = false;
  Implausible found_, far_;
  std::optional<FingerSample> last_;  // last sample with a position
  std::int64_t positions_ = 0;
  std::int64_t far_positions_ = 0;
  int fast_positions_ = 0;                // in a row
  bool came_from_start_ = false;          // otherwise the finger may rest anywhere
  int wrong_positions_ = 0;               // in a row
  int turned_positions_ = 0;              // in a row
  std::optional<std::int64_t> first_ns_;  // time of the first counted sample
  int samples_ = 0;                       // within a millisecond of it
};

}  // namespace hrt::plugin
