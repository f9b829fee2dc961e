#include "plugin/src/abi/text.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <cmath>

namespace hrt::plugin {

std::size_t write_number(double number, char (&out)[max_number]) {
  return static_cast<std::size_t>(fmt::format_to(out, "{}", number) - out);
}

bool read_number(std::string_view text, double* out) {
  const char* const end = text.data() + text.size();
  double number = 0.0;
  const auto [stopped_at, error] = fast_float::from_chars(text.data(), end, number);
  if (error != std::errc() || stopped_at != end) return false;
  const bool overflowed = std::isinf(number) && text.find_first_of("0123456789") != text.npos;
  if (overflowed) return false;
  *out = number;
  return true;
}

}  // namespace hrt::plugin
