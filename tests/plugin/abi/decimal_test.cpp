// What decimal.cpp makes of C's functions is what std::to_chars() and std::from_chars() give.
#include "plugin/src/abi/decimal.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace hrt::plugin {
namespace {

using in_c::read_decimal;

std::string written(double number) {
  char text[longest_decimal];
  return std::string(text, in_c::write_decimal(number, text));
}

TEST(Decimal, Texts) {
  EXPECT_EQ(written(0.0), "0");
  EXPECT_EQ(written(-0.0), "-0");
  EXPECT_EQ(written(0.1), "0.1");
  EXPECT_EQ(written(-84.5), "-84.5");
  EXPECT_EQ(written(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(written(1e5), "1e+05");
  EXPECT_EQ(written(12e4), "120000");
  EXPECT_EQ(written(0.001), "0.001");
  EXPECT_EQ(written(0.0001), "1e-04");
  EXPECT_EQ(written(1e22), "1e+22");
  EXPECT_EQ(written(123456789012345680000.0), "123456789012345683968");
  EXPECT_EQ(written(5e-324), "5e-324");
  EXPECT_EQ(written(-std::numeric_limits<double>::max()), "-1.7976931348623157e+308");
}

TEST(Decimal, Readings) {
  double number = 7.0;
  for (const char* text :
       {"", " 1", "+1", "1 ", "0x1", "1,5", "1e", "e1", ".", "-", "--1", "1e999", "nan(1)"}) {
    EXPECT_FALSE(read_decimal(text, &number)) << text;
    EXPECT_EQ(number, 7.0);
  }
  EXPECT_TRUE(read_decimal("-.5e1", &number));
  EXPECT_EQ(number, -5.0);
  EXPECT_TRUE(read_decimal("-Inf", &number));
  EXPECT_EQ(number, -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(read_decimal("NaN", &number));
  EXPECT_TRUE(std::isnan(number));
}

/// Calls `take` with numbers of all sizes: powers of two and their neighbours, where the distance to the next
/// number changes; any bits; decimals of few digits.
template <class Take>
void for_many_numbers(Take&& take) {
  for (int exponent = -1074; exponent < 1024; ++exponent) {
    const double power = std::ldexp(1.0, exponent);
    for (const double number : {std::nextafter(power, 0.0), power, std::nextafter(power, 2.0 * power)})
      take(number);
  }
  std::uint64_t bits = 1;
  for (int i = 0; i < 20'000; ++i) {
    bits = bits * 6364136223846793005u + 1442695040888963407u;
    const double any = std::bit_cast<double>(bits);
    if (std::isfinite(any)) take(any);
    const double digits = static_cast<double>(bits >> 44);
    take(digits * std::pow(10.0, static_cast<double>(bits % 40) - 20.0));
    take(digits / 1e6);
  }
}

TEST(Decimal, ReadsBackToTheSameBits) {
  for_many_numbers([](double number) {
    double back = 0.0;
    ASSERT_TRUE(read_decimal(written(number), &back)) << written(number);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(back), std::bit_cast<std::uint64_t>(number)) << written(number);
  });
}

#if defined(__cpp_lib_to_chars)
TEST(Decimal, IsWhatTheCxxLibraryWrites) {
  for_many_numbers([](double number) {
    char text[longest_decimal];
    ASSERT_EQ(written(number), std::string(text, write_decimal(number, text)));
  });
}
#endif

}  // namespace
}  // namespace hrt::plugin
