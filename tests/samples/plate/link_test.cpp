// The host's side of the line against the firmware's ELF: in simulated time, and once over a pseudo-terminal
// in real time.
#include "plugin/src/plate/plate_link.h"

#include <gtest/gtest.h>

#include "plugin/src/plate/plate_failure.h"
#include "plugin/src/plate/serial_line.h"
#include "tests/samples/plate/board_line.h"
#include "tests/samples/plate/pty_board.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

TEST(PlateLink, GreetsTheFirmwareAndMeasuresTheLine) {
  EmulatedBoard board;
  PlateLink link(std::make_unique<BoardLine>(board));
  EXPECT_EQ(link.greeting().version, Version::two);
  EXPECT_EQ(link.info()->firmware, "1.0.0");
  ASSERT_TRUE(link.round_trip());
  // 3 ms of line, and a tick of the emulator's receiver.
  EXPECT_GT(*link.round_trip(), 3ms);
  EXPECT_LT(*link.round_trip(), 6ms);
  EXPECT_EQ(link.limits().latency, 20ms + *link.round_trip() / 2);
  EXPECT_EQ(link.refusals(), 0U);
}

TEST(PlateLink, GreetsThroughAPseudoTerminal) {
  PtyBoard board;
  PlateLink link(open_serial_line(board.device(), 115200), Start::quiet);
  EXPECT_EQ(link.info()->firmware, "1.0.0");
  EXPECT_GT(*link.round_trip(), 3ms);
  EXPECT_TRUE(board.pulses().empty());
}

TEST(PlateLink, TurnsTheServo) {
  EmulatedBoard board;
  PlateLink link(std::make_unique<BoardLine>(board));
  link.turn_to(-60.0);
  for (const auto end = link.now() + 1s; link.now() < end;) link.wait(10ms);
  EXPECT_EQ(link.orientation_deg(), -60.0);
  EXPECT_NEAR(board.pulses().back().width_us(), 1500.0 - 60.0 * 2000.0 / 180.0, 1.0);
  EXPECT_LE(link.limits().speed_deg_s, 300.0);
}

// In the middle of a turn: a brown-out, or another program opens the line.
TEST(PlateLink, NoticesAResetInMotion) {
  EmulatedBoard board;
  PlateLink link(std::make_unique<BoardLine>(board));
  link.turn_to(80.0);
  for (const auto end = link.now() + 100ms; link.now() < end;) link.wait(10ms);
  EXPECT_GT(*link.orientation_deg(), 5.0);
  EXPECT_LT(*link.orientation_deg(), 75.0);
  board.reset();
  const std::size_t pulses = board.pulses().size();
  std::string failure;
  try {
    for (const auto end = link.now() + 3s; link.now() < end;) link.wait(10ms);
  } catch (const PlateFailure& failed) {
    failure = failed.what();
  }
  EXPECT_EQ(failure, "has restarted: its supply or its line failed");
  EXPECT_EQ(board.pulses().size(), pulses);
}

TEST(PlateLink, AsksForSettings) {
  EmulatedBoard board;
  PlateLink link(std::make_unique<BoardLine>(board));
  double zero_us = 0.0;
  link.ask("CONF zero 1510", [&](const PlateMessage& message) {
    const auto* setting = std::get_if<PlateSetting>(&message);
    if (setting != nullptr && setting->name == "zero") zero_us = setting->value;
    return zero_us != 0.0;
  });
  EXPECT_EQ(zero_us, 1510.0);
}

}  // namespace
}  // namespace hrt::plate
