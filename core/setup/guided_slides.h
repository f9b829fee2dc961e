// Slides back and forth along guides, from the start to each object, without lifting. The vector from the start to an
// object does not depend on the point of contact on the skin, or on a shift of the tracker's frame.
#pragma once

#include <algorithm>
#include <array>

#include "core/plate/touched_frame.h"
#include "core/setup/setup_step.h"
#include "core/tracker/finger_phase.h"

namespace hrt {

/// Uses no heap, lock or exception.
class GuidedSlides {
 public:
  static constexpr int max_objects = 8;
  static constexpr int slides_an_object = 6;  ///< alternately to the object and back

  /// Awaits slides between `start` and each of the places where guides end, min_guide_mm away at least.
  GuidedSlides(const PlatePoint& start, const std::array<PlatePoint, max_objects>& ends, int count);

  static constexpr double min_guide_mm = 40.0;

  void observe(const SetupSample& sample);
  /// Forgets all slides.
  void restart();

  bool complete() const { return object_ == count_; }
  int done() const { return object_ * slides_an_object + std::max(0, rests_ - 1); }
  int of() const { return count_ * slides_an_object; }
  int object() const { return object_; }
  /// Slides to the object that did not count.
  int failed() const { return failed_; }
  bool has_begun() const { return rests_ > 0; }
  /// Position at which the finger is to rest next.
  const PlatePoint& next() const;
  SetupProblem problem() const { return problem_; }

  /// The tracker's frame about the start. None: slides that do not fit each other. Requires complete().
  std::optional<TouchedFrame> fit() const;

 private:
  static constexpr int rests_an_object = slides_an_object + 1;  // alternately at the start and at the object
  using Rests = std::array<PlatePoint, rests_an_object>;
  struct Seen {
    Eigen::Vector2d from_start_mm;
    double square_mm2;  // mean square of the deviations of one coordinate from their mean
  };
  std::optional<Seen> seen(const Rests& rests) const;
  void again(SetupProblem problem);
  void come_to_rest(const PlatePoint& place, bool long_since);

  PlatePoint start_;
  std::array<PlatePoint, max_objects> ends_;
  int count_;
  std::array<Rests, max_objects> seen_{};
  int object_ = 0;
  int rests_ = 0;  // rests of this object
  int failed_ = 0;
  SetupProblem problem_ = SetupProblem::none;
  FingerPhase finger_;
  std::int64_t seen_ns_ = 0;
};

}  // namespace hrt
