// What crosses between a script and the plate node.
#pragma once

#include <cstdint>
#include <iterator>
#include <limits>
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

/** A place in the world and a rotation: the columns of a basis, and its origin. */
struct Pose {
  Vector3 x_axis, y_axis, z_axis;
  Vector3 origin;
  bool operator==(const Pose&) const = default;
};

/** Of Godot's enumeration Error. */
enum class Error : int64_t {
  kOk = 0,
  kUnavailable = 2,
  kParameterRange = 5,
  kOutOfMemory = 6,
  kFileCannotWrite = 13,
  kCannotCreate = 20,
  kInvalidData = 30,
  kInvalidParameter = 31,
  kAlreadyExists = 32,
  kDoesNotExist = 33,
  kParse = 43,
  kBusy = 44,
  kBug = 47
};

/** A Dictionary of numbers, places and texts. Keys are string literals. */
using Entry = std::variant<int64_t, double, Vector3, std::string>;
using Record = std::vector<std::pair<const char*, Entry>>;

/** The alternatives are in the order of Type. */
using Value = std::variant<std::monostate, bool, int64_t, double, std::string, Vector3, Record, Pose>;

enum class Type { kNil, kBool, kInt, kReal, kString, kVector3, kRecord, kPose };

inline Type type_of(const Value& value) { return static_cast<Type>(value.index()); }

constexpr const char* type_name(Type type) {
  constexpr const char* names[] = {"null", "bool", "int", "float", "String", "Vector3", "Dictionary", "Transform3D"};
  static_assert(std::size(names) == std::variant_size_v<Value>);
  return names[static_cast<size_t>(type)];
}

/** What a method that fails returns: no target; a place that update() refuses. */
template <typename T>
T failure() {
  if constexpr (std::is_same_v<T, Error>)
    return Error::kInvalidParameter;
  else if constexpr (std::is_same_v<T, Vector3>)
    return {std::numeric_limits<double>::quiet_NaN(), 0, 0};
  else
    return {};
}

template <typename T>
Value to_value(T value) {
  if constexpr (std::is_same_v<T, Error>)
    return static_cast<int64_t>(value);
  else if constexpr (std::is_same_v<T, Entry>)
    return std::visit([](auto& entry) { return Value(std::move(entry)); }, value);
  else
    return Value(std::move(value));
}

/** A value of the type; GDScript writes 5 for 5.0. */
template <typename T>
T from_value(const Value& value) {
  if constexpr (std::is_same_v<T, double>)
    if (const int64_t* integer = std::get_if<int64_t>(&value)) return static_cast<double>(*integer);
  return std::get<T>(value);
}

}  // namespace hrt_godot
