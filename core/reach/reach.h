// Input and output of a reach: targets, commands, summary.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "core/plate/plate_frame.h"
#include "core/plate/plate_limits.h"
#include "core/plate/plate_model.h"

namespace hrt {

/// Feasible gap for a pair of targets and a person.
struct GapFeasibility {
  bool reachable;                 ///< true: the gap is feasible
  double gap_deg;                 ///< direction at which the person aims minus real direction
  double max_gap_deg;             ///< largest feasible gap, >= 0
  double margin_deg;              ///< max_gap_deg - |gap_deg|; negative if the gap is not feasible
  double plate_orientation_deg;   ///< plate orientation that sustains settling_direction_deg
  double settling_direction_deg;  ///< direction in which the finger settles: the real direction if reachable
};

/// A pair of targets seen from the start of the reach or, after a retarget, as in Retargeter::retarget(). Directions
/// are in degrees from the mid-line.
struct Reach {
  /// direction of the real target: finite, less than 90 degrees from the goal (virtual direction plus bias)
  double real_direction_deg;
  double virtual_direction_deg;        ///< finite
  double plate_orientation_deg = 0.0;  ///< plate orientation before the reach
  PlatePoint start;                    ///< position of the finger at rest
  double real_distance_mm = 100.0;     ///< distance from the start to the real target, > 0
  double duration_s = 0.0;             ///< expected duration of the motion, 0.1 to 20; 0: unknown
};

/// Returns true if every field is in its range for a person whose goal is `goal_direction_deg`.
inline bool is_valid(const Reach& reach, double goal_direction_deg) {
  return std::isfinite(reach.real_direction_deg) && std::isfinite(reach.virtual_direction_deg) &&
         std::abs(reach.real_direction_deg - goal_direction_deg) < 90.0 && std::isfinite(reach.plate_orientation_deg) &&
         std::isfinite(reach.start.right_mm) && std::isfinite(reach.start.away_mm) &&
         std::isfinite(reach.real_distance_mm) && reach.real_distance_mm > 0.0 &&
         (reach.duration_s == 0.0 || (reach.duration_s >= 0.1 && reach.duration_s <= 20.0));
}

/// State that a reach passes to the reach that replaces it: the plate, which may be moving, and the counts of samples.
struct PlateHandover {
  PlateModel plate;
  double commanded_deg;
  std::int64_t samples;
  std::int64_t dropped_samples;
};

/// Progress of a reach, as ReachEnd (reach_end.h) detects it.
struct ReachProgress {
  bool arrived = false;  ///< the reach is over
  /// the reach ended away from the target, or the finger is over 60 degrees off the target's direction after three
  /// tenths of the path
  bool off_target = false;
  bool not_at_start = false;  ///< the finger has not been at the start, and has not moved
};

inline constexpr double unknown_miss_sd_deg = 180.0;

/// Command for the plate, with the state from which it was computed.
struct PlateCommand {
  /// orientation to command; of those with the same ridges, the one that plate_limits.h selects
  double plate_orientation_deg = 0.0;
  double finger_direction_deg = 0.0;  ///< direction of motion, estimated or predicted
  /// bearing of the finger from the start of the reach or, without positions, direction of motion; 0 before the motion
  double bearing_deg = 0.0;
  double perceived_direction_deg = 0.0;  ///< perceived direction; under the paper's controller, at the end of the step
  /// direction to which the finger is steered. Controller for people: that of the real target from the finger or, close
  /// to the target, from the start or the last retarget. Paper's controller: that of the real target from the start or
  /// the last retarget, or the nearest feasible direction
  double aimed_direction_deg = 0.0;
  /// estimate; under the controller for people, the shift of the perceived direction by a ridge normal at 60 degrees to
  /// the motion, divided by 60 degrees
  double tactile_weight = 0.0;
  double tactile_weight_sd = 0.0;  ///< SD of the tactile weight; under the paper's controller, 0 without adaptation
  double distance_to_go_mm = 0.0;  ///< distance to the real target from the finger or, before a position, the start
  /// time until the end of the motion; 0 once the model expects the end; otherwise -1 before the motion, while
  /// `resting`, and under the paper's controller
  double time_to_go_s = -1.0;
  double felt_error_deg = 0.0;  ///< estimated present perceived-direction error; 0 under the paper's controller
  /// predicted bearing of the end of the reach minus that of the real target; while the finger rests: its bearing minus
  /// that of the real target
  double predicted_miss_deg = 0.0;
  /// SD of the true position of the finger across the line to the real target, as an angle from the start; includes the
  /// uncertainty of filter, registration and tracker. 180 before the motion and under the paper's controller
  double bearing_error_sd_deg = unknown_miss_sd_deg;
  double nis = 0.0;  ///< mean normalised innovation squared of recent positions, expected: 2; 0: paper's controller
  std::int64_t step = -1;                  ///< model step; -1 before the motion
  ActiveBound active = ActiveBound::none;  ///< bound that limits the command
  bool for_people = false;                 ///< true: controller for people; false: the paper's controller
  bool held = true;                        ///< no orientation was planned since the previous command
  bool predicted = false;                  ///< no recent observation: the model predicts the finger
  bool unreachable = false;                ///< the gap is probably not feasible for this person
  bool optimal = true;        ///< false: the solver reached its iteration limit; the command is within its bounds
  bool misfit = false;        ///< the model does not describe the motion: the estimates are not reliable
  bool off_target = false;    ///< the reach will probably end, or has ended, over `near_deg` off the target
  bool resting = false;       ///< the finger pauses or is lifted after the onset; not under the paper's controller
  bool arrived = false;       ///< the reach is over (reach_end.h)
  bool not_at_start = false;  ///< the finger has not been at the start, and has not moved
  bool miss_unknown = true;   ///< predicted_miss_deg is unknown
  // The caller of the controller sets the following fields.
  bool lifted = false;                 ///< the finger does not touch the plate
  bool off_plate = false;              ///< the finger is beyond the plate's rim
  bool registration_doubtful = false;  ///< the registration is missing, older or less accurate than allowed
  bool contacts_disagree = false;      ///< contacts contradict the registration
  bool implausible = false;            ///< times, units or axes are probably wrong
  bool fault = false;                  ///< the computed plate orientation was not finite
};

/// A reach is on target if the bearing of its end differs from that of the real target by at most this angle.
inline constexpr double near_deg = 1.5;

/// Estimates of the paper's controller in a reach; the controller for people sets some of them (ReachSummary).
struct FingerEstimate {
  PlatePoint position;
  double speed_mm_s = 0.0;
  double direction_deg = 0.0;
  double tactile_weight = 0.0;
  double tactile_weight_sd = 0.0;
  double tracker_noise_mm = 0.0;  ///< SD of the noise of a coordinate
  /// motor variance (sigma_u^2 of the paper); near the configured value if the reach does not determine it
  double motor_variance_deg2 = 0.0;
  double motor_variance_sd_deg2 = 0.0;
};

/// Estimates of the controller for people in a reach.
struct PersonEstimate {
  double curve = 0.0;  ///< b of person_model.h; 0: the illusion is linear
  double curve_sd = 0.0;
  double gain_per_s = 0.0;  ///< k: rate at which the person corrects a perceived-direction error
  double gain_sd_per_s = 0.0;
  double bias_deg = 0.0;  ///< goal minus virtual direction
  double bias_sd_deg = 0.0;
  double duration_s = 0.0;
};

struct ReachSummary {
  std::int64_t steps = 0;               ///< model steps with an accepted observation
  std::int64_t predicted_steps = 0;     ///< model steps without an accepted observation
  std::int64_t saturated_steps = 0;     ///< steps in which a bound of the orientation or a stop limited the command
  std::int64_t rate_limited_steps = 0;  ///< steps in which the rate bound limited the command
  std::int64_t samples = 0;
  std::int64_t dropped_samples = 0;      ///< samples without an observation, outliers and duplicates
  double final_direction_deg = 0.0;      ///< direction of motion in the last step, estimated or predicted
  double final_miss_deg = 0.0;           ///< final_direction_deg minus the real direction
  double perceived_direction_deg = 0.0;  ///< perceived direction in the last step
  double perceived_error_deg = 0.0;      ///< perceived_direction_deg - (virtual direction + configured bias)
  double distance_to_target_mm = 0.0;    ///< distance from the last position, tracked or estimated, to the real target
  double bearing_deg = 0.0;              ///< value in the last PlateCommand
  double bearing_error_deg = 0.0;        ///< bearing_deg minus the bearing of the real target; 0 before the motion
  double bearing_error_sd_deg = unknown_miss_sd_deg;  ///< value in the last PlateCommand
  double peak_felt_error_deg = 0.0;    ///< largest absolute PlateCommand::felt_error_deg while the finger moved
  double rms_felt_error_deg = 0.0;     ///< root mean square of PlateCommand::felt_error_deg while the finger moved
  double nis = 0.0;                    ///< largest PlateCommand::nis after the onset
  bool unreachable = false;            ///< value in the last PlateCommand
  bool misfit = false;                 ///< true if any PlateCommand had this flag
  bool off_target = false;             ///< the reach probably ended over `near_deg` off the target
  bool registration_doubtful = false;  ///< true if any PlateCommand had this flag
  bool contacts_disagree = false;      ///< value in the last PlateCommand or, if there was a contact, after it
  bool not_at_start = false;           ///< value in the last PlateCommand
  bool miss_unknown = false;           ///< no motion was observed
  bool implausible = false;            ///< value in the last PlateCommand
  FingerEstimate estimate;  ///< under the controller for people, only the tactile weight, its SD and the tracker noise
  std::optional<PersonEstimate> person;  ///< nullopt under the paper's controller
};

}  // namespace hrt
