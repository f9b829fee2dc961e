#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace hrt {

/// Error of a file that is not a usable scene: one line that names the file and, for a mistake in a node, the node.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline bool is_control_character(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// Returns `text` with control characters replaced by '?'.
inline std::string printable(std::string text) {
  std::replace_if(text.begin(), text.end(), is_control_character, '?');
  return text;
}

/// Returns `text` in double quotes for an error text: printable, truncated after 80 characters of UTF-8.
inline std::string in_quotes(std::string_view text) {
  const std::string shown = fmt::format("{:.80}", text);
  return fmt::format("\"{}{}\"", printable(shown), shown.size() < text.size() ? "..." : "");
}

/// Throws SceneError. `where` names the file, or a node of it.
template <class... Parts>
[[noreturn]] void refuse(std::string_view where, fmt::format_string<Parts...> what, Parts&&... parts) {
  throw SceneError(fmt::format("{}: {}", where, fmt::format(what, std::forward<Parts>(parts)...)));
}

}  // namespace hrt
