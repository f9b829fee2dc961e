#pragma once

#include <fmt/format.h>

#include <cstddef>
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

/// Returns `text`, in UTF-8, with each byte of the control characters U+0000 to U+001F and U+007F to U+009F replaced by
/// '?'.
inline std::string printable(std::string text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(at < text.size() ? text[at] : 0); };
    if (byte(i) < 0x20 || byte(i) == 0x7f) text[i] = '?';
    if (byte(i) == 0xc2 && byte(i + 1) >= 0x80 && byte(i + 1) < 0xa0) text[i] = text[i + 1] = '?';
  }
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
