// Arithmetic on several doubles at a time. Code that is written as a template over Lanes runs on single
// numbers (ScalarLanes), on pairs (PairLanes) or on fours (QuadLanes), and gives the same bits on all: every
// operation is IEEE's.
//
// PairLanes is SSE2 on x86-64 and what the compiler makes of its vector types elsewhere; where a compiler
// has none, it is ScalarLanes. QuadLanes is AVX2, and is used only by sources that are compiled for it.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace hrt {

struct ScalarLanes {
  using Reals = double;
  using Words = std::uint64_t;
  static constexpr int count = 1;

  static Reals all(double x) { return x; }
  static Words all(std::uint64_t x) { return x; }
  static Reals load(const double* from) { return *from; }
  static Words load(const std::uint64_t* from) { return *from; }
  static void store(double* to, Reals x) { *to = x; }
  static void store(std::uint64_t* to, Words x) { *to = x; }
  static Reals as_reals(Words x) { return std::bit_cast<double>(x); }
  static Words as_words(Reals x) { return std::bit_cast<std::uint64_t>(x); }
  static Reals square_root(Reals x) { return std::sqrt(x); }
  static Reals larger(Reals a, Reals b) { return a > b ? a : b; }
  /// All bits where a <= b, none elsewhere.
  static Words less_equal(Reals a, Reals b) { return a <= b ? ~std::uint64_t{0} : 0; }
  /// Product of the low 32 bits of each.
  static Words multiply_low(Words a, Words b) { return (a & 0xffffffffu) * (b & 0xffffffffu); }
};

#if defined(__GNUC__)

// Of vector types of the compiler's.
template <class RealVector, class WordVector>
struct VectorLanes {
  using Reals = RealVector;
  using Words = WordVector;
  static constexpr int count = sizeof(Reals) / sizeof(double);

  static Reals all(double x) { return x - Reals{}; }  // of -0 too
  static Words all(std::uint64_t x) { return x + Words{}; }
  static Reals load(const double* from) {
    Reals x;
    std::memcpy(&x, from, sizeof x);
    return x;
  }
  static Words load(const std::uint64_t* from) {
    Words x;
    std::memcpy(&x, from, sizeof x);
    return x;
  }
  static void store(double* to, Reals x) { std::memcpy(to, &x, sizeof x); }
  static void store(std::uint64_t* to, Words x) { std::memcpy(to, &x, sizeof x); }
  static Reals as_reals(Words x) { return reinterpret_cast<Reals>(x); }
  static Words as_words(Reals x) { return reinterpret_cast<Words>(x); }
  static Words less_equal(Reals a, Reals b) { return reinterpret_cast<Words>(a <= b); }
  static Reals square_root(Reals x) {
    for (int i = 0; i < count; ++i) x[i] = std::sqrt(x[i]);
    return x;
  }
  static Reals larger(Reals a, Reals b) {
    for (int i = 0; i < count; ++i) a[i] = a[i] > b[i] ? a[i] : b[i];
    return a;
  }
  static Words multiply_low(Words a, Words b) { return (a & 0xffffffffu) * (b & 0xffffffffu); }
};

using TwoReals = double __attribute__((vector_size(16)));
using TwoWords = std::uint64_t __attribute__((vector_size(16)));
struct PairLanes : VectorLanes<TwoReals, TwoWords> {
#if defined(__SSE2__)
  static Reals square_root(Reals x) { return _mm_sqrt_pd(x); }
  static Reals larger(Reals a, Reals b) { return _mm_max_pd(a, b); }
  static Words multiply_low(Words a, Words b) {
    return reinterpret_cast<Words>(_mm_mul_epu32(reinterpret_cast<__m128i>(a), reinterpret_cast<__m128i>(b)));
  }
#endif
};

#if defined(__AVX2__)
using FourReals = double __attribute__((vector_size(32)));
using FourWords = std::uint64_t __attribute__((vector_size(32)));
struct QuadLanes : VectorLanes<FourReals, FourWords> {
  static Reals square_root(Reals x) { return _mm256_sqrt_pd(x); }
  static Reals larger(Reals a, Reals b) { return _mm256_max_pd(a, b); }
  static Words multiply_low(Words a, Words b) {
    return reinterpret_cast<Words>(_mm256_mul_epu32(reinterpret_cast<__m256i>(a), reinterpret_cast<__m256i>(b)));
  }
};
#else
struct QuadLanes;
#endif

#else

using PairLanes = ScalarLanes;

#endif

}  // namespace hrt
