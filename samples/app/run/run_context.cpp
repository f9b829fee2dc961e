#include "samples/app/run/run_context.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "samples/app/text/format.h"

namespace hrt::app {

std::string within_s(XrDuration limit_ns) { return format("within %g s", static_cast<double>(limit_ns) * 1e-9); }

double distance_along_plate_m(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[2] - b[2]); }

hrt_session_config config_of(const RunContext& context) {
  hrt_session_config config{.struct_size = sizeof config};
  context.plugin.check(context.plugin.hrt_session_get(context.targets.session, &config, nullptr));
  return config;
}

Fingertip locate(const RunContext& context, Hand hand, XrTime time) {
  if (context.touch != nullptr) return context.touch->locate();
  Fingertip tip = context.session.locate(hand, time);
  if (!tip.tracked || context.skin_m == Point{}) return tip;
  if (!tip.rotation) return {};
  Eigen::Map<Eigen::Vector3d>(tip.position_m.data()) +=
      Eigen::Quaterniond(tip.rotation->data()) * Eigen::Vector3d(context.skin_m.data());
  return tip;
}

hrt_sample sample_of(XrTime time, const Fingertip& tip, std::optional<double> plate_orientation_deg) {
  hrt_sample sample{.struct_size = sizeof sample};
  sample.time_ns = time;
  if (tip.tracked) {
    sample.flags |= HRT_SAMPLE_PLATE_POSITION;
    std::copy(tip.position_m.begin(), tip.position_m.end(), sample.finger_position_m);
  }
  if (tip.lifted) sample.flags |= HRT_SAMPLE_LIFTED;
  if (plate_orientation_deg) {
    sample.flags |= HRT_SAMPLE_PLATE_ORIENTATION;
    sample.plate_orientation_deg = *plate_orientation_deg;
  }
  return sample;
}

hrt_sample world_sample_of(XrTime time, const Fingertip& joint, std::optional<double> plate_orientation_deg) {
  hrt_sample sample = sample_of(time, joint, plate_orientation_deg);
  if (joint.tracked) sample.flags ^= HRT_SAMPLE_PLATE_POSITION | HRT_SAMPLE_WORLD_POSITION;
  return sample;
}

void instruct(RunContext& context, Hand hand, double direction_deg, double distance_m) {
  Point start_m = context.targets.start_m;
  start_m[1] += tip_height_m;
  context.simulation->instruct(hand, start_m, direction_deg, distance_m);
}

XrTime next_frame(RunContext& context) {
  const XrTime time = context.session.next_frame();
  context.plate.service(time);
  if (context.handle_keys) context.handle_keys(time);
  return time;
}

}  // namespace hrt::app
