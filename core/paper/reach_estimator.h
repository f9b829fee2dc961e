// Estimates the motion of the finger and the tactile weight of the person in one reach.
//
// The steps of the model start with the motion. While the finger rests or is lifted, the steps are suspended, since
// nothing is perceived. A step without an accepted observation is predicted.
#pragma once

#include <cstdint>
#include <optional>

#include "core/paper/estimator.h"
#include "core/paper/participant.h"
#include "core/paper/step_clock.h"
#include "core/plate/plate_model.h"
#include "core/reach/finger_sample.h"
#include "core/tracker/finger_phase.h"

namespace hrt {

struct SampleCounts {
  std::int64_t steps = 0;            ///< model steps with an accepted observation
  std::int64_t predicted_steps = 0;  ///< model steps without an accepted observation
  std::int64_t samples = 0;
  std::int64_t dropped_samples = 0;  ///< samples without an observation, outliers and duplicates
};

/// Estimator for one reach. Uses no heap, lock or exception. One thread at a time.
class ReachEstimator {
 public:
  /// Begins at rest at `start`, before a motion whose goal is `goal_direction_deg`. `horizon`: length of gains(), 1 to
  /// max_horizon + max_lead. Requires valid arguments, `step_period_ns` > 0.
  ReachEstimator(const EstimatorConfig& config, const Participant& participant, double goal_direction_deg,
                 const PlatePoint& start, std::int64_t step_period_ns, int horizon);

  /// Advances the model and `plate` to the time of the sample, and processes the sample. Returns the observation on
  /// which a decision may be based: none, direction or position.
  Observation observe(const FingerSample& sample, PlateModel& plate);

  /// Advances by one step without a clock: the previous step ended with the present plate orientation, and the finger
  /// now moves along `direction_deg`. Do not use both step() and observe().
  void step(double direction_deg, const PlateModel& plate);

  void turn_to(double goal_direction_deg);

  /// Direction of motion, estimated or predicted.
  double direction_deg() const { return direction_deg_; }
  double tactile_weight() const { return estimator_.tactile_weight(); }
  double tactile_weight_sd() const { return estimator_.tactile_weight_sd(); }
  /// True if neither the previous nor the current step has an accepted observation.
  bool predicted() const { return missed_ && !sampled_; }
  /// Current step; -1 before the motion.
  std::int64_t current_step() const { return clock_.step(); }
  std::int64_t now_ns() const { return now_ns_; }
  std::int64_t step_end_ns() const { return clock_.end_ns(); }
  /// Kalman gains of the current and the next steps (GainWindow); valid until the next observe() or step().
  const double* gains() const { return gains_.data(); }

  /// Counts since the start of the reach; `steps` includes the current step if it has an accepted observation.
  SampleCounts counts() const;
  FingerEstimate estimate() const { return estimator_.estimate(); }
  const FingerPhase& finger() const { return finger_; }
  /// Position of the finger: tracked before the motion, then estimated; nullopt until a position is observed.
  const std::optional<PlatePoint>& place() const { return place_; }

 private:
  void start(std::int64_t time_ns, const PlatePoint& place);
  void advance(std::int64_t time_ns, PlateModel& plate);
  void end_step(double plate_orientation_deg);
  Observation take(const FingerSample& sample, PlateModel& plate);
  Observation take_position(const FingerSample& sample, PlateModel& plate);
  double white_noise_mm() const;

  bool adapts_;
  Participant participant_;
  double goal_direction_deg_;
  PlatePoint start_;
  FingerPhase finger_;
  Estimator estimator_;
  StepClock clock_;
  GainWindow gains_;
  SampleCounts counts_;  // without the current step
  double direction_deg_ = 0.0;
  std::optional<PlatePoint> place_;
  std::optional<std::int64_t> first_ns_;     // time of the first position
  std::optional<std::int64_t> position_ns_;  // time of the last position
  std::int64_t now_ns_ = 0;                  // time to which the estimate is advanced
  double unseen_s_ = 0.0;                    // time of predicted motion since the last accepted observation
  bool paused_ = false;                      // the finger rests or is lifted
  bool sampled_ = false;                     // the current step has an accepted observation
  bool missed_ = false;                      // the previous step had no accepted observation
};

}  // namespace hrt
