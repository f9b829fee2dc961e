// Configuration of a Retargeter: the controller, and its assumptions about user, plate and tracker.
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

enum class ControlMode {
  mpc,          ///< controller of paper section III
  reach,        ///< controller for people if samples have positions; otherwise as mpc
  fixed_plate,  ///< no control: the plate stays at RetargeterConfig::fixed_plate_orientation_deg (paper Fig. 8)
};

/// Configuration of a Retargeter; defaults: the paper's controller. Reaches use the fields marked [reach] only in
/// ControlMode::reach.
struct RetargeterConfig {
  Participant participant;  ///< model of the participant; adaptation starts at its tactile weight
  MpcConfig mpc;
  ControlMode mode = ControlMode::mpc;
  double fixed_plate_orientation_deg = 0.0;   ///< finite
  EstimatorConfig estimator;                  ///< prior of the paper's controller; tracker noise for both controllers
  PlateDynamics plate;                        ///< latency at most `max_lead` model steps
  std::int64_t step_period_ns = 100'000'000;  ///< period of the paper's model steps, 1 ms to 10 s
  PersonBelief person = unknown_person();     ///< [reach] prior of the person
  ReachControlConfig reach;                   ///< [reach] limits of plate and perceived direction
  std::int64_t tracker_latency_ns = 0;        ///< [reach] age of a position at the time of its sample, 0 to 0.5 s
  double tracker_bearing_sd_deg = 0.0;  ///< [reach] SD of the tracker's bearing error from reach to reach, 0 to 45
  bool plate_waits = false;             ///< [reach] the plate does not turn before the motion
  bool start_is_felt = false;           ///< the first rest of the finger is at the start, as in a dimple
  FrameCovariance frame = FrameCovariance::Zero();  ///< [reach] covariance of the plate's pose
  TouchedFrame touched;  ///< correction of the tracker's frame; the caller applies it to samples before update()
  Tuning tuning;         ///< tuned numbers, most of them for ControlMode::reach
};

bool is_valid(const RetargeterConfig& config);

}  // namespace hrt
