// Phase of a tracked finger: waiting before the first motion, moving, paused, or lifted.
//
//   waiting --left--> moving --still--> paused --left--> moving
//   any --lift()--> lifted --next position--> waiting, or paused after a motion
//
// sigma is the SD of the noise of a coordinate: known, or estimated (noise_learner.h). Tests, with default PhaseTuning:
//
//   left     |mean of the last 3 positions - rest position| > max(3.3 sigma, 1 mm). White noise exceeds this limit in 1
//            of 10^7 means. If the noise is estimated, sigma is at least 1 + 2 / n times the SD that n differences of
//            successive positions show.
//   still    Uses the positions of the last T seconds, at least 10, and none before the detection of the motion. Their
//            displacement d along the least-squares line is below a limit. The sagitta of the least-squares parabola is
//            at most four times this limit, since a finger that turns back has no displacement. If the speed v of the
//            motion is known: T = 0.11 s, d < 2.5 sigma and d + sigma < v T. Otherwise T = 0.11 s + 2.5 sigma /
//            (15 mm/s), so that a slow motion is not mistaken for a rest, and d < max(2.5 sigma, 8.6 mm/s T), since a
//            resting hand drifts.
//   outlier  At rest, a position further from the last one than 600 mm/s * elapsed time + 5.7 sigma (4 SDs of a
//            difference) is ignored, at most twice in succession. The third one begins a rest at another position.
//   rest     The rest position is the running mean of positions within 3 sigma of it, with a memory of 1 s. If a finger
//            leaves and returns within 0.5 s, the rest continues. Its duration restarts after 0.2 s without a position.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <optional>

#include "core/plate/plate_frame.h"
#include "core/tracker/noise_learner.h"
#include "core/tracker/recent_places.h"

namespace hrt {

/// Parameters of the detector. Fields `..._deviations` are in units of sigma. Numbers were chosen by search on the
/// simulated people of hrt-study robustness, except numbers with [model], which were set by the statistics of the
/// noise.
struct PhaseTuning {
  double leaving_deviations = 3.3;  ///< distance from the rest position at which the mean of 3 positions has left
  double min_leaving_mm = 1.0;      ///< mm: lower limit of this distance, for tremor and motion of the skin
  double hidden_share = 2.0;        ///< the SD that n differences show is multiplied by 1 + hidden_share / n
  double still_places = 10;         ///< minimum number of positions in the test "still"
  double still_s = 0.11;            ///< s: minimum duration of the test "still"
  double still_deviations = 2.5;    ///< limit of the displacement in the test "still"
  double slow_mm_s = 15.0;  ///< mm/s: a motion at this speed fails the test "still"; a slower motion may pass as a rest
  double max_creep_mm_s = 8.6;          ///< mm/s: upper limit of the drift of a resting hand
  double max_start_speed_mm_s = 600.0;  ///< mm/s: upper limit of the speed of a motion from rest
  double outlier_deviations = 5.7;      ///< [model] 4 SDs of the difference of two positions
  double max_outliers = 2;              ///< number of successive outliers that are ignored
  double rest_place_deviations = 3.0;   ///< [model] positions further from the rest position do not change it
  double place_memory_s = 1.0;          ///< s: memory of the mean of the rest position
  double start_tolerance_mm = 15.0;     ///< mm: a first position further from the expected start is a rest elsewhere
  /// a position closer to the rest position than this shows that the finger still rests
  double seen_at_rest_deviations = 1.0;
  double min_seen_at_rest_mm = 0.1;  ///< mm: lower limit of this distance
  double max_gap_s = 0.2;            ///< s: a longer time without a position restarts the duration of a rest
  double max_departure_s = 0.5;      ///< s: a shorter departure does not end the rest
  double min_place_sd_mm = 0.05;     ///< mm: lower limit of the SD of the rest position
};

enum class Phase {
  waiting,  ///< at rest, before its first motion
  moving,
  paused,  ///< at rest, after a motion
  lifted,
};

/// `Point`: PlatePoint, or Eigen::Vector3d for a tracked position off the plate (mm). Uses no heap, lock or exception.
/// One thread at a time.
template <class Point>
class PhaseDetector {
 public:
  /// `start`: expected position of the first rest; nullopt: unknown. `noise`: noise of the tracker, if it is known.
  explicit PhaseDetector(const std::optional<Point>& start = {}, const std::optional<TrackerNoise>& noise = {},
                         const PhaseTuning& tuning = {});

  enum class Outcome {
    ignored,  ///< an outlier during a rest
    merged,   ///< the position was averaged with the last one
    place,    ///< a new position
    set_down  ///< a new position, the first after a lift or at another rest position
  };
  /// Processes one position, not earlier than the last one. May set the phase to moving or, after a lift or a jump, to
  /// waiting or paused.
  Outcome process(double time_s, const Point& position);
  /// Tests, after process(), whether a moving finger has come to rest, and returns true if the phase became paused.
  /// `expected_mm_s`: expected speed of the motion, if known. If the expected motion is so slow that a rest cannot be
  /// distinguished from it, no pause is found.
  bool find_pause(std::optional<double> expected_mm_s = {});
  /// Calls process() and, after a new position, find_pause(); with a time in nanoseconds.
  void observe(std::int64_t time_ns, const Point& position);
  void lift() { phase_ = Phase::lifted; }
  /// Sets the phase to paused: the finger rests at `place` from `time_s` on.
  void pause_at(double time_s, const Point& place);

  Phase phase() const { return phase_; }
  bool at_rest() const { return phase_ == Phase::waiting || phase_ == Phase::paused; }
  bool has_moved() const { return moved_; }
  /// Position of the present rest, or of the last one if the finger does not rest.
  const Point& rest_place() const { return rest_.place; }
  /// SD of a coordinate of the rest position.
  double rest_place_sd_mm() const;
  /// Mean of the last three positions, or of all if there are fewer. Requires a position.
  Point smoothed() const { return places_.mean_of_last(std::min(3, places_.count())); }
  /// Duration of the rest; 0 unless at_rest().
  double rest_s() const { return at_rest() && places_.count() > 0 ? places_[0].time_s - rest_.since_s : 0.0; }
  /// Last time at which a position was close to the rest position.
  double left_s() const { return rest_.seen_s; }
  const RecentPlaces<Point>& places() const { return places_; }
  const TrackerNoise& noise() const { return noise_.noise(); }
  const NoiseLearner<Point>& learner() const { return noise_; }

 private:
  struct Rest {
    Point place;
    int places = 0;        // number of positions in the mean
    int seen = 0;          // positions since the rest began
    double since_s = 0.0;  // time at which the rest began
    double seen_s = 0.0;   // last time at which a position was close to `place`
  };
  double sigma_mm() const;
  bool is_outlier(double time_s, const Point& position);
  bool has_left() const;
  double leaving_mm() const;
  void add_to_rest();
  void set_down();

  PhaseTuning tuning_;
  NoiseLearner<Point> noise_;
  RecentPlaces<Point> places_;
  Rest rest_;
  std::optional<std::int64_t> origin_ns_;  // time of the first observe()
  Phase phase_ = Phase::waiting;
  bool start_known_;
  bool moved_ = false;
  double moving_since_s_ = 0.0;
  int successive_outliers_ = 0;
};

using FingerPhase = PhaseDetector<PlatePoint>;
extern template class PhaseDetector<PlatePoint>;
extern template class PhaseDetector<Eigen::Vector3d>;

}  // namespace hrt
