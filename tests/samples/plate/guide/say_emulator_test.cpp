// samples/plate/guide/say beside the firmware's own ELF on an emulated board.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/samples/plate/pty_board.h"
#include "tests/samples/process.h"

namespace hrt::plate {
namespace {

// 10 degrees are 1500 + 10 * 2000 / 180 us.
TEST(Say, TurnsTheEmulatedPlate) {
  PtyBoard board;
  const std::string typed = "SET 10\\nTEST\\nCONF zero 1505\\nSTOP\\nSAVE\\n";
  const Outcome outcome =
      Process({"/bin/sh", "-c", "(sleep 1; printf '" + typed + "'; sleep 2) | " HRT_SAY " " + board.device()},
              {})
          .wait();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* answer : {"PLATE 2 ", "TEST emergency closed\n", "CONF zero 1505", "STOPPED host\n",
                             "SAVED\n", "AT +010.00\n"}) {
    EXPECT_NE(outcome.out.find(answer), std::string::npos) << answer << "is missing in\n" << outcome.out;
  }
  const std::vector<Pulse> pulses = board.pulses();
  ASSERT_FALSE(pulses.empty());
  EXPECT_NEAR(pulses.front().width_us(), 1500.0, 1.0);
  EXPECT_NEAR(pulses.back().width_us(), 1505.0 + 10.0 * 2000.0 / 180.0, 1.0);
}

}  // namespace
}  // namespace hrt::plate
