// A node's haptic role and its properties, from the node's `extras`.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace hrt {

enum class HapticRole { plate, real, virtual_target, start };

/// As in the file, checked against the ranges. A property that the role does not take is absent.
struct HapticProperties {
  HapticRole role;
  std::optional<std::string> name;        ///< 1 to 255 bytes, no control characters
  std::optional<double> radius_m;         ///< 0.001 to 10
  std::optional<double> max_speed_deg_s;  ///< 0.001 to 1e5
  std::optional<std::string> served_by;   ///< as name
};

/// True if `extras`, of any type, holds haptic properties: nested under `haptic`, or flat as
/// `haptic_role` and so on.
bool is_haptic(const nlohmann::json& extras);

/// The haptic properties of `extras`; requires is_haptic(extras). Throws SceneError, its text starting with
/// `where`, on one that is unknown, of the wrong type, out of its range or not for the role.
HapticProperties haptic_properties(const nlohmann::json& extras, const std::string& where);

}  // namespace hrt
