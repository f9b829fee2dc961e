// The plate as a device: its firmware at a pseudo-terminal, which a program opens as a serial line.
#pragma once

#include <openxr/openxr.h>

#include <unistd.h>

#include <optional>
#include <string>

#include "core/plate/plate_model.h"
#include "samples/app/firmware/plate.h"

namespace hrt::mock {

class PlateTerminal {
 public:
  /// Creates `link` as a symbolic link to the terminal. The plate reports the given speed and latency, turns by 90
  /// degrees to either side and has a sensor. Throws an Error if another file exists at `link`, or if no
  /// pseudo-terminal is available.
  PlateTerminal(std::string link, const PlateDynamics& servo, XrTime now);
  ~PlateTerminal();
  PlateTerminal(const PlateTerminal&) = delete;
  PlateTerminal& operator=(const PlateTerminal&) = delete;

  /// Runs the firmware until `now` with the received bytes and the plate at `orientation_deg`. Returns the servo
  /// target of its latest pulse; nothing without pulses.
  std::optional<double> run_until(XrTime now, double orientation_deg);

 private:
  static bool send(const char* line, std::uint8_t length);
  static void save(const std::uint8_t* bytes);

  /// Both ends of the terminal; the far end is kept open, so that the terminal persists between programs.
  struct Ends {
    Ends() = default;
    Ends(const Ends&) = delete;
    Ends& operator=(const Ends&) = delete;
    ~Ends() {
      close(own);
      close(other);
    }
    int own = -1;
    int other = -1;
  };

  std::string link_;
  Ends ends_;
  Plate plate_{};
  bool saves_ = false;
  XrTime now_;
};

}  // namespace hrt::mock
