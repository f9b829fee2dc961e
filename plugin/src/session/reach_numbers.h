// The numbers of what a reach returns, in the order of the structs.
#pragma once

#include <array>

#include "haptic_retargeting/reach.h"

namespace hrt::plugin {

/// Also the order of a recording's columns and of hrt_replay_report::hash.
inline constexpr auto command_numbers = [] {
  using C = hrt_command;
  return std::array{&C::plate_orientation_deg, &C::finger_direction_deg,  &C::perceived_direction_deg,
                    &C::aimed_direction_deg,   &C::distance_to_go_m,      &C::tactile_weight,
                    &C::tactile_weight_sd,     &C::time_to_go_s,          &C::felt_error_deg,
                    &C::predicted_miss_deg,    &C::normalised_innovation, &C::bearing_error_sd_deg};
}();
static_assert(sizeof(hrt_command) == 16 + sizeof(double) * command_numbers.size());

inline constexpr auto summary_numbers = [] {
  using S = hrt_reach_summary;
  return std::array{&S::final_direction_deg,
                    &S::final_miss_deg,
                    &S::perceived_direction_deg,
                    &S::perceived_error_deg,
                    &S::distance_to_target_m,
                    &S::tactile_weight,
                    &S::tactile_weight_sd,
                    &S::tracker_noise_m,
                    &S::motor_variance_deg2,
                    &S::motor_variance_sd_deg2,
                    &S::bearing_error_deg,
                    &S::peak_felt_error_deg,
                    &S::rms_felt_error_deg,
                    &S::normalised_innovation,
                    &S::illusion_curve,
                    &S::illusion_curve_sd,
                    &S::gain_per_s,
                    &S::gain_sd_per_s,
                    &S::bias_deg,
                    &S::bias_sd_deg,
                    &S::habit_deg,
                    &S::habit_sd_deg,
                    &S::duration_s,
                    &S::bearing_error_sd_deg};
}();
static_assert(sizeof(hrt_reach_summary) == 56 + sizeof(double) * summary_numbers.size());

}  // namespace hrt::plugin
