// What crosses between a script and the plate node.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace hrt_godot {

/** Godot's vectors are of floats: each goes through the plugin's doubles and back unchanged. */
struct Vector3 {
  double x, y, z;
  bool operator==(const Vector3&) const = default;
};

inline Vector3 widen(float x, float y, float z) {
  return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
}

/** A place in the world and a rotation: the columns of a basis, and its origin. */
struct Pose {
  Vector3 x_axis, y_axis, z_axis;
  Vector3 origin;
  bool operator==(const Pose&) const = default;
};

/** A Dictionary of numbers, places and texts. Keys are string literals. */
using Entry = std::variant<int64_t, double, Vector3, std::string>;
using Record = std::vector<std::pair<const char*, Entry>>;

/** The alternatives are in the order of Type. */
using Value = std::variant<std::monostate, bool, int64_t, double, std::string, Vector3, Record, Pose>;

enum class Type { kNil, kBool, kInt, kReal, kString, kVector3, kRecord, kPose };

inline Type type_of(const Value& value) {
  return static_cast<Type>(value.index());
}

inline const char* type_name(Type type) {
  constexpr const char* names[] = {"null",   "bool",    "int",        "float",
                                   "String", "Vector3", "Dictionary", "Transform3D"};
  static_assert(std::size(names) == std::variant_size_v<Value>);
  return names[static_cast<size_t>(type)];
}

inline int64_t to_int(const Value& value) {
  return std::get<int64_t>(value);
}
inline double to_real(const Value& value) {
  const int64_t* integer = std::get_if<int64_t>(&value);
  return integer ? static_cast<double>(*integer) : std::get<double>(value);
}
inline const std::string& to_text(const Value& value) {
  return std::get<std::string>(value);
}

}  // namespace hrt_godot
