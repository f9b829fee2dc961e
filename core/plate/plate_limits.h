// Limits of the plate orientation: its stops, the half turns by which ridges repeat, and the bound that holds a
// command. Degrees. Uses no heap, lock or exception.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "core/math/trigonometry.h"

namespace hrt {

/// Between which orientations the plate turns, from the mid-line; infinite: it turns freely. At least 180
/// apart, so that every direction of ridges can be had.
struct PlateStops {
  double lower_deg = -std::numeric_limits<double>::infinity();
  double upper_deg = std::numeric_limits<double>::infinity();
};

/// True if every field is in its range.
bool is_valid(const PlateStops& stops);

/// Limits an orientation to the stops.
double clamped(double orientation_deg, const PlateStops& stops);

/// The limit that holds an orientation: a bound about the virtual direction, a stop, or the rate bound.
enum class ActiveBound : std::int8_t { none, lower, upper, rate_down, rate_up };

/// An orientation for the plate, and the limit that holds it.
struct PlateOrientation {
  double orientation_deg = 0.0;
  ActiveBound active = ActiveBound::none;
  bool optimal = true;  ///< false: the solver's work was cut short
};

/// Direction of the perceived ridge normal at `plate_orientation_deg`: of the normals that repeat every half turn, the
/// one within 90 of the goal (paper section III).
inline double ridge_normal_deg(double plate_orientation_deg, double goal_direction_deg) {
  const double offset_deg = plate_orientation_deg - goal_direction_deg;
  // A command on a bound of 90 may be a rounding error beyond it; it must not turn into the other bound.
  if (std::abs(offset_deg) <= 90.0 + 1e-9) return plate_orientation_deg;
  return goal_direction_deg + wrap_deg(offset_deg, 180.0);
}

/// The orientation nearest to `current_deg` of those within the stops that have the same ridges as `orientation_deg`.
double nearest_equivalent_deg(double orientation_deg, double current_deg, const PlateStops& stops);

/// `orientation_deg` as an encoder counts it that may be any number of half turns off, if the plate turns
/// freely: the one nearest to `expected_deg`. Between stops the encoder is right.
double reported_orientation_deg(double orientation_deg, double expected_deg, const PlateStops& stops);

/// Half turns to add so that the range from `lowest_deg` to `highest_deg` fits between the stops, or is cut
/// the least, without a swing of half a turn within it. Of equal ones those nearest to `current_deg`. A whole
/// number.
double half_turns_between_stops(double lowest_deg, double highest_deg, double current_deg, const PlateStops& stops);

/// The limits of one reach.
class PlateLimits {
 public:
  /// Limits of a plate without a bound on its speed: each command is the nearest orientation with the same ridges.
  PlateLimits(const PlateStops& stops, double goal_direction_deg);

  /// A plate that takes time to turn keeps to one half turn for the reach, so that no swing is felt on the
  /// way: the one in which the stops leave most of the orientations from 30 short of `holding_deg`, which
  /// holds the real direction, to `bound_deg` from the goal beyond it. Of several, the nearest to
  /// `current_deg`.
  PlateLimits(const PlateStops& stops, double goal_direction_deg, double bound_deg, double holding_deg,
              double current_deg);

  /// The goal in the half turn that the plate keeps to: orientations are planned about it.
  double centre_deg() const { return centre_deg_; }

  /// The goal turns within the reach; the half turn stays.
  void turn_goal(double by_deg) { centre_deg_ += by_deg; }

  /// `planned` held at a stop, if the plate keeps to one half turn.
  PlateOrientation at_stops(const PlateOrientation& planned) const;

  /// at_stops(), or else the equivalent of `planned` that is nearest to `current_deg`.
  PlateOrientation limit(const PlateOrientation& planned, double current_deg) const;

 private:
  PlateStops stops_;
  double centre_deg_;
  bool keeps_half_turn_;
};

}  // namespace hrt
