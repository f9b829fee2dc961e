// Doubles as decimal texts, to the last bit: std::to_chars() and std::from_chars(), also where the C++
// library has them for integers alone.
#pragma once

#include <charconv>
#include <cstddef>
#include <string_view>

namespace hrt::plugin {

/// Room for any number that write_decimal() writes.
inline constexpr std::size_t longest_decimal = 32;

/// What they stand for, in C's functions. Not in another locale than "C".
namespace in_c {
std::size_t write_decimal(double number, char (&out)[longest_decimal]);
bool read_decimal(std::string_view text, double* out);
}  // namespace in_c

/// The shortest text that reads back as the same finite number, of such texts the nearest, and of its fixed
/// and its scientific form the shorter. Returns its length.
inline std::size_t write_decimal(double number, char (&out)[longest_decimal]) {
#if defined(__cpp_lib_to_chars)
  return static_cast<std::size_t>(std::to_chars(out, out + longest_decimal, number).ptr - out);
#else
  return in_c::write_decimal(number, out);
#endif
}

/// Whether all of `text` is a number: digits with at most one point, with or without an exponent; or inf,
/// nan.
inline bool read_decimal(std::string_view text, double* out) {
#if defined(__cpp_lib_to_chars)
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), *out);
  return error == std::errc() && end == text.data() + text.size();
#else
  return in_c::read_decimal(text, out);
#endif
}

/// Whether all of `text` is a whole number.
template <class Integer>
bool read_decimal(std::string_view text, Integer* out) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), *out);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace hrt::plugin
