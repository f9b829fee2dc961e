#include "samples/mock_runtime/capture/record.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace hrt::capture {

Json number(double value) {
  if (std::isfinite(value)) return value;
  std::array<char, 17> bits{};
  std::snprintf(bits.data(), bits.size(), "%016llx",
                static_cast<unsigned long long>(std::bit_cast<std::uint64_t>(value)));
  return bits.data();
}

Json number(float value) {
  std::array<char, 32> text{};
  if (!std::isfinite(value)) {
    std::snprintf(text.data(), text.size(), "%08x", static_cast<unsigned>(std::bit_cast<std::uint32_t>(value)));
    return text.data();
  }
  // The playback reads a double and rounds it: rounded twice, a few shortest decimals are another float.
  double read = 0.0;
  std::from_chars(text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr, read);
  return static_cast<float>(read) == value ? read : static_cast<double>(value);
}

}  // namespace hrt::capture
