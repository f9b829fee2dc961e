#include "samples/mock_runtime/graphics/picture.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "samples/mock_runtime/error.h"

namespace hrt::mock {
namespace {

float from_half(std::uint16_t bits) {
  const int exponent = static_cast<int>(bits >> 10U & 31U);
  const float fraction = static_cast<float>(bits & 1023U) / 1024.0F;
  const float size = exponent == 0    ? std::ldexp(fraction, -14)
                     : exponent == 31 ? 65504.0F
                                      : std::ldexp(1.0F + fraction, exponent - 15);
  return (bits >> 15U) != 0 ? -size : size;
}

// IEC 61966-2-1.
std::uint8_t encoded(float linear) {
  const float in = std::clamp(linear, 0.0F, 1.0F);
  const float out = in <= 0.0031308F ? 12.92F * in : 1.055F * std::pow(in, 1.0F / 2.4F) - 0.055F;
  return static_cast<std::uint8_t>(std::lround(255.0F * out));
}

const std::array<std::uint8_t, 256>& encoded_bytes() {
  static const auto table = [] {
    std::array<std::uint8_t, 256> made{};
    for (std::size_t i = 0; i < made.size(); ++i) made[i] = encoded(static_cast<float>(i) / 255.0F);
    return made;
  }();
  return table;
}

}  // namespace

std::uint32_t bytes_of(PixelKind kind) { return kind == PixelKind::half_linear ? 8 : 4; }

void convert_pixels(PixelKind kind, const std::uint8_t* from, std::size_t count, std::uint8_t* rgba) {
  const bool swaps = kind == PixelKind::bgra_srgb || kind == PixelKind::bgra_linear;
  const bool linear = kind == PixelKind::rgba_linear || kind == PixelKind::bgra_linear;
  const auto& table = encoded_bytes();
  for (std::size_t i = 0; i < count; ++i, from += bytes_of(kind), rgba += 4) {
    if (kind == PixelKind::half_linear) {
      std::array<std::uint16_t, 4> halves{};
      std::memcpy(halves.data(), from, sizeof halves);
      for (std::size_t c = 0; c < 3; ++c) rgba[c] = encoded(from_half(halves[c]));
      rgba[3] = static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(from_half(halves[3]), 0.0F, 1.0F)));
      continue;
    }
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint8_t value = from[swaps ? 2 - c : c];
      rgba[c] = linear ? table[value] : value;
    }
    rgba[3] = from[3];
  }
}

std::string hash_of(const Picture& picture) {
  std::uint64_t hash = 14695981039346656037U;
  const auto add = [&](std::uint8_t byte) { hash = (hash ^ byte) * 1099511628211U; };
  for (const std::uint32_t size : {picture.width, picture.height})
    for (const unsigned shift : {0U, 8U, 16U, 24U}) add(static_cast<std::uint8_t>(size >> shift));
  for (const std::uint8_t byte : picture.rgba) add(byte);
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

void write_png(const Picture& picture, const std::string& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = picture.width;
  image.height = picture.height;
  image.format = PNG_FORMAT_RGBA;
  image.flags = PNG_IMAGE_FLAG_FAST;
  if (png_image_write_to_file(&image, path.c_str(), 0, picture.rgba.data(), 0, nullptr) == 0)
    throw Error{XR_ERROR_RUNTIME_FAILURE, path + ": " + image.message};
}

}  // namespace hrt::mock
