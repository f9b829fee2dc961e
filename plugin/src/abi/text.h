// Text in a buffer of fixed size, and conversion of numbers to text and back, without heap or locale.
#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "plugin/src/abi/utf8.h"

namespace hrt::plugin {

/// Maximum length of a number that write_number() writes.
inline constexpr std::size_t max_number = 32;

/// Writes the shortest text that reads back as the same finite number. Returns its length.
std::size_t write_number(double number, char (&out)[max_number]);

/// Reads `text` as a number: digits with at most one point, with or without minus and exponent; or inf, nan. Returns
/// false and does not change `*out` if `text` has any other form, or if the number is too large for a double.
bool read_number(std::string_view text, double* out);

/// Reads a decimal integer. Returns false and does not change `*out` if `text` is not one in the range of Integer.
template <class Integer>
bool read_number(std::string_view text, Integer* out) {
  Integer number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return false;
  *out = number;
  return true;
}

/// A name, key or path in a message: truncated after 64 bytes, so that the rest of the message fits.
struct Shown {
  std::string_view text;
};

/// A text in a buffer of `capacity` bytes. Characters that do not fit are dropped.
template <std::size_t capacity>
class Text {
 public:
  void clear() { text_[length_ = 0] = '\0'; }
  const char* c_str() const { return text_; }
  std::string_view view() const { return {text_, length_}; }

  Text& operator<<(std::string_view part) {
    if (part.empty()) return *this;  // its data() may be null, which memcpy() does not allow
    const std::string_view taken = utf8_beginning(part, capacity - 1 - length_);
    std::memcpy(text_ + length_, taken.data(), taken.size());
    text_[length_ += taken.size()] = '\0';
    return *this;
  }

  Text& operator<<(Shown shown) {
    const std::string_view beginning = utf8_beginning(shown.text, 64);
    return *this << beginning << (beginning.size() < shown.text.size() ? "..." : "");
  }

  /// Appends a number in its shortest form, or NaN, Inf or -Inf.
  template <class Number>
    requires std::is_arithmetic_v<Number>
  Text& operator<<(Number number) {
    if constexpr (std::is_floating_point_v<Number>) {
      if (std::isnan(number)) return *this << std::string_view("NaN");
      if (std::isinf(number)) return *this << std::string_view(number > 0 ? "Inf" : "-Inf");
      char digits[max_number];
      return *this << std::string_view(digits, write_number(double{number}, digits));
    } else {
      char digits[32];
      const auto [end, error] = std::to_chars(digits, digits + sizeof digits, number);
      return error == std::errc() ? *this << std::string_view(digits, static_cast<std::size_t>(end - digits)) : *this;
    }
  }

  /// Replaces control characters, and bytes that are not UTF-8, by '?'.
  void make_printable() {
    for (std::size_t i = 0; i < length_;) {
      const std::size_t size = utf8_character_size(view().substr(i)), taken = size == 0 ? 1 : size;
      if (size == 0 || begins_with_control_character(view().substr(i))) std::memset(text_ + i, '?', taken);
      i += taken;
    }
  }

 private:
  char text_[capacity]{};
  std::size_t length_ = 0;
};

}  // namespace hrt::plugin
