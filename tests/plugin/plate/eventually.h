#pragma once

#include <gtest/gtest.h>
#include <haptic_retargeting/plate.h>

#include <chrono>
#include <thread>

namespace hrt::plate {

/// Returns true as soon as `condition` is true; false after two minutes, which is long enough for a busy machine.
template <class Condition>
bool eventually(Condition condition) {
  using Clock = std::chrono::steady_clock;
  for (const auto give_up = Clock::now() + std::chrono::minutes(2); !condition();
       std::this_thread::sleep_for(std::chrono::milliseconds(2)))
    if (Clock::now() > give_up) return false;
  return true;
}

inline hrt_plate_report report_of(hrt_plate plate) {
  hrt_plate_report report{};
  report.struct_size = sizeof report;
  EXPECT_EQ(hrt_plate_get(plate, &report), HRT_OK) << hrt_plate_last_error();
  return report;
}

}  // namespace hrt::plate
