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
constexpr std::uint32_t no_instruction = UINT32_MAX;  // no instruction has been given yet
// Path length of a simulated participant who is to stay at the start: the mock runtime requires a length above 0.
constexpr double no_path_m = 1e-6;

Hand hand_in_use(const RunContext& context, XrTime time) {
  const auto tracked = std::find_if(context.hands.begin(), context.hands.end(),
                                    [&](Hand hand) { return locate(context, hand, time).tracked; });
  return tracked == context.hands.end() ? context.hands.front() : *tracked;
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
    request += step.of > 1 ? format(" (%u of %u).", step.done + 1, step.of) : ".";
  return request;
}

SetUp::SetUp(const Plugin& plugin, hrt_session session, std::uint32_t what, const hrt_setup_config& config,
             std::vector<std::string> mark_names)
    : plugin_(plugin), session_(session), mark_names_(std::move(mark_names)) {
  asked_.part = what & (~what + 1);  // parts are done in the order of their bits
  asked_.instruction = no_instruction;
  result_.struct_size = sizeof result_;
  result_.left = what;
  const hrt_result begun = plugin.hrt_setup_begin(session, what, &config);
  if (begun == HRT_ERROR_OUT_OF_RANGE) throw Failure(ExitCode::scene, plugin.hrt_last_error());
  plugin.check(begun);
}

SetUp::~SetUp() {
  if (result_.left != 0) static_cast<void>(plugin_.hrt_setup_cancel(session_));
}

// Throws Failure for a dropped part, but not for a failed check, or slides that do not determine the parameters. Only
// the latter end the calibration in hrt_setup_finish(), before asked_ has another part.
void SetUp::check_dropped() const {
  const std::uint32_t touched = HRT_SETUP_FINGERTIP | HRT_SETUP_REGISTRATION;
  if ((result_.dropped & touched) != 0) throw Failure(ExitCode::registration, result_.reason);
  if ((result_.dropped & HRT_SETUP_CALIBRATION) != 0 && asked_.part != HRT_SETUP_CALIBRATION)
    throw Failure(ExitCode::no_hand, result_.reason);
}

void SetUp::ask(RunContext& context, const hrt_setup_step& step) {
  if (step.problem == HRT_PROBLEM_PLATE) throw Failure(ExitCode::plate, step.text);
  context.tell_user(request_of(step, mark_names_));
  if (context.simulation != nullptr && step.instruction == HRT_STEP_REST_AT_START)
    instruct(context, context.hands.front(), 0.0, no_path_m);
  if (context.simulation != nullptr && step.instruction == HRT_STEP_SLIDE)
    instruct(context, context.hands.front(), 0.0,
             distance_along_plate_m({step.place_m[0], 0.0, step.place_m[2]}, context.targets.start_m));
}

// Passes one frame to the plugin, turns the plate as requested, and returns the next instruction.
hrt_setup_step SetUp::update(RunContext& context, XrTime time) {
  const Hand hand = hand_in_use(context, time);
  for (const Hand seen : {Hand::left, Hand::right}) fingers_->add(seen, locate(context, seen, time));
  // Registration, check and fingertip use the joint in world coordinates.
  const bool in_world = (asked_.part & world_parts) != 0;
  Fingertip tip = in_world ? context.session.locate(hand, time) : locate(context, hand, time);
  if ((asked_.part & HRT_SETUP_FINGERTIP) != 0 && !tip.rotation) tip.tracked = false;
  last_ = time + later_by_;
  const std::optional<double> plate_deg = context.plate.orientation_deg(time);
  hrt_sample sample = in_world ? world_sample_of(last_, tip, plate_deg) : sample_of(last_, tip, plate_deg);
  if (in_world && tip.tracked && tip.rotation) {
    sample.flags |= HRT_SAMPLE_JOINT_ROTATION;
    std::copy(tip.rotation->begin(), tip.rotation->end(), sample.joint_rotation);
  }
  hrt_setup_step step{.struct_size = sizeof step};
  plugin_.check(plugin_.hrt_setup_update(session_, &sample, &step));
  if (commanded_deg_ != step.plate_orientation_deg) context.plate.command(time, step.plate_orientation_deg);
  commanded_deg_ = step.plate_orientation_deg;
  return step;
}

// Runs frames until the plugin requests hrt_setup_finish().
void SetUp::run_until_finish(RunContext& context, XrTime* now, std::ostream* slides) {
  for (;; *now = next_frame(context)) {
    const hrt_setup_step step = update(context, *now);
    if (is_new_instruction(asked_, step)) {
      if (slides != nullptr && step.done > asked_.done)
        *slides << format("slide %3u  plate %6.1f deg\n", step.done,
                          std::remainder(asked_.plate_orientation_deg, 180.0))  // orientations repeat every 180 degrees
                << std::flush;
      ask(context, step);
      asked_ = step;
      asked_at_ = *now;
      fingers_.emplace(context.targets.start_m);
    }
    if (step.instruction == HRT_STEP_FINISH) return;
    if (step.instruction == HRT_STEP_REST_AT_START && context.hint && *now - asked_at_ > settle_ns)
      context.hint(fingers_->where(context));
    if (*now - asked_at_ > context.time_limit_ns)
      throw Failure(ExitCode::no_hand, "no response " + within_s(context.time_limit_ns) + ". " +
                                           ((step.part & world_parts) != 0 ? fingers_->why_no_touch(context)
                                                                           : fingers_->why_not_begun(context)));
  }
}

hrt_setup_result SetUp::run(RunContext& context, std::ostream* slides) {
  XrTime now = next_frame(context);
  later_by_ = std::max<XrTime>(0, last_ - now);
  commanded_deg_.reset();
  asked_at_ = now;
  fingers_.emplace(context.targets.start_m);
  const ScopeExit stop([&] {
    try {
      context.plate.stop(now);
    } catch (const std::exception&) {
      // Either another failure is being reported, or the result no longer needs the plate.
    }
  });
  while (result_.left != 0) {
    run_until_finish(context, &now, slides);
    plugin_.check(plugin_.hrt_setup_finish(session_, &result_));  // each call computes a part of the fit
    check_dropped();
    if (result_.left != 0) now = next_frame(context);
  }
  return result_;
}

}  // namespace hrt::app
