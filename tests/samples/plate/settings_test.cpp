#include "samples/app/firmware/settings.h"

#include <gtest/gtest.h>

#include <array>

namespace hrt::plate {
namespace {

// Returns the defaults with the whole range of pulses and one change.
Settings with(Setting setting, int32_t hundredths) {
  Settings settings = settings_default();
  settings.value[SETTING_MIN_DEG] = -9000;
  settings.value[SETTING_MAX_DEG] = 9000;
  settings.value[setting] = hundredths;
  return settings;
}

TEST(PlateSettings, HaveDefaultsThatFit) {
  const Settings settings = settings_default();
  EXPECT_TRUE(settings_valid(&settings));
  // Pulses of 1000 to 2000 us, the usual range of hobby servos.
  EXPECT_EQ(settings_lower_limit(&settings), -4500);
  EXPECT_EQ(settings_upper_limit(&settings), 4500);
  EXPECT_FALSE(settings_has_feedback(&settings));
}

TEST(PlateSettings, HaveRanges) {
  const auto valid = [](Setting setting, int32_t value) {
    const Settings settings = with(setting, value);
    return settings_valid(&settings);
  };
  EXPECT_TRUE(valid(SETTING_ZERO_US, 50000));
  EXPECT_FALSE(valid(SETTING_ZERO_US, 49900));
  EXPECT_FALSE(valid(SETTING_ZERO_US, 150050));  // only whole microseconds are valid
  EXPECT_TRUE(valid(SETTING_SPAN_US, -200000));
  EXPECT_FALSE(valid(SETTING_SPAN_US, 0));
  EXPECT_FALSE(valid(SETTING_SPAN_US, 49900));
  EXPECT_FALSE(valid(SETTING_SPAN_US, 250100));
  EXPECT_FALSE(valid(SETTING_MIN_DEG, 1));
  EXPECT_FALSE(valid(SETTING_MAX_DEG, -1));
  EXPECT_FALSE(valid(SETTING_SPEED_DEG_S, 0));
  EXPECT_FALSE(valid(SETTING_SPEED_DEG_S, 100100));
  EXPECT_FALSE(valid(SETTING_ADC_AT_MAX, 4900));  // readings less than 50 apart
  EXPECT_TRUE(valid(SETTING_ADC_AT_MAX, 5000));
  EXPECT_FALSE(valid(SETTING_EMERGENCY, 200));
  for (int i = 0; i < SETTING_COUNT; ++i) {
    EXPECT_FALSE(valid(static_cast<Setting>(i), INT32_MAX)) << i;
    EXPECT_FALSE(valid(static_cast<Setting>(i), INT32_MIN)) << i;
  }
}

TEST(PlateSettings, AreFoundByName) {
  for (int i = 0; i < SETTING_COUNT; ++i)
    EXPECT_EQ(setting_named(setting_name(static_cast<Setting>(i))), static_cast<Setting>(i));
  EXPECT_EQ(setting_named(""), SETTING_COUNT);
  EXPECT_EQ(setting_named("zer"), SETTING_COUNT);
  EXPECT_EQ(setting_named("zero1"), SETTING_COUNT);
}

// Expected: 1500 us +- 1000 us at +-90 degrees, which is 3000, 1000 and 5000 half microseconds; 4000 at 45 degrees.
TEST(PlateSettings, MapAnglesToPulses) {
  const Settings settings = settings_default();
  EXPECT_EQ(settings_pulse_ticks(&settings, 0), 3000);
  EXPECT_EQ(settings_pulse_ticks(&settings, 90000), 5000);
  EXPECT_EQ(settings_pulse_ticks(&settings, -90000), 1000);
  EXPECT_EQ(settings_pulse_ticks(&settings, 45000), 4000);
  EXPECT_EQ(settings_pulse_ticks(&settings, 100000), 5000);  // the longest pulse
  const Settings clockwise = with(SETTING_SPAN_US, -200000);
  EXPECT_EQ(settings_pulse_ticks(&clockwise, 45000), 2000);
  for (int32_t millideg = -90000; millideg <= 90000; millideg += 7)
    EXPECT_NEAR(settings_pulse_ticks(&settings, millideg), 3000.0 + millideg / 45.0, 0.5001) << millideg;
}

// With 10 us more at orientation 0, the longest pulse, 2500 us, limits the orientation to 90 - 0.9 degrees.
TEST(PlateSettings, LimitAnglesToTheRangeOfPulses) {
  const Settings trimmed = with(SETTING_ZERO_US, 151000);
  EXPECT_EQ(settings_lower_limit(&trimmed), -9000);
  EXPECT_EQ(settings_upper_limit(&trimmed), 8910);
  EXPECT_EQ(settings_pulse_ticks(&trimmed, 89100), 5000);
  Settings clockwise = trimmed;
  clockwise.value[SETTING_SPAN_US] = -200000;
  EXPECT_EQ(settings_lower_limit(&clockwise), -8910);
  EXPECT_EQ(settings_upper_limit(&clockwise), 9000);
}

TEST(PlateSettings, MapReadingsToAngles) {
  Settings settings = with(SETTING_ADC_AT_MIN, 10000);
  settings.value[SETTING_ADC_AT_MAX] = 90000;
  EXPECT_TRUE(settings_valid(&settings));
  EXPECT_EQ(settings_measured_millideg(&settings, 100 * 16), -90000);
  EXPECT_EQ(settings_measured_millideg(&settings, 500 * 16), 0);
  EXPECT_EQ(settings_measured_millideg(&settings, 900 * 16), 90000);
  EXPECT_NEAR(settings_measured_millideg(&settings, 1023 * 16), 90000 + 123 * 225, 10);
}

TEST(PlateSettings, MapReadingsToAtMostOneTurn) {
  Settings settings = with(SETTING_ADC_AT_MIN, 10000);
  settings.value[SETTING_ADC_AT_MAX] = 15000;
  EXPECT_EQ(settings_measured_millideg(&settings, 1023 * 16), 360000);
  settings.value[SETTING_ADC_AT_MIN] = 95000;
  settings.value[SETTING_ADC_AT_MAX] = 100000;
  EXPECT_EQ(settings_measured_millideg(&settings, 0), -360000);
}

TEST(PlateSettings, ArePackedAndUnpacked) {
  Settings settings = with(SETTING_SERIAL, 99999900);
  settings.value[SETTING_SPAN_US] = -180000;
  std::array<uint8_t, SETTINGS_BYTES> bytes{};
  settings_pack(&settings, bytes.data());
  Settings read = settings_default();
  ASSERT_TRUE(settings_unpack(&read, bytes.data()));
  for (int i = 0; i < SETTING_COUNT; ++i) EXPECT_EQ(read.value[i], settings.value[i]);
}

TEST(PlateSettings, RefuseDamagedBitsErasedMemoryAndValuesOutOfRange) {
  const Settings settings = settings_default();
  std::array<uint8_t, SETTINGS_BYTES> bytes{};
  settings_pack(&settings, bytes.data());
  Settings read = with(SETTING_SERIAL, 700);
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] = static_cast<uint8_t>(bytes[bit / 8] ^ (1U << bit % 8));
    EXPECT_FALSE(settings_unpack(&read, bytes.data())) << bit;
    bytes[bit / 8] = static_cast<uint8_t>(bytes[bit / 8] ^ (1U << bit % 8));
  }
  bytes.fill(0xFF);
  EXPECT_FALSE(settings_unpack(&read, bytes.data()));
  bytes.fill(0);
  EXPECT_FALSE(settings_unpack(&read, bytes.data()));
  const Settings beyond = with(SETTING_ZERO_US, 300000);  // out of range, with a right checksum
  settings_pack(&beyond, bytes.data());
  EXPECT_FALSE(settings_unpack(&read, bytes.data()));
  EXPECT_EQ(read.value[SETTING_SERIAL], 700);
}

}  // namespace
}  // namespace hrt::plate
