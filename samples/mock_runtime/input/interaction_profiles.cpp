// The interaction profiles of OpenXR 1.0 and 1.1: specification, "Interaction Profile Paths".
#include <algorithm>
#include <map>
#include <set>

#include "samples/mock_runtime/input/paths.h"

namespace hrt::mock {
namespace {

constexpr std::string_view hands = "left right";

// Components that several profiles have. Names are below input/, or with output/ in front, separated by spaces; a/b|c
// is a/b and a/c.
constexpr std::string_view touch_left = "x/click|touch y/click|touch menu/click";
constexpr std::string_view touch_right = "a/click|touch b/click|touch system/click";
constexpr std::string_view touch_both =
    "squeeze/value trigger/value|touch thumbstick/x|y|click|touch grip/pose aim/pose output/haptic";
constexpr std::string_view touch_proximity = "trigger/proximity thumb_resting_surfaces/proximity";
constexpr std::string_view pico =
    "system/click squeeze/click|value trigger/click|touch|value thumbstick/x|y|click|touch grip/pose aim/pose "
    "output/haptic";
constexpr std::string_view microsoft_motion =
    "menu/click squeeze/click trigger/value thumbstick/x|y|click trackpad/x|y|click|touch grip/pose aim/pose "
    "output/haptic";

struct Part {
  std::string_view profiles;  // below /interaction_profiles/, separated by spaces
  std::string_view devices;
  std::string_view components;
};

constexpr Part parts_of_1_0[] = {
    {"khr/simple_controller", hands, "select/click menu/click grip/pose aim/pose output/haptic"},
    {"google/daydream_controller", hands, "select/click trackpad/x|y|click|touch grip/pose aim/pose"},
    {"htc/vive_controller", hands,
     "system/click squeeze/click menu/click trigger/click|value trackpad/x|y|click|touch grip/pose aim/pose "
     "output/haptic"},
    {"htc/vive_pro", "head", "system/click volume_up/click volume_down/click mute_mic/click"},
    {"microsoft/motion_controller", hands, microsoft_motion},
    {"microsoft/xbox_controller", "gamepad",
     "menu/click view/click a/click b/click x/click y/click dpad_down/click dpad_right/click dpad_up/click "
     "dpad_left/click shoulder_left/click shoulder_right/click thumbstick_left/x|y|click thumbstick_right/x|y|click "
     "trigger_left/value trigger_right/value output/haptic_left output/haptic_right output/haptic_left_trigger "
     "output/haptic_right_trigger"},
    {"oculus/go_controller", hands,
     "system/click trigger/click back/click trackpad/x|y|click|touch grip/pose aim/pose"},
    {"oculus/touch_controller", "left", touch_left},
    {"oculus/touch_controller", "right", touch_right},
    {"oculus/touch_controller", hands, touch_both},
    {"oculus/touch_controller", hands, "thumbrest/touch"},
    {"valve/index_controller", hands,
     "system/click|touch a/click|touch b/click|touch squeeze/value|force trigger/click|value|touch "
     "thumbstick/x|y|click|touch trackpad/x|y|force|touch grip/pose aim/pose output/haptic"},
};

constexpr std::string_view meta_touch =
    "meta/touch_controller_rift_cv1 meta/touch_controller_quest_1_rift_s meta/touch_controller_quest_2 "
    "meta/touch_plus_controller meta/touch_pro_controller";

constexpr Part parts_of_1_1[] = {
    {"oculus/touch_controller", hands, touch_proximity},
    {meta_touch, "left", touch_left},
    {meta_touch, "right", touch_right},
    {meta_touch, hands, touch_both},
    {meta_touch, hands, touch_proximity},
    {"meta/touch_controller_rift_cv1 meta/touch_controller_quest_2 meta/touch_plus_controller "
     "meta/touch_pro_controller",
     hands, "thumbrest/touch"},
    {"meta/touch_plus_controller", hands, "trigger/force trigger_slide/value trigger_curl/value"},
    {"meta/touch_pro_controller", hands,
     "stylus/force trigger_slide/value trigger_curl/value thumbrest/force output/haptic_thumb output/haptic_trigger"},
    {"bytedance/pico_neo3_controller bytedance/pico4_controller", "left", "x/click|touch y/click|touch"},
    {"bytedance/pico_neo3_controller bytedance/pico4_controller", "right", "a/click|touch b/click|touch"},
    {"bytedance/pico_neo3_controller bytedance/pico4_controller", hands, pico},
    {"bytedance/pico_neo3_controller", hands, "menu/click"},
    {"bytedance/pico4_controller", "left", "menu/click"},
    // Older registries lack x and y of its thumbstick, a mistake: KhronosGroup/OpenXR-Docs, 158.
    {"bytedance/pico_g3_controller", hands, "trigger/click|value menu/click thumbstick/x|y|click grip/pose aim/pose"},
    {"hp/mixed_reality_controller", "left", "x/click y/click"},
    {"hp/mixed_reality_controller", "right", "a/click b/click"},
    {"hp/mixed_reality_controller", hands,
     "menu/click squeeze/value trigger/value thumbstick/x|y|click grip/pose aim/pose output/haptic"},
    {"htc/vive_cosmos_controller htc/vive_focus3_controller", "left", "x/click y/click menu/click"},
    {"htc/vive_cosmos_controller htc/vive_focus3_controller", "right", "a/click b/click system/click"},
    {"htc/vive_cosmos_controller", hands,
     "shoulder/click squeeze/click trigger/click|value thumbstick/x|y|click|touch grip/pose aim/pose output/haptic"},
    {"htc/vive_focus3_controller", hands,
     "squeeze/click|touch|value trigger/click|touch|value thumbstick/x|y|click|touch thumbrest/touch grip/pose "
     "aim/pose output/haptic"},
    {"ml/ml2_controller", hands,
     "menu/click home/click trigger/click|value trackpad/x|y|click|force|touch shoulder/click grip/pose aim/pose "
     "output/haptic"},
    {"samsung/odyssey_controller", hands, microsoft_motion},
};

std::vector<std::string_view> words(std::string_view text, char separator = ' ') {
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

// Adds sources and the parents of inputs, such as ".../trigger" of ".../trigger/value".
void add_part(const Part& part, Profiles& made) {
  for (const std::string_view profile : words(part.profiles))
    for (const std::string_view device : words(part.devices))
      for (const std::string_view component : words(part.components)) {
        auto& paths = made["/interaction_profiles/" + std::string(profile)];
        const std::size_t slash = component.find('/');
        const bool is_output = component.starts_with("output/");
        const std::string parent = user_path(device) + (is_output ? "/" : "/input/") + std::string(component, 0, slash);
        if (!is_output) paths.insert(parent);
        for (const std::string_view leaf : words(component.substr(slash + 1), '|'))
          paths.insert(parent + '/' + std::string(leaf));
      }
}

Profiles make_profiles(bool version_1_1) {
  Profiles made;
  for (const Part& part : parts_of_1_0) add_part(part, made);
  if (!version_1_1) return made;
  for (const Part& part : parts_of_1_1) add_part(part, made);
  for (auto& [profile, paths] : made)
    for (const char* hand : {"/user/hand/left/input/", "/user/hand/right/input/"})
      if (paths.contains(std::string(hand) + "grip"))
        paths.insert({std::string(hand) + "grip_surface", std::string(hand) + "grip_surface/pose"});
  return made;
}

}  // namespace

const std::vector<std::string>& top_level_paths() {
  static const std::vector<std::string> paths{"/user/hand/left", "/user/hand/right", "/user/head", "/user/gamepad",
                                              "/user/treadmill"};
  return paths;
}

std::string_view top_level_of(std::string_view path) {
  for (const std::string& top : top_level_paths())
    if (path == top || (path.starts_with(top) && path[top.size()] == '/')) return top;
  return {};
}

const std::set<std::string>* find_profile(std::string_view profile, bool version_1_1) {
  static const Profiles of_1_0 = make_profiles(false), of_1_1 = make_profiles(true);
  const Profiles& profiles = version_1_1 ? of_1_1 : of_1_0;
  const auto found = profiles.find(profile);
  return found == profiles.end() ? nullptr : &found->second;
}

}  // namespace hrt::mock
