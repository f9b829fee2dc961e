#include "core/simulation/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace hrt {
namespace {

// Known answers from Random123 (kat_vectors, philox4x32 with 10 rounds).
TEST(SimulationRandom, PhiloxCounters_GiveTheKnownAnswers) {
  EXPECT_EQ(philox({}, 0), (PhiloxBlock{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  constexpr std::uint32_t max = 0xffffffff;
  EXPECT_EQ(philox({max, max, max, max}, ~std::uint64_t{0}),
            (PhiloxBlock{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, 0x299f31d0'a4093822),
            (PhiloxBlock{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

// Box-Muller transform in long double, with the layout of bits of normal_pair().
std::array<long double, 2> reference_pair(std::uint64_t bits) {
  const long double radius = std::sqrt(-2.0L * std::log((static_cast<long double>(bits >> 24) + 0.5L) * 0x1p-40L));
  long double x = static_cast<long double>(bits & 0x3fffff) + 0.5L;
  x = (x * 0x1p-22L - 0.5L) * std::numbers::pi_v<long double> / 2.0L;
  std::array<long double, 2> pair{(bits >> 22 & 1) ? -std::cos(x) : std::cos(x), std::sin(x)};
  if (bits >> 23 & 1) std::swap(pair[0], pair[1]);
  return {radius * pair[0], radius * pair[1]};
}

void expect_near_reference(std::uint64_t bits) {
  const std::array<double, 2> pair = normal_pair(bits);
  const auto [first, second] = reference_pair(bits);
  const double tolerance = 3e-15 * std::max(1.0, static_cast<double>(std::hypot(first, second)));
  ASSERT_NEAR(pair[0], static_cast<double>(first), tolerance) << std::hex << bits;
  ASSERT_NEAR(pair[1], static_cast<double>(second), tolerance) << std::hex << bits;
}

TEST(SimulationRandom, RandomBits_AgreeWithLongDouble) {
  for (const std::uint64_t radius_bits :
       {0x0ull, 0x1ull, 0xffull, 0x7fffffffffull, 0x8000000000ull, 0xb504f333f9ull, 0xb504f333faull, 0xffffffffffull}) {
    for (const std::uint64_t angle_bits : {0x0ull, 0x1fffffull, 0x200000ull, 0x3fffffull, 0x400000ull, 0x5a5a5aull,
                                           0x800000ull, 0xc00000ull, 0xffffffull})
      expect_near_reference(radius_bits << 24 | angle_bits);
  }
  for (std::uint64_t i = 0; i < 200'000; ++i) expect_near_reference(i * 0x9e3779b97f4a7c15u);
}

// In sequence, with gaps, backwards and at the ends of the range of steps.
TEST(SimulationRandom, StepsInAnyOrder_GiveTheDrawsOfTheirCounters) {
  NormalDraws draws(0x0123456789abcdef, 77, 5);
  for (const std::uint32_t step : {0u, 1u, 2u, 3u, 4u, 5u, 9u, 22u, 21u, 20u, 0u, 3u, 0xfffffffeu, 0xffffffffu})
    EXPECT_EQ(draws(step), standard_normal({0x0123456789abcdef, 77, 5, step})) << step;
}

// Philox of the counter {block, person, reach, stream + 1}: 64 bits for one uniform draw or two normal ones.
TEST(SimulationDraws, EachDraw_TakesHalfABlock) {
  const auto half = [](std::uint32_t block, std::size_t index) {
    const PhiloxBlock words = philox({block, 3, 4, 3}, 7);
    return static_cast<std::uint64_t>(words[2 * index + 1]) << 32 | words[2 * index];
  };
  Draws draws(7, 2, 3, 4);
  EXPECT_EQ(draws.uniform(), static_cast<double>(half(0, 0) >> 11) * 0x1p-53);
  const auto [first, second] = normal_pair(half(0, 1));
  EXPECT_EQ(draws.normal(), first);
  EXPECT_EQ(draws.uniform(), static_cast<double>(half(1, 0) >> 11) * 0x1p-53);
  EXPECT_EQ(draws.normal(), second);
  EXPECT_EQ(draws.normal(), normal_pair(half(1, 1))[0]);
}

}  // namespace
}  // namespace hrt
