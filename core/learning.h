// Updates the parameters of a person and of the tracker's frame from one reach to the next.
#pragma once

#include "core/paper/estimator.h"
#include "core/person/person_belief.h"
#include "core/retargeter_config.h"

namespace hrt {

/// Upper bound of the SD of w_T.
inline constexpr double max_weight_sd = 0.49;

/// Returns the configuration for the next reach, after a reach under the paper's controller: w_T, the motor variance
/// and their SDs are set to the estimates `learnt`. The variance changes by a factor of at most 2; if this limit
/// applies, its SD is unchanged.
RetargeterConfig carried(const RetargeterConfig& config, const FingerEstimate& learnt);

/// Returns the configuration after a contact, with the new correction of the tracker's frame. If the bias has been
/// estimated from reaches (`was_learnt`), it contains the frame's rotation, since reaches show only the sum of the two;
/// it is then corrected too.
RetargeterConfig carried(const RetargeterConfig& config, const Contact& contact, bool was_learnt);

/// Returns the prior for the next reach. `before` is the prior of this reach, `learnt` its posterior, and `missed` is
/// true if it did not end at its target. The deviations of bias and habit in this reach are removed, and the scatter is
/// updated from that of the bias. The covariance grows, since people change, up to that of `unknown`. The variance of
/// the habit is corrected for the narrower prior of the reach, steering_belief(). If the reach missed and the weight is
/// far below its former estimate, the illusion is reset to `unknown`.
PersonBelief carried(const PersonBelief& before, const PersonBelief& learnt, bool missed, const PersonBelief& unknown,
                     const Tuning& tuning = {});

}  // namespace hrt
