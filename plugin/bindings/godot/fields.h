// The fields of the plugin's structs as Godot sees them: properties of the node, keys of Dictionaries. Their
// tables are generated from the C headers (tables.cpp).
#pragma once

#include <haptic_retargeting/haptic_retargeting.h>
#include <haptic_retargeting/setup.h>
#include <haptic_retargeting/study.h>

#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include "value.h"

namespace hrt_godot {

/** How the inspector shows a property: numbers of Godot's PropertyHint. */
enum class Hint : uint32_t { kNone = 0, kRange = 1, kEnum = 2, kFlags = 6 };

struct Field {
  const char* name;
  Type type;
  Entry (*get)(const void* object);
  /** False, and nothing changes, if the value is not of the field's type. Ranges are left to the plugin. */
  bool (*set)(void* object, const Value& value);
  const char* allowed;  ///< values
  // Of properties alone.
  Hint hint;
  const char* hint_text;
  const char* group;
};

/** A field of a struct, or of a part of that field: each step on the way. */
template <auto first, auto... path>
struct Access {
  template <typename Struct, typename T>
  static Struct struct_of(T Struct::*);
  using Struct = decltype(struct_of(first));

  template <typename Object>
  static auto& of(Object& object) {
    return ((object.*first).*....*path);
  }
  using T = std::remove_reference_t<decltype(of(std::declval<Struct&>()))>;
  static constexpr bool is_place = std::is_same_v<T, double[3]>;
  static constexpr Type type = std::is_same_v<T, double> ? Type::kReal
                               : is_place                ? Type::kVector3
                               : std::is_array_v<T>      ? Type::kString
                                                         : Type::kInt;

  static Entry get(const void* object) {
    const auto& value = of(*static_cast<const Struct*>(object));
    if constexpr (type == Type::kReal)
      return value;
    else if constexpr (is_place)
      return Vector3{value[0], value[1], value[2]};
    else if constexpr (type == Type::kString)
      return std::string(value);
    else if constexpr (std::is_same_v<T, hrt_target>)
      return static_cast<int64_t>(value.value);
    else
      return static_cast<int64_t>(value);
  }

  static bool set(void* object, const Value& value) {
    auto& into = of(*static_cast<Struct*>(object));
    const int64_t* integer = std::get_if<int64_t>(&value);
    if constexpr (is_place) {
      const Vector3* place = std::get_if<Vector3>(&value);
      if (place) into[0] = place->x, into[1] = place->y, into[2] = place->z;
      return place;
    } else if constexpr (type == Type::kReal) {
      if (!integer && !std::holds_alternative<double>(value)) return false;
      into = from_value<double>(value);
      return true;
    } else if constexpr (std::is_integral_v<T>) {
      if (!integer || !std::in_range<T>(*integer)) return false;
      into = static_cast<T>(*integer);
      return true;
    }
    return false;
  }
};

template <auto... path>
constexpr Field make_field(const char* name, Hint hint = Hint::kNone, const char* hint_text = "",
                           const char* group = "") {
  using Own = Access<path...>;
  const bool is_unsigned = std::is_same_v<typename Own::T, uint32_t>;
  const char* allowed = is_unsigned ? "int from 0 to 4294967295" : type_name(Own::type);
  return {name, Own::type, Own::get, Own::set, allowed, hint, hint_text, group};
}

inline Record to_record(const void* object, std::span<const Field> fields) {
  Record record;
  record.reserve(fields.size());
  for (const Field& field : fields) record.emplace_back(field.name, field.get(object));
  return record;
}

/** The properties: hrt_session_config without the plate's pose, which is the node's own, and without its
 * fixed arrays, such as what is believed of the person, which profiles hold. */
extern const std::span<const Field> config_fields;
/** More properties: hrt_setup_config without its marks. */
extern const std::span<const Field> setup_fields;
extern const std::span<const Field> command_fields, summary_fields, gap_fields, step_fields, conditions_fields,
    recording_fields, device_fields;
/** Of an interval NAME the fields NAME, NAME_lower, NAME_upper and NAME_known. */
extern const std::span<const Field> result_fields;

struct Constant {
  const char* enumeration;
  const char* name;
  int64_t value;
  bool is_flag;
};
/** Of properties and flags: COMMAND_SATURATED and its like. */
extern const std::span<const Constant> constants;

/** What the editor shows of properties and constants: XML. */
extern const char* const class_reference;

/** Copies the fixed arrays, which no property shows. */
void copy_hidden(const hrt_session_config& from, hrt_session_config& to);

}  // namespace hrt_godot
