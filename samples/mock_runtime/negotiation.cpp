#include "samples/mock_runtime/negotiation.h"

#include "samples/mock_runtime/entry.h"

namespace hrt::mock {
namespace {

XrResult negotiate(const NegotiateLoaderInfo* loader, NegotiateRuntimeRequest* request) {
  if (loader == nullptr || request == nullptr) return XR_ERROR_INITIALIZATION_FAILED;
  if (loader->struct_type != loader_info_type || loader->struct_version != struct_version ||
      loader->struct_size != sizeof(NegotiateLoaderInfo))
    return XR_ERROR_INITIALIZATION_FAILED;
  if (request->struct_type != runtime_request_type || request->struct_version != struct_version ||
      request->struct_size != sizeof(NegotiateRuntimeRequest))
    return XR_ERROR_INITIALIZATION_FAILED;
  if (loader->min_interface_version > interface_version || loader->max_interface_version < interface_version)
    return XR_ERROR_INITIALIZATION_FAILED;
  if (loader->min_api_version > runtime_api_version || loader->max_api_version < runtime_api_version)
    return XR_ERROR_INITIALIZATION_FAILED;
  request->runtime_interface_version = interface_version;
  request->runtime_api_version = runtime_api_version;
  request->get_instance_proc_addr = &Entry<FunctionId::xrGetInstanceProcAddr, &get_instance_proc_addr>::call;
  return XR_SUCCESS;
}

}  // namespace
}  // namespace hrt::mock

/// The one symbol that the library exports, and where a loader starts.
extern "C" __attribute__((visibility("default"))) XRAPI_ATTR XrResult XRAPI_CALL
xrNegotiateLoaderRuntimeInterface(const hrt::mock::NegotiateLoaderInfo* loader,
                                  hrt::mock::NegotiateRuntimeRequest* request) {
  return hrt::mock::negotiate(loader, request);
}
