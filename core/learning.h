// Parameters carried from one reach to the next of the same person.
#pragma once

#include "core/paper/estimator.h"
#include "core/person/person_belief.h"
#include "core/retargeter_config.h"

namespace hrt {

/// Largest SD of w_T that is carried.
inline constexpr double max_weight_sd = 0.49;

/// The configuration for the next reach, after one with `config` and the estimates `learnt`: w_T, the motor variance
/// and their SDs. The variance is clamped to a factor of 2; its SD is then unchanged.
RetargeterConfig carried(const RetargeterConfig& config, const FingerEstimate& learnt);

/// The configuration after a contact: correction of the frame, and of the person's bias if it `was_learnt` in reaches,
/// which show only its sum with the frame's rotation.
RetargeterConfig carried(const RetargeterConfig& config, const Contact& contact, bool was_learnt);

/// The belief for the next reach after one that began with `before`, ended with `learnt` and, if `missed`, did not
/// reach its target. The deviation of this reach from the person's bias is removed, and the scatter estimated from it.
/// The covariance grows, since people change, but never beyond `unknown`; the habit's variance is the mean square of
/// its error, although the reach began with steering_belief(). After a miss with an illusion far below the
/// former estimate, the illusion is unknown again.
PersonBelief carried(const PersonBelief& before, const PersonBelief& learnt, bool missed, const PersonBelief& unknown,
                     const Tuning& tuning = {});

}  // namespace hrt
