// Conversion of numbers to text and back restores every bit, also with std::from_chars where it exists.
#include "plugin/src/abi/text.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace hrt::plugin {
namespace {

std::string written(double number) {
  char text[max_number];
  return std::string(text, write_number(number, text));
}

TEST(Number, WritesTheShortestTextThatReadsBack) {
  EXPECT_EQ(written(0.0), "0");
  EXPECT_EQ(written(-0.0), "-0");
  EXPECT_EQ(written(0.1), "0.1");
  EXPECT_EQ(written(-84.5), "-84.5");
  EXPECT_EQ(written(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(written(12e4), "120000");
  EXPECT_EQ(written(0.0001), "0.0001");
  EXPECT_EQ(written(0.00001), "1e-05");
  EXPECT_EQ(written(1e22), "1e+22");
  EXPECT_EQ(written(5e-324), "5e-324");
  EXPECT_EQ(written(-std::numeric_limits<double>::max()), "-1.7976931348623157e+308");
}

TEST(Number, ReadsDecimalNumbersAndRejectsOtherTexts) {
  double number = 7.0;
  for (const char* text : {"", " 1", "+1", "1 ", "0x1", "1,5", "1e", "e1", ".", "-", "--1", "1e999", "1.5.5"}) {
    EXPECT_FALSE(read_number(text, &number)) << text;
    EXPECT_EQ(number, 7.0);
  }
  EXPECT_TRUE(read_number("-.5e1", &number));
  EXPECT_EQ(number, -5.0);
  EXPECT_TRUE(read_number("-Inf", &number));
  EXPECT_EQ(number, -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(read_number("NaN", &number));
  EXPECT_TRUE(std::isnan(number));
}

TEST(Number, ReadsIntegersAndRejectsOtherTexts) {
  std::int64_t number = 7;
  for (const char* text : {"", "1.0", "1 ", "9223372036854775808", "NaN"}) {
    EXPECT_FALSE(read_number(text, &number)) << text;
    EXPECT_EQ(number, 7);
  }
  EXPECT_TRUE(read_number("-9223372036854775808", &number));
  EXPECT_EQ(number, std::numeric_limits<std::int64_t>::min());
}

}  // namespace
}  // namespace hrt::plugin
