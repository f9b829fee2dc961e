// Parameters carried from one reach to the next of the same person.
#pragma once

#include "core/paper/estimator.h"
#include "core/person/person_belief.h"
#include "core/retargeter_config.h"

namespace hrt {

/// Largest SD of w_T that is carried.
inline constexpr double max_weight_sd = 0.49;

/// The configuration for the next reach, after one with `config` that has learnt `learnt`: w_T, the motor
/// variance and their deviations. The variance is clamped to a factor of 2; if clamped, its deviation is
/// unchanged.
RetargeterConfig carried(const RetargeterConfig& config, const FingerEstimate& learnt);

/// The configuration after a contact: of the frame, and, if the person `was_learnt` in reaches, of their
/// bias, which reaches show together with the frame's turn.
RetargeterConfig carried(const RetargeterConfig& config, const Contact& contact, bool was_learnt);

/// The belief for the next reach after one that began with `before`, ended with `learnt` and, if `missed`,
/// did not reach its target: without the reach's own deviation from the bias, by which the scatter is learnt;
/// wider, since people change, yet never wider than `unknown`. After a miss with an illusion far below what
/// was believed, the illusion is unknown again.
PersonBelief carried(const PersonBelief& before, const PersonBelief& learnt, bool missed, const PersonBelief& unknown,
                     const Tuning& tuning = {});

}  // namespace hrt
