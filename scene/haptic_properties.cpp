#include "scene/haptic_properties.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/scene_error.h"

namespace hrt {
namespace {

constexpr std::size_t max_text = 255;
constexpr double min_number = 0.001;  // metres, or degrees a second: what a session takes as a radius
constexpr double max_radius_m = 10.0;
constexpr double speed_limit_deg_s = 1e5;
constexpr std::string_view nested_key = "haptic";
constexpr std::string_view flat_prefix = "haptic_";

// A role, and the properties that it takes.
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

// One property, and how messages call it.
struct Property {
  std::string key;  // without prefix
  std::string label;
  const nlohmann::json& value;
};

class PropertyReader {
 public:
  PropertyReader(std::vector<Property> properties, const std::string& where)
      : properties_(std::move(properties)), where_(where) {}

  HapticProperties read() {
    const Role& known = role();
    HapticProperties result{.role = known.role};
    for (const Property& property : properties_) {
      if (property.key == "role") continue;
      if (std::find(known.keys.begin(), known.keys.end(), property.key) == known.keys.end())
        refuse(where_, "{} is not a property of this role; allowed are {}", property.label,
               fmt::join(known.keys, ", "));
      if (property.key == "name")
        result.name = text(property);
      else if (property.key == "served_by")
        result.served_by = text(property);
      else if (property.key == "radius_m")
        result.radius_m = number(property, max_radius_m);
      else
        result.max_speed_deg_s = number(property, speed_limit_deg_s);
    }
    if (result.role == HapticRole::plate && !result.radius_m)
      refuse(where_, "{} is missing: a plate needs its radius in metres", label_of("radius_m"));
    return result;
  }

 private:
  const Role& role() const {
    const auto found =
        std::find_if(properties_.begin(), properties_.end(), [](const Property& p) { return p.key == "role"; });
    if (found == properties_.end())
      refuse(where_, "{} is missing, beside {}", label_of("role"), properties_.front().label);
    const std::string name = text(*found);
    for (const Role& known : roles)
      if (known.name == name) return known;
    refuse(where_, "{} is {}; allowed are \"plate\", \"real\", \"virtual\" and \"start\"", found->label,
           in_quotes(name));
  }

  std::string text(const Property& property) const {
    if (!property.value.is_string()) refuse(where_, "{} is not a string", property.label);
    auto value = property.value.get<std::string>();
    if (value.empty() || value.size() > max_text)
      refuse(where_, "{} has {} bytes; allowed are 1 to {}", property.label, value.size(), max_text);
    if (value != printable(value))
      refuse(where_, "{} is {}, with a control character in it", property.label, in_quotes(value));
    return value;
  }

  double number(const Property& property, double max) const {
    if (!property.value.is_number()) refuse(where_, "{} is not a number", property.label);
    const double value = property.value.get<double>();
    if (!(value >= min_number && value <= max))
      refuse(where_, "{} is {:g}; allowed is {:g} to {:g}", property.label, value, min_number, max);
    return value;
  }

  // The label that an absent property would have.
  std::string label_of(const std::string& key) const {
    const Property& first = properties_.front();
    return first.label.substr(0, first.label.size() - first.key.size()) + key;
  }

  std::vector<Property> properties_;
  const std::string& where_;
};

// A key as a message shows it: printable, and no longer than a name in quotes.
std::string shown_key(std::string_view key) {
  const std::string quoted = in_quotes(key);
  return quoted.substr(1, quoted.size() - 2);
}

}  // namespace

bool is_haptic(const nlohmann::json& extras) {
  if (!extras.is_object()) return false;
  for (const auto& [key, value] : extras.items())
    if (key == nested_key || key.starts_with(flat_prefix)) return true;
  return false;
}

HapticProperties haptic_properties(const nlohmann::json& extras, const std::string& where) {
  std::vector<Property> flat;
  for (const auto& [key, value] : extras.items())
    if (key.starts_with(flat_prefix))
      flat.push_back({key.substr(flat_prefix.size()), "extras." + shown_key(key), value});
  const auto nested = extras.find(nested_key);
  if (nested == extras.end()) return PropertyReader(std::move(flat), where).read();
  if (!flat.empty()) refuse(where, "both extras.haptic and {} are given; keep one form", flat.front().label);
  if (!nested->is_object() || nested->empty()) refuse(where, "extras.haptic is not an object with a role");
  std::vector<Property> properties;
  for (const auto& [key, value] : nested->items())
    properties.push_back({key, "extras.haptic." + shown_key(key), value});
  return PropertyReader(std::move(properties), where).read();
}

}  // namespace hrt
