#include "samples/reach/run/stage.h"

#include <algorithm>
#include <cmath>

#include "samples/format.h"

namespace hrt::reach {
namespace {

constexpr double rest_m = 0.004;  // a finger that has moved less is at rest

}  // namespace

std::string within_s(XrDuration limit_ns) {
  return format("within %g s", static_cast<double>(limit_ns) * 1e-9);
}

double distance_along_plate_m(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[2] - b[2]);
}

Fingertip locate(const Stage& stage, Hand hand, XrTime time) {
  Fingertip tip = stage.session.locate(hand, time);
  const hrt_fingertip& skin = stage.fingertips[static_cast<std::size_t>(hand)];
  if (!tip.tracked || skin.known == 0) return tip;
  if (!tip.rotation) return {};
  hrt_joint_touch joint{};
  std::copy(tip.position_m.begin(), tip.position_m.end(), joint.position_m);
  std::copy(tip.rotation->begin(), tip.rotation->end(), joint.rotation);
  hrt_sample placed{.struct_size = sizeof placed};
  stage.plugin.check(stage.plugin.hrt_fingertip_place(&skin, &joint, &placed));
  std::copy_n(placed.finger_position_m, 3, tip.position_m.begin());
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

bool is_at_rest(const std::vector<Moment>& moments, XrTime finger_came, const Point& start_m, double min_m,
                XrDuration rest_ns) {
  const Moment& last = moments.back();
  if (!last.tracked || distance_along_plate_m(last.position_m, start_m) < min_m) return false;
  for (auto moment = moments.rbegin(); moment != moments.rend() && moment->time >= finger_came; ++moment) {
    if (!moment->tracked) continue;
    if (distance_along_plate_m(moment->position_m, last.position_m) > rest_m) return false;
    if (last.time - moment->time >= rest_ns) return true;
  }
  return false;
}

}  // namespace hrt::reach
