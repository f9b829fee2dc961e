#include "samples/app/run/reach.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "samples/app/base/exit_code.h"
#include "samples/app/run/sighting.h"
#include "samples/app/text/format.h"

namespace hrt::app {
namespace {

constexpr XrDuration lift_ns = 500'000'000;  // longer than the other hand needs to take over

double bearing_deg(const Point& from, const Point& to) {
  return std::atan2(from[0] - to[0], from[2] - to[2]) * 180.0 / std::numbers::pi;
}

// Ends the plugin's reach. After a failure the reach is cancelled, so that nothing is learnt, and the plate stops.
class ActiveReach {
 public:
  ActiveReach(Stage& stage, const TargetPair& pair, XrTime now) : stage_(stage), time_(now) {
    hrt_reach_config config = hrt_reach_config_init();
    config.real_target = pair.real_target;
    config.virtual_target = pair.virtual_target;
    if (const std::optional<double> orientation_deg = stage.plate.orientation_deg(now)) {
      config.flags |= HRT_REACH_PLATE_ORIENTATION;
      config.plate_orientation_deg = *orientation_deg;
    }
    stage.plugin.check(stage.plugin.hrt_reach_begin(stage.targets.session, &config));
  }

  ~ActiveReach() {
    if (ended_) return;
    stage_.plugin.hrt_reach_cancel(stage_.targets.session);
    try {
      stage_.plate.stop(time_);
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
    stage_.plugin.check(stage_.plugin.hrt_reach_update(stage_.targets.session, &sample, &command));
    return command;
  }

  hrt_reach_summary end() {
    hrt_reach_summary summary{.struct_size = sizeof summary};
    stage_.plugin.check(stage_.plugin.hrt_reach_end(stage_.targets.session, &summary));
    ended_ = true;
    return summary;
  }

 private:
  Stage& stage_;
  XrTime time_;
  bool ended_ = false;
};

bool is_on_plate(const Stage& stage, const Fingertip& tip) {
  return tip.tracked && tip.position_m[1] <= lifted_height_m &&
         distance_along_plate_m(tip.position_m, {}) <= stage.targets.plate_radius_m;
}

// The finger that slides. If it has been off the plate for settle_ns while the other hand's finger is on the plate,
// the other finger takes over: the user changed hands, or the tracker confused them.
class FingerInUse {
 public:
  FingerInUse(Stage& stage, Hand first, XrTime now) : stage_(stage), hand_(first), on_plate_(now) {}

  Fingertip locate(XrTime time) {
    const Fingertip tip = app::locate(stage_, hand_, time);
    if (is_on_plate(stage_, tip)) on_plate_ = time;
    if (time - on_plate_ < settle_ns || stage_.simulation != nullptr) return tip;
    for (const Hand other : stage_.hands) {
      const Fingertip others = other == hand_ ? Fingertip{} : app::locate(stage_, other, time);
      if (!is_on_plate(stage_, others)) continue;
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
  Stage& stage_;
  Hand hand_;
  XrTime on_plate_;  // time when the finger was last on the plate
  bool changed_ = false;
};

// Index of the first moment above the plate if the finger slid and was then lifted for lift_ns; else the number of
// moments.
std::size_t lifted_at(const Stage& stage, const std::vector<Moment>& moments) {
  std::size_t first = moments.size();
  while (first > 0 && moments[first - 1].lifted) --first;
  if (first == 0 || first == moments.size() || moments.back().time - moments[first].time < lift_ns)
    return moments.size();
  const bool has_slid = distance_along_plate_m(moments[first - 1].position_m, stage.targets.start_m) > start_radius_m;
  return has_slid ? first : moments.size();
}

// True if the reach has ended. Simulated participant: moved, then rested for settle_ns. Person: the finger touches the
// real target, rests (as the plugin reports) or is lifted.
bool has_arrived(const Stage& stage, const TargetPair& pair, const FingerInUse& finger, std::vector<Moment>& moments,
                 std::optional<XrTime>& done_since) {
  if (stage.simulation != nullptr) {
    if (!stage.simulation->truth(finger.hand()).done) return false;
    if (!done_since) done_since = moments.back().time;
    return moments.back().time - *done_since >= settle_ns;
  }
  if (const std::size_t lifted = lifted_at(stage, moments); lifted < moments.size()) {
    moments.resize(lifted);  // the reach ended where the finger left the plate
    return true;
  }
  const Moment& last = moments.back();
  return last.arrived ||
         (last.tracked && distance_along_plate_m(last.position_m, pair.real_position_m) <= pair.real_radius_m);
}

// Fingertip as the plugin receives it: a lifted finger counts as not tracked.
Fingertip sliding(const Stage& stage, const Fingertip& tip) {
  const bool is_lifted = stage.simulation == nullptr && tip.position_m[1] > lifted_height_m;
  return is_lifted ? Fingertip{} : tip;
}

std::string request_for(const Stage& stage, const TargetPair& pair) {
  const double direction_deg = std::round(pair.virtual_direction_deg);
  std::string way = "straight ahead";
  if (direction_deg != 0.0)
    way = format("%.0f degrees to the %s of straight ahead", std::abs(direction_deg),
                 direction_deg > 0.0 ? "left" : "right");
  return "Put your index finger on the start. Then slide it to \"" + pair.virtual_name + "\", " +
         format("%.0f mm, ", 1e3 * distance_along_plate_m(pair.virtual_position_m, stage.targets.start_m)) + way +
         ", and rest there.";
}

ReachResult result_of(const Stage& stage, const TargetPair& pair, Hand hand, const hrt_reach_summary& summary,
                      const std::vector<Moment>& moments) {
  ReachResult result{};
  Point end_m = moments.back().position_m;
  result.can_be_held = moments.back().can_be_held;
  result.summary = summary;
  result.peak_felt_error_deg = summary.peak_felt_error_deg;
  if (stage.simulation != nullptr) {
    const Simulation::Truth truth = stage.simulation->truth(hand);
    result.peak_felt_error_deg = truth.peak_felt_error_deg;
    result.holdable_gap_deg = pair.real_direction_deg < pair.virtual_direction_deg
                                  ? pair.virtual_direction_deg - truth.rightmost_direction_deg
                                  : truth.leftmost_direction_deg - pair.virtual_direction_deg;
    result.tactile_weight = truth.tactile_weight;
    result.is_truth = true;
    end_m = truth.tip_m;
  }
  const double end_bearing_deg = bearing_deg(stage.targets.start_m, end_m);
  result.miss_deg = end_bearing_deg - pair.real_direction_deg;
  if (config_of(stage).guidance == HRT_GUIDANCE_ARRIVAL)
    result.final_direction_deg = end_bearing_deg;
  else
    result.final_direction_deg = stage.simulation != nullptr ? stage.simulation->truth(hand).finger_direction_deg
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

// A finger that ends inside the object's radius has touched it: the plugin uses this contact to check the registration.
void take_contact(Stage& stage, const TargetPair& pair, const ReachResult& result) {
  const bool registered = (config_of(stage).flags & HRT_SESSION_REGISTERED) != 0;
  if (!registered || result.miss_m > pair.real_radius_m) return;
  const hrt_session session = stage.targets.session;
  if (stage.plugin.hrt_reach_touched(session, nullptr) != HRT_OK) stage.tell_user(stage.plugin.hrt_last_error());
}

}  // namespace

ReachResult run_reach(Stage& stage, const TargetPair& pair) {
  Hand first = stage.hands.front();
  if (stage.simulation == nullptr) {
    stage.tell_user(request_for(stage, pair));
    first = await_finger_at_start(stage);
  }
  const XrTime began = next_frame(stage);
  FingerInUse finger(stage, first, began);
  ActiveReach reach(stage, pair, began);
  if (stage.simulation != nullptr) {
    instruct(stage, first, pair.virtual_direction_deg, pair.real_distance_m);
  }

  std::vector<Moment> moments;
  std::optional<XrTime> done_since;
  Sightings sightings(stage.targets.start_m);
  for (XrTime time = began; moments.empty() || !has_arrived(stage, pair, finger, moments, done_since);
       time = next_frame(stage)) {
    if (time - began > stage.time_limit_ns)
      throw Failure(ExitCode::no_hand, "the reach to \"" + pair.virtual_name + "\" did not end " +
                                           within_s(stage.time_limit_ns) + ". " + sightings.why_not_ended(stage, pair));
    const Fingertip tip = finger.locate(time);
    sightings.see(finger.hand(), tip);
    const std::optional<double> measured_deg = stage.plate.orientation_deg(time);
    const hrt_command command = reach.update(time, sliding(stage, tip), measured_deg);
    stage.plate.command(time, command.plate_orientation_deg);

    Moment moment{.time = time,
                  .tracked = tip.tracked,
                  .position_m = tip.tracked       ? tip.position_m
                                : moments.empty() ? stage.targets.start_m
                                                  : moments.back().position_m,
                  .bearing_deg = command.bearing_deg,
                  .felt_direction_deg = command.perceived_direction_deg,
                  .plate_orientation_deg = measured_deg.value_or(command.plate_orientation_deg),
                  .distance_to_go_m = command.distance_to_go_m,
                  .lifted = tip.lifted || (tip.tracked && tip.position_m[1] > lifted_height_m),
                  .saturated = (command.flags & (HRT_COMMAND_SATURATED | HRT_COMMAND_RATE_LIMITED)) != 0,
                  .arrived = (command.flags & HRT_COMMAND_ARRIVED) != 0,
                  .can_be_held = (command.flags & HRT_COMMAND_UNREACHABLE) == 0};
    if (stage.simulation != nullptr) moment.felt_direction_deg = stage.simulation->truth(first).perceived_direction_deg;
    moments.push_back(moment);
    stage.on_frame(pair, moment);
  }
  ReachResult result = result_of(stage, pair, first, reach.end(), moments);
  result.changed_hands = finger.has_changed();
  take_contact(stage, pair, result);
  return result;
}

}  // namespace hrt::app
