// Calls of libhaptic_retargeting and libhrt_plate with the tag [real-time] allocate nothing, take no lock and make no
// system call, also when they fail. Memory and lock functions are replaced by functions that count; the kernel forbids
// system calls.
#include <dlfcn.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <pthread.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "fixture.h"
#include "haptic_retargeting/plate.h"
#include "samples/app/emulator/pty_device.h"
#include "tests/plugin/plate/eventually.h"

namespace {

constinit thread_local bool watching = false;  // true: the calls of this thread are counted
constinit std::atomic<long> allocations{0};
constinit std::atomic<long> locks{0};

void count(std::atomic<long>& counter) {
  if (watching) counter.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace

extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);

void* malloc(std::size_t size) {
  count(allocations);
  return __libc_malloc(size);
}
void* calloc(std::size_t n, std::size_t size) {
  count(allocations);
  return __libc_calloc(n, size);
}
void* realloc(void* memory, std::size_t size) {
  count(allocations);
  return __libc_realloc(memory, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  count(allocations);
  return __libc_memalign(alignment, size);
}
void free(void* memory) {
  if (memory) count(allocations);
  __libc_free(memory);
}

int pthread_mutex_lock(pthread_mutex_t* mutex) {
  static const auto real = reinterpret_cast<int (*)(pthread_mutex_t*)>(dlsym(RTLD_NEXT, "pthread_mutex_lock"));
  count(locks);
  return real(mutex);
}
int pthread_mutex_trylock(pthread_mutex_t* mutex) {
  static const auto real = reinterpret_cast<int (*)(pthread_mutex_t*)>(dlsym(RTLD_NEXT, "pthread_mutex_trylock"));
  count(locks);
  return real(mutex);
}
}

namespace hrt::test {
namespace {

class RealTimeTest : public SessionTest {
 protected:
  void SetUp() override {
    hrt_session_config config = session_config();
    config.flags = HRT_SESSION_REGISTERED;
    create(config);
    reach = reach_config(add(HRT_TARGET_REAL, -5.0), add(HRT_TARGET_VIRTUAL, 5.0));
  }

  /// Makes the real-time calls of reaches, with success and with errors. Returns the number of unexpected results.
  int call_everything() const {
    int wrong = 0;
    const auto expect = [&](hrt_result result, hrt_result expected) { wrong += result != expected; };
    auto command = output<hrt_command>();
    auto summary = output<hrt_reach_summary>();
    const hrt_sample nan = direction_sample(0, std::nan("")), early = direction_sample(-1, 0.0);
    hrt_sample both = direction_sample(0, 0.0);
    both.flags = ~0u;
    hrt_sample small = direction_sample(0, 0.0);
    small.struct_size = 1;

    expect(hrt_reach_update(session, &nan, &command), HRT_ERROR_WRONG_STATE);
    expect(hrt_reach_end(session, &summary), HRT_ERROR_WRONG_STATE);
    expect(hrt_reach_begin(session, nullptr), HRT_ERROR_NULL_ARGUMENT);
    expect(hrt_reach_begin(session, &reach), HRT_OK);
    expect(hrt_reach_begin(session, &reach), HRT_ERROR_WRONG_STATE);
    for (int i = 0; i < 1000; ++i) {
      const hrt_sample direction = direction_sample(std::int64_t{i} * 20'000'000, 10.0 - 0.02 * i);
      expect(hrt_reach_update(session, &direction, &command), HRT_OK);
      if (i % 100 != 0) continue;
      expect(hrt_reach_update(session, &early, &command), HRT_ERROR_TIME_REVERSED);
      expect(hrt_reach_update(session, &nan, &command), HRT_ERROR_OUT_OF_RANGE);
      expect(hrt_reach_update(session, &both, &command), HRT_ERROR_OUT_OF_RANGE);
      expect(hrt_reach_update(session, &small, &command), HRT_ERROR_STRUCT_SIZE);
      expect(hrt_reach_update(session, nullptr, &command), HRT_ERROR_NULL_ARGUMENT);
      expect(hrt_reach_update(session, &direction, nullptr), HRT_ERROR_NULL_ARGUMENT);
      expect(hrt_reach_update({42}, &direction, &command), HRT_ERROR_INVALID_HANDLE);
    }
    const hrt_sample hour_late = direction_sample(3'600'000'000'000, 0.0);
    expect(hrt_reach_update(session, &hour_late, &command), HRT_OK);
    expect(hrt_reach_end(session, nullptr), HRT_ERROR_NULL_ARGUMENT);
    expect(hrt_reach_end(session, &summary), HRT_OK);

    std::uint32_t state = 0;
    expect(hrt_session_get(session, nullptr, &state), HRT_OK);
    auto configured = output<hrt_session_config>();
    expect(hrt_session_get(session, &configured, nullptr), HRT_OK);
    expect(hrt_session_get({42}, nullptr, nullptr), HRT_ERROR_INVALID_HANDLE);
    expect(hrt_reach_retarget(session, reach.real_target, reach.virtual_target), HRT_ERROR_WRONG_STATE);
    expect(hrt_reach_cancel(session), HRT_ERROR_WRONG_STATE);
    hrt_reach_config at_finger = reach;
    at_finger.flags = HRT_REACH_START_AT_FINGER;
    for (const hrt_reach_config* config : {&reach, static_cast<const hrt_reach_config*>(&at_finger)}) {
      expect(hrt_reach_begin(session, config), HRT_OK);
      for (int i = 0; i < 300; ++i) {
        const hrt_sample position =
            position_sample(std::int64_t{i} * 10'000'000, 0.0, -0.05 + 0.0004 * std::max(0, i - 50));
        expect(hrt_reach_update(session, &position, &command), HRT_OK);
        expect(hrt_reach_retarget(session, reach.real_target, reach.virtual_target), HRT_OK);
      }
      expect(hrt_reach_retarget(session, reach.virtual_target, reach.virtual_target), HRT_ERROR_OUT_OF_RANGE);
      expect(hrt_reach_retarget(session, {0}, reach.virtual_target), HRT_ERROR_INVALID_HANDLE);
      auto contact = output<hrt_contact>();
      contact.flags = HRT_CONTACT_PLATE_POSITION;
      contact.position_m[2] = -1.0;
      expect(hrt_reach_touched(session, &contact), HRT_ERROR_OUT_OF_RANGE);
      contact.position_m[2] = -0.05;
      expect(hrt_reach_touched(session, &contact), HRT_OK);
      expect(hrt_reach_touched(session, nullptr), HRT_ERROR_WRONG_STATE);
      expect(hrt_reach_end(session, &summary), HRT_OK);
    }
    return wrong;
  }

  /// Updates a calibration that was begun before: rests, slides and errors. Returns the number of unexpected results.
  int set_up() const {
    int wrong = 0;
    const auto expect = [&](hrt_result result, hrt_result expected) { wrong += result != expected; };
    auto step = output<hrt_setup_step>();
    const hrt_sample early = position_sample(-1, 0.0, 0.0), direction = direction_sample(0, 0.0);
    std::uint32_t instructions = 0;
    for (std::int64_t i = 0; i < 6000; ++i) {
      // Moves between the start and a position 80 mm ahead of it, with rests of 1 s.
      const double phase = std::fmod(static_cast<double>(i) / 100.0, 4.0);
      const double share = phase < 1.0 ? 0.0 : phase < 2.0 ? phase - 1.0 : phase < 3.0 ? 1.0 : 4.0 - phase;
      const hrt_sample sample = position_sample(i * 10'000'000, 0.0, -0.05 + 0.08 * share);
      expect(hrt_setup_update(session, &sample, &step), HRT_OK);
      instructions |= 1u << step.instruction;
    }
    expect(hrt_setup_update(session, &early, &step), HRT_ERROR_TIME_REVERSED);
    expect(hrt_setup_update(session, &direction, &step), HRT_ERROR_OUT_OF_RANGE);
    expect(hrt_setup_update(session, nullptr, &step), HRT_ERROR_NULL_ARGUMENT);
    return wrong + (step.done < 5) + ((instructions & 1u << HRT_STEP_SLIDE) == 0);
  }

  hrt_reach_config reach;
};

// Runs the body on a new thread, which has not called the library before.
void expect_neither_memory_nor_locks(auto&& body) {
  int wrong = -1;
  std::thread([&] {
    allocations = locks = 0;
    watching = true;
    wrong = body();
    watching = false;
  }).join();
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(allocations, 0);
  EXPECT_EQ(locks, 0);
}

TEST_F(RealTimeTest, AllocatesNothingAndTakesNoLock) {
  pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
  watching = true;
  const hrt_target allocated = add(HRT_TARGET_REAL, 0.0);
  watching = false;
  ASSERT_GE(allocations, 1) << "the test does not see allocations";
  ASSERT_OK(hrt_target_remove(session, allocated));
  watching = true;
  pthread_mutex_lock(&mutex);
  watching = false;
  pthread_mutex_unlock(&mutex);
  ASSERT_EQ(locks, 1) << "the test does not see locks";

  expect_neither_memory_nor_locks([&] { return call_everything(); });
  ASSERT_OK(hrt_setup_begin(session, HRT_SETUP_CALIBRATION, nullptr));
  expect_neither_memory_nor_locks([&] { return set_up(); });
  ASSERT_OK(hrt_setup_cancel(session));
}

// After this call, the kernel terminates this process at any system call of this thread except exit_group (_exit()).
bool forbid_system_calls() {
  sock_filter filter[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_exit_group, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
  };
  const sock_fprog program{.len = sizeof filter / sizeof *filter, .filter = filter};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

// Returns the status of a child that runs the body without system calls, except in threads that `prepare` starts.
template <class Prepare, class Body>
int status_without_system_calls(Prepare&& prepare, Body&& body) {
  const pid_t child = fork();
  if (child == 0) {
    prepare();
    if (!forbid_system_calls()) _exit(99);
    _exit(body());
  }
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  return status;
}

void expect_success(int status) {
  ASSERT_FALSE(WIFSIGNALED(status)) << "ended by signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST_F(RealTimeTest, MakesNoSystemCall) {
  const int guarded = status_without_system_calls([] {}, [] { return getppid() > 0 ? 0 : 1; });
  ASSERT_TRUE(WIFSIGNALED(guarded) && WTERMSIG(guarded) == SIGSYS) << "the test does not see system calls";

  expect_success(status_without_system_calls(
      [&] {
        if (hrt_setup_begin(session, HRT_SETUP_CALIBRATION, nullptr) != HRT_OK) _exit(98);
      },
      [&] { return set_up(); }));
  expect_success(status_without_system_calls([] {}, [&] { return call_everything(); }));
}

TEST_F(RealTimeTest, MakesNoSystemCallWhileRecorded) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("hrt_realtime" + std::to_string(getpid()) + ".csv");
  const int status = status_without_system_calls(
      [&] {
        if (hrt_recording_start(session, path.c_str()) != HRT_OK) _exit(98);
      },
      [&] {
        int wrong = 0;
        for (int i = 0; i < 50; ++i) wrong += call_everything();
        auto recorded = output<hrt_recording_status>();
        wrong += hrt_recording_get_status(session, &recorded) != HRT_OK || recorded.rows_lost == 0;
        return wrong;
      });
  std::filesystem::remove(path);
  expect_success(status);
}

struct OpenPlate {
  OpenPlate() {
    if (hrt_plate_open(("serial:" + device.device()).c_str(), nullptr, &plate) != HRT_OK) return;
    plate::eventually([&] {
      auto report = output<hrt_plate_report>();
      return hrt_plate_get(plate, &report) == HRT_OK && report.state == HRT_PLATE_STATE_READY;
    });
  }
  ~OpenPlate() { EXPECT_OK(hrt_plate_close(plate)); }
  OpenPlate(const OpenPlate&) = delete;
  OpenPlate& operator=(const OpenPlate&) = delete;

  int call_everything() const {
    int wrong = 0;
    const auto expect = [&](hrt_result result, hrt_result expected) { wrong += result != expected; };
    auto report = output<hrt_plate_report>();
    for (int i = 0; i < 1000; ++i) {
      expect(hrt_plate_set(plate, 0.1 * i), HRT_OK);
      expect(hrt_plate_get(plate, &report), HRT_OK);
      expect(hrt_plate_stop(plate), HRT_OK);
      expect(hrt_plate_set(plate, std::nan("")), HRT_ERROR_OUT_OF_RANGE);
      expect(hrt_plate_get(plate, nullptr), HRT_ERROR_NULL_ARGUMENT);
      expect(hrt_plate_stop({42}), HRT_ERROR_INVALID_HANDLE);
    }
    return wrong + (report.state != HRT_PLATE_STATE_READY);
  }

  plate::PtyPlate device;
  hrt_plate plate{};
};

TEST(PlateRealTime, AllocatesNothingAndTakesNoLock) {
  const OpenPlate open;
  expect_neither_memory_nor_locks([&] { return open.call_everything(); });
}

TEST(PlateRealTime, MakesNoSystemCall) {
  const OpenPlate* open = nullptr;
  expect_success(status_without_system_calls([&] { open = new OpenPlate; }, [&] { return open->call_everything(); }));
}

}  // namespace
}  // namespace hrt::test
