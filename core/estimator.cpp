#include "core/estimator.h"

#include <cmath>

#include "core/trigonometry.h"

namespace hrt {

double bearing_deg(const PlatePoint& from, const PlatePoint& to) {
  return atan2_deg(from.right_m - to.right_m, to.away_m - from.away_m);
}

double distance_m(const PlatePoint& from, const PlatePoint& to) {
  const double right_m = to.right_m - from.right_m;
  const double away_m = to.away_m - from.away_m;
  return std::sqrt(right_m * right_m + away_m * away_m);
}

void Estimator::observe(const FingerSample& sample) {
  switch (sample.observation) {
    case Observation::none:
      return;
    case Observation::direction:
      observed_direction_deg_ = sample.direction_deg;
      if (!motion_start_ns_) motion_start_ns_ = step_start_ns_ = sample.time_ns;
      return;
    case Observation::position:
      if (!motion_start_ns_) {
        if (!rest_) rest_ = sample.position;
        if (distance_m(*rest_, sample.position) >= least_travel_m) {
          // After a gap nobody knows when the motion started: it starts now.
          const bool seen_at_rest = elapsed_ns(position_ns_, sample.time_ns) < step_period_ns_;
          motion_start_ns_ = step_start_ns_ = seen_at_rest ? position_ns_ : sample.time_ns;
          step_base_ = seen_at_rest ? position_ : sample.position;
        }
      } else if (!step_base_) {
        step_base_ = sample.position;
      }
      position_ = sample.position;
      position_ns_ = sample.time_ns;
      return;
  }
}

void Estimator::begin_step(std::int64_t time_ns) {
  step_start_ns_ = time_ns;
  observed_direction_deg_.reset();
  step_base_.reset();
}

std::optional<double> Estimator::direction_deg() const {
  if (observed_direction_deg_) return observed_direction_deg_;
  const bool enough = motion_start_ns_ && step_base_ &&
                      elapsed_ns(step_start_ns_, position_ns_) >= step_period_ns_ / 2 &&
                      distance_m(*step_base_, *position_) >= least_travel_m;
  if (!enough) return std::nullopt;
  return bearing_deg(*step_base_, *position_);
}

}  // namespace hrt
