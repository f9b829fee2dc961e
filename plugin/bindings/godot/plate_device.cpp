#include "plate_device.h"

#include "fields.h"

namespace hrt_godot {

PlateDevice::~PlateDevice() {
  hrt_plate_close(plate_);
}

hrt_result PlateDevice::open(const std::string& name) {
  if (const hrt_result closed = close(); closed != HRT_OK) return closed;
  failure_is_known_ = false;
  return hrt_plate_open(name.c_str(), nullptr, &plate_);
}

hrt_result PlateDevice::turn_to(double orientation_deg) const {
  return hrt_plate_set(plate_, orientation_deg);
}

hrt_result PlateDevice::stop() const {
  return hrt_plate_stop(plate_);
}

hrt_result PlateDevice::close() {
  const hrt_result closed = hrt_plate_close(plate_);
  if (closed == HRT_OK) plate_ = {};
  return closed;
}

bool PlateDevice::get(hrt_plate_report& out_report) const {
  out_report = {};
  out_report.struct_size = sizeof out_report;
  return plate_.value != 0 && hrt_plate_get(plate_, &out_report) == HRT_OK;
}

Record PlateDevice::report() const {
  hrt_plate_report report;
  if (!get(report)) return {};
  return to_record(&report, device_fields);
}

std::string PlateDevice::description() const {
  hrt_plate_report report;
  return get(report) ? report.description : "";
}

std::string PlateDevice::message() const {
  hrt_plate_report report;
  return get(report) ? report.message : "";
}

std::optional<double> PlateDevice::orientation_deg() const {
  hrt_plate_report report;
  if (!get(report) || (report.flags & HRT_PLATE_REPORT_ORIENTATION) == 0) return std::nullopt;
  return report.orientation_deg;
}

bool PlateDevice::has_failed_anew() {
  hrt_plate_report report;
  if (failure_is_known_ || !get(report) || report.state != HRT_PLATE_STATE_FAILED) return false;
  failure_is_known_ = true;
  return true;
}

}  // namespace hrt_godot
