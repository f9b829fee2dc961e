// Calibration: curve of the illusion, bias and habit of a participant, and noise of the tracker, from slides over a
// plate at rest (paper section V, "calibration"; the method is ours, derived in core/calibrate/README.md), with a test
// of whether the model fits the slides at all. Allocates. Any thread.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/calibrate/person_fit.h"
#include "core/calibrate/slide_track.h"
#include "core/tracker/tracker_noise.h"

namespace hrt {

/// Result for one slide of the data.
struct CalibratedSlide {
  std::size_t trial;          ///< index of the slide in the data, from 0
  double plate_deg;           ///< direction of the ridge normal, relative to the goal direction
  SlideDirections parts_deg;  ///< directions of its parts, relative to the goal direction
  SlideDirections fitted_deg;
  SlideVerdict verdict;
};

/// A point of the illusion's curve with the ends of its 95 % interval.
struct CurvePoint {
  double offset_deg;
  Interval shift_deg;
};

/// `known` of an estimate is false if the slides do not fit the model (fits() is false) or do not show it.
struct Calibration {
  Interval tactile_weight;                   ///< felt shift over offset at 60 degrees, mean of both sides, at the
                                             ///< pace of the slides
  Interval bias_deg;                         ///< goal at the middle of the path minus target direction, left positive
  Interval habit_deg;                        ///< half of the rotation of the goal over the path
  Interval max_gap_deg;                      ///< largest felt shift within 75 degrees, on the weaker side
  double peak_offset_deg = curve_bound_deg;  ///< smallest offset that gives it
  Interval slope;                            ///< w of the controller's curve w t - b t (t / 75)^2
  Interval curve;                            ///< b of it
  double slope_curve_correlation = 0.0;
  RestNoise noise;  ///< noise of the tracker, from the finger at rest before each slide

  std::vector<CurvePoint> band;  ///< curve with its interval, from -75 to 75 degrees
  LackOfFit lack_of_fit;
  std::vector<CalibratedSlide> slides;  ///< every trial with a slide over a plate at rest
  std::size_t slides_turned = 0;        ///< left out: the plate turned within them
  double max_plate_deg = 0.0;           ///< largest plate angle of the slides used; published human data cover 60

  /// No pattern is left in the residuals.
  bool fits() const;
  std::size_t count(SlideVerdict verdict) const;
  /// Recommended actions, one sentence each; empty if no action is needed.
  std::vector<std::string> advice() const;
};

/// The slides of trials over a plate at rest, with the trials' places in the data.
struct CalibrationSlides {
  std::vector<SlideTrack> resting;
  std::vector<double> order;
  std::size_t turned = 0;  ///< slides that are left out: the plate turned within them
};
CalibrationSlides slides_of(const std::vector<CalibrationTrial>& trials, double goal_direction_deg);

/// Refusal of a calibration: one sentence with the mistake and the requirement.
struct CalibrationRefusal {
  std::string reason;
};

/// `goal_direction_deg`: direction of the target that the participant goes for, finite.
///
/// Needs at least `min_trials` slides of at least 30 mm that count, at three plate angles or more that span
/// 40 degrees: one angle alone cannot separate w_T from a bias. Refuses a w_T whose interval is not within the usable
/// range (0.02, 0.48).
///
/// In steps of bounded time.
class CalibrationFit {
 public:
  CalibrationFit(std::vector<CalibrationTrial> trials, double goal_direction_deg);
  CalibrationFit(const CalibrationFit&) = delete;
  CalibrationFit& operator=(const CalibrationFit&) = delete;
  ~CalibrationFit() = default;
  /// Returns true at the end; no calls after that.
  bool step();
  const std::variant<Calibration, CalibrationRefusal>& result() const { return result_; }

 private:
  bool refuse(std::string reason);
  bool begin();
  bool describe();
  void add_details();

  std::vector<CalibrationTrial> trials_;
  double goal_direction_deg_;
  std::size_t trial_ = 0;  // index of the next slide to reduce
  CalibrationSlides slides_;
  std::optional<PersonFitting> person_;
  std::optional<std::vector<std::vector<TimedPoint>>> rests_;  // of the slides described so far
  std::optional<RestNoiseFit> noise_;
  std::variant<Calibration, CalibrationRefusal> result_;
};

/// All steps of it.
std::variant<Calibration, CalibrationRefusal> calibrate(const std::vector<CalibrationTrial>& trials,
                                                        double goal_direction_deg = 0.0);

inline constexpr int min_trials = 10;

}  // namespace hrt
