#include "core/plate/plate_limits.h"

#include <algorithm>
#include <cmath>

namespace hrt {
namespace {

// Most planned orientations are at most this much nearer to the goal than holding_deg.
constexpr double play_deg = 30.0;

// Chooses the half turn for PlateLimits. On the side of holding_deg away from the goal, the range reaches to the bound,
// since the first steps may require any orientation there.
double half_turns_for_reach(const PlateStops& stops, double goal_deg, double bound_deg, double holding_deg,
                            double current_deg) {
  const double lowest_deg = holding_deg < goal_deg ? goal_deg - bound_deg : holding_deg - play_deg;
  const double highest_deg = holding_deg > goal_deg ? goal_deg + bound_deg : holding_deg + play_deg;
  return half_turns_between_stops(std::max(lowest_deg, goal_deg - bound_deg),
                                  std::min(highest_deg, goal_deg + bound_deg), current_deg, stops);
}

}  // namespace

bool is_valid(const PlateStops& stops) {
  return !std::isnan(stops.lower_deg) && stops.upper_deg - stops.lower_deg >= 180.0;
}

double clamped(double orientation_deg, const PlateStops& stops) {
  return std::clamp(orientation_deg, stops.lower_deg, stops.upper_deg);
}

double nearest_equivalent_deg(double orientation_deg, double current_deg, const PlateStops& stops) {
  double half_turns = std::floor((current_deg - orientation_deg) / 180.0 + 0.5);
  if (orientation_deg + 180.0 * half_turns > stops.upper_deg) {
    half_turns = std::floor((stops.upper_deg - orientation_deg) / 180.0);
  }
  if (orientation_deg + 180.0 * half_turns < stops.lower_deg) {
    half_turns = std::ceil((stops.lower_deg - orientation_deg) / 180.0);
  }
  return orientation_deg + 180.0 * half_turns;
}

double reported_orientation_deg(double orientation_deg, double expected_deg, const PlateStops& stops) {
  const bool turns_freely = std::isinf(stops.lower_deg) && std::isinf(stops.upper_deg);
  return turns_freely ? nearest_equivalent_deg(orientation_deg, expected_deg, stops) : orientation_deg;
}

double half_turns_between_stops(double lowest_deg, double highest_deg, double current_deg, const PlateStops& stops) {
  const double nearest = std::floor((current_deg - 0.5 * (lowest_deg + highest_deg)) / 180.0 + 0.5);
  const double fewest = std::ceil((stops.lower_deg - lowest_deg) / 180.0);
  const double max = std::floor((stops.upper_deg - highest_deg) / 180.0);
  if (fewest <= max) return std::clamp(nearest, fewest, max);
  const double cut_below_deg = stops.lower_deg - (lowest_deg + 180.0 * max);
  const double cut_above_deg = highest_deg + 180.0 * fewest - stops.upper_deg;
  if (cut_below_deg == cut_above_deg) return std::clamp(nearest, max, fewest);
  return cut_below_deg < cut_above_deg ? max : fewest;
}

PlateLimits::PlateLimits(const PlateStops& stops, double goal_direction_deg)
    : stops_(stops), centre_deg_(goal_direction_deg), keeps_half_turn_(false) {}

PlateLimits::PlateLimits(const PlateStops& stops, double goal_direction_deg, double bound_deg, double holding_deg,
                         double current_deg)
    : stops_(stops),
      centre_deg_(goal_direction_deg +
                  180.0 * half_turns_for_reach(stops, goal_direction_deg, bound_deg, holding_deg, current_deg)),
      keeps_half_turn_(true) {}

PlateOrientation PlateLimits::at_stops(const PlateOrientation& planned) const {
  if (!keeps_half_turn_) return planned;
  if (planned.orientation_deg < stops_.lower_deg) return {stops_.lower_deg, ActiveBound::lower, planned.optimal};
  if (planned.orientation_deg > stops_.upper_deg) return {stops_.upper_deg, ActiveBound::upper, planned.optimal};
  return planned;
}

PlateOrientation PlateLimits::limit(const PlateOrientation& planned, double current_deg) const {
  if (keeps_half_turn_) return at_stops(planned);
  return {nearest_equivalent_deg(planned.orientation_deg, current_deg, stops_), planned.active, planned.optimal};
}

}  // namespace hrt
