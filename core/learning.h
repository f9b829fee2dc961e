// Updates the parameters of a person and of the tracker's frame from one reach to the next.
#pragma once

#include "core/paper/estimator.h"
#include "core/person/person_belief.h"
#include "core/retargeter_config.h"

namespace hrt {

/// Upper bound of the SD of w_T.
inline constexpr double max_weight_sd = 0.49;

/// Returns the configuration for the next reach, after a reach under the paper's controller: w_T, the motor variance
/// and their SDs are set to the estimates `learnt`. The variance changes by a factor of 2 at most, its SD then not at
/// all.
RetargeterConfig carried(const RetargeterConfig& config, const FingerEstimate& learnt);

/// Returns the configuration after a contact: the correction of the tracker's frame, and the person's bias. Reaches
/// show only the sum of the bias and the frame's rotation; `was_learnt`: the bias has been estimated from reaches.
RetargeterConfig carried(const RetargeterConfig& config, const Contact& contact, bool was_learnt);

/// Returns the prior for the next reach. `before` is the prior of this reach, `learnt` its posterior, and `missed` is
/// true if it did not end at its target. The deviations of bias and habit in this reach are removed, and the scatter is
/// updated from that of the bias. The covariance grows, since people change, up to that of `unknown`. The variance of
/// the habit is the mean square of its error, although the reach began with steering_belief(). If the reach missed and
/// the weight is far below its former estimate, the illusion is reset to `unknown`.
PersonBelief carried(const PersonBelief& before, const PersonBelief& learnt, bool missed, const PersonBelief& unknown,
                     const Tuning& tuning = {});

}  // namespace hrt
