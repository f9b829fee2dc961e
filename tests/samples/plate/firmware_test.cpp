// Tests of the firmware's behaviour, compiled for this machine: lines, motion, homing and stops.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "samples/app/emulator/hobby_plate.h"
#include "tests/samples/plate/board_fixture.h"
#include "tests/samples/plate/damage.h"
#include "tests/samples/text.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

class FirmwareLogic : public BoardFixture<HobbyPlate> {
 protected:
  explicit FirmwareLogic(const HobbyPlate::Traits& traits = {}) : BoardFixture(traits), plate_(board_.plate()) {
    board_.receive_line("HELLO 2");
    board_.run_for(20ms);  // the sensor is read
  }

  void home(double orientation_deg, std::chrono::milliseconds time = 0ms) { set(orientation_deg, time, "HOME"); }
  double position_deg() const { return plate_.position_microdeg * 1e-6; }
  // Returns the answers to a line, without reports.
  std::string answer(const std::string& bytes) {
    board_.run_for(20ms);
    board_.take_lines();
    board_.receive(bytes, board_.now());
    board_.run_for(20ms);
    std::string named;
    for (const std::string& line : board_.take_lines())
      if (!line.starts_with("AT ")) named += line + ";";
    return named;
  }
  std::string answer_to(const std::string& body) { return answer(encode_line(body)); }

  Plate& plate_;
};

// The pulse moves from the measured position at 200 degrees a second.
TEST_F(FirmwareLogic, TurnsAtItsSpeed) {
  set(80.0);
  board_.run_for(160ms);  // the first pulses hold the servo
  EXPECT_NEAR(position_deg(), 0.0, 0.3);
  run_with_beats(200ms);
  EXPECT_NEAR(position_deg(), 40.0, 0.5);
  run_with_beats(500ms);
  EXPECT_EQ(position_deg(), 80.0);
  EXPECT_NEAR(board_.orientation_deg(), 80.0, 0.3);
}

// After a stop, a servo turns by at most 2 degrees plus its motion in the dead time of 10 ms, a period of its pulses,
// and the filter of its sensor. Silence of the host stops the servo after 300 ms.
TEST(Firmware, AStopEndsTheMotionOfTheServo) {
  for (const double speed_deg_s : {30.0, 60.0, 160.0, 250.0}) {
    for (const std::string stop : {"STOP 00100", "HELLO 2", ""}) {
      HobbyPlate board({.servo = {.speed_deg_s = speed_deg_s}, .orientation_deg = -80.0});
      board.receive_line("HELLO 2");
      board.run_for(20ms);
      board.receive_line(motion_body(80.0, 1));
      for (std::uint16_t i = 2; i < 8; ++i) {
        board.run_for(100ms);
        board.receive_line(with_number("BEAT", i));
      }
      if (stop.empty()) {
        board.run_for(300ms);
      } else {
        board.receive_line(stop);
      }
      const double stopped_deg = board.orientation_deg();
      EXPECT_LT(stopped_deg, 78.0);
      double farthest_deg = 0.0;
      for (int i = 0; i < 4000; ++i) {
        board.run_for(1ms);
        farthest_deg = std::max(farthest_deg, std::abs(board.orientation_deg() - stopped_deg));
      }
      EXPECT_LT(farthest_deg, 2.0 + 0.04 * std::min(200.0, speed_deg_s)) << speed_deg_s << " " << stop;
    }
  }
}

TEST_F(FirmwareLogic, ThePulseIsAheadOfTheSensorByABoundedAngle) {
  board_.servo.limit_speed(20.0);
  for (const double orientation_deg : {85.0, -85.0}) {
    set(orientation_deg);
    for (int i = 0; i < 100; ++i) {
      run_with_beats(50ms);
      EXPECT_LT(std::abs(position_deg() - board_.orientation_deg()), 15.0);
    }
    EXPECT_GT(std::abs(board_.orientation_deg()), 10.0);
  }
}

TEST_F(FirmwareLogic, SendsALineLaterIfTheBufferIsFull) {
  set(91.0);
  board_.has_room = false;
  board_.run_for(100ms);
  board_.has_room = true;
  board_.run_for(1ms);
  EXPECT_TRUE(has_sent("STOPPED limit"));
}

TEST_F(FirmwareLogic, IgnoresAnEmergencyContactOpenForOneMillisecond) {
  set(0.0);
  board_.press_emergency_stop(true);
  board_.run_for(1ms);
  board_.press_emergency_stop(false);
  board_.run_for(1ms);
  EXPECT_TRUE(board_.has_pulses());
  board_.press_emergency_stop(true);
  board_.run_for(2ms);
  EXPECT_FALSE(board_.has_pulses());
  EXPECT_TRUE(has_sent("STOPPED emergency"));
}

TEST_F(FirmwareLogic, AGreetingDoesNotEndAnEmergencyWhileTheContactIsOpen) {
  board_.press_emergency_stop(true);
  board_.run_for(5ms);
  board_.receive_line("HELLO 2");
  set(10.0);
  board_.run_for(5ms);
  EXPECT_FALSE(board_.has_pulses());
  board_.press_emergency_stop(false);
  board_.run_for(5ms);
  EXPECT_EQ(plate_.state, PLATE_LATCHED);
  board_.receive_line("HELLO 2");
  set(10.0);
  board_.run_for(5ms);
  EXPECT_TRUE(board_.has_pulses());
}

// A servo with a tenth of the speed of the motion lags for seconds, but moves.
TEST_F(FirmwareLogic, ASlowServoIsNotStuckAndAJammedOneIs) {
  board_.servo.limit_speed(20.0);
  set(80.0, 2500ms);
  EXPECT_TRUE(board_.is_following());
  board_.servo.is_jammed = true;
  set(-80.0, 1300ms);
  EXPECT_TRUE(has_sent("STOPPED stuck"));
  EXPECT_FALSE(board_.has_pulses());  // so that a jammed servo draws no current
}

// The settings adc_least and adc_most are exchanged, so that the first pulse turns the plate to the opposite side.
TEST(Firmware, WithExchangedReadingsThePlateTurnsByLessThan15Degrees) {
  Settings exchanged = commissioned();
  std::swap(exchanged.value[SETTING_ADC_AT_MIN], exchanged.value[SETTING_ADC_AT_MAX]);
  for (const double orientation_deg : {10.0, 40.0, 70.0, -40.0, -70.0}) {
    HobbyPlate board({.settings = exchanged, .orientation_deg = orientation_deg});
    board.receive_line("HELLO 2");
    board.run_for(20ms);
    board.receive_line(motion_body(orientation_deg, 1));
    double farthest_deg = 0.0;
    for (std::uint16_t sequence = 2; sequence < 200; ++sequence) {
      board.receive_line(with_number("BEAT", sequence));
      board.run_for(5ms);
      farthest_deg = std::max(farthest_deg, std::abs(board.servo.plate_deg() - orientation_deg));
    }
    const auto lines = board.take_lines();
    EXPECT_EQ(std::count(lines.begin(), lines.end(), "STOPPED sensor"), 1) << orientation_deg;
    EXPECT_LT(farthest_deg, 15.0) << orientation_deg;
    EXPECT_FALSE(board.has_pulses());
  }
}

// An offset of 4 degrees between the servo and its sensor, as a potentiometer may have.
TEST_F(FirmwareLogic, AcceptsASensorOffset) {
  plate_.settings.value[SETTING_ZERO_US] += 4400;  // 44 us
  for (const double orientation_deg : {0.0, 50.0, -50.0}) {
    board_.receive_line("HELLO 2");
    board_.servo.turn_by_hand(orientation_deg);
    run_with_beats(100ms);
    set(10.0, 2000ms);
    EXPECT_TRUE(board_.is_following()) << orientation_deg;
    EXPECT_NEAR(board_.servo.plate_deg(), 14.0, 0.5);
  }
}

// The servo's supply fails while the plate turns, is stuck or holds. Later the supply returns: if the board still sent
// pulses, the servo would then turn at its full speed of 250 degrees a second.
TEST_F(FirmwareLogic, ALostSupplyEndsThePulses) {
  const std::function<void()> moments[] = {[&] { set(80.0, 400ms); },
                                           [&] {
                                             board_.servo.is_jammed = true;
                                             set(-80.0, 400ms);
                                           },
                                           [&] { set(0.0, 1500ms); }};
  for (const auto& moment : moments) {
    board_.receive_line("HELLO 2");
    moment();
    board_.servo.supply = 0.0;
    run_with_beats(10ms);
    EXPECT_TRUE(has_sent("STOPPED supply"));
    board_.servo.is_jammed = false;
    run_with_beats(300ms);
    const double orientation_deg = board_.orientation_deg();
    board_.servo.supply = 1.0;
    set(80.0, 300ms);
    EXPECT_FALSE(board_.has_pulses());
    EXPECT_NEAR(board_.orientation_deg(), orientation_deg, 0.5);
    board_.receive_line("HELLO 2");
    set(80.0, 100ms);
    EXPECT_NEAR(board_.orientation_deg(), orientation_deg, 0.5);  // the first pulses hold the servo at its position
    run_with_beats(1000ms);
    EXPECT_NEAR(board_.orientation_deg(), 80.0, 0.5);
  }
  board_.servo.supply = 0.7;  // 3.5 V
  board_.run_for(4ms);
  EXPECT_TRUE(board_.has_pulses());  // a short dip is ignored
  board_.run_for(5ms);
  EXPECT_TRUE(has_sent("STOPPED supply"));
  board_.receive_line("HELLO 2");
  EXPECT_EQ(answer_to("CONF supply 0"), "CONF supply 0.00;");
  board_.receive_line("HELLO 2");
  set(80.0, 200ms);
  EXPECT_TRUE(board_.has_pulses());
}

// A host that greets with a token excludes other hosts until it has been silent for 300 ms.
TEST_F(FirmwareLogic, RefusesASecondHost) {
  board_.run_for(300ms);
  EXPECT_TRUE(has(answer_to("HELLO 2 00007"), "PLATE 2 "));
  for (const char* line : {"SET +040.00 00001", "SET +040.00 00001 00008", "BEAT 00001", "CONF zero 1600", "STOP 00001",
                           "HOME +040.00 00001 7", "SAVE", "TEST", "HELLO 2", "HELLO 2 00008"}) {
    board_.receive_line("BEAT 00002 00007");
    EXPECT_EQ(answer_to(line), "ERROR session;") << line;
  }
  EXPECT_FALSE(board_.has_pulses());
  EXPECT_EQ(answer_to("CONF zero 1501 00007"), "CONF zero 1501.00;");
  EXPECT_EQ(answer_to("SET +040.00 00003 00007"), "");
  EXPECT_TRUE(board_.has_pulses());
  board_.run_for(300ms);
  EXPECT_TRUE(has(answer_to("HELLO 2 00008"), "PLATE 2 "));
}

TEST_F(FirmwareLogic, RefusesASettingThatMovesTheServoByMoreThan20Microseconds) {
  set(0.0, 200ms);
  const int before = plate_pulse_ticks(&plate_);
  EXPECT_EQ(answer_to("CONF zero 1521"), "ERROR step;");
  EXPECT_EQ(answer_to("CONF zero 1520"), "CONF zero 1520.00;");
  EXPECT_EQ(plate_pulse_ticks(&plate_), before + 40);
}

TEST_F(FirmwareLogic, RefusesSettingsDuringAMotion) {
  set(90.0, 150ms);
  EXPECT_EQ(answer_to("CONF speed 10"), "ERROR busy;");
  EXPECT_EQ(answer_to("SAVE"), "ERROR busy;");
  EXPECT_EQ(board_.saves(), 0);
  board_.receive_line(with_number("STOP", 9));
  board_.receive_line("SAVE");
  EXPECT_EQ(board_.saves(), 1);
  board_.run_for(10ms);
  EXPECT_TRUE(has_sent("SAVED"));
}

TEST_F(FirmwareLogic, AnswersQuestions) {
  const std::string settings = answer_to("CONF");
  EXPECT_EQ(std::count(settings.begin(), settings.end(), ';'), SETTING_COUNT);
  EXPECT_EQ(answer_to("INFO"), "INFO 1.1.0 000007;");
  EXPECT_EQ(
      answer_to("TEST"),
      "TEST settings saved;TEST emergency closed;TEST adc 512;TEST supply 5.00;TEST pulse 0.00;TEST loop 0;TEST end;");
}

TEST_F(FirmwareLogic, ReportsTheReasonOfARefusal) {
  EXPECT_EQ(answer("SET +010.00 00001*0000\n"), "ERROR sum;");
  EXPECT_EQ(answer("SET +010.00 00001*00\n"), "ERROR sum;");
  EXPECT_EQ(answer(std::string(100, 'x') + "\n"), "ERROR length;");
  EXPECT_EQ(answer("SET\t\n"), "ERROR byte;");
  EXPECT_EQ(answer_to("TURN 1"), "ERROR word;");
  EXPECT_EQ(answer_to("SET 10.00 00001"), "ERROR number;");
  EXPECT_EQ(answer_to("SET +010.00"), "ERROR word;");
  EXPECT_EQ(answer_to("SET +370.00 00001"), "ERROR range;");
  EXPECT_EQ(answer_to("SET +090.01 00001"), "STOPPED limit;");
  EXPECT_EQ(answer_to("HELLO 1"), "ERROR word;");
  EXPECT_EQ(answer_to("CONF zero 2501"), "ERROR range;");
  EXPECT_EQ(answer_to("CONF size 1"), "ERROR word;");
  EXPECT_EQ(answer_to("BEAT 00001"), "");
  EXPECT_FALSE(board_.has_pulses());
}

TEST_F(FirmwareLogic, AMillionDamagedLinesMoveNothing) {
  set(0.0, 600ms);
  const int ticks = plate_pulse_ticks(&plate_);
  std::mt19937 random(1);
  std::string bad;
  for (int i = 0; i < 1'000'000; ++i) {
    switch (i % 3) {
      case 0:
        bad = motion_body(static_cast<double>(random() % 18001) / 100.0 - 90.0, sequence_);
        break;
      case 1:
        bad = "CONF zero 1" + std::to_string(490 + random() % 20);
        break;
      default:
        bad = with_number("STOP", sequence_);
        break;
    }
    for (const char byte : damaged(encode_line(bad), random)) plate_receive(&plate_, byte);
    if (i % 10 != 0) continue;
    beat();
    board_.run_for(3ms);
    board_.take_output();
    ASSERT_EQ(plate_.sequence, sequence_) << i;
    ASSERT_TRUE(board_.is_following()) << bad;
    ASSERT_EQ(plate_.target_microdeg, 0) << bad;
    ASSERT_EQ(plate_pulse_ticks(&plate_), ticks) << bad;
  }
}

TEST_F(FirmwareLogic, NoiseKeepsThePlateWithinItsLimits) {
  static const std::string alphabet = "SETBAPOHML 0123456789+-.*\nFCDINRV\r";
  std::mt19937 random(2);
  for (int i = 0; i < 300'000; ++i) {
    plate_receive(&plate_, random() % 8 == 0 ? static_cast<char>(random()) : alphabet[random() % alphabet.size()]);
    if (i % 20 == 0) board_.run_for(1ms);
    ASSERT_LE(std::abs(plate_.position_microdeg), 90'000'000);
  }
  LineBuffer buffer{};
  for (const char byte : board_.take_output()) {
    LineError error = LINE_OK;
    EXPECT_TRUE(!line_receive(&buffer, byte, &error) || error == LINE_OK) << buffer.text;
  }
}

// Plate with a hobby servo without a sensor, at 20 degrees, before homing.
class FirmwareWithoutSensor : public FirmwareLogic {
 protected:
  FirmwareWithoutSensor() : FirmwareLogic({.settings = settings_default(), .orientation_deg = 20.0}) {}
  std::string reported() {
    board_.take_lines();
    run_with_beats(50ms);
    return board_.take_lines().back().substr(3, 7);
  }
};

// With one pulse in eight, the servo turns at about an eighth of its 250 degrees a second.
TEST_F(FirmwareWithoutSensor, IsHomedSlowly) {
  home(-40.0);
  for (double before_deg = 20.0; board_.orientation_deg() > -39.0;) {
    run_with_beats(500ms);
    EXPECT_LT(before_deg - board_.orientation_deg(), 0.5 * 250.0 / 8.0 + 6.0);
    before_deg = board_.orientation_deg();
    ASSERT_LT(board_.now(), 8s);
  }
  EXPECT_EQ(reported(), "unknown");
  while (board_.now() < 8200ms) run_with_beats(50ms);
  EXPECT_EQ(reported(), "-040.00");
  set(40.0, 1300ms);  // without a sensor, the speed is limited to 60 degrees a second
  EXPECT_LT(board_.orientation_deg(), 40.0);
  run_with_beats(200ms);
  EXPECT_NEAR(board_.orientation_deg(), 40.0, 0.2);
  EXPECT_EQ(reported(), "+040.00");
}

TEST_F(FirmwareWithoutSensor, IsStoppedWhileItIsHomed) {
  const std::function<void()> stops[] = {[&] { board_.receive_line(with_number("STOP", 9)); },
                                         [&] { board_.run_for(300ms); }, [&] { board_.receive_line("HELLO 2"); }};
  for (const auto& stop : stops) {
    home(-40.0, 500ms);
    EXPECT_TRUE(board_.has_pulses());
    stop();
    EXPECT_FALSE(board_.has_pulses());
    EXPECT_EQ(reported(), "unknown");
  }
}

// A hand turns the plate while the emergency stop is pressed, or after a reset.
TEST_F(FirmwareWithoutSensor, OrientationIsUnknownAfterAnEmergencyAndAReset) {
  for (const bool reset : {false, true}) {
    home(0.0, 8200ms);
    EXPECT_EQ(reported(), "+000.00");
    board_.press_emergency_stop(!reset);
    if (reset) board_.restart();
    board_.run_for(100ms);
    board_.servo.turn_by_hand(80.0);
    board_.press_emergency_stop(false);
    board_.run_for(5ms);
    board_.receive_line("HELLO 2");
    EXPECT_EQ(answer_to("SET +000.00 00001"), "STOPPED unhomed;");
    EXPECT_EQ(reported(), "unknown");
    EXPECT_EQ(board_.orientation_deg(), 80.0);
  }
}

TEST(FirmwareLine, ReadsNumbers) {
  const auto read = [](const char* word) {
    int32_t value = -1;
    return line_parse_hundredths(word, &value) ? value : INT32_MIN;
  };
  EXPECT_EQ(read("0"), 0);
  EXPECT_EQ(read("-12.5"), -1250);
  EXPECT_EQ(read("12.34"), 1234);
  EXPECT_EQ(read("12.349"), 1234);
  EXPECT_EQ(read("9999999"), 999999900);
  for (const char* word :
       {"", "-", ".", "1.", ".5", "+1", "1e3", "nan", "10000000", "1,5", "1 ", "0x1", "--1", "1234567890123"})
    EXPECT_EQ(read(word), INT32_MIN) << word;
}

}  // namespace
}  // namespace hrt::plate
