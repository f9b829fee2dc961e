// Every tuned number of the controller for people: value, unit, source, meaning. A variant is run by setting fields:
// `hrt-study robustness --tune NAME=VALUE`, which reads the names and ranges of tuning_fields().
//
// Sources: [s] chosen on the simulated people of hrt-study robustness; [m] the model, core/person/README.md; [p] a
// bound on computing time; a publication is named. "Kept for" names the test of a fault that needs a number which gains
// less than half a point in samples/study/RESULTS.md.
#pragma once

#include <string>
#include <vector>

#include "core/person/person_state.h"
#include "core/tracker/finger_phase.h"

namespace hrt {

/// A trait of an unknown person. [s] all
struct TraitTuning {
  double mean;    ///< mean of the prior
  double sd;      ///< SD of the prior
  double change;  ///< SD of the change from one reach to the next
};

struct Tuning {
  // Prior. The weight's and the curve's mean and SD are multiples of the SD of a linear illusion's weight, which the
  // host gives; the weight's mean is relative to that weight. The bias's mean is the host's.
  TraitTuning traits[PersonState::traits] = {
      {0.9, 1.7, 0.008},   // weight
      {1.1, 1.6, 0.03},    // curve
      {14.0, 4.0, 0.7},    // gain, 1/s
      {0.0, 4.0, 0.5},     // bias, deg
      {0.0, 9.0, 0.4},     // habit, deg; recorded people and targets: 9.3
      {0.05, 0.35, 0.05},  // evenness
      {-0.65, 0.55, 0.1},  // log_rate
      {0.05, 0.6, 0.02},   // fading
      {1.2, 0.8, 0.1},     // scatter, deg
      {1.4, 1.2, 0.15},    // log_wander
  };
  double weight_curve_correlation = 0.85;  ///< [s] prior correlation of weight and curve
  double steered_habit_sd_deg = 2.0;       ///< deg [s] SD of the habit that a reach begins with is at most this
  double known_weight_sd = 0.001;          ///< [m] SDs of known_person()
  double known_bias_sd_deg = 0.05;         ///< deg
  double known_fading_sd = 0.01;
  double known_scatter_sd_deg = 0.05;   ///< deg
  double min_weight_sd = 0.01;          ///< [s] SDs of calibrated_person() are at least these: people change
  double min_curve_sd = 0.015;          ///< [s] also the cost of a curve that is not a cubic
  double min_bias_sd_deg = 0.5;         ///< deg
  double min_habit_sd_deg = 0.4;        ///< deg
  double max_correlation = 0.95;        ///< largest correlation of weight and curve in calibrated_person()
  double given_duration_log_sd = 0.12;  ///< [s] SD of log_rate if the host gives the duration

  // Illusion.
  double touch_memory_s = 0.3;  ///< s [m] a fading touch decays within this
  double first_ridge = 1.2;     ///< [s] lost touch before the first ridge is crossed
  double max_slope = 3.0;       ///< [m] bound on the decay of the felt error, in gains

  // Filter. Random walks are per second.
  double first_direction = 0.2;            ///< [s] h: initial direction as a fraction of the virtual direction
  double first_direction_sd = 0.45;        ///< [s] SD of h from reach to reach
  double direction_density_deg2_s = 14.0;  ///< deg^2/s [s]
  double log_rate_density_s = 0.07;        ///< 1/s [s]
  double place_density_mm2_s = 0.018;      ///< mm^2/s [s]
  /// s [s] noise along the motion, times the speed squared. Kept for RetargetTest.BringsAPersonToTheMovedTarget.
  double speed_variance_s = 4e-4;
  double resting_density_mm2_s = 0.5;  ///< mm^2/s [s] in a pause
  double wander_s = 0.3;               ///< s [m] decay of the wander, the fast part of the own path
  /// [s] SD of the habit from reach to reach, over the SD of the wander; recorded reaches have 9.1 over 3.8 degrees
  double habit_scatter = 1.0;
  double min_return_fraction = 0.1;  ///< [m] of the path: the wander is not made good over less
  double pace_skew = 0.4;            ///< [m] skew of the pace; recorded reaches have 0.54 and 0.14, +-0.4
  double answer_s = 0.3;             ///< s [m] decay of the former goal until a moved target is answered
  double sensory_delay_s = 0.06;     ///< s [m] from plate to felt direction; half of the simulated 0.12
  double turn_sd_fraction = 0.5;     ///< [s] of the turn of a moved target: its SD
  double max_stretch = 1.5;          ///< [s] longest path of one motion after a moved target, over the path left
  double new_motion_sd_s = 0.15;     ///< s [s] SD of the clock if another motion follows

  // Onset.
  double fit_spacing_s = 0.02;   ///< s [p] positions further apart than this are enough to distinguish paces
  double rate_deviations = 0.4;  ///< [s] step of the grid of rates, in SDs
  double onset_sd_s = 0.02;      ///< s [s] SD of the onset

  // Gate and fit statistics.
  double max_accepted_nis = 25.0;  ///< an innovation above this (5 SDs) is an outlier
  /// [s] outliers in a row before a position is accepted as a jump. Kept for
  /// PersonEstimatorTest.FollowsAJumpAndForgetsAnOutlier.
  double max_outliers = 4;
  double fit_sample_weight = 0.05;  ///< [s] of one position in the running means
  /// [s] one position, or outlier, counts no more. Kept for PersonTest.MotionThatIsNoReachIsAMisfitAndTeachesNothing.
  double max_counted_nis = 9.0;
  double misfit_nis = 6.0;           ///< [s] mean above which the model does not fit
  double misfit_correlation = 0.75;  ///< [s] correlation above which the model does not fit
  /// [s] unless the mean NIS is below this. Kept for PersonReach.BringsPeopleToTheRealTarget, with a tracker without
  /// noise.
  double min_correlated_nis = 1.0;

  // Rest and motion: core/tracker/finger_phase.h.
  PhaseTuning phase;

  // Pauses.
  double min_pausing_nis = 6.0;          ///< [s] a pause surprises the filter by this
  double min_pausing_speed_mm_s = 25.0;  ///< mm/s [s] pauses of a slower finger are not detected
  double pause_clock_sd_s = 0.07;        ///< s [s] SD of the clock, added on entry and on exit
  double reaction_time_s = 0.2;          ///< s [m] from a moved target to the person's answer

  // Plan.
  double change_weight_mm_deg = 0.08;  ///< mm/deg [s] of miss that a degree of change of the felt shift is worth
  double weight_caution = 0.2;         ///< [s] the plan's weight is lower by this many SDs
  double min_plan_weight = 0.03;       ///< lower limit of the same

  // Flags.
  double last_phase = 0.97;         ///< [m] fraction of the duration after which no plate is answered
  double first_judged_phase = 0.5;  ///< [s] fraction before which OFF_TARGET is not raised
  double min_margin_deg = 0.3;      ///< deg [s] the gap is unreachable if the margin is below this
  double margin_deviations = 0.9;   ///< [s] SDs subtracted from min_margin_deg
  double min_aim_fraction =
      0.1;  ///< fraction of the path left below which the bearing of the target is no longer updated

  // Tracker noise that the host knows.
  double min_known_noise_mm = 0.02;         ///< mm [s] least of each part: without noise every trace is the person's
  double white_noise_fraction = 0.66;       ///< [s] of a total noise; with the next one its squares add up to 1
  double correlated_noise_fraction = 0.75;  ///< [s]
  double min_leg_mm = 10.0;  ///< mm [s] distance below which the tracker's noise dominates a bearing of a moved target

  // Learning.
  double wander_step = 0.5;        ///< [s] eps of motion_log.h
  double wander_evidence = 0.8;    ///< [s] beta of motion_log.h
  double max_wander_change = 1.0;  ///< [s] of log_wander in one reach: beyond it the likelihood is no parabola
  /// [s] fraction of the duration below which a reach changes no estimate, as hrt_adaptation promises.
  double min_taught_phase = 0.7;
  /// [s] drop of the weight, in SDs, at which the illusion is reset. Kept for
  /// SimulationPeople.ThoseWhoWeakenAreLedAnew.
  double illusion_fall_deviations = 1.2;
  double min_scatter_deg = 0.2;                     ///< deg [s] lower bound of the scatter
  double min_carried_weight_sd = 0.01;              ///< [s] of the paper's estimator: people change
  double min_carried_motor_variance_sd_deg2 = 0.1;  ///< deg^2 [s] of the paper's estimator
};

/// A field of a Tuning by its name, and the range in which it may be set.
struct TuningField {
  std::string name;
  double* value;
  double min, max;
};

/// All fields of `tuning`. Allocates.
std::vector<TuningField> tuning_fields(Tuning& tuning);

}  // namespace hrt
