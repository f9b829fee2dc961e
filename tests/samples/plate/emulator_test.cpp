// Tests of the firmware's ELF in simavr, in simulated time: pulses, EEPROM, watchdog and sensor, which the board adds
// to the behaviour that firmware_test.cpp tests. No board and no servo has run it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/samples/plate/board_with_servo.h"
#include "tests/samples/plate/damage.h"
#include "tests/samples/text.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

bool contains(const std::vector<std::string>& lines, const std::string& line) {
  return std::find(lines.begin(), lines.end(), line) != lines.end();
}

class Firmware : public testing::Test {
 protected:
  explicit Firmware(const Settings& settings = commissioned()) : board_({}, 40.0, eeprom_with(settings)) { greet(); }
  void TearDown() override {
    for (const std::string& complaint : board_.complaints()) ADD_FAILURE() << complaint;
  }

  void greet() {
    board_.run_for(50ms);
    board_.say("HELLO 2");
    board_.run_for(20ms);
  }
  // Sends a command, then heartbeats for this time.
  void set(double orientation_deg, std::chrono::milliseconds time = 0ms, const char* word = "SET") {
    board_.say(set_body(orientation_deg, ++sequence_, word));
    run_with_beats(time);
  }
  void beat() { board_.say(beat_body("BEAT", ++sequence_)); }
  void run_with_beats(std::chrono::milliseconds time) {
    for (; time > 0ms; time -= 50ms) {
      beat();
      board_.run_for(std::min<std::chrono::milliseconds>(time, 50ms));
    }
  }
  double width_us() const { return board_.pulses().back().width_us(); }

  BoardWithServo board_;
  std::uint16_t sequence_ = 0;
};

struct BlindFirmware : Firmware {
  BlindFirmware() : Firmware(settings_default()) {}
};

TEST_F(Firmware, SendsBootAndNoPulseBeforeACommand) {
  run_with_beats(1000ms);
  const auto lines = board_.take_lines();
  EXPECT_EQ(lines.front(), "BOOT");
  EXPECT_EQ(lines[1], "PLATE 2 -90.00 90.00 200.00 30.00 measured");
  EXPECT_TRUE(board_.pulses().empty());
  EXPECT_EQ(board_.servo.plate_deg(), 40.0);
}

TEST_F(Firmware, StartsFromTheMeasuredPosition) {
  set(80.0, 60ms);
  EXPECT_NEAR((board_.pulses().front().width_us() - 1500.0) * 0.09, 40.0, 1.0);
  run_with_beats(600ms);
  EXPECT_NEAR(board_.servo.plate_deg(), 80.0, 0.2);
  const auto report = parse_plate_message(board_.take_lines().back());
  EXPECT_NEAR(*std::get<PlateReport>(*report).orientation_deg, 80.0, 0.5);
}

// Expected: pulses of 1500 us at 0 and 2000 us per 180 degrees, from -90 to 90 degrees in steps of 0.5, and a frame of
// 20 ms.
TEST_F(Firmware, PulsesAreWithinAMicrosecondOverTheWholeRange) {
  set(-90.0, 900ms);
  const std::size_t first = board_.pulses().size();
  double worst_us = 0.0;
  for (double angle_deg = -90.0; angle_deg <= 90.0; angle_deg += 0.5) {
    set(angle_deg);
    board_.run_for(45ms);
    worst_us = std::max(worst_us, std::abs(width_us() - (1500.0 + angle_deg * 2000.0 / 180.0)));
  }
  EXPECT_LT(worst_us, 1.0);
  std::printf("worst deviation of a pulse: %.3f us\n", worst_us);
  const auto& pulses = board_.pulses();
  for (std::size_t i = first; i < pulses.size(); ++i)
    EXPECT_NEAR(static_cast<double>((pulses[i].start - pulses[i - 1].start).count()), 20e6, 1e3) << i;
}

TEST_F(Firmware, EchoesSequenceNumbersWithinMilliseconds) {
  board_.run_for(30ms);
  board_.take_lines();
  beat();
  const auto sent = board_.now();
  const std::string echo = beat_body("", sequence_);
  bool has_come = false;
  while (!has_come && board_.now() < sent + 100ms) {
    board_.run_for(100us);
    for (const std::string& line : board_.take_lines()) has_come = has_come || line.ends_with(echo);
  }
  // The two lines have 11 and 22 bytes of 0.09 ms; the next tick follows within a millisecond.
  EXPECT_LT(board_.now() - sent, 6ms);
  std::printf("from a line to its echo: %.2f ms\n", static_cast<double>((board_.now() - sent).count()) * 1e-6);
}

// The pulse is constant from 300 ms after the last byte on, at every phase of the frame.
TEST_F(Firmware, StopsWithin300MillisecondsOfSilence) {
  std::chrono::nanoseconds slowest{};
  for (int phase = 0; phase < 20; ++phase) {
    BoardWithServo board({}, 40.0);
    board.run_for(30ms + phase * 1ms);
    board.say("HELLO 2");
    board.say("CONF speed 100");  // 130 degrees take 1.3 s
    board.say(set_body(-90.0, 3));
    while (board.is_sending()) board.run_for(100us);
    const auto silent = board.now();
    board.take_lines();
    board.run_for(700ms);
    std::chrono::nanoseconds last_change{};
    const auto& pulses = board.pulses();
    for (std::size_t i = 1; i < pulses.size(); ++i)
      if (std::abs(pulses[i].width_us() - pulses[i - 1].width_us()) > 0.6) last_change = pulses[i].start;
    EXPECT_LE(last_change - silent, 300ms) << phase;
    EXPECT_GT(last_change - silent, 200ms) << phase;  // it moved until then
    slowest = std::max(slowest, last_change - silent);
    EXPECT_TRUE(contains(board.take_lines(), "STOPPED heartbeat"));
  }
  std::printf("last change of a pulse after the last byte: %.1f ms\n", static_cast<double>(slowest.count()) * 1e-6);
}

// A servo of 60 degrees a second, with a motion of 200, at a STOP, a second HELLO, or silence.
TEST_F(Firmware, StopsASlowServoAtItsPosition) {
  for (const char* stop : {"STOP 00002", "HELLO 2", ""}) {
    BoardWithServo board({.speed_deg_s = 60.0}, -60.0);
    board.run_for(30ms);
    board.say("HELLO 2");
    board.say(set_body(80.0, 1));
    board.run_for(250ms);
    board.say(beat_body("BEAT", 2));
    board.run_for(250ms);
    if (*stop != 0) board.say(stop);
    board.run_for(*stop != 0 ? 5ms : 50ms);
    const double stopped_deg = board.servo.plate_deg();
    EXPECT_GT(stopped_deg, -50.0);
    board.run_for(1500ms);
    EXPECT_NEAR(board.servo.plate_deg(), stopped_deg, 2.0) << stop;
  }
}

// The divider at A1 shows the loss. With pulses, the servo would turn at full speed when the supply returns.
TEST_F(Firmware, ALostSupplyEndsThePulses) {
  set(-80.0, 350ms);
  const double place_deg = board_.servo.plate_deg();
  board_.servo.supply = 0.0;
  run_with_beats(300ms);
  board_.servo.supply = 1.0;
  const std::size_t pulses = board_.pulses().size();
  set(-80.0, 500ms);
  EXPECT_EQ(board_.pulses().size(), pulses);
  EXPECT_NEAR(board_.servo.plate_deg(), place_deg, 3.0);  // 2 degrees to brake
  EXPECT_TRUE(contains(board_.take_lines(), "STOPPED supply"));
}

TEST_F(Firmware, RefusesASecondHost) {
  run_with_beats(50ms);
  board_.run_for(300ms);
  board_.say("HELLO 2 00042");
  board_.run_for(10ms);
  board_.take_lines();
  set(-80.0);
  greet();
  EXPECT_TRUE(contains(board_.take_lines(), "ERROR session"));
  EXPECT_TRUE(board_.pulses().empty());
}

// 5 thousand damaged lines with good ones in between: the pulse is constant, each good line is executed, and the main
// loop takes at most 2 ms.
TEST_F(Firmware, DamagedLinesMoveNothing) {
  set(0.0, 600ms);
  std::mt19937 random(7);
  const std::size_t before = board_.pulses().size();
  const double held_us = width_us();
  for (int i = 0; i < 500; ++i) {
    for (int k = 0; k < 10; ++k) {
      const double angle_deg = static_cast<double>(random() % 18001) / 100.0 - 90.0;
      board_.send(damaged(encode_line(set_body(angle_deg, sequence_)), random));
    }
    beat();
    while (board_.is_sending()) board_.run_for(1ms);
    board_.run_for(10ms);
    const auto lines = board_.take_lines();
    ASSERT_TRUE(std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
      return line.starts_with("AT ") && line.ends_with(beat_body("", sequence_));
    })) << i;
  }
  for (std::size_t i = before; i < board_.pulses().size(); ++i)
    EXPECT_NEAR(board_.pulses()[i].width_us(), held_us, 0.45);  // a step is 0.5
  board_.say("TEST");
  board_.run_for(30ms);
  const auto lines = board_.take_lines();
  EXPECT_TRUE(contains(lines, "TEST loop 1") || contains(lines, "TEST loop 2"));
}

TEST_F(Firmware, DeclaresABrownOutAtFourPointThreeVolts) { EXPECT_EQ(board_.extended_fuse(), 0xFC); }

// The host continues to send commands after a reset of the board.
TEST_F(Firmware, AResetEndsThePulsesUntilTheNextGreeting) {
  set(90.0, 150ms);
  board_.take_lines();
  board_.reset();
  const std::size_t pulses = board_.pulses().size();
  for (int i = 0; i < 10; ++i) {
    set(90.0);
    board_.run_for(50ms);
  }
  EXPECT_EQ(board_.pulses().size(), pulses);
  const auto lines = board_.take_lines();
  EXPECT_EQ(lines.front(), "BOOT");
  EXPECT_TRUE(contains(lines, "ERROR greeting"));
  const double place_deg = board_.servo.plate_deg();
  greet();
  set(0.0, 60ms);
  EXPECT_NEAR((board_.pulses().at(pulses).width_us() - 1500.0) * 0.09, place_deg, 1.0);
}

TEST_F(Firmware, EmergencyStopCompletesTheLastPulse) {
  set(90.0, 100ms);
  board_.open_emergency_stop(true);
  const auto opened = board_.now();
  board_.run_for(500ms);
  EXPECT_LT(board_.pulses().back().start - opened, 25ms);
  EXPECT_GE(width_us(), 500.0);
  EXPECT_TRUE(contains(board_.take_lines(), "STOPPED emergency"));
}

// Without a sensor, the compare unit omits the pulses of seven in eight frames for 8 s.
TEST_F(BlindFirmware, IsHomedByOnePulseInEight) {
  set(-40.0, 500ms);
  EXPECT_TRUE(contains(board_.take_lines(), "STOPPED unhomed"));
  EXPECT_TRUE(board_.pulses().empty());
  set(-40.0, 7900ms, "HOME");
  EXPECT_TRUE(has(board_.take_lines().back(), "AT unknown"));
  EXPECT_NEAR(board_.servo.plate_deg(), -40.0, 0.2);
  run_with_beats(500ms);
  EXPECT_TRUE(has(board_.take_lines().back(), "AT -040.00"));
  const auto& pulses = board_.pulses();
  for (std::size_t i = 1; i < pulses.size(); ++i) {
    const auto apart = pulses[i].start - pulses[i - 1].start;
    EXPECT_NEAR(static_cast<double>(apart.count()), i < 51 ? 160e6 : 20e6, 1e3) << i;
    EXPECT_NEAR(pulses[i].width_us(), 1500.0 - 40.0 * 2000.0 / 180.0, 1.0) << i;
  }
  EXPECT_GT(pulses.size(), 60U);
}

// The watchdog ends the pulses after a complete one, and resets the board, which then waits for a greeting.
TEST_F(Firmware, AMainLoopThatHangsLosesItsPulsesAndIsReset) {
  set(90.0, 100ms);
  board_.take_lines();
  board_.hang();
  const auto hung = board_.now();
  board_.run_for(500ms);
  EXPECT_LT(board_.pulses().back().start - hung, 170ms);
  EXPECT_GE(width_us(), 500.0);
  EXPECT_TRUE(contains(board_.take_lines(), "BOOT"));
  board_.run_for(500ms);
  EXPECT_FALSE(contains(board_.take_lines(), "BOOT"));  // once
}

TEST_F(Firmware, KeepsItsSettingsInEeprom) {
  for (const char* body : {"CONF zero 1510", "CONF speed 150", "CONF serial 42"}) {
    board_.say(body);
    board_.run_for(10ms);
  }
  EXPECT_TRUE(contains(board_.take_lines(), "CONF zero 1510.00"));
  board_.say("SAVE");
  board_.run_for(2000ms);
  EXPECT_TRUE(contains(board_.take_lines(), "SAVED"));

  auto memory = board_.eeprom();
  const auto greeting_with = [](const std::vector<std::uint8_t>& eeprom) {
    EmulatedBoard board(eeprom);
    board.run_for(20ms);
    board.say("HELLO 2");
    board.say("INFO");
    board.run_for(30ms);
    std::string text;
    for (const std::string& line : board.take_lines())
      if (line.starts_with("PLATE") || line.starts_with("INFO")) text += line + ";";
    return text;
  };
  // With 10 us more at 0, the longest pulse limits the orientation to 990 / 2000 * 180 degrees.
  const std::string kept = "PLATE 2 -90.00 89.10 150.00 30.00 measured;INFO 1.1.0 000042;";
  EXPECT_EQ(greeting_with(memory), kept);
  memory[20] ^= 1;  // one copy is damaged, as by a power failure while it is written
  EXPECT_EQ(greeting_with(memory), kept);
  memory[128 + 20] ^= 1;  // both are
  EXPECT_EQ(greeting_with(memory), "PLATE 2 -45.00 45.00 60.00 30.00 assumed;INFO 1.1.0 000000;");
}

}  // namespace
}  // namespace hrt::plate
