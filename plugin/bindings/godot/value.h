// Types of the values that scripts and the plate node exchange.
#pragma once

#include <haptic_retargeting/haptic_retargeting.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace hrt_godot {

/** Godot's vectors contain floats, which doubles represent exactly. */
using Vector3 = Eigen::Vector3d;

/** Godot's Transform3D. The basis of a node may also scale, shear or mirror. */
struct Pose {
  Eigen::Matrix3d basis = Eigen::Matrix3d::Identity();
  Vector3 origin = Vector3::Zero();
  bool operator==(const Pose&) const = default;
};

/** Values of Godot's enumeration Error. */
enum class Error : int64_t { kOk = 0, kUnavailable = 2, kFileCannotWrite = 13, kInvalidParameter = 31, kBug = 47 };

/** A time in nanoseconds. Scripts must pass an int; a float is an error, because it is probably in seconds. */
struct Time {
  int64_t ns;
};

struct Value;
/** A Dictionary, whose keys are string literals. */
using Record = std::vector<std::pair<const char*, Value>>;
/** A value of any type; the alternatives are in the order of kTypes. */
struct Value : std::variant<std::monostate, bool, int64_t, double, std::string, Vector3, Record, Pose> {
  using variant::variant;
};

/** Numbers of Godot's Variant.Type; kTime is registered as a Variant, so that the engine does not convert floats. */
enum class Type {
  kNil = 0,
  kBool = 1,
  kInt = 2,
  kReal = 3,
  kString = 4,
  kVector3 = 9,
  kPose = 18,
  kRecord = 27,
  kTime = 99
};
struct TypeName {
  Type type;
  const char* name;  ///< name in scripts
};
inline constexpr TypeName kTypes[] = {
    {Type::kNil, "null"},          {Type::kBool, "bool"},        {Type::kInt, "int"},
    {Type::kReal, "float"},        {Type::kString, "String"},    {Type::kVector3, "Vector3"},
    {Type::kRecord, "Dictionary"}, {Type::kPose, "Transform3D"}, {Type::kTime, "int"}};

inline Type type_of(const Value& value) { return kTypes[value.index()].type; }

inline const char* type_name(Type type) { return std::ranges::find(kTypes, type, &TypeName::type)->name; }

/** Returns whether a value has this type; an int also fits a float and a time. */
inline bool fits(const Value& value, Type type) {
  return type_of(value) == type || ((type == Type::kReal || type == Type::kTime) && type_of(value) == Type::kInt);
}

/** Result that shows a failure: kInvalidParameter for an Error, NaN for a position (update() refuses it), otherwise an
 *  empty value. */
template <typename T>
T failure() {
  if constexpr (std::is_same_v<T, Error>)
    return Error::kInvalidParameter;
  else if constexpr (std::is_same_v<T, Vector3>)
    return {std::numeric_limits<double>::quiet_NaN(), 0, 0};
  else
    return {};
}

/** Converts the result of a method, or a field of the plugin's structs, to a value. */
template <typename T>
Value to_value(const T& value) {
  if constexpr (std::is_same_v<T, double[3]>)
    return Vector3(value);
  else if constexpr (std::is_same_v<T, hrt_target>)
    return static_cast<int64_t>(value.value);
  else if constexpr (std::is_enum_v<T> || (std::is_integral_v<T> && !std::is_same_v<T, bool>))
    return static_cast<int64_t>(value);
  else
    return value;
}

template <typename T>
Type argument_type() {
  if constexpr (std::is_same_v<T, Time>)
    return Type::kTime;
  else
    return type_of(to_value(failure<T>()));
}

/** Converts a value that fits the type to an argument. */
template <typename T>
T from_value(const Value& value) {
  const int64_t* integer = std::get_if<int64_t>(&value);
  if constexpr (std::is_same_v<T, hrt_target>)
    return {static_cast<uint64_t>(*integer)};
  else if constexpr (std::is_same_v<T, Time>)
    return {*integer};
  else if constexpr (std::is_same_v<T, double>)
    return integer ? static_cast<double>(*integer) : std::get<double>(value);
  else
    return std::get<T>(value);
}

}  // namespace hrt_godot
