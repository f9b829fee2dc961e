#pragma once

#include <algorithm>
#include <random>
#include <string>

namespace hrt::plate {

/// Damages `line` (with its "\n") in one of the ways that the checksum or the fixed widths of protocol 2 always detect:
/// up to three flipped bits, a burst of up to 16 bits, two adjacent characters exchanged, a character lost, doubled or
/// inserted, the end cut off, or noise in front. The result ends with "\n" and differs from `line`.
inline std::string damaged(const std::string& line, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  for (;;) {
    std::string bad = line.substr(0, line.size() - 1);
    const auto flip = [&](std::size_t bit) { bad[bit / 8] = static_cast<char>(bad[bit / 8] ^ (1 << (bit % 8))); };
    const std::size_t at = below(bad.size());
    switch (below(7)) {
      case 0:
        for (std::size_t i = 0, count = 1 + below(3); i < count; ++i) flip(below(8 * bad.size()));
        break;
      case 1: {
        // Bits are in the order of the CRC: the first bit of a character is its highest.
        const std::size_t first = below(8 * bad.size() - 16);
        for (std::size_t i = 0, mask = 1 + below(65535); i < 16; ++i)
          if ((mask >> i & 1U) != 0) flip((first + i) / 8 * 8 + 7 - (first + i) % 8);
        break;
      }
      case 2:
        if (at + 1 < bad.size()) std::swap(bad[at], bad[at + 1]);
        break;
      case 3:
        bad.erase(at, 1);
        break;
      case 4:
        bad.insert(at, 1, below(2) == 0 ? bad[at] : static_cast<char>(random()));
        break;
      case 5:
        bad.resize(at);
        break;
      default:
        for (std::size_t i = 0, count = 1 + below(8); i < count; ++i) bad.insert(0, 1, static_cast<char>(random()));
        break;
    }
    // The damage may have made a line end, so that there would be two lines.
    std::replace(bad.begin(), bad.end(), '\n', '\v');
    bad += '\n';
    if (bad != line && bad != line.substr(0, line.size() - 1) + "\r\n") return bad;
  }
}

}  // namespace hrt::plate
