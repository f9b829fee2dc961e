// Columns of text, whose width is counted in characters of UTF-8; fields of CSV; and escapes of HTML.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace hrt {

std::size_t length_of(std::string_view text);

/// The first `length` characters, or all of a shorter text.
std::string cut_to(std::string_view text, std::size_t length);

/// `text` padded with spaces to at least `width` characters: right() pads before it, left() after it.
std::string right(std::string_view text, std::size_t width);
std::string left(std::string_view text, std::size_t width);

/// `text` wrapped at words into lines of at most `width` characters; a longer word has a line of its own.
std::string wrapped(const std::string& text, std::size_t width);

/// `text` as a field of CSV: in quotes if it has a comma, a quote or a line end.
std::string csv_field(std::string_view text);

/// The fields of a line of CSV, without the quotes that R and Excel write around them, and without spaces around each.
std::vector<std::string> csv_fields(std::string_view line);

/// The byte order mark that some editors write first.
inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// `text` escaped for HTML or XML, including attributes; control characters except line ends become '?'.
std::string escaped(std::string_view text);

}  // namespace hrt
