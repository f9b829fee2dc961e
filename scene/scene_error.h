// Messages of refusal.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

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

}  // namespace hrt
