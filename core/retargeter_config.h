// Configuration of a retargeter: its controller, and its assumptions about user, plate and tracker.
#pragma once

#include <cstdint>

#include "core/paper/estimator.h"
#include "core/paper/mpc_config.h"
#include "core/paper/participant.h"
#include "core/person/person_belief.h"
#include "core/person/reach_control.h"
#include "core/plate/frame_error.h"
#include "core/plate/plate_limits.h"
#include "core/plate/plate_model.h"
#include "core/plate/touched_frame.h"

namespace hrt {

/// The controller of the plate's orientation.
enum class ControlMode {
  mpc,          ///< the controller of paper section III
  reach,        ///< the controller for people, where positions are streamed; with directions alone, as mpc
  fixed_plate,  ///< none: the plate stays at RetargeterConfig::fixed_plate_orientation_deg (paper Fig. 8)
};

/// The defaults are the paper's controller.
struct RetargeterConfig {
  Participant participant;  ///< as assumed by the controller; adaptation starts at its w_T
  MpcConfig mpc;
  ControlMode mode = ControlMode::mpc;
  double fixed_plate_orientation_deg = 0.0;   ///< finite
  EstimatorConfig estimator;                  ///< of the paper's controller
  PlateDynamics plate;                        ///< its latency at most `max_lead` model steps
  std::int64_t step_period_ns = 100'000'000;  ///< 1 ms to 10 s
  PersonBelief person = unknown_person();     ///< assumptions of the controller for people
  ReachControlConfig reach;
  /// Time from a motion to the time of its sample, 0 to 0.5 s. Used by ControlMode::reach.
  std::int64_t tracker_latency_ns = 0;
  double tracker_bearing_sd_deg = 0.0;  ///< SD of the tracked bearing of a reach, 0 to 45; used by ControlMode::reach
  bool plate_waits = false;             ///< do not turn the plate before the finger moves; of ControlMode::reach
  bool start_is_felt = false;           ///< the position of a rest is the start; used by ControlMode::reach
  FrameCovariance frame = FrameCovariance::Zero();  ///< covariance of the plate's pose; used by ControlMode::reach
  TouchedFrame touched;                             ///< correction by contacts, already applied to samples
  Tuning tuning;                                    ///< used by ControlMode::reach
};

/// True if every field is in its range.
bool is_valid(const RetargeterConfig& config);

}  // namespace hrt
