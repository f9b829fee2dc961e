// Ten million updates with random dropouts, gaps and errors, in reach after reach: memory stays flat,
// commands finite and within the plate's bound.
#if defined(__linux__)
#include <unistd.h>
#endif

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>

#include "fixture.h"

namespace hrt::test {
namespace {

/// Of this process; 0 where only the library's own requests are counted.
long resident_bytes() {
#if defined(__linux__)
  std::ifstream statm("/proc/self/statm");
  long size = 0, resident = 0;
  statm >> size >> resident;
  return resident * sysconf(_SC_PAGESIZE);
#else
  return 0;
#endif
}

/// Numbers that look random.
class Random {
 public:
  std::uint64_t next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return state_ >> 33;
  }
  /// In [-1, 1).
  double symmetric() { return static_cast<double>(next()) / double{1u << 30} - 1.0; }
  bool one_in(std::uint64_t n) { return next() % n == 0; }

 private:
  std::uint64_t state_ = 7;
};

std::atomic<long> blocks_taken{0};

class SoakTest : public SessionTest {
 protected:
  void SetUp() override {
    hrt_host host = hrt_host_init();
    host.allocate = [](void*, std::size_t size, std::size_t) {
      ++blocks_taken;
      return std::malloc(size);
    };
    host.release = [](void*, void* memory) { std::free(memory); };
    ASSERT_OK(hrt_set_host(&host));
    SessionTest::SetUp();
  }
  void TearDown() override {
    SessionTest::TearDown();
    EXPECT_OK(hrt_set_host(nullptr));
  }
};

TEST_F(SoakTest, MemoryStaysFlatAndCommandsFinite) {
  hrt_session_config config = session_config();
  config.plate_max_speed_deg_s = 400.0;
  create(config);
  const hrt_target real = add(HRT_TARGET_REAL, -5.0), virtual_target = add(HRT_TARGET_VIRTUAL, 5.0);
  hrt_reach_config reach = hrt_reach_config_init();
  reach.real_target = real;
  reach.virtual_target = virtual_target;

  Random random;
  std::int64_t time_ns = 0;
  long wrong = 0, refused = 0, bytes = 0, taken = 0;
  auto command = output<hrt_command>();
  auto summary = output<hrt_reach_summary>();
  for (long i = 0; i < HRT_SOAK_UPDATES; ++i) {
    const long in_reach = i % 300;
    if (in_reach == 0) {
      ASSERT_OK(hrt_reach_begin(session, &reach));
    }
    if (i == HRT_SOAK_UPDATES / 10) {
      bytes = resident_bytes();
      taken = blocks_taken;
    }
    time_ns +=
        random.one_in(1000) ? 3'600'000'000'000 : static_cast<std::int64_t>(random.next() % 22'000'000);
    // A second's flight of the clock backwards, one sample in a hundred; not a number, another.
    hrt_sample sample = (i / 300) % 2 == 0 ? direction_sample(time_ns, 20.0 * random.symmetric())
                                           : position_sample(time_ns, 0.001 * random.symmetric(),
                                                             -0.05 + 0.0003 * static_cast<double>(in_reach));
    if (random.one_in(10)) sample.flags = 0;
    if (random.one_in(100)) sample.time_ns -= 1'000'000'000;
    if (random.one_in(100)) sample.finger_direction_deg = sample.finger_position_m[0] = std::nan("");
    if (hrt_reach_update(session, &sample, &command) != HRT_OK) {
      ++refused;
    } else {
      wrong += !(std::abs(command.plate_orientation_deg) < 1e6) ||
               !(std::abs(command.perceived_direction_deg) < 1e6) ||
               !(command.tactile_weight > 0.0 && command.tactile_weight < 0.5);
    }
    if (in_reach == 299) {
      ASSERT_OK(hrt_reach_end(session, &summary));
      const hrt_session_config carried = config_of(session);
      ASSERT_OK(hrt_session_set(session, &carried));
      time_ns = 0;
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(refused, HRT_SOAK_UPDATES / 100);
  EXPECT_LT(refused, HRT_SOAK_UPDATES / 10);
  EXPECT_EQ(blocks_taken, taken);
  EXPECT_LT(resident_bytes() - bytes, 1'000'000);
}

}  // namespace
}  // namespace hrt::test
