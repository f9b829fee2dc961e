// The text of the plate's protocol, as samples/plate/protocol.md defines it.
#include "plugin/src/plate/plate_line.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace hrt::plate {
namespace {

// 'B' ^ 'E' ^ 'A' ^ 'T' = 0x42 ^ 0x45 ^ 0x41 ^ 0x54 = 0x12.
TEST(PlateLine, EndsWithItsSum) {
  EXPECT_EQ(encode_line("BEAT", Version::one), "BEAT*12\n");
}

// The check value of CRC-16/CCITT-FALSE in catalogues of sums.
TEST(PlateLine, EndsWithItsCrcInVersionTwo) {
  EXPECT_EQ(crc_of("123456789"), 0x29B1);
  EXPECT_EQ(encode_line("123456789", Version::two), "123456789*29B1\n");
}

std::optional<std::string> body_of(std::string_view line) {
  const auto decoded = decode_line(line);
  return decoded ? std::optional(std::string(decoded->body)) : std::nullopt;
}

TEST(PlateLine, IsReadBack) {
  EXPECT_EQ(body_of("BEAT*12"), "BEAT");
  EXPECT_EQ(body_of("BEAT*12\r"), "BEAT");
  EXPECT_EQ(body_of("123456789*29B1"), "123456789");
  EXPECT_EQ(decode_line("BEAT*12")->version, Version::one);
  EXPECT_EQ(decode_line("123456789*29B1")->version, Version::two);
}

TEST(PlateLine, IsRefusedUnlessItIsWhole) {
  for (const char* line : {"", "*", "*00", "*FFFF", "BEAT", "BEAT*", "BEAT*1", "BEAT*13", "BEAT*12 ",
                           "EAT*12", "BE\tAT*12", "BEAT*12\r\r", "BE*AT*38", "BEAT\x80*92", "123456789*29B",
                           "123456789*29b1", "123456789*29B12", "123456789*29B"})
    EXPECT_FALSE(decode_line(line)) << line;
  EXPECT_EQ(encode_line("AT 1j", Version::one).substr(5),
            "*6E\n");  // a sum with a letter in it: upper case only
  EXPECT_TRUE(decode_line("AT 1j*6E"));
  EXPECT_FALSE(decode_line("AT 1j*6e"));
}

// Digits that have changed places pass the exclusive-or, not the CRC.
TEST(PlateLine, NoticesTransposedDigitsInVersionTwo) {
  const auto transposed = [](Version version) {
    std::string line = encode_line("AT +012.34 00001", version);
    line.pop_back();
    std::swap(line[5], line[6]);
    return decode_line(line).has_value();
  };
  EXPECT_TRUE(transposed(Version::one));
  EXPECT_FALSE(transposed(Version::two));
}

// The page's examples are what others will build from.
TEST(PlateLine, OfTheDocumentedExamplesIsValid) {
  std::ifstream page(HRT_PLATE_SOURCE "/protocol.md");
  int lines = 0;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("    host    ") && !line.starts_with("    plate   ")) continue;
    ++lines;
    const auto decoded = decode_line(std::string_view(line).substr(12));
    ASSERT_TRUE(decoded) << line;
    const bool is_message = parse_plate_message(decoded->body, decoded->version).has_value();
    EXPECT_EQ(line.starts_with("    plate"), is_message) << line;
  }
  EXPECT_EQ(lines, 20);
}

TEST(PlateLine, OfTheHostHasFixedWidths) {
  EXPECT_EQ(set_body(-34.25, Version::two, 7), "SET -034.25 00007");
  EXPECT_EQ(set_body(0.0, Version::two, 65535), "SET +000.00 65535");
  EXPECT_EQ(set_body(-34.25, Version::one, 7), "SET -34.25");
  EXPECT_EQ(beat_body("BEAT", Version::two, 12), "BEAT 00012");
  EXPECT_EQ(beat_body("STOP", Version::one, 12), "STOP");
}

std::optional<PlateMessage> first(std::string_view body) {
  return parse_plate_message(body, Version::one);
}
std::optional<PlateMessage> second(std::string_view body) {
  return parse_plate_message(body, Version::two);
}

TEST(PlateMessage, OfVersionTwo) {
  const auto greeting = std::get<PlateGreeting>(*second("PLATE 2 -90.00 85.5 300 20.00 measured"));
  EXPECT_EQ(greeting.version, Version::two);
  EXPECT_EQ(greeting.max_deg, 85.5);
  EXPECT_EQ(greeting.latency_ms, 20.0);
  EXPECT_TRUE(greeting.is_measured);
  const auto report = std::get<PlateReport>(*second("AT -012.50 00042"));
  EXPECT_EQ(report.orientation_deg, -12.5);
  EXPECT_EQ(report.sequence, 42);
  EXPECT_EQ(std::get<PlateStopped>(*second("STOPPED emergency")).reason, StopReason::emergency);
  EXPECT_EQ(std::get<PlateStopped>(*second("STOPPED stuck")).reason, StopReason::stuck);
  EXPECT_TRUE(std::holds_alternative<PlateBooted>(*second("BOOT")));
  EXPECT_EQ(std::get<PlateInfo>(*second("INFO 1.0.0 000042")).serial, "000042");
  EXPECT_EQ(std::get<PlateRefusal>(*second("ERROR sum")).why, "sum");
  EXPECT_EQ(std::get<PlateSetting>(*second("CONF zero 1510.00")).value, 1510.0);
  EXPECT_EQ(std::get<PlateTest>(*second("TEST emergency closed")).result, "closed");
}

TEST(PlateMessage, OfVersionTwoIsNothingElse) {
  for (const char* body : {"PLATE 2 -90 90 400",
                           "PLATE 1 -90 90 400",
                           "PLATE 2 -90 90 400 20 guessed",
                           "PLATE 2 -90 90 400 -1 measured",
                           "PLATE 2 -90 90 400 1001 measured",
                           "AT -12.50 00042",
                           "AT +012.5 00042",
                           "AT +0012.50 0042",
                           "AT +012.50 0042",
                           "AT +012.50 65536",
                           "AT +012.50",
                           "AT  012.50 00042",
                           "AT +361.00 00001",
                           "AT +01.250 00001",
                           "AT +012.50 +0042",
                           "BOOT now",
                           "INFO 1.0.0",
                           "CONF zero x",
                           "CONF zero",
                           "ERROR",
                           "TEST",
                           "STOPPED"})
    EXPECT_FALSE(second(body)) << body;
}

TEST(PlateMessage, OfVersionOne) {
  const auto greeting = std::get<PlateGreeting>(*first("PLATE 1 -90.00 85.5 400"));
  EXPECT_EQ(greeting.min_deg, -90.0);
  EXPECT_EQ(greeting.max_deg, 85.5);
  EXPECT_EQ(greeting.speed_deg_s, 400.0);
  EXPECT_EQ(std::get<PlateReport>(*first("AT -12.5")).orientation_deg, -12.5);
  const std::pair<const char*, StopReason> stops[] = {{"STOPPED host", StopReason::host},
                                                      {"STOPPED heartbeat", StopReason::heartbeat},
                                                      {"STOPPED limit", StopReason::limit},
                                                      {"STOPPED fault", StopReason::fault}};
  for (const auto& [body, reason] : stops) EXPECT_EQ(std::get<PlateStopped>(*first(body)).reason, reason);
}

TEST(PlateMessage, OfVersionOneIsNothingElse) {
  for (const char* body : {"",
                           " ",
                           "AT",
                           "AT ",
                           "AT x",
                           "AT 1 2",
                           "AT  1",
                           "AT nan",
                           "AT inf",
                           "AT 1e3",
                           "AT 0x10",
                           "AT 1,5",
                           "AT 1234567890123",
                           "AT 360.01",
                           "AT -99999999999",
                           "at 1",
                           "PLATE",
                           "PLATE 2 -90 90 400",
                           "PLATE 1 90 -90 400",
                           "PLATE 1 90 90 400",
                           "PLATE 1 -90 90 0",
                           "PLATE 1 -90 90 1000001",
                           "PLATE 1 -361 90 400",
                           "PLATE 1 -90 90",
                           "PLATE 1 -90 90 400 1",
                           "STOPPED",
                           "STOPPED why",
                           "BEAT",
                           "STOPPED stuck",
                           "BOOT",
                           "AT +001.00 00001",
                           "SET 1"})
    EXPECT_FALSE(first(body)) << body;
}

TEST(PlateLineReader, CutsLines) {
  LineReader reader;
  std::vector<std::string> read;
  for (const char byte : std::string("one\ntwo\r\n\nthree"))
    if (const auto line = reader.take(byte)) read.emplace_back(*line);
  EXPECT_EQ(read, (std::vector<std::string>{"one", "two\r", ""}));
}

TEST(PlateLineReader, EmptiesALineThatIsTooLongAndReadsTheNext) {
  for (const std::size_t length : {LineReader::max_line - 1, LineReader::max_line, std::size_t{100'000}}) {
    LineReader reader;
    for (std::size_t i = 0; i < length; ++i) EXPECT_FALSE(reader.take('x'));
    const auto line = reader.take('\n');
    ASSERT_TRUE(line);
    EXPECT_EQ(line->size(), length < LineReader::max_line ? length : 0);
    for (const char byte : std::string("next")) reader.take(byte);
    EXPECT_EQ(reader.take('\n'), "next");
  }
}

// A bit that flips in any place of a line is noticed: every single-bit error changes the sum or the frame.
TEST(PlateLine, NoticesEverySingleBitError) {
  const std::string good = "AT -34.25*36";
  ASSERT_TRUE(decode_line(good));
  for (std::size_t i = 0; i < good.size() * 8; ++i) {
    std::string bad = good;
    bad[i / 8] = static_cast<char>(bad[i / 8] ^ (1 << (i % 8)));
    EXPECT_FALSE(decode_line(bad)) << bad;
  }
}

TEST(PlateLine, SurvivesNoise) {
  std::mt19937 random(1);
  LineReader reader;
  int messages = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const auto line = reader.take(static_cast<char>(random() & 0xff));
    if (!line) continue;
    EXPECT_LT(line->size(), LineReader::max_line);
    const auto decoded = decode_line(*line);
    messages += decoded && parse_plate_message(decoded->body, decoded->version) ? 1 : 0;
  }
  EXPECT_EQ(messages, 0);
}

}  // namespace
}  // namespace hrt::plate
