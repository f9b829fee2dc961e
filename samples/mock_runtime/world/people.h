// Simulated participants, drawn from a seed and the settings of a script.
#pragma once

#include <optional>
#include <vector>

#include "core/simulation/person.h"

namespace hrt::mock {

/// Bounds of a uniform draw; equal bounds fix the value.
struct Range {
  double min;
  double max;
};

/// Ranges from which a participant is drawn. The defaults give participants with a natural pace.
struct PersonSettings {
  std::vector<IllusionFamily> illusions = {IllusionFamily::linear, IllusionFamily::saturating, IllusionFamily::sine,
                                           IllusionFamily::tanh};
  std::optional<Range> illusion_scale_deg;  ///< unset: depends on the illusion
  Range tactile_weight = {0.12, 0.30};      ///< w_T, in (0, 0.5)
  Range weight_drift = {0.0, 0.0};
  std::vector<Steering> steerings = {Steering::continuous, Steering::predictive};
  Range gain_per_s = {5.0, 12.0};
  Range delay_s = {0.0, 0.12};  ///< at most 0.25
  Range noise_deg2_per_s = {8.0, 8.0};
  std::optional<Range> start_direction_deg;  ///< unset: between the mid-line and the virtual target
  Range bias_deg = {0.0, 0.0};
  Range own_bias_deg = {0.0, 0.0};
  Range habit_deg = {-3.0, 3.0};
  std::vector<Pace> paces = {Pace::minimum_jerk, Pace::skewed};
  Range duration_s = {1.0, 2.0};
  Range path_scale = {1.0, 1.0};
  Range reaction_s = {0.3, 0.7};  ///< from the instruction to the motion
};

/// Participant of paper section II-A: steps of 100 ms, first along the mid-line, with an even pace of 3 s.
PersonSettings paper_person();

struct DrawnPerson {
  Person person;             ///< start_direction_deg is that for a virtual target on the mid-line
  double start_share = 0.0;  ///< fraction of the virtual target's direction that is added to it
  std::int64_t reaction_ns = 0;

  Person towards(double virtual_direction_deg) const;
};

/// Draws participant `number` of a seed. Each trait has its own draw: fixing one does not change the others.
DrawnPerson draw(const PersonSettings& settings, std::uint64_t seed, std::uint32_t number);

/// Noise stream of reach `number`.
Draws noise_of_reach(std::uint64_t seed, std::uint32_t number);

}  // namespace hrt::mock
