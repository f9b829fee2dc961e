#include "samples/app/text/text.h"

#include <algorithm>
#include <sstream>

namespace hrt {
namespace {

// Every byte of a character but the first is 10xxxxxx.
bool starts_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }

std::string spaces(std::string_view text, std::size_t width) {
  return std::string(width - std::min(width, length_of(text)), ' ');
}

}  // namespace

std::size_t length_of(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), starts_character));
}

std::string cut_to(std::string_view text, std::size_t length) {
  std::size_t characters = 0;
  const auto end = std::find_if(text.begin(), text.end(),
                                [&](char byte) { return starts_character(byte) && ++characters > length; });
  return {text.begin(), end};
}

std::string right(std::string_view text, std::size_t width) { return spaces(text, width) += text; }

std::string left(std::string_view text, std::size_t width) { return std::string(text) += spaces(text, width); }

std::string wrapped(const std::string& text, std::size_t width) {
  std::string lines, line;
  std::istringstream words(text);
  for (std::string word; words >> word; line += (line.empty() ? "" : " ") + word) {
    if (line.empty() || length_of(line) + 1 + length_of(word) <= width) continue;
    lines += line + "\n";
    line.clear();
  }
  return lines + line;
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\n") == std::string_view::npos) return std::string(text);
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
  return field + '"';
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += static_cast<unsigned char>(c) < 0x20 && c != '\n' ? '?' : c;
    }
  }
  return result;
}

}  // namespace hrt
