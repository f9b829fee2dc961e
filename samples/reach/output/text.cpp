#include "samples/reach/output/text.h"

#include <algorithm>

namespace hrt::reach {
namespace {

// Every byte of a character but the first is 10xxxxxx.
bool starts_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
}

}  // namespace

std::size_t length_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), starts_character));
}

std::string cut_to(const std::string& text, std::size_t length) {
  std::size_t characters = 0;
  const auto end = std::find_if(text.begin(), text.end(),
                                [&](char byte) { return starts_character(byte) && ++characters > length; });
  return {text.begin(), end};
}

std::string padded_to(const std::string& text, std::size_t length) {
  std::string result = cut_to(text, length);
  result.append(length - length_of(result), ' ');
  return result;
}

}  // namespace hrt::reach
