// The simulated plate as a device: its firmware runs behind a pseudo-terminal, which a program opens as a serial line.
#pragma once

#include <openxr/openxr.h>

#include <optional>
#include <string>

#include "core/plate/plate_model.h"
#include "samples/app/emulator/pseudo_terminal.h"
#include "samples/app/firmware/plate.h"

namespace hrt::mock {

class PlateTerminal {
 public:
  /// Creates the symbolic link `link` to the terminal. The plate reports the speed and latency of `servo`, can rotate
  /// by 90 degrees to either side and has a sensor. Throws an Error if a file that is not a symbolic link exists at
  /// `link`, or if no pseudo-terminal is available.
  PlateTerminal(std::string link, const PlateDynamics& servo, XrTime now);
  ~PlateTerminal();
  PlateTerminal(const PlateTerminal&) = delete;
  PlateTerminal& operator=(const PlateTerminal&) = delete;

  /// Runs the firmware until `now` with the bytes received since the last call; its sensor reads `orientation_deg`.
  /// Returns the orientation to which the servo pulses steer; nothing if the firmware sends no pulses.
  std::optional<double> run_until(XrTime now, double orientation_deg);

 private:
  static bool send(const char* line, std::uint8_t length);
  static void save(const std::uint8_t* bytes);

  std::string link_;
  plate::Pty terminal_;
  Plate plate_{};
  bool save_requested_ = false;
  XrTime now_;
};

}  // namespace hrt::mock
