// The generated tables.cpp: the fields of the plugin's structs as properties of the node and keys of Dictionaries, the
// plugin's constants, and the class reference.
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

/** The properties are the fields of these, without the plate's pose, which is the node's, the fixed arrays, such as the
 *  person's mean, which profiles store, and the marks of set-ups. */
struct Properties {
  hrt_session_config session = hrt_session_config_init();
  hrt_setup_config setup = hrt_setup_config_init();
};
using Place = std::variant<double*, int64_t*, uint32_t*, double (*)[3]>;

/** How the inspector shows a property: numbers of Godot's PropertyHint. */
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
  /** Returns false and changes nothing if the value is not of the field's type. The plugin checks ranges. */
  bool set(Properties& of, const Value& value) const;
};
extern const std::span<const Property> properties;

/** Empty if struct_size is 0. Of an interval NAME there are NAME, NAME_lower, NAME_upper and NAME_known. */
Record to_record(const hrt_command& of), to_record(const hrt_reach_summary& of), to_record(const hrt_gap& of),
    to_record(const hrt_setup_step& of), to_record(const hrt_setup_result& of), to_record(const hrt_conditions& of),
    to_record(const hrt_recording_status& of), to_record(const hrt_plate_report& of);

struct Constant {
  const char* enumeration;
  const char* name;
  int64_t value;
  bool is_flag;
};
/** Values of properties and flags, such as COMMAND_SATURATED. */
extern const std::span<const Constant> constants;

/** An error text with the names of GDScript: of methods for those of calls, and of constants without HRT_. */
std::string script_names(std::string text);
struct ScriptName {
  const char* call;
  const char* method;
};
extern const std::span<const ScriptName> script_names_of_calls;

/** The class reference that the editor shows: XML. */
extern const char* const class_reference;

}  // namespace hrt_godot
