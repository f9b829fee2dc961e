// Recordings in the host's process: files, full and slow disks, signals, forks.
#if defined(__linux__)
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <set>
#include <thread>
#endif

#include "recording_fixture.h"

// In the child of a fork, memory of the parent's threads is unreachable, and must not be reported as a leak.
extern "C" __attribute__((weak, visibility("default"))) const char* __lsan_default_suppressions() {
  return "leak:start_thread_with_signals_blocked\n";
}

namespace hrt::test {
namespace {

#if !defined(__EMSCRIPTEN__)  // in WebAssembly, the library does not check or lock files
TEST_F(RecordingTest, FileOfAnotherRecordingIsRejected) {
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  begin_reach();
  const hrt_session_config config = paper_config();
  hrt_session other{};
  ASSERT_OK(hrt_session_create(HRT_VERSION, &config, &other));
  const std::string same = (folder() / "." / "recording.csv").string();
  expect_error(hrt_recording_start(other, same.c_str()), HRT_ERROR_SYSTEM, ": another recording");
  EXPECT_NE(std::string(hrt_last_error()).find(same.substr(0, 64)), std::string::npos) << hrt_last_error();
  ASSERT_OK(hrt_reach_cancel(session));
  stop();
  EXPECT_EQ(replay(read(path())).rows, 2u);
  EXPECT_EQ(replay(read(path())).complete, 1u);
  EXPECT_OK(hrt_recording_start(other, same.c_str()));
  EXPECT_OK(hrt_session_destroy(other));
}

TEST_F(RecordingTest, NonRegularFilesAreRejected) {
  const auto refused = [&](const std::string& path) {
    expect_error(hrt_recording_start(session, path.c_str()), HRT_ERROR_SYSTEM, "");
    EXPECT_NE(std::string(hrt_last_error()).find(path.substr(0, 64)), std::string::npos) << hrt_last_error();
  };
  refused(folder().string());
#if defined(_WIN32)
  refused("NUL");
#else
  refused("/dev/null");
#endif
}
#endif

#if defined(__linux__)  // these tests use Linux's pipes, limits and processes

TEST_F(RecordingTest, PipesAreRejectedWithoutBlocking) {
  ASSERT_EQ(mkfifo(path().c_str(), 0600), 0);
  auto report = output<hrt_replay_report>();
  expect_error(hrt_recording_start(session, path().c_str()), HRT_ERROR_SYSTEM, path().substr(0, 40));
  expect_error(hrt_recording_replay(path().c_str(), nullptr, 0, &report), HRT_ERROR_SYSTEM, path().substr(0, 40));
  const int reader = open(path().c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  expect_error(hrt_recording_start(session, path().c_str()), HRT_ERROR_SYSTEM, path().substr(0, 40));
  close(reader);
  expect_error(hrt_recording_replay("/dev/zero", nullptr, 0, &report), HRT_ERROR_SYSTEM, "/dev/zero");
}

/// While this object exists, the system limits files to `size` bytes.
class FullDisk {
 public:
  explicit FullDisk(rlim_t size) {
    std::signal(SIGXFSZ, SIG_IGN);
    EXPECT_EQ(getrlimit(RLIMIT_FSIZE, &before_), 0);
    const rlimit small{.rlim_cur = size, .rlim_max = before_.rlim_max};
    EXPECT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  }
  ~FullDisk() { EXPECT_EQ(setrlimit(RLIMIT_FSIZE, &before_), 0); }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
};

TEST_F(RecordingTest, DiskThatIsFullAtTheStartIsReported) {
  const FullDisk disk(100);
  expect_error(hrt_recording_start(session, path().c_str()), HRT_ERROR_SYSTEM, "File too large");
  begin_reach();
  update(direction_sample(0, 0.0));
}

TEST_F(RecordingTest, FullDiskIsReportedAndTheSessionContinues) {
  const Log others;
  Log log(session);
  hrt_recording_status status{};
  {
    const FullDisk disk(100'000);
    ASSERT_OK(hrt_recording_start(session, path().c_str()));
    begin_reach();
    for (int i = 0; i < 5'000; ++i) {
      update(direction_sample(i * ms, 0.0));
      if (i % 1000 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    end();
    status = stop();
  }
  EXPECT_EQ(status.system_error, EFBIG);
  EXPECT_GT(status.rows_lost, 0u);
  EXPECT_GE(status.rows_written + status.rows_lost, 5'002u);
  EXPECT_TRUE(log.text.starts_with(std::to_string(HRT_LOG_ERROR) + " session " + std::to_string(session.value) + ", " +
                                   path().substr(0, 64)))
      << log.text;
  EXPECT_NE(log.text.find("File too large"), log.text.npos) << log.text;
  EXPECT_EQ(others.text, "");
  EXPECT_EQ(replay(read(path())).complete, 0u);
}

std::vector<int> descriptors_of(const std::string& path) {
  std::vector<int> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    std::error_code gone;
    if (std::filesystem::read_symlink(entry.path(), gone) == std::filesystem::canonical(path))
      found.push_back(std::stoi(entry.path().filename().string()));
  }
  return found;
}

// A pipe replaces the file. While nothing reads the pipe, it acts as a stalled disk; later, as a slow one.
TEST_F(RecordingTest, SlowDiskLosesRowsAndDelaysNoCall) {
  Log log;
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  const std::vector<int> files = descriptors_of(path());
  ASSERT_EQ(files.size(), 1u);
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  ASSERT_EQ(dup2(ends[1], files[0]), files[0]);
  close(ends[1]);
  begin_reach();
  for (int i = 0; i < 30'000; ++i) update(direction_sample(i * ms, 0.0));
  auto status = output<hrt_recording_status>();
  ASSERT_OK(hrt_recording_get_status(session, &status));
  EXPECT_GT(status.rows_lost, 10'000u);

  std::string text = read(path());
  std::thread slow([&] {
    char block[4096];
    for (ssize_t n = 0; (n = ::read(ends[0], block, sizeof block)) > 0;) {
      text.append(block, static_cast<size_t>(n));
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
  });
  for (int i = 30'000; i < 40'000; ++i) {
    update(direction_sample(i * ms, 0.0));
    std::this_thread::sleep_for(std::chrono::microseconds(20));
  }
  EXPECT_EQ(end().counts.samples, 40'000);
  status = stop();
  slow.join();
  close(ends[0]);
  EXPECT_EQ(status.system_error, 0);
  // After a loss, no row is accepted until half of the recording's buffer is free, so there are few gaps and few lines
  // in the log.
  std::size_t gaps = 0;
  for (std::size_t at = 0; (at = text.find("\n# lost ", at + 1)) != text.npos;) ++gaps;
  EXPECT_GE(gaps, 1u);
  EXPECT_LE(gaps, 10u);
  EXPECT_NE(log.text.find(" calls were not recorded"), log.text.npos) << log.text;
  EXPECT_NE(text.find("\n# end "), std::string::npos);
  EXPECT_EQ(ending(text), HRT_ENDING_LOST_ROWS);
  EXPECT_EQ(replay(text).first_different_line, 0u);
}

// Files that are too large, or that do not begin like a recording, are rejected quickly.
TEST_F(RecordingTest, LargeFilesAreRejectedWithoutReadingThem) {
  const auto refused = [&](std::uintmax_t size, hrt_result code, const char* part) {
    std::ofstream(path(), std::ios::binary) << "not a recording";
    std::filesystem::resize_file(path(), size);
    auto report = output<hrt_replay_report>();
    const auto before = std::chrono::steady_clock::now();
    expect_error(hrt_recording_replay(path().c_str(), nullptr, 0, &report), code, part);
    EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::milliseconds(100));
  };
  refused(std::uintmax_t{6} << 30, HRT_ERROR_SYSTEM, "has 6442450944 bytes; allowed: up to 1073741824");
  refused(std::uintmax_t{1} << 30, HRT_ERROR_BAD_FORMAT, "version 4");
}

/// Runs the body in a child of this process, and returns its status by waitpid().
template <class Body>
int status_in_child(Body&& body) {
  const pid_t child = fork();
  if (child == 0) {
    alarm(20);  // instead of hanging
    body();
    std::exit(testing::Test::HasFailure() ? 1 : 0);
  }
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  return status;
}

// In the child the session works, but is not recorded: the log says so, and hrt_recording_get_status() and
// hrt_recording_stop() fail.
TEST_F(RecordingTest, ForkedChildIsNotRecordedAndReportsIt) {
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  begin_reach();
  update(direction_sample(0, 1.0));
  // Waits until the writing thread runs: under the address sanitizer, a child that is forked earlier may hang.
  auto written = output<hrt_recording_status>();
  ASSERT_OK(hrt_recording_flush(session, &written));
  EXPECT_EQ(written.rows_written, 2u);
  const std::string of_child = (folder() / "child.csv").string();
  const int child = status_in_child([&] {
    Log log;
    update(direction_sample(1, 1.0));
    for (int i = 0; i < 10'000; ++i) update(direction_sample(2, 1.0));
    auto status = output<hrt_recording_status>();
    expect_error(hrt_recording_get_status(session, &status), HRT_ERROR_WRONG_STATE);
    expect_error(hrt_recording_stop(session, &status), HRT_ERROR_WRONG_STATE);
    end();
    expect_error(hrt_recording_start(session, path().c_str()), HRT_ERROR_SYSTEM, "another recording");
    ASSERT_OK(hrt_recording_start(session, of_child.c_str()));
    EXPECT_NE(log.text.find(path().substr(0, 64)), std::string::npos) << log.text;
    EXPECT_NE(log.text.find(": 10002 calls"), std::string::npos) << log.text;
    begin_reach();
    ASSERT_OK(hrt_reach_cancel(session));
    stop();
    EXPECT_EQ(replay(read(of_child)).rows, 2u);
  });
  EXPECT_EQ(child, 0);
  // This child makes no call; its exit runs the library's destructors.
  EXPECT_EQ(status_in_child([] {}), 0);
  EXPECT_EQ(status_in_child([&] { EXPECT_OK(hrt_session_destroy(session)); }), 0);
  update(direction_sample(1, 2.0));
  end();
  EXPECT_EQ(stop().rows_written, 4u);
  const hrt_replay_report report = replay(read(path()));
  EXPECT_EQ(report.rows, 4u);
  expect_same(report);
}

TEST_F(RecordingTest, StoppedRecordingUnlocksItsFileDespiteRunningChildren) {
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  const pid_t child = fork();
  if (child == 0) {
    alarm(20);
    pause();
    _exit(0);
  }
  stop();
  EXPECT_OK(hrt_recording_start(session, path().c_str()));
  stop();
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
}

std::set<std::string> threads() {
  std::set<std::string> ids;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task"))
    ids.insert(entry.path().filename().string());
  return ids;
}

TEST_F(RecordingTest, ThreadBlocksSignalsAndChildrenInheritNoFile) {
  const std::set<std::string> before = threads();
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  int writers = 0;
  for (const std::string& id : threads()) {
    if (before.contains(id)) continue;
    ++writers;
    const std::string status = read("/proc/self/task/" + id + "/status");
    const std::uint64_t blocked = std::stoull(status.substr(status.find("SigBlk:") + 7), nullptr, 16);
    EXPECT_TRUE(blocked >> (SIGUSR1 - 1) & 1) << std::hex << blocked;
    EXPECT_TRUE(blocked >> (SIGTERM - 1) & 1) << std::hex << blocked;
  }
  EXPECT_GE(writers, 1);  // the thread sanitizer adds a thread of its own
  sigset_t own;
  ASSERT_EQ(pthread_sigmask(SIG_SETMASK, nullptr, &own), 0);
  EXPECT_EQ(sigismember(&own, SIGUSR1), 0);
  const std::vector<int> files = descriptors_of(path());
  ASSERT_EQ(files.size(), 1u);
  EXPECT_NE(fcntl(files[0], F_GETFD) & FD_CLOEXEC, 0);
  stop();
}
#endif

}  // namespace
}  // namespace hrt::test
