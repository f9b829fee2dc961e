// Detects one slide, or its problem: the plate turns; the finger rests at the start, leaves it, and rests ahead of it.
#pragma once

#include "core/setup/setup_step.h"
#include "core/tracker/finger_phase.h"

namespace hrt {

/// Uses no heap, lock or exception.
class SlideWatch {
 public:
  enum class Phase : std::uint8_t { plate_turns, rest_at_start, slide, done };

  /// Waits for a slide straight ahead.
  void begin(const PlatePoint& start, double distance_mm, double plate_orientation_deg);
  /// Returns true if the sample belongs to the slide or to the rest before it. is_first(): it is the first such sample.
  bool observe(const SetupSample& sample);

  Phase phase() const { return phase_; }
  bool is_first() const { return first_; }
  bool has_left() const { return left_ns_.has_value(); }
  SetupProblem problem() const { return problem_; }
  /// Number of rejected slides since begin().
  int failed() const { return failed_; }
  /// Bearing of the last rejected slide, if it was more than 90 degrees from straight ahead.
  const std::optional<double>& wrong_way_deg() const { return wrong_way_deg_; }
  /// True if the plate has reported other orientations than the commanded one for a minute.
  bool plate_is_stuck() const { return plate_is_stuck_; }

 private:
  void again(SetupProblem problem);
  void fail(SetupProblem problem);
  void await_plate(const SetupSample& sample);
  bool await_rest(const SetupSample& sample);
  bool follow(const SetupSample& sample);
  void come_to(std::int64_t time_ns);
  bool plate_is_off(const SetupSample& sample, double tolerance_deg) const;

  PlatePoint start_;
  double distance_mm_ = 0.0;
  double plate_orientation_deg_ = 0.0;
  Phase phase_ = Phase::done;
  SetupProblem problem_ = SetupProblem::none;
  int failed_ = 0;
  std::optional<double> wrong_way_deg_;
  bool plate_is_stuck_ = false;
  bool first_ = false;
  bool resting_ = false;  // the finger is near the start: its samples are stored
  FingerPhase finger_;
  PlatePoint rest_;  // position of the rest at the start
  std::optional<std::int64_t> asked_ns_;
  std::optional<std::int64_t> left_ns_;
  std::int64_t seen_ns_ = 0;
};

}  // namespace hrt
