// Messages of refusal.
#pragma once

#include <cstddef>
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

/// `text` in double quotes for a message: printable, cut after at most 80 bytes.
std::string in_quotes(std::string_view text);

/// A number for a message: six digits, in the "C" locale.
std::string number_text(double value);

/// An index as `[7]`: stands for a missing name.
std::string in_brackets(std::size_t index);

}  // namespace hrt
