// Searches in texts, for tests.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <string>

namespace hrt {

/// True if `text` contains `part`; a failed expectation shows the text.
inline testing::AssertionResult has(const std::string& text, const std::string& part) {
  const bool found = text.find(part) != std::string::npos;
  return (found ? testing::AssertionSuccess() : testing::AssertionFailure())
         << "\"" << part << "\" is" << (found ? "" : " not") << " in\n"
         << text;
}

inline testing::AssertionResult has(const std::string& text, std::initializer_list<const char*> parts) {
  for (const char* part : parts)
    if (const testing::AssertionResult one = has(text, std::string(part)); !one) return one;
  return testing::AssertionSuccess();
}

/// Number of occurrences, including overlapping ones.
inline std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// Number after a name in a text; NaN if there is no such number.
inline double value_of(const std::string& text, const std::string& name) {
  const std::size_t at = text.find(name);
  double value = std::nan("");
  if (at != std::string::npos) std::sscanf(text.c_str() + at + name.size(), "%lf", &value);
  return value;
}

}  // namespace hrt
