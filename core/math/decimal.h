// Formats numbers for messages, independent of the locale.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>

namespace hrt {

/// Returns `value` rounded to `decimals` places, 0 to 3; "more than 1000000000" if |value| >= 1e9 or `value` is NaN.
inline std::string decimal(double value, int decimals) {
  constexpr std::int64_t units[] = {1, 10, 100, 1000};
  const std::int64_t unit = units[decimals];
  if (!(std::abs(value) < 1e9)) return "more than 1000000000";
  const std::int64_t number = std::llround(std::abs(value) * static_cast<double>(unit));
  // Not "." + std::string, in which gcc 12 wrongly reports an overflow.
  std::string text = value < 0.0 && number > 0 ? "-" : "";
  text += std::to_string(number / unit);
  if (decimals > 0) text.append(".").append(std::to_string(unit + number % unit), 1);
  return text;
}

}  // namespace hrt
