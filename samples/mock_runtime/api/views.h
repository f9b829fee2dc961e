// The two views of the simulated head-mounted display.
#pragma once

#include <openxr/openxr.h>

#include <cstdint>

namespace hrt::mock {

inline constexpr std::uint32_t view_image_width = 1024;
inline constexpr std::uint32_t view_image_height = 1024;

/// Throws unless the system has views of this type.
void require_view_configuration(XrViewConfigurationType type);

}  // namespace hrt::mock
