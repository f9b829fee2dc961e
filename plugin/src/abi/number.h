// Numbers as text, whatever the locale: every double reads back to the same bits. No heap: real-time.
#pragma once

#include <charconv>
#include <cstddef>
#include <string_view>

namespace hrt::plugin {

/// Room for any number that write_number() writes.
inline constexpr std::size_t max_number = 32;

/// Writes the shortest text that reads back as the same finite number. Returns its length.
std::size_t write_number(double number, char (&out)[max_number]);

/// Whether all of `text` is a number that a double can hold: digits with at most one point, with or without
/// an exponent; or inf, nan. `*out` changes only then.
bool read_number(std::string_view text, double* out);

/// Whether all of `text` is a whole number.
template <class Integer>
bool read_number(std::string_view text, Integer* out) {
  Integer number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return false;
  *out = number;
  return true;
}

}  // namespace hrt::plugin
