// Limits of the plate orientation by its stops, and the choice between orientations that have the same ridges: ridges
// repeat every half turn. Angles are in degrees. Uses no heap, lock or exception.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "core/math/elementary.h"

namespace hrt {

/// Range of orientations, at least 180 degrees wide, so that ridges can have any direction. Infinite: no stops.
struct PlateStops {
  double lower_deg = -std::numeric_limits<double>::infinity();
  double upper_deg = std::numeric_limits<double>::infinity();
};

bool is_valid(const PlateStops& stops);

double clamped(double orientation_deg, const PlateStops& stops);

/// The limit that determined an orientation. `lower`, `upper`: a bound relative to the goal or to the motion, or a
/// stop; `rate_down`, `rate_up`: the largest rotation in a step.
enum class ActiveBound : std::int8_t { none, lower, upper, rate_down, rate_up };

/// An orientation to command, and the limit that determined this orientation.
struct PlateOrientation {
  double orientation_deg = 0.0;
  ActiveBound active = ActiveBound::none;
  bool optimal = true;  ///< false: the solver reached its iteration limit
};

/// Returns the direction of the perceived ridge normal at `plate_orientation_deg`: of the normals, which repeat every
/// half turn, the one within 90 degrees of the goal (paper section III).
inline double ridge_normal_deg(double plate_orientation_deg, double goal_direction_deg) {
  const double offset_deg = plate_orientation_deg - goal_direction_deg;
  // A command at a bound of 90 may exceed 90 by rounding, and must not be folded to the opposite bound.
  if (std::abs(offset_deg) <= 90.0 + 1e-9) return plate_orientation_deg;
  return goal_direction_deg + wrap_deg(offset_deg, 180.0);
}

/// Returns the orientation nearest to `current_deg` among those within the stops with the same ridges as
/// `orientation_deg`.
double nearest_equivalent_deg(double orientation_deg, double current_deg, const PlateStops& stops);

/// Interprets a reported orientation. The encoder of a plate without stops may have added half turns; for such a plate,
/// returns the orientation with the same ridges nearest to `expected_deg`, otherwise `orientation_deg`.
double reported_orientation_deg(double orientation_deg, double expected_deg, const PlateStops& stops);

/// Returns the integer number of half turns that must be added to the range from `lowest_deg` to `highest_deg` so that
/// the range fits between the stops or is cut least by them. If several numbers are equally good, returns the one that
/// brings the range nearest to `current_deg`.
double half_turns_between_stops(double lowest_deg, double highest_deg, double current_deg, const PlateStops& stops);

/// Limits of the plate orientation in one reach.
class PlateLimits {
 public:
  /// Each command is the orientation nearest to the present one that has the planned ridges and is within the stops.
  PlateLimits(const PlateStops& stops, double goal_direction_deg);

  /// Keeps the plate within one half turn during the reach, so that the person does not feel a rotation by half a turn.
  /// The expected range of orientations begins 30 degrees nearer to the goal than `holding_deg`, the orientation that
  /// sustains the gap. It ends on the same side of the goal, `bound_deg` from the goal. Chooses the half turn in which
  /// the stops cut least off this range; of equally good half turns, the nearest to `current_deg`.
  PlateLimits(const PlateStops& stops, double goal_direction_deg, double bound_deg, double holding_deg,
              double current_deg);

  /// The goal direction plus the chosen half turns; plans are relative to this orientation.
  double centre_deg() const { return centre_deg_; }

  /// Rotates the goal by `by_deg` during the reach; the half turn is kept.
  void turn_goal(double by_deg) { centre_deg_ += by_deg; }

  /// Returns `planned`, clamped to the stops if the plate stays within one half turn.
  PlateOrientation at_stops(const PlateOrientation& planned) const;

  /// Returns at_stops(planned) if the plate stays within one half turn, otherwise nearest_equivalent_deg().
  PlateOrientation limit(const PlateOrientation& planned, double current_deg) const;

 private:
  PlateStops stops_;
  double centre_deg_;
  bool keeps_half_turn_;
};

}  // namespace hrt
