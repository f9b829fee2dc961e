// The device that turns the plate. Only close_device(), which open_device() calls, waits for it, for at most 0.5 s.
#include "plate_node.h"

namespace hrt_godot {

/** Returns the report of the device, or zeros without a device. */
hrt_plate_report PlateNode::read_device() const {
  hrt_plate_report report{};
  report.struct_size = sizeof report;
  return device_.value && hrt_plate_get(device_, &report) == HRT_OK ? report : hrt_plate_report{};
}

/** Returns the error of a call, and shows it. WRONG_STATE is not shown, because each frame may command a device that is
 *  being opened; if the device has failed, its failure is shown once. */
Error PlateNode::after_device(hrt_result result) {
  result_ = result;
  if (result == HRT_ERROR_WRONG_STATE) {
    const hrt_plate_report report = read_device();
    if (!device_failure_is_shown_ && report.state == HRT_PLATE_STATE_FAILED) {
      device_failure_is_shown_ = true;
      engine_.push_error(report.message);
    }
  } else if (result != HRT_OK) {
    engine_.push_error(script_names(hrt_plate_last_error()).c_str());
  }
  return error();
}

Error PlateNode::open_device(std::string device) {
  if (const Error closed = close_device(); closed != Error::kOk) return closed;
  device_failure_is_shown_ = false;
  return after_device(hrt_plate_open(engine_.system_path(device).c_str(), nullptr, &device_));
}

Error PlateNode::take_device() {
  const hrt_plate_report report = read_device();
  if (report.state != HRT_PLATE_STATE_READY) return Error::kUnavailable;
  hrt_session_config_from_plate(&properties_.session, &report);
  engine_.update_warnings();
  return Error::kOk;
}

Error PlateNode::close_device() {
  const Error closed = after_device(hrt_plate_close(device_));
  if (closed == Error::kOk) device_ = {};
  return closed;
}

}  // namespace hrt_godot
