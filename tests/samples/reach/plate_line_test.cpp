// The text of the plate's protocol, as samples/reach/plate_protocol.md defines it.
#include "samples/reach/plate_line.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace hrt::reach {
namespace {

// 'B' ^ 'E' ^ 'A' ^ 'T' = 0x42 ^ 0x45 ^ 0x41 ^ 0x54 = 0x12.
TEST(PlateLine, EndsWithItsSum) {
  EXPECT_EQ(encode_line("BEAT"), "BEAT*12\n");
}

TEST(PlateLine, IsReadBack) {
  EXPECT_EQ(decode_line("BEAT*12"), "BEAT");
  EXPECT_EQ(decode_line("BEAT*12\r"), "BEAT");
}

TEST(PlateLine, IsRefusedUnlessItIsWhole) {
  for (const char* line : {"", "*", "*00", "BEAT", "BEAT*", "BEAT*1", "BEAT*13", "BEAT*12 ", "EAT*12",
                           "BE\tAT*12", "BEAT*12\r\r", "BE*AT*38", "BEAT\x80*92"})
    EXPECT_FALSE(decode_line(line)) << line;
  EXPECT_EQ(encode_line("AT 1j").substr(5), "*6E\n");  // a sum with a letter in it: upper case only
  EXPECT_TRUE(decode_line("AT 1j*6E"));
  EXPECT_FALSE(decode_line("AT 1j*6e"));
}

// The page's example is what others will build from.
TEST(PlateLine, OfTheDocumentedExampleIsValid) {
  std::ifstream page(HRT_REACH_SOURCE "/plate_protocol.md");
  int lines = 0;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("    host    ", 0) != 0 && line.rfind("    plate   ", 0) != 0) continue;
    ++lines;
    const auto body = decode_line(std::string_view(line).substr(12));
    ASSERT_TRUE(body) << line;
    EXPECT_EQ(line.rfind("    plate", 0) == 0, parse_plate_message(*body).has_value()) << line;
  }
  EXPECT_EQ(lines, 9);
}

TEST(PlateMessage, HasLimitsAndSpeed) {
  const auto message = parse_plate_message("PLATE 1 -90.00 85.5 400");
  ASSERT_TRUE(message);
  const auto greeting = std::get<PlateGreeting>(*message);
  EXPECT_EQ(greeting.least_deg, -90.0);
  EXPECT_EQ(greeting.most_deg, 85.5);
  EXPECT_EQ(greeting.speed_deg_s, 400.0);
}

TEST(PlateMessage, HasThePlatesOrientation) {
  EXPECT_EQ(std::get<PlateReport>(*parse_plate_message("AT -12.5")).orientation_deg, -12.5);
}

TEST(PlateMessage, HasTheReasonOfAStop) {
  EXPECT_EQ(std::get<PlateStopped>(*parse_plate_message("STOPPED host")).reason, StopReason::host);
  EXPECT_EQ(std::get<PlateStopped>(*parse_plate_message("STOPPED heartbeat")).reason, StopReason::heartbeat);
  EXPECT_EQ(std::get<PlateStopped>(*parse_plate_message("STOPPED limit")).reason, StopReason::limit);
  EXPECT_EQ(std::get<PlateStopped>(*parse_plate_message("STOPPED fault")).reason, StopReason::fault);
}

TEST(PlateMessage, IsNothingElse) {
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
                           "SET 1"})
    EXPECT_FALSE(parse_plate_message(body)) << body;
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
    const auto body = decode_line(*line);
    messages += body && parse_plate_message(*body) ? 1 : 0;
  }
  EXPECT_EQ(messages, 0);
}

}  // namespace
}  // namespace hrt::reach
