// The structures with which a loader and a runtime agree on an interface: OpenXR loader specification,
// "Loader/Runtime Negotiation", interface version 1. Debian's OpenXR 1.0.20 ships no header for them.
#pragma once

#include <openxr/openxr.h>

#include <cstddef>
#include <cstdint>

namespace hrt::mock {

inline constexpr std::uint32_t loader_info_type = 1;      // XR_LOADER_INTERFACE_STRUCT_LOADER_INFO
inline constexpr std::uint32_t runtime_request_type = 3;  // XR_LOADER_INTERFACE_STRUCT_RUNTIME_REQUEST
inline constexpr std::uint32_t interface_version = 1;     // XR_CURRENT_LOADER_RUNTIME_VERSION
inline constexpr std::uint32_t struct_version = 1;        // of both structures
inline constexpr XrVersion runtime_api_version = XR_CURRENT_API_VERSION;

struct NegotiateLoaderInfo {
  std::uint32_t struct_type;
  std::uint32_t struct_version;
  std::size_t struct_size;
  std::uint32_t min_interface_version;
  std::uint32_t max_interface_version;
  XrVersion min_api_version;
  XrVersion max_api_version;
};

struct NegotiateRuntimeRequest {
  std::uint32_t struct_type;
  std::uint32_t struct_version;
  std::size_t struct_size;
  std::uint32_t runtime_interface_version;
  XrVersion runtime_api_version;
  PFN_xrGetInstanceProcAddr get_instance_proc_addr;
};

static_assert(sizeof(NegotiateLoaderInfo) == 40 && sizeof(NegotiateRuntimeRequest) == 40);

}  // namespace hrt::mock
