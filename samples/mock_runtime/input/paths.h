#pragma once

#include <openxr/openxr.h>

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace hrt::mock {

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

}  // namespace hrt::mock
