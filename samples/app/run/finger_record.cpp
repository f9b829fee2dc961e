#include "samples/app/run/finger_record.h"

#include <algorithm>
#include <cmath>

#include "samples/app/base/exit_code.h"
#include "samples/app/text/format.h"

namespace hrt::app {
namespace {

constexpr double far_m = 0.3;      // if the finger stays farther from the start, the assumed pose is probably wrong
constexpr double named_m = 0.005;  // smaller components of the position along the plate are not reported

const char* name_of(Hand hand) { return hand == Hand::left ? "left" : "right"; }

std::string mm(double metres) { return format("%.0f mm", 1e3 * metres); }

}  // namespace

void FingerRecord::add(Hand hand, const Fingertip& tip) {
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

Hand FingerRecord::best_of(const RunContext& context) const {
  return *std::max_element(context.hands.begin(), context.hands.end(),
                           [this](Hand a, Hand b) { return of(a).tracked < of(b).tracked; });
}

std::string FingerRecord::tracked_in_words(const RunContext& context, Hand hand) const {
  const Seen& seen = of(hand);
  const double percent = 100.0 * seen.tracked / std::max(1, seen.frames);
  return context.touch != nullptr
             ? format(" [The touch frame saw a finger for %.0f %% of the time.]", percent)
             : format(" [The %s hand was tracked for %.0f %% of the time.]", name_of(hand), percent);
}

std::string FingerRecord::not_tracked(const RunContext& context) const {
  const Hand hand = context.hands.front();
  const Hand other = hand == Hand::left ? Hand::right : Hand::left;
  if (context.touch != nullptr) return "Nothing touched the touch frame. Touch it with one fingertip.";
  if (context.hands.size() > 1) return "No hand was tracked. Hold one hand where the headset's cameras see it.";
  if (of(other).tracked > 0)
    return format("The %s hand was not tracked, but the %s one was. Change to the %s hand (or hrt-reach --hand %s).",
                  name_of(hand), name_of(other), name_of(hand), name_of(other));
  return format("The %s hand was not tracked. Hold it where the headset's cameras see it.", name_of(hand));
}

// Returns text such as "62 mm left of the start and 20 mm beyond it, 31 mm above the plate".
std::string FingerRecord::position_in_words(const RunContext& context, const Point& tip_m) const {
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
  if (distance_along_plate_m(tip_m, {}) > context.targets.plate_radius_m) text += ", outside the rim of the plate";
  return text;
}

std::string FingerRecord::where(const RunContext& context, bool plate_is_placed) const {
  for (const Hand hand : context.hands)
    if (of(hand).tracked_now)
      return (context.touch != nullptr ? "The finger is " : format("The %s index finger is ", name_of(hand))) +
             (plate_is_placed ? position_in_words(context, of(hand).last_m) : "tracked") + ".";
  if (context.touch != nullptr) return "No finger touches the frame now.";
  return context.hands.size() > 1 ? "No hand is tracked now."
                                  : format("The %s hand is not tracked now.", name_of(context.hands.front()));
}

std::string FingerRecord::why_not_begun(const RunContext& context) const {
  const Hand hand = best_of(context);
  const Seen& seen = of(hand);
  if (seen.tracked == 0) return not_tracked(context);
  std::string text = "The finger was last " + position_in_words(context, seen.last_m) + "." +
                     tracked_in_words(context, hand) + " [Smallest distance from the start: " + mm(seen.nearest_m) +
                     ".] ";
  if (context.touch != nullptr)
    return text +
           "Rest one fingertip on the start. If the finger was on the start, the position of the touch frame is wrong: "
           "correct it [right_mm and towards_mm of --finger].";
  if (4 * seen.tracked < seen.frames) return text + "Hold the hand where the headset's cameras see it.";
  if (seen.nearest_m > far_m)
    return text +
           "If the finger was on the plate, the assumed position of the plate is wrong: register the plate "
           "(hrt-reach: --register FILE).";
  if (seen.nearest_m > start_radius_m) return text + "Put it within " + mm(start_radius_m) + " of the start.";
  return text +
         "Rest the finger on the start. If it has rested there, register the plate (hrt-reach: --register FILE).";
}

std::string FingerRecord::why_not_ended(const RunContext& context, const TargetPair& pair) const {
  const Hand hand = best_of(context);
  const Seen& seen = of(hand);
  if (seen.tracked == 0) return not_tracked(context);
  std::string text = "The finger was last " + position_in_words(context, seen.last_m) + ", " +
                     mm(distance_along_plate_m(seen.last_m, pair.real_position_m)) + " from the target." +
                     tracked_in_words(context, hand) + " ";
  if (!seen.tracked_now && context.touch == nullptr) return text + "Keep the hand where the headset's cameras see it.";
  if (context.simulation != nullptr) return text + "Allow the simulated user more time (hrt-reach: --time-limit).";
  if (seen.farthest_m <= start_radius_m) return text + "The finger stayed at the start: slide it to the target.";
  return text +
         "A reach ends when the finger is at the target, rests for 2 s after a third of the path, or is lifted "
         "(hrt-reach: --time-limit allows more time).";
}

std::string FingerRecord::why_no_touch(const RunContext& context) const {
  const Hand hand = best_of(context);
  if (of(hand).tracked == 0) return not_tracked(context);
  return "Move the finger to the mark, where the headset's cameras see it, and hold it still for a second." +
         tracked_in_words(context, hand);
}

Hand await_finger_at_start(RunContext& context) {
  const XrTime began = next_frame(context);
  std::array<XrTime, 2> there_since{};
  FingerRecord fingers(context.targets.start_m);
  for (XrTime time = began; time - began <= context.time_limit_ns; time = next_frame(context)) {
    for (const Hand hand : {Hand::left, Hand::right}) {
      const Fingertip tip = locate(context, hand, time);
      fingers.add(hand, tip);
      if (std::find(context.hands.begin(), context.hands.end(), hand) == context.hands.end()) continue;
      const bool there = tip.tracked && tip.position_m[1] <= lifted_height_m &&
                         distance_along_plate_m(tip.position_m, context.targets.start_m) <= start_radius_m;
      XrTime& since = there_since[static_cast<std::size_t>(hand)];
      if (!there) {
        since = 0;
      } else if (since == 0) {
        since = time;
      } else if (time - since >= settle_ns) {
        return hand;
      }
    }
    if (context.hint && time - began > settle_ns) context.hint(fingers.where(context));
  }
  throw Failure(ExitCode::no_hand, "No index finger came to the start " + within_s(context.time_limit_ns) + ". " +
                                       fingers.why_not_begun(context));
}

}  // namespace hrt::app
