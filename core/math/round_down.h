// The largest integer that is not above a number.
#pragma once

namespace hrt {

/// std::floor() in half its instructions, on processors of which SSE4.1 is not known. |x| < 2^51.
inline double round_down(double x) {
  constexpr double to_integer = 0x1.8p52;  // a sum with it has no room for a fraction
  const double near = (x + to_integer) - to_integer;
  return near - static_cast<double>(near > x);
}

}  // namespace hrt
