// Tests of the lines and messages of the protocol that plugin/src/plate/protocol.md defines.
#include "plugin/src/plate/plate_line.h"
#include "plugin/include/plate_driver/crc16.h"
#include "plugin/include/plate_driver/plate_text.h"

#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <sstream>
#include <string>

namespace hrt::plate {
namespace {

// Returns the body of `line`, which has no newline; nullopt if the line is not valid.
std::optional<std::string> decode(std::string_view line) {
  LineBuffer buffer{};
  LineError error = LINE_OK;
  for (const char byte : line) line_receive(&buffer, byte, &error);
  return line_receive(&buffer, '\n', &error) && error == LINE_OK ? std::optional<std::string>(buffer.text)
                                                                 : std::nullopt;
}

// Published check values of CRC-16/CCITT-FALSE and CRC-16/UMTS.
TEST(PlateLine, EndsWithItsCrc) {
  EXPECT_EQ(crc16_ccitt("123456789", 9), 0x29B1U);
  EXPECT_EQ(crc16_umts("123456789", 9), 0xFEE8U);
  EXPECT_EQ(encode_line("123456789"), "123456789*29B1\n");
}

TEST(PlateLine, IsDecoded) {
  EXPECT_EQ(decode("123456789*29B1"), "123456789");
  EXPECT_EQ(decode("123456789*29B1\r"), "123456789");
}

TEST(PlateLine, IsRefusedIfDamagedOrIncomplete) {
  for (const char* line :
       {"", "*", "*FFFF", "BEAT", "BEAT*", "BEAT*12", "123456789*29B1 ", "123456789*29B1\r\r", "12345*6789*29B1",
        "1234\t6789*29B1", "1234\2006789*29B1", "123456789*29B", "123456789*29b1", "123456789*29B12", "213456789*29B1"})
    EXPECT_FALSE(decode(line)) << line;
}

TEST(PlateLine, DocumentedExamplesAreValid) {
  std::ifstream page(HRT_PLATE_PAGES "/protocol.md");
  int lines = 0;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("    host    ") && !line.starts_with("    plate   ")) continue;
    ++lines;
    const auto decoded = decode(std::string_view(line).substr(12));
    ASSERT_TRUE(decoded) << line;
    const bool is_message = parse_plate_message(*decoded).has_value();
    EXPECT_EQ(line.starts_with("    plate"), is_message) << line;
  }
  EXPECT_EQ(lines, 13);
}

TEST(PlateLine, HostLinesHaveFixedWidths) {
  EXPECT_EQ(motion_body(-34.25, 7), "SET -034.25 00007");
  EXPECT_EQ(motion_body(0.0, 65535, "HOME"), "HOME +000.00 65535");
  EXPECT_EQ(with_number("BEAT", 12), "BEAT 00012");
}

TEST(PlateMessage, ParsesEachKind) {
  const auto greeting = std::get<PlateGreeting>(*parse_plate_message("PLATE 2 -90.00 85.5 300 20.00 measured"));
  EXPECT_EQ(greeting.max_deg, 85.5);
  EXPECT_EQ(greeting.latency_ms, 20.0);
  EXPECT_TRUE(greeting.is_measured);
  const auto report = std::get<PlateReport>(*parse_plate_message("AT -012.50 00042"));
  EXPECT_EQ(report.orientation_deg, -12.5);
  EXPECT_EQ(report.sequence, 42);
  EXPECT_FALSE(std::get<PlateReport>(*parse_plate_message("AT unknown 00042")).orientation_deg);
  EXPECT_EQ(std::get<PlateStopped>(*parse_plate_message("STOPPED emergency")).reason, StopReason::emergency);
  EXPECT_EQ(std::get<PlateStopped>(*parse_plate_message("STOPPED stuck")).reason, StopReason::stuck);
  EXPECT_TRUE(std::holds_alternative<PlateBooted>(*parse_plate_message("BOOT")));
  EXPECT_EQ(std::get<PlateInfo>(*parse_plate_message("INFO 1.1.0 000042")).serial, "000042");
  EXPECT_EQ(std::get<PlateRefusal>(*parse_plate_message("ERROR sum")).why, "sum");
  EXPECT_EQ(std::get<PlateSetting>(*parse_plate_message("CONF zero 1510.00")).value, 1510.0);
  EXPECT_EQ(std::get<PlateTest>(*parse_plate_message("TEST emergency closed")).result, "closed");
  EXPECT_EQ(std::get<PlateTest>(*parse_plate_message("TEST end")).what, "end");
}

TEST(PlateMessage, RefusesInvalidBodies) {
  std::istringstream bodies(
      "; ;AT;AT ;at +001.00 00001;BEAT 00001;SET +001.00 00001;PLATE;"
      "PLATE 1 -90 90 400 20 measured;PLATE 2 90 -90 400 20 measured;PLATE 2 90 90 400 20 measured;"
      "PLATE 2 -90 90 0 20 measured;PLATE 2 -90 90 nan 20 measured;PLATE 2 -90 90 1e3 20 measured;"
      "PLATE 2 -90 90 0x10 20 measured;PLATE 2 -90 90 1000001 20 measured;"
      "PLATE 2 -361 90 400 20 measured;PLATE 2 -90 90 1234567890123 20 measured;"
      "PLATE 2 -90 90 400 20 measured 1;PLATE 2 -90 90 400;PLATE 2 -90 90 400 20 guessed;"
      "PLATE 2 -90 90 400 -1 measured;PLATE 2 -90 90 400 1001 measured;AT -12.50 00042;"
      "AT +012.5 00042;AT +0012.50 0042;AT +012.50 0042;AT +012.50 65536;AT +012.50;"
      "AT  012.50 00042;AT +361.00 00001;AT +01.250 00001;AT +012.50 +0042;BOOT now;INFO 1.1.0;"
      "CONF zero x;CONF zero;ERROR;TEST;TEST over;STOPPED why;STOPPED");
  for (std::string body; std::getline(bodies, body, ';');) EXPECT_FALSE(parse_plate_message(body)) << body;
}

TEST(PlateLine, TheLineAfterOneThatIsTooLongIsRead) {
  for (const int length : {LINE_SIZE - 1, int{LINE_SIZE}, 100'000}) {
    LineBuffer buffer{};
    LineError error = LINE_OK;
    for (int i = 0; i < length; ++i) EXPECT_FALSE(line_receive(&buffer, 'x', &error));
    EXPECT_TRUE(line_receive(&buffer, '\n', &error));
    EXPECT_EQ(error, length < LINE_SIZE ? LINE_BAD_SUM : LINE_TOO_LONG);
    for (const char byte : encode_line("next")) line_receive(&buffer, byte, &error);
    EXPECT_EQ(error, LINE_OK);
    EXPECT_STREQ(buffer.text, "next");
  }
}

}  // namespace
}  // namespace hrt::plate
