// Tables for the class HapticRetargeting, in tables.cpp, which plugin/bindings/generate writes.
#pragma once

#include <haptic_retargeting/gap.h>
#include <haptic_retargeting/haptic_retargeting.h>
#include <haptic_retargeting/host.h>
#include <haptic_retargeting/person.h>
#include <haptic_retargeting/plate.h>
#include <haptic_retargeting/profile.h>
#include <haptic_retargeting/recording.h>
#include <haptic_retargeting/scene.h>
#include <haptic_retargeting/setup.h>

#include <span>
#include <variant>

#include "value.h"

namespace hrt_godot {

/** Structs with the fields that are properties. Their other fields are the plate's pose, which is that of the node,
 *  results of set-ups and reaches such as the person's mean, and the marks of set-ups. */
struct Properties {
  hrt_session_config session = hrt_session_config_init();
  hrt_setup_config setup = hrt_setup_config_init();
};
using Place = std::variant<double*, int64_t*, uint32_t*, double (*)[3]>;

/** Control of a property in the inspector: numbers of Godot's PropertyHint. */
enum class Hint : uint32_t { kNone = 0, kRange = 1, kEnum = 2, kFlags = 6 };

struct Property {
  const char* name;
  Place (*place)(Properties& properties);
  Hint hint;
  const char* hint_text;
  const char* group;

  Value get(Properties& of) const {
    return std::visit([](const auto* at) { return to_value(*at); }, place(of));
  }
  /** Sets the field. Returns false, without a change, if the value does not fit its type. Does not check its range. */
  bool set(Properties& of, const Value& value) const;
};
extern const std::span<const Property> properties;

/** Converts a struct to a Dictionary, which is empty if struct_size is 0. An hrt_interval NAME has the keys
 *  NAME, NAME_lower, NAME_upper and NAME_known. */
Record to_record(const hrt_command& of), to_record(const hrt_reach_summary& of), to_record(const hrt_gap& of),
    to_record(const hrt_setup_step& of), to_record(const hrt_setup_result& of), to_record(const hrt_conditions& of),
    to_record(const hrt_recording_status& of), to_record(const hrt_plate_report& of);

struct Constant {
  const char* enumeration;
  const char* name;
  int64_t value;
  bool is_flag;
};
extern const std::span<const Constant> constants;

/** Returns an error text with the names of GDScript: methods instead of C functions, and constants without HRT_. */
std::string script_names(std::string text);
struct ScriptName {
  const char* call;
  const char* method;
};
extern const std::span<const ScriptName> script_names_of_calls;

/** Class reference that the editor shows, as XML. */
extern const char* const class_reference;

}  // namespace hrt_godot
