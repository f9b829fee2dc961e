// Text in columns: UTF-8, counted in characters.
#pragma once

#include <cstddef>
#include <string>

namespace hrt::reach {

std::size_t length_of(const std::string& text);

/// The first `length` characters, or all of a shorter text.
std::string cut_to(const std::string& text, std::size_t length);

/// cut_to(), and filled up with spaces.
std::string padded_to(const std::string& text, std::size_t length);

}  // namespace hrt::reach
