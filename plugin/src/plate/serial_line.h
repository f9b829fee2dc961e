// A serial line in raw mode, whose settings are restored at the end.
#pragma once

#include <memory>
#include <string>

#include "plugin/src/plate/line.h"

namespace hrt::plate {

/// The rates that open_serial_line() knows.
inline constexpr int baud_rates[] = {57600, 115200, 1000000};

/// Opens a serial line of `baud`, one of baud_rates, 8 data bits, no parity, 1 stop bit, no flow
/// control. Throws PlateFailure.
std::unique_ptr<Line> open_serial_line(const std::string& device, int baud);

}  // namespace hrt::plate
