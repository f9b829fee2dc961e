// One record of a captured script: a JSON array in a line. playback/recording.h lists the records.
#pragma once

#include <openxr/openxr.h>

#include <concepts>
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
  explicit Record(std::string_view kind) : text_("[") { put(kind); }

  /// Of a pose x, y, z, w, then the position.
  template <typename... Values>
  Record& add(const Values&... values) {
    (put(values), ...);
    return *this;
  }
  /// In an array of their own.
  template <typename... Values>
  Record& nest(const Values&... values) {
    return open().add(values...).close();
  }
  /// The members that follow are in an array of their own, until close().
  Record& open();
  Record& close();

  /// The line, without its end.
  std::string text() const { return text_ + "]"; }

 private:
  void put_token(std::string_view token);
  void put(std::string_view value);
  void put(const char* value) { put(std::string_view(value)); }
  void put(bool value) { put_token(value ? "true" : "false"); }
  void put(Enumeration auto value) { put(static_cast<int>(value)); }
  void put(std::integral auto value) { put_token(std::to_string(value)); }
  void put(std::floating_point auto value) { put_token(text_of(value)); }
  void put(const XrVector3f& vector) { add(vector.x, vector.y, vector.z); }
  void put(const XrPosef& pose) {
    const XrQuaternionf& q = pose.orientation;
    add(q.x, q.y, q.z, q.w, pose.position);
  }
  std::string text_;
};

}  // namespace hrt::capture
