// The guided calibration: slides straight ahead, each over a plate at rest at another angle, until the plugin
// knows the user well enough.
#pragma once

#include <cstdint>
#include <ostream>
#include <vector>

#include "samples/reach/run/stage.h"

namespace hrt::reach {

struct CalibrationOutcome {
  hrt_calibration_result result;
  bool enough;                                ///< else the time ran out first
  std::vector<hrt_calibration_slide> slides;  ///< what the plugin made of each
};

/// The slides of one calibration, across as many sessions as the runtime makes necessary.
class GuidedCalibration {
 public:
  /// `targets` gives the plate, the start and the plugin's session. `limit_ns`: the whole calibration ends
  /// with the first slide after it. `seed` draws a simulated user's noise.
  GuidedCalibration(const Plugin& plugin, const TargetSet& targets, XrDuration limit_ns, std::uint64_t seed);
  ~GuidedCalibration();
  GuidedCalibration(const GuidedCalibration&) = delete;
  GuidedCalibration& operator=(const GuidedCalibration&) = delete;

  /// Goes through the slides that are left, with instructions in plain words on stage.tell_user and a line a
  /// slide on `out`. Throws as run_reach(); an unfinished slide does not count, and the next call repeats it.
  /// Throws Failure (ExitCode::calibration) if the slides do not determine the user.
  CalibrationOutcome run(Stage& stage, std::ostream& out);

  std::uint32_t slides() const { return slides_; }

 private:
  template <class Call>
  void compute(Stage& stage, Call&& call);
  double next_angle_deg(Stage& stage);
  void turn_plate(Stage& stage, double orientation_deg) const;
  bool slide(Stage& stage, double plate_orientation_deg);
  CalibrationOutcome solve(Stage& stage);

  const Plugin& plugin_;
  const TargetSet& targets_;
  XrDuration limit_ns_;
  std::uint64_t seed_;
  double distance_m_;
  hrt_calibration calibration_{};
  std::uint32_t slides_ = 0;
  bool enough_ = false;
  int failed_ = 0;           // slides in a row that did not count
  XrDuration spent_ns_ = 0;  // in sessions that ended, less what the plugin took to compute
};

}  // namespace hrt::reach
