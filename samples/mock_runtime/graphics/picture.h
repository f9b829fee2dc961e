// Pictures with 8 bits per channel in sRGB.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace hrt::mock {

struct Picture {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> rgba;  ///< top row first

  Picture() = default;
  Picture(std::uint32_t w, std::uint32_t h) : width(w), height(h), rgba(std::size_t{4} * w * h) {}
  const std::uint8_t* at(std::uint32_t x, std::uint32_t y) const { return &rgba[4 * (std::size_t{y} * width + x)]; }
};

/// Returns the FNV-1a hash of size and pixels in 16 hexadecimal digits.
std::string hash_of(const Picture& picture);

/// Writes a PNG file. Throws an Error with the reason if the file cannot be written.
void write_png(const Picture& picture, const std::string& path);

}  // namespace hrt::mock
