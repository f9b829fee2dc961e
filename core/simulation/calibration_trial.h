// Simulated slides over a plate that stands still, or turns within the slide, as a calibration records them.
#pragma once

#include "core/calibrate/calibration.h"
#include "core/paper/perception.h"
#include "core/simulation/people.h"
#include "core/simulation/trial.h"

namespace hrt {

/// Who slides, and how they are tracked.
struct CalibrationCondition {
  Participant participant;
  double goal_direction_deg = 0.0;  ///< of the target
  double distance_m = 0.1;          ///< of the path, > 0
  double duration_s = 3.0;          ///< of the path, > 0
  double step_period_s = 0.1;       ///< of the participant's steps, > 0
  double rest_s = 0.5;              ///< tracked at rest before the path, >= 0
  double tracker_noise_m = 0.0012;  ///< >= 0
  double tracker_rate_hz = 90.0;    ///< > 0
};

/// One slide with the plate at `plate_orientation_deg`; with `turns`, at once on the goal's other side
/// between a fifth and 55 % of the way, and the trial has its orientations. Any thread.
CalibrationTrial simulate_calibration_trial(const CalibrationCondition& condition,
                                            double plate_orientation_deg, const TrialId& id,
                                            bool turns = false);

/// One slide of a person of people.h, straight ahead, with the plate at rest at `plate_orientation_deg`; the
/// gap of the condition does not count. `slide` is its number in the session; each sets out within 2 degrees
/// (standard deviation) of the person's start direction. Any thread.
CalibrationTrial simulate_slide(const PersonCondition& condition, double plate_orientation_deg,
                                std::uint64_t seed, std::uint32_t person, std::uint32_t slide);

/// The same over a plate that begins at `plate_orientation_deg` and is commanded to the opposite side after
/// a fifth of the way and back after 55 %; the condition's servo turns it. The trial has its orientations.
CalibrationTrial simulate_turning_slide(const PersonCondition& condition, double plate_orientation_deg,
                                        std::uint64_t seed, std::uint32_t person, std::uint32_t slide);

}  // namespace hrt
