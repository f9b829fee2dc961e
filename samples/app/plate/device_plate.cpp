#include "samples/app/plate/device_plate.h"

#include <chrono>
#include <cstdio>
#include <thread>

#include "samples/app/base/exit_code.h"
#include "samples/app/text/format.h"

namespace hrt::app {

DevicePlate::DevicePlate(const std::string& device) : device_(device) {
  const hrt_plate_options options{
      .struct_size = sizeof options, .homing = HRT_PLATE_HOMING_SLOW, .host_timeout_ns = 300'000'000};
  const hrt_result opened = hrt_plate_open(device.c_str(), &options, &plate_);
  if (opened != HRT_OK)
    throw Failure(opened == HRT_ERROR_OUT_OF_RANGE ? ExitCode::usage : ExitCode::plate, hrt_plate_last_error());
  report_.struct_size = sizeof report_;
  try {
    for (service(0); report_.state == HRT_PLATE_STATE_OPENING; service(0))
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    home();
  } catch (...) {
    hrt_plate_close(plate_);
    throw;
  }
}

void DevicePlate::home() {
  if ((report_.flags & HRT_PLATE_REPORT_UNHOMED) == 0) return;
  std::fprintf(stderr, "The plate is not homed: it now turns slowly to orientation 0. Keep fingers off it.\n");
  for (command(0, 0.0); (report_.flags & HRT_PLATE_REPORT_FIRST_MOTION) != 0; service(0))
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

DevicePlate::~DevicePlate() { hrt_plate_close(plate_); }

void DevicePlate::service(XrTime) {
  check(hrt_plate_get(plate_, &report_));
  if (report_.state == HRT_PLATE_STATE_FAILED) throw Failure(ExitCode::plate, report_.message);
}

void DevicePlate::command(XrTime, double orientation_deg) { check(hrt_plate_set(plate_, orientation_deg)); }

std::optional<double> DevicePlate::orientation_deg(XrTime) {
  if ((report_.flags & HRT_PLATE_REPORT_ORIENTATION) == 0) return std::nullopt;
  return report_.orientation_deg;
}

void DevicePlate::stop(XrTime) { check(hrt_plate_stop(plate_)); }

// A plate that has just failed rejects commands; the plate's report has the reason.
void DevicePlate::check(hrt_result result) {
  if (result == HRT_OK) return;
  const std::string refusal = hrt_plate_last_error();
  if (hrt_plate_get(plate_, &report_) == HRT_OK && report_.state == HRT_PLATE_STATE_FAILED)
    throw Failure(ExitCode::plate, report_.message);
  throw Failure(ExitCode::plate, "the plate refused a call: " + refusal);
}

std::string DevicePlate::description() const {
  std::string text = "Plate at " + device_ + ": " + report_.description;
  text += format(", %g to %g deg", report_.lower_stop_deg, report_.upper_stop_deg) +
          format(", %g deg/s", report_.max_speed_deg_s);
  if ((report_.flags & HRT_PLATE_REPORT_ROUND_TRIP) != 0)
    text += format(", round trip of the line %.1f ms", static_cast<double>(report_.round_trip_ns) * 1e-6) +
            format(", latency %.1f ms", static_cast<double>(report_.latency_ns) * 1e-6) +
            ((report_.flags & HRT_PLATE_REPORT_MEASURED) != 0 ? ", orientation measured" : ", orientation assumed");
  return text + ".";
}

}  // namespace hrt::app
