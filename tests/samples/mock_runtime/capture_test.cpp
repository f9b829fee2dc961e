// The layer in samples/mock_runtime/capture: what an application was given, played back.
#include <dlfcn.h>

#include <filesystem>

#include "tests/samples/mock_runtime/capture_support.h"
#include "tests/samples/mock_runtime/negotiation.h"

namespace hrt::mock {
namespace {

class MockCapture : public CaptureFixture {
 protected:
  XrHandTrackerEXT track(XrHandEXT which) {
    const XrHandTrackerCreateInfoEXT info{XR_TYPE_HAND_TRACKER_CREATE_INFO_EXT, nullptr, which,
                                          XR_HAND_JOINT_SET_DEFAULT_EXT};
    XrHandTrackerEXT tracker = XR_NULL_HANDLE;
    EXPECT_XR(XR_SUCCESS, fetch<PFN_xrCreateHandTrackerEXT>(instance, "xrCreateHandTrackerEXT")(
                              session, &info, &tracker));
    return tracker;
  }
  using Joints = std::array<XrHandJointLocationEXT, XR_HAND_JOINT_COUNT_EXT>;
  Joints locate_hand(XrHandTrackerEXT tracker, XrSpace base, XrTime time) {
    Joints joints{};
    std::array<XrHandJointVelocityEXT, XR_HAND_JOINT_COUNT_EXT> moving{};
    XrHandJointVelocitiesEXT velocities{XR_TYPE_HAND_JOINT_VELOCITIES_EXT, nullptr, XR_HAND_JOINT_COUNT_EXT,
                                        moving.data()};
    XrHandJointLocationsEXT locations{XR_TYPE_HAND_JOINT_LOCATIONS_EXT, &velocities, XR_FALSE,
                                      XR_HAND_JOINT_COUNT_EXT, joints.data()};
    const XrHandJointsLocateInfoEXT info{XR_TYPE_HAND_JOINTS_LOCATE_INFO_EXT, nullptr, base, time};
    const XrResult result =
        fetch<PFN_xrLocateHandJointsEXT>(instance, "xrLocateHandJointsEXT")(tracker, &info, &locations);
    given.add(result);
    if (XR_FAILED(result)) {
      ++given.failures;
      return joints;
    }
    given.add(locations.isActive);
    if (locations.isActive != XR_TRUE) return joints;
    ++given.active;
    given.add(joints);
    given.add(moving);
    return joints;
  }

  // An application with a head and two hands in two spaces.
  Given run_application() {
    given = {};
    EXPECT_XR(XR_SUCCESS, create_instance());
    XrInstanceProperties properties{XR_TYPE_INSTANCE_PROPERTIES};
    EXPECT_XR(XR_SUCCESS, xrGetInstanceProperties(instance, &properties));
    given.bytes += properties.runtimeName;
    given.add(properties.runtimeVersion);
    create_session();
    std::uint32_t count = 0;
    EXPECT_XR(XR_SUCCESS, xrEnumerateReferenceSpaces(session, 0, &count, nullptr));
    std::vector<XrReferenceSpaceType> types(count);
    EXPECT_XR(XR_SUCCESS, xrEnumerateReferenceSpaces(session, count, &count, types.data()));
    for (const XrReferenceSpaceType type : types) given.add(type);
    local = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL);
    const XrSpace aside = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL, {{0, 0, 0, 1}, {0.1F, 1e-30F, -0.3F}});
    const XrSpace view = create_space(XR_REFERENCE_SPACE_TYPE_VIEW);
    const XrHandTrackerEXT trackers[] = {track(XR_HAND_LEFT_EXT), track(XR_HAND_RIGHT_EXT)};
    for (int frames = 0; frames < 60;) {
      poll();
      if (!running) continue;
      const XrTime time = frame();
      ++frames;
      for (const XrHandTrackerEXT tracker : trackers)
        for (const XrSpace base : {local, aside}) locate_hand(tracker, base, time);
      XrSpaceLocation location{XR_TYPE_SPACE_LOCATION};
      EXPECT_XR(XR_SUCCESS, xrLocateSpace(view, local, time, &location));
      given.add(location.locationFlags);
      given.add(location.pose);
      const XrViewLocateInfo info{XR_TYPE_VIEW_LOCATE_INFO, nullptr,
                                  XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, time, aside};
      XrViewState state{XR_TYPE_VIEW_STATE};
      std::array<XrView, 2> views{{{XR_TYPE_VIEW}, {XR_TYPE_VIEW}}};
      EXPECT_XR(XR_SUCCESS, xrLocateViews(session, &info, &state, 2, &count, views.data()));
      given.add(state.viewStateFlags);
      for (const XrView& each : views) {
        given.add(each.pose);
        given.add(each.fov);
      }
    }
    end();
    return given;
  }
};

const std::string moving_hand = R"({"hands": {"left": {"tracked": true}, "right": {"path": [
    {"time_ms": 0, "position_m": [0.1, -0.3, -0.4]},
    {"time_ms": 2000, "position_m": [-0.2, -0.35, -0.5], "orientation": [0.1, 0.2, -0.3, 0.927362]}]}},
    "head": {"path": [{"time_ms": 0, "position_m": [0, 0, 0]}, {"time_ms": 900, "position_m": [0.1, 0, 0.3]}]},
    "events": [{"frame": 20, "do": "lose_tracking", "hand": "right"},
               {"frame": 30, "do": "regain_tracking", "hand": "right"},
               {"frame": 40, "do": "recenter", "position_m": [0.1, 0, 0], "yaw_deg": 20}]})";

TEST_F(MockCapture, GivesTheSameAgain) {
  script(moving_hand);
  capture_to(folder / "capture.json");
  const Given first = run_application();
  EXPECT_EQ(first.active, 60 * 4 - 20);
  play(folder / "capture.json");
  const Given again = run_application();
  EXPECT_TRUE(first.bytes == again.bytes);
  EXPECT_EQ(first.states, again.states);
}

TEST_F(MockCapture, GivesWhatAnotherRuntimeGave) {
  script(odd_recording());
  capture_to(folder / "capture.json");
  const Given first = run_application();
  EXPECT_EQ(first.failures, 2);
  EXPECT_EQ(first.active, 60 * 4 - 2);
  EXPECT_EQ(first.bytes.compare(0, 15, "Other \"runtime\""), 0);
  EXPECT_EQ(first.states,
            (std::vector{XR_SESSION_STATE_IDLE, XR_SESSION_STATE_READY, XR_SESSION_STATE_SYNCHRONIZED,
                         XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_FOCUSED, XR_SESSION_STATE_STOPPING,
                         XR_SESSION_STATE_IDLE, XR_SESSION_STATE_EXITING}));
  play(folder / "capture.json");
  const Given again = run_application();
  EXPECT_EQ(again.failures, first.failures);
  EXPECT_EQ(first.states, again.states);
  EXPECT_TRUE(first.bytes == again.bytes);
}

// For a time between two samples the nearer one; in a space that the capture does not have, as it would be.
TEST_F(MockCapture, GivesTheNearestInAnySpaceOfTheSameOrigin) {
  script(moving_hand);
  capture_to(folder / "capture.json");
  run_application();
  play(folder / "capture.json");
  ASSERT_XR(XR_SUCCESS, create_instance());
  create_session();
  while (!running) poll();
  local = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL);
  const XrSpace turned = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL, {{0, 0.6F, 0, 0.8F}, {1, 2, 3}});
  const XrSpace stage = create_space(XR_REFERENCE_SPACE_TYPE_STAGE);
  const XrSpace view = create_space(XR_REFERENCE_SPACE_TYPE_VIEW);
  const XrHandTrackerEXT right = track(XR_HAND_RIGHT_EXT);
  frame();
  const XrTime first = frame();
  const Joints joints = locate_hand(right, local, first);
  const Joints before = locate_hand(right, local, first - 4'000'000),
               after = locate_hand(right, local, first + 4'000'000);
  EXPECT_EQ(std::memcmp(&joints, &before, sizeof joints), 0);
  EXPECT_EQ(std::memcmp(&joints, &after, sizeof joints), 0);
  const Joints next = locate_hand(right, local, first + 8'000'000);
  EXPECT_NE(std::memcmp(&joints, &next, sizeof joints), 0);
  // By hand: the inverse of a turn by 2 atan 0.75 about +Y, 16.26 degrees short of a right angle.
  const Joints seen = locate_hand(right, turned, first);
  const XrVector3f p = joints[XR_HAND_JOINT_INDEX_TIP_EXT].pose.position;
  const XrVector3f q = seen[XR_HAND_JOINT_INDEX_TIP_EXT].pose.position;
  const float x = p.x - 1, y = p.y - 2, z = p.z - 3;
  EXPECT_NEAR(q.x, 0.28F * x - 0.96F * z, 1e-6F);
  EXPECT_NEAR(q.y, y, 1e-6F);
  EXPECT_NEAR(q.z, 0.96F * x + 0.28F * z, 1e-6F);
  // Nothing was located in STAGE.
  given.active = 0;
  locate_hand(right, stage, first);
  EXPECT_EQ(given.active, 0);
  XrSpaceLocation location{XR_TYPE_SPACE_LOCATION};
  ASSERT_XR(XR_SUCCESS, xrLocateSpace(view, stage, first, &location));
  EXPECT_EQ(location.locationFlags, 0U);
  ASSERT_XR(XR_SUCCESS, xrLocateSpace(view, turned, first, &location));
  EXPECT_NE(location.locationFlags, 0U);
  EXPECT_XR(XR_SUCCESS, xrDestroyInstance(instance));
}

// An application that stops before or after the captured one did is not left waiting.
TEST_F(MockCapture, SessionEndsWhenItIsAskedTo) {
  capture_to(folder / "capture.json");
  run_application();
  play(folder / "capture.json");
  for (const int frames : {5, 200}) {
    ASSERT_XR(XR_SUCCESS, create_instance());
    create_session();
    while (!running) poll();
    XrTime latest = 0;
    for (int i = 0; i < frames; ++i) {
      const XrTime time = frame();
      EXPECT_GT(time, latest);
      latest = time;
    }
    EXPECT_XR(XR_SUCCESS, xrRequestExitSession(session));
    for (int i = 0; i < 100 && !ended; ++i) {
      poll();
      if (running) frame();
    }
    EXPECT_TRUE(ended) << frames;
    EXPECT_XR(XR_SUCCESS, xrDestroySession(session));
    EXPECT_XR(XR_SUCCESS, xrDestroyInstance(instance));
  }
}

TEST_F(MockCapture, WhatIsNoCaptureIsRefusedByName) {
  capture_to(folder / "capture.json");
  run_application();
  const std::string whole = read_file(folder / "capture.json");
  ASSERT_GT(whole.size(), 10'000U);
  const auto expect_refused = [&](const std::string& text, const std::string& why) {
    std::ofstream(folder / "broken.json") << text;
    play(folder / "broken.json");
    testing::internal::CaptureStderr();
    EXPECT_XR(XR_ERROR_INITIALIZATION_FAILED, create_instance());
    const std::string message = testing::internal::GetCapturedStderr();
    EXPECT_TRUE(has(message, folder / "broken.json"));
    EXPECT_TRUE(has(message, why));
  };
  for (const std::size_t size : {whole.size() / 2, whole.size() - 5, std::size_t{100}})
    expect_refused(whole.substr(0, size), "parse error");
  const auto with = [](const std::string& records) {
    return R"({"playback": {"version": 1, "records": [)" + records + "]}}";
  };
  expect_refused(with(R"(["dance", 1])"), "records[0] is a record of no known kind");
  expect_refused(with(R"(["frame", 1, 5, 6, true], ["frame", 1, 5])"), "records[1] has too few fields");
  expect_refused(with(R"(["frame", 1, 5, 6, true, 9])"), "records[0] has too many fields");
  expect_refused(with(R"(["frame", 0, 5, 6, true])"), "records[0] has no number of a session");
  expect_refused(with(R"(["frame", 1, 5.5, 6, true])"), "records[0][2] must be a whole number");
  expect_refused(with(R"(["joints", 1, 5, 1, 0, false, 0])"), "names a space before there is one");
  expect_refused(with(R"(["plate", 1, 5, "12"])"), "records[0][3] must be a number");
  expect_refused(with(R"(["timespec", 1, 5, 0.5])"), "records[0][3] must be a whole number");
  expect_refused(with(R"(["failed", 1, "xrDance", 1, -2])"),
                 "names a function that this runtime does not have");
  expect_refused(with("7"), "script.playback.records must be an array of arrays");
  expect_refused(R"({"playback": {"version": 2, "records": []}})", "script.playback.version must be 1");
  expect_refused(R"({"seed": 3, "playback": {"version": 1, "records": []}})", "takes the place of seed");
}

// Faults can be added to what was captured.
TEST_F(MockCapture, PlaysFaultsOfTheScriptBeside) {
  capture_to(folder / "capture.json");
  run_application();
  std::string text = read_file(folder / "capture.json");
  text.insert(1, R"("calls": [{"function": "xrGetSystem", "result": "XR_ERROR_FORM_FACTOR_UNAVAILABLE"}], )");
  std::ofstream(folder / "faults.json") << text;
  play(folder / "faults.json");
  ASSERT_XR(XR_SUCCESS, create_instance());
  const XrSystemGetInfo get{XR_TYPE_SYSTEM_GET_INFO, nullptr, XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY};
  EXPECT_XR(XR_ERROR_FORM_FACTOR_UNAVAILABLE, xrGetSystem(instance, &get, &system));
  EXPECT_XR(XR_SUCCESS, xrGetSystem(instance, &get, &system));
  EXPECT_XR(XR_SUCCESS, xrDestroyInstance(instance));
}

TEST_F(MockCapture, NeedsAFileThatCanBeWritten) {
  capture_to("");
  EXPECT_XR(XR_ERROR_INITIALIZATION_FAILED, create_instance());
  capture_to(folder / "no/such/folder/capture.json");
  testing::internal::CaptureStderr();
  EXPECT_XR(XR_ERROR_INITIALIZATION_FAILED, create_instance());
  EXPECT_TRUE(has(testing::internal::GetCapturedStderr(), "no/such/folder"));
}

// An implicit layer is found by where its manifest is, and enabled and disabled by its two variables.
TEST_F(MockCapture, IsImplicitWhereItsManifestIsInstalled) {
  const std::filesystem::path implicit = folder.path / "openxr/1/api_layers/implicit.d";
  std::filesystem::create_directories(implicit);
  std::string manifest = read_file(HRT_CAPTURE_MANIFESTS "/hrtx_capture.json");
  const std::string beside = "\"../libhrtx_capture.so\"";
  ASSERT_TRUE(has(manifest, beside));
  manifest.replace(manifest.find(beside), beside.size(), "\"" HRT_CAPTURE_LIBRARY "\"");
  std::ofstream(implicit / "hrtx_capture.json") << manifest;
  setenv("XDG_DATA_HOME", folder.path.c_str(), 1);
  run_application();
  EXPECT_FALSE(std::filesystem::exists(folder / "capture.json"));
  setenv("HRT_CAPTURE_FILE", (folder / "capture.json").c_str(), 1);
  const Given first = run_application();
  ASSERT_TRUE(std::filesystem::exists(folder / "capture.json"));
  play(folder / "capture.json");
  EXPECT_TRUE(first.bytes == run_application().bytes);
}

// Without a loader, which hides these.
class MockCaptureLayer : public MockNegotiation {
 protected:
  void SetUp() override {
    MockNegotiation::SetUp();
    layer_library = dlopen(HRT_CAPTURE_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(layer_library, nullptr) << dlerror();
    negotiate_layer =
        reinterpret_cast<NegotiateLayer>(dlsym(layer_library, "xrNegotiateLoaderApiLayerInterface"));
    ASSERT_NE(negotiate_layer, nullptr);
  }
  void TearDown() override {
    dlclose(layer_library);
    MockNegotiation::TearDown();
  }
  using NegotiateLayer = XrResult(XRAPI_PTR*)(const NegotiateLoaderInfo*, const char*,
                                              NegotiateApiLayerRequest*);
  void* layer_library = nullptr;
  NegotiateLayer negotiate_layer = nullptr;
  NegotiateApiLayerRequest layer{api_layer_request_type, struct_version, sizeof(NegotiateApiLayerRequest)};
};

// Right in front of the runtime, since Debian 12's loader refuses applications for 1.1: its function is
// wrapped, and what it gives is in the file.
TEST_F(MockCaptureLayer, CapturesAnApplicationForOpenXR11) {
  const TemporaryFolder folder;
  setenv("HRT_CAPTURE_FILE", (folder / "capture.json").c_str(), 1);
  ASSERT_XR(XR_SUCCESS, negotiate(&loader, &request));
  ASSERT_XR(XR_SUCCESS, negotiate_layer(&loader, "XR_APILAYER_HRTX_capture", &layer));
  static PFN_xrGetInstanceProcAddr runtime = nullptr;
  runtime = request.get_instance_proc_addr;
  ApiLayerNextInfo next{};
  next.struct_size = sizeof next;
  next.next_get_instance_proc_addr = runtime;
  next.next_create_api_layer_instance = [](const XrInstanceCreateInfo* of, const ApiLayerCreateInfo*,
                                           XrInstance* made) {
    PFN_xrVoidFunction create = nullptr;
    EXPECT_XR(XR_SUCCESS, runtime(XR_NULL_HANDLE, "xrCreateInstance", &create));
    return reinterpret_cast<PFN_xrCreateInstance>(create)(of, made);
  };
  ApiLayerCreateInfo layers{};
  layers.struct_size = sizeof layers;
  layers.next_info = &next;
  const std::vector<const char*> names{XR_MND_HEADLESS_EXTENSION_NAME};
  XrInstanceCreateInfo info = instance_info(names);
  info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 1, 41);
  ASSERT_XR(XR_SUCCESS, layer.create_api_layer_instance(&info, &layers, &instance));
  request.get_instance_proc_addr = layer.get_instance_proc_addr;  // direct() from here on
  const XrSessionCreateInfo session_info{XR_TYPE_SESSION_CREATE_INFO, nullptr, 0, 1};
  XrSession session = XR_NULL_HANDLE;
  ASSERT_XR(XR_SUCCESS, direct<PFN_xrCreateSession>("xrCreateSession")(instance, &session_info, &session));
  const XrReferenceSpaceCreateInfo floor{XR_TYPE_REFERENCE_SPACE_CREATE_INFO, nullptr,
                                         XR_REFERENCE_SPACE_TYPE_LOCAL_FLOOR, identity_pose};
  XrSpace space = XR_NULL_HANDLE;
  ASSERT_XR(XR_SUCCESS,
            direct<PFN_xrCreateReferenceSpace>("xrCreateReferenceSpace")(session, &floor, &space));
  XrSpaceLocationData data{};
  XrSpaceLocations locations{XR_TYPE_SPACE_LOCATIONS, nullptr, 1, &data};
  const XrSpacesLocateInfo locate{XR_TYPE_SPACES_LOCATE_INFO, nullptr, space, 1'450'000'000, 1, &space};
  ASSERT_XR(XR_SUCCESS, direct<PFN_xrLocateSpaces>("xrLocateSpaces")(session, &locate, &locations));
  destroy_direct();
  EXPECT_TRUE(has(read_file(folder / "capture.json"), "[\"located\",1,1450000000,"));
  unsetenv("HRT_CAPTURE_FILE");
}

TEST_F(MockCaptureLayer, RefusesALoaderOfAnotherInterface) {
  EXPECT_XR(XR_SUCCESS, negotiate_layer(&loader, "XR_APILAYER_HRTX_capture", &layer));
  EXPECT_NE(layer.create_api_layer_instance, nullptr);
  EXPECT_XR(XR_ERROR_INITIALIZATION_FAILED, negotiate_layer(nullptr, nullptr, &layer));
  EXPECT_XR(XR_ERROR_INITIALIZATION_FAILED, negotiate_layer(&loader, nullptr, nullptr));
  NegotiateLoaderInfo newer = loader;
  newer.min_interface_version = newer.max_interface_version = 2;
  EXPECT_XR(XR_ERROR_INITIALIZATION_FAILED, negotiate_layer(&newer, nullptr, &layer));
  NegotiateApiLayerRequest larger = layer;
  larger.struct_size += 8;
  EXPECT_XR(XR_ERROR_INITIALIZATION_FAILED, negotiate_layer(&loader, nullptr, &larger));
  EXPECT_XR(XR_ERROR_INITIALIZATION_FAILED, layer.create_api_layer_instance(nullptr, nullptr, &instance));
}

}  // namespace
}  // namespace hrt::mock
