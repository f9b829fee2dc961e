// The path that a person takes of their own accord, with statistics of recorded reaches. It is the direction of motion
// less the direction of the target, over the fraction s of the path, in degrees,
//
//   o(s) = a0 (1 - 2 s) + a1 (6 s^2 - 6 s + 1) + a2 ((1 - s)^8 - 1/9) + a3 (s^8 - 1/9)
//
// The mean of each shape over the path is 0, so the path returns to the line to the target. core/simulation/README.md
// has the sources.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "core/simulation/random.h"

namespace hrt {

/// a0 to a3, deg.
using PathShape = std::array<double, 4>;

/// A recorded reach, from start to stop.
struct RecordedReach {
  std::array<double, 21> direction_deg{};   ///< direction of motion minus that of the chord, at equal steps of the path
  std::array<double, 101> path_fraction{};  ///< fraction of the path at equal steps of the time
};

struct OwnPath {
  PathShape mean_deg{};          ///< mean for this person and target
  PathShape sd_deg{};            ///< SDs from reach to reach, independent of one another
  bool returns = true;           ///< false: o(s) fades to 0 before half of the path, and the deflection stays
  bool lags = false;             ///< false: the hand follows o(s) without lag; true: o(s) is part of the goal
  double log_duration_sd = 0.0;  ///< log SD of the duration of a reach
  /// Each reach takes the path and the pace of one of these; null: none. The means and SDs above then say what an
  /// informed controller knows.
  std::shared_ptr<const std::vector<RecordedReach>> recorded;

  bool any() const { return recorded || mean_deg != PathShape{} || sd_deg != PathShape{}; }
};

/// The own path of a person and target as recorded, with all angles times `size`.
OwnPath draw_own_path(double size, Draws& draws);

/// The own path of a person and target of whom these reaches were recorded; at least one.
OwnPath own_path_of(std::vector<RecordedReach> reaches);

/// The value at `fraction`, clamped to [0, 1], between values at equal steps.
template <std::size_t size>
double interpolated(const std::array<double, size>& values, double fraction) {
  const double at = std::clamp(fraction, 0.0, 1.0) * (size - 1);
  const std::size_t before = std::min(static_cast<std::size_t>(at), size - 2);
  const double share = at - static_cast<double>(before);
  return (1.0 - share) * values[before] + share * values[before + 1];
}

/// Habit of the mean path: its part along 1 - 2 s, by least squares over the path.
double mean_habit_deg(const OwnPath& path);

/// SD of o(s) from reach to reach, root mean square over the path.
double wander_sd_deg(const OwnPath& path);

/// The shape of one reach.
PathShape draw_shape(const OwnPath& path, Draws& draws);

/// o(s), for s clamped to [0, 1].
double own_direction_deg(const OwnPath& path, const PathShape& shape, double path_fraction);

/// The pace of one recorded reach: the speed is u^2 (1 - u)^b over the fraction u of the time, with the peak at
/// 2 / (2 + b); in a share of reaches another submovement follows, or the finger stops.
struct RecordedPace {
  double late_power = 3.6;  ///< b
  double first_part = 1.0;  ///< fraction of the path in the first submovement
  double stop_at = 2.0;     ///< fraction of the time in motion; above 1: it does not stop
  double time_scale = 1.0;  ///< duration of this reach over the person's

  /// s after `fraction` of the duration.
  double path_fraction(double fraction) const;
};
RecordedPace draw_pace(double log_duration_sd, Draws& draws);

/// Time from start to end over the time between the points of 5 % of the peak speed, relative to a minimum-jerk
/// motion: recorded motions have longer tails.
inline constexpr double recorded_tail_scale = 1.13;

}  // namespace hrt
