// Path atoms, and the paths of the core interaction profiles.
#pragma once

#include <openxr/openxr.h>

#include <set>
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

  /// Text of a path. Throws XR_ERROR_PATH_INVALID unless the path is an atom of this instance.
  const std::string& text(XrPath path) const;

 private:
  std::vector<std::string> texts_;  // text of path 1, 2, ...
  std::unordered_map<std::string, XrPath> atoms_;
};

/// The top level user paths that actions can be bound to.
const std::vector<std::string>& top_level_paths();

/// Top level user path, such as "/user/hand/left" of "/user/hand/left/input/select/click"; empty without one.
std::string_view top_level_of(std::string_view path);

/// The binding paths of an interaction profile of OpenXR 1.0 or 1.1; null if there is no such profile.
const std::set<std::string>* find_profile(std::string_view profile, bool version_1_1);

}  // namespace hrt::mock
