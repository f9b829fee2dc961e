// Messages of refusal.
#pragma once

#include <fmt/format.h>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace hrt {

/// Why a file is not a usable scene: one line that names the file, the node and the property.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// `text` with control characters as '?'.
std::string printable(std::string_view text);

/// `text` in double quotes for a message: printable, cut after 80 characters of UTF-8.
std::string in_quotes(std::string_view text);

/// Throws SceneError: `where` is the file, or a node of it.
template <class... Parts>
[[noreturn]] void refuse(std::string_view where, fmt::format_string<Parts...> what, Parts&&... parts) {
  throw SceneError(fmt::format("{}: {}", where, fmt::format(what, std::forward<Parts>(parts)...)));
}

}  // namespace hrt
