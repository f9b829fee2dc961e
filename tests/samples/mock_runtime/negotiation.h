// The runtime without a loader in between, which hides some rules, and Debian's all of OpenXR 1.1.
#pragma once

#include <dlfcn.h>

#include "samples/mock_runtime/abi/negotiation.h"
#include "tests/samples/mock_runtime/support.h"

namespace hrt::mock {

class MockNegotiation : public ::testing::Test {
 protected:
  void SetUp() override {
    library = dlopen(HRT_MOCK_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(library, nullptr) << dlerror();
    negotiate = reinterpret_cast<Negotiate>(dlsym(library, "xrNegotiateLoaderRuntimeInterface"));
    ASSERT_NE(negotiate, nullptr);
  }
  void TearDown() override { dlclose(library); }

  template <typename Function>
  Function fetch_direct(XrInstance of, const char* name) {
    PFN_xrVoidFunction function = nullptr;
    EXPECT_XR(XR_SUCCESS, request.get_instance_proc_addr(of, name, &function)) << name;
    return reinterpret_cast<Function>(function);
  }
  template <typename Function>
  Function direct(const char* name) {
    return fetch_direct<Function>(instance, name);
  }
  XrResult create_direct(const std::vector<const char*>& names, XrVersion version) {
    XrInstanceCreateInfo info = instance_info(names);
    info.applicationInfo.apiVersion = version;
    return fetch_direct<PFN_xrCreateInstance>(XR_NULL_HANDLE, "xrCreateInstance")(&info, &instance);
  }
  void destroy_direct() { EXPECT_XR(XR_SUCCESS, direct<PFN_xrDestroyInstance>("xrDestroyInstance")(instance)); }
  XrPath path(const std::string& text) {
    XrPath made = XR_NULL_PATH;
    EXPECT_XR(XR_SUCCESS, direct<PFN_xrStringToPath>("xrStringToPath")(instance, text.c_str(), &made));
    return made;
  }
  /// Of this type, in a set of its own.
  XrAction only_action(XrActionType type) {
    const XrActionSetCreateInfo of_set = set_info("set", "set");
    XrActionSet set = XR_NULL_HANDLE;
    EXPECT_XR(XR_SUCCESS, direct<PFN_xrCreateActionSet>("xrCreateActionSet")(instance, &of_set, &set));
    const XrActionCreateInfo of_action = action_info("only", "only", type);
    XrAction made = XR_NULL_HANDLE;
    EXPECT_XR(XR_SUCCESS, direct<PFN_xrCreateAction>("xrCreateAction")(set, &of_action, &made));
    return made;
  }
  XrResult suggest(XrAction action, const std::string& profile, const std::string& source) {
    const XrActionSuggestedBinding binding{action, path(source)};
    const XrInteractionProfileSuggestedBinding info{XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING, nullptr,
                                                    path("/interaction_profiles/" + profile), 1, &binding};
    return direct<PFN_xrSuggestInteractionProfileBindings>("xrSuggestInteractionProfileBindings")(instance, &info);
  }

  using Negotiate = XrResult(XRAPI_PTR*)(const NegotiateLoaderInfo*, NegotiateRuntimeRequest*);
  void* library = nullptr;
  Negotiate negotiate = nullptr;
  XrInstance instance = XR_NULL_HANDLE;
  NegotiateLoaderInfo loader{loader_info_type,
                             struct_version,
                             sizeof(NegotiateLoaderInfo),
                             1,
                             1,
                             XR_MAKE_VERSION(1, 0, 0),
                             XR_MAKE_VERSION(1, 1, 0xFFFFFFFF)};
  NegotiateRuntimeRequest request{runtime_request_type, struct_version, sizeof(NegotiateRuntimeRequest), 0, 0, nullptr};
};

}  // namespace hrt::mock
