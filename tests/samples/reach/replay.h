#pragma once

#include <gtest/gtest.h>
#include <haptic_retargeting/haptic_retargeting.h>
#include <haptic_retargeting/recording.h>

#include <string>

namespace hrt::reach {

/// Expects a complete recording that replays bit for bit. Returns the number of its rows.
inline std::uint64_t expect_replays(const std::string& file) {
  hrt_replay_report report{.struct_size = sizeof report};
  EXPECT_EQ(hrt_recording_replay(file.c_str(), nullptr, 0, &report), HRT_OK) << hrt_last_error();
  EXPECT_EQ(report.complete, 1U);
  EXPECT_EQ(report.first_different_line, 0U);
  return report.rows;
}

}  // namespace hrt::reach
