// One reach: the tracked fingertip in, the plate's orientation out.
//
// Samples may come at any rate. The reach advances in model steps of a fixed period that start when the
// finger starts to move; at the end of each the participant feels the plate and steers. Exact directions
// move the controller once a step, noisy positions at each sample, as they tell ever more of the step; in
// between the command holds. A step without samples is predicted with the model, and the plate stays.
#pragma once

#include <cstdint>
#include <optional>

#include "core/authority.h"
#include "core/estimator.h"
#include "core/guidance.h"
#include "core/mpc.h"
#include "core/onset.h"
#include "core/perception.h"
#include "core/plate.h"
#include "core/time.h"

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
  double real_direction_deg;           ///< P_R, finite; within 90 of virtual_direction_deg
  double virtual_direction_deg;        ///< theta_V, finite
  double plate_orientation_deg = 0.0;  ///< where the plate stands before the reach
  PlatePoint start;                    ///< where the finger is before the reach
  double real_distance_m = 0.1;        ///< from the start to the real target, > 0
};

/// True if every field is in its range.
bool is_valid(const Reach& reach);

/// What the plate is to do, and why. Until the finger moves, the plate stays where the reach found it.
struct PlateCommand {
  double plate_orientation_deg = 0.0;      ///< T; of those that feel the same, as core/README.md tells
  double finger_direction_deg = 0.0;       ///< P of this step, estimated or predicted
  double perceived_direction_deg = 0.0;    ///< theta_hat at the end of this step
  double aimed_direction_deg = 0.0;        ///< where the finger is wanted, within what can be held
  double tactile_weight = 0.0;             ///< w_T in use
  double tactile_weight_sd = 0.0;          ///< its standard deviation; 0 without adaptation
  double distance_to_go_m = 0.0;           ///< to the real target's place; the whole until a position is seen
  std::int64_t step = -1;                  ///< model step; -1 before the finger moves
  ActiveBound active = ActiveBound::none;  ///< the bound that holds the command
  bool held = true;                        ///< no new decision was taken in this call
  bool predicted =
      false;  ///< the step before had no sample, nor has this one: finger_direction_deg is the model's
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
  double final_direction_deg = 0.0;      ///< P of the last step
  double final_miss_deg = 0.0;           ///< final_direction_deg - P_R
  double perceived_direction_deg = 0.0;  ///< theta_hat of the last step
  double perceived_error_deg = 0.0;      ///< perceived_direction_deg - theta_V
  double distance_to_target_m = 0.0;     ///< from the last estimated position to the real target's place
  FingerEstimate estimate;               ///< what was learnt: w_T, tracker noise
};

/// Runs one reach after another. No heap, no lock, no exception. One thread at a time.
class Retargeter {
 public:
  /// Requires is_valid(config).
  explicit Retargeter(const RetargeterConfig& config);

  /// Starts a reach; whatever the last one left is forgotten. Requires is_valid(reach).
  void begin(const Reach& reach);

  /// Takes one sample in and returns the command that holds now. Requires begin(); the sample's time must
  /// not be before the last one's. However long the gap, at most `max_catch_up_steps` are predicted.
  const PlateCommand& update(const FingerSample& sample);

  /// The paper's loop, without a clock: one model step with the finger moving along
  /// `finger_direction_deg` (finite). Requires begin(); not to be mixed with update() in one reach.
  const PlateCommand& step(double finger_direction_deg);

  const PlateCommand& command() const { return command_; }
  ReachSummary summary() const;
  const Estimator& estimator() const { return estimator_; }
  const RetargeterConfig& config() const { return config_; }
  const Reach& reach() const { return reach_; }

  /// After this many steps without a sample the model has long settled; more would change nothing.
  static constexpr int max_catch_up_steps = 64;
  /// A finger slower than this rests: the participant's steps wait for it.
  static constexpr double rest_speed_m_s = 0.004;

 private:
  void start(std::int64_t time_ns, const PlatePoint& place);
  void advance(std::int64_t time_ns);
  void end_step();
  void count_step(ReachSummary& summary) const;
  void observe_position(const FingerSample& sample);
  void decide(const FingerEstimate& estimate);
  void act(const FingerEstimate& estimate);
  double plan_deg(const FingerEstimate& estimate);
  double half_turns_for_reach() const;
  bool plans_turns() const;
  double perceived_deg(const FingerEstimate& estimate, double plate_orientation_deg, int lead = 0) const;
  std::int64_t step_end_ns() const { return later_ns(step_start_ns_, config_.step_period_ns); }

  RetargeterConfig config_;
  Reach reach_{};
  Mpc mpc_;
  Guidance guidance_;
  GainWindow gains_;
  Onset onset_;
  Estimator estimator_;
  Plate plate_;
  PlateCommand command_;
  ReachSummary summary_;
  // That the plate keeps to in this reach, beyond the orientations about the goal; see plans_turns().
  double half_turns_ = 0.0;
  std::int64_t step_start_ns_ = 0;
  std::int64_t now_ns_ = 0;                  // of the estimator
  std::optional<std::int64_t> position_ns_;  // of the last position
  bool started_ = false;
  bool paused_ = false;   // the finger rests or is lifted: no step goes by
  bool acted_ = false;    // in the current step
  bool sampled_ = false;  // in the current step
};

}  // namespace hrt
