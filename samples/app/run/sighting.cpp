#include "samples/app/run/sighting.h"

#include <algorithm>
#include <cmath>

#include "samples/app/base/exit_code.h"
#include "samples/app/text/format.h"

namespace hrt::app {
namespace {

constexpr double far_m = 0.3;      // farther than this, the plate is probably not where it is assumed
constexpr double named_m = 0.005;  // smaller distances are not reported

const char* name_of(Hand hand) { return hand == Hand::left ? "left" : "right"; }

std::string mm(double metres) { return format("%.0f mm", 1e3 * metres); }

}  // namespace

void Sightings::see(Hand hand, const Fingertip& tip) {
  Seen& seen = seen_[static_cast<std::size_t>(hand)];
  ++seen.frames;
  seen.tracked_now = tip.tracked;
  if (!tip.tracked) return;
  const double distance_m = distance_along_plate_m(tip.position_m, start_m_);
  seen.nearest_m = seen.tracked == 0 ? distance_m : std::min(seen.nearest_m, distance_m);
  seen.farthest_m = std::max(seen.farthest_m, distance_m);
  seen.last_m = tip.position_m;
  ++seen.tracked;
}

Hand Sightings::best_of(const Stage& stage) const {
  return *std::max_element(stage.hands.begin(), stage.hands.end(),
                           [this](Hand a, Hand b) { return of(a).tracked < of(b).tracked; });
}

std::string Sightings::tracked_in_words(Hand hand) const {
  const Seen& seen = of(hand);
  return format("The %s hand was tracked for %.0f %% of the time", name_of(hand),
                100.0 * seen.tracked / std::max(1, seen.frames));
}

std::string Sightings::not_tracked(const Stage& stage) const {
  const Hand hand = stage.hands.front();
  const Hand other = hand == Hand::left ? Hand::right : Hand::left;
  if (stage.touch != nullptr) return "Nothing touched the touch frame. Touch it with one fingertip.";
  if (stage.hands.size() > 1) return "No hand was tracked. Hold one where the headset's cameras see it.";
  if (of(other).tracked > 0)
    return format("The %s hand was not tracked, but the %s one was. Use the %s one, or --hand %s.", name_of(hand),
                  name_of(other), name_of(hand), name_of(other));
  return format("The %s hand was not tracked. Hold it where the headset's cameras see it.", name_of(hand));
}

// "62 mm left of the start and 20 mm beyond it, 31 mm above the plate"
std::string Sightings::place_in_words(const Stage& stage, const Point& tip_m) const {
  const double right_m = tip_m[0] - start_m_[0];
  const double nearer_m = tip_m[2] - start_m_[2];
  const double above_m = tip_m[1] - tip_height_m;
  const bool is_beside = std::abs(right_m) >= named_m;
  std::string text = is_beside ? mm(std::abs(right_m)) + (right_m > 0.0 ? " right" : " left") + " of the start" : "";
  if (std::abs(nearer_m) >= named_m)
    text += (is_beside ? " and " : "") + mm(std::abs(nearer_m)) +
            (nearer_m > 0.0 ? " nearer to you than " : " beyond ") + (is_beside ? "it" : "the start");
  if (text.empty()) text = "at the start";
  if (std::abs(above_m) > lifted_height_m - tip_height_m)
    text += ", " + mm(std::abs(above_m)) + (above_m > 0.0 ? " above the plate" : " below the plate");
  if (distance_along_plate_m(tip_m, {}) > stage.targets.plate_radius_m) text += ", beside the plate";
  return text;
}

std::string Sightings::where(const Stage& stage, bool plate_is_placed) const {
  for (const Hand hand : stage.hands)
    if (of(hand).tracked_now)
      return format("The %s index finger is ", name_of(hand)) +
             (plate_is_placed ? place_in_words(stage, of(hand).last_m) : "tracked") + ".";
  return stage.hands.size() > 1 ? "No hand is tracked now."
                                : format("The %s hand is not tracked now.", name_of(stage.hands.front()));
}

std::string Sightings::why_not_begun(const Stage& stage) const {
  const Hand hand = best_of(stage);
  const Seen& seen = of(hand);
  if (seen.tracked == 0) return not_tracked(stage);
  std::string text = tracked_in_words(hand) + "; its index finger was last " + place_in_words(stage, seen.last_m) +
                     "; at best it was " + mm(seen.nearest_m) + " from the start. ";
  if (stage.touch != nullptr)
    return text + "Rest one fingertip on the start; if it was there, enter where the frame is on the plate (right_mm).";
  if (4 * seen.tracked < seen.frames) return text + "Hold the hand where the headset's cameras see it.";
  if (seen.nearest_m > far_m)
    return text +
           "If the finger was at the plate, the plate is elsewhere than assumed: register it (--register "
           "FILE).";
  if (seen.nearest_m > start_radius_m) return text + "Put the finger within " + mm(start_radius_m) + " of the start.";
  return text + "Lay the finger on the start and let it rest; if it did, register the plate (--register FILE).";
}

std::string Sightings::why_not_ended(const Stage& stage, const TargetPair& pair) const {
  const Hand hand = best_of(stage);
  const Seen& seen = of(hand);
  if (seen.tracked == 0) return not_tracked(stage);
  std::string text = tracked_in_words(hand) + "; its index finger was last " + place_in_words(stage, seen.last_m) +
                     ", " + mm(distance_along_plate_m(seen.last_m, pair.real_position_m)) + " from the target. ";
  if (!seen.tracked_now && stage.touch == nullptr) return text + "Keep the hand where the headset's cameras see it.";
  if (seen.farthest_m <= start_radius_m) return text + "It stayed at the start: slide it to the target.";
  return text +
         "A reach ends at the target, or with a rest of 1.5 s, or with a lift; --time-limit allows more "
         "time.";
}

std::string Sightings::why_no_touch(const Stage& stage) const {
  const Hand hand = best_of(stage);
  if (of(hand).tracked == 0) return not_tracked(stage);
  return tracked_in_words(hand) +
         ". Move the finger to the mark, then hold it still for a second, where the headset's cameras see "
         "it.";
}

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
  throw Failure(ExitCode::no_hand, "no index finger came to the start " + within_s(stage.time_limit_ns) + ". " +
                                       sightings.why_not_begun(stage));
}

}  // namespace hrt::app
