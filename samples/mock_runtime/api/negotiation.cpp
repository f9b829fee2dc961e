// Start of the runtime: negotiation with a loader, and xrGetInstanceProcAddr.
#include "samples/mock_runtime/abi/negotiation.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "samples/mock_runtime/api/entry.h"

namespace hrt::mock {
namespace {

// Reads the script before xrCreateInstance, so that the script can inject a fault into that call. After a mistake in
// the script, the negotiation succeeds and xrCreateInstance fails with its reason.
void load_script() {
  Runtime& shared = runtime();
  const std::lock_guard lock(shared.mutex);
  shared.script_error.clear();
  shared.log.open();
  try {
    // A loader negotiates for every instance. An unchanged script is kept, so that past faults do not recur.
    const std::string text = script_from_environment();
    if (text != shared.script_text) shared.apply(text);
  } catch (const Error& error) {
    shared.script_error =
        fmt::format("file {} of HRT_MOCK_SCRIPT (hrtx-run: --script): {}", std::getenv("HRT_MOCK_SCRIPT"), error.why);
    std::fprintf(stderr, "mock runtime: %s\n", shared.script_error.c_str());
  }
}

XrResult negotiate(const NegotiateLoaderInfo* loader, NegotiateRuntimeRequest* request) {
  if (!is_compatible(loader, request)) return XR_ERROR_INITIALIZATION_FAILED;
  load_script();
  request->runtime_interface_version = interface_version;
  request->runtime_api_version = std::min(max_api_version, loader->max_api_version);
  request->get_instance_proc_addr =
      &Entry<FunctionId::xrGetInstanceProcAddr, PFN_xrGetInstanceProcAddr, true, &xrGetInstanceProcAddr>::call;
  return XR_SUCCESS;
}

const PFN_xrVoidFunction entries[] = {
#define HRT_MOCK_ENTRY(extension, name) \
  reinterpret_cast<PFN_xrVoidFunction>( \
      &Entry<FunctionId::name, PFN_##name, takes_handles(#name), &hrt::mock::name>::call),
    HRT_MOCK_FUNCTIONS(HRT_MOCK_ENTRY)
#undef HRT_MOCK_ENTRY
};

bool needs_no_instance(std::string_view name) {
  return name == "xrEnumerateInstanceExtensionProperties" || name == "xrEnumerateApiLayerProperties" ||
         name == "xrCreateInstance" || name == "xrGetInstanceProcAddr";
}

}  // namespace

void xrGetInstanceProcAddr(XrInstance handle, const char* name, PFN_xrVoidFunction* function) {
  require_pointer(function, "function");
  *function = nullptr;
  require_pointer(name, "name");
  const Instance* instance = nullptr;
  if (handle != XR_NULL_HANDLE)
    instance = &runtime().registry.get_even_lost<Instance>(handle);
  else
    require(needs_no_instance(name), XR_ERROR_HANDLE_INVALID,
            "{} needs an instance, but the handle is null; call xrCreateInstance first", name);
  const auto id = find_function(name);
  require(id.has_value(), XR_ERROR_FUNCTION_UNSUPPORTED, "this runtime has no function {}; check its name", name);
  const Extension needed = functions[static_cast<std::size_t>(*id)].needed;
  if (needed != Extension::core)
    require(instance->enabled(needed), XR_ERROR_FUNCTION_UNSUPPORTED, "{} needs the extension {}; enable it", name,
            extensions[static_cast<std::size_t>(needed)].name);
  *function = entries[static_cast<std::size_t>(*id)];
}

}  // namespace hrt::mock

/// The only exported symbol. A loader calls it first.
extern "C" __attribute__((visibility("default"))) XRAPI_ATTR XrResult XRAPI_CALL xrNegotiateLoaderRuntimeInterface(
    const hrt::mock::NegotiateLoaderInfo* loader, hrt::mock::NegotiateRuntimeRequest* request) {
  try {
    return hrt::mock::negotiate(loader, request);
  } catch (...) {
    return XR_ERROR_INITIALIZATION_FAILED;
  }
}
