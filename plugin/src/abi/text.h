// A line of text in a fixed buffer: no heap, no locale. What does not fit is cut off.
#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "plugin/src/abi/number.h"

namespace hrt::plugin {

template <std::size_t capacity>
class Text {
 public:
  void clear() { text_[length_ = 0] = '\0'; }
  const char* c_str() const { return text_; }
  std::string_view view() const { return {text_, length_}; }

  Text& operator<<(std::string_view part) {
    if (part.empty()) return *this;  // whose data may be null
    const std::size_t room = capacity - 1 - length_;
    const std::size_t taken = part.size() < room ? part.size() : room;
    std::memcpy(text_ + length_, part.data(), taken);
    text_[length_ += taken] = '\0';
    return *this;
  }

  /// The shortest text that reads back as the same number; NaN, Inf and -Inf.
  template <class Number>
  requires std::is_arithmetic_v<Number> Text& operator<<(Number number) {
    if constexpr (std::is_floating_point_v<Number>) {
      if (std::isnan(number)) return *this << std::string_view("NaN");
      if (std::isinf(number)) return *this << std::string_view(number > 0 ? "Inf" : "-Inf");
      char digits[longest_number];
      return *this << std::string_view(digits, write_number(double{number}, digits));
    } else {
      char digits[32];
      const auto [end, error] = std::to_chars(digits, digits + sizeof digits, number);
      return error == std::errc() ? *this << std::string_view(digits, static_cast<std::size_t>(end - digits))
                                  : *this;
    }
  }

 private:
  char text_[capacity]{};
  std::size_t length_ = 0;
};

}  // namespace hrt::plugin
