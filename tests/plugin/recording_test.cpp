// Recordings, and replaying them.
#if defined(__linux__)
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#endif

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "core/simulation/participant.h"
#include "fixture.h"

namespace hrt::test {
namespace {

constexpr std::int64_t ms = 1'000'000;

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

hrt_replay_report replay(const std::string& text) {
  auto report = output<hrt_replay_report>();
  EXPECT_OK(hrt_replay_text(text.data(), text.size(), &report));
  return report;
}

/// The table of a recording, without its comments.
std::string rows_of(const std::string& text) {
  std::istringstream lines(text);
  std::string rows;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("#")) rows += line + "\n";
  }
  return rows;
}

class RecordingTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
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

  /// A recording of play().
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

  /// Noise that is the same on every host.
  double noise() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 40) / double{1 << 23} - 1.0;
  }

  /// Three reaches that use every kind of sample, errors among them.
  void play() {
    const hrt_target real = add(HRT_TARGET_REAL, -5.0, "cylinder"),
                     cup = add(HRT_TARGET_VIRTUAL, 5.0, "a \"cup\"");
    reach_by_direction(real, cup);
    hrt_session_config config = session_config();
    config.horizon = 20;
    config.plate_max_speed_deg_s = 400.0;
    config.plate_latency_ns = 30 * ms;
    config.guidance = HRT_GUIDANCE_LINE_OF_SIGHT;
    config.adaptation = HRT_ADAPTATION_CARRIED;
    config.plate_position_m[1] = 0.7;
    config.plate_rotation[1] = 0.6;
    config.plate_rotation[3] = 0.8;
    ASSERT_OK(hrt_session_set_config(session, &config));
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

TEST_F(RecordingTest, ReplaysToTheSameBits) {
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  play();
  const hrt_recording_status status = stop();
  EXPECT_EQ(status.rows_lost, 0u);
  EXPECT_EQ(status.system_error, 0);
  auto report = output<hrt_replay_report>();
  ASSERT_OK(hrt_replay_file(path().c_str(), &report));
  EXPECT_EQ(report.complete, 1u);
  EXPECT_EQ(report.rows, 3u * 2u + 64u + 2u * 270u);
  EXPECT_EQ(report.first_different_line, 0u);
}

// The checked-in recording was made by play(); every host, compiler and optimisation gives these bits. After
// a change that is meant to change them, take the file and the hash that this test then names.
TEST_F(RecordingTest, GoldenRecordingGivesTheGoldenHash) {
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  play();
  stop();
  const std::string played = read(path());
  const std::string golden = read(HRT_GOLDEN_RECORDING);
  if (rows_of(played) != rows_of(golden)) {
    std::filesystem::copy_file(path(), "golden_recording.csv",
                               std::filesystem::copy_options::overwrite_existing);
    FAIL() << "played anew, the recording is " << std::filesystem::absolute("golden_recording.csv")
           << " and its hash 0x" << std::hex << replay(played).hash;
  }
  const hrt_replay_report report = replay(golden);
  EXPECT_EQ(report.complete, 1u);
  EXPECT_EQ(report.first_different_line, 0u);
  EXPECT_EQ(report.hash, HRT_GOLDEN_HASH) << "which is 0x" << std::hex << report.hash;
}

TEST_F(RecordingTest, FirstDifferenceIsFound) {
  std::string text = recording();
  const std::size_t second = text.find("\nupdate,0,40000000,");
  ASSERT_NE(second, std::string::npos);
  const std::size_t comma = text.rfind(",0.15,", text.find('\n', second + 1));
  text[comma - 1] = text[comma - 1] == '1' ? '2' : '1';  // the last digit of the distance to go
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(second) + 1, '\n');
  EXPECT_EQ(replay(text).first_different_line, static_cast<uint64_t>(line));
}

TEST_F(RecordingTest, OpensAsATable) {
  std::istringstream rows(rows_of(recording()));
  std::string line;
  std::getline(rows, line);
  EXPECT_TRUE(line.starts_with("call,result,time_ns,sample_flags,")) << line;
  const auto commas = std::count(line.begin(), line.end(), ',');
  while (std::getline(rows, line)) EXPECT_EQ(std::count(line.begin(), line.end(), ','), commas) << line;
}

TEST_F(RecordingTest, CutOffAnywhereIsIncompleteOrRefused) {
  const std::string golden = recording();
  for (std::size_t size = 0; size + 1 < golden.size(); size += size < 4000 ? 1 : 997) {
    auto report = output<hrt_replay_report>();
    const hrt_result result = hrt_replay_text(golden.data(), size, &report);
    if (result == HRT_OK) {
      EXPECT_EQ(report.complete, 0u);
      EXPECT_EQ(report.first_different_line, 0u);
    } else {
      EXPECT_EQ(result, HRT_ERROR_BAD_FORMAT);
    }
  }
}

TEST_F(RecordingTest, WhatIsNotARecordingIsRefusedByLine) {
  const std::string golden = recording();
  const auto refused = [](const std::string& text, const char* part) {
    auto report = output<hrt_replay_report>();
    report.rows = 77;
    expect_error(hrt_replay_text(text.data(), text.size(), &report), HRT_ERROR_BAD_FORMAT, part);
    EXPECT_EQ(report.rows, 77u);
  };
  const std::string header = golden.substr(0, golden.find("# config"));
  const std::string config =
      golden.substr(header.size(), golden.find('\n', header.size()) + 1 - header.size());
  refused("", "does not begin");
  refused("time,x\n1,2\n", "does not begin");
  refused(header + "update,0\n", "line 7: a row before the configuration");
  refused(header + "# config {}\n", "line 7: the configuration has 0 fields");
  refused(header + config + "update,0\n", "line 8: the row has 2 columns");
  refused(header + config + "jump,0" + std::string(28, ',') + "\n", "line 8: the row's call is \"jump\"");
  refused(header + config + "update,0,soon" + std::string(27, ',') + "\n", "line 8: column 3 is \"soon\"");
  auto report = output<hrt_replay_report>();
  expect_error(hrt_replay_file("/no/such/file", &report), HRT_ERROR_SYSTEM, "/no/such/file");
}

TEST_F(RecordingTest, ReplayStopsWhereRowsWereLost) {
  std::string text = recording();
  const std::size_t at = text.find("\nupdate,0,40000000,") + 1;
  text.insert(at, "# lost 3 calls here: the disk was too slow\n");
  const hrt_replay_report report = replay(text);
  EXPECT_EQ(report.complete, 0u);
  EXPECT_EQ(report.rows, 2u);
}

TEST_F(RecordingTest, CallsOutOfOrderAreRefused) {
  auto status = output<hrt_recording_status>();
  expect_error(hrt_recording_stop(session, &status), HRT_ERROR_WRONG_STATE, "nothing is being recorded");
  expect_error(hrt_recording_get_status(session, &status), HRT_ERROR_WRONG_STATE,
               "nothing is being recorded");
  expect_error(hrt_recording_start(session, nullptr), HRT_ERROR_NULL_ARGUMENT, "path");
  expect_error(hrt_recording_start(session, "/no/such/folder/file"), HRT_ERROR_SYSTEM,
               "/no/such/folder/file");
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  expect_error(hrt_recording_start(session, path().c_str()), HRT_ERROR_WRONG_STATE, "already");
  stop();
  begin_reach();
  expect_error(hrt_recording_start(session, path().c_str()), HRT_ERROR_WRONG_STATE, "under way");
}

#if defined(__linux__)  // what makes a disk full or slow here: a device, a limit, a pipe
TEST_F(RecordingTest, DiskThatIsFullAtTheStartIsReported) {
  expect_error(hrt_recording_start(session, "/dev/full"), HRT_ERROR_SYSTEM, "No space left");
  begin_reach();
  update(direction_sample(0, 0.0));
}

// Hears the library's log while it lives.
class Log {
 public:
  Log() { EXPECT_OK(hrt_set_log_callback(hear, this)); }
  ~Log() { EXPECT_OK(hrt_set_log_callback(nullptr, nullptr)); }
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;
  Log(Log&&) = delete;
  Log& operator=(Log&&) = delete;
  std::string text;  // to be read once the recording has stopped

 private:
  static void hear(void* context, uint32_t, const char* text) {
    static_cast<Log*>(context)->text += std::string(text) + "\n";
  }
};

TEST_F(RecordingTest, DiskThatBecomesFullIsReportedAndControlGoesOn) {
  ASSERT_OK(hrt_session_destroy(session));
  session.value = 0;
  {
    Log log;
    create(session_config());
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const rlimit small{.rlim_cur = 100'000, .rlim_max = before.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    ASSERT_OK(hrt_recording_start(session, path().c_str()));
    begin_reach();
    for (int i = 0; i < 5'000; ++i) {
      update(direction_sample(i * ms, 0.0));
      if (i % 1000 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    end();
    const hrt_recording_status status = stop();
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
    EXPECT_EQ(status.system_error, EFBIG);
    EXPECT_GT(status.rows_lost, 0u);
    EXPECT_GE(status.rows_written + status.rows_lost, 5'002u);
    EXPECT_NE(log.text.find("File too large"), std::string::npos) << log.text;
    EXPECT_EQ(replay(read(path())).complete, 0u);
    ASSERT_OK(hrt_session_destroy(session));
    session.value = 0;
  }
}

// A pipe that nobody reads for a while is a disk that has stalled.
TEST_F(RecordingTest, SlowDiskLosesRowsAndNoControl) {
  ASSERT_EQ(mkfifo(path().c_str(), 0600), 0);
  const int reader = open(path().c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  begin_reach();
  for (int i = 0; i < 30'000; ++i) update(direction_sample(i * ms, 0.0));
  auto status = output<hrt_recording_status>();
  ASSERT_OK(hrt_recording_get_status(session, &status));
  EXPECT_GT(status.rows_lost, 10'000u);
  EXPECT_EQ(end().samples, 30'000);

  std::string text;
  std::thread slow([&] {
    fcntl(reader, F_SETFL, 0);
    char block[4096];
    for (ssize_t n = 0; (n = ::read(reader, block, sizeof block)) > 0;)
      text.append(block, static_cast<size_t>(n));
  });
  status = stop();
  slow.join();
  close(reader);
  EXPECT_EQ(status.system_error, 0);
  EXPECT_NE(text.find("\n# lost "), std::string::npos);
  EXPECT_TRUE(text.ends_with("# end\n"));
  EXPECT_EQ(replay(text).complete, 0u);
  EXPECT_EQ(replay(text).first_different_line, 0u);
}

#endif

TEST_F(RecordingTest, PathsAreUtf8) {
  const std::filesystem::path file = folder() / std::filesystem::path(u8"\u00fcbung \u65e5.csv");
  const std::u8string utf8 = file.u8string();
  const char* path = reinterpret_cast<const char*>(utf8.c_str());
  ASSERT_OK(hrt_recording_start(session, path));
  stop();
  EXPECT_TRUE(std::filesystem::exists(file));
  auto report = output<hrt_replay_report>();
  ASSERT_OK(hrt_replay_file(path, &report));
  EXPECT_EQ(report.complete, 1u);
}

TEST_F(RecordingTest, DestroyedSessionCompletesItsRecording) {
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  begin_reach();
  update(direction_sample(0, 0.0));
  ASSERT_OK(hrt_session_destroy(session));
  session.value = 0;
  const hrt_replay_report report = replay(read(path()));
  EXPECT_EQ(report.complete, 1u);
  EXPECT_EQ(report.rows, 2u);
}

}  // namespace
}  // namespace hrt::test
