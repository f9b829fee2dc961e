#include "scene/scene_error.h"

#include <fmt/format.h>

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
  const std::string shown = fmt::format("{:.80}", text);
  return fmt::format("\"{}{}\"", printable(shown), shown.size() < text.size() ? "..." : "");
}

}  // namespace hrt
