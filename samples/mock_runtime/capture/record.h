// One record of a captured script: a JSON array in a line. playback/recording.h lists the records.
#pragma once

#include <openxr/openxr.h>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace hrt::capture {

/// The shortest decimals that the playback reads back to the same bits; of numbers that are not finite,
/// which JSON lacks, the bits in hexadecimal as a text.
std::string text_of(float value);
std::string text_of(double value);

template <typename T>
concept Enumeration = std::is_enum_v<T>;

class Record {
 public:
  explicit Record(std::string_view kind);

  Record& add(std::string_view value);
  Record& add(const char* value) { return add(std::string_view(value)); }
  Record& add(bool value) { return put(value ? "true" : "false"); }
  Record& add(Enumeration auto value) { return add(static_cast<int>(value)); }
  Record& add(std::integral auto value) { return put(std::to_string(value)); }
  Record& add(std::floating_point auto value) { return put(text_of(value)); }
  Record& add(const XrVector3f& vector);
  /// x, y, z, w, then the position.
  Record& add(const XrPosef& pose);
  /// The members that follow are in an array of their own, until close().
  Record& open();
  Record& close();

  /// The line, without its end.
  std::string text() const { return text_ + "]"; }

 private:
  Record& put(std::string_view token);
  std::string text_;
};

}  // namespace hrt::capture
