// An API layer that injects faults which a script of the mock runtime cannot: with HRT_FAULT="FUNCTION CALL WHAT", call
// number CALL of xrWaitFrame or xrCreateReferenceSpace locks a stream and blocks (WHAT is stdout or stderr), or refuses
// a type as unknown.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string>

#include "samples/mock_runtime/abi/negotiation.h"

namespace hrt::reach {
namespace {

struct Fault {
  std::string function;
  int call = 0;
  std::string what;

  Fault() {
    const char* ordered = std::getenv("HRT_FAULT");
    std::istringstream(ordered != nullptr ? ordered : "") >> function >> call >> what;
  }
};

PFN_xrGetInstanceProcAddr next_get = nullptr;

[[noreturn]] void block() {
  for (;;) pause();
}

// True if the call is to fail.
bool is_at_fault(const char* function) {
  static const Fault fault;
  static int calls = 0;
  if (fault.function != function || ++calls != fault.call) return false;
  if (fault.what == "stdout" || fault.what == "stderr") {
    flockfile(fault.what == "stdout" ? stdout : stderr);
    block();
  }
  return fault.what == "unknown";
}

template <class Function>
Function next(XrInstance instance, const char* name) {
  PFN_xrVoidFunction found = nullptr;
  next_get(instance, name, &found);
  return reinterpret_cast<Function>(found);
}

XrInstance the_instance = XR_NULL_HANDLE;

XRAPI_ATTR XrResult XRAPI_CALL wait_frame(XrSession session, const XrFrameWaitInfo* info, XrFrameState* state) {
  is_at_fault("xrWaitFrame");
  return next<PFN_xrWaitFrame>(the_instance, "xrWaitFrame")(session, info, state);
}

XRAPI_ATTR XrResult XRAPI_CALL create_reference_space(XrSession session, const XrReferenceSpaceCreateInfo* info,
                                                      XrSpace* space) {
  if (is_at_fault("xrCreateReferenceSpace")) return XR_ERROR_VALIDATION_FAILURE;
  return next<PFN_xrCreateReferenceSpace>(the_instance, "xrCreateReferenceSpace")(session, info, space);
}

XRAPI_ATTR XrResult XRAPI_CALL get_instance_proc_addr(XrInstance instance, const char* name,
                                                      PFN_xrVoidFunction* function) {
  const XrResult result = next_get(instance, name, function);
  if (XR_FAILED(result)) return result;
  if (std::strcmp(name, "xrWaitFrame") == 0) *function = reinterpret_cast<PFN_xrVoidFunction>(&wait_frame);
  if (std::strcmp(name, "xrCreateReferenceSpace") == 0)
    *function = reinterpret_cast<PFN_xrVoidFunction>(&create_reference_space);
  return result;
}

XRAPI_ATTR XrResult XRAPI_CALL create_instance(const XrInstanceCreateInfo* info, const mock::ApiLayerCreateInfo* layers,
                                               XrInstance* instance) {
  mock::ApiLayerCreateInfo further = *layers;
  further.next_info = layers->next_info->next;
  next_get = layers->next_info->next_get_instance_proc_addr;
  const XrResult result = layers->next_info->next_create_api_layer_instance(info, &further, instance);
  the_instance = *instance;
  return result;
}

}  // namespace
}  // namespace hrt::reach

extern "C" __attribute__((visibility("default"))) XRAPI_ATTR XrResult XRAPI_CALL xrNegotiateLoaderApiLayerInterface(
    const hrt::mock::NegotiateLoaderInfo*, const char*, hrt::mock::NegotiateApiLayerRequest* request) {
  request->layer_interface_version = hrt::mock::interface_version;
  request->layer_api_version = hrt::mock::max_api_version;
  request->get_instance_proc_addr = &hrt::reach::get_instance_proc_addr;
  request->create_api_layer_instance = &hrt::reach::create_instance;
  return XR_SUCCESS;
}
