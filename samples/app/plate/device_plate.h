#pragma once

#include <haptic_retargeting/plate.h>

#include <string>

#include "samples/app/plate/plate.h"

namespace hrt::app {

/// A plate that libhrt_plate drives (haptic_retargeting/plate.h).
class DevicePlate : public Plate {
 public:
  /// Opens the plate, homes it if necessary, and waits until it is ready, which takes seconds. `device`: as in
  /// hrt_plate_open(). Throws Failure: ExitCode::usage if `device` is invalid, ExitCode::plate for other errors.
  explicit DevicePlate(const std::string& device);
  /// Stops the plate.
  ~DevicePlate() override;
  DevicePlate(const DevicePlate&) = delete;
  DevicePlate& operator=(const DevicePlate&) = delete;

  std::string description() const override;
  const hrt_plate_report* report() const override { return &report_; }
  void service(XrTime time) override;
  void command(XrTime time, double orientation_deg) override;
  std::optional<double> orientation_deg(XrTime time) override;
  void stop(XrTime time) override;

 private:
  void home();
  void check(hrt_result result);

  std::string device_;
  hrt_plate plate_{};
  hrt_plate_report report_{};
};

}  // namespace hrt::app
