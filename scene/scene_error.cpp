#include "scene/scene_error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>

namespace hrt {

std::string printable(std::string_view text) {
  std::string result(text);
  std::replace_if(
      result.begin(), result.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; },
      '?');
  return result;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 80;
  std::size_t end = std::min(longest, text.size());
  // Not within a UTF-8 character, whose further bytes are 10xxxxxx.
  while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) {
    --end;
  }
  std::string result = "\"";
  result += printable(text.substr(0, end));
  return result += end < text.size() ? "...\"" : "\"";
}

std::string number_text(double value) {
  std::array<char, 32> digits{};
#if defined(__cpp_lib_to_chars)
  const auto written =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 6);
  return {digits.data(), written.ptr};
#else  // of integers alone; the same in the "C" locale
  const int length = std::snprintf(digits.data(), digits.size(), "%g", value);
  return {digits.data(), static_cast<std::size_t>(length)};
#endif
}

std::string in_brackets(std::size_t index) {
  std::string result = "[";
  result += std::to_string(index);
  return result += "]";
}

}  // namespace hrt
