// Refusing a file: what is wrong with it, and where.
#pragma once

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "scene/scene_error.h"

namespace hrt {

/// Throws SceneError: `where` is the file, or a node of it.
template <class... Parts>
[[noreturn]] void refuse(std::string_view where, fmt::format_string<Parts...> what, Parts&&... parts) {
  throw SceneError(fmt::format("{}: {}", where, fmt::format(what, std::forward<Parts>(parts)...)));
}

}  // namespace hrt
