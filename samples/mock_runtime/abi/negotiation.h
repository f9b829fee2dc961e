// Structures with which a loader and a runtime agree on an interface version: OpenXR loader specification,
// "Loader/Runtime Negotiation". Debian's package of OpenXR 1.0.20 has no header for them.
#pragma once

#include <openxr/openxr.h>

#include <cstddef>
#include <cstdint>

namespace hrt::mock {

inline constexpr std::uint32_t loader_info_type = 1;      // XR_LOADER_INTERFACE_STRUCT_LOADER_INFO
inline constexpr std::uint32_t runtime_request_type = 3;  // XR_LOADER_INTERFACE_STRUCT_RUNTIME_REQUEST
inline constexpr std::uint32_t interface_version = 1;     // XR_CURRENT_LOADER_RUNTIME_VERSION
inline constexpr std::uint32_t struct_version = 1;        // version of both structures
/// OpenXR versions that the runtime supports. 1.0.34 is the last version of 1.0.
inline constexpr XrVersion min_api_version = XR_MAKE_VERSION(1, 0, 0);
inline constexpr XrVersion max_api_version = XR_MAKE_VERSION(1, 0, 34);

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

/// True if both structures are valid and the loader allows this interface version and an OpenXR version of the runtime.
inline bool is_compatible(const NegotiateLoaderInfo* loader, const NegotiateRuntimeRequest* request) {
  return loader != nullptr && request != nullptr && loader->struct_type == loader_info_type &&
         loader->struct_version == struct_version && loader->struct_size == sizeof *loader &&
         request->struct_type == runtime_request_type && request->struct_version == struct_version &&
         request->struct_size == sizeof *request && loader->min_interface_version <= interface_version &&
         loader->max_interface_version >= interface_version && loader->min_api_version <= max_api_version &&
         loader->max_api_version >= min_api_version;
}

static_assert(sizeof(NegotiateLoaderInfo) == 40 && sizeof(NegotiateRuntimeRequest) == 40);

}  // namespace hrt::mock
