// Fixtures for tests of the mock runtime. MockRuntime uses Khronos' loader, as an application does; MockNegotiation
// calls the runtime without a loader.
#pragma once

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "samples/mock_runtime/abi/negotiation.h"
#include "samples/mock_runtime/abi/structure.h"
#include "tests/samples/process.h"

namespace hrt::mock {

inline constexpr XrSystemGetInfo head_mounted{XR_TYPE_SYSTEM_GET_INFO, nullptr, XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY};
inline constexpr XrPosef identity_pose{{0.0F, 0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, 0.0F}};

#define EXPECT_XR(expected, call) EXPECT_EQ(name_of(expected), name_of(call))
#define ASSERT_XR(expected, call) ASSERT_EQ(name_of(expected), name_of(call))

/// Returns a function of the loader by its name. An unknown name fails the test.
template <typename Function>
Function fetch(XrInstance instance, const char* name) {
  PFN_xrVoidFunction function = nullptr;
  EXPECT_XR(XR_SUCCESS, xrGetInstanceProcAddr(instance, name, &function));
  return reinterpret_cast<Function>(function);
}

/// Calls a function that takes an object and an info structure and writes one output; returns its result.
template <typename Object, typename Info, typename Output>
XrResult result_of(XrResult(XRAPI_PTR* call)(Object, const Info*, Output*), std::type_identity_t<Object> object,
                   const std::type_identity_t<Info>& info, Output&& made = {}) {
  if constexpr (Typed<Output>) made.type = structure_type<Output>.type;
  return call(object, &info, &made);
}
/// Calls a function like result_of(), expects success and returns the output.
template <typename Object, typename Info, typename Output>
Output output(XrResult(XRAPI_PTR* call)(Object, const Info*, Output*), std::type_identity_t<Object> object,
              const std::type_identity_t<Info>& info) {
  Output made{};
  EXPECT_XR(XR_SUCCESS, result_of(call, object, info, std::move(made)));
  return made;
}

/// Returns the creation info of an instance with these extensions. `extensions` must outlive the info.
XrInstanceCreateInfo instance_info(const std::vector<const char*>& extensions);

/// The extensions for headless tests under the manual clock.
const std::vector<const char*>& default_extensions();

/// An application with one instance, and a session if the test creates one.
class Application : public ::testing::Test {
 protected:
  virtual PFN_xrVoidFunction look_up(const char* name) = 0;
#define XR(name) reinterpret_cast<PFN_##name>(look_up(#name))

  void create_session();
  void focus();

  XrPath path(const std::string& text);

  struct Hand {
    bool active = false;
    std::array<XrHandJointLocationEXT, XR_HAND_JOINT_COUNT_EXT> joints{};
    std::array<XrHandJointVelocityEXT, XR_HAND_JOINT_COUNT_EXT> velocities{};
    const XrVector3f& index_tip() const { return joints[XR_HAND_JOINT_INDEX_TIP_EXT].pose.position; }
  };
  XrHandTrackerEXT create_hand_tracker(XrHandEXT which = XR_HAND_RIGHT_EXT);
  Hand locate_hand(XrHandTrackerEXT tracker, XrSpace space, XrTime time);

  XrSpace create_space(XrReferenceSpaceType type, const XrPosef& pose = identity_pose);
  XrSpaceLocation located(XrSpace space, XrSpace base, XrTime time, XrSpaceVelocity* velocity = nullptr);

  /// Waits for, begins and ends one frame. Returns the predicted display time.
  XrTime frame();

  XrInstance instance = XR_NULL_HANDLE;
  XrSystemId system = 1;
  XrSession session = XR_NULL_HANDLE;
  XrSpace local = XR_NULL_HANDLE;
  XrHandTrackerEXT hand = XR_NULL_HANDLE;
};

/// Fixture with an instance that is created through the loader and enables the given extensions.
class MockRuntime : public Application {
 protected:
  explicit MockRuntime(std::vector<const char*> enabled = default_extensions(), bool creates_instance = true)
      : extensions(std::move(enabled)), creates_instance_(creates_instance) {}
  void SetUp() override;
  void TearDown() override;
  PFN_xrVoidFunction look_up(const char* name) override { return fetch<PFN_xrVoidFunction>(instance, name); }

  /// Calls create_session() and focus(), and reads all events.
  void begin_session();
  /// Replaces the script and the instance.
  void apply(const std::string& script);
  XrResult try_apply(const std::string& script);
  XrResult create_instance();
  void destroy_instance();
  /// Calls apply() and begin_session(), and creates `local` and `hand`.
  void begin_with(const std::string& script);

  /// Returns the next event of this type and drops earlier events.
  template <typename Event>
  std::optional<Event> next_event(XrStructureType type) {
    XrEventDataBuffer event{XR_TYPE_EVENT_DATA_BUFFER};
    for (; xrPollEvent(instance, &event) == XR_SUCCESS; event = {XR_TYPE_EVENT_DATA_BUFFER})
      if (event.type == type) return reinterpret_cast<const Event&>(event);
    return std::nullopt;
  }
  /// Reads all events and returns the session states that they report.
  std::vector<XrSessionState> all_states();

  std::string last_call();

  /// Places a plate with a radius of 75 mm at the origin of `in`.
  void place_plate(XrSpace in);
  void instruct(double goal_deg = 5.0, const XrVector3f& start = {}, double length_m = 0.1);
  XrReachTruthHRTX truth();

  std::vector<const char*> extensions;
  TemporaryFolder folder;  ///< folder of the script and the call log

 private:
  bool creates_instance_;
};

/// Fixture that negotiates with the runtime itself: loaders check some arguments before the runtime does.
class MockNegotiation : public Application {
 protected:
  void SetUp() override {
    library = dlopen(HRT_MOCK_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(library, nullptr) << dlerror();
    negotiate = reinterpret_cast<Negotiate>(dlsym(library, "xrNegotiateLoaderRuntimeInterface"));
    ASSERT_NE(negotiate, nullptr);
  }
  void TearDown() override { dlclose(library); }

  template <typename Function>
  Function function_of(XrInstance of, const char* name) {
    PFN_xrVoidFunction function = nullptr;
    EXPECT_XR(XR_SUCCESS, request.get_instance_proc_addr(of, name, &function)) << name;
    return reinterpret_cast<Function>(function);
  }
  PFN_xrVoidFunction look_up(const char* name) override { return function_of<PFN_xrVoidFunction>(instance, name); }

  using Negotiate = XrResult(XRAPI_PTR*)(const NegotiateLoaderInfo*, NegotiateRuntimeRequest*);
  void* library = nullptr;
  Negotiate negotiate = nullptr;
  NegotiateLoaderInfo loader{loader_info_type, struct_version,           sizeof loader, 1, 1,
                             min_api_version,  XR_MAKE_VERSION(1, 1, 47)};
  NegotiateRuntimeRequest request{runtime_request_type, struct_version, sizeof(NegotiateRuntimeRequest), 0, 0, nullptr};
};

}  // namespace hrt::mock
