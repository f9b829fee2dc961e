// A fixture that serves a device, and takes what a failed one says.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "plugin/src/plate/device.h"
#include "plugin/src/plate/plate_failure.h"

namespace hrt::plate {

class FailingTest : public testing::Test {
 protected:
  /// Empty if `action` does not fail.
  template <class Action>
  std::string failure_of(Action action) {
    try {
      action();
    } catch (const PlateFailure& failed) {
      fault = failed.fault();
      return failed.what();
    }
    return {};
  }
  static void serve(Device& device, std::chrono::milliseconds time) {
    for (const auto end = device.now() + time; device.now() < end;) device.wait(std::chrono::milliseconds(5));
  }

  Fault fault{};
};

}  // namespace hrt::plate
