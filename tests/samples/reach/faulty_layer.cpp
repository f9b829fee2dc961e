// An API layer that injects faults which a script of the mock runtime cannot: with HRT_FAULT="FUNCTION CALL WHAT", call
// number CALL of a function locks a stream and blocks (WHAT is stdout or stderr), refuses a type as unknown, or gives
// an impossible time or pose.
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

// What is wrong with this call; empty: nothing.
std::string fault_of(const char* function) {
  static const Fault fault;
  static int calls = 0;
  if (fault.function != function || ++calls != fault.call) return "";
  if (fault.what == "stdout" || fault.what == "stderr") {
    flockfile(fault.what == "stdout" ? stdout : stderr);
    block();
  }
  return fault.what;
}

template <class Function>
Function next(XrInstance instance, const char* name) {
  PFN_xrVoidFunction found = nullptr;
  next_get(instance, name, &found);
  return reinterpret_cast<Function>(found);
}

XrInstance the_instance = XR_NULL_HANDLE;

XRAPI_ATTR XrResult XRAPI_CALL wait_frame(XrSession session, const XrFrameWaitInfo* info, XrFrameState* state) {
  const std::string fault = fault_of("xrWaitFrame");
  const XrResult result = next<PFN_xrWaitFrame>(the_instance, "xrWaitFrame")(session, info, state);
  if (fault == "no_time") state->predictedDisplayTime = 0;
  if (fault == "later") state->predictedDisplayTime += 27LL * 86'400 * 1'000'000'000;
  return result;
}

// The runtime knows its own times only.
XRAPI_ATTR XrResult XRAPI_CALL end_frame(XrSession session, const XrFrameEndInfo* info) {
  const XrResult result = next<PFN_xrEndFrame>(the_instance, "xrEndFrame")(session, info);
  return result == XR_ERROR_TIME_INVALID ? XR_SUCCESS : result;
}

XRAPI_ATTR XrResult XRAPI_CALL locate_joints(XrHandTrackerEXT tracker, const XrHandJointsLocateInfoEXT* info,
                                             XrHandJointLocationsEXT* locations) {
  const std::string fault = fault_of("xrLocateHandJointsEXT");
  if (fault == "time_invalid") return XR_ERROR_TIME_INVALID;
  const XrResult result =
      next<PFN_xrLocateHandJointsEXT>(the_instance, "xrLocateHandJointsEXT")(tracker, info, locations);
  XrPosef& tip = locations->jointLocations[XR_HAND_JOINT_INDEX_TIP_EXT].pose;
  if (fault == "far_away") tip.position.x = 1e6f;
  if (fault == "no_rotation") tip.orientation = {0.0f, 0.0f, 0.0f, 0.0f};
  return result;
}

XRAPI_ATTR XrResult XRAPI_CALL create_reference_space(XrSession session, const XrReferenceSpaceCreateInfo* info,
                                                      XrSpace* space) {
  if (fault_of("xrCreateReferenceSpace") == "unknown") return XR_ERROR_VALIDATION_FAILURE;
  return next<PFN_xrCreateReferenceSpace>(the_instance, "xrCreateReferenceSpace")(session, info, space);
}

XRAPI_ATTR XrResult XRAPI_CALL get_instance_proc_addr(XrInstance instance, const char* name,
                                                      PFN_xrVoidFunction* function) {
  const XrResult result = next_get(instance, name, function);
  if (XR_FAILED(result)) return result;
  if (std::strcmp(name, "xrWaitFrame") == 0) *function = reinterpret_cast<PFN_xrVoidFunction>(&wait_frame);
  if (std::strcmp(name, "xrEndFrame") == 0) *function = reinterpret_cast<PFN_xrVoidFunction>(&end_frame);
  if (std::strcmp(name, "xrLocateHandJointsEXT") == 0) *function = reinterpret_cast<PFN_xrVoidFunction>(&locate_joints);
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
