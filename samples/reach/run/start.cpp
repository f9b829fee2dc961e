#include "samples/reach/run/start.h"

#include <algorithm>

#include "samples/reach/base/exit_code.h"
#include "samples/reach/run/sighting.h"

namespace hrt::reach {

Hand await_finger_at_start(Stage& stage) {
  const XrTime began = next_frame(stage);
  std::array<XrTime, 2> there_since{};
  Sightings sightings(stage.targets.start_m);
  for (XrTime time = began; time - began <= stage.time_limit_ns; time = next_frame(stage)) {
    for (const Hand hand : {Hand::left, Hand::right}) {
      const Fingertip tip = locate(stage, hand, time);
      sightings.see(hand, tip);
      if (std::find(stage.hands.begin(), stage.hands.end(), hand) == stage.hands.end()) continue;
      const bool there = tip.tracked && tip.position_m[1] <= lifted_height_m &&
                         distance_along_plate_m(tip.position_m, stage.targets.start_m) <= start_radius_m;
      XrTime& since = there_since[static_cast<std::size_t>(hand)];
      if (!there) {
        since = 0;
      } else if (since == 0) {
        since = time;
      } else if (time - since >= settle_ns) {
        return hand;
      }
    }
    if (stage.hint && time - began > settle_ns) stage.hint(sightings.where(stage));
  }
  throw Failure(ExitCode::no_hand, "no index finger came to the start " + within_s(stage.time_limit_ns) +
                                       ". " + sightings.why_not_begun(stage));
}

}  // namespace hrt::reach
