#include "samples/reach/run/registration.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <string>

#include "samples/format.h"
#include "samples/reach/base/exit_code.h"
#include "samples/reach/run/sighting.h"

namespace hrt::reach {
namespace {

constexpr XrPosef world{{0.0f, 0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 0.0f}};
constexpr int max_attempts = 3;
constexpr XrDuration mark_rest_ns = 700'000'000;
// A finger counts once it has moved by more since it was asked for, as it may rest elsewhere until then.
constexpr double min_moved_m = 0.015;
// Of a resting finger: root mean square distance from its mean, and from the first half of the time to the
// second.
constexpr double max_spread_m = 0.004;
constexpr double max_drift_m = 0.003;
constexpr double millimetres = 1000.0;

double distance_m(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// One hand's finger, until it has come to rest.
class RestDetector {
 public:
  /// Where the finger rests; nothing if it does not.
  std::optional<Point> see(XrTime time, const Fingertip& tip) {
    if (!tip.tracked) {
      seen_.clear();
      moved_ = true;  // it may come back anywhere
      return std::nullopt;
    }
    if (!asked_at_) asked_at_ = tip.position_m;
    moved_ = moved_ || distance_m(tip.position_m, *asked_at_) > min_moved_m;
    seen_.push_back({time, tip.position_m});
    const XrTime since = time - mark_rest_ns;
    if (seen_.front().time > since) return std::nullopt;
    while (seen_.size() > 1 && seen_[1].time <= since) seen_.pop_front();
    if (!moved_ || seen_.size() < 4) return std::nullopt;
    const Point mean_m = mean(0, seen_.size());
    double square_sum_m2 = 0.0;
    for (const Seen& seen : seen_) square_sum_m2 += std::pow(distance_m(seen.position_m, mean_m), 2);
    const bool near = std::sqrt(square_sum_m2 / static_cast<double>(seen_.size())) <= max_spread_m;
    // The finger may have come in the first half; where it was in the second half is where it rests.
    const Point rested_m = mean(seen_.size() / 2, seen_.size());
    const bool still = distance_m(mean(0, seen_.size() / 2), rested_m) <= max_drift_m;
    return near && still ? std::optional(rested_m) : std::nullopt;
  }

 private:
  struct Seen {
    XrTime time;
    Point position_m;
  };

  Point mean(std::size_t from, std::size_t to) const {
    Point sum{};
    for (std::size_t i = from; i < to; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        sum[axis] += seen_[i].position_m[axis] / static_cast<double>(to - from);
    return sum;
  }

  std::deque<Seen> seen_;
  std::optional<Point> asked_at_;
  bool moved_ = false;
};

struct Touch {
  Point position_m;  // in the space that the session's plate stands in
  std::optional<std::array<double, 4>> rotation;
  XrTime time;
};

Touch await_touch(Stage& stage, std::span<const Hand> hands, const std::string& request) {
  stage.tell_user(request);
  std::array<RestDetector, 2> detectors;
  Sightings sightings({});
  const XrTime began = next_frame(stage);
  for (XrTime time = began; time - began <= stage.time_limit_ns; time = next_frame(stage)) {
    for (const Hand hand : {Hand::left, Hand::right}) {
      const Fingertip tip = locate(stage, hand, time);
      sightings.see(hand, tip);
      if (std::find(hands.begin(), hands.end(), hand) == hands.end()) continue;
      RestDetector& detector = detectors[static_cast<std::size_t>(hand)];
      if (const auto place_m = detector.see(time, tip)) return {*place_m, tip.rotation, time};
    }
  }
  throw Failure(ExitCode::no_hand, "no index finger came to rest " + within_s(stage.time_limit_ns) +
                                       " after: " + request + " " + sightings.why_no_touch(stage));
}

hrt_mark_touch to_plugin(const Mark& mark, const Point& touched_m) {
  hrt_mark_touch touch{};
  std::copy(mark.position_m.begin(), mark.position_m.end(), touch.mark_m);
  std::copy(touched_m.begin(), touched_m.end(), touch.touched_m);
  return touch;
}

// How a finger is held while it touches one mark: about two axes, each to both sides.
constexpr const char* attitudes[] = {"flat",
                                     "steeply",
                                     "leant to the left",
                                     "leant to the right",
                                     "flat, turned to the left",
                                     "flat, turned to the right"};

hrt_fingertip find_fingertip(Stage& stage, const Mark& mark, Hand hand) {
  const std::string finger = hand == Hand::left ? "left index finger" : "right index finger";
  const auto count = static_cast<int>(std::size(attitudes));
  for (int attempt = 0; attempt < max_attempts; ++attempt) {
    const int recentrings = stage.session.recentrings();
    std::vector<hrt_joint_touch> touches;
    for (const char* attitude : attitudes) {
      const Touch touch =
          await_touch(stage, {&hand, 1},
                      "Lift your finger. Then touch the mark \"" + mark.name + "\" with your " + finger +
                          " held " + attitude + ", and hold still (" + std::to_string(touches.size() + 1) +
                          " of " + std::to_string(count) + ").");
      if (!touch.rotation)
        throw Failure(ExitCode::registration,
                      "the runtime does not report how the finger is turned; leave out --fingertip");
      hrt_joint_touch& joint = touches.emplace_back();
      std::copy(touch.position_m.begin(), touch.position_m.end(), joint.position_m);
      std::copy(touch.rotation->begin(), touch.rotation->end(), joint.rotation);
    }
    if (stage.session.recentrings() != recentrings) {
      stage.tell_user("The runtime moved its space meanwhile, so the touches are to be made again.");
      continue;
    }
    hrt_fingertip found{.struct_size = sizeof found};
    stage.plugin.check(stage.plugin.hrt_fingertip_fit(nullptr, touches.data(), touches.size(), &found));
    if (found.known == 0) {
      stage.tell_user("The touches do not show where the skin is: hold the finger more differently.");
      continue;
    }
    const double(&o)[3] = found.offset_m;
    const double(&sd)[3] = found.sd_m;
    stage.tell_user("The skin of your " + finger +
                    format(" is %.1f mm from the joint", millimetres * std::hypot(o[0], o[1], o[2])) +
                    format(", known to %.1f mm.", millimetres * std::max({sd[0], sd[1], sd[2]})));
    return found;
  }
  throw Failure(ExitCode::registration,
                "the touches do not show where the skin of the finger is; hold it "
                "more differently, or leave out --fingertip");
}

XrPosef pose_of(const hrt_registration& registration) {
  return to_xr(registration.plate_position_m, registration.plate_rotation);
}

void apply(Stage& stage, const RegisteredPlate& plate, XrTime time) {
  stage.plugin.check(stage.plugin.hrt_registration_apply(stage.targets.session, &plate.registration, time));
  stage.session.place_plate(plate.space, pose_of(plate.registration));
}

// What became of the touches, for a person.
void report(Stage& stage, std::span<const Mark> marks, const hrt_registration& found,
            const std::vector<double>& residuals_m) {
  if (found.verdict == HRT_REGISTRATION_HOLDS) {
    if (found.left_out >= 0)
      stage.tell_user("The touch of \"" + marks[static_cast<std::size_t>(found.left_out)].name +
                      "\" did not fit and was left out.");
    stage.tell_user(format("The plate is registered: residual %.1f mm, ", millimetres * found.residual_m) +
                    format("its turn known to %.2f degrees.", found.turn_sd_deg));
    return;
  }
  for (std::size_t i = 0; i < marks.size(); ++i)
    stage.tell_user("\"" + marks[i].name + format("\": %.0f mm off", millimetres * residuals_m[i]));
  stage.tell_user(stage.plugin.hrt_registration_advice(found.verdict));
}

}  // namespace

RegisteredPlate register_plate(Stage& stage, std::span<const Mark> marks, bool fingertips) {
  hrt_registration_config config = hrt_registration_config_init();
  config.flags = HRT_REGISTER_UP;  // y is up in every reference space
  RegisteredPlate plate{
      .space = stage.session.steady_space(), .registration = {}, .check = marks.front(), .fingertips = {}};
  stage.session.place_plate(plate.space, world);
  if (fingertips)
    for (const Hand hand : stage.hands)
      plate.fingertips[static_cast<std::size_t>(hand)] = find_fingertip(stage, marks.front(), hand);
  stage.fingertips = plate.fingertips;
  for (int attempt = 0; attempt < max_attempts; ++attempt) {
    stage.session.begin_coordinates(plate.space);
    stage.session.place_plate(plate.space, world);
    const int recentrings = stage.session.recentrings();
    std::vector<hrt_mark_touch> touches;
    std::vector<double> residuals_m(marks.size());
    XrTime time = 0;
    for (std::size_t i = 0; i < marks.size(); ++i) {
      const std::string count = std::to_string(i + 1) + " of " + std::to_string(marks.size());
      const Touch touch = await_touch(
          stage, stage.hands,
          "Touch the mark \"" + marks[i].name + "\" with your index finger and hold still (" + count + ").");
      touches.push_back(to_plugin(marks[i], touch.position_m));
      time = touch.time;
    }
    if (stage.session.recentrings() != recentrings) {
      stage.tell_user("The runtime moved its space meanwhile, so all marks are to be touched again.");
      continue;
    }
    plate.registration = {.struct_size = sizeof plate.registration};
    stage.plugin.check(stage.plugin.hrt_registration_fit(&config, touches.data(), touches.size(),
                                                         residuals_m.size(), residuals_m.data(),
                                                         &plate.registration));
    report(stage, marks, plate.registration, residuals_m);
    if (plate.registration.verdict != HRT_REGISTRATION_HOLDS) continue;
    apply(stage, plate, time);
    return plate;
  }
  throw Failure(ExitCode::registration, std::string("the plate could not be registered: ") +
                                            stage.plugin.hrt_registration_advice(plate.registration.verdict));
}

void check_plate(Stage& stage, const RegisteredPlate& plate) {
  const auto has_skin = [&](Hand hand) {
    return plate.fingertips[static_cast<std::size_t>(hand)].known != 0;
  };
  const bool any = has_skin(Hand::left) || has_skin(Hand::right);
  if (any && !std::all_of(stage.hands.begin(), stage.hands.end(), has_skin))
    throw Failure(ExitCode::registration,
                  "the plate was registered by the skin of the other hand (--fingertip): choose that hand, "
                  "or register the plate anew (--register)");
  stage.session.place_plate(plate.space, world);
  stage.fingertips = plate.fingertips;
  const Touch touch = await_touch(
      stage, stage.hands,
      "Touch the mark \"" + plate.check.name + "\" and hold still: is the plate where it was registered?");
  const hrt_mark_touch seen = to_plugin(plate.check, touch.position_m);
  hrt_touch_check check{.struct_size = sizeof check};
  stage.plugin.check(
      stage.plugin.hrt_registration_apply(stage.targets.session, &plate.registration, touch.time));
  stage.plugin.check(stage.plugin.hrt_registration_confirm(stage.targets.session, &plate.registration, &seen,
                                                           touch.time, &check));
  if (check.holds == 0)
    throw Failure(
        ExitCode::registration,
        "the mark \"" + plate.check.name +
            format("\" was touched %.0f mm from where it was registered, ", millimetres * check.distance_m) +
            format("and %.0f mm are allowed; touch it again, or register the plate anew (--register)",
                   millimetres * check.allowed_m));
  stage.tell_user(format("It is: the touch was %.0f mm off.", millimetres * check.distance_m));
  stage.session.place_plate(plate.space, pose_of(plate.registration));
}

}  // namespace hrt::reach
