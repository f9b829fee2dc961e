// A reach under the paper's controller. An accepted sample passes through
//   estimate (reach_estimator), aim (participant), plan (paper_control), limit (plate_limits), command.
#pragma once

#include <cstdint>
#include <optional>

#include "core/paper/paper_control.h"
#include "core/paper/reach_estimator.h"
#include "core/plate/plate_limits.h"
#include "core/plate/plate_model.h"
#include "core/reach/finger_sample.h"
#include "core/reach/reach.h"

namespace hrt {

struct PaperReachConfig {
  Participant participant;  ///< model of the participant; adaptation starts at its tactile weight
  MpcConfig mpc;
  std::optional<double> fixed_plate_orientation_deg;  ///< constant plate orientation without control (paper Fig. 8)
  EstimatorConfig estimator;
  PlateDynamics plate;  ///< latency at most `max_lead` steps
  std::int64_t step_period_ns = 100'000'000;
};

/// Controller of one reach. Plans at each accepted position, since positions refine the estimate; if directions are
/// observed, once in a model step. Uses no heap, lock or exception. One thread at a time.
class PaperReach {
 public:
  /// `handover`: state of the reach that this one replaces; nullopt: the plate is at rest. Requires valid arguments.
  PaperReach(const PaperReachConfig& config, const Reach& reach,
             const std::optional<PlateHandover>& handover = std::nullopt);

  /// Processes a sample, not earlier than the previous one.
  const PlateCommand& update(const FingerSample& sample);

  /// Moves the targets. `real`: position of the real target. `now`: the remaining reach, from Retargeter::retarget().
  void retarget(const PlatePoint& real, const Reach& now);

  /// Advances by one model step without a clock; `finger_direction_deg` is finite. Do not use both step() and update().
  const PlateCommand& step(double finger_direction_deg);

  const PlateCommand& command() const { return command_; }
  /// Position of the finger; nullopt before the motion, and without positions.
  std::optional<PlatePoint> place() const { return command_.step >= 0 ? estimator_.place() : std::nullopt; }
  double speed_mm_s() const { return 0.0; }  ///< 0: the paper's participant has no reaction time
  ReachSummary summary() const;
  PlateHandover handover() const;
  const FingerPhase& finger() const { return estimator_.finger(); }

 private:
  struct Aim {
    double direction_deg;  // direction to which the finger is steered
    bool unreachable;
  };
  struct Decision {
    std::int64_t step = -1;
    Aim aim;
    PlateOrientation plate;
  };

  PlateOrientation initial_plate(const std::optional<PlateHandover>& handover) const;
  Aim aim() const;
  PlateOrientation plan(const Aim& aim);
  void decide(const Decision& decision);
  void show_finger(double plate_orientation_deg);
  const PlateCommand& publish(bool held);
  double distance_to_go_mm() const;
  double bearing_from_start_deg() const;

  PaperReachConfig config_;
  PlatePoint start_;
  Reach reach_;
  double goal_deg_;
  PlatePoint target_;
  ReachEstimator estimator_;
  PaperControl control_;
  PlateModel plate_;
  PlateLimits limits_;
  Decision decision_;
  PlateCommand command_;
  std::int64_t samples_before_ = 0;  // this and the next field: counts of the replaced reach
  std::int64_t dropped_before_ = 0;
  std::int64_t saturated_steps_ = 0;  // this and the next field: without the step of the last decision
  std::int64_t rate_limited_steps_ = 0;
};

}  // namespace hrt
