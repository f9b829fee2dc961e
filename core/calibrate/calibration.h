// Calibration: estimates the illusion curve, the bias and the habit of a participant, and the noise of the tracker,
// from slides over a plate at rest, and tests whether the model fits them. The paper (section V) names a calibration
// but no method; ours is derived in README.md. Allocates. Any thread.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/calibrate/person_fit.h"
#include "core/calibrate/slide_track.h"
#include "core/tracker/tracker_noise.h"

namespace hrt {

struct CalibratedSlide {
  std::size_t trial;          ///< index of the slide in the data, from 0
  double plate_deg;           ///< direction of the ridge normal, relative to the direction of the target
  SlideDirections parts_deg;  ///< directions of the parts of the path, relative to the direction of the target
  SlideDirections fitted_deg;
  SlideVerdict verdict;
};

struct CurvePoint {
  double offset_deg;
  Interval shift_deg;
};

/// `known` of an estimate is false if the slides do not fit the model (fits() is false) or do not determine the
/// estimate; in `band`, it is always true. An offset is the angle from the motion to the ridge normal.
struct Calibration {
  /// shift of the perceived direction divided by the offset: mean of the values at 60 degrees to both sides
  Interval tactile_weight;
  Interval bias_deg;     ///< goal direction at the middle of the path minus target direction, left positive
  Interval habit_deg;    ///< goal direction at the start of the path minus that at its end, halved
  Interval max_gap_deg;  ///< largest shift for offsets up to 75 degrees: the smaller one of both sides
  double peak_offset_deg = curve_bound_deg;  ///< smallest offset that causes max_gap_deg
  Interval slope;                            ///< w of the controller's curve w t - b t (t / 75)^2 over the offset t
  Interval curve;                            ///< b of that curve
  double slope_curve_correlation = 0.0;
  RestNoise noise;  ///< noise of the tracker, from the rests before the slides

  std::vector<CurvePoint> band;  ///< illusion curve from -75 to 75 degrees
  LackOfFit lack_of_fit;
  std::vector<CalibratedSlide> slides;  ///< slides over a plate at rest, including those that are not fitted
  std::size_t slides_turned = 0;        ///< number of excluded slides, in which the plate turned
  double max_plate_deg = 0.0;           ///< largest absolute plate angle of the fitted slides

  /// True if no test for lack of fit is significant.
  bool fits() const;
  std::size_t count(SlideVerdict verdict) const;
  /// Returns recommended actions, one sentence each; empty if none is needed.
  std::vector<std::string> advice() const;
};

/// The slides over a plate at rest, and the indices of their trials as `order`.
struct CalibrationSlides {
  std::vector<SlideTrack> resting;
  std::vector<double> order;
  std::size_t turned = 0;  ///< number of slides that are excluded because the plate turned
};

/// A rejected calibration; `reason` states the mistake, the requirement and what to do, in at most 160 characters.
struct CalibrationRefusal {
  std::string reason;
};

/// Fits a calibration in short steps. `goal_direction_deg`: direction of the target, finite.
///
/// Requires at least `min_trials` usable slides of at least 30 mm, at three or more plate angles that span 40 degrees:
/// one angle alone cannot separate the tactile weight from a bias. Rejects a tactile weight whose interval is not
/// within (0.02, 0.48).
class CalibrationFit {
 public:
  CalibrationFit(std::vector<CalibrationTrial> trials, double goal_direction_deg);
  CalibrationFit(const CalibrationFit&) = delete;
  CalibrationFit& operator=(const CalibrationFit&) = delete;
  ~CalibrationFit() = default;
  /// Returns true when the fit is finished; do not call step() after that.
  bool step();
  const std::variant<Calibration, CalibrationRefusal>& result() const { return result_; }

 private:
  bool refuse(std::string reason);
  bool begin();
  bool describe();
  void add_details();

  std::vector<CalibrationTrial> trials_;
  double goal_direction_deg_;
  std::size_t next_trial_ = 0;
  CalibrationSlides slides_;
  std::optional<PersonFitting> person_;
  std::optional<std::vector<std::vector<TimedPoint>>> rests_;  // rests before the slides described so far
  std::optional<RestNoiseFit> noise_;
  std::variant<Calibration, CalibrationRefusal> result_;
};

/// Runs all steps of a CalibrationFit.
std::variant<Calibration, CalibrationRefusal> calibrate(const std::vector<CalibrationTrial>& trials,
                                                        double goal_direction_deg = 0.0);

inline constexpr int min_trials = 10;

}  // namespace hrt
