// Access to the runtime without a loader: loaders hide some rules, and Debian's hides OpenXR 1.1.
#pragma once

#include <dlfcn.h>

#include "samples/mock_runtime/abi/negotiation.h"
#include "tests/samples/mock_runtime/support.h"

namespace hrt::mock {

class MockNegotiation : public Application {
 protected:
  void SetUp() override {
    library = dlopen(HRT_MOCK_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(library, nullptr) << dlerror();
    negotiate = reinterpret_cast<Negotiate>(dlsym(library, "xrNegotiateLoaderRuntimeInterface"));
    ASSERT_NE(negotiate, nullptr);
  }
  void TearDown() override { dlclose(library); }

  PFN_xrVoidFunction look_up_of(XrInstance of, const char* name) {
    PFN_xrVoidFunction function = nullptr;
    EXPECT_XR(XR_SUCCESS, request.get_instance_proc_addr(of, name, &function)) << name;
    return function;
  }
  PFN_xrVoidFunction look_up(const char* name) override { return look_up_of(instance, name); }
  XrResult create_direct(const std::vector<const char*>& names, XrVersion version) {
    XrInstanceCreateInfo info = instance_info(names);
    info.applicationInfo.apiVersion = version;
    return reinterpret_cast<PFN_xrCreateInstance>(look_up_of(XR_NULL_HANDLE, "xrCreateInstance"))(&info, &instance);
  }
  void destroy_direct() { EXPECT_XR(XR_SUCCESS, XR(xrDestroyInstance)(instance)); }

  using Negotiate = XrResult(XRAPI_PTR*)(const NegotiateLoaderInfo*, NegotiateRuntimeRequest*);
  void* library = nullptr;
  Negotiate negotiate = nullptr;
  static constexpr XrVersion latest = XR_MAKE_VERSION(1, 1, 0xFFFFFFFF);
  NegotiateLoaderInfo loader{loader_info_type, struct_version, sizeof loader, 1, 1, min_api_version, latest};
  NegotiateRuntimeRequest request{runtime_request_type, struct_version, sizeof(NegotiateRuntimeRequest), 0, 0, nullptr};
};

}  // namespace hrt::mock
