// Sentences of a set-up for the user and the application: hrt_setup_step::text.
#include <cmath>
#include <cstring>

#include "plugin/src/abi/text.h"
#include "plugin/src/api/write.h"

namespace hrt::plugin {
namespace {

const char* problem_text(SetupProblem problem) {
  switch (problem) {
    case SetupProblem::none:
      return "";
    case SetupProblem::too_fast:
      return "The slide was too fast. Please move more slowly. ";
    case SetupProblem::too_slow:
      return "The slide was too slow. Please move faster. ";
    case SetupProblem::stopped:
      return "The finger stopped before the end. Please slide without a stop. ";
    case SetupProblem::left_plate:
      return "The finger left the plate. Please keep it on the plate. ";
    case SetupProblem::lost:
      return "The tracker lost the finger. Please keep your hand in its view. ";
    case SetupProblem::moved:
      return "The plate moved during the slide. Please repeat the slide. ";
    case SetupProblem::plate:
      return "The plate does not turn as commanded. Please ask the supervisor to check it. ";
    case SetupProblem::disagrees:
      return "The measurements do not agree. Please repeat them and keep the plate still. ";
    case SetupProblem::upside_down:
      return "The touches fit a plate that is upside down or mirrored. Please check the marks. ";
    case SetupProblem::undetermined:
      return "The measurements are not sufficient. Please continue. ";
  }
  return "";
}

// Rounds a number in a sentence to one decimal.
double rounded(double value) { return std::round(10.0 * value) / 10.0; }

void write_observed(const Observed& observed, Text<HRT_TEXT_SIZE>& text) {
  using Kind = Observed::Kind;
  switch (observed.kind) {
    case Kind::none:
      break;
    case Kind::no_finger:
      text << "The tracker does not see the finger. ";
      break;
    case Kind::lifted:
      text << "The finger is above the plate in every sample: check the plate's height. ";
      break;
    case Kind::time:
      text << "Times advance by " << rounded(observed.first) << " ns per sample: time_ns must be in nanoseconds. ";
      break;
    case Kind::far_away:
      text << "The finger is " << rounded(observed.first / mm_per_m)
           << " m from the plate: positions must be in metres. ";
      break;
    case Kind::plate:
      text << "The plate reports " << rounded(observed.first) << " degrees although " << rounded(observed.second)
           << " were commanded. ";
      break;
    case Kind::elsewhere:
      text << "The finger is " << std::round(observed.first) << " mm from the requested position. ";
      break;
    case Kind::wrong_way:
      text << "The finger slid towards " << std::round(observed.first)
           << " degrees, where 0 is straight ahead: axes may be swapped or mirrored. ";
      break;
    case Kind::no_rest:
      text << "The finger has not rested at the requested position yet. ";
      break;
  }
}

void write_problem(SetupProblem problem, std::string_view reason, const Observed& observed, Text<HRT_TEXT_SIZE>& text) {
  text << problem_text(problem);
  if (!reason.empty()) text << "(" << reason << ") ";
  write_observed(observed, text);
}

const char* part_text(SetupPart part) {
  switch (part) {
    case setup_fingertip:
      return "fingertip: ";
    case setup_registration:
      return "registration: ";
    case setup_check:
      return "check: ";
    case setup_guides:
      return "guides: ";
    case setup_calibration:
      return "calibration: ";
    case setup_retest:
      return "retest: ";
  }
  return "";
}

const char* attitude_text(int number) {
  // The finger is rotated about two axes, each to both sides.
  constexpr const char* attitudes[finger_attitudes] = {"flat",
                                                       "steeply",
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
  text << part_text(report.drop.part);
  write_problem(report.drop.problem, report.drop_reason, report.drop.observed, text);
  std::memcpy(out, text.c_str(), text.view().size() + 1);
}

}  // namespace hrt::plugin
