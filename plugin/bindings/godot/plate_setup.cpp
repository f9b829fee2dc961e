#include <cstring>

#include "plate_node.h"

namespace hrt_godot {

Error PlateNode::begin_setup(int64_t what) {
  const uint32_t parts = std::in_range<uint32_t>(what) ? static_cast<uint32_t>(what) : UINT32_MAX;
  if (configure() && ok(hrt_setup_begin(session_, parts, &properties_.setup))) {
    setting_up_ = true;
    step_ = {};
    found_ = {};
    refused_.reset();
  }
  return error();
}

/** Processes a sample. Emits plate_commanded if the plate orientation changes, setup_step if anything else changes. */
Error PlateNode::guide(const hrt_sample& sample) {
  hrt_setup_step step = hrt_setup_step_init();
  if (!taken(hrt_setup_update(session_, &sample, &step))) return error();
  hrt_setup_step last = step_;
  const bool turns = last.struct_size == 0 || last.plate_orientation_deg != step.plate_orientation_deg;
  last.plate_orientation_deg = step.plate_orientation_deg;
  step_ = step;
  if (turns) engine_.emit(kPlateCommanded, step.plate_orientation_deg);
  if (std::memcmp(&last, &step, sizeof step) != 0) engine_.emit(kSetupStep, to_record(step));
  return setting_up_ && step.instruction == HRT_STEP_FINISH ? continue_fit() : Error::kOk;
}

Error PlateNode::continue_fit() {
  hrt_setup_result found = hrt_setup_result_init();
  if (!ok(hrt_setup_finish(session_, &found))) return error();
  setting_up_ = found.left != 0;
  if (found.done != found_.done || !setting_up_) take_changes();
  found_ = found;
  if (!setting_up_) engine_.emit(kSetupFinished, to_record(found));
  return Error::kOk;
}

Error PlateNode::cancel_setup() {
  if (ok(hrt_setup_cancel(session_))) setting_up_ = false;
  return error();
}

Error PlateNode::new_person() {
  if (ok(hrt_profile_reset(session_))) take_changes();
  return error();
}

}  // namespace hrt_godot
