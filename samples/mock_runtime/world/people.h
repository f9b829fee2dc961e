// Simulated participants, drawn at random from ranges that a script sets.
#pragma once

#include <optional>
#include <vector>

#include "core/simulation/person.h"

namespace hrt::mock {

/// Bounds of a uniform distribution; equal bounds fix the value.
struct Range {
  double min;
  double max;
};

/// Distributions from which a participant is drawn: elements of a list have equal probability. SCRIPTS.md describes the
/// fields.
struct PersonSettings {
  std::vector<IllusionFamily> illusions = {IllusionFamily::linear, IllusionFamily::saturating, IllusionFamily::sine,
                                           IllusionFamily::tanh};
  std::optional<Range> illusion_scale_deg;  ///< unset: usual_scale_deg() in people.cpp
  Range tactile_weight = {0.12, 0.30};      ///< w_T, in (0, 0.5)
  Range weight_drift = {0.0, 0.0};
  std::vector<Steering> steerings = {Steering::continuous, Steering::predictive};
  Range gain_per_s = {5.0, 12.0};
  Range delay_s = {0.0, 0.12};  ///< at most 0.25
  Range noise_deg2_per_s = {8.0, 8.0};
  std::optional<Range> start_direction_deg;  ///< unset: between mid-line and virtual target, plus noise of SD 1
  Range bias_deg = {0.0, 0.0};
  Range own_bias_deg = {0.0, 0.0};
  Range habit_deg = {-3.0, 3.0};
  std::vector<Pace> paces = {Pace::minimum_jerk, Pace::skewed};
  Range duration_s = {1.0, 2.0};
  Range path_scale = {1.0, 1.0};
  Range reaction_s = {0.3, 0.7};  ///< from the instruction to the motion
};

/// The participant of the paper's section II-A: steers in steps of 100 ms, starts along the mid-line, and moves for 3 s
/// at a constant speed.
PersonSettings paper_person();

struct DrawnPerson {
  Person person;                ///< with the start direction for a virtual target on the mid-line
  double start_fraction = 0.0;  ///< fraction of the virtual target's direction that is added to the start direction
  std::int64_t reaction_ns = 0;

  Person towards(double virtual_direction_deg) const;
};

/// Draws participant `number` of a seed. Fixing one field in the script does not change the draws of the others.
DrawnPerson draw(const PersonSettings& settings, std::uint64_t seed, std::uint32_t number);

Draws noise_of_reach(std::uint64_t seed, std::uint32_t number);

}  // namespace hrt::mock
