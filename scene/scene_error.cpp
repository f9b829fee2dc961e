#include "scene/scene_error.h"

namespace hrt {

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 80;
  std::string result = "\"";
  for (const char c : text.substr(0, longest)) {
    const bool is_control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    result += is_control ? '?' : c;
  }
  return result + (text.size() > longest ? "...\"" : "\"");
}

std::string in_brackets(std::size_t index) {
  std::string result = "[";
  result += std::to_string(index);
  return result += "]";
}

}  // namespace hrt
