// The generator and the normal transform behind random.h, for one draw or for several at a time (lanes.h).
// Built of the four operations, the square root, comparisons and moves of bits alone, so that the bits of a
// draw depend neither on the compiler nor on a mathematics library.
#pragma once

#include <array>
#include <cstdint>

#include "core/simulation/lanes.h"

namespace hrt {

/// The ten round keys of Philox 4x32-10 for one seed.
template <class Lanes>
class PhiloxKeys {
 public:
  struct Round {
    typename Lanes::Words first;
    typename Lanes::Words second;
  };

  explicit PhiloxKeys(std::uint64_t seed) {
    auto first = static_cast<std::uint32_t>(seed);
    auto second = static_cast<std::uint32_t>(seed >> 32);
    for (Round& round : rounds_) {
      round = {Lanes::all(std::uint64_t{first}), Lanes::all(std::uint64_t{second})};
      first += 0x9E3779B9u;
      second += 0xBB67AE85u;
    }
  }

  const std::array<Round, 10>& rounds() const { return rounds_; }

 private:
  std::array<Round, 10> rounds_;
};

/// The four 32-bit words of one block as two numbers of 64 bits: word 1 above word 0, word 3 above word 2.
template <class Lanes>
struct RandomBlock {
  typename Lanes::Words first;
  typename Lanes::Words second;
};

/// Philox 4x32-10 (Salmon, Moraes, Dror, Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC11) of the
/// counter words 0 to 3, each below 2^32.
template <class Lanes>
[[gnu::always_inline]] inline RandomBlock<Lanes> philox(const PhiloxKeys<Lanes>& keys, typename Lanes::Words word0,
                                                        typename Lanes::Words word1, typename Lanes::Words word2,
                                                        typename Lanes::Words word3) {
  using Words = typename Lanes::Words;
  const Words multiplier0 = Lanes::all(std::uint64_t{0xD2511F53});
  const Words multiplier1 = Lanes::all(std::uint64_t{0xCD9E8D57});
  // Only the low half of each word counts; the high half is not cleared until the end.
  for (const typename PhiloxKeys<Lanes>::Round& round : keys.rounds()) {
    const Words product0 = Lanes::multiply_low(word0, multiplier0);
    const Words product1 = Lanes::multiply_low(word2, multiplier1);
    word0 = (product1 >> 32) ^ word1 ^ round.first;
    word2 = (product0 >> 32) ^ word3 ^ round.second;
    word1 = product1;
    word3 = product0;
  }
  const Words low_half = Lanes::all(std::uint64_t{0xffffffff});
  return {(word1 << 32) | (word0 & low_half), (word3 << 32) | (word2 & low_half)};
}

/// Two independent draws from N(0, 1).
template <class Lanes>
struct NormalPair {
  typename Lanes::Reals first;
  typename Lanes::Reals second;
};

namespace random_detail {

// sin(pi/2 x) = x (c_0 + c_1 x^2 + ...) and cos(pi/2 x) = c_0 + c_1 x^2 + ...: the Taylor series, whose
// remainder is below 1e-15 for |x| <= 1/2. `power` of the first term: 1 for the sine, 0 for the cosine.
constexpr std::array<double, 8> circular_series(int power) {
  constexpr double half_pi = 1.5707963267948966;
  std::array<double, 8> series{};
  double term = power == 1 ? half_pi : 1.0;
  for (double& coefficient : series) {
    coefficient = term;
    term *= -half_pi * half_pi / ((power + 1) * (power + 2));
    power += 2;
  }
  return series;
}
inline constexpr std::array<double, 8> sine_series = circular_series(1);
inline constexpr std::array<double, 8> cosine_series = circular_series(0);

// -2 ln((1 + s) / (1 - s)) = s (c_0 + c_1 s^2 + ...), |s| <= 0.1716: minus twice the minimax series of Sun's
// fdlibm (e_log.c), of relative error below 2^-58.
inline constexpr std::array<double, 8> logarithm_series = {
    -4.0,
    -2.0 * 6.666666666666735130e-01,
    -2.0 * 3.999999999940941908e-01,
    -2.0 * 2.857142874366239149e-01,
    -2.0 * 2.222219843214978396e-01,
    -2.0 * 1.818357216161805012e-01,
    -2.0 * 1.531383769920937332e-01,
    -2.0 * 1.479819860511658591e-01,
};

template <class Lanes>
[[gnu::always_inline]] inline typename Lanes::Reals polynomial(typename Lanes::Reals x,
                                                               const std::array<double, 8>& coefficients) {
  typename Lanes::Reals value = Lanes::all(coefficients[7]);
  for (int i = 6; i >= 0; --i) value = value * x + Lanes::all(coefficients[i]);
  return value;
}

// -2 ln(x) for normal x in (0, 1].
template <class Lanes>
[[gnu::always_inline]] inline typename Lanes::Reals minus_two_logarithm(typename Lanes::Reals x) {
  using Reals = typename Lanes::Reals;
  using Words = typename Lanes::Words;
  // x = 2^exponent m, m in [sqrt(1/2), sqrt(2)): the exponent field counts from sqrt(1/2) once its bits
  // are shifted to where those of 1 are.
  constexpr std::uint64_t bits_of_one = 0x3ff0000000000000;
  constexpr std::uint64_t bits_of_root_half = 0x3fe6a09e667f3bcd;
  const Words shifted = Lanes::as_words(x) + Lanes::all(bits_of_one - bits_of_root_half);
  // An integer below 2^52 becomes a double by its place in the fraction of 2^52.
  const Reals exponent =
      Lanes::as_reals((shifted >> 52) | Lanes::all(std::uint64_t{0x4330000000000000})) - Lanes::all(0x1p52 + 1023);
  const Reals m =
      Lanes::as_reals((shifted & Lanes::all(std::uint64_t{0x000fffffffffffff})) + Lanes::all(bits_of_root_half));
  const Reals f = m - Lanes::all(1.0);
  const Reals s = f / (m + Lanes::all(1.0));
  return exponent * Lanes::all(-2.0 * 0.6931471805599453) + s * polynomial<Lanes>(s * s, logarithm_series);
}

}  // namespace random_detail

/// Two draws from N(0, 1) out of 64 random bits (Box and Muller): 40 bits for the radius, so that the tails
/// are true to 7.5, and 24 for the angle.
template <class Lanes>
[[gnu::always_inline]] inline NormalPair<Lanes> normal_pair(typename Lanes::Words bits) {
  using Reals = typename Lanes::Reals;
  using Words = typename Lanes::Words;
  const Words one = Lanes::all(std::uint64_t{0x3ff0000000000000});

  // The middle of one of 2^40 equal cells of (0, 1), the bits being the fraction of a number in [1, 2).
  const Words cell = (bits >> 12) & Lanes::all(std::uint64_t{0x000ffffffffff000});
  const Reals uniform = Lanes::as_reals(cell | one | Lanes::all(std::uint64_t{0x800})) - Lanes::all(1.0);
  const Reals radius = Lanes::square_root(random_detail::minus_two_logarithm<Lanes>(uniform));

  // The angle: 22 bits within +-1/2 of a quarter turn, one bit that adds half a turn and one that swaps sine
  // and cosine make the four quarters of the circle.
  const Words quarter_cell = (bits & Lanes::all(std::uint64_t{0x3fffff})) << 30;
  const Reals quarters = Lanes::as_reals(quarter_cell | one | Lanes::all(std::uint64_t{0x20000000})) - Lanes::all(1.5);
  const Reals square = quarters * quarters;
  const Reals sine = quarters * random_detail::polynomial<Lanes>(square, random_detail::sine_series);
  const Reals cosine = random_detail::polynomial<Lanes>(square, random_detail::cosine_series);
  const Words sign = (bits << 41) & Lanes::all(std::uint64_t{0x8000000000000000});
  const Words swap = Lanes::all(std::uint64_t{0}) - ((bits >> 23) & Lanes::all(std::uint64_t{1}));
  const Words sine_bits = Lanes::as_words(sine);
  const Words cosine_bits = Lanes::as_words(cosine) ^ sign;
  const Words exchanged = (sine_bits ^ cosine_bits) & swap;
  return {radius * Lanes::as_reals(cosine_bits ^ exchanged), radius * Lanes::as_reals(sine_bits ^ exchanged)};
}

}  // namespace hrt
