// The servo that turns the plate: a command takes effect after a latency, then the plate turns towards it
// at a constant speed.
#pragma once

#include <openxr/openxr.h>

#include <deque>

#include "samples/mock_runtime/world/settings.h"

namespace hrt::mock {

class Servo {
 public:
  explicit Servo(const ServoSettings& settings) : settings_(settings) {}

  /// Commands must come in the order of their times.
  void command(XrTime time, double orientation_deg);

  /// The plate's orientation at a time, past or (if no further command comes) future.
  double orientation_deg(XrTime time) const;

 private:
  // From `start` on the plate turns from `from_deg` to `to_deg`.
  struct Turn {
    XrTime start;
    double from_deg;
    double to_deg;
  };

  ServoSettings settings_;
  std::deque<Turn> turns_;  // the latest, oldest first
};

}  // namespace hrt::mock
