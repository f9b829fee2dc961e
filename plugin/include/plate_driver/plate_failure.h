// Failures of a plate.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace hrt::plate {

/// HRT_PLATE_FAULT_* of haptic_retargeting/plate.h.
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

/// A sentence about the plate without its subject: "is unplugged".
class PlateFailure : public std::runtime_error {
 public:
  PlateFailure(Fault fault, const std::string& sentence) : std::runtime_error(sentence), fault_(fault) {}
  Fault fault() const { return fault_; }

 private:
  Fault fault_;
};

}  // namespace hrt::plate
