// Two threads: each with its own session, or both with one session, which is an error (HRT_ERROR_BUSY).
#include <atomic>
#include <thread>

#include "core/paper_simulation/participant.h"
#include "tests/plugin/fixture.h"

namespace hrt::test {
namespace {

using ThreadTest = SessionTest;

TEST_F(ThreadTest, SecondThreadGetsBusyAndNothingIsCorrupted) {
  begin_reach();
  std::atomic<int> ready{0};
  std::atomic<long> taken{0}, refused{0}, other{0};
  const auto hammer = [&] {
    ++ready;
    while (ready < 2) {
    }
    for (int i = 0; i < 100'000 || (refused == 0 && i < 50'000'000); ++i) {
      const hrt_sample sample = direction_sample(0, 1.0);
      auto command = output<hrt_command>();
      const hrt_result result = hrt_reach_update(session, &sample, &command);
      ++(result == HRT_OK ? taken : result == HRT_ERROR_BUSY ? refused : other);
    }
  };
  std::thread a(hammer), b(hammer);
  a.join();
  b.join();
  EXPECT_GT(refused, 0);
  EXPECT_EQ(other, 0);
  EXPECT_EQ(end().counts.samples, taken);
}

TEST(Threads, SessionsAreIndependent) {
  const auto run = [](double& last_deg) {
    const hrt_session_config config = session_config();
    for (int round = 0; round < 200; ++round) {
      hrt_session session{};
      ASSERT_OK(hrt_session_create(HRT_VERSION, &config, &session));
      const hrt_target_config real_config = target_config(HRT_TARGET_REAL, -5.0, "real");
      const hrt_target_config virtual_config = target_config(HRT_TARGET_VIRTUAL, 5.0, "virtual");
      hrt_reach_config reach = hrt_reach_config_init();
      ASSERT_OK(hrt_target_add(session, &real_config, &reach.real_target));
      ASSERT_OK(hrt_target_add(session, &virtual_config, &reach.virtual_target));
      ASSERT_OK(hrt_reach_begin(session, &reach));
      SimulatedParticipant participant({}, 5.0);
      for (int step = 0; step < 30; ++step) {
        const hrt_sample sample = direction_sample(step * step_ns, participant.finger_direction_deg());
        auto command = output<hrt_command>();
        ASSERT_OK(hrt_reach_update(session, &sample, &command));
        participant.step(command.plate_orientation_deg, 0.0);
        last_deg = command.plate_orientation_deg;
      }
      ASSERT_OK(hrt_session_destroy(session));
    }
  };
  double alone = 0.0, first = 0.0, second = 1.0;
  run(alone);
  std::thread a(run, std::ref(first)), b(run, std::ref(second));
  a.join();
  b.join();
  EXPECT_EQ(first, alone);
  EXPECT_EQ(second, alone);
}

}  // namespace
}  // namespace hrt::test
