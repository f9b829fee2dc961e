#include "scene/scene_error.h"

#include <algorithm>

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
  std::string result = "\"";
  result += printable(text.substr(0, longest));
  return result += text.size() > longest ? "...\"" : "\"";
}

std::string in_brackets(std::size_t index) {
  std::string result = "[";
  result += std::to_string(index);
  return result += "]";
}

}  // namespace hrt
