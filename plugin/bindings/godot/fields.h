// The fields of the plugin's structs as Godot sees them: properties of the node, keys of Dictionaries. Their
// tables are generated from the C headers (tables.cpp).
#pragma once

#include <haptic_retargeting/haptic_retargeting.h>
#include <haptic_retargeting/setup.h>
#include <haptic_retargeting/study.h>

#include <cstddef>
#include <cstdint>
#include <span>

#include "value.h"

namespace hrt_godot {

enum class FieldKind { kInt32, kUint32, kInt64, kDouble, kVector3, kText };

struct Field {
  const char* name;
  FieldKind kind;
  size_t offset;
  /** What the inspector offers, for a field with named values; else null. */
  const char* choices = nullptr;
};

Type type_of(const Field& field);
Value get_field(const void* object, const Field& field);
/** False, and nothing changes, if the value is not of the field's type. Ranges are left to the plugin. */
bool set_field(void* object, const Field& field, const Value& value);
bool is_different(const void* object, const void* other, const Field& field);
Record to_record(const void* object, std::span<const Field> fields);

/** The properties: hrt_session_config without the plate's pose, which is the node's own, and without its
 * fixed arrays, such as what is believed of the person, which profiles hold. */
extern const std::span<const Field> config_fields;
/** More properties: hrt_setup_config without its marks. */
extern const std::span<const Field> setup_fields;
extern const std::span<const Field> command_fields;
extern const std::span<const Field> summary_fields;
extern const std::span<const Field> gap_fields;
/** Of an interval NAME the fields NAME, NAME_lower, NAME_upper and NAME_known. */
extern const std::span<const Field> result_fields;
extern const std::span<const Field> step_fields;
extern const std::span<const Field> conditions_fields;
extern const std::span<const Field> recording_fields;
extern const std::span<const Field> device_fields;

struct Constant {
  const char* enumeration;
  const char* name;
  int64_t value;
  bool is_flag;
};
/** Of properties and flags: COMMAND_SATURATED and its like. */
extern const std::span<const Constant> constants;

/** Copies the fixed arrays, which no property shows. */
void copy_hidden(const hrt_session_config& from, hrt_session_config& to);

}  // namespace hrt_godot
