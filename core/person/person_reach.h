// A reach under the controller for people. A position passes through
//   estimate (person_estimator), plan (reach_control), limit (plate_limits), command.
#pragma once

#include <cstdint>
#include <optional>

#include "core/person/person_estimator.h"
#include "core/person/reach_control.h"
#include "core/plate/frame_error.h"
#include "core/plate/plate_limits.h"
#include "core/plate/plate_model.h"
#include "core/plate/touched_frame.h"
#include "core/reach/finger_sample.h"
#include "core/reach/reach.h"

namespace hrt {

struct PersonReachConfig {
  PersonBelief person;  ///< prior of the person; is_valid()
  ReachControlConfig control;
  PlateDynamics plate;
  std::optional<TrackerNoise> noise;                ///< noise of the tracker; nullopt: estimated while the finger rests
  std::int64_t tracker_latency_ns = 0;              ///< age of a position at the time of its sample, 0 to 0.5 s
  double tracker_bearing_sd_deg = 0.0;              ///< SD of the tracker's bearing error from reach to reach, 0 to 45
  std::int64_t step_period_ns = 100'000'000;        ///< period of the steps that PlateCommand::step counts
  bool plate_waits = false;                         ///< the plate does not turn before the motion
  bool start_is_felt = false;                       ///< the first rest of the finger is at the start, as in a dimple
  FrameCovariance frame = FrameCovariance::Zero();  ///< covariance of the plate's pose; is_frame_covariance()
  TouchedFrame touched;                             ///< correction of the tracker's frame by contacts
  Tuning tuning;
};

struct ReachGoal {
  Reach reach;        ///< present targets; the real one is seen from the start
  PlatePoint target;  ///< position of the real target
  /// Position of the finger when the targets last moved; nullopt if the targets have not moved during the motion.
  std::optional<PlatePoint> aimed_from;
  double aimed_direction_deg;  ///< direction of the real target from `aimed_from` or from the start
  double tracker_sd_deg;       ///< PersonReachConfig::tracker_bearing_sd_deg
  double frame_sd_deg;         ///< SD of the target's bearing from the start due to the uncertain pose of the plate

  /// Returns the largest observed miss, in degrees, for which the true miss is probably within hrt::near_deg; 0 if
  /// there is no such miss. With the observed miss x and the SD sigma of tracker and frame, the median of the squared
  /// true miss is about x^2 + 0.455 sigma^2.
  double near_deg() const;
};

/// Controller of one reach. Uses no heap, lock or exception. One thread at a time.
class PersonReach {
 public:
  /// `handover`: state of the reach that this one replaces; nullopt: the plate is at rest. Requires valid arguments.
  PersonReach(const PersonReachConfig& config, const Reach& reach,
              const std::optional<PlateHandover>& handover = std::nullopt);

  /// Processes a sample, not earlier than the previous one. An observed direction is ignored.
  const PlateCommand& update(const FingerSample& sample);

  /// Moves the targets. `real`: position of the real target. `now`: the remaining reach, from Retargeter::retarget().
  void retarget(const PlatePoint& real, const Reach& now);

  /// The last command; before the first sample, that of the constructor.
  const PlateCommand& command() const { return command_; }
  /// Position of the finger; nullopt before the motion.
  std::optional<PlatePoint> place() const;
  /// Variance of a coordinate of place(): mean over both coordinates.
  double place_variance_mm2() const;
  /// Estimated speed of the finger; 0 before the motion and in a pause.
  double speed_mm_s() const;
  /// True if at least one position was observed.
  bool seen() const { return position_ns_.has_value(); }
  ReachSummary summary() const;
  PlateHandover handover() const;
  const PersonFilter& filter() const { return estimator_.filter(); }
  const FingerPhase& finger() const { return estimator_.finger(); }

  /// Posterior of the person; nullopt before the phase Tuning::min_taught_phase, and after a misfit.
  std::optional<PersonBelief> learnt() const;

 private:
  struct Decision {
    PlateOrientation plate;
    double predicted_miss_deg = 0.0;
    bool unreachable = false;
  };

  void prepare_plate();
  Decision decide(const PersonFilter& answered, std::int64_t now_ns) const;
  PlateCommand command_now(const PersonFilter& answered, bool decided) const;
  void add_progress(const PersonFilter& answered, PlateCommand& command) const;
  PlatePoint on_plate(const PlatePoint& seen) const;

  PersonReachConfig config_;
  ReachGoal goal_;
  PersonEstimator estimator_;
  PlateModel plate_;
  PlateLimits limits_;
  Decision decision_;
  PlateCommand command_;
  ReachSummary counts_;
  bool prepared_ = false;  // prepare_plate() has given a command since the last sample
  double seen_s_ = 0.0;    // time from the first to the last sample
  double square_felt_sum_deg2_ = 0.0;
  std::int64_t felt_samples_ = 0;
  std::int64_t counted_step_ = -1;
  std::optional<std::int64_t> origin_ns_;  // time of the first sample
  std::optional<std::int64_t> position_ns_;
};

}  // namespace hrt
