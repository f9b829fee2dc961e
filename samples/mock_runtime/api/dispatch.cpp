// xrGetInstanceProcAddr, over the table of all functions.
#include <cstring>

#include "samples/mock_runtime/api/entry.h"
#include "samples/mock_runtime/api/instance.h"
#include "samples/mock_runtime/extensions.h"

namespace hrt::mock {
namespace {

struct Row {
  const char* name;
  PFN_xrVoidFunction function;
  Extension extension;
};

const Row function_table[] = {
#define HRT_MOCK_ROW(name, implementation, extension, returned)                                    \
  {#name, reinterpret_cast<PFN_xrVoidFunction>(&Entry<FunctionId::name, &(implementation)>::call), \
   Extension::extension},
    HRT_MOCK_FUNCTIONS(HRT_MOCK_ROW)
#undef HRT_MOCK_ROW
};

bool needs_no_instance(const char* name) {
  return std::strcmp(name, "xrEnumerateInstanceExtensionProperties") == 0 ||
         std::strcmp(name, "xrEnumerateApiLayerProperties") == 0 ||
         std::strcmp(name, "xrCreateInstance") == 0 || std::strcmp(name, "xrGetInstanceProcAddr") == 0;
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
  for (const Row& row : function_table) {
    if (std::strcmp(row.name, name) != 0) continue;
    if (row.extension != Extension::core)
      require(instance->enabled(row.extension), XR_ERROR_FUNCTION_UNSUPPORTED,
              "its extension or version is not enabled");
    *function = row.function;
    return;
  }
  throw Error{XR_ERROR_FUNCTION_UNSUPPORTED, "no such function"};
}

}  // namespace hrt::mock
