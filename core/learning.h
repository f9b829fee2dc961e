// What one reach leaves for the next reach of the same person.
#pragma once

#include "core/estimator.h"
#include "core/person_belief.h"
#include "core/retargeter.h"

namespace hrt {

/// People change: what is carried is never surer than this.
inline constexpr double least_carried_weight_sd = 0.01;
inline constexpr double least_carried_motor_variance_sd_deg2 = 0.1;
/// Nor less sure of w_T.
inline constexpr double most_weight_sd = 0.49;

/// The configuration for the next reach, after one with `config` that has learnt `learnt`: w_T, the motor
/// variance and their deviations. The variance is clamped to a factor of 2; if clamped, its deviation is
/// unchanged.
RetargeterConfig carried(const RetargeterConfig& config, const FingerEstimate& learnt);

/// What the next reach begins with after one that ended with `learnt`: people change, so it is wider, yet
/// never wider than `unknown`.
PersonBelief carried(const PersonBelief& learnt, const PersonBelief& unknown);

}  // namespace hrt
