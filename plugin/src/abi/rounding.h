// Rounding to nearest, whatever the host has set for its thread: other modes would give other bits.
#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace hrt::plugin {

/// Rounds to nearest while it lives. Costs a few nanoseconds where the host does so too.
class NearestRounding {
 public:
  NearestRounding() {
    if (host_mode_ != nearest) set(nearest);
  }
  ~NearestRounding() {
    if (host_mode_ != nearest) set(host_mode_);
  }
  NearestRounding(const NearestRounding&) = delete;
  NearestRounding& operator=(const NearestRounding&) = delete;

 private:
#if defined(__SSE2__)  // the mode of what computes here; fegetround() would ask the other unit
  using Mode = unsigned;
  static constexpr Mode nearest = _MM_ROUND_NEAREST;
  static Mode get() { return _mm_getcsr() & _MM_ROUND_MASK; }
#else
  using Mode = int;
  static constexpr Mode nearest = FE_TONEAREST;
  static Mode get() { return std::fegetround(); }
#endif
  static void set(Mode mode);

  Mode host_mode_ = get();
};

}  // namespace hrt::plugin
