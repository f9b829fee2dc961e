// Records of a captured script: JSON arrays. playback/recording.h lists them.
#pragma once

#include <openxr/openxr.h>

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <type_traits>

namespace hrt::capture {

using Json = nlohmann::json;

/// A number with the fewest decimals that the playback reads back to the same bits. Numbers that are not finite, which
/// JSON lacks, are a text with the bits in hexadecimal.
Json number(float value);
Json number(double value);

/// Appends values to an array; vectors and poses (orientation x, y, z, w, then position) as their numbers.
template <typename... Values>
void append(Json& array, const Values&... values) {
  const auto put = [&]<typename Value>(const Value& value) {
    if constexpr (std::is_same_v<Value, XrVector3f>)
      append(array, value.x, value.y, value.z);
    else if constexpr (std::is_same_v<Value, XrQuaternionf>)
      append(array, value.x, value.y, value.z, value.w);
    else if constexpr (std::is_same_v<Value, XrPosef>)
      append(array, value.orientation, value.position);
    else if constexpr (std::is_floating_point_v<Value>)
      array.push_back(number(value));
    else if constexpr (std::is_enum_v<Value>)
      array.push_back(static_cast<int>(value));
    else if constexpr (std::is_same_v<Value, std::string_view>)
      array.push_back(std::string(value));
    else
      array.push_back(value);
  };
  (put(values), ...);
}

template <typename... Values>
Json array_of(const Values&... values) {
  Json array = Json::array();
  append(array, values...);
  return array;
}

}  // namespace hrt::capture
