// What tables.cpp has, which is generated: the fields of the plugin's structs as Godot sees them, properties of the
// node and keys of Dictionaries, the plugin's constants, and the class reference.
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

/** What has the properties: the configuration of sessions without the plate's pose, which is the node's own, and
 * without its fixed arrays, such as what is believed of the person, which profiles hold; and that of set-ups without
 * its marks. */
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
  /** False, and nothing changes, if the value is not of the field's type. Ranges are left to the plugin. */
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
/** Of properties and flags: COMMAND_SATURATED and its like. */
extern const std::span<const Constant> constants;

/** What the editor shows of properties and constants: XML. */
extern const char* const class_reference;

}  // namespace hrt_godot
