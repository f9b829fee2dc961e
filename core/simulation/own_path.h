// The own path of a simulated person: how the direction of the hand differs from that of the target, with the
// statistics of recorded reaches. In degrees, as a function of the fraction s of the path,
//
//   o(s) = a0 (1 - 2 s) + a1 (6 s^2 - 6 s + 1) + a2 ((1 - s)^8 - 1/9) + a3 (s^8 - 1/9)
//
// The mean of each term over the path is 0, so that the path ends on the line to the target. Sources: README.md.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "core/simulation/random.h"

namespace hrt {

/// Coefficients a0 to a3, deg.
using PathShape = std::array<double, 4>;

struct RecordedReach {
  std::array<double, 21> direction_deg{};   ///< direction of motion minus that of the chord at equal steps of the path
  std::array<double, 101> path_fraction{};  ///< fraction of the path at equal steps of the time
};

struct OwnPath {
  PathShape mean_deg{};  ///< mean for this person and target
  PathShape sd_deg{};    ///< SDs from reach to reach; the coefficients are independent
  bool returns = true;   ///< false: o(s) fades to 0 between 0.4 and 0.5 of the path, so that the path does not return
  bool lags = false;     ///< false: the hand follows o(s) without delay; true: o(s) is added to the goal of steering
  double log_duration_sd = 0.0;  ///< SD of the log of the duration from reach to reach
  /// Recordings; each reach uses path and pace of one of them. Null: no recordings, and o(s) is drawn. For informed
  /// controllers, mean_deg and sd_deg describe the recordings.
  std::shared_ptr<const std::vector<RecordedReach>> recorded;

  bool any() const { return recorded || mean_deg != PathShape{} || sd_deg != PathShape{}; }
};

/// Draws an own path from the statistics of the recorded people; all angles are multiplied by `size`.
OwnPath draw_own_path(double size, Draws& draws);

/// Returns an own path that replays recordings of one person and target. Requires at least one.
OwnPath own_path_of(std::vector<RecordedReach> reaches);

/// Interpolates linearly between values at equal steps. `fraction` is clamped to [0, 1].
template <std::size_t size>
double interpolated(const std::array<double, size>& values, double fraction) {
  const double at = std::clamp(fraction, 0.0, 1.0) * (size - 1);
  const std::size_t before = std::min(static_cast<std::size_t>(at), size - 2);
  const double share = at - static_cast<double>(before);
  return (1.0 - share) * values[before] + share * values[before + 1];
}

/// Returns the habit of the mean path: its component along 1 - 2 s, by least squares over the path.
double mean_habit_deg(const OwnPath& path);

/// Returns the SD of o(s) from reach to reach, as root mean square over the path, for a path that returns.
double wander_sd_deg(const OwnPath& path);

PathShape draw_shape(const OwnPath& path, Draws& draws);

/// Returns o(s), for s clamped to [0, 1].
double own_direction_deg(const OwnPath& path, const PathShape& shape, double path_fraction);

/// Pace of one reach with the statistics of recorded reaches. Without a second submovement or a stop, the speed is
/// proportional to u^2 (1 - u)^b over the fraction u of the time, with its maximum at 2 / (2 + b).
struct RecordedPace {
  double late_power = 3.6;  ///< b
  double first_part = 1.0;  ///< fraction of the path in the first submovement; 1: there is no second
  /// fraction of the time in motion after which the finger stops once; 1 or more: it does not stop
  double stop_at = 2.0;
  double time_scale = 1.0;  ///< factor of Person::duration_s in this reach

  /// Returns the fraction of the path after `fraction` of the duration.
  double path_fraction(double fraction) const;
};
RecordedPace draw_pace(double log_duration_sd, Draws& draws);

/// Additional factor of the duration of a pace from draw_pace(), so that the time between the points of 5 % of the peak
/// speed is about that of a minimum-jerk motion: recorded motions end more slowly.
inline constexpr double recorded_tail_scale = 1.13;

}  // namespace hrt
