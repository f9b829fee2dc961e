#include "core/setup/setup_progress.h"

#include <limits>

#include "core/math/time.h"

namespace hrt {
namespace {

constexpr double min_sample_s = 2e-5;  // no tracker has 50 samples in a millisecond
constexpr double far_mm = 1000.0;
constexpr double near_mm = 25.0;

}  // namespace

void SetupProgress::observe(const SetupSample& sample) {
  if (!since_ns_) since_ns_ = sample.time_ns;
  now_ns_ = sample.time_ns;
  if (samples_ < std::numeric_limits<int>::max()) ++samples_;
  seen_ = seen_ || sample.on_plate.observation != Observation::none;
  touched_ = touched_ || sample.on_plate.observation == Observation::position;
  if (sample.tracked_mm) finger_ = sample.on_plate.position;
  plate_deg_ = sample.on_plate.plate_orientation_deg;
}

Observed SetupProgress::observed(const std::optional<PlatePoint>& place,
                                 const std::optional<double>& commanded_deg) const {
  using Kind = Observed::Kind;
  if (!may_be_stuck()) return {};
  const double passed_s = elapsed_s(*since_ns_, now_ns_);
  const double sample_s = passed_s / (samples_ - 1);
  if (samples_ >= many_samples && sample_s < min_sample_s) return {Kind::time, 1e9 * sample_s, 0.0};
  if (passed_s < 1e-9 * static_cast<double>(patience_ns)) return {};
  if (commanded_deg && plate_deg_) return {Kind::plate, *plate_deg_, *commanded_deg};
  if (!seen_) return {Kind::no_finger, 0.0, 0.0};
  if (!place) return {Kind::no_rest, 0.0, 0.0};
  const double off_mm = finger_ ? distance_mm(*place, *finger_) : 0.0;
  if (off_mm > far_mm) return {Kind::far_away, off_mm, 0.0};
  if (!touched_) return {Kind::lifted, 0.0, 0.0};
  if (off_mm > near_mm) return {Kind::elsewhere, off_mm, 0.0};
  return {Kind::no_rest, 0.0, 0.0};
}

}  // namespace hrt
