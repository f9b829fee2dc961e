// Numbers of nlohmann's parser, whatever the locale.
#pragma once

#include <cstddef>
#include <string>

namespace hrt {

/// A number that is not whole, with a point: the parser has put the locale's decimal point into its text, and
/// read its value by that.
inline std::string with_point(std::string number) {
  const std::size_t point = number.find_first_not_of("+-0123456789eE");
  if (point != number.npos) number[point] = '.';
  return number;
}

}  // namespace hrt
