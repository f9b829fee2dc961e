#include "samples/app/run/set_up.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "samples/app/base/exit_code.h"
#include "samples/app/base/scope_exit.h"
#include "samples/app/text/format.h"

namespace hrt::app {
namespace {

constexpr std::uint32_t world_parts = HRT_SETUP_FINGERTIP | HRT_SETUP_REGISTRATION | HRT_SETUP_CHECK;
constexpr std::uint32_t nothing = UINT32_MAX;  // no instruction has been given
// Path of a simulated participant who is to stay at the start: the mock runtime requires a length above 0.
constexpr double no_way_m = 1e-6;

Hand hand_in_use(const Stage& stage, XrTime time) {
  const auto tracked = std::find_if(stage.hands.begin(), stage.hands.end(),
                                    [&](Hand hand) { return locate(stage, hand, time).tracked; });
  return tracked == stage.hands.end() ? stage.hands.front() : *tracked;
}

}  // namespace

bool is_new_instruction(const hrt_setup_step& asked, const hrt_setup_step& step) {
  return step.part != asked.part || step.number != asked.number || step.done != asked.done ||
         step.problem != asked.problem ||
         (step.instruction != asked.instruction && step.instruction != HRT_STEP_HOLD_STILL);
}

std::string request_of(const hrt_setup_step& step, const std::vector<std::string>& mark_names) {
  std::string request = step.text;
  if (step.instruction == HRT_STEP_TOUCH_MARK) {
    const std::size_t mark = step.part == HRT_SETUP_FINGERTIP ? 0 : step.number;
    request += format(" Mark %zu is \"", mark + 1) + mark_names.at(mark) + "\"";
  }
  if (step.instruction == HRT_STEP_TOUCH_MARK || step.instruction == HRT_STEP_REST_AT_START)
    request += format(" (%u of %u).", step.done + 1, step.of);
  return request;
}

SetUp::SetUp(const Plugin& plugin, hrt_session session, std::uint32_t what, const hrt_setup_config& config,
             std::vector<std::string> mark_names)
    : plugin_(plugin), session_(session), mark_names_(std::move(mark_names)) {
  asked_.part = what & (~what + 1);  // parts are done in the order of their bits
  asked_.instruction = nothing;
  result_.struct_size = sizeof result_;
  result_.left = what;
  const hrt_result begun = plugin.hrt_setup_begin(session, what, &config);
  if (begun == HRT_ERROR_OUT_OF_RANGE) throw Failure(ExitCode::scene, plugin.hrt_last_error());
  plugin.check(begun);
}

SetUp::~SetUp() {
  if (result_.left != 0) static_cast<void>(plugin_.hrt_setup_cancel(session_));
}

// A failed check is a result and not dropped; so is a calibration whose slides do not determine the user.
void SetUp::check_dropped() const {
  const std::uint32_t touched = HRT_SETUP_FINGERTIP | HRT_SETUP_REGISTRATION;
  if ((result_.dropped & touched) != 0) throw Failure(ExitCode::registration, result_.reason);
  if ((result_.dropped & HRT_SETUP_CALIBRATION) != 0 && result_.slides == 0)
    throw Failure(ExitCode::no_hand, result_.reason);
}

void SetUp::ask(Stage& stage, const hrt_setup_step& step) {
  if (step.problem == HRT_PROBLEM_PLATE) throw Failure(ExitCode::plate, step.text);
  request_ = request_of(step, mark_names_);
  stage.tell_user(request_);
  if (stage.simulation != nullptr && step.instruction == HRT_STEP_REST_AT_START)
    instruct(stage, stage.hands.front(), 0.0, no_way_m);
  if (stage.simulation != nullptr && step.instruction == HRT_STEP_SLIDE)
    instruct(stage, stage.hands.front(), 0.0,
             distance_along_plate_m({step.place_m[0], 0.0, step.place_m[2]}, stage.targets.start_m));
}

// Passes one frame to the plugin, turns the plate as requested, and returns the next instruction.
hrt_setup_step SetUp::update(Stage& stage, XrTime time) {
  const Hand hand = hand_in_use(stage, time);
  for (const Hand seen : {Hand::left, Hand::right}) sightings_->see(seen, locate(stage, seen, time));
  // The parts that find the plate and the skin take the joint in world coordinates.
  const bool in_world = (asked_.part & world_parts) != 0;
  Fingertip tip = in_world ? stage.session.locate(hand, time) : locate(stage, hand, time);
  if ((asked_.part & HRT_SETUP_FINGERTIP) != 0 && !tip.rotation) tip.tracked = false;
  last_ = time + later_by_;
  const std::optional<double> plate_deg = stage.plate.orientation_deg(time);
  hrt_sample sample = in_world ? world_sample_of(last_, tip, plate_deg) : sample_of(last_, tip, plate_deg);
  if (in_world && tip.tracked && tip.rotation) {
    sample.flags |= HRT_SAMPLE_JOINT_ROTATION;
    std::copy(tip.rotation->begin(), tip.rotation->end(), sample.joint_rotation);
  }
  hrt_setup_step step{.struct_size = sizeof step};
  plugin_.check(plugin_.hrt_setup_update(session_, &sample, &step));
  if (commanded_deg_ != step.plate_orientation_deg) stage.plate.command(time, step.plate_orientation_deg);
  commanded_deg_ = step.plate_orientation_deg;
  return step;
}

// Runs frames until the plugin has the samples that it needs.
void SetUp::lead(Stage& stage, XrTime* now, std::ostream* slides) {
  for (;; *now = next_frame(stage)) {
    const hrt_setup_step step = update(stage, *now);
    if (is_new_instruction(asked_, step)) {
      if (slides != nullptr && step.done > asked_.done)
        *slides << format("slide %3u  plate %6.1f deg\n", step.done,
                          std::remainder(asked_.plate_orientation_deg, 180.0))  // orientations repeat every 180 degrees
                << std::flush;
      ask(stage, step);
      asked_ = step;
      asked_at_ = *now;
      sightings_.emplace(stage.targets.start_m);
    }
    if (step.instruction == HRT_STEP_FINISH) return;
    if (step.instruction == HRT_STEP_REST_AT_START && stage.hint && *now - asked_at_ > settle_ns)
      stage.hint(sightings_->where(stage));
    if (*now - asked_at_ > stage.time_limit_ns)
      throw Failure(ExitCode::no_hand, "not fulfilled " + within_s(stage.time_limit_ns) + ": " + request_ + " " +
                                           ((step.part & world_parts) != 0 ? sightings_->why_no_touch(stage)
                                                                           : sightings_->why_not_begun(stage)));
  }
}

hrt_setup_result SetUp::run(Stage& stage, std::ostream* slides) {
  XrTime now = next_frame(stage);
  later_by_ = std::max<XrTime>(0, last_ - now);
  commanded_deg_.reset();
  asked_at_ = now;
  sightings_.emplace(stage.targets.start_m);
  const ScopeExit stop([&] {
    try {
      stage.plate.stop(now);
    } catch (const std::exception&) {
      // Either another failure is being reported, or the result no longer needs the plate.
    }
  });
  while (result_.left != 0) {
    lead(stage, &now, slides);
    plugin_.check(plugin_.hrt_setup_finish(session_, &result_));  // a part of a fit: each frame continues it
    check_dropped();
    if (result_.left != 0) now = next_frame(stage);
  }
  return result_;
}

}  // namespace hrt::app
