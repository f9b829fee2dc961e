// The paper's numbers as printed: "Controlling Hand Movements relying on Tactile
// Illusions: A Model Predictive Control Framework".
#pragma once

#include <array>

#include "core/paper_simulation/trial.h"

namespace hrt::study {

/// Number of trials behind each percentage of the paper.
inline constexpr double paper_trials = 50;

/// One row of Table I: the percentage of trials that end within 1.5 degrees of the real target.
struct PaperCell {
  double real_direction_deg;
  double virtual_direction_deg;
  double percent;
};

/// One block of Table I.
struct PaperCondition {
  double motor_variance_deg2;
  double tactile_weight;
  double mean_percent;  ///< from the text of the paper
  double sd_percent;    ///< SD over the six pairs, from the text of the paper
  std::array<PaperCell, 6> cells;
};

inline constexpr std::array<PaperCondition, 4> paper_table1{{
    {0.5, 0.15, 93.0, 3.3, {{{-5, 5, 94}, {5, -5, 96}, {0, 10, 90}, {-10, 0, 94}, {10, 0, 96}, {0, -10, 88}}}},
    {0.5, 0.10, 82.7, 3.0, {{{-5, 5, 82}, {5, -5, 80}, {0, 10, 80}, {-10, 0, 82}, {10, 0, 88}, {0, -10, 84}}}},
    {1.0, 0.15, 81.3, 3.0, {{{-5, 5, 78}, {5, -5, 84}, {0, 10, 78}, {-10, 0, 80}, {10, 0, 82}, {0, -10, 86}}}},
    // 79 % of 50 trials are 39.5 trials; the printed value is used.
    {1.0, 0.10, 77.8, 3.5, {{{-5, 5, 76}, {5, -5, 72}, {0, 10, 80}, {-10, 0, 82}, {10, 0, 78}, {0, -10, 79}}}},
}};

/// Mean percentage of the six pairs with w_T = 0.05, of section III-B.
inline constexpr double paper_impaired_touch_percent = 40;
/// Percentage with a real target at 0, a virtual one at 12 degrees and a motor variance of 2 (section III-B, Fig. 7).
inline constexpr double paper_wide_gap_percent = 60;

/// Returns a condition with these values, which the controller knows.
inline Condition make_condition(double motor_variance_deg2, double tactile_weight, double real_direction_deg,
                                double virtual_direction_deg) {
  Condition condition{.real_direction_deg = real_direction_deg, .virtual_direction_deg = virtual_direction_deg};
  condition.participant.motor_variance_deg2 = motor_variance_deg2;
  condition.participant.tactile_weight = tactile_weight;
  condition.controller.participant = condition.participant;
  return condition;
}

}  // namespace hrt::study
