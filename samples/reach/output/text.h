// Text: numbers by printf, columns of UTF-8 counted in characters.
#pragma once

#include <cstddef>
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

std::size_t length_of(const std::string& text);

/// The first `length` characters, or all of a shorter text.
std::string cut_to(const std::string& text, std::size_t length);

/// cut_to(), and filled up with spaces.
std::string padded_to(const std::string& text, std::size_t length);

}  // namespace hrt::reach
