#include "plugin/src/abi/error.h"

#include "plugin/src/abi/arithmetic.h"

namespace hrt::plugin {

thread_local constinit ThreadError thread_error;

// Not inline, so that the compiler does not move computations before the change of the mode.
void FloatingPointModeGuard::set(Mode mode) {
#if defined(__SSE2__)
  _mm_setcsr((_mm_getcsr() & ~mode_bits) | mode);
#else
  std::fesetround(mode);
#endif
}

}  // namespace hrt::plugin
