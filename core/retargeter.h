// One reach: the tracked fingertip in, the plate's orientation out.
//
// Samples may come at any rate. The reach advances in model steps of a fixed period that start when the
// finger starts to move; in each step the controller acts once, as soon as the step's direction can be
// told, and the command is held until the next time. A step that passes without a direction is predicted
// with the model, and the plate stays where it is.
#pragma once

#include <cstdint>

#include "core/estimator.h"
#include "core/guidance.h"
#include "core/mpc.h"
#include "core/perception.h"

namespace hrt {

/// What decides the plate's orientation.
enum class ControlMode {
  mpc,          ///< the controller of paper section III
  fixed_plate,  ///< none: the plate stays at RetargeterConfig::fixed_plate_orientation_deg (paper Fig. 8)
};

struct RetargeterConfig {
  Participant participant;  ///< whom the controller assumes
  MpcConfig mpc;
  ControlMode mode = ControlMode::mpc;
  double fixed_plate_orientation_deg = 0.0;  ///< finite
  GuidanceMode guidance = GuidanceMode::fixed_direction;
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
  double plate_orientation_deg = 0.0;    ///< T
  double finger_direction_deg = 0.0;     ///< P of the last step, observed or predicted
  double perceived_direction_deg = 0.0;  ///< theta_hat of the last step under this command
  double aimed_direction_deg = 0.0;      ///< where the finger is wanted: the real target's direction
  double distance_to_go_m = 0.0;         ///< to the real target's place; its whole until a position is seen
  std::int64_t step = -1;  ///< model step that the command belongs to; -1 before the finger moves
  ActiveBound active = ActiveBound::none;  ///< the bound that holds the command
  bool held = true;                        ///< no new decision was taken in this call
  bool predicted = false;                  ///< the last step had no direction and was predicted
};

/// What became of a reach.
struct ReachSummary {
  std::int64_t steps = 0;               ///< model steps that the controller acted in
  std::int64_t predicted_steps = 0;     ///< model steps that passed without a direction
  std::int64_t saturated_steps = 0;     ///< acted steps whose command the plate bound held
  std::int64_t rate_limited_steps = 0;  ///< acted steps whose command the rate bound held
  std::int64_t samples = 0;
  std::int64_t dropped_samples = 0;      ///< with nothing observed
  double final_direction_deg = 0.0;      ///< P of the last step
  double final_miss_deg = 0.0;           ///< final_direction_deg - P_R
  double perceived_direction_deg = 0.0;  ///< theta_hat of the last step
  double perceived_error_deg = 0.0;      ///< perceived_direction_deg - theta_V
  double distance_to_target_m = 0.0;     ///< from the last position to the real target's place
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
  const RetargeterConfig& config() const { return config_; }
  const Reach& reach() const { return reach_; }

  /// After this many steps without a direction the model has long settled; more would change nothing.
  static constexpr int max_catch_up_steps = 64;

 private:
  void catch_up(std::int64_t time_ns);
  void act(double finger_direction_deg);
  void close_step();

  RetargeterConfig config_;
  Mpc mpc_;
  Reach reach_{};
  Estimator estimator_;
  Guidance guidance_;
  GainWindow gains_;
  PlateCommand command_;
  ReachSummary summary_;
  bool started_ = false;
  bool acted_ = false;  // in the current step
  std::int64_t step_start_ns_ = 0;
  double felt_plate_orientation_deg_ = 0.0;  // measured where the device reports it, else commanded
  double predicted_direction_deg_ = 0.0;     // of the current step, from the model; P_0 is the mid-line
};

}  // namespace hrt
