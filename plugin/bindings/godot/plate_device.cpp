// The device that turns the plate: libhrt_plate. Its calls wait for nothing, except open and close for up to
// half a second.
#include "plate_node.h"

namespace hrt_godot {

/** False without a device. Takes no memory. */
bool PlateNode::read_device(hrt_plate_report& out) const {
  out = {};
  out.struct_size = sizeof out;
  return device_.value != 0 && hrt_plate_get(device_, &out) == HRT_OK;
}

// Each frame may turn a device that is being opened, or has failed: the reason of a failure is shown once.
Error PlateNode::after_device(hrt_result result) {
  result_ = result;
  hrt_plate_report report;
  if (result == HRT_ERROR_WRONG_STATE) {
    if (!failure_is_known_ && read_device(report) && report.state == HRT_PLATE_STATE_FAILED) {
      failure_is_known_ = true;
      engine_.push_error(report.message);
    }
  } else if (result != HRT_OK) {
    engine_.push_error(hrt_plate_last_error());
  }
  return error();
}

Error PlateNode::open_device(std::string device) {
  if (const Error closed = close_device(); closed != Error::kOk) return closed;
  failure_is_known_ = false;
  return after_device(hrt_plate_open(device.c_str(), nullptr, &device_));
}

Error PlateNode::turn_device(double orientation_deg) { return after_device(hrt_plate_set(device_, orientation_deg)); }

Error PlateNode::stop_device() { return after_device(hrt_plate_stop(device_)); }

Record PlateNode::get_device_report() {
  hrt_plate_report report;
  return read_device(report) ? to_record(&report, device_fields) : Record{};
}

Error PlateNode::take_device() {
  hrt_plate_report report;
  result_ = read_device(report) && report.state == HRT_PLATE_STATE_READY ? HRT_OK : HRT_ERROR_WRONG_STATE;
  if (result_ != HRT_OK) return error();
  hrt_session_config_from_plate(&config_, &report);
  engine_.update_warnings();
  return Error::kOk;
}

Error PlateNode::close_device() {
  const Error closed = after_device(hrt_plate_close(device_));
  if (closed == Error::kOk) device_ = {};
  return closed;
}

}  // namespace hrt_godot
