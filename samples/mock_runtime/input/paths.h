// XrPath values and their texts, and the input and output paths of the interaction profiles.
#pragma once

#include <openxr/openxr.h>

#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace hrt::mock {

/// True if `name` may be a component of a path: one or more of a-z, 0-9, '-', '_' and '.', but not periods only.
bool is_path_component(std::string_view name);

/// Maps the XrPath values of an instance to their texts and back.
class PathTable {
 public:
  /// Returns the path of a text. Throws XR_ERROR_PATH_FORMAT_INVALID if the text is not well formed.
  XrPath intern(std::string_view text);

  /// Returns the text of a path. Throws XR_ERROR_PATH_INVALID unless intern() has returned the path.
  const std::string& text(XrPath path) const;

 private:
  std::vector<std::string> texts_;  // element i is the text of path i + 1
  std::unordered_map<std::string, XrPath> paths_;
};

/// Returns the top level user path in which `path` lies, such as "/user/hand/left" for
/// "/user/hand/left/input/select/click"; empty if there is no such path.
std::string_view top_level_of(std::string_view path);

/// Returns the input and output paths of an interaction profile of OpenXR 1.0; null if there is no such profile.
const std::set<std::string>* find_profile(std::string_view profile);

}  // namespace hrt::mock
