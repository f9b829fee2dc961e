// One reach: the tracked fingertip in, the plate's orientation out. A sample passes through
//   estimate (reach_estimator), aim (guidance, authority), plan (paper_control), limit (plate_limits),
//   command.
//
// Samples may come at any rate. Exact directions move the controller once a model step; each position moves
// it, since each refines the estimate of the step. In between the command is held.
#pragma once

#include <cstdint>

#include "core/finger_sample.h"
#include "core/guidance.h"
#include "core/paper_control.h"
#include "core/plate_limits.h"
#include "core/plate_model.h"
#include "core/reach_estimator.h"

namespace hrt {

/// What decides the plate's orientation.
enum class ControlMode {
  mpc,          ///< the controller of paper section III
  fixed_plate,  ///< none: the plate stays at RetargeterConfig::fixed_plate_orientation_deg (paper Fig. 8)
};

/// The defaults are the paper's controller.
struct RetargeterConfig {
  Participant participant;  ///< whom the controller assumes; w_T is where adaptation starts
  MpcConfig mpc;
  ControlMode mode = ControlMode::mpc;
  double fixed_plate_orientation_deg = 0.0;  ///< finite
  GuidanceMode guidance = GuidanceMode::fixed_direction;
  EstimatorConfig estimator;
  PlateDynamics plate;                        ///< its latency at most `max_lead` model steps
  std::int64_t step_period_ns = 100'000'000;  ///< 1 ms to 10 s
};

/// True if every field is in its range.
bool is_valid(const RetargeterConfig& config);

/// A pair of targets seen from the start of the reach; directions in degrees from the mid-line.
struct Reach {
  double real_direction_deg;           ///< P_R, finite; within 90 of the goal: theta_V and the person's bias
  double virtual_direction_deg;        ///< theta_V, finite
  double plate_orientation_deg = 0.0;  ///< where the plate stands before the reach
  PlatePoint start;                    ///< where the finger is before the reach
  double real_distance_m = 0.1;        ///< from the start to the real target, > 0
};

/// True if every field is in its range, for this participant.
bool is_valid(const Reach& reach, const Participant& participant);

/// What the plate is to do, and why. Until the finger moves, the plate stays where the reach found it.
struct PlateCommand {
  double plate_orientation_deg = 0.0;      ///< T; which of those that feel the same, see plate_limits.h
  double finger_direction_deg = 0.0;       ///< P of this step, estimated or predicted
  double perceived_direction_deg = 0.0;    ///< theta_hat at the end of this step
  double aimed_direction_deg = 0.0;        ///< where the finger is wanted, within what can be held
  double tactile_weight = 0.0;             ///< w_T in use
  double tactile_weight_sd = 0.0;          ///< its standard deviation; 0 without adaptation
  double distance_to_go_m = 0.0;           ///< to the real target's place; the whole until a position is seen
  std::int64_t step = -1;                  ///< model step; -1 before the finger moves
  ActiveBound active = ActiveBound::none;  ///< the bound that holds the command
  bool held = true;                        ///< no new decision was taken in this call
  bool predicted = false;    ///< neither this step nor the one before has a sample: the finger is the model's
  bool unreachable = false;  ///< the real direction is beyond what this participant's w_T can hold
};

/// What became of a reach.
struct ReachSummary {
  std::int64_t steps = 0;               ///< model steps with samples
  std::int64_t predicted_steps = 0;     ///< model steps without
  std::int64_t saturated_steps = 0;     ///< of steps, those whose command the plate bound or a stop held
  std::int64_t rate_limited_steps = 0;  ///< of steps, those whose command the rate bound held
  std::int64_t samples = 0;
  std::int64_t dropped_samples = 0;      ///< with nothing observed, or left out as outliers or duplicates
  double final_direction_deg = 0.0;      ///< P of the last step, estimated or predicted
  double final_miss_deg = 0.0;           ///< final_direction_deg - P_R
  double perceived_direction_deg = 0.0;  ///< theta_hat of the last step
  double perceived_error_deg = 0.0;      ///< perceived_direction_deg - G
  double distance_to_target_m = 0.0;     ///< from the last position, seen or predicted, to the real target's
  FingerEstimate estimate;               ///< what was learnt: w_T, tracker noise
};

/// Runs one reach after another. No heap, no lock, no exception. One thread at a time.
class Retargeter {
 public:
  /// Requires is_valid(config).
  explicit Retargeter(const RetargeterConfig& config);

  /// Starts a reach; whatever the last one left is forgotten. Requires is_valid(reach,
  /// config.participant).
  void begin(const Reach& reach);

  /// Takes one sample in and returns the command that holds now. Requires begin(); the sample's time must
  /// not be before the last one's. However long the gap, at most StepClock::max_catch_up_steps are predicted.
  PlateCommand update(const FingerSample& sample);

  /// The paper's loop, without a clock: one model step with the finger moving along
  /// `finger_direction_deg` (finite). Requires begin(); not to be mixed with update() in one reach.
  PlateCommand step(double finger_direction_deg);

  /// The last one; begin()'s before the first sample.
  PlateCommand command() const { return command_; }
  ReachSummary summary() const;

 private:
  /// Where the finger is wanted.
  struct Aim {
    double direction_deg;
    bool unreachable;
  };
  /// What the plate was last turned to, and for what.
  struct Decision {
    std::int64_t step = -1;
    Aim aim;
    PlateOrientation plate;
  };
  /// The finger as commands and summary show it.
  struct Finger {
    double direction_deg;
    double perceived_direction_deg;
    double tactile_weight;
    double tactile_weight_sd;
  };

  Aim aim(const ReachState& state);
  PlateOrientation plan(const ReachState& state, const Aim& aim);
  void decide(const Decision& decision);
  Finger finger(const ReachState& state, double plate_orientation_deg) const;
  PlateCommand publish(const ReachState& state, bool held);
  double distance_to_go_m() const;

  RetargeterConfig config_;
  Reach reach_{};
  double goal_deg_ = 0.0;
  ReachEstimator estimator_;
  Guidance guidance_;
  PaperControl control_;
  PlateLimits limits_;
  PlateModel plate_;
  Decision decision_{};
  Finger finger_{};
  PlateCommand command_;
  std::int64_t saturated_steps_ = 0;  // without the last decision's
  std::int64_t rate_limited_steps_ = 0;
};

}  // namespace hrt
