#include "samples/app/run/reach.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "samples/app/base/exit_code.h"
#include "samples/app/run/finger_record.h"
#include "samples/app/text/format.h"

namespace hrt::app {
namespace {

// Duration of a lift that ends a reach. It is longer than settle_ns, after which the other hand can continue the reach.
constexpr XrDuration lift_ns = 500'000'000;

double bearing_deg(const Point& from, const Point& to) {
  return std::atan2(from[0] - to[0], from[2] - to[2]) * 180.0 / std::numbers::pi;
}

// A reach of the plugin. Unless end() was called, the destructor cancels the reach, so that the estimates stay
// unchanged, and stops the plate.
class ActiveReach {
 public:
  ActiveReach(RunContext& context, const TargetPair& pair, XrTime now) : context_(context), time_(now) {
    hrt_reach_config config = hrt_reach_config_init();
    config.real_target = pair.real_target;
    config.virtual_target = pair.virtual_target;
    if (const std::optional<double> orientation_deg = context.plate.orientation_deg(now)) {
      config.flags |= HRT_REACH_PLATE_ORIENTATION;
      config.plate_orientation_deg = *orientation_deg;
    }
    context.plugin.check(context.plugin.hrt_reach_begin(context.targets.session, &config));
  }

  ~ActiveReach() {
    if (ended_) return;
    context_.plugin.hrt_reach_cancel(context_.targets.session);
    try {
      context_.plate.stop(time_);
    } catch (const std::exception&) {
      // The first failure is already being reported.
    }
  }
  ActiveReach(const ActiveReach&) = delete;
  ActiveReach& operator=(const ActiveReach&) = delete;

  hrt_command update(XrTime time, const Fingertip& tip, std::optional<double> plate_orientation_deg) {
    time_ = time;
    const hrt_sample sample = sample_of(time, tip, plate_orientation_deg);
    hrt_command command{.struct_size = sizeof command};
    context_.plugin.check(context_.plugin.hrt_reach_update(context_.targets.session, &sample, &command));
    return command;
  }

  hrt_reach_summary end() {
    hrt_reach_summary summary{.struct_size = sizeof summary};
    context_.plugin.check(context_.plugin.hrt_reach_end(context_.targets.session, &summary));
    ended_ = true;
    return summary;
  }

 private:
  RunContext& context_;
  XrTime time_;
  bool ended_ = false;
};

bool is_on_plate(const RunContext& context, const Fingertip& tip) {
  return tip.tracked && tip.position_m[1] <= lifted_height_m &&
         distance_along_plate_m(tip.position_m, {}) <= context.targets.plate_radius_m;
}

// Tracks the finger that slides. If it has been off the plate for settle_ns, and the finger of another hand that may
// reach is on the plate, that finger is used from then on: the user changed hands, or the tracker confused the hands.
class FingerInUse {
 public:
  FingerInUse(RunContext& context, Hand first, XrTime now) : context_(context), hand_(first), on_plate_(now) {}

  Fingertip locate(XrTime time) {
    const Fingertip tip = app::locate(context_, hand_, time);
    if (is_on_plate(context_, tip)) on_plate_ = time;
    if (time - on_plate_ < settle_ns || context_.simulation != nullptr) return tip;
    for (const Hand other : context_.hands) {
      const Fingertip others = other == hand_ ? Fingertip{} : app::locate(context_, other, time);
      if (!is_on_plate(context_, others)) continue;
      hand_ = other;
      on_plate_ = time;
      changed_ = true;
      return others;
    }
    return tip;
  }

  Hand hand() const { return hand_; }
  bool has_changed() const { return changed_; }

 private:
  RunContext& context_;
  Hand hand_;
  XrTime on_plate_;  // time when the finger was last on the plate
  bool changed_ = false;
};

// If the finger slid and was then lifted for lift_ns: index of the first moment above the plate. Else: moments.size().
std::size_t lifted_at(const RunContext& context, const std::vector<Moment>& moments) {
  std::size_t first = moments.size();
  while (first > 0 && moments[first - 1].lifted) --first;
  if (first == 0 || first == moments.size() || moments.back().time - moments[first].time < lift_ns)
    return moments.size();
  const bool has_slid = distance_along_plate_m(moments[first - 1].position_m, context.targets.start_m) > start_radius_m;
  return has_slid ? first : moments.size();
}

// True if the reach has ended. Simulated participant: moved, then rested for settle_ns. Person: the finger touches the
// real target, rests (as the plugin reports) or is lifted.
bool has_arrived(const RunContext& context, const TargetPair& pair, const FingerInUse& finger,
                 std::vector<Moment>& moments, std::optional<XrTime>& done_since) {
  if (context.simulation != nullptr) {
    if (!context.simulation->truth(finger.hand()).done) return false;
    if (!done_since) done_since = moments.back().time;
    return moments.back().time - *done_since >= settle_ns;
  }
  if (const std::size_t lifted = lifted_at(context, moments); lifted < moments.size()) {
    moments.resize(lifted);  // the reach ended where the finger left the plate
    return true;
  }
  const Moment& last = moments.back();
  return last.arrived ||
         (last.tracked && distance_along_plate_m(last.position_m, pair.real_position_m) <= pair.real_radius_m);
}

// Fingertip as the plugin receives it: a person's finger above the plate counts as not tracked.
Fingertip sliding(const RunContext& context, const Fingertip& tip) {
  const bool is_lifted = context.simulation == nullptr && tip.position_m[1] > lifted_height_m;
  return is_lifted ? Fingertip{} : tip;
}

std::string request_for(const RunContext& context, const TargetPair& pair) {
  const double direction_deg = std::round(pair.virtual_direction_deg);
  std::string direction = "straight ahead";
  if (direction_deg != 0.0)
    direction = format("%.0f degree%s to the %s of straight ahead", std::abs(direction_deg),
                       std::abs(direction_deg) == 1.0 ? "" : "s", direction_deg > 0.0 ? "left" : "right");
  return "Put your index finger on the start. Then slide it to \"" + pair.virtual_name + "\", " +
         format("%.0f mm away, ", 1e3 * distance_along_plate_m(pair.virtual_position_m, context.targets.start_m)) +
         direction + ", and rest it there.";
}

ReachResult result_of(const RunContext& context, const TargetPair& pair, Hand hand, const hrt_reach_summary& summary,
                      const std::vector<Moment>& moments) {
  ReachResult result{};
  Point end_m = moments.back().position_m;
  result.is_feasible = moments.back().is_feasible;
  result.summary = summary;
  result.peak_felt_error_deg = summary.peak_felt_error_deg;
  if (context.simulation != nullptr) {
    const Simulation::Truth truth = context.simulation->truth(hand);
    result.peak_felt_error_deg = truth.peak_felt_error_deg;
    result.max_gap_deg = pair.real_direction_deg < pair.virtual_direction_deg
                             ? pair.virtual_direction_deg - truth.rightmost_direction_deg
                             : truth.leftmost_direction_deg - pair.virtual_direction_deg;
    result.tactile_weight = truth.tactile_weight;
    result.is_truth = true;
    end_m = truth.tip_m;
  }
  const double end_bearing_deg = bearing_deg(context.targets.start_m, end_m);
  result.miss_deg = end_bearing_deg - pair.real_direction_deg;
  if (config_of(context).guidance == HRT_GUIDANCE_ARRIVAL)
    result.final_direction_deg = end_bearing_deg;
  else
    result.final_direction_deg = context.simulation != nullptr ? context.simulation->truth(hand).finger_direction_deg
                                                               : summary.paper.final_direction_deg;
  result.miss_m = distance_along_plate_m(end_m, pair.real_position_m);
  result.frames = static_cast<int>(moments.size());
  result.dropouts = static_cast<int>(
      std::count_if(moments.begin(), moments.end(), [](const Moment& moment) { return !moment.tracked; }));
  if (summary.counts.steps > 0)
    result.saturated_share = static_cast<double>(summary.counts.saturated_steps + summary.paper.rate_limited_steps) /
                             static_cast<double>(summary.counts.steps);
  return result;
}

// For a registered plate, reports an end within the real target's radius to the plugin, as a contact.
void take_contact(RunContext& context, const TargetPair& pair, const ReachResult& result) {
  const bool registered = (config_of(context).flags & HRT_SESSION_REGISTERED) != 0;
  if (!registered || result.miss_m > pair.real_radius_m) return;
  const hrt_session session = context.targets.session;
  if (context.plugin.hrt_reach_touched(session, nullptr) != HRT_OK) context.tell_user(context.plugin.hrt_last_error());
}

}  // namespace

ReachResult run_reach(RunContext& context, const TargetPair& pair) {
  Hand first = context.hands.front();
  if (context.simulation == nullptr) {
    context.tell_user(request_for(context, pair));
    first = await_finger_at_start(context);
  }
  const XrTime began = next_frame(context);
  FingerInUse finger(context, first, began);
  ActiveReach reach(context, pair, began);
  if (context.simulation != nullptr) {
    instruct(context, first, pair.virtual_direction_deg, pair.real_distance_m);
  }

  std::vector<Moment> moments;
  std::optional<XrTime> done_since;
  FingerRecord fingers(context.targets.start_m);
  for (XrTime time = began; moments.empty() || !has_arrived(context, pair, finger, moments, done_since);
       time = next_frame(context)) {
    if (time - began > context.time_limit_ns)
      throw Failure(ExitCode::no_hand, "The reach to \"" + pair.virtual_name + "\" did not end " +
                                           within_s(context.time_limit_ns) + ". " +
                                           fingers.why_not_ended(context, pair));
    const Fingertip tip = finger.locate(time);
    fingers.add(finger.hand(), tip);
    const std::optional<double> measured_deg = context.plate.orientation_deg(time);
    const hrt_command command = reach.update(time, sliding(context, tip), measured_deg);
    context.plate.command(time, command.plate_orientation_deg);

    Moment moment{.time = time,
                  .tracked = tip.tracked,
                  .position_m = tip.tracked       ? tip.position_m
                                : moments.empty() ? context.targets.start_m
                                                  : moments.back().position_m,
                  .bearing_deg = command.bearing_deg,
                  .felt_direction_deg = command.perceived_direction_deg,
                  .plate_orientation_deg = measured_deg.value_or(command.plate_orientation_deg),
                  .distance_to_go_m = command.distance_to_go_m,
                  .lifted = tip.lifted || (tip.tracked && tip.position_m[1] > lifted_height_m),
                  .saturated = (command.flags & (HRT_COMMAND_SATURATED | HRT_COMMAND_RATE_LIMITED)) != 0,
                  .arrived = (command.flags & HRT_COMMAND_ARRIVED) != 0,
                  .is_feasible = (command.flags & HRT_COMMAND_UNREACHABLE) == 0};
    if (context.simulation != nullptr)
      moment.felt_direction_deg = context.simulation->truth(first).perceived_direction_deg;
    moments.push_back(moment);
    context.on_frame(pair, moment);
  }
  ReachResult result = result_of(context, pair, first, reach.end(), moments);
  result.changed_hands = finger.has_changed();
  take_contact(context, pair, result);
  return result;
}

}  // namespace hrt::app
