// Fixtures of the mock runtime's tests. Nearly all tests use Khronos' loader, as an application does.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "samples/mock_runtime/abi/structure.h"

namespace hrt::mock {

inline constexpr XrSystemGetInfo head_mounted{XR_TYPE_SYSTEM_GET_INFO, nullptr, XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY};
inline constexpr XrPosef identity_pose{{0.0F, 0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, 0.0F}};

#define EXPECT_XR(expected, call) EXPECT_EQ(result_name(expected), result_name(call))
#define ASSERT_XR(expected, call) ASSERT_EQ(result_name(expected), result_name(call))

/// Returns a function of the loader or the runtime by its name. An unknown name fails the test.
template <typename Function>
Function fetch(XrInstance instance, const char* name) {
  PFN_xrVoidFunction function = nullptr;
  EXPECT_XR(XR_SUCCESS, xrGetInstanceProcAddr(instance, name, &function));
  return reinterpret_cast<Function>(function);
}

/// Result of a call that creates or writes `made`.
template <typename Object, typename Info, typename Output>
XrResult result_of(XrResult(XRAPI_PTR* call)(Object, const Info*, Output*), std::type_identity_t<Object> object,
                   const std::type_identity_t<Info>& info, Output&& made = {}) {
  if constexpr (Typed<Output>) made.type = structure_type<Output>.type;
  return call(object, &info, &made);
}
/// Output of a call, which is expected to succeed.
template <typename Object, typename Info, typename Output>
Output output(XrResult(XRAPI_PTR* call)(Object, const Info*, Output*), std::type_identity_t<Object> object,
              const std::type_identity_t<Info>& info) {
  Output made{};
  EXPECT_XR(XR_SUCCESS, result_of(call, object, info, std::move(made)));
  return made;
}

/// Creation info of an instance with these extensions. Refers to `extensions`.
XrInstanceCreateInfo instance_info(const std::vector<const char*>& extensions);

XrActionSetCreateInfo set_info(const char* name, const char* localized);
/// Creation info of an action. Refers to `subactions`.
XrActionCreateInfo action_info(const char* name, const char* localized, XrActionType type,
                               const std::vector<XrPath>& subactions = {});

/// The extensions that the runtime has under the manual clock.
const std::vector<const char*>& default_extensions();

/// An application with an instance, and on request a session of it.
class Application : public ::testing::Test {
 protected:
  /// Returns a function of the instance. An unknown name fails the test.
  virtual PFN_xrVoidFunction look_up(const char* name) = 0;
#define XR(name) reinterpret_cast<PFN_##name>(look_up(#name))

  void create_session();
  void focus();

  XrPath path(const std::string& text);

  /// All joints of a hand in a space, with velocities.
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

  XrActionSet make_set(const char* name);
  XrAction make_action(XrActionSet in, const char* name, XrActionType type, const std::vector<XrPath>& subactions = {});
  XrResult suggest(const std::string& profile, const std::vector<XrActionSuggestedBinding>& bindings);
  XrResult attach(const std::vector<XrActionSet>& sets);
  XrResult sync(const std::vector<XrActiveActionSet>& sets);
  XrSpace create_action_space(XrAction action);

  /// One frame of the loop. Returns the predicted display time.
  XrTime frame() { return whole_frame().predictedDisplayTime; }
  XrFrameState whole_frame();

  XrInstance instance = XR_NULL_HANDLE;
  XrSystemId system = 1;  ///< id of the only system
  XrSession session = XR_NULL_HANDLE;
  XrSpace local = XR_NULL_HANDLE;
  XrHandTrackerEXT hand = XR_NULL_HANDLE;
};

/// Fixture with an instance that enables all extensions, created through the loader.
class MockRuntime : public Application {
 protected:
  explicit MockRuntime(std::vector<const char*> enabled = default_extensions()) : extensions_(std::move(enabled)) {}
  void SetUp() override;
  void TearDown() override;
  PFN_xrVoidFunction look_up(const char* name) override { return fetch<PFN_xrVoidFunction>(instance, name); }

  /// Calls create_session() and focus(), and reads all events.
  void begin_session();
  void apply(const std::string& script);
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
  /// Returns the next reported session state, or nothing.
  std::optional<XrSessionState> next_state();
  std::vector<XrSessionState> all_states();

  std::vector<XrCallRecordHRTX> call_log();

  /// Places a plate with a radius of 75 mm at the origin of `in`.
  void place_plate(XrSpace in);
  void instruct(double goal_deg = 5.0, const XrVector3f& start = {}, double length_m = 0.1);
  XrReachTruthHRTX truth();

 private:
  std::vector<const char*> extensions_;
};

}  // namespace hrt::mock
