// The structures with which a loader and a runtime, or an API layer, agree on an interface: OpenXR loader
// specification, "Loader/Runtime Negotiation" and "Loader/API Layer Negotiation", interface version 1.
// Debian's OpenXR 1.0.20 ships no header for them.
#pragma once

#include <openxr/openxr.h>

#include <cstddef>
#include <cstdint>

namespace hrt::mock {

inline constexpr std::uint32_t loader_info_type = 1;        // XR_LOADER_INTERFACE_STRUCT_LOADER_INFO
inline constexpr std::uint32_t api_layer_request_type = 2;  // XR_LOADER_INTERFACE_STRUCT_API_LAYER_REQUEST
inline constexpr std::uint32_t runtime_request_type = 3;    // XR_LOADER_INTERFACE_STRUCT_RUNTIME_REQUEST
inline constexpr std::uint32_t interface_version = 1;       // XR_CURRENT_LOADER_RUNTIME_VERSION, ..._API_LAYER_VERSION
inline constexpr std::uint32_t struct_version = 1;          // of every structure
/// Of OpenXR itself, whatever the headers that this is built with.
inline constexpr XrVersion min_api_version = XR_MAKE_VERSION(1, 0, 0);
inline constexpr XrVersion max_api_version = XR_MAKE_VERSION(1, 1, 47);

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

/// An API layer, or the runtime, behind a layer.
struct ApiLayerCreateInfo;
using PFN_create_api_layer_instance = XrResult(XRAPI_PTR*)(const XrInstanceCreateInfo* info,
                                                           const ApiLayerCreateInfo* layers, XrInstance* instance);
struct ApiLayerNextInfo {
  std::uint32_t struct_type;
  std::uint32_t struct_version;
  std::size_t struct_size;
  char layer_name[XR_MAX_API_LAYER_NAME_SIZE];  ///< that this entry is for
  PFN_xrGetInstanceProcAddr next_get_instance_proc_addr;
  PFN_create_api_layer_instance next_create_api_layer_instance;
  ApiLayerNextInfo* next;
};

struct ApiLayerCreateInfo {
  std::uint32_t struct_type;
  std::uint32_t struct_version;
  std::size_t struct_size;
  void* loader_instance;
  char settings_file_location[512];
  ApiLayerNextInfo* next_info;
};

struct NegotiateApiLayerRequest {
  std::uint32_t struct_type;
  std::uint32_t struct_version;
  std::size_t struct_size;
  std::uint32_t layer_interface_version;
  XrVersion layer_api_version;
  PFN_xrGetInstanceProcAddr get_instance_proc_addr;
  PFN_create_api_layer_instance create_api_layer_instance;
};

/// Whether a loader of this interface asks by a structure of this type.
template <typename Request>
bool agrees(const NegotiateLoaderInfo* loader, const Request* request, std::uint32_t request_type) {
  return loader != nullptr && request != nullptr && loader->struct_type == loader_info_type &&
         loader->struct_version == struct_version && loader->struct_size == sizeof *loader &&
         request->struct_type == request_type && request->struct_version == struct_version &&
         request->struct_size == sizeof *request && loader->min_interface_version <= interface_version &&
         loader->max_interface_version >= interface_version;
}

static_assert(sizeof(NegotiateApiLayerRequest) == 48);
static_assert(sizeof(ApiLayerNextInfo) == 16 + XR_MAX_API_LAYER_NAME_SIZE + 24);
static_assert(sizeof(ApiLayerCreateInfo) == 16 + 8 + 512 + 8);
static_assert(sizeof(NegotiateLoaderInfo) == 40 && sizeof(NegotiateRuntimeRequest) == 40);

}  // namespace hrt::mock
