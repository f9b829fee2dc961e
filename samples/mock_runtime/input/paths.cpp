#include "samples/mock_runtime/input/paths.h"

#include <algorithm>

#include "samples/mock_runtime/error.h"

namespace hrt::mock {
namespace {

// True if `name` may be a component of a path: one or more of a-z, 0-9, '-', '_' and '.', but not periods only.
bool is_path_component(std::string_view name) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
  };
  return !name.empty() && std::all_of(name.begin(), name.end(), allowed) &&
         name.find_first_not_of('.') != std::string_view::npos;
}

void require_well_formed(std::string_view path) {
  const auto require_format = [&](bool holds, const char* rule) {
    require(holds, XR_ERROR_PATH_FORMAT_INVALID, "path \"{}\": {}", path.substr(0, XR_MAX_PATH_LENGTH), rule);
  };
  require_format(path.starts_with('/'), "must begin with a slash");
  require_format(path.size() < XR_MAX_PATH_LENGTH, "must be at most 255 characters long");
  for (std::size_t begin = 1; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    require_format(is_path_component(path.substr(begin, end - begin)),
                   "each component must have one or more of a-z, 0-9, '-', '_' and '.', and not periods only");
    begin = end + 1;
  }
}

}  // namespace

XrPath PathTable::intern(std::string_view text) {
  require_well_formed(text);
  const auto [found, is_new] = paths_.try_emplace(std::string(text), texts_.size() + 1);
  if (is_new) texts_.emplace_back(text);
  return found->second;
}

const std::string& PathTable::text(XrPath path) const {
  require(path >= 1 && path <= texts_.size(), XR_ERROR_PATH_INVALID,
          "XrPath {} was never returned by xrStringToPath; call it first", path);
  return texts_[path - 1];
}

}  // namespace hrt::mock
