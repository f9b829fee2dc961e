// The interaction profiles of OpenXR 1.0: "Interaction Profile Paths" of the specification.
#include <algorithm>
#include <map>
#include <set>

#include "samples/mock_runtime/input/paths.h"

namespace hrt::mock {
namespace {

constexpr std::string_view hands = "left right";

// Inputs and outputs of an interaction profile. Components are separated by spaces; they are below input/, unless they
// begin with output/. a/b|c means a/b and a/c.
struct Part {
  std::string_view profile;  // below /interaction_profiles/
  std::string_view devices;  // top level user paths, separated by spaces: left and right are below /user/hand/
  std::string_view components;
};

constexpr Part parts[] = {
    {"khr/simple_controller", hands, "select/click menu/click grip/pose aim/pose output/haptic"},
    {"google/daydream_controller", hands, "select/click trackpad/x|y|click|touch grip/pose aim/pose"},
    {"htc/vive_controller", hands,
     "system/click squeeze/click menu/click trigger/click|value trackpad/x|y|click|touch grip/pose aim/pose "
     "output/haptic"},
    {"htc/vive_pro", "head", "system/click volume_up/click volume_down/click mute_mic/click"},
    {"microsoft/motion_controller", hands,
     "menu/click squeeze/click trigger/value thumbstick/x|y|click trackpad/x|y|click|touch grip/pose aim/pose "
     "output/haptic"},
    {"microsoft/xbox_controller", "gamepad",
     "menu/click view/click a/click b/click x/click y/click dpad_down/click dpad_right/click dpad_up/click "
     "dpad_left/click shoulder_left/click shoulder_right/click thumbstick_left/x|y|click thumbstick_right/x|y|click "
     "trigger_left/value trigger_right/value output/haptic_left output/haptic_right output/haptic_left_trigger "
     "output/haptic_right_trigger"},
    {"oculus/go_controller", hands,
     "system/click trigger/click back/click trackpad/x|y|click|touch grip/pose aim/pose"},
    {"oculus/touch_controller", "left", "x/click|touch y/click|touch menu/click"},
    {"oculus/touch_controller", "right", "a/click|touch b/click|touch system/click"},
    {"oculus/touch_controller", hands,
     "squeeze/value trigger/value|touch thumbstick/x|y|click|touch thumbrest/touch grip/pose aim/pose output/haptic"},
    {"valve/index_controller", hands,
     "system/click|touch a/click|touch b/click|touch squeeze/value|force trigger/click|value|touch "
     "thumbstick/x|y|click|touch trackpad/x|y|force|touch grip/pose aim/pose output/haptic"},
};

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> found;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    found.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return found;
}

std::string user_path(std::string_view device) {
  return (device == "left" || device == "right" ? "/user/hand/" : "/user/") + std::string(device);
}

using Profiles = std::map<std::string, std::set<std::string>, std::less<>>;

// Inputs have a path of their own, such as ".../trigger", besides those of their components, ".../trigger/value".
Profiles make_profiles() {
  Profiles made;
  for (const Part& part : parts)
    for (const std::string_view device : split(part.devices, ' '))
      for (const std::string_view component : split(part.components, ' ')) {
        auto& paths = made["/interaction_profiles/" + std::string(part.profile)];
        const std::size_t slash = component.find('/');
        const bool is_output = component.starts_with("output/");
        const std::string parent = user_path(device) + (is_output ? "/" : "/input/") + std::string(component, 0, slash);
        if (!is_output) paths.insert(parent);
        for (const std::string_view leaf : split(component.substr(slash + 1), '|'))
          paths.insert(parent + '/' + std::string(leaf));
      }
  return made;
}

}  // namespace

std::string_view top_level_of(std::string_view path) {
  for (const std::string_view top :
       {"/user/hand/left", "/user/hand/right", "/user/head", "/user/gamepad", "/user/treadmill"})
    if (path == top || (path.starts_with(top) && path[top.size()] == '/')) return top;
  return {};
}

const std::set<std::string>* find_profile(std::string_view profile) {
  static const Profiles profiles = make_profiles();
  const auto found = profiles.find(profile);
  return found == profiles.end() ? nullptr : &found->second;
}

}  // namespace hrt::mock
