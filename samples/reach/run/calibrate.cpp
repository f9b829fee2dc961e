#include "samples/reach/run/calibrate.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <string>

#include "samples/format.h"
#include "samples/reach/base/at_end.h"
#include "samples/reach/base/exit_code.h"
#include "samples/reach/run/start.h"

namespace hrt::reach {
namespace {

// The target is straight ahead, where the range of plate angles is even.
constexpr double goal_direction_deg = 0.0;
constexpr double max_slide_m = 0.1;
constexpr double shortest_slide_m = 0.05;
constexpr double margin_m = 0.01;  // left to the rim
constexpr double plate_tolerance_deg = 1.0;
constexpr XrDuration plate_limit_ns = 5'000'000'000;
constexpr XrDuration unreported_turn_ns = 1'000'000'000;  // of a plate that does not report where it is
constexpr int failures_allowed = 5;                       // slides in a row that do not count

// Of the slide straight ahead that stays on the plate.
double slide_distance_m(const TargetSet& targets) {
  const double right_m = targets.start_m[0];
  const double towards_user_m = targets.start_m[2];
  const double half_m =
      std::sqrt(std::max(0.0, targets.plate_radius_m * targets.plate_radius_m - right_m * right_m));
  const double distance_m = std::min(max_slide_m, towards_user_m + half_m - margin_m);
  if (distance_m < shortest_slide_m)
    throw Failure(ExitCode::scene,
                  format("the plate has %.0f mm straight ahead of the start; a calibration needs %.0f",
                         1e3 * std::max(0.0, distance_m), 1e3 * shortest_slide_m));
  return distance_m;
}

bool feels_the_same(double a_deg, double b_deg) {
  return std::abs(std::remainder(a_deg - b_deg, 180.0)) <= plate_tolerance_deg;
}

double minutes_of(XrDuration duration_ns) {
  return static_cast<double>(duration_ns) / 60e9;
}

const char* advice(std::uint32_t failed) {
  return failed > 1 ? " Slide in one motion, and keep the fingertip on the plate." : "";
}

}  // namespace

GuidedCalibration::GuidedCalibration(const Plugin& plugin, const TargetSet& targets, XrDuration limit_ns,
                                     std::uint64_t seed)
    : plugin_(plugin),
      targets_(targets),
      limit_ns_(limit_ns),
      seed_(seed),
      distance_m_(slide_distance_m(targets)) {
  hrt_calibration_config config = hrt_calibration_config_init();
  config.goal_direction_deg = goal_direction_deg;
  plugin.check(plugin.hrt_calibration_create(targets.session, &config, &calibration_));
}

GuidedCalibration::~GuidedCalibration() {
  plugin_.hrt_calibration_destroy(calibration_);
}

// `call` takes too long for a frame: the plate is served meanwhile, and the time is not the user's.
template <class Call>
void GuidedCalibration::compute(Stage& stage, Call&& call) {
  std::string reason;
  auto computed = std::async(std::launch::async, [&] {
    const hrt_result code = call();
    if (code != HRT_OK) reason = plugin_.hrt_last_error();
    return code;
  });
  const XrTime began = next_frame(stage);
  XrTime now = began;
  while (computed.wait_for(std::chrono::seconds(0)) != std::future_status::ready) now = next_frame(stage);
  spent_ns_ -= now - began;
  const hrt_result code = computed.get();
  if (code == HRT_ERROR_INSUFFICIENT_DATA) throw Failure(ExitCode::calibration, "no calibration: " + reason);
  if (code != HRT_OK) throw Failure(ExitCode::plugin, reason);
}

CalibrationOutcome GuidedCalibration::solve(Stage& stage) {
  CalibrationOutcome outcome{.result = {.struct_size = sizeof(hrt_calibration_result)}, .enough = enough_};
  compute(stage, [&] { return plugin_.hrt_calibration_solve(calibration_, &outcome.result); });
  for (std::uint32_t i = 0; i < outcome.result.trials_used; ++i) {
    hrt_calibration_slide slide{.struct_size = sizeof slide};
    plugin_.check(plugin_.hrt_calibration_get_residual(calibration_, i, &slide));
    outcome.slides.push_back(slide);
  }
  return outcome;
}

double GuidedCalibration::next_angle_deg(Stage& stage) {
  double plate_orientation_deg = 0.0;
  std::uint32_t enough = 0;
  compute(stage,
          [&] { return plugin_.hrt_calibration_next_angle(calibration_, &plate_orientation_deg, &enough); });
  enough_ = enough != 0;
  return plate_orientation_deg;
}

void GuidedCalibration::turn_plate(Stage& stage, double orientation_deg) const {
  const XrTime began = next_frame(stage);
  stage.plate.command(began, orientation_deg);
  for (XrTime time = next_frame(stage); time - began <= plate_limit_ns; time = next_frame(stage)) {
    const std::optional<double> measured_deg = stage.plate.orientation_deg(time);
    if (measured_deg ? feels_the_same(*measured_deg, orientation_deg) : time - began >= unreported_turn_ns)
      return;
  }
  throw Failure(ExitCode::plate, format("the plate did not turn to %g degrees within 5 s", orientation_deg));
}

// True if the slide counts.
bool GuidedCalibration::slide(Stage& stage, double plate_orientation_deg) {
  Hand hand = stage.hands.front();
  if (stage.simulation == nullptr) {
    hand = await_finger_at_start(stage);
    stage.tell_user("Now slide straight ahead, as far as is comfortable, and rest there.");
  }
  const XrTime began = next_frame(stage);
  plugin_.check(plugin_.hrt_calibration_begin_trial(calibration_, plate_orientation_deg));
  bool ended = false;
  const AtEnd cancel([&] {
    if (!ended) plugin_.hrt_calibration_end_trial(calibration_, 0);
  });
  if (stage.simulation != nullptr) {
    instruct(stage, hand, goal_direction_deg, distance_m_);
  }
  std::vector<Moment> moments;
  std::optional<XrTime> done_since;
  for (XrTime time = began; time - began <= stage.time_limit_ns; time = next_frame(stage)) {
    const Fingertip tip = locate(stage, hand, time);
    const std::optional<double> measured_deg = stage.plate.orientation_deg(time);
    if (measured_deg && !feels_the_same(*measured_deg, plate_orientation_deg)) {
      stage.tell_user("The plate has moved: this slide does not count.");
      return false;
    }
    const hrt_sample sample = sample_of(time, tip, std::nullopt);
    plugin_.check(plugin_.hrt_calibration_add_sample(calibration_, &sample));
    moments.push_back({.time = time, .tracked = tip.tracked, .position_m = tip.position_m});
    if (stage.simulation != nullptr && stage.simulation->truth(hand).done && !done_since) done_since = time;
    const bool arrived = stage.simulation != nullptr
                             ? done_since && time - *done_since >= settle_ns
                             : is_at_rest(moments, began, targets_.start_m, distance_m_ / 2.0, settle_ns);
    if (!arrived) continue;
    const auto lost =
        std::count_if(moments.begin(), moments.end(), [](const Moment& m) { return !m.tracked; });
    if (4 * lost > static_cast<std::ptrdiff_t>(moments.size())) {
      stage.tell_user("The tracker lost the fingertip: this slide does not count.");
      return false;
    }
    ended = true;
    plugin_.check(plugin_.hrt_calibration_end_trial(calibration_, 1));
    return true;
  }
  stage.tell_user("The slide did not end " + within_s(stage.time_limit_ns) + ": it does not count.");
  return false;
}

CalibrationOutcome GuidedCalibration::run(Stage& stage, std::ostream& out) {
  const XrTime began = next_frame(stage);
  if (slides_ == 0) {
    stage.tell_user(
        format("You will slide one fingertip straight ahead, %.0f mm, again and again. Close your eyes, "
               "and slide towards what feels straight ahead. Rest for a second before each slide. It "
               "takes some 12 to 40 slides and ends by itself, after %.0f minutes at the latest; between "
               "slides you may rest your hand for up to %.0f s.",
               1e3 * distance_m_, std::ceil(minutes_of(limit_ns_)),
               static_cast<double>(stage.time_limit_ns) * 1e-9));
  }
  XrTime now = began;
  const AtEnd stop([&] {
    spent_ns_ += now - began;
    try {
      stage.plate.stop(now);
    } catch (const std::exception&) {
      // A failure is already being reported, or the slides are complete without the plate.
    }
  });
  for (;;) {
    const double plate_orientation_deg = next_angle_deg(stage);
    now = next_frame(stage);
    const XrDuration spent_ns = spent_ns_ + (now - began);
    if (enough_ || spent_ns > limit_ns_) return solve(stage);
    turn_plate(stage, plate_orientation_deg);
    stage.tell_user(
        format("Slide %u, minute %.0f of at most %.0f: put your index finger to the start and let it rest.",
               slides_ + 1, std::floor(minutes_of(spent_ns)) + 1.0, std::ceil(minutes_of(limit_ns_))));
    if (stage.simulation != nullptr)
      stage.simulation->seed(seed_, slides_ + static_cast<std::uint32_t>(failed_));
    if (slide(stage, plate_orientation_deg)) {
      ++slides_;
      failed_ = 0;
      out << format("slide %3u  plate %6.1f deg\n", slides_, plate_orientation_deg) << std::flush;
    } else if (++failed_ > failures_allowed) {
      throw Failure(ExitCode::no_hand, format("%d slides in a row did not count", failed_));
    } else {
      stage.tell_user(std::string("Again, please.") + advice(static_cast<std::uint32_t>(failed_)));
    }
    if (!out) throw Failure(ExitCode::output, "the standard output cannot be written");
  }
}

}  // namespace hrt::reach
