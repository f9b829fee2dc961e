// Setting up: samples in, what the user is to do out.
#include <cstring>

#include "plate_node.h"

namespace hrt_godot {

Error PlateNode::begin_setup(int64_t what) {
  const uint32_t parts = what < 0 || what > UINT32_MAX ? UINT32_MAX : static_cast<uint32_t>(what);
  if (configure() && ok(hrt_setup_begin(session_, parts, &setup_config_))) {
    setting_up_ = true;
    step_ = {};
    refused_.reset();
  }
  return error();
}

/** A step is shown when it is another one; its plate's orientation, which may change in every frame, goes the
 *  way of a reach's. */
Error PlateNode::guide(const hrt_sample& sample) {
  hrt_setup_step step = hrt_setup_step_init();
  result_ = hrt_setup_update(session_, &sample, &step);
  if (result_ != HRT_OK) {
    report_sample(reason_of(result_), hrt_last_error());
    return error();
  }
  hrt_setup_step last = step_;
  const bool turns = last.struct_size == 0 || last.plate_orientation_deg != step.plate_orientation_deg;
  last.plate_orientation_deg = step.plate_orientation_deg;
  step_ = step;
  if (turns) engine_.emit(kPlateCommanded, step.plate_orientation_deg);
  if (std::memcmp(&last, &step, sizeof step) != 0) engine_.emit(kSetupStep, to_record(&step, step_fields));
  return Error::kOk;
}

Record PlateNode::finish_setup() {
  hrt_setup_result found = hrt_setup_result_init();
  if (!ok(hrt_setup_finish(session_, &found))) return {};
  setting_up_ = found.left != 0;
  take_changes();
  const Record record = to_record(&found, result_fields);
  if (!setting_up_) engine_.emit(kSetupFinished, record);
  return record;
}

Error PlateNode::cancel_setup() {
  if (ok(hrt_setup_cancel(session_))) setting_up_ = false;
  return error();
}

Error PlateNode::new_person() {
  if (ok(hrt_session_new_person(session_))) take_changes();
  return error();
}

}  // namespace hrt_godot
