#include "scene/haptic_properties.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/scene_error.h"

namespace hrt {
namespace {

constexpr std::size_t longest_text = 255;
constexpr double largest_radius_m = 10.0;
constexpr double largest_speed_deg_s = 1e5;
constexpr const char* nested_key = "haptic";
constexpr std::string_view flat_prefix = "haptic_";

struct RoleName {
  std::string_view name;
  HapticRole role;
};
constexpr std::array role_names{RoleName{"plate", HapticRole::plate}, RoleName{"real", HapticRole::real},
                                RoleName{"virtual", HapticRole::virtual_target},
                                RoleName{"start", HapticRole::start}};

// One property, and how messages call it.
struct Property {
  std::string key;  // without prefix
  std::string label;
  const nlohmann::json* value;
};

class Reader {
 public:
  Reader(std::vector<Property> properties, const std::string& where)
      : properties_(std::move(properties)), where_(where) {}

  HapticProperties read() {
    HapticProperties result{.role = role()};
    for (const Property& property : properties_) {
      if (property.key == "role") {
        continue;
      }
      if (!is_for(result.role, property.key)) {
        fail(property.label + " is not a property of this role; " + allowed_text(result.role));
      }
      if (property.key == "name") {
        result.name = text(property);
      } else if (property.key == "served_by") {
        result.served_by = text(property);
      } else if (property.key == "radius_m") {
        result.radius_m = number(property, largest_radius_m);
      } else {
        result.max_speed_deg_s = number(property, largest_speed_deg_s);
      }
    }
    if (result.role == HapticRole::plate && !result.radius_m) {
      fail(label_of("radius_m") + " is missing: a plate needs its radius in metres");
    }
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw SceneError(where_ + what); }

  HapticRole role() const {
    const auto found = std::find_if(properties_.begin(), properties_.end(),
                                    [](const Property& p) { return p.key == "role"; });
    if (found == properties_.end()) {
      fail(label_of("role") + " is missing, beside " + properties_.front().label);
    }
    const std::string name = text(*found);
    for (const RoleName& known : role_names) {
      if (known.name == name) {
        return known.role;
      }
    }
    fail(found->label + " is " + in_quotes(name) +
         "; allowed are \"plate\", \"real\", \"virtual\" and \"start\"");
  }

  static bool is_for(HapticRole role, std::string_view key) {
    switch (role) {
      case HapticRole::plate:
        return key == "name" || key == "radius_m" || key == "max_speed_deg_s";
      case HapticRole::real:
        return key == "name" || key == "radius_m";
      case HapticRole::virtual_target:
        return key == "name" || key == "radius_m" || key == "served_by";
      case HapticRole::start:
        return key == "name";
    }
    return false;
  }

  static std::string allowed_text(HapticRole role) {
    std::string text = "allowed are role";
    for (const char* key : {"name", "radius_m", "max_speed_deg_s", "served_by"}) {
      if (is_for(role, key)) {
        text += std::string(", ") + key;
      }
    }
    return text;
  }

  std::string text(const Property& property) const {
    if (!property.value->is_string()) {
      fail(property.label + " is not a string");
    }
    std::string value = property.value->get<std::string>();
    if (value.empty() || value.size() > longest_text) {
      fail(property.label + " has " + std::to_string(value.size()) + " bytes; allowed are 1 to " +
           std::to_string(longest_text));
    }
    if (value != printable(value)) {
      fail(property.label + " is " + in_quotes(value) + ", with a control character in it");
    }
    return value;
  }

  double number(const Property& property, double largest) const {
    if (!property.value->is_number()) {
      fail(property.label + " is not a number");
    }
    const double value = property.value->get<double>();
    if (!(value > 0.0 && value <= largest)) {
      fail(property.label + " is " + number_text(value) + "; allowed is more than 0, up to " +
           number_text(largest));
    }
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
std::string shown(const std::string& key) {
  const std::string quoted = in_quotes(key);
  return quoted.substr(1, quoted.size() - 2);
}

}  // namespace

bool is_haptic(const nlohmann::json& extras) {
  if (!extras.is_object()) {
    return false;
  }
  const auto items = extras.items();
  return extras.contains(nested_key) || std::any_of(items.begin(), items.end(), [](const auto& item) {
           return item.key().starts_with(flat_prefix);
         });
}

HapticProperties haptic_properties(const nlohmann::json& extras, const std::string& where) {
  std::vector<Property> flat;
  for (const auto& [key, value] : extras.items()) {
    if (key.starts_with(flat_prefix)) {
      flat.push_back({key.substr(flat_prefix.size()), "extras." + shown(key), &value});
    }
  }
  const auto nested = extras.find(nested_key);
  if (nested == extras.end()) {
    return Reader(std::move(flat), where).read();
  }
  if (!flat.empty()) {
    throw SceneError(where + "both extras.haptic and " + flat.front().label + " are given; keep one form");
  }
  if (!nested->is_object() || nested->empty()) {
    throw SceneError(where + "extras.haptic is not an object with a role");
  }
  std::vector<Property> properties;
  for (const auto& [key, value] : nested->items()) {
    properties.push_back({key, "extras.haptic." + shown(key), &value});
  }
  return Reader(std::move(properties), where).read();
}

}  // namespace hrt
