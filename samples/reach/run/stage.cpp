#include "samples/reach/run/stage.h"

#include <algorithm>
#include <cmath>

#include "samples/format.h"

namespace hrt::reach {
namespace {

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// v + 2 q x (q x v + w v), of a unit quaternion (q, w).
Point rotated(const std::array<double, 4>& r, const Point& v) {
  const Point q{r[0], r[1], r[2]};
  Point inner = cross(q, v);
  for (std::size_t i = 0; i < 3; ++i) inner[i] += r[3] * v[i];
  const Point outer = cross(q, inner);
  return {v[0] + 2.0 * outer[0], v[1] + 2.0 * outer[1], v[2] + 2.0 * outer[2]};
}

}  // namespace

std::string within_s(XrDuration limit_ns) {
  return format("within %g s", static_cast<double>(limit_ns) * 1e-9);
}

double distance_along_plate_m(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[2] - b[2]);
}

hrt_session_config config_of(const Stage& stage) {
  hrt_session_config config{.struct_size = sizeof config};
  stage.plugin.check(stage.plugin.hrt_session_get(stage.targets.session, &config, nullptr));
  return config;
}

Fingertip locate(const Stage& stage, Hand hand, XrTime time) {
  Fingertip tip = stage.session.locate(hand, time);
  if (!tip.tracked || stage.skin_m == Point{}) return tip;
  if (!tip.rotation) return {};
  const Point to_skin_m = rotated(*tip.rotation, stage.skin_m);
  for (std::size_t i = 0; i < 3; ++i) tip.position_m[i] += to_skin_m[i];
  return tip;
}

hrt_sample sample_of(XrTime time, const Fingertip& tip, std::optional<double> plate_orientation_deg) {
  hrt_sample sample{.struct_size = sizeof sample};
  sample.time_ns = time;
  if (tip.tracked) {
    sample.flags |= HRT_SAMPLE_PLATE_POSITION;
    std::copy(tip.position_m.begin(), tip.position_m.end(), sample.finger_position_m);
  }
  if (plate_orientation_deg) {
    sample.flags |= HRT_SAMPLE_PLATE_ORIENTATION;
    sample.plate_orientation_deg = *plate_orientation_deg;
  }
  return sample;
}

void instruct(Stage& stage, Hand hand, double direction_deg, double distance_m) {
  Point start_m = stage.targets.start_m;
  start_m[1] += tip_height_m;
  stage.simulation->instruct(hand, start_m, direction_deg, distance_m);
}

XrTime next_frame(Stage& stage) {
  const XrTime time = stage.session.next_frame();
  stage.plate.service(time);
  if (stage.attend) stage.attend(time);
  return time;
}

}  // namespace hrt::reach
