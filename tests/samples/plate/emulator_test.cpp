// Tests of the firmware's ELF in simavr, in simulated time: pulses, EEPROM, watchdog and sensor, which main.c adds to
// the behaviour that firmware_test.cpp tests. The firmware has not run on a real board or with a real servo.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/samples/plate/board_fixture.h"
#include "tests/samples/plate/board_with_servo.h"
#include "tests/samples/plate/damage.h"
#include "tests/samples/text.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

class Firmware : public BoardFixture<BoardWithServo> {
 protected:
  explicit Firmware(const Settings& settings = commissioned())
      : BoardFixture(ServoTraits{}, 40.0, eeprom_with(settings)) {
    greet();
  }
  void TearDown() override {
    for (const std::string& error : board_.simulator_errors()) ADD_FAILURE() << error;
  }

  void greet() {
    board_.run_for(50ms);
    board_.receive_line("HELLO 2");
    board_.run_for(20ms);
  }
  double width_us() const { return board_.pulses().back().width_us(); }
};

struct FirmwareWithoutSensor : Firmware {
  FirmwareWithoutSensor() : Firmware(settings_default()) {}
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

// Expected: a pulse every 20 ms, of 1500 us at 0 and 2000 us more per 180 degrees.
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
  const std::string echo = with_number("", sequence_);
  bool is_echoed = false;
  while (!is_echoed && board_.now() < sent + 100ms) {
    board_.run_for(100us);
    for (const std::string& line : board_.take_lines()) is_echoed = is_echoed || line.ends_with(echo);
  }
  // The two lines have 16 and 22 bytes of 0.09 ms; the board sends its answer in the next tick, within a millisecond.
  EXPECT_LT(board_.now() - sent, 6ms);
  std::printf("from a line to its echo: %.2f ms\n", static_cast<double>((board_.now() - sent).count()) * 1e-6);
}

// The pulse is constant from 300 ms after the last byte on, at 20 phases of the pulse period.
TEST_F(Firmware, StopsWithin300MillisecondsOfSilence) {
  std::chrono::nanoseconds slowest{};
  for (int phase = 0; phase < 20; ++phase) {
    BoardWithServo board({}, 40.0);
    board.run_for(30ms + phase * 1ms);
    board.receive_line("HELLO 2");
    board.receive_line("CONF speed 100");  // 130 degrees take 1.3 s
    board.receive_line(motion_body(-90.0, 3));
    while (board.is_sending()) board.run_for(100us);
    const auto silent = board.now();
    board.run_for(700ms);
    std::chrono::nanoseconds last_change{};
    const auto& pulses = board.pulses();
    for (std::size_t i = 1; i < pulses.size(); ++i)
      if (std::abs(pulses[i].width_us() - pulses[i - 1].width_us()) > 0.6) last_change = pulses[i].start;
    EXPECT_LE(last_change - silent, 300ms) << phase;
    EXPECT_GT(last_change - silent, 200ms) << phase;  // the pulse moved until then
    slowest = std::max(slowest, last_change - silent);
    const auto lines = board.take_lines();
    EXPECT_EQ(std::count(lines.begin(), lines.end(), "STOPPED heartbeat"), 1) << phase;
  }
  std::printf("last change of a pulse after the last byte: %.1f ms\n", static_cast<double>(slowest.count()) * 1e-6);
}

// The divider at A1 shows the loss. With pulses, the servo would turn at full speed when the supply returns.
TEST_F(Firmware, ALostSupplyEndsThePulses) {
  set(-80.0, 350ms);
  const double orientation_deg = board_.servo.plate_deg();
  board_.servo.supply = 0.0;
  run_with_beats(300ms);
  board_.servo.supply = 1.0;
  const std::size_t pulses = board_.pulses().size();
  set(-80.0, 500ms);
  EXPECT_EQ(board_.pulses().size(), pulses);
  EXPECT_NEAR(board_.servo.plate_deg(), orientation_deg, 3.0);  // 2 degrees to brake
  EXPECT_TRUE(has_sent("STOPPED supply"));
}

TEST_F(Firmware, DamagedLinesMoveNothing) {
  set(0.0, 600ms);
  std::mt19937 random(7);
  const std::size_t before = board_.pulses().size();
  const double held_us = width_us();
  for (int i = 0; i < 500; ++i) {
    for (int k = 0; k < 10; ++k) {
      const double angle_deg = static_cast<double>(random() % 18001) / 100.0 - 90.0;
      board_.send(damaged(encode_line(motion_body(angle_deg, sequence_)), random));
    }
    beat();
    while (board_.is_sending()) board_.run_for(1ms);
    board_.run_for(10ms);
    const auto lines = board_.take_lines();
    ASSERT_TRUE(std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
      return line.starts_with("AT ") && line.ends_with(with_number("", sequence_));
    })) << i;
  }
  for (std::size_t i = before; i < board_.pulses().size(); ++i)
    EXPECT_NEAR(board_.pulses()[i].width_us(), held_us, 0.45);  // the timer's step is 0.5 us
  board_.receive_line("TEST");
  board_.run_for(30ms);
  const auto lines = board_.take_lines();
  EXPECT_EQ(
      std::count(lines.begin(), lines.end(), "TEST loop 1") + std::count(lines.begin(), lines.end(), "TEST loop 2"), 1);
}

TEST_F(Firmware, DeclaresABrownOutAtFourPointThreeVolts) { EXPECT_EQ(board_.extended_fuse(), 0xFC); }

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
  EXPECT_NE(std::find(lines.begin(), lines.end(), "ERROR greeting"), lines.end());
  const double orientation_deg = board_.servo.plate_deg();
  greet();
  set(0.0, 60ms);
  EXPECT_NEAR((board_.pulses().at(pulses).width_us() - 1500.0) * 0.09, orientation_deg, 1.0);
}

TEST_F(Firmware, EmergencyStopCompletesTheLastPulse) {
  set(90.0, 100ms);
  board_.open_emergency_stop(true);
  const auto opened = board_.now();
  board_.run_for(500ms);
  EXPECT_LT(board_.pulses().back().start - opened, 25ms);
  EXPECT_GE(width_us(), 500.0);
  EXPECT_TRUE(has_sent("STOPPED emergency"));
}

TEST_F(FirmwareWithoutSensor, IsHomedByOnePulseInEight) {
  set(-40.0, 500ms);
  EXPECT_TRUE(has_sent("STOPPED unhomed"));
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

// The watchdog ends the pulses after a complete pulse, and resets the board once.
TEST_F(Firmware, AMainLoopThatHangsLosesItsPulsesAndIsReset) {
  set(90.0, 100ms);
  board_.take_lines();
  board_.hang();
  const auto hung = board_.now();
  board_.run_for(500ms);
  EXPECT_LT(board_.pulses().back().start - hung, 170ms);
  EXPECT_GE(width_us(), 500.0);
  EXPECT_TRUE(has_sent("BOOT"));
  board_.run_for(500ms);
  EXPECT_FALSE(has_sent("BOOT"));
}

TEST_F(Firmware, KeepsItsSettingsInEeprom) {
  for (const char* body : {"CONF zero 1510", "CONF speed 150", "CONF serial 42"}) {
    board_.receive_line(body);
    board_.run_for(10ms);
  }
  EXPECT_TRUE(has_sent("CONF zero 1510.00"));
  board_.receive_line("SAVE");
  board_.run_for(2000ms);
  EXPECT_TRUE(has_sent("SAVED"));

  auto memory = board_.eeprom();
  const auto greeting_with = [](const std::vector<std::uint8_t>& eeprom) {
    EmulatedBoard board(eeprom);
    board.run_for(20ms);
    board.receive_line("HELLO 2");
    board.receive_line("INFO");
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
  memory[128 + 20] ^= 1;  // both copies are damaged
  EXPECT_EQ(greeting_with(memory), "PLATE 2 -45.00 45.00 60.00 30.00 assumed;INFO 1.1.0 000000;");
}

}  // namespace
}  // namespace hrt::plate
