// The device that turns the plate, as a node of the class HapticRetargeting has it: libhrt_plate.
#pragma once

#include <haptic_retargeting/plate.h>

#include <optional>
#include <string>

#include "value.h"

namespace hrt_godot {

/** One device at most. Its calls wait for nothing, except open() and close() for up to half a second. */
class PlateDevice {
 public:
  PlateDevice() = default;
  ~PlateDevice();
  PlateDevice(const PlateDevice&) = delete;
  PlateDevice& operator=(const PlateDevice&) = delete;

  /** Closes another one first. */
  hrt_result open(const std::string& name);
  hrt_result turn_to(double orientation_deg) const;
  hrt_result stop() const;
  hrt_result close();

  /** Numbers of the report; empty without a device. */
  Record report() const;
  std::string description() const;
  /** Why it has failed; empty if it has not. */
  std::string message() const;
  /** Where the plate stands, if a device reports it. Takes no memory. */
  std::optional<double> orientation_deg() const;
  /** True once for each device that has failed. */
  bool has_failed_anew();

 private:
  bool get(hrt_plate_report& out_report) const;

  hrt_plate plate_{};
  bool failure_is_known_ = false;
};

}  // namespace hrt_godot
