#include "samples/mock_runtime/capture/record.h"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace hrt::capture {

std::string text_of(double value) {
  if (!std::isfinite(value)) return fmt::format("\"{:016x}\"", std::bit_cast<std::uint64_t>(value));
  // "-0" would be an integer, which has no sign.
  if (value == 0.0 && std::signbit(value)) return "-0.0";
  return fmt::format("{}", value);
}

std::string text_of(float value) {
  if (!std::isfinite(value)) return fmt::format("\"{:08x}\"", std::bit_cast<std::uint32_t>(value));
  if (value == 0.0F && std::signbit(value)) return "-0.0";
  const std::string shortest = fmt::format("{}", value);
  // The playback reads a double and rounds it: twice rounded, a few decimals are another float.
  double read = 0.0;
  std::from_chars(shortest.data(), shortest.data() + shortest.size(), read);
  return static_cast<float>(read) == value ? shortest : text_of(static_cast<double>(value));
}

void Record::put_token(std::string_view token) {
  if (text_.back() != '[') text_ += ',';
  text_ += token;
}

void Record::put(std::string_view value) {
  put_token(nlohmann::json(value).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace));
}

Record& Record::open() {
  put_token("[");
  return *this;
}

Record& Record::close() {
  text_ += ']';
  return *this;
}

}  // namespace hrt::capture
