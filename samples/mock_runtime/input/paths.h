// Path atoms, and the input sources of the core interaction profiles.
#pragma once

#include <openxr/openxr.h>

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace hrt::mock {

/// True for a name that may be a component of a path: a-z, 0-9, '-', '_' and '.', not periods alone.
bool is_path_component(std::string_view name);

/// The path atoms of an instance.
class PathTable {
 public:
  /// The atom of a string. Throws XR_ERROR_PATH_FORMAT_INVALID.
  XrPath intern(std::string_view text);

  /// Throws XR_ERROR_PATH_INVALID unless the path is an atom of this instance.
  const std::string& text(XrPath path) const;

 private:
  std::vector<std::string> texts_;  // of path 1, 2, ...
  std::unordered_map<std::string, XrPath> atoms_;
};

/// The top level user paths that actions can be bound to.
const std::vector<std::string>& top_level_paths();

/// "/user/hand/left" of "/user/hand/left/input/select/click"; empty without one.
std::string_view top_level_of(std::string_view path);

enum class SourceKind { boolean, scalar, pose, haptic };

/// One input or output of an interaction profile: "/user/hand/left/input/select/click".
struct Source {
  std::string path;
  SourceKind kind;
};

/// Which sources interaction profiles have.
struct SourceSet {
  bool version_1_1 = true;   ///< those of OpenXR 1.1, or of 1.0
  bool palm_pose = true;     ///< and of XR_EXT_palm_pose
  bool grip_surface = true;  ///< and of XR_KHR_maintenance1, which 1.1 has
};

/// The sources of an interaction profile, or null if there is no such profile.
const std::vector<Source>* find_profile(std::string_view profile, const SourceSet& set = {});

/// The sources that drive an action of `type` bound to `path`, a source or the parent of sources: one, or x
/// and y of a vector. An empty list if they cannot drive that type; none if the profile has no such path.
std::optional<std::vector<Source>> resolve_binding(const std::vector<Source>& profile, std::string_view path,
                                                   XrActionType type);

/// The source of this path in any profile, or null.
const Source* find_source(std::string_view path);

}  // namespace hrt::mock
