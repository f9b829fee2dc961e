// States of the person filter, one row each. The first `traits` states describe a person and are carried from reach to
// reach; HRT_PERSON_WEIGHT to HRT_PERSON_LOG_WANDER in session.h are their indices in the C interface.
#pragma once

#include <limits>

namespace hrt {

struct PersonState {
  enum Index {
    weight,    ///< w of the illusion
    curve,     ///< b of the illusion
    gain,      ///< k: rate at which a perceived-direction error is corrected
    bias,      ///< B: goal minus virtual direction
    habit,     ///< c: regular part of the own path's direction, from +c at the start to -c at the end
    evenness,  ///< a of the pace
    log_rate,  ///< rho: natural logarithm of one over the duration in seconds
    fading,    ///< f of the illusion
    /// Number of the traits above, which enter the equations of motion. The next two are parameters of the filter.
    felt_traits,
    scatter = felt_traits,  ///< SD of the bias from reach to reach
    log_wander,             ///< natural logarithm of the SD of the wander in degrees
    traits,                 ///< number of traits
    right = traits,         ///< position of the finger relative to the rest position
    away,
    steered,       ///< psi: direction that the person steers, without the own path
    phase,         ///< u: fraction of the duration
    wander,        ///< omega: random part of the own path's direction
    displacement,  ///< y: lateral displacement that the wander has caused, left positive
    noise_right,   ///< correlated noise of the tracker
    noise_away,
    count
  };
};

struct StateVariable {
  PersonState::Index index;
  const char* name;
  const char* unit;
  double min, max;  ///< range of the estimate
};

inline constexpr double unlimited = std::numeric_limits<double>::infinity();

inline constexpr StateVariable person_state[PersonState::count] = {
    {PersonState::weight, "weight", "", 0.01, 0.6},
    {PersonState::curve, "curve", "", -0.1, 0.5},
    {PersonState::gain, "gain", "per_s", 3.0, 20.0},
    {PersonState::bias, "bias", "deg", -90.0, 90.0},
    {PersonState::habit, "habit", "deg", -45.0, 45.0},
    {PersonState::evenness, "evenness", "", 0.0, 1.0},
    {PersonState::log_rate, "log_rate", "", -3.0, 2.4},
    {PersonState::fading, "fading", "", -0.2, 1.0},
    {PersonState::scatter, "scatter", "deg", 0.0, 10.0},
    {PersonState::log_wander, "log_wander", "", -1.5, 3.0},
    {PersonState::right, "right", "mm", -unlimited, unlimited},
    {PersonState::away, "away", "mm", -unlimited, unlimited},
    {PersonState::steered, "steered", "deg", -3600.0, 3600.0},
    {PersonState::phase, "phase", "", 0.0, 1.0},
    {PersonState::wander, "wander", "deg", -360.0, 360.0},
    {PersonState::displacement, "displacement", "mm", -10000.0, 10000.0},
    {PersonState::noise_right, "noise_right", "mm", -unlimited, unlimited},
    {PersonState::noise_away, "noise_away", "mm", -unlimited, unlimited},
};

constexpr bool rows_are_in_order() {
  for (int i = 0; i < PersonState::count; ++i)
    if (person_state[i].index != i) return false;
  return true;
}
static_assert(rows_are_in_order());

}  // namespace hrt
