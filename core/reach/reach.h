// The inputs and outputs of a reach: targets, commands, summary.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "core/plate/plate_frame.h"
#include "core/plate/plate_limits.h"
#include "core/plate/plate_model.h"

namespace hrt {

/// The gaps that can be held for one pair of targets and one participant. Angles in degrees.
struct Authority {
  bool reachable;                 ///< the real direction can be held
  double gap_deg;                 ///< theta_V - P_R
  double max_gap_deg;             ///< L w_T / (1 - w_T), >= 0
  double margin_deg;              ///< max_gap_deg - |gap_deg|; negative if not feasible
  double plate_orientation_deg;   ///< sustains the settling direction; at the bound if the gap is not feasible
  double settling_direction_deg;  ///< direction in which the finger settles: the real direction if reachable
};

/// A pair of targets seen from the start of the reach; directions in degrees from the mid-line.
struct Reach {
  double real_direction_deg;           ///< P_R, finite; within 90 of the goal: theta_V and the person's bias
  double virtual_direction_deg;        ///< theta_V, finite
  double plate_orientation_deg = 0.0;  ///< plate orientation before the reach
  PlatePoint start;                    ///< position of the finger at rest
  double real_distance_mm = 100.0;     ///< distance from the start to the real target, > 0
  double duration_s = 0.0;             ///< expected duration of the motion, 0.1 to 20; 0: unknown
};

/// True if every field is in its range, for a person with this goal direction.
inline bool is_valid(const Reach& reach, double goal_direction_deg) {
  return std::isfinite(reach.real_direction_deg) && std::isfinite(reach.virtual_direction_deg) &&
         std::abs(reach.real_direction_deg - goal_direction_deg) < 90.0 && std::isfinite(reach.plate_orientation_deg) &&
         std::isfinite(reach.start.right_mm) && std::isfinite(reach.start.away_mm) &&
         std::isfinite(reach.real_distance_mm) && reach.real_distance_mm > 0.0 &&
         (reach.duration_s == 0.0 || (reach.duration_s >= 0.1 && reach.duration_s <= 20.0));
}

/// State that a reach passes to the reach that replaces it: the moving plate and the samples so far.
struct PlateHandover {
  PlateModel plate;
  double commanded_deg;
  std::int64_t samples;
  std::int64_t dropped_samples;
};

/// Progress of a reach, by the positions of its finger: reach_end.h.
struct ReachProgress {
  bool arrived = false;       ///< the reach is over
  bool off_target = false;    ///< the reach ended away from the target, or the finger moves away from it
  bool not_at_start = false;  ///< the finger rests elsewhere, and has not been at the start
};

/// SD of a miss that is not known.
inline constexpr double unknown_miss_sd_deg = 180.0;

/// A command for the plate, with its reasons.
struct PlateCommand {
  double plate_orientation_deg =
      0.0;  ///< T; of the orientations with the same ridges, the one that plate_limits.h selects
  double finger_direction_deg = 0.0;     ///< P, estimated or predicted
  double bearing_deg = 0.0;              ///< bearing of the finger from the start of the reach; 0 until it moves
  double perceived_direction_deg = 0.0;  ///< theta_hat at the end of this step; of a person: felt now
  double aimed_direction_deg = 0.0;      ///< the intended direction, if it is feasible
  double tactile_weight = 0.0;           ///< w_T in use; of a person: the felt shift over the offset, at 60 degrees
  double tactile_weight_sd = 0.0;        ///< SD of the tactile weight; 0 without adaptation
  double distance_to_go_mm = 0.0;        ///< distance to the real target; from the start until the first position
  double time_to_go_s = -1.0;       ///< until the motion ends, then 0; -1 before it, in a pause and under the paper's
  double felt_error_deg = 0.0;      ///< perceived minus intended direction, now, as estimated
  double predicted_miss_deg = 0.0;  ///< predicted bearing of the position of arrival minus that of the real target
  /// SD of the finger's true place across the line to the real target, as a bearing from the
  /// start: by the filter and by the registration of the plate.
  double bearing_error_sd_deg = unknown_miss_sd_deg;
  double nis = 0.0;                        ///< normalised innovation squared of recent positions; 2 is expected
  std::int64_t step = -1;                  ///< model step; -1 before the finger moves
  ActiveBound active = ActiveBound::none;  ///< the bound that holds the command
  bool for_people = false;                 ///< the command is from the controller for people, not from the paper's
  bool held = true;                        ///< no new decision was taken in this call
  bool predicted = false;                  ///< the last two steps have no samples: the finger is predicted by the model
  bool unreachable = false;                ///< the real direction is not feasible for this participant
  bool optimal = true;                     ///< false: the solver's work was cut short; the command is within its bounds
  bool misfit = false;                     ///< the person does not move as the model does: do not trust the estimates
  bool off_target = false;    ///< the finger is going to end beyond `near_deg` of the real target's bearing
  bool resting = false;       ///< the finger rests within the reach
  bool arrived = false;       ///< the reach is over: see reach_end.h
  bool not_at_start = false;  ///< the finger rests elsewhere than at the start
  bool miss_unknown = true;   ///< predicted_miss_deg is unknown
  // The caller of the controller sets these.
  bool lifted = false;                 ///< the finger does not touch the plate
  bool off_plate = false;              ///< the finger is beyond the plate's rim
  bool registration_doubtful = false;  ///< the plate's registration is older or worse than allowed
  bool contacts_disagree = false;      ///< contacts contradict the registration
  bool implausible = false;            ///< times, units or axes of this reach are probably wrong
  bool fault = false;                  ///< a value was not a finite number
};

/// Within this of the real target's bearing, a reach ends on it.
inline constexpr double near_deg = 1.5;

/// The finger of the paper's person, as estimated in a reach. SDs are the filter's own.
struct FingerEstimate {
  PlatePoint position;
  double speed_mm_s = 0.0;
  double direction_deg = 0.0;
  double tactile_weight = 0.0;
  double tactile_weight_sd = 0.0;
  double tracker_noise_mm = 0.0;
  /// sigma_u^2 as corrected by this reach, and its SD: about the configured one
  /// if the reach cannot determine them.
  double motor_variance_deg2 = 0.0;
  double motor_variance_sd_deg2 = 0.0;
};

/// A person as estimated in a reach; SDs are the filter's own.
struct PersonEstimate {
  double curve = 0.0;  ///< b of illusion.h: 0 is linear
  double curve_sd = 0.0;
  double gain_s = 0.0;  ///< k, 1/s
  double gain_sd_s = 0.0;
  double bias_deg = 0.0;  ///< goal minus virtual direction
  double bias_sd_deg = 0.0;
  double duration_s = 0.0;  ///< duration of the motion
};

/// The outcome of a reach.
struct ReachSummary {
  std::int64_t steps = 0;               ///< model steps with samples
  std::int64_t predicted_steps = 0;     ///< model steps without
  std::int64_t saturated_steps = 0;     ///< number of steps in which the plate bound or a stop held the command
  std::int64_t rate_limited_steps = 0;  ///< number of steps in which the rate bound held the command
  std::int64_t samples = 0;
  std::int64_t dropped_samples = 0;      ///< samples without an observation, outliers and duplicates
  double final_direction_deg = 0.0;      ///< P of the last step, estimated or predicted
  double final_miss_deg = 0.0;           ///< final_direction_deg - P_R
  double perceived_direction_deg = 0.0;  ///< theta_hat of the last step
  double perceived_error_deg = 0.0;      ///< perceived_direction_deg minus theta_V and the configured bias
  double distance_to_target_mm = 0.0;    ///< distance from the last position, observed or predicted, to the real target
  double bearing_deg = 0.0;              ///< value in the last PlateCommand
  double bearing_error_deg = 0.0;        ///< bearing_deg minus the bearing of the real target; 0 if it is unknown
  double bearing_error_sd_deg = unknown_miss_sd_deg;  ///< value in the last PlateCommand
  double peak_felt_error_deg = 0.0;                   ///< largest size of PlateCommand::felt_error_deg
  double rms_felt_error_deg = 0.0;
  double nis = 0.0;                      ///< largest value in a PlateCommand
  bool unreachable = false;              ///< value in the last PlateCommand
  bool misfit = false;                   ///< true if any PlateCommand had it
  bool off_target = false;               ///< the finger ended beyond `near_deg` of the real target's bearing
  bool registration_doubtful = false;    ///< true if any PlateCommand had it
  bool contacts_disagree = false;        ///< as in the last PlateCommand, or after the contact of this reach
  bool not_at_start = false;             ///< value in the last PlateCommand
  bool miss_unknown = false;             ///< no sample shows a motion
  bool implausible = false;              ///< true if any PlateCommand had it
  FingerEstimate estimate;               ///< estimates of w_T and of the tracker's noise
  std::optional<PersonEstimate> person;  ///< none without positions
};

}  // namespace hrt
