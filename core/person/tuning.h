// Tuned numbers, most of them of the controller for people. `hrt-study robustness --tune NAME=VALUE` runs a variant;
// tuning_fields() lists names and ranges.
//
// Numbers were chosen by search on the simulated people of hrt-study robustness, except numbers with [model] (from the
// model, core/person/README.md) and [time] (limited by computing time). "Kept for" names a test that fails without this
// number, if the number changes the results in samples/study/RESULTS.md by less than half a percentage point.
#pragma once

#include <string>
#include <vector>

#include "core/person/person_state.h"
#include "core/tracker/finger_phase.h"

namespace hrt {

/// Prior of a trait of an unknown person.
struct TraitTuning {
  double mean;
  double sd;
  double change;     ///< SD of the change from one reach to the next
  double forgotten;  ///< fraction of the information from reaches that is forgotten after each reach
};

struct Tuning {
  // Prior, for unknown_person(), which gets mean and SD of the tactile weight, and the mean of the bias. In the rows of
  // weight and curve, mean and SD are in units of the given SD; the given mean is added to that of the weight.
  TraitTuning traits[PersonState::traits] = {
      {0.9, 1.7, 0.004, 0.05},  // weight
      {1.1, 1.6, 0.01, 0.02},   // curve
      {14.0, 4.0, 0.0, 0.1},    // gain, 1/s
      {0.0, 4.0, 0.25, 0.1},    // bias, deg
      {0.0, 9.0, 0.0, 0.1},     // habit, deg
      {0.05, 0.35, 0.0, 0.1},   // evenness
      {-0.65, 0.55, 0.0, 0.1},  // log_rate
      {0.05, 0.6, 0.0, 0.02},   // fading
      {1.2, 0.8, 0.0, 0.1},     // scatter, deg
      {1.4, 1.2, 0.0, 0.1},     // log_wander
  };
  double weight_curve_correlation = 0.85;  ///< prior correlation of weight and curve
  double steered_habit_sd_deg = 2.0;       ///< deg: upper limit of the SD of the habit with which a reach begins
  double known_weight_sd = 0.001;          ///< [model] this and the next three: SDs of known_person()
  double known_bias_sd_deg = 0.05;
  double known_fading_sd = 0.01;
  double known_scatter_sd_deg = 0.05;
  double min_weight_sd = 0.01;  ///< this and the next three: lower bounds of SDs in calibrated_person()
  double min_curve_sd = 0.015;  ///< includes the misfit of illusions that are not cubic
  double min_bias_sd_deg = 0.5;
  double min_habit_sd_deg = 0.4;
  double max_correlation = 0.95;        ///< largest correlation of weight and curve in calibrated_person()
  double given_duration_log_sd = 0.12;  ///< SD of log_rate if Reach::duration_s is given

  double touch_memory_s = 0.3;  ///< s: [model] time constant of the decay of the cue from touch
  double first_ridge = 1.2;     ///< second term of A (slowness()) after one ridge spacing of travel
  double max_slope = 3.0;       ///< [model] bound of |1 - dg/dtheta| in steer()

  // Filter. A density is the variance that a state gains per second as process noise.
  double first_direction = 0.2;            ///< h: initial direction as a fraction of the virtual direction
  double first_direction_sd = 0.45;        ///< SD of h from reach to reach
  double direction_density_deg2_s = 14.0;  ///< deg^2/s: density of psi, the steered direction
  double log_rate_density_s = 0.07;        ///< 1/s: density of rho, the log rate
  double place_density_mm2_s = 0.018;      ///< mm^2/s: density of x and z, the position
  /// s: density of the position along the motion, divided by the squared speed. Kept for
  /// RetargetTest.SteersAPersonToTheMovedTarget.
  double speed_variance_s = 4e-4;
  double resting_density_mm2_s = 0.5;  ///< mm^2/s: density of the position while the finger pauses or is lifted
  /// time constant of the wander, the random part of the own path, as a fraction of the duration
  double wander_phase = 0.35;
  double habit_scatter = 1.0;  ///< SD of the habit from reach to reach divided by the SD of the wander
  double min_return_fraction =
      0.1;                 ///< [model] smallest fraction of the path over which the finger returns to the line
  double pace_skew = 0.4;  ///< [model] skew of the pace
  double answer_s = 0.3;   ///< s: [model] time constant with which plans expect the response to a moved target
  /// s: [model] delay from the plate to the perceived direction; half of 0.12 s, the largest simulated delay
  double sensory_delay_s = 0.06;
  /// SD of the response to a moved target, as a fraction of the change of direction
  double turn_sd_fraction = 0.5;
  /// a moved target that lengthens the remaining path by more than this factor requires a second motion
  double max_stretch = 1.5;
  double new_motion_sd_s = 0.15;  ///< s: SD of the phase, as a time, at the beginning of the second motion

  double fit_spacing_s = 0.02;   ///< s: [time] spacing of the positions in the fit of the onset
  double rate_deviations = 0.8;  ///< step of the grid of log rates, in SDs of the prior
  double onset_sd_s = 0.02;      ///< s: SD of the estimated time of the onset

  double max_accepted_nis = 25.0;  ///< a position with a NIS above this is an outlier
  /// number of successive outliers before a position is accepted as a jump. Kept for
  /// PersonEstimatorTest.AnOutlierIsRejectedAndAJump_IsFollowed.
  double max_outliers = 4;
  double fit_sample_weight = 0.05;  ///< weight of one position in the running means of NIS and correlation
  /// upper bound of the NIS of one position in the mean NIS. Kept for
  /// PersonTest.ImpossibleMotionIsAMisfitAndChangesNoEstimate.
  double max_counted_nis = 9.0;
  double misfit_nis = 6.0;           ///< mean NIS above which the model does not fit
  double misfit_correlation = 0.75;  ///< mean correlation of successive innovations above which the model does not fit
  /// with a mean NIS below this, the model fits at any correlation. Kept for
  /// PersonReach.PeopleOfTheModel_ReachTheRealTarget, whose tracker has no noise.
  double min_correlated_nis = 1.0;

  // Rest and motion: core/tracker/finger_phase.h.
  PhaseTuning phase;

  double min_pausing_nis = 6.0;          ///< lower bound of the NIS of the first position of a pause
  double min_pausing_speed_mm_s = 25.0;  ///< mm/s: while the filter expects a lower speed, no pause is detected
  double pause_clock_sd_s = 0.07;        ///< s: SD of the phase, as a time, added at both ends of a pause and at a jump
  double reaction_time_s = 0.2;          ///< s: [model] time from a target's move to the person's response

  /// mm/deg: miss that costs as much as a change of the shift by one degree
  double change_weight_mm_deg = 0.08;
  double weight_caution = 0.2;    ///< number of SDs by which the plan's weight is below the mean
  double min_plan_weight = 0.03;  ///< lower limit of the plan's weight

  /// [model] fraction of the duration after which the person no longer responds to the plate
  double last_phase = 0.97;
  double first_judged_phase = 0.5;  ///< fraction of the duration from which on the predicted miss sets off_target
  double min_margin_deg = 0.3;      ///< deg: a gap larger than the largest shift minus this margin is unreachable
  double margin_deviations = 0.9;   ///< number of SDs of shift minus gap that are subtracted from min_margin_deg
  /// if the finger is nearer to the target than this fraction of the target's distance from the start,
  /// PlateCommand::aimed_direction_deg is not the direction from the finger
  double min_aim_fraction = 0.1;

  /// mm: lower limit of the white and of the correlated part of a configured noise; without noise, every deviation
  /// would be attributed to the person
  double min_known_noise_mm = 0.02;
  double white_noise_fraction = 0.66;       ///< white part of a configured total noise, as a fraction
  double correlated_noise_fraction = 0.75;  ///< correlated part; the squares of both fractions add up to about 1
  double min_leg_mm = 10.0;                 ///< mm: in a retarget, shorter distances do not determine a direction

  /// difference of log_wander between the three filters that MotionLog compares
  double wander_step = 0.5;
  /// factor of the log likelihood of a motion; below 1, because successive positions are correlated
  double wander_evidence = 0.8;
  /// limit of the change of log_wander in one reach: for larger changes the quadratic approximation is invalid
  double max_wander_change = 1.0;
  double min_taught_phase = 0.7;  ///< a reach that ends before this fraction of the duration does not change the prior
  /// drop of the weight, in SDs before the reach, at which a reach that missed resets the illusion to its prior. Kept
  /// for SimulationPeople.AWeightThatDrops_IsEstimatedAgainWithinTwoReaches.
  double illusion_fall_deviations = 1.2;
  /// fraction by which the estimated scatter falls for each unit by which the estimate of log_wander rises
  double scatter_wander = 0.4;
  /// deg: error of the bias (RMS) that the covariance does not contain; the SD of the linear illusion's weight has it
  double hidden_bias_deg = 2.5;
  double min_scatter_deg = 0.2;  ///< deg: lower bound of the scatter
  /// lower bound of the SD of the tactile weight after a reach under the paper's controller, since people change
  double min_carried_weight_sd = 0.01;
  /// deg^2: lower bound of the SD of the motor variance after a reach under the paper's controller
  double min_carried_motor_variance_sd_deg2 = 0.1;
};

struct TuningField {
  std::string name;
  double* value;
  double min, max;  ///< range in which the value may be set
};

/// Returns all fields of `tuning`. Allocates.
std::vector<TuningField> tuning_fields(Tuning& tuning);

}  // namespace hrt
