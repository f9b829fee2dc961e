// Updates the parameters of a person and of the tracker's frame from one reach to the next.
#pragma once

#include "core/paper/estimator.h"
#include "core/person/person_belief.h"
#include "core/retargeter_config.h"

namespace hrt {

/// Upper bound of the SD of w_T after a reach.
inline constexpr double max_weight_sd = 0.49;

/// Returns the configuration for the next reach, after a reach under the paper's controller: w_T, the motor variance
/// and their SDs are set to the estimates `learnt`, within bounds. The motor variance changes by a factor of at most 2;
/// if this limit applies, the SD of the motor variance is unchanged.
RetargeterConfig carried(const RetargeterConfig& config, const FingerEstimate& learnt);

/// Returns the configuration after a contact, with the new correction of the tracker's frame. If the bias has been
/// estimated from reaches (`was_learnt`), it contains the frame's rotation (touched_frame.h), and is corrected too.
RetargeterConfig carried(const RetargeterConfig& config, const Contact& contact, bool was_learnt);

/// Returns the prior for the next reach. `before` and `learnt` are prior and posterior of the last reach; `missed`:
/// true if the last reach did not end at its target. Deviations of bias and habit that belong to the last reach alone
/// are removed, and the deviation of the bias updates the scatter. The variance of the habit is corrected for the
/// narrower prior with which a reach begins, steering_belief(). Since people change, variances grow, and a part of the
/// information from reaches is replaced by that of the prior `unknown` (Tuning::traits). If `missed`, and the weight
/// has dropped far below its former estimate, the illusion is that of `unknown`.
PersonBelief carried(const PersonBelief& before, const PersonBelief& learnt, bool missed, const PersonBelief& unknown,
                     const Tuning& tuning = {});

}  // namespace hrt
