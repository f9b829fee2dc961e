// Sets the arithmetic with which the library is tested, and restores that of the host's thread: another rounding would
// give other bits, and a trap would end the host at an intermediate infinity.
#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace hrt::plugin {

/// Rounds to nearest and, with SSE, traps nothing while it lives. Costs a few nanoseconds where the host does so too.
class OurArithmetic {
 public:
  OurArithmetic() {
    if (host_mode_ != our_mode) set(our_mode);
  }
  ~OurArithmetic() {
    if (host_mode_ != our_mode) set(host_mode_);
  }
  OurArithmetic(const OurArithmetic&) = delete;
  OurArithmetic& operator=(const OurArithmetic&) = delete;

 private:
#if defined(__SSE2__)  // the mode of SSE, in which this code computes; fegetround() would query the x87
  using Mode = unsigned;
  static constexpr Mode mode_bits = _MM_ROUND_MASK | _MM_MASK_MASK;
  static constexpr Mode our_mode = _MM_ROUND_NEAREST | _MM_MASK_MASK;
  static Mode get() { return _mm_getcsr() & mode_bits; }
#else
  using Mode = int;
  static constexpr Mode our_mode = FE_TONEAREST;
  static Mode get() { return std::fegetround(); }
#endif
  static void set(Mode mode);

  Mode host_mode_ = get();
};

}  // namespace hrt::plugin
