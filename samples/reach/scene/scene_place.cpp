#include "samples/reach/scene/scene_place.h"

#include <cmath>

#include "samples/format.h"
#include "samples/reach/base/exit_code.h"

namespace hrt::reach {
namespace {

double asked_eye_height_m(Prompt& prompt) {
  const std::optional<double> answer = prompt.ask_number(
      "How high are your eyes above the floor, in metres? Seated about 1.2, standing about 1.6. Then press "
      "Enter.",
      0.3, 2.5);
  if (answer) return *answer;
  throw Failure(ExitCode::usage,
                "the OpenXR runtime knows no floor, so the height of the plate is unknown: give the height of the eyes "
                "above the floor (--eye-height METRES), or register the plate (--register FILE)");
}

std::string words_of(const ScenePlace& place, double above_floor_m) {
  const XrVector3f& at = place.pose.position;
  const char* from = place.space == XR_REFERENCE_SPACE_TYPE_STAGE
                         ? "the centre of the runtime's room"
                         : "where you were when the runtime last centred its view";
  return format("The plate is assumed where the scene has it: %.2f m above the floor, ", above_floor_m) +
         format("%.2f m to the %s and ", std::abs(static_cast<double>(at.x)), at.x < 0.0f ? "left" : "right") +
         format("%.2f m %s, seen from ", std::abs(static_cast<double>(at.z)), at.z > 0.0f ? "behind" : "ahead") + from +
         " (" + name_of(place.space) +
         " space). If it is elsewhere, start again with --register FILE, which finds it by touches.";
}

}  // namespace

ScenePlace place_of(const TargetSet& targets, const XrHeadlessSession& session, std::optional<double> eye_height_m,
                    Prompt& prompt) {
  ScenePlace place{.space = session.floor_space(), .pose = targets.plate_pose, .words = {}};
  if (place.space == XR_REFERENCE_SPACE_TYPE_LOCAL)
    place.pose.position.y -= static_cast<float>(eye_height_m ? *eye_height_m : asked_eye_height_m(prompt));
  place.words = words_of(place, static_cast<double>(targets.plate_pose.position.y));
  return place;
}

}  // namespace hrt::reach
