// The firmware's behaviour, compiled for this machine: lines, motion and stops without a board.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "plugin/src/plate/plate_line.h"
#include "samples/plate/firmware/plate.h"
#include "tests/samples/plate/damage.h"

namespace hrt::plate {
namespace {

std::string sent;
int saves = 0;
bool has_room = true;

bool send(const char* line, uint8_t length) {
  if (has_room) sent.append(line, length);
  return has_room;
}

void save(const uint8_t*) {
  ++saves;
}

constexpr PlateBoard board{send, save};

class FirmwareLogic : public testing::Test {
 protected:
  FirmwareLogic() {
    sent.clear();
    saves = 0;
    has_room = true;
    plate_start(&plate_, &board, nullptr, nullptr);
    hear(encode_line("HELLO 2", Version::two));
  }

  void hear(const std::string& bytes) {
    for (const char byte : bytes) plate_hear(&plate_, byte);
  }
  void say(const std::string& body) { hear(encode_line(body, Version::two)); }
  void set(double orientation_deg) { say(set_body(orientation_deg, Version::two, ++sequence_)); }
  void beat() { say(beat_body("BEAT", Version::two, ++sequence_)); }

  void pass(int milliseconds) {
    for (; milliseconds > 0; --milliseconds) plate_tick(&plate_, &inputs_);
  }
  void pass_with_beats(int milliseconds) {
    for (; milliseconds > 0; milliseconds -= 50) {
      beat();
      pass(std::min(milliseconds, 50));
    }
  }
  double position_deg() const { return plate_.position_microdeg * 1e-6; }

  std::vector<std::string> take_lines() {
    std::vector<std::string> lines;
    LineReader reader;
    for (const char byte : sent) {
      const auto line = reader.take(byte);
      if (!line) continue;
      const auto decoded = decode_line(*line);
      EXPECT_TRUE(decoded) << *line;
      if (decoded) lines.emplace_back(decoded->body);
    }
    sent.clear();
    return lines;
  }
  bool has_sent(const std::string& body) {
    const auto lines = take_lines();
    return std::find(lines.begin(), lines.end(), body) != lines.end();
  }

  Plate plate_{};
  PlateInputs inputs_{false, -1};
  std::uint16_t sequence_ = 0;
};

// 300 degrees a second: 30 degrees after 100 ms of motion, which begins when the servo has settled at 0.
TEST_F(FirmwareLogic, TurnsAtItsSpeedAfterTheServoHasSettled) {
  set(90.0);
  pass_with_beats(500);
  EXPECT_EQ(position_deg(), 0.0);
  EXPECT_EQ(plate_pulse_ticks(&plate_), 3000);
  pass(100);
  EXPECT_NEAR(position_deg(), 30.0, 1e-6);
  pass_with_beats(500);
  EXPECT_EQ(position_deg(), 90.0);
  EXPECT_EQ(plate_pulse_ticks(&plate_), 5000);
}

TEST_F(FirmwareLogic, StopsWithoutAHeartbeatBeforeThePulsesOf300Milliseconds) {
  set(0.0);
  pass_with_beats(600);
  set(90.0);
  pass(274);
  const double before_deg = position_deg();
  pass(300);
  EXPECT_NEAR(position_deg(), before_deg, 0.31);
  EXPECT_TRUE(has_sent("STOPPED heartbeat"));
  EXPECT_EQ(plate_.state, PLATE_RESTING);
}

TEST_F(FirmwareLogic, SaysWhatFindsNoRoomLater) {
  set(91.0);
  has_room = false;
  pass(100);
  has_room = true;
  pass(1);
  EXPECT_TRUE(has_sent("STOPPED limit"));
}

TEST_F(FirmwareLogic, AWaveringEmergencyContactIsNoEmergency) {
  set(0.0);
  inputs_.emergency_open = true;
  pass(1);
  inputs_.emergency_open = false;
  pass(1);
  EXPECT_TRUE(plate_.pulses);
  inputs_.emergency_open = true;
  pass(2);
  EXPECT_FALSE(plate_.pulses);
  EXPECT_TRUE(has_sent("STOPPED emergency"));
}

TEST_F(FirmwareLogic, AGreetingDoesNotEndAnEmergencyThatLasts) {
  inputs_.emergency_open = true;
  pass(5);
  say("HELLO 2");
  set(10.0);
  pass(5);
  EXPECT_FALSE(plate_.pulses);
  EXPECT_EQ(plate_.state, PLATE_LATCHED);
  inputs_.emergency_open = false;
  pass(5);
  EXPECT_EQ(plate_.state, PLATE_LATCHED);
  say("HELLO 2");
  set(10.0);
  pass(5);
  EXPECT_TRUE(plate_.pulses);
}

// A potentiometer that follows at a tenth of the speed is far away for seconds, and on its way.
TEST_F(FirmwareLogic, ASlowServoIsNotStuck) {
  plate_.settings.value[SETTING_ADC_LEAST] = 20000;
  plate_.settings.value[SETTING_ADC_MOST] = 80000;
  const auto reading_at = [](double place_deg) {
    return static_cast<std::int16_t>(std::lround(500.0 + place_deg / 0.3));
  };
  double place_deg = 0.0;
  inputs_.adc = reading_at(place_deg);
  pass(1);
  set(80.0);
  for (int i = 0; i < 2500; ++i) {
    if (i % 50 == 0) beat();
    place_deg = std::min(80.0, place_deg + 0.03);
    inputs_.adc = reading_at(place_deg);
    pass(1);
  }
  EXPECT_EQ(plate_.state, PLATE_FOLLOWING);
  set(-80.0);
  pass_with_beats(800);
  EXPECT_EQ(plate_.state, PLATE_LATCHED);
  EXPECT_TRUE(has_sent("STOPPED stuck"));
}

TEST_F(FirmwareLogic, AGreetingStopsTheMotion) {
  set(90.0);
  pass_with_beats(600);
  const double before_deg = position_deg();
  ASSERT_LT(before_deg, 89.0);
  say("HELLO 2");
  pass(200);
  EXPECT_EQ(position_deg(), before_deg);
}

// A trim of 21 us at once would jump by two degrees.
TEST_F(FirmwareLogic, ASettingMovesTheServoByASmallStepOnly) {
  set(0.0);
  pass_with_beats(600);
  take_lines();
  say("CONF zero 1521");
  pass(2);
  EXPECT_TRUE(has_sent("ERROR range"));
  say("CONF zero 1520");
  pass(2);
  EXPECT_TRUE(has_sent("CONF zero 1520.00"));
  EXPECT_EQ(plate_pulse_ticks(&plate_), 3040);
}

TEST_F(FirmwareLogic, SettingsWaitForTheEndOfAMotion) {
  set(90.0);
  pass_with_beats(550);
  take_lines();
  say("CONF speed 10");
  pass(2);
  EXPECT_TRUE(has_sent("ERROR busy"));
  say("SAVE");
  pass(20);
  EXPECT_TRUE(has_sent("ERROR busy"));
  EXPECT_EQ(saves, 0);
  say(beat_body("STOP", Version::two, 9));
  say("SAVE");
  EXPECT_EQ(saves, 1);
  plate_saved(&plate_, true);
  pass(2);
  EXPECT_TRUE(has_sent("SAVED"));
}

TEST_F(FirmwareLogic, ListsItsSettings) {
  say("CONF");
  pass(30);
  int count = 0;
  for (const std::string& line : take_lines()) count += line.starts_with("CONF ") ? 1 : 0;
  EXPECT_EQ(count, SETTING_COUNT);
}

TEST_F(FirmwareLogic, StartsWithinItsLimitsWhateverTheMemoryHolds) {
  for (const std::int32_t known : {INT32_MIN, -200'000'000, 200'000'000, INT32_MAX}) {
    plate_start(&plate_, &board, nullptr, &known);
    EXPECT_LE(std::abs(position_deg()), 90.0);
  }
}

// A million damaged lines, a good one after every tenth: the plate stays at 0, and hears the good ones.
TEST_F(FirmwareLogic, AMillionDamagedLinesMoveNothing) {
  set(0.0);
  pass_with_beats(600);
  std::mt19937 random(1);
  std::string bad;
  for (int i = 0; i < 1'000'000; ++i) {
    switch (i % 3) {
      case 0:
        bad = set_body(static_cast<double>(random() % 18001) / 100.0 - 90.0, Version::two, sequence_);
        break;
      case 1:
        bad = "CONF zero 1" + std::to_string(490 + random() % 20);
        break;
      default:
        bad = beat_body("STOP", Version::two, sequence_);
        break;
    }
    hear(damaged(encode_line(bad, Version::two), random));
    if (i % 10 != 0) continue;
    beat();
    pass(3);
    sent.clear();
    ASSERT_EQ(plate_.sequence, sequence_) << i;
    ASSERT_EQ(plate_.state, PLATE_FOLLOWING) << bad;
    ASSERT_EQ(plate_.target_microdeg, 0) << bad;
    ASSERT_EQ(plate_pulse_ticks(&plate_), 3000) << bad;
  }
}

// Any bytes at all, most of them of the protocol: nothing leaves the limits, and every line that is sent is
// valid.
TEST_F(FirmwareLogic, NoiseNeverLeavesTheLimits) {
  static const std::string alphabet = "SETBAPOHL 0123456789+-.*\nFCDINRV\r";
  std::mt19937 random(2);
  for (int i = 0; i < 300'000; ++i) {
    plate_hear(&plate_,
               random() % 8 == 0 ? static_cast<char>(random()) : alphabet[random() % alphabet.size()]);
    if (i % 20 == 0) pass(1);
    ASSERT_LE(std::abs(plate_.position_microdeg), 90'000'000);
  }
  take_lines();
}

TEST(FirmwareLine, HasTheSumOfTheStandard) {
  EXPECT_EQ(line_crc("123456789", 9), 0x29B1);
  EXPECT_EQ(crc_of("123456789"), 0x29B1);
}

// Firmware and driver agree on every line that the other can write.
TEST(FirmwareLine, AgreesWithTheDriver) {
  for (const Version version : {Version::one, Version::two}) {
    for (const char* body : {"BEAT", "SET -34.25", "HELLO 2", "x"}) {
      char line[LINE_SIZE];
      const uint8_t length = line_seal(line, body, static_cast<uint8_t>(version));
      EXPECT_EQ(std::string(line, length), encode_line(body, version));
    }
  }
  for (double angle_deg = -180.0; angle_deg <= 180.0; angle_deg += 0.37) {
    int32_t read = 0;
    ASSERT_TRUE(line_fixed_angle(set_body(angle_deg, Version::two, 7).substr(4, 7).c_str(), &read));
    EXPECT_NEAR(read, angle_deg * 100.0, 0.51);
    char text[16];
    *line_put_fixed_angle(text, read) = 0;
    EXPECT_EQ(std::string(text), set_body(read / 100.0, Version::two, 7).substr(4, 7));
  }
}

TEST(FirmwareLine, ReadsNumbers) {
  const auto read = [](const char* word) {
    int32_t value = -1;
    return line_hundredths(word, &value) ? value : INT32_MIN;
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
