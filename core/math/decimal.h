// Formats numbers for messages, independent of the locale.
#pragma once

#include <cmath>
#include <string>

namespace hrt {

/// Returns `value` rounded to `decimals` places, 0 to 3; "more than 1000000000" if |value| >= 1e9 or `value` is NaN.
inline std::string decimal(double value, int decimals) {
  constexpr long units[] = {1, 10, 100, 1000};
  const long unit = units[decimals];
  if (!(std::abs(value) < 1e9)) return "more than 1000000000";
  const long number = std::lround(std::abs(value) * static_cast<double>(unit));
  std::string text = (value < 0.0 && number > 0 ? "-" : "") + std::to_string(number / unit);
  if (decimals > 0) text += "." + std::to_string(unit + number % unit).substr(1);
  return text;
}

}  // namespace hrt
