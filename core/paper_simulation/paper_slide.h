// Simulated slides of the paper's participant over a plate at rest, as a calibration records them.
#pragma once

#include "core/calibrate/slide_track.h"
#include "core/paper/participant.h"
#include "core/paper_simulation/trial.h"

namespace hrt {

struct CalibrationCondition {
  Participant participant;
  double goal_direction_deg = 0.0;  ///< direction of the target
  double distance_mm = 100.0;       ///< length of the path, > 0
  double duration_s = 3.0;          ///< duration of the path, > 0
  double step_period_s = 0.1;       ///< period of the participant's steps, > 0
  double rest_s = 0.5;              ///< duration of the tracked rest before the path, >= 0
  double tracker_noise_mm = 1.2;    ///< SD of the white noise of a coordinate, >= 0
  double tracker_rate_hz = 90.0;    ///< > 0
};

/// Simulates one slide with the plate at `plate_orientation_deg`. Any thread.
CalibrationTrial simulate_calibration_trial(const CalibrationCondition& condition, double plate_orientation_deg,
                                            const TrialId& id);

}  // namespace hrt
