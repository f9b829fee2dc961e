// The interaction profiles of OpenXR 1.0 and 1.1: specification, "Interaction Profile Paths".
#include <algorithm>
#include <array>
#include <map>

#include "samples/mock_runtime/input/paths.h"

namespace hrt::mock {
namespace {

constexpr std::string_view hands = "left right";

// Devices, and their components: names below input/, or with output/ in front, separated by spaces; a/b|c is a/b and
// a/c.
struct Part {
  std::string_view devices;
  std::string_view components;
  bool version_1_1 = false;  // not of OpenXR 1.0
};

struct Profile {
  std::string_view path;  // below /interaction_profiles/
  std::vector<Part> parts;
};

// What the controllers of one family have in common.
constexpr std::string_view face_buttons_left = "x/click|touch y/click|touch menu/click";
constexpr std::string_view face_buttons_right = "a/click|touch b/click|touch system/click";
constexpr std::string_view oculus_touch =
    "squeeze/value trigger/value|touch thumbstick/x|y|click|touch grip/pose aim/pose output/haptic";
constexpr std::string_view thumbrest = "thumbrest/touch";
constexpr std::string_view proximity = "trigger/proximity thumb_resting_surfaces/proximity";
constexpr std::string_view pico =
    "system/click squeeze/click|value trigger/click|touch|value thumbstick/x|y|click|touch grip/pose aim/pose "
    "output/haptic";
constexpr std::string_view microsoft_motion =
    "menu/click squeeze/click trigger/value thumbstick/x|y|click trackpad/x|y|click|touch grip/pose aim/pose "
    "output/haptic";

// A controller of Oculus or Meta.
std::vector<Part> touch(bool version_1_1, const std::vector<Part>& further) {
  std::vector<Part> parts{{"left", face_buttons_left, version_1_1},
                          {"right", face_buttons_right, version_1_1},
                          {hands, oculus_touch, version_1_1},
                          {hands, proximity, true}};
  parts.insert(parts.end(), further.begin(), further.end());
  return parts;
}

const std::vector<Profile>& profile_table() {
  static const std::vector<Profile> table{
      {"khr/simple_controller", {{hands, "select/click menu/click grip/pose aim/pose output/haptic"}}},
      {"google/daydream_controller", {{hands, "select/click trackpad/x|y|click|touch grip/pose aim/pose"}}},
      {"htc/vive_controller",
       {{hands,
         "system/click squeeze/click menu/click trigger/click|value trackpad/x|y|click|touch grip/pose aim/pose "
         "output/haptic"}}},
      {"htc/vive_pro", {{"head", "system/click volume_up/click volume_down/click mute_mic/click"}}},
      {"microsoft/motion_controller", {{hands, microsoft_motion}}},
      {"microsoft/xbox_controller",
       {{"gamepad",
         "menu/click view/click a/click b/click x/click y/click dpad_down/click dpad_right/click dpad_up/click "
         "dpad_left/click shoulder_left/click shoulder_right/click thumbstick_left/x|y|click "
         "thumbstick_right/x|y|click trigger_left/value trigger_right/value output/haptic_left output/haptic_right "
         "output/haptic_left_trigger output/haptic_right_trigger"}}},
      {"oculus/go_controller",
       {{hands, "system/click trigger/click back/click trackpad/x|y|click|touch grip/pose aim/pose"}}},
      {"oculus/touch_controller", touch(false, {{hands, thumbrest}})},
      {"valve/index_controller",
       {{hands,
         "system/click|touch a/click|touch b/click|touch squeeze/value|force trigger/click|value|touch "
         "thumbstick/x|y|click|touch trackpad/x|y|force|touch grip/pose aim/pose output/haptic"}}},
      {"bytedance/pico_neo3_controller",
       {{"left", "x/click|touch y/click|touch", true},
        {"right", "a/click|touch b/click|touch", true},
        {hands, "menu/click", true},
        {hands, pico, true}}},
      {"bytedance/pico4_controller",
       {{"left", "x/click|touch y/click|touch menu/click", true},
        {"right", "a/click|touch b/click|touch", true},
        {hands, pico, true}}},
      // Older registries lack x and y of its thumbstick, a mistake: KhronosGroup/OpenXR-Docs, 158.
      {"bytedance/pico_g3_controller",
       {{hands, "trigger/click|value menu/click thumbstick/x|y|click grip/pose aim/pose", true}}},
      {"hp/mixed_reality_controller",
       {{"left", "x/click y/click", true},
        {"right", "a/click b/click", true},
        {hands, "menu/click squeeze/value trigger/value thumbstick/x|y|click grip/pose aim/pose output/haptic", true}}},
      {"htc/vive_cosmos_controller",
       {{"left", "x/click y/click menu/click", true},
        {"right", "a/click b/click system/click", true},
        {hands,
         "shoulder/click squeeze/click trigger/click|value thumbstick/x|y|click|touch grip/pose aim/pose output/haptic",
         true}}},
      {"htc/vive_focus3_controller",
       {{"left", "x/click y/click menu/click", true},
        {"right", "a/click b/click system/click", true},
        {hands,
         "squeeze/click|touch|value trigger/click|touch|value thumbstick/x|y|click|touch thumbrest/touch grip/pose "
         "aim/pose output/haptic",
         true}}},
      {"meta/touch_controller_rift_cv1", touch(true, {{hands, thumbrest, true}})},
      {"meta/touch_controller_quest_1_rift_s", touch(true, {})},
      {"meta/touch_controller_quest_2", touch(true, {{hands, thumbrest, true}})},
      {"meta/touch_plus_controller",
       touch(true, {{hands, thumbrest, true}, {hands, "trigger/force trigger_slide/value trigger_curl/value", true}})},
      {"meta/touch_pro_controller", touch(true, {{hands, thumbrest, true},
                                                 {hands,
                                                  "stylus/force trigger_slide/value trigger_curl/value thumbrest/force "
                                                  "output/haptic_thumb output/haptic_trigger",
                                                  true}})},
      {"ml/ml2_controller",
       {{hands,
         "menu/click home/click trigger/click|value trackpad/x|y|click|force|touch shoulder/click grip/pose aim/pose "
         "output/haptic",
         true}}},
      {"samsung/odyssey_controller", {{hands, microsoft_motion, true}}},
  };
  return table;
}

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

Source make_source(std::string_view device, std::string_view component) {
  if (component.starts_with("output/")) return {user_path(device) + '/' + std::string(component), SourceKind::haptic};
  const std::string_view leaf = component.substr(component.find('/') + 1);
  const SourceKind kind = leaf == "click" || leaf == "touch" || leaf == "proximity" ? SourceKind::boolean
                          : leaf == "pose"                                          ? SourceKind::pose
                                                                                    : SourceKind::scalar;
  return {user_path(device) + "/input/" + std::string(component), kind};
}

using ProfileSources = std::map<std::string, std::vector<Source>, std::less<>>;

// The pose of the palm is wherever there is a grip.
ProfileSources make_profiles(const SourceSet& set) {
  ProfileSources made;
  for (const Profile& profile : profile_table())
    for (const Part& part : profile.parts) {
      if (part.version_1_1 && !set.version_1_1) continue;
      auto& sources = made["/interaction_profiles/" + std::string(profile.path)];
      for (const std::string_view device : words(part.devices))
        for (const std::string_view component : words(part.components)) {
          const std::size_t leaves = component.find('/') + 1;
          for (const std::string_view leaf : words(component.substr(leaves), '|'))
            sources.push_back(make_source(device, std::string(component.substr(0, leaves)).append(leaf)));
          if (component != "grip/pose") continue;
          if (set.grip_surface) sources.push_back(make_source(device, "grip_surface/pose"));
          if (set.palm_pose) sources.push_back(make_source(device, "palm_ext/pose"));
        }
    }
  return made;
}

const ProfileSources& profiles_of(SourceSet set) {
  static const auto all = [] {
    std::array<ProfileSources, 8> made;
    for (unsigned i = 0; i < made.size(); ++i) made[i] = make_profiles({(i & 1U) != 0, (i & 2U) != 0, (i & 4U) != 0});
    return made;
  }();
  return all[(set.version_1_1 ? 1U : 0U) + (set.palm_pose ? 2U : 0U) + (set.grip_surface ? 4U : 0U)];
}

// Whether a source of this kind can drive an action; floats and booleans convert to each other.
bool can_drive(SourceKind kind, XrActionType type) {
  switch (type) {
    case XR_ACTION_TYPE_BOOLEAN_INPUT:
    case XR_ACTION_TYPE_FLOAT_INPUT:
      return kind == SourceKind::boolean || kind == SourceKind::scalar;
    case XR_ACTION_TYPE_POSE_INPUT:
      return kind == SourceKind::pose;
    case XR_ACTION_TYPE_VIBRATION_OUTPUT:
      return kind == SourceKind::haptic;
    default:
      return false;
  }
}

// The components of a parent that an action can use, best first.
std::vector<std::string_view> preferred_components(XrActionType type) {
  switch (type) {
    case XR_ACTION_TYPE_BOOLEAN_INPUT:
      return {"click", "value", "force", "touch"};
    case XR_ACTION_TYPE_FLOAT_INPUT:
      return {"value", "force", "click", "touch"};
    case XR_ACTION_TYPE_POSE_INPUT:
      return {"pose"};
    default:
      return {};
  }
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

const std::vector<Source>* find_profile(std::string_view profile, const SourceSet& set) {
  const ProfileSources& profiles = profiles_of(set);
  const auto found = profiles.find(profile);
  return found == profiles.end() ? nullptr : &found->second;
}

const Source* find_source(std::string_view path) {
  for (const auto& [name, sources] : profiles_of({}))
    for (const Source& source : sources)
      if (source.path == path) return &source;
  return nullptr;
}

std::optional<std::vector<Source>> resolve_binding(const std::vector<Source>& profile, std::string_view path,
                                                   XrActionType type) {
  const auto find = [&](const std::string& wanted) {
    return std::find_if(profile.begin(), profile.end(), [&](const Source& source) { return source.path == wanted; });
  };
  const std::string text(path);
  if (const auto leaf = find(text); leaf != profile.end())
    return can_drive(leaf->kind, type) ? std::vector{*leaf} : std::vector<Source>{};
  const bool is_parent = std::any_of(profile.begin(), profile.end(), [&](const Source& source) {
    return source.path.rfind('/') == text.size() && source.path.starts_with(text) && source.kind != SourceKind::haptic;
  });
  if (!is_parent) return std::nullopt;
  if (type == XR_ACTION_TYPE_VECTOR2F_INPUT) {
    const auto x = find(text + "/x");
    const auto y = find(text + "/y");
    return x != profile.end() && y != profile.end() ? std::vector{*x, *y} : std::vector<Source>{};
  }
  for (const std::string_view component : preferred_components(type))
    if (const auto child = find(text + '/' + std::string(component)); child != profile.end())
      return std::vector{*child};
  return std::vector<Source>{};
}

}  // namespace hrt::mock
