#include "samples/app/text/text.h"

#include <algorithm>
#include <sstream>

namespace hrt {
namespace {

// In UTF-8, the bytes of a character after the first are 10xxxxxx.
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

std::vector<std::string> csv_fields(std::string_view line) {
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == ',' && !is_quoted)
      fields.emplace_back();
    else if (line[i] != '"' || (!is_quoted && i > 0 && line[i - 1] == '"'))  // two quotes in a field represent one
      fields.back() += line[i];
    if (line[i] == '"') is_quoted = !is_quoted;
  }
  for (std::string& field : fields) {
    field.erase(0, std::min(field.find_first_not_of(" \t"), field.size()));
    field.erase(field.find_last_not_of(" \t") + 1);
  }
  return fields;
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
