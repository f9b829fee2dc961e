// Updates the parameters of a person and of the tracker's frame from one reach to the next.
#pragma once

#include "core/paper/estimator.h"
#include "core/person/person_belief.h"
#include "core/retargeter_config.h"

namespace hrt {

/// Largest SD of the tactile weight that carried() returns for the paper's controller.
inline constexpr double max_weight_sd = 0.49;

/// Returns the configuration for the next reach, after a reach under the paper's controller with the estimates `learnt`
/// of the tactile weight, the motor variance and their SDs. The SDs and the motor variance are clamped to their ranges.
/// The motor variance changes by a factor of at most 2; if this limit applies, its SD is unchanged.
RetargeterConfig carried(const RetargeterConfig& config, const FingerEstimate& learnt);

/// Returns the configuration after a contact, with the new correction of the tracker's frame. A bias that was estimated
/// from reaches (`was_learnt`) contains the frame's rotation (touched_frame.h), and is corrected too.
RetargeterConfig carried(const RetargeterConfig& config, const Contact& contact, bool was_learnt);

/// Returns the prior for the next reach under the controller for people. `before` and `learnt` are prior and posterior
/// of the last reach. Bias and habit differ from reach to reach: the expected differences of the last reach from the
/// person's mean are subtracted, and that of the bias updates the scatter. The variance of the habit is corrected for
/// the narrower prior with which a reach begins, steering_belief(). Since people change, variances grow, and a part of
/// the information from reaches is replaced by that of the prior `unknown` (Tuning::traits). If the last reach did not
/// end at its target (`missed`) and the weight has dropped far below `before`, the illusion is that of `unknown`.
PersonBelief carried(const PersonBelief& before, const PersonBelief& learnt, bool missed, const PersonBelief& unknown,
                     const Tuning& tuning = {});

}  // namespace hrt
