// The layer's way in: negotiation with a loader, the instance, and the functions in front of the runtime's.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

#include "samples/mock_runtime/abi/negotiation.h"
#include "samples/mock_runtime/capture/capture.h"

namespace hrt::capture {
namespace {

using mock::ApiLayerCreateInfo;
using mock::ApiLayerNextInfo;

Capture& capture() {
  // Never destroyed: a thread may be within a call when the process ends.
  static Capture& the_capture = *new Capture;
  return the_capture;
}

template <typename Function>
struct Wrapper;

template <typename... Args>
struct Wrapper<XrResult (*)(Args...)> {
  template <const char* name, auto next, auto note>
  static XRAPI_ATTR XrResult XRAPI_CALL call(Args... args) noexcept {
    Capture& the = capture();
    const std::uint64_t session = the.session_of_call();
    const XrResult result = (the.next.*next)(args...);
    try {
      const std::lock_guard lock(the.mutex);
      the.called(name, session, result);
      if (XR_SUCCEEDED(result)) note(the, result, args...);
    } catch (...) {
      // The capture lacks this call, the application does not.
    }
    return result;
  }
};

#define HRT_CAPTURE_NAME(name, member) constexpr char name_of_##name[] = #name;
HRT_CAPTURE_FUNCTIONS(HRT_CAPTURE_NAME)
#undef HRT_CAPTURE_NAME

XRAPI_ATTR XrResult XRAPI_CALL get_instance_proc_addr(XrInstance instance, const char* name,
                                                      PFN_xrVoidFunction* function) noexcept {
  const XrResult result = capture().next.xrGetInstanceProcAddr(instance, name, function);
  if (XR_FAILED(result)) return result;
#define HRT_CAPTURE_WRAP(function_name, member)                                            \
  if (std::strcmp(name, #function_name) == 0)                                              \
    *function = reinterpret_cast<PFN_xrVoidFunction>(                                      \
        &Wrapper<PFN_##function_name>::call<name_of_##function_name, &Next::function_name, \
                                            [](Capture& the, const auto&... given) { the.member(given...); }>);
  HRT_CAPTURE_FUNCTIONS(HRT_CAPTURE_WRAP)
#undef HRT_CAPTURE_WRAP
  return result;
}

template <typename Function>
void fetch(PFN_xrGetInstanceProcAddr get, XrInstance instance, const char* name, Function& function) {
  PFN_xrVoidFunction found = nullptr;
  function = XR_SUCCEEDED(get(instance, name, &found)) ? reinterpret_cast<Function>(found) : nullptr;
}

void fetch_all(Next& next, PFN_xrGetInstanceProcAddr get, XrInstance instance) {
#define HRT_CAPTURE_FETCH(name, member) fetch(get, instance, #name, next.name);
  HRT_CAPTURE_FUNCTIONS(HRT_CAPTURE_FETCH)
#undef HRT_CAPTURE_FETCH
  fetch(get, instance, "xrGetInstanceProperties", next.xrGetInstanceProperties);
  fetch(get, instance, "xrEnumerateReferenceSpaces", next.xrEnumerateReferenceSpaces);
}

XrResult refuse(XrResult result, const std::string& why) {
  std::fprintf(stderr, "OpenXR capture: %s\n", why.c_str());
  return result;
}

XRAPI_ATTR XrResult XRAPI_CALL create_instance(const XrInstanceCreateInfo* info, const ApiLayerCreateInfo* layers,
                                               XrInstance* instance) noexcept {
  if (info == nullptr || instance == nullptr || layers == nullptr || layers->next_info == nullptr ||
      layers->struct_size != sizeof(ApiLayerCreateInfo) || layers->next_info->struct_size != sizeof(ApiLayerNextInfo))
    return XR_ERROR_INITIALIZATION_FAILED;
  const char* path = std::getenv("HRT_CAPTURE_FILE");
  if (path == nullptr || *path == '\0')
    return refuse(XR_ERROR_INITIALIZATION_FAILED, "HRT_CAPTURE_FILE names no file to write");
  Capture& the = capture();
  const std::lock_guard lock(the.mutex);
  if (the.has_instance())
    return refuse(XR_ERROR_LIMIT_REACHED, "an instance is being captured already; one at a time is");
  try {
    the.open(path);
    // What this layer was given is for it; the next one has its own part.
    ApiLayerCreateInfo further = *layers;
    further.next_info = layers->next_info->next;
    const ApiLayerNextInfo& next = *layers->next_info;
    const XrResult result = next.next_create_api_layer_instance(info, &further, instance);
    if (XR_FAILED(result)) return result;
    the.next.xrGetInstanceProcAddr = next.next_get_instance_proc_addr;
    fetch_all(the.next, next.next_get_instance_proc_addr, *instance);
    the.instance_created(*instance, *info);
    return result;
  } catch (const std::system_error& error) {
    return refuse(XR_ERROR_INITIALIZATION_FAILED, error.what());
  } catch (const std::bad_alloc&) {
    return XR_ERROR_OUT_OF_MEMORY;
  }
}

}  // namespace
}  // namespace hrt::capture

/// The only exported symbol, where a loader starts.
extern "C" __attribute__((visibility("default"))) XRAPI_ATTR XrResult XRAPI_CALL xrNegotiateLoaderApiLayerInterface(
    const hrt::mock::NegotiateLoaderInfo* loader, const char*, hrt::mock::NegotiateApiLayerRequest* request) {
  using namespace hrt::mock;
  if (!agrees(loader, request, api_layer_request_type)) return XR_ERROR_INITIALIZATION_FAILED;
  request->layer_interface_version = interface_version;
  request->layer_api_version = max_api_version;
  request->get_instance_proc_addr = &hrt::capture::get_instance_proc_addr;
  request->create_api_layer_instance = &hrt::capture::create_instance;
  return XR_SUCCESS;
}
