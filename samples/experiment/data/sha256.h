// SHA-256 (FIPS 180-4).
#pragma once

#include <string>
#include <string_view>

namespace hrt::experiment {

/// In hexadecimal.
std::string sha256_of(std::string_view text);

}  // namespace hrt::experiment
