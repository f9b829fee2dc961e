#include "samples/experiment/data/sha256.h"

#include <sha2.h>

#include <array>
#include <cstdint>

namespace hrt::experiment {

std::string sha256_of(std::string_view text) {
  std::array<char, SHA256_DIGEST_STRING_LENGTH> digits{};
  SHA256Data(reinterpret_cast<const std::uint8_t*>(text.data()), text.size(), digits.data());
  return digits.data();
}

}  // namespace hrt::experiment
