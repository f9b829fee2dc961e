// The interaction profiles of OpenXR 1.0 and 1.1: specification, "Interaction Profile Paths".
#include <algorithm>
#include <array>
#include <map>

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

Source make_source(std::string_view device, std::string_view component) {
  if (component.starts_with("output/")) return {user_path(device) + '/' + std::string(component), SourceKind::haptic};
  const std::string_view leaf = component.substr(component.find('/') + 1);
  const SourceKind kind = leaf == "click" || leaf == "touch" || leaf == "proximity" ? SourceKind::boolean
                          : leaf == "pose"                                          ? SourceKind::pose
                                                                                    : SourceKind::scalar;
  return {user_path(device) + "/input/" + std::string(component), kind};
}

using ProfileSources = std::map<std::string, std::vector<Source>, std::less<>>;

// Poses of the palm are where there is a grip.
void add_part(const Part& part, const SourceSet& set, ProfileSources& made) {
  for (const std::string_view profile : words(part.profiles))
    for (const std::string_view device : words(part.devices))
      for (const std::string_view component : words(part.components)) {
        auto& sources = made["/interaction_profiles/" + std::string(profile)];
        const std::size_t leaves = component.find('/') + 1;
        for (const std::string_view leaf : words(component.substr(leaves), '|'))
          sources.push_back(make_source(device, std::string(component.substr(0, leaves)).append(leaf)));
        if (component != "grip/pose") continue;
        if (set.grip_surface) sources.push_back(make_source(device, "grip_surface/pose"));
        if (set.palm_pose) sources.push_back(make_source(device, "palm_ext/pose"));
      }
}

ProfileSources make_profiles(const SourceSet& set) {
  ProfileSources made;
  for (const Part& part : parts_of_1_0) add_part(part, set, made);
  for (const Part& part : parts_of_1_1)
    if (set.version_1_1) add_part(part, set, made);
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
