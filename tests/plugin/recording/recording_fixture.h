#pragma once

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/paper_simulation/participant.h"
#include "tests/plugin/fixture.h"

namespace hrt::test {

inline std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline hrt_replay_report replay(const std::string& text) {
  auto report = output<hrt_replay_report>();
  EXPECT_OK(hrt_recording_replay(nullptr, text.data(), text.size(), &report));
  return report;
}

inline void expect_same(const hrt_replay_report& report) {
  EXPECT_EQ(report.complete, 1u);
  EXPECT_EQ(report.first_different_line, 0u);
}

/// Expects that the recording of the scripted reach replays to the hash that all hosts compute.
inline void expect_golden_bits() {
  const hrt_replay_report report = replay(read(HRT_GOLDEN_RECORDING));
  expect_same(report);
  EXPECT_EQ(report.hash, HRT_GOLDEN_HASH) << "which is 0x" << std::hex << report.hash;
}

inline std::uint32_t ending(const std::string& text) {
  const hrt_replay_report report = replay(text);
  EXPECT_EQ(report.complete, report.ending == HRT_ENDING_COMPLETE ? 1u : 0u);
  return report.ending;
}

class RecordingTest : public SessionTest {
 protected:
  void SetUp() override {
    create(paper_config());
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = std::filesystem::temp_directory_path() / ("hrt_recording_" + test + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override {
    SessionTest::TearDown();
    std::filesystem::remove_all(folder_);
  }

  const std::filesystem::path& folder() const { return folder_; }
  std::string path() const { return (folder_ / "recording.csv").string(); }

  hrt_recording_status stop() {
    auto status = output<hrt_recording_status>();
    EXPECT_OK(hrt_recording_stop(session, &status));
    return status;
  }

  std::string recording() {
    EXPECT_OK(hrt_recording_start(session, path().c_str()));
    play();
    stop();
    return read(path());
  }

  hrt_result try_update(const hrt_sample& sample) {
    auto command = output<hrt_command>();
    return hrt_reach_update(session, &sample, &command);
  }

  /// Returns pseudo-random noise that is the same on every host.
  double noise() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 40) / double{1 << 23} - 1.0;
  }

  /// Runs three reaches with both controllers and every flag of a sample except JOINT_ROTATION. Some calls fail.
  void play() {
    const hrt_target real = add(HRT_TARGET_REAL, -5.0, "cylinder"), cup = add(HRT_TARGET_VIRTUAL, 5.0, "a \"cup\"");
    reach_by_direction(real, cup);
    hrt_session_config config = session_config();
    config.paper.horizon = 20;
    config.plate.max_speed_deg_s = 400.0;
    config.plate.latency_ns = 30 * ms;
    config.plate.position_m[1] = 0.7;
    config.plate.rotation[1] = 0.6;
    config.plate.rotation[3] = 0.8;
    ASSERT_OK(hrt_session_set(session, &config));
    reach_by_position(real, cup, HRT_SAMPLE_PLATE_POSITION);
    reach_by_position(real, cup, HRT_SAMPLE_WORLD_POSITION | HRT_SAMPLE_PLATE_POSE);
    ASSERT_OK(hrt_target_remove(session, cup));
  }

  void reach_by_direction(hrt_target real, hrt_target virtual_target) {
    ASSERT_OK(begin(real, virtual_target));
    SimulatedParticipant participant({}, 5.0);
    for (int step = 0; step < 30; ++step) {
      hrt_sample sample = direction_sample(step * 100 * ms, participant.finger_direction_deg());
      const hrt_command command = update(sample);
      participant.step(command.plate_orientation_deg, noise());
      sample.time_ns += 40 * ms;
      if (step % 5 == 0) sample.flags = 0;
      update(sample);
    }
    hrt_sample bad = direction_sample(0, std::nan(""));
    EXPECT_EQ(try_update(bad), HRT_ERROR_OUT_OF_RANGE);
    bad.finger_direction_deg = 1.0;
    EXPECT_EQ(try_update(bad), HRT_ERROR_TIME_REVERSED);
    update(direction_sample(3'600'000 * ms, 1.0));
    end();
    EXPECT_EQ(try_update(bad), HRT_ERROR_WRONG_STATE);
  }

  void reach_by_position(hrt_target real, hrt_target virtual_target, std::uint32_t flags) {
    ASSERT_OK(begin(real, virtual_target));
    double right_m = 0.0, forward_m = -0.05, plate_deg = 0.0;
    for (int i = 0; i < 270; ++i) {
      hrt_sample sample = position_sample(i * 11 * ms + 1, right_m, forward_m);
      sample.flags = flags | HRT_SAMPLE_PLATE_ORIENTATION;
      sample.plate_orientation_deg = plate_deg;
      sample.plate_rotation[3] = 1.0;
      if (i % 50 == 49) sample.flags |= HRT_SAMPLE_LIFTED;
      plate_deg += 0.5 * (update(sample).plate_orientation_deg - plate_deg);
      right_m += 0.0002 * noise();
      forward_m += 0.00036;
    }
    end();
  }

 private:
  std::filesystem::path folder_;
  std::uint64_t state_ = 1;
};

}  // namespace hrt::test
