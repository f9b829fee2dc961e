// A finger that rests on the plate while the plate turns to and fro under it: what shows a tracker's latency.
#pragma once

#include <span>
#include <vector>

#include "core/setup/setup_step.h"
#include "core/tracker/tracker_latency.h"

namespace hrt {

/// Takes its memory at construction; observe() takes none. Keeps at most 250 positions a second.
class CarriedFinger {
 public:
  CarriedFinger();

  /// The plate turns about `plate_orientation_deg` from now on.
  void begin(std::int64_t time_ns, double plate_orientation_deg);
  void observe(const SetupSample& sample);

  bool complete() const { return complete_; }
  /// The finger left or was lost: it is to begin again.
  SetupProblem problem() const { return problem_; }
  /// What the plate is to do now.
  double plate_orientation_deg() const { return now_deg_; }
  /// Seconds of `of`.
  int done_s() const { return done_s_; }
  static int of_s();
  std::span<const CarriedSample> samples() const { return samples_; }

 private:
  std::vector<CarriedSample> samples_;
  std::int64_t began_ns_ = 0;
  std::int64_t seen_ns_ = 0;
  double middle_deg_ = 0.0;
  double now_deg_ = 0.0;
  int done_s_ = 0;
  bool complete_ = false;
  SetupProblem problem_ = SetupProblem::none;
};

}  // namespace hrt
