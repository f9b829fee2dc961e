// States of the person filter, one row each. The first ones are the traits of a person, which hold for every reach;
// their indices in the C interface are HRT_PERSON_ and the name.
#pragma once

namespace hrt {

struct PersonState {
  enum Index {
    weight,       ///< w of the illusion
    curve,        ///< b of the illusion
    gain,         ///< k: rate at which the perceived error is corrected
    bias,         ///< B: goal minus virtual direction
    habit,        ///< c: the goal turns from +c to -c along the path
    evenness,     ///< a of the pace
    log_rate,     ///< rho: natural logarithm of one over the duration in seconds
    fading,       ///< f of the illusion
    felt_traits,  ///< number of the above: those that move the finger; the next ones are parameters of the filter
    scatter = felt_traits,  ///< SD of the bias from reach to reach
    log_wander,             ///< natural logarithm of the SD of the wander in degrees
    traits,                 ///< number of the above
    right = traits,         ///< position of the finger, relative to its rest
    away,
    steered,      ///< psi: direction of motion without the own path
    phase,        ///< u: fraction of the duration
    wander,       ///< dr: fast part of the own path
    strayed,      ///< y: lateral distance from the line due to the wander, left positive
    noise_right,  ///< the tracker's correlated noise
    noise_away,
    count
  };
};

struct StateVariable {
  PersonState::Index index;
  const char* name;
  const char* unit;
  double min, max;  ///< an estimate is kept in this range; min = max: no range
};

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
    {PersonState::right, "right", "mm", 0.0, 0.0},
    {PersonState::away, "away", "mm", 0.0, 0.0},
    {PersonState::steered, "steered", "deg", 0.0, 0.0},
    {PersonState::phase, "phase", "", 0.0, 1.0},
    {PersonState::wander, "wander", "deg", 0.0, 0.0},
    {PersonState::strayed, "strayed", "mm", 0.0, 0.0},
    {PersonState::noise_right, "noise_right", "mm", 0.0, 0.0},
    {PersonState::noise_away, "noise_away", "mm", 0.0, 0.0},
};

constexpr bool rows_are_in_order() {
  for (int i = 0; i < PersonState::count; ++i)
    if (person_state[i].index != i) return false;
  return true;
}
static_assert(rows_are_in_order());

}  // namespace hrt
