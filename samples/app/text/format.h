// Conversion of numbers to text, with printf formats, and back.
#pragma once

#include <charconv>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace hrt {

/// Formats as printf does; the result is cut after 511 bytes.
template <class... Values>
std::string format(const char* pattern, Values... values) {
  char text[512];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

/// Parses all of `text`, independently of the locale. Returns nothing unless it is a number in [low, high].
inline std::optional<double> number_in(std::string_view text, double low, double high) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  return is_number && value >= low && value <= high ? std::optional(value) : std::nullopt;
}

}  // namespace hrt
