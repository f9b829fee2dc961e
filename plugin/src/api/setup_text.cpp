// Sentences of a set-up for the user and the application: hrt_setup_step::text and hrt_setup_result::reason.
#include <cmath>
#include <cstring>
#include <iterator>
#include <utility>

#include "plugin/src/abi/text.h"
#include "plugin/src/api/write.h"

namespace hrt::plugin {
namespace {

constexpr const char* problem_texts[] = {  // indexed by SetupProblem
    "",
    "The slide was too fast. Please move more slowly. ",
    "The slide was too slow. Please move faster. ",
    "The finger stopped during the slide. Please slide without a stop. ",
    "The finger left the plate. Please keep it on the plate. ",
    "The tracker lost the finger. Please keep your hand in view of the tracker. ",
    "The plate moved during the slide. Please repeat the slide. ",
    "The plate does not turn as commanded. Please ask the supervisor to check the plate. ",
    "The measurements do not agree. Please repeat them and keep the plate still. ",
    "The touches fit a plate that is upside down or mirrored. Please check the marks. ",
    "The measurements are not sufficient. Please continue. "};
static_assert(std::size(problem_texts) == static_cast<std::size_t>(SetupProblem::undetermined) + 1);

double rounded(double value) { return std::round(10.0 * value) / 10.0; }

void write_observed(const Observed& observed, Text<HRT_TEXT_SIZE>& text) {
  using Kind = Observed::Kind;
  switch (observed.kind) {
    case Kind::none:
      break;
    case Kind::no_finger:
      text << "The tracker does not see the finger: keep the finger in its view. ";
      break;
    case Kind::lifted:
      text << "The finger was above the plate in every sample: put it on the plate, or check the plate's height. ";
      break;
    case Kind::time:
      text << "[Times advance by " << rounded(observed.first) << " ns per sample: time_ns must be in nanoseconds.] ";
      break;
    case Kind::far_away:
      text << "[The finger is " << rounded(observed.first / mm_per_m)
           << " m from the requested position: check that positions are in metres, and the plate's pose.] ";
      break;
    case Kind::plate:
      text << "[The plate reports " << rounded(observed.first) << " degrees, but " << rounded(observed.second)
           << " degrees were commanded: check the servo and the sign of its angles.] ";
      break;
    case Kind::elsewhere:
      text << "The finger is " << std::round(observed.first)
           << " mm from the requested position: move it there, or check the plate's pose. ";
      break;
    case Kind::wrong_way:
      text << "[The finger slid towards " << std::round(observed.first)
           << " degrees, where 0 is straight ahead: check for swapped or mirrored axes.] ";
      break;
    case Kind::no_rest:
      text << "The finger has not rested at the requested position yet: keep it still there. ";
      break;
  }
}

void write_problem(SetupProblem problem, std::string_view reason, const Observed& observed, Text<HRT_TEXT_SIZE>& text) {
  text << problem_texts[static_cast<std::size_t>(problem)];
  if (!reason.empty() && observed.kind == Observed::Kind::none) text << "[" << reason << "] ";  // both do not fit
  write_observed(observed, text);
}

constexpr std::pair<std::uint32_t, const char*> part_texts[] = {
    {setup_fingertip, "fingertip: "}, {setup_registration, "registration: "}, {setup_check, "check: "},
    {setup_guides, "guides: "},       {setup_calibration, "calibration: "},   {setup_retest, "retest: "}};

const char* attitude_text(int number) {
  constexpr const char* attitudes[finger_attitudes] = {"flat",
                                                       "almost upright",
                                                       "tilted onto its left side",
                                                       "tilted onto its right side",
                                                       "flat, turned to the left",
                                                       "flat, turned to the right"};
  return attitudes[number % finger_attitudes];
}

void write_touch(const SetupStep& step, Text<HRT_TEXT_SIZE>& text) {
  if (step.part == setup_fingertip) {
    text << "Lift your finger. Then touch mark 1 with the finger held " << attitude_text(step.number)
         << ", and keep it still.";
  } else if (step.part == setup_check) {
    text << "Touch mark " << step.number + 1 << " and hold still, to check the plate's position.";
  } else {
    text << "Lift your finger. Then touch mark " << step.number + 1 << " and hold still.";
  }
}

}  // namespace

void write_step_text(const SetupStep& step, char (&out)[HRT_TEXT_SIZE]) {
  Text<HRT_TEXT_SIZE> text;
  write_problem(step.problem, step.reason, step.observed, text);
  switch (step.instruction) {
    case Instruction::wait:
      text << "Lift your finger while the plate turns.";
      break;
    case Instruction::touch_mark:
      write_touch(step, text);
      break;
    case Instruction::hold_still:
      text << "Hold still.";
      break;
    case Instruction::rest_at_start:
      text << "Put your finger on the start and let it rest.";
      break;
    case Instruction::slide:
      if (step.part == setup_guides)
        text << "Slide along guide " << step.number + 1
             << (step.done % 2 == 0 ? " to the object" : " back to the start") << ", without lifting, and rest there.";
      else
        text << "Slide evenly towards what feels straight ahead, as far as is comfortable, and rest there.";
      break;
    case Instruction::finish:
      text << "Please wait a moment.";
      break;
  }
  std::memcpy(out, text.c_str(), text.view().size() + 1);
}

void write_drop_text(const SetupReport& report, char (&out)[HRT_TEXT_SIZE]) {
  Text<HRT_TEXT_SIZE> text;
  for (const auto& [part, name] : part_texts)
    if (part == report.drop.part) text << name;
  const bool lacks_data = report.drop.problem == SetupProblem::undetermined;
  const bool has_moved = report.drop.part == setup_check && report.drop.problem == SetupProblem::disagrees;
  if (lacks_data) text << "The measurements are not sufficient. Please repeat this part. ";
  if (has_moved) text << "The plate does not seem to be where it was registered. Please register it again. ";
  write_problem(lacks_data || has_moved ? SetupProblem::none : report.drop.problem, report.drop_reason,
                report.drop.observed, text);
  std::memcpy(out, text.c_str(), text.view().size() + 1);
}

}  // namespace hrt::plugin
