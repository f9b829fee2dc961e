#pragma once

#include <gtest/gtest.h>

#include "plugin/include/plate_driver/device.h"
#include "plugin/include/plate_driver/plate_failure.h"

namespace hrt::plate {

struct FailingTest : testing::Test {
  /// Returns the text of the failure; empty if `action` does not fail.
  template <class Action>
  std::string failure_of(Action action) try {
    action();
    return {};
  } catch (const PlateFailure& failed) {
    fault = failed.fault();
    return failed.what();
  }
  static void serve(Device& device, std::chrono::milliseconds time) {
    for (const auto end = device.now() + time; device.now() < end;) device.wait(std::chrono::milliseconds(5));
  }

  Fault fault{};
};

}  // namespace hrt::plate
