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

  template <typename... Values>
  void add(const Values&... values) {
    (bytes.append(reinterpret_cast<const char*>(&values), sizeof values), ...);
  }
};

/// What another runtime might give, as a script: numbers of any bits, uneven frames with a jump, late states, a clock
/// that is not the machine's, calls that fail.
inline std::string odd_recording() {
  std::string all = R"({"playback": {"version": 1, "records": [
    ["instance", "Other \"runtime\"", 1125921381679110, ["XR_MND_headless", "XR_EXT_hand_tracking",
     "XR_KHR_convert_timespec_time"]], ["system", "Other headset", true],
    ["reference_space", 2, [0, 0, 0, 1, 0, 0, 0]], ["reference_space", 2, [0, 0, 0, 1, 0.1, 1e-30, -0.3]],
    ["reference_space", 1, [0, 0, 0, 1, 0, 0, 0]], ["spaces", 1, [2, 1]],
    ["failed", 1, "xrLocateHandJointsEXT", 7, -2], ["failed", 1, "xrLocateHandJointsEXT", 100, -2],
    ["call", 1, "begin"], ["call", 1, "exit"], ["call", 1, "end"],
    ["event", 1, 0, 0, "state", 1, 5], ["event", 1, 0, 0, "state", 2, 6], ["event", 1, 1, 1, "state", 3, 7],
    ["event", 1, 1, 2, "state", 4, 8], ["event", 1, 1, 4, "state", 5, 9],
    ["event", 1, 1, 20, "space_change", 2, 86400412345678, false, [0, 0, 0, 1, 0, "7fc12345", 0]],
    ["event", 1, 2, 1, "state", 6, 10], ["event", 1, 3, 0, "state", 1, 11], ["event", 1, 3, 0, "state", 8, 12])";
  std::uint32_t state = 1;
  const auto bits = [&](int count) {
    std::string list;
    for (char text[16]; count > 0; --count) {
      state = state * 1664525U + 1013904223U;
      std::snprintf(text, sizeof text, "\"%08x\"%s", state, count > 1 ? "," : "");
      list += text;
    }
    return list;
  };
  const auto add = [&](const std::string& kind, const std::string& rest) {
    all += ",\n[\"" + kind + "\",1," + rest + "]";
  };
  for (int i = 0; i < 70; ++i) {
    const XrTime at = 86'400'123'456'789 + i * 13'888'888LL + i * 7919 % 1000 * 1000 + (i > 30 ? 2'000'000'000 : 0);
    const std::string time = std::to_string(at), even = i % 2 == 0 ? "true" : "false";
    add("frame", time + ",13888888," + even);
    add("converted", std::to_string(at + 17));
    for (const char* space : {"1", "2"})
      add("located", time + "," + space + ",0," + (i % 7 == 3 ? "0" : "3") + ",[" + bits(7) + "],2,[" + bits(6) + "]");
    if (i % 3 != 0) continue;  // the nearest counts
    add("views", time + ",1,3,[" + bits(22) + "]");
    for (const char* hand : {"1", "2"}) {
      std::string joints, velocities;
      for (int joint = 0; joint < 26; ++joint) {
        joints += (joint == 0 ? "" : ",") + std::to_string(joint % 16) + "," + bits(8);
        velocities += (joint == 0 ? "" : ",") + std::to_string(joint % 4) + "," + bits(6);
      }
      add("joints",
          time + "," + hand + "," + (i % 2 == 0 ? "0" : "1") + ",true,1,[" + joints + "],[" + velocities + "]");
    }
  }
  return all + "]}}";
}

/// A test that captures an application and plays it back.
class CaptureFixture : public MockRuntime {
 protected:
  void SetUp() override {}
  void TearDown() override {
    for (const char* name : {"XR_ENABLE_API_LAYERS", "XR_API_LAYER_PATH", "HRT_CAPTURE_FILE", "HRT_MOCK_SCRIPT"})
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

  XrResult create_instance(const std::vector<const char*>& extensions = {XR_MND_HEADLESS_EXTENSION_NAME,
                                                                         XR_EXT_HAND_TRACKING_EXTENSION_NAME}) {
    const XrInstanceCreateInfo info = instance_info(extensions);
    return xrCreateInstance(&info, &instance);
  }
  void create_session() {
    system = output(xrGetSystem, instance, head_mounted);
    XrSystemHandTrackingPropertiesEXT hands{XR_TYPE_SYSTEM_HAND_TRACKING_PROPERTIES_EXT};
    XrSystemProperties properties{XR_TYPE_SYSTEM_PROPERTIES, &hands};
    ASSERT_XR(XR_SUCCESS, xrGetSystemProperties(instance, system, &properties));
    given.bytes += properties.systemName;
    Application::create_session();
    running = ended = false;
  }
  void poll() {
    XrEventDataBuffer event{XR_TYPE_EVENT_DATA_BUFFER};
    for (; xrPollEvent(instance, &event) == XR_SUCCESS; event = {XR_TYPE_EVENT_DATA_BUFFER}) {
      given.add(event.type);
      if (event.type == XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING) {
        const auto& change = reinterpret_cast<const XrEventDataReferenceSpaceChangePending&>(event);
        EXPECT_EQ(change.session, session);
        given.add(change.changeTime, change.poseInPreviousSpace);
      }
      if (event.type != XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED) continue;
      const auto& change = reinterpret_cast<const XrEventDataSessionStateChanged&>(event);
      EXPECT_EQ(change.session, session);
      given.add(change.state, change.time);
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
  void run_session() {
    ASSERT_XR(XR_SUCCESS, create_instance());
    create_session();
    while (!running) poll();
  }
  XrTime frame() {
    const XrFrameState state = whole_frame();
    given.add(state.predictedDisplayTime, state.predictedDisplayPeriod, state.shouldRender);
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
