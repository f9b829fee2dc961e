#include "core/learning.h"

#include <algorithm>

namespace hrt {

RetargeterConfig carried(const RetargeterConfig& config, const FingerEstimate& learnt) {
  RetargeterConfig next = config;
  next.participant.tactile_weight = learnt.tactile_weight;
  next.estimator.tactile_weight_sd =
      std::clamp(learnt.tactile_weight_sd, least_carried_weight_sd, most_weight_sd);
  const double assumed_deg2 = config.participant.motor_variance_deg2;
  const double limited_deg2 = std::clamp(learnt.motor_variance_deg2, 0.5 * assumed_deg2, 2.0 * assumed_deg2);
  next.participant.motor_variance_deg2 =
      std::clamp(limited_deg2, Estimator::least_motor_variance_deg2, Estimator::most_motor_variance_deg2);
  // Far from what was assumed, the reach is surer than it can be.
  if (limited_deg2 == learnt.motor_variance_deg2)
    next.estimator.motor_variance_sd_deg2 =
        std::max(learnt.motor_variance_sd_deg2, least_carried_motor_variance_sd_deg2);
  return next;
}

}  // namespace hrt
