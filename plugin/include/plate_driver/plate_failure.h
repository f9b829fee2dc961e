// Failures of a plate, and the texts of failures that several kinds of devices share.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace hrt::plate {

/// Cause of a failure: HRT_PLATE_FAULT_* of haptic_retargeting/plate.h.
enum class Fault : std::uint32_t {
  line = 1,
  no_answer,
  unplugged,
  silent,
  no_report,
  limits,
  stuck,
  restarted,
  emergency,
  device,
  protocol,
  internal,
};

/// Failure of a plate. what() is a sentence without its subject "the plate", such as "is unplugged".
class PlateFailure : public std::runtime_error {
 public:
  PlateFailure(Fault fault, const std::string& sentence) : std::runtime_error(sentence), fault_(fault) {}
  Fault fault() const { return fault_; }

 private:
  Fault fault_;
};

inline constexpr const char* silent_text = "has not answered for half a second; check its cable and supply";
inline constexpr const char* restarted_text =
    "has restarted: its supply or its serial line failed; check both, and open the plate again";
inline constexpr const char* second_program_text = "receives commands from another program. End that program";

}  // namespace hrt::plate
