// What the tests of the layer in samples/mock_runtime/capture share.
#pragma once

#include <cstdlib>
#include <cstring>
#include <fstream>

#include "tests/samples/mock_runtime/support.h"
#include "tests/samples/process.h"

namespace hrt::mock {

/// All that an application was given, byte after byte.
struct Given {
  std::string bytes;
  int active = 0;    ///< hands
  int failures = 0;  ///< of xrLocateHandJointsEXT
  std::vector<XrSessionState> states;

  template <typename Value>
  void add(const Value& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
};

/// A test that captures an application and plays it back.
class CaptureFixture : public MockRuntime {
 protected:
  void SetUp() override {}
  void TearDown() override {
    for (const char* name : {"XR_ENABLE_API_LAYERS", "XR_API_LAYER_PATH", "HRT_CAPTURE_FILE",
                             "HRT_MOCK_SCRIPT", "XDG_DATA_HOME", "HRT_CAPTURE_DISABLE"})
      unsetenv(name);
    setenv("XR_RUNTIME_JSON", HRT_MOCK_MANIFEST, 1);
  }

  void capture_to(const std::string& file) {
    setenv("XR_ENABLE_API_LAYERS", "XR_APILAYER_HRTX_capture", 1);
    setenv("XR_API_LAYER_PATH", HRT_CAPTURE_MANIFESTS, 1);
    setenv("HRT_CAPTURE_FILE", file.c_str(), 1);
  }
  void play(const std::string& file) {
    TearDown();
    setenv("HRT_MOCK_SCRIPT", file.c_str(), 1);
  }
  void script(const std::string& text) {
    std::ofstream(folder / "script.json") << text;
    setenv("HRT_MOCK_SCRIPT", (folder / "script.json").c_str(), 1);
  }

  XrResult create_instance(const std::vector<const char*>& extensions = {
                               XR_MND_HEADLESS_EXTENSION_NAME, XR_EXT_HAND_TRACKING_EXTENSION_NAME}) {
    const XrInstanceCreateInfo info = instance_info(extensions);
    return xrCreateInstance(&info, &instance);
  }
  void create_session() {
    const XrSystemGetInfo get{XR_TYPE_SYSTEM_GET_INFO, nullptr, XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY};
    ASSERT_XR(XR_SUCCESS, xrGetSystem(instance, &get, &system));
    XrSystemHandTrackingPropertiesEXT hands{XR_TYPE_SYSTEM_HAND_TRACKING_PROPERTIES_EXT};
    XrSystemProperties properties{XR_TYPE_SYSTEM_PROPERTIES, &hands};
    ASSERT_XR(XR_SUCCESS, xrGetSystemProperties(instance, system, &properties));
    given.bytes += properties.systemName;
    MockRuntime::create_session();
    running = ended = false;
  }
  void poll() {
    XrEventDataBuffer event{XR_TYPE_EVENT_DATA_BUFFER};
    for (; xrPollEvent(instance, &event) == XR_SUCCESS; event = {XR_TYPE_EVENT_DATA_BUFFER}) {
      given.add(event.type);
      if (event.type == XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING) {
        const auto& change = reinterpret_cast<const XrEventDataReferenceSpaceChangePending&>(event);
        EXPECT_EQ(change.session, session);
        given.add(change.changeTime);
        given.add(change.poseInPreviousSpace);
      }
      if (event.type != XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED) continue;
      const auto& change = reinterpret_cast<const XrEventDataSessionStateChanged&>(event);
      EXPECT_EQ(change.session, session);
      given.add(change.state);
      given.add(change.time);
      given.states.push_back(change.state);
      if (change.state == XR_SESSION_STATE_READY) {
        focus();
        running = true;
      }
      if (change.state == XR_SESSION_STATE_STOPPING) {
        ASSERT_XR(XR_SUCCESS, xrEndSession(session));
        running = false;
      }
      ended = ended || change.state == XR_SESSION_STATE_EXITING;
    }
  }
  XrTime frame() {
    XrFrameState state{XR_TYPE_FRAME_STATE};
    EXPECT_XR(XR_SUCCESS, xrWaitFrame(session, nullptr, &state));
    EXPECT_XR(XR_SUCCESS, xrBeginFrame(session, nullptr));
    const XrFrameEndInfo end{XR_TYPE_FRAME_END_INFO,           nullptr, state.predictedDisplayTime,
                             XR_ENVIRONMENT_BLEND_MODE_OPAQUE, 0,       nullptr};
    EXPECT_XR(XR_SUCCESS, xrEndFrame(session, &end));
    given.add(state.predictedDisplayTime);
    given.add(state.predictedDisplayPeriod);
    given.add(state.shouldRender);
    return state.predictedDisplayTime;
  }
  void end() {
    EXPECT_XR(XR_SUCCESS, xrRequestExitSession(session));
    while (!ended) {
      poll();
      if (running) frame();
    }
    EXPECT_XR(XR_SUCCESS, xrDestroySession(session));
    EXPECT_XR(XR_SUCCESS, xrDestroyInstance(instance));
  }

  TemporaryFolder folder;
  bool running = false;
  bool ended = false;
  Given given;
};

}  // namespace hrt::mock
