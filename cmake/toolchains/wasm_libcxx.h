// Parts of C++20 that the C++ library of emscripten 3.1.6 lacks, included before every C++ source for WebAssembly.
#pragma once

#if defined(__cplusplus)
#include <version>
#if !defined(__cpp_lib_bit_cast)
namespace std {
template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}
}  // namespace std
#endif
#endif
