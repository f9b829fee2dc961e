// Numbers as text, by printf.
#pragma once

#include <cstdio>
#include <string>

namespace hrt::reach {

/// printf into a string, cut after 511 bytes.
template <class... Values>
std::string format(const char* pattern, Values... values) {
  char text[512];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

}  // namespace hrt::reach
