#include "samples/mock_runtime/api/negotiation.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "samples/mock_runtime/api/entry.h"

namespace hrt::mock {
namespace {

// Read now, so that xrCreateInstance itself can be given a fault. xrCreateInstance reports a mistake in the
// script: the negotiation cannot.
void load_script() {
  Runtime& the = runtime();
  const std::lock_guard lock(the.mutex);
  the.script_error.clear();
  the.log.open();
  try {
    // The same script as before continues: what it orders once happens once in a process.
    const std::string text = script_from_environment();
    if (text != the.script_text) the.apply(text);
  } catch (const Error& error) {
    the.script_error = std::string(std::getenv("HRT_MOCK_SCRIPT")) + ": " + error.why;
    std::fprintf(stderr, "mock runtime: HRT_MOCK_SCRIPT: %s\n", the.script_error.c_str());
  }
}

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
  if (loader->min_api_version > max_api_version || loader->max_api_version < min_api_version)
    return XR_ERROR_INITIALIZATION_FAILED;
  load_script();
  request->runtime_interface_version = interface_version;
  request->runtime_api_version = std::min(max_api_version, loader->max_api_version);
  request->get_instance_proc_addr = &Entry<FunctionId::xrGetInstanceProcAddr, &get_instance_proc_addr>::call;
  return XR_SUCCESS;
}

}  // namespace
}  // namespace hrt::mock

/// The only exported symbol, where a loader starts.
extern "C" __attribute__((visibility("default"))) XRAPI_ATTR XrResult XRAPI_CALL
xrNegotiateLoaderRuntimeInterface(const hrt::mock::NegotiateLoaderInfo* loader,
                                  hrt::mock::NegotiateRuntimeRequest* request) {
  try {
    return hrt::mock::negotiate(loader, request);
  } catch (...) {
    return XR_ERROR_INITIALIZATION_FAILED;
  }
}
