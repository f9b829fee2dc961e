// samples/plate/guide/say beside the firmware's own ELF on an emulated board.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "tests/plugin/plate/pty_device.h"
#include "tests/samples/plate/emulated_board.h"
#include "tests/samples/process.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

// 10 degrees are 1500 + 10 * 2000 / 180 us.
TEST(Say, TurnsTheEmulatedPlate) {
  PtyDevice<EmulatedBoard> board;
  int ends[2];
  ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
  const Process say({HRT_SAY, board.device()}, {}, -1, ends[0]);
  close(ends[0]);
  // The next line is typed when the last is answered: the board is slower than real time on a busy machine.
  const auto answers = [&](const std::string& typed, const std::string& answer) {
    EXPECT_EQ(write(ends[1], typed.data(), typed.size()), static_cast<ssize_t>(typed.size()));
    const auto give_up = std::chrono::steady_clock::now() + 30s;
    while (say.out().find(answer) == std::string::npos && std::chrono::steady_clock::now() < give_up)
      std::this_thread::sleep_for(10ms);
    EXPECT_TRUE(has(say.out(), answer)) << " is missing in\n";
  };
  answers("", "PLATE 2 ");
  answers("SET 10\n", "AT +010.00\n");
  answers("TEST\n", "TEST end\n");
  answers("CONF zero 1505\n", "CONF zero 1505");
  answers("STOP\n", "STOPPED host\n");
  answers("SAVE\n", "SAVED\n");
  close(ends[1]);
  const Outcome outcome = say.wait();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "TEST emergency closed\n"));
  const std::vector<Pulse> pulses = board.with(&EmulatedBoard::pulses);
  ASSERT_FALSE(pulses.empty());
  EXPECT_NEAR(pulses.front().width_us(), 1500.0, 1.0);
  EXPECT_NEAR(pulses.back().width_us(), 1505.0 + 10.0 * 2000.0 / 180.0, 1.0);
}

}  // namespace
}  // namespace hrt::plate
