// The firmware's ELF in simavr: its pulses, its watchdog, and what it makes of a damaged line. Simulated
// time. No board and no servo has run it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "plugin/src/plate/plate_line.h"
#include "tests/samples/plate/damage.h"
#include "tests/samples/plate/emulated_board.h"
#include "tests/samples/plate/emulated_servo.h"
#include "tests/samples/text.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

class Firmware : public testing::Test {
 protected:
  explicit Firmware(const std::vector<std::uint8_t>& eeprom = {}) : board_(eeprom) {}

  void TearDown() override {
    for (const std::string& complaint : board_.complaints()) ADD_FAILURE() << complaint;
  }

  void greet() {
    board_.run_for(50ms);
    board_.say("HELLO 2");
    board_.run_for(20ms);
    board_.take_lines();
  }

  void set(double orientation_deg) { board_.say(set_body(orientation_deg, Version::two, ++sequence_)); }
  void beat() { board_.say(beat_body("BEAT", Version::two, ++sequence_)); }

  void run_with_beats(std::chrono::milliseconds time) {
    for (; time > 0ms; time -= 50ms) {
      beat();
      board_.run_for(std::min<std::chrono::milliseconds>(time, 50ms));
    }
  }

  // Past the first pulses, at 0.
  void start_at_zero() {
    greet();
    set(0.0);
    run_with_beats(600ms);
  }

  double width_us() const { return board_.pulses().back().width_us(); }

  static bool contains(const std::vector<std::string>& lines, const std::string& line) {
    return std::find(lines.begin(), lines.end(), line) != lines.end();
  }

  EmulatedBoard board_;
  std::uint16_t sequence_ = 0;
};

TEST_F(Firmware, AnnouncesItselfAndAnswersAGreeting) {
  board_.run_for(50ms);
  EXPECT_EQ(board_.take_lines(), std::vector<std::string>{"BOOT"});
  board_.say("HELLO 2");
  board_.run_for(10ms);
  EXPECT_EQ(board_.take_lines().front(), "PLATE 2 -90.00 90.00 300.00 20.00 assumed");
}

TEST_F(Firmware, GivesNoPulseBeforeACommand) {
  greet();
  run_with_beats(1000ms);
  EXPECT_TRUE(board_.pulses().empty());
}

// 1500 us at 0, 2000 us over 180 degrees: the pulse of every angle from -90 to 90 in steps of 0.5 degrees,
// and the frame of 20 ms.
TEST_F(Firmware, PulsesAreWithinAMicrosecondOverTheWholeRange) {
  start_at_zero();
  set(-90.0);
  run_with_beats(400ms);
  double worst_us = 0.0;
  for (double angle_deg = -90.0; angle_deg <= 90.0; angle_deg += 0.5) {
    set(angle_deg);
    board_.run_for(45ms);
    worst_us = std::max(worst_us, std::abs(width_us() - (1500.0 + angle_deg * 2000.0 / 180.0)));
  }
  EXPECT_LT(worst_us, 1.0);
  RecordProperty("worst_us", std::to_string(worst_us));
  std::printf("worst deviation of a pulse: %.3f us\n", worst_us);
  const auto& pulses = board_.pulses();
  for (std::size_t i = 1; i < pulses.size(); ++i)
    EXPECT_NEAR(static_cast<double>((pulses[i].start - pulses[i - 1].start).count()), 20e6, 1e3) << i;
}

// 300 degrees a second, and a pulse every 20 ms: 6 degrees, 66.7 us, from one to the next.
TEST_F(Firmware, TurnsAtItsSpeed) {
  start_at_zero();
  const std::size_t before = board_.pulses().size();
  set(90.0);
  run_with_beats(400ms);
  const auto& pulses = board_.pulses();
  for (std::size_t i = before; i < pulses.size(); ++i) {
    const double step_us = pulses[i].width_us() - pulses[i - 1].width_us();
    EXPECT_LE(step_us, 6.0 * 2000.0 / 180.0 + 3.4 + 1.0) << i;  // a millisecond more or less, and rounding
    EXPECT_GE(step_us, -1.0) << i;
  }
  // 90 degrees take 300 ms.
  EXPECT_NEAR(pulses[before + 7].width_us(), 1500.0 + 1000.0 * 7.5 * 20.0 / 300.0, 80.0);
  EXPECT_NEAR(width_us(), 2500.0, 1.0);
}

TEST_F(Firmware, EchoesSequenceNumbersWithinMilliseconds) {
  start_at_zero();
  board_.run_for(30ms);
  board_.take_lines();
  beat();
  const auto sent = board_.now();
  const std::string echo = "AT +000.00 " + beat_body("", Version::two, sequence_).substr(1);
  std::vector<std::string> lines;
  while (!contains(lines, echo) && board_.now() < sent + 100ms) {
    board_.run_for(100us);
    const auto more = board_.take_lines();
    lines.insert(lines.end(), more.begin(), more.end());
  }
  // 11 and 22 bytes at 0.09 ms, and up to a millisecond to the tick.
  EXPECT_LT(board_.now() - sent, 5ms);
  std::printf("from a line to its echo: %.2f ms\n",
              static_cast<double>((board_.now() - sent).count()) * 1e-6);
}

// The pulse stands still 300 ms after the last byte, at every phase of the frame.
TEST_F(Firmware, StopsWithin300MillisecondsOfSilence) {
  std::chrono::nanoseconds slowest{};
  for (int phase = 0; phase < 20; ++phase) {
    EmulatedBoard board;
    board.run_for(30ms + phase * 1ms);
    board.say("HELLO 2");
    board.say("CONF speed 100");  // 90 degrees take 900 ms
    board.say(set_body(0.0, Version::two, 1));
    for (int i = 0; i < 12; ++i) {
      board.run_for(50ms);
      board.say(beat_body("BEAT", Version::two, 2));
    }
    board.say(set_body(-90.0, Version::two, 3));
    while (board.is_sending()) board.run_for(100us);
    const auto silent = board.now();
    board.take_lines();
    board.run_for(700ms);
    std::chrono::nanoseconds last_change{};
    const auto& pulses = board.pulses();
    for (std::size_t i = 1; i < pulses.size(); ++i)
      if (std::abs(pulses[i].width_us() - pulses[i - 1].width_us()) > 0.6) last_change = pulses[i].start;
    EXPECT_LE(last_change - silent, 300ms) << phase;
    EXPECT_GT(last_change - silent, 200ms) << phase;  // and it did move until then
    slowest = std::max(slowest, last_change - silent);
    EXPECT_TRUE(contains(board.take_lines(), "STOPPED heartbeat"));
  }
  std::printf("last change of a pulse after the last byte: %.1f ms\n",
              static_cast<double>(slowest.count()) * 1e-6);
}

TEST_F(Firmware, HoldsItsPlaceAfterAStopAndGoesOnWithTheNextCommand) {
  greet();
  board_.say("CONF speed 100");
  start_at_zero();
  set(90.0);
  run_with_beats(100ms);
  board_.run_for(600ms);
  const double held_us = width_us();
  EXPECT_GT(held_us, 1600.0);
  EXPECT_LT(held_us, 2499.0);
  board_.run_for(1000ms);
  EXPECT_EQ(width_us(), held_us);
  set(90.0);
  run_with_beats(1000ms);
  EXPECT_NEAR(width_us(), 2500.0, 1.0);
}

// 20 thousand damaged lines, with good ones in between: the pulse stays, and the good ones are all
// understood.
TEST_F(Firmware, DamagedLinesMoveNothing) {
  start_at_zero();
  std::mt19937 random(7);
  const std::size_t before = board_.pulses().size();
  for (int i = 0; i < 2000; ++i) {
    for (int k = 0; k < 10; ++k) {
      const double angle_deg = static_cast<double>(random() % 18001) / 100.0 - 90.0;
      std::string bad =
          damaged(encode_line(set_body(angle_deg, Version::two, sequence_), Version::two), random);
      board_.send(bad);
    }
    beat();
    while (board_.is_sending()) board_.run_for(1ms);
    board_.run_for(10ms);
    const auto lines = board_.take_lines();
    ASSERT_TRUE(contains(lines, "AT +000.00 " + beat_body("", Version::two, sequence_).substr(1))) << i;
    for (const std::string& line : lines) {
      const bool is_report = line.starts_with("AT ");
      EXPECT_TRUE(!is_report || line.starts_with("AT +000.00 ")) << i << " " << line;
    }
  }
  for (std::size_t i = before; i < board_.pulses().size(); ++i)
    EXPECT_NEAR(board_.pulses()[i].width_us(), 1500.0, 0.5);
  // And no flood of lines has kept the main loop from a millisecond.
  board_.say("TEST");
  board_.run_for(30ms);
  const auto lines = board_.take_lines();
  EXPECT_TRUE(contains(lines, "TEST loop 1") || contains(lines, "TEST loop 2"));
}

TEST_F(Firmware, NamesWhatItRefuses) {
  greet();
  const auto answer = [&](const std::string& bytes) {
    board_.send(bytes);
    board_.run_for(30ms);
    std::string named;
    for (const std::string& line : board_.take_lines())
      if (line.starts_with("ERROR ") || line.starts_with("STOPPED ")) named += line + ";";
    return named;
  };
  const auto line = [](const std::string& body) { return encode_line(body, Version::two); };
  EXPECT_EQ(answer("SET +010.00 00001*0000\n"), "ERROR sum;");
  EXPECT_EQ(answer(std::string(100, 'x') + "\n"), "ERROR length;");
  EXPECT_EQ(answer("SET\t\n"), "ERROR byte;");
  EXPECT_EQ(answer(line("TURN 1")), "ERROR word;");
  EXPECT_EQ(answer(line("SET 10.00 00001")), "ERROR number;");
  EXPECT_EQ(answer(line("SET +010.00")), "ERROR word;");
  EXPECT_EQ(answer(line("SET +370.00 00001")), "ERROR range;");
  EXPECT_EQ(answer(line("SET +090.01 00001")), "STOPPED limit;");
  EXPECT_EQ(answer(encode_line("BEAT", Version::one)), "ERROR sum;");
  EXPECT_EQ(answer(line("CONF zero 2501")), "ERROR range;");
  EXPECT_EQ(answer(line("CONF size 1")), "ERROR word;");
  EXPECT_EQ(answer(line("BEAT 00001")), "");
  EXPECT_TRUE(board_.pulses().empty());
}

// The host has been sending since before the board started.
TEST_F(Firmware, BootsWhileTheHostTalks) {
  for (int i = 0; i < 20; ++i) {
    set(45.0);
    board_.run_for(7ms);
  }
  EXPECT_TRUE(board_.pulses().empty());
  const auto lines = board_.take_lines();
  EXPECT_EQ(lines.front(), "BOOT");
  EXPECT_TRUE(contains(lines, "ERROR greeting"));
  start_at_zero();
  EXPECT_NEAR(width_us(), 1500.0, 1.0);
}

// No pulse after the reset until the next greeting and command; then from the place where the plate was.
TEST_F(Firmware, StaysWhereItIsWhenItIsResetInMotion) {
  start_at_zero();
  set(90.0);
  run_with_beats(150ms);
  const double before_us = width_us();
  ASSERT_GT(before_us, 1600.0);
  ASSERT_LT(before_us, 2450.0);
  board_.take_lines();
  board_.reset();
  const std::size_t pulses = board_.pulses().size();
  for (int i = 0; i < 10; ++i) {
    set(90.0);
    board_.run_for(50ms);
  }
  EXPECT_EQ(board_.pulses().size(), pulses);
  EXPECT_EQ(board_.take_lines().front(), "BOOT");

  board_.say("HELLO 2");
  set(0.0);
  run_with_beats(300ms);
  EXPECT_NEAR(board_.pulses().at(pulses).width_us(), before_us, 70.0);  // at most a frame of motion later
  run_with_beats(800ms);
  EXPECT_NEAR(width_us(), 1500.0, 1.0);
}

TEST_F(Firmware, EmergencyStopEndsThePulsesUntilTheNextGreeting) {
  start_at_zero();
  set(90.0);
  run_with_beats(100ms);
  board_.take_lines();
  board_.open_emergency_stop(true);
  const auto opened = board_.now();
  board_.run_for(500ms);
  EXPECT_LT(board_.pulses().back().start - opened, 25ms);
  EXPECT_GE(board_.pulses().back().width_us(), 500.0);  // none is cut
  EXPECT_TRUE(contains(board_.take_lines(), "STOPPED emergency"));

  const std::size_t pulses = board_.pulses().size();
  board_.open_emergency_stop(false);
  set(0.0);
  board_.run_for(100ms);
  EXPECT_TRUE(contains(board_.take_lines(), "STOPPED emergency"));
  EXPECT_EQ(board_.pulses().size(), pulses);
  start_at_zero();
  EXPECT_GT(board_.pulses().size(), pulses);
}

TEST_F(Firmware, KeepsItsSettingsInEeprom) {
  greet();
  for (const char* body : {"CONF zero 1510", "CONF speed 200", "CONF serial 42"}) {
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
  // 10 us more at 0: the upper limit is where the pulse ends, 990 / 2000 * 180 degrees.
  const std::string kept = "PLATE 2 -90.00 89.10 200.00 20.00 assumed;INFO 1.0.0 000042;";
  EXPECT_EQ(greeting_with(memory), kept);
  memory[20] ^= 1;  // one copy is damaged, as by a power failure while it is written
  EXPECT_EQ(greeting_with(memory), kept);
  memory[64 + 20] ^= 1;  // both are
  EXPECT_EQ(greeting_with(memory), "PLATE 2 -90.00 90.00 300.00 20.00 assumed;INFO 1.0.0 000000;");
}

TEST_F(Firmware, TestsItself) {
  greet();
  board_.say("TEST");
  board_.run_for(30ms);
  std::vector<std::string> lines;
  for (const std::string& line : board_.take_lines())
    if (line.starts_with("TEST")) lines.push_back(line);
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(lines[0], "TEST settings default");
  EXPECT_EQ(lines[1], "TEST emergency closed");
  EXPECT_EQ(lines[3], "TEST pulse 0.00");
  EXPECT_EQ(lines[5], "TEST end");
}

TEST_F(Firmware, SpeaksVersionOne) {
  board_.run_for(50ms);
  board_.send("HELLO 1*53\n");
  board_.run_for(10ms);
  EXPECT_TRUE(has(board_.take_output(), "PLATE 1 -90.00 90.00 300.00*"));
  for (int i = 0; i < 20; ++i) {
    board_.send(i == 0 ? "SET -34.25*61\n" : "BEAT*12\n");
    board_.run_for(50ms);
  }
  EXPECT_NEAR(width_us(), 1500.0 - 34.25 * 2000.0 / 180.0, 1.0);
  EXPECT_TRUE(contains(board_.take_lines(), "AT -34.25"));
  board_.run_for(400ms);
  EXPECT_TRUE(contains(board_.take_lines(), "STOPPED heartbeat"));
}

// A servo with a potentiometer, at 40 degrees.
class FirmwareWithFeedback : public Firmware {
 protected:
  FirmwareWithFeedback() : Firmware(eeprom_with_feedback()), servo_(board_, 40.0, 4.8) {
    board_.run_for(50ms);
    board_.say("HELLO 2");
    board_.run_for(10ms);
  }

  EmulatedServo servo_;
};

TEST_F(FirmwareWithFeedback, StartsFromWhereTheServoIs) {
  EXPECT_TRUE(contains(board_.take_lines(), "PLATE 2 -90.00 90.00 300.00 20.00 measured"));
  set(80.0);
  run_with_beats(60ms);
  EXPECT_NEAR((board_.pulses().front().width_us() - 1500.0) * 0.09, 40.0, 1.0);
  run_with_beats(600ms);
  EXPECT_NEAR(servo_.place_deg(), 80.0, 0.1);
  double reported_deg = 0.0;
  for (const std::string& line : board_.take_lines())
    if (const auto message = parse_plate_message(line, Version::two))
      if (const auto* report = std::get_if<PlateReport>(&*message)) reported_deg = report->orientation_deg;
  EXPECT_NEAR(reported_deg, 80.0, 0.5);
}

TEST_F(FirmwareWithFeedback, NoticesAServoThatIsStuck) {
  servo_.jammed = true;
  set(80.0);
  run_with_beats(1000ms);
  EXPECT_TRUE(contains(board_.take_lines(), "STOPPED stuck"));
  const std::size_t pulses = board_.pulses().size();
  run_with_beats(200ms);
  EXPECT_EQ(board_.pulses().size(), pulses);  // no current for a servo that cannot move
}

}  // namespace
}  // namespace hrt::plate
