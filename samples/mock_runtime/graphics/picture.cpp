#include "samples/mock_runtime/graphics/picture.h"

#include <png.h>

#include <cstdio>

#include "samples/mock_runtime/error.h"

namespace hrt::mock {

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
    throw Error{XR_ERROR_RUNTIME_FAILURE, path + ": cannot be written: " + image.message};
}

}  // namespace hrt::mock
