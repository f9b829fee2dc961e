// The plate as a device: its firmware behind a pseudo-terminal, which a program opens as a serial line.
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
  /// `link` becomes a symbolic link to the terminal. The plate announces this speed and latency, turns by 90
  /// degrees to either side and has a sensor. Throws an Error if there is something else at `link`, or no
  /// pseudo-terminal.
  PlateTerminal(std::string link, const PlateDynamics& servo, XrTime now);
  ~PlateTerminal();
  PlateTerminal(const PlateTerminal&) = delete;
  PlateTerminal& operator=(const PlateTerminal&) = delete;

  /// Lets the firmware take in what has come and run until `now`, while the plate stands at
  /// `orientation_deg`. Returns where its latest pulse sends the servo; nothing without pulses.
  std::optional<double> run_until(XrTime now, double orientation_deg);

 private:
  static bool send(const char* line, std::uint8_t length);
  static void save(const std::uint8_t* bytes);

  /// Both ends of the terminal; the other one is kept open, so that it lasts from one program to the next.
  struct Ends {
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
