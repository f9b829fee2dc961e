// The controller of paper section III for a plate that takes time: the optimum over a short window, from the
// first step that a command given now can still change.
#pragma once

#include <cstdint>

#include "core/paper/mpc.h"
#include "core/paper/reach_estimator.h"
#include "core/plate/plate_limits.h"
#include "core/plate/plate_model.h"

namespace hrt {

/// Plans one reach. No heap, no lock, no exception. One thread at a time.
class PaperControl {
 public:
  /// A turn within a step is bounded by `plate` as well as by `config`. Requires valid arguments,
  /// a latency of at most `max_lead` steps.
  PaperControl(const MpcConfig& config, const PlateDynamics& plate, std::int64_t step_period_ns,
               double goal_direction_deg);

  /// The orientation that the finger shall feel at the end of the first step that a command given now can
  /// change, planned about `centre_deg`, which feels like the goal. Steps before it end with `plate` as it is
  /// already commanded.
  PlateOrientation plan(const ReachEstimator& reach, double aimed_direction_deg, double centre_deg,
                        const PlateModel& plate);

  /// A turn takes time, so that turns are planned.
  bool plans_turns() const;

 private:
  Mpc mpc_;
  std::int64_t latency_ns_;
  std::int64_t step_period_ns_;
  double goal_direction_deg_;
};

}  // namespace hrt
