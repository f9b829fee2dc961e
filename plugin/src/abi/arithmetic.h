// Sets the floating-point mode in which the library is tested, and restores the mode of the host's thread. With another
// rounding mode, results would differ in their last bits; a trap would terminate the host at an intermediate infinity.
#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace hrt::plugin {

/// During its lifetime, arithmetic rounds to nearest and, with SSE, floating-point exceptions are masked.
class FloatingPointModeGuard {
 public:
  FloatingPointModeGuard() {
    if (host_mode_ != library_mode) set(library_mode);
  }
  ~FloatingPointModeGuard() {
    if (host_mode_ != library_mode) set(host_mode_);
  }
  FloatingPointModeGuard(const FloatingPointModeGuard&) = delete;
  FloatingPointModeGuard& operator=(const FloatingPointModeGuard&) = delete;

 private:
#if defined(__SSE2__)  // the library computes by SSE; fegetround() would return the mode of the x87
  using Mode = unsigned;
  static constexpr Mode mode_bits = _MM_ROUND_MASK | _MM_MASK_MASK;
  static constexpr Mode library_mode = _MM_ROUND_NEAREST | _MM_MASK_MASK;
  static Mode get() { return _mm_getcsr() & mode_bits; }
#else
  using Mode = int;
  static constexpr Mode library_mode = FE_TONEAREST;
  static Mode get() { return std::fegetround(); }
#endif
  static void set(Mode mode);

  Mode host_mode_ = get();
};

}  // namespace hrt::plugin
