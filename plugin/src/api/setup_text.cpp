// The sentences of a set-up.
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
      return "That was too fast to count. ";
    case SetupProblem::too_slow:
      return "That was too slow to count. ";
    case SetupProblem::stopped:
      return "The finger stopped elsewhere: that does not count. ";
    case SetupProblem::left_plate:
      return "The finger left the plate: that does not count. ";
    case SetupProblem::lost:
      return "The tracker lost the finger: hold the hand where it is seen. ";
    case SetupProblem::moved:
      return "The plate has moved: that does not count. ";
    case SetupProblem::plate:
      return "The plate does not turn as it should. ";
    case SetupProblem::disagrees:
      return "That does not fit together: once more, each in its turn, with the plate still. ";
    case SetupProblem::upside_down:
      return "By the touches the plate lies upside down: left and right were confused. ";
    case SetupProblem::undetermined:
      return "That does not show enough yet. ";
  }
  return "";
}

const char* attitude_text(int number) {
  // About two axes, each to both sides.
  constexpr const char* attitudes[finger_attitudes] = {"flat",
                                                       "steeply",
                                                       "leant to the left",
                                                       "leant to the right",
                                                       "flat, turned to the left",
                                                       "flat, turned to the right"};
  return attitudes[number % finger_attitudes];
}

void write_touch(const SetupStep& step, Text<HRT_TEXT_SIZE>& text) {
  if (step.part == setup_fingertip) {
    text << "Lift your finger. Then touch mark 1 with the finger held " << attitude_text(step.number)
         << ", and hold still.";
  } else if (step.part == setup_check) {
    text << "Touch mark " << step.number + 1 << " and hold still: is the plate where it was?";
  } else {
    text << "Lift your finger. Then touch mark " << step.number + 1 << " and hold still.";
  }
}

}  // namespace

void write_step_text(const SetupStep& step, char (&out)[HRT_TEXT_SIZE]) {
  Text<HRT_TEXT_SIZE> text;
  text << problem_text(step.problem);
  switch (step.instruction) {
    case Instruction::wait:
      text << "Lift your finger: the plate turns.";
      break;
    case Instruction::touch_mark:
      write_touch(step, text);
      break;
    case Instruction::hold_still:
      text << "Hold still.";
      break;
    case Instruction::rest_at_start:
      text << "Put your finger to the start and let it rest.";
      break;
    case Instruction::slide:
      if (step.part == setup_guides)
        text << "Slide along guide " << step.number + 1
             << (step.done % 2 == 0 ? " to the object" : " back to the start") << ", without a lift, and rest there.";
      else
        text << "Slide evenly towards what feels straight ahead, as far as is comfortable, and rest there.";
      break;
    case Instruction::finish:
      text << "One moment.";
      break;
  }
  std::memcpy(out, text.c_str(), text.view().size() + 1);
}

}  // namespace hrt::plugin
