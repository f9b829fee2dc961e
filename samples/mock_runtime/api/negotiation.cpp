// Entry into the runtime: negotiation with a loader, and xrGetInstanceProcAddr over the table of all functions.
#include "samples/mock_runtime/abi/negotiation.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "samples/mock_runtime/api/entry.h"

namespace hrt::mock {
namespace {

// Reads the script before xrCreateInstance, so that a fault of that call can be injected. xrCreateInstance reports a
// mistake in the script, since the negotiation cannot.
void load_script() {
  Runtime& the = runtime();
  const std::lock_guard lock(the.mutex);
  the.script_error.clear();
  the.log.open();
  try {
    // An unchanged script continues: its faults occur once per process.
    const std::string text = script_from_environment();
    if (text != the.script_text) the.apply(text);
  } catch (const Error& error) {
    the.script_error = std::string(std::getenv("HRT_MOCK_SCRIPT")) + ": " + error.why;
    std::fprintf(stderr, "mock runtime: HRT_MOCK_SCRIPT: %s\n", the.script_error.c_str());
  }
}

XrResult negotiate(const NegotiateLoaderInfo* loader, NegotiateRuntimeRequest* request) {
  if (!agrees(loader, request) || loader->min_api_version > max_api_version ||
      loader->max_api_version < min_api_version)
    return XR_ERROR_INITIALIZATION_FAILED;
  load_script();
  request->runtime_interface_version = interface_version;
  request->runtime_api_version = std::min(max_api_version, loader->max_api_version);
  request->get_instance_proc_addr =
      &Entry<FunctionId::xrGetInstanceProcAddr, PFN_xrGetInstanceProcAddr, true, &get_instance_proc_addr>::call;
  return XR_SUCCESS;
}

// Entry points, indexed by FunctionId.
const PFN_xrVoidFunction entries[] = {
#define HRT_MOCK_ENTRY(name, implementation, extension, returned) \
  reinterpret_cast<PFN_xrVoidFunction>(                           \
      &Entry<FunctionId::name, PFN_##name, takes_handles(#name), &(implementation)>::call),
    HRT_MOCK_FUNCTIONS(HRT_MOCK_ENTRY)
#undef HRT_MOCK_ENTRY
};

bool needs_no_instance(std::string_view name) {
  return name == "xrEnumerateInstanceExtensionProperties" || name == "xrEnumerateApiLayerProperties" ||
         name == "xrCreateInstance" || name == "xrGetInstanceProcAddr";
}

}  // namespace

void get_instance_proc_addr(XrInstance handle, const char* name, PFN_xrVoidFunction* function) {
  require_pointer(function, "function");
  *function = nullptr;
  require_pointer(name, "name");
  const Instance* instance = nullptr;
  if (handle != XR_NULL_HANDLE)
    instance = &runtime().registry.get_even_lost<Instance>(handle);
  else
    require(needs_no_instance(name), XR_ERROR_HANDLE_INVALID, "this function needs an instance");
  const auto id = find_function(name);
  require(id.has_value(), XR_ERROR_FUNCTION_UNSUPPORTED, "no such function");
  const Extension needed = functions[static_cast<std::size_t>(*id)].needed;
  require(needed == Extension::core || instance->enabled(needed), XR_ERROR_FUNCTION_UNSUPPORTED,
          "its extension or version is not enabled");
  *function = entries[static_cast<std::size_t>(*id)];
}

}  // namespace hrt::mock

/// The only exported symbol, which a loader calls first.
extern "C" __attribute__((visibility("default"))) XRAPI_ATTR XrResult XRAPI_CALL xrNegotiateLoaderRuntimeInterface(
    const hrt::mock::NegotiateLoaderInfo* loader, hrt::mock::NegotiateRuntimeRequest* request) {
  try {
    return hrt::mock::negotiate(loader, request);
  } catch (...) {
    return XR_ERROR_INITIALIZATION_FAILED;
  }
}
