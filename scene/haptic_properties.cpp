#include "scene/haptic_properties.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "scene/scene_error.h"

namespace hrt {
namespace {

constexpr std::size_t max_text = 255;
constexpr double min_number = 0.001;  // metres, or degrees per second
constexpr double max_radius_m = 10.0;
constexpr double speed_limit_deg_s = 1e5;
constexpr const char* nested_key = "haptic";
constexpr std::string_view flat_prefix = "haptic_";

// A role, and the keys of the properties that apply to it.
struct Role {
  std::string_view name;
  HapticRole role;
  std::span<const std::string_view> keys;
};
constexpr std::string_view plate_keys[] = {"role", "name", "radius_m", "max_speed_deg_s"};
constexpr std::string_view real_keys[] = {"role", "name", "radius_m"};
constexpr std::string_view virtual_keys[] = {"role", "name", "radius_m", "served_by"};
constexpr std::string_view start_keys[] = {"role", "name"};
constexpr Role roles[] = {{"plate", HapticRole::plate, plate_keys},
                          {"real", HapticRole::real, real_keys},
                          {"virtual", HapticRole::virtual_target, virtual_keys},
                          {"start", HapticRole::start, start_keys}};

bool is_haptic_key(std::string_view key) { return key == nested_key || key.starts_with(flat_prefix); }

}  // namespace

bool is_haptic(const tinygltf::Value& extras) {
  const std::vector<std::string> keys = extras.Keys();  // empty if `extras` is not an object
  return std::any_of(keys.begin(), keys.end(), is_haptic_key);
}

HapticProperties haptic_properties(const tinygltf::Value& extras, const std::string& where) {
  std::map<std::string, const tinygltf::Value*> values;  // values by key, without the prefix of the flat form
  std::string prefix = "extras.haptic_";
  const auto label = [&](std::string_view key) {
    const std::string quoted = in_quotes(key);
    return prefix + quoted.substr(1, quoted.size() - 2);
  };
  for (const auto& [key, value] : extras.Get<tinygltf::Value::Object>())
    if (key.starts_with(flat_prefix)) values.emplace(key.substr(flat_prefix.size()), &value);
  if (extras.Has(nested_key)) {
    if (!values.empty())
      refuse(where, "both extras.haptic and {} are given; keep one form", label(values.begin()->first));
    if (!extras.Get(nested_key).IsObject()) refuse(where, "extras.haptic is not an object; write {{\"role\": ...}}");
    prefix = "extras.haptic.";
    for (const auto& [key, value] : extras.Get(nested_key).Get<tinygltf::Value::Object>()) values.emplace(key, &value);
  }

  const auto text = [&](const char* key) -> std::optional<std::string> {
    const auto found = values.find(key);
    if (found == values.end()) return std::nullopt;
    if (!found->second->IsString()) refuse(where, "{} is not a string; write it in quotes", label(key));
    const auto& value = found->second->Get<std::string>();
    if (value.empty() || value.size() > max_text)
      refuse(where, "{} has {} bytes; allowed: 1 to {}", label(key), value.size(), max_text);
    if (value != printable(value))
      refuse(where, "{} is {}; remove the control characters", label(key), in_quotes(value));
    return value;
  };
  const auto number = [&](const char* key, double max) -> std::optional<double> {
    const auto found = values.find(key);
    if (found == values.end()) return std::nullopt;
    if (!found->second->IsNumber()) refuse(where, "{} is not a number; write a number without quotes", label(key));
    const double value = found->second->GetNumberAsDouble();
    if (!(value >= min_number && value <= max))
      refuse(where, "{} is {:g}; allowed: {:g} to {:g}", label(key), value, min_number, max);
    return value;
  };

  const std::optional<std::string> name = text("role");
  if (!name) refuse(where, "{} is missing; set it to plate, real, virtual or start", label("role"));
  const auto* role = std::find_if(std::begin(roles), std::end(roles), [&](const Role& r) { return r.name == *name; });
  if (role == std::end(roles))
    refuse(where, "{} is {}; allowed: \"plate\", \"real\", \"virtual\" and \"start\"", label("role"), in_quotes(*name));
  for (const auto& [key, value] : values)
    if (std::find(role->keys.begin(), role->keys.end(), key) == role->keys.end())
      refuse(where, "{} is not a property of the role {}; allowed after {}: {}", label(key), role->name, prefix,
             fmt::join(role->keys, ", "));
  HapticProperties result{.role = role->role,
                          .name = text("name"),
                          .radius_m = number("radius_m", max_radius_m),
                          .max_speed_deg_s = number("max_speed_deg_s", speed_limit_deg_s),
                          .served_by = text("served_by")};
  if (result.role == HapticRole::plate && !result.radius_m)
    refuse(where, "{} is missing; set it to the radius of the plate in metres", label("radius_m"));
  return result;
}

}  // namespace hrt
