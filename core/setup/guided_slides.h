// Slides back and forth along guides, from the start to each object, without lifting. They measure the vectors from the
// start to the objects, which do not depend on the point of contact on the skin or on a shift of the tracker's frame.
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

  /// Waits for slides between `start` and the ends of `count` guides, which are at least min_guide_mm long.
  GuidedSlides(const PlatePoint& start, const std::array<PlatePoint, max_objects>& ends, int count);

  static constexpr double min_guide_mm = 40.0;

  void observe(const SetupSample& sample);
  void restart();

  bool complete() const { return object_ == count_; }
  int done() const { return object_ * slides_an_object + std::max(0, rests_ - 1); }
  int of() const { return count_ * slides_an_object; }
  int object() const { return object_; }
  /// Number of failed attempts to complete the slides of the present object.
  int failed() const { return failed_; }
  bool has_begun() const { return rests_ > 0; }
  /// Position of the next rest.
  const PlatePoint& next() const;
  SetupProblem problem() const { return problem_; }

  /// Returns the correction of the tracker's frame; nullopt if the slides are inconsistent. Requires complete().
  std::optional<TouchedFrame> fit() const;

 private:
  static constexpr int rests_an_object = slides_an_object + 1;  // alternately at the start and at the object
  using Rests = std::array<PlatePoint, rests_an_object>;
  struct MeasuredObject {
    Eigen::Vector2d from_start_mm;
    double square_mm2;  // sum of the squared distances of the three measured vectors from their mean
  };
  std::optional<MeasuredObject> measured(const Rests& rests) const;
  void again(SetupProblem problem);
  void come_to_rest(const PlatePoint& place, bool long_since);

  PlatePoint start_;
  std::array<PlatePoint, max_objects> ends_;
  int count_;
  std::array<Rests, max_objects> seen_{};
  int object_ = 0;
  int rests_ = 0;  // number of rests for this object
  int failed_ = 0;
  SetupProblem problem_ = SetupProblem::none;
  FingerPhase finger_;
  std::int64_t seen_ns_ = 0;
};

}  // namespace hrt
