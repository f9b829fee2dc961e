// The haptic role of a node and its properties, from the node's `extras`.
#pragma once

#include <tiny_gltf.h>

#include <optional>
#include <string>

namespace hrt {

enum class HapticRole { plate, real, virtual_target, start };

/// Properties of a node, within their ranges. A property that does not apply to the role is unset.
struct HapticProperties {
  HapticRole role;
  std::optional<std::string> name;        ///< 1 to 255 bytes, no control characters
  std::optional<double> radius_m;         ///< 0.001 to 10; always set for a plate
  std::optional<double> max_speed_deg_s;  ///< 0.001 to 1e5
  std::optional<std::string> served_by;   ///< name of a real target, which may not exist
};

/// True if `extras` has haptic properties: nested in `haptic`, or flat as `haptic_role` and so on.
bool is_haptic(const tinygltf::Value& extras);

/// Reads the properties. Requires is_haptic(extras). Throws SceneError if a property is missing, unknown, of the wrong
/// type, out of range, or does not apply to the role. `where` is the beginning of the error text.
HapticProperties haptic_properties(const tinygltf::Value& extras, const std::string& where);

}  // namespace hrt
