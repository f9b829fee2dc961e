// Negotiation, instance, system, handles, paths and conversions. Above each test stands the sentence that
// it tests, from the OpenXR specification 1.0 or the loader specification.
#include <array>
#include <cstring>

#include "tests/samples/mock_runtime/negotiation.h"
#include "tests/samples/mock_runtime/support.h"

namespace hrt::mock {
namespace {

using MockInstance = MockRuntime;

// "The runtime must [...] fill in" interface version, API version and xrGetInstanceProcAddr.
TEST_F(MockNegotiation, AnswersALoaderOfItsVersion) {
  ASSERT_XR(XR_SUCCESS, negotiate(&loader, &request));
  EXPECT_EQ(request.runtime_interface_version, 1U);
  EXPECT_EQ(request.runtime_api_version, XR_MAKE_VERSION(1, 1, 47));
  EXPECT_NE(request.get_instance_proc_addr, nullptr);
  loader.max_api_version = XR_MAKE_VERSION(1, 0, 99);
  ASSERT_XR(XR_SUCCESS, negotiate(&loader, &request));
  EXPECT_EQ(request.runtime_api_version, XR_MAKE_VERSION(1, 0, 99));
}

// "If the loader [and] runtime can't agree [...] XR_ERROR_INITIALIZATION_FAILED": wrong structures and
// version ranges without the runtime's own.
TEST_F(MockNegotiation, RefusesWrongStructuresAndVersions) {
  EXPECT_XR(XR_ERROR_INITIALIZATION_FAILED, negotiate(nullptr, &request));
  EXPECT_XR(XR_ERROR_INITIALIZATION_FAILED, negotiate(&loader, nullptr));
  const auto expect_refused = [&](auto change) {
    NegotiateLoaderInfo bad_loader = loader;
    NegotiateRuntimeRequest bad_request = request;
    change(bad_loader, bad_request);
    EXPECT_XR(XR_ERROR_INITIALIZATION_FAILED, negotiate(&bad_loader, &bad_request));
    EXPECT_EQ(bad_request.get_instance_proc_addr, nullptr);
  };
  expect_refused([](auto& info, auto&) { info.struct_type = runtime_request_type; });
  expect_refused([](auto& info, auto&) { ++info.struct_version; });
  expect_refused([](auto& info, auto&) { --info.struct_size; });
  expect_refused([](auto& info, auto&) { info.min_interface_version = info.max_interface_version = 2; });
  expect_refused([](auto& info, auto&) { info.min_api_version = XR_MAKE_VERSION(1, 2, 0); });
  expect_refused([](auto& info, auto&) { info.max_api_version = XR_MAKE_VERSION(0, 9, 0); });
  expect_refused([](auto&, auto& wanted) { wanted.struct_type = loader_info_type; });
  expect_refused([](auto&, auto& wanted) { ++wanted.struct_version; });
  expect_refused([](auto&, auto& wanted) { wanted.struct_size = 0; });
}

// "The runtime must return XR_ERROR_API_VERSION_UNSUPPORTED if it does not support the requested API
// version."
TEST_F(MockNegotiation, TakesApplicationsForOpenXR10And11) {
  ASSERT_XR(XR_SUCCESS, negotiate(&loader, &request));
  for (const XrVersion version : {XR_MAKE_VERSION(1, 0, 0), XR_MAKE_VERSION(1, 0, 99), XR_MAKE_VERSION(1, 1, 40)}) {
    ASSERT_XR(XR_SUCCESS, create_direct({}, version));
    PFN_xrVoidFunction locate_spaces = nullptr;
    EXPECT_XR(XR_VERSION_MINOR(version) == 1 ? XR_SUCCESS : XR_ERROR_FUNCTION_UNSUPPORTED,
              request.get_instance_proc_addr(instance, "xrLocateSpaces", &locate_spaces));
    EXPECT_EQ(locate_spaces != nullptr, XR_VERSION_MINOR(version) == 1);
    destroy_direct();
  }
  for (const XrVersion version : {XR_MAKE_VERSION(0, 9, 0), XR_MAKE_VERSION(1, 2, 0), XR_MAKE_VERSION(2, 0, 0)})
    EXPECT_XR(XR_ERROR_API_VERSION_UNSUPPORTED, create_direct({}, version));
}

// "If instance is XR_NULL_HANDLE": functions other than those that need none are XR_ERROR_HANDLE_INVALID, and
// "on failure [function] must be NULL".
TEST_F(MockNegotiation, GivesFunctionsWithoutAnInstanceOnlyIfTheyNeedNone) {
  ASSERT_XR(XR_SUCCESS, negotiate(&loader, &request));
  for (const char* name :
       {"xrCreateInstance", "xrEnumerateInstanceExtensionProperties", "xrEnumerateApiLayerProperties"})
    EXPECT_NE(look_up_of(XR_NULL_HANDLE, name), nullptr) << name;
  auto function = reinterpret_cast<PFN_xrVoidFunction>(negotiate);
  EXPECT_XR(XR_ERROR_HANDLE_INVALID, request.get_instance_proc_addr(XR_NULL_HANDLE, "xrGetSystem", &function));
  EXPECT_EQ(function, nullptr);
}

// "If the function is from an extension that is not enabled, XR_ERROR_FUNCTION_UNSUPPORTED".
TEST(MockExtensions, FunctionOfAnExtensionThatIsNotEnabledIsUnsupported) {
  const XrInstanceCreateInfo info = instance_info({});
  XrInstance instance = XR_NULL_HANDLE;
  ASSERT_XR(XR_SUCCESS, xrCreateInstance(&info, &instance));
  for (const char* name : {"xrCreateHandTrackerEXT", "xrConvertTimespecTimeToTimeKHR", "xrSetInputDeviceActiveEXT",
                           "xrPlacePlateHRTX", "xrApplyScriptHRTX", "xrCreateSpatialAnchorMSFT", "xrNoSuchFunction"}) {
    PFN_xrVoidFunction function = nullptr;
    EXPECT_XR(XR_ERROR_FUNCTION_UNSUPPORTED, xrGetInstanceProcAddr(instance, name, &function));
    EXPECT_EQ(function, nullptr) << name;
  }
  EXPECT_XR(XR_SUCCESS, xrDestroyInstance(instance));
}

// "When a [parent] handle is destroyed, all its child handles become invalid"; a handle is never used again,
// nor for an object of another type. errors_test.cpp has null and bogus ones.
TEST_F(MockInstance, DestroyingASessionDestroysWhatIsBelowIt) {
  create_session();
  const XrSpace space = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL);
  const XrHandTrackerEXT tracker = create_hand_tracker();
  const XrSession first = session;
  EXPECT_XR(XR_ERROR_HANDLE_INVALID, xrDestroySpace(reinterpret_cast<XrSpace>(first)));
  ASSERT_XR(XR_SUCCESS, xrDestroySession(first));
  EXPECT_XR(XR_ERROR_HANDLE_INVALID, xrDestroySpace(space));
  EXPECT_XR(XR_ERROR_HANDLE_INVALID, XR(xrDestroyHandTrackerEXT)(tracker));
  create_session();
  EXPECT_NE(session, first);
}

// "View configurations": one, primary stereo, of two views.
TEST_F(MockInstance, ViewsArePrimaryStereo) {
  std::uint32_t count = 0;
  std::array<XrViewConfigurationType, 4> types{};
  ASSERT_XR(XR_SUCCESS, xrEnumerateViewConfigurations(instance, system, 4, &count, types.data()));
  ASSERT_EQ(count, 1U);
  EXPECT_EQ(types[0], XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO);
  std::array<XrViewConfigurationView, 2> views{{{XR_TYPE_VIEW_CONFIGURATION_VIEW}, {XR_TYPE_VIEW_CONFIGURATION_VIEW}}};
  ASSERT_XR(XR_SUCCESS, xrEnumerateViewConfigurationViews(instance, system, types[0], 2, &count, views.data()));
  EXPECT_EQ(count, 2U);
  XrEnvironmentBlendMode mode{};
  ASSERT_XR(XR_SUCCESS, xrEnumerateEnvironmentBlendModes(instance, system, types[0], 1, &count, &mode));
  EXPECT_EQ(mode, XR_ENVIRONMENT_BLEND_MODE_OPAQUE);
}

// "XR_UNKNOWN_SUCCESS_ [or] XR_UNKNOWN_FAILURE_ concatenated with the result value" for what is not known.
TEST_F(MockInstance, ResultsAndStructureTypesHaveNames) {
  std::array<char, XR_MAX_RESULT_STRING_SIZE> text{};
  ASSERT_XR(XR_SUCCESS, xrResultToString(instance, XR_ERROR_POSE_INVALID, text.data()));
  EXPECT_STREQ(text.data(), "XR_ERROR_POSE_INVALID");
  ASSERT_XR(XR_SUCCESS, xrResultToString(instance, static_cast<XrResult>(-123456), text.data()));
  EXPECT_STREQ(text.data(), "XR_UNKNOWN_FAILURE_-123456");
  ASSERT_XR(XR_SUCCESS, xrResultToString(instance, static_cast<XrResult>(123456), text.data()));
  EXPECT_STREQ(text.data(), "XR_UNKNOWN_SUCCESS_123456");
  std::array<char, XR_MAX_STRUCTURE_NAME_SIZE> name{};
  ASSERT_XR(XR_SUCCESS, xrStructureTypeToString(instance, XR_TYPE_SYSTEM_GET_INFO, name.data()));
  EXPECT_STREQ(name.data(), "XR_TYPE_SYSTEM_GET_INFO");
  ASSERT_XR(XR_SUCCESS, xrStructureTypeToString(instance, XR_TYPE_SPACES_LOCATE_INFO, name.data()));
  EXPECT_STREQ(name.data(), "XR_TYPE_SPACES_LOCATE_INFO");
  ASSERT_XR(XR_SUCCESS, xrStructureTypeToString(instance, static_cast<XrStructureType>(123456), name.data()));
  EXPECT_STREQ(name.data(), "XR_UNKNOWN_STRUCTURE_TYPE_123456");
}

// "Well-formed path strings": they start with a slash, do not end with one, and have no empty component, none
// of periods only, and no other characters; XR_ERROR_PATH_FORMAT_INVALID.
TEST_F(MockInstance, OnlyWellFormedStringsArePaths) {
  for (const char* text : {"/a", "/user/hand/left/input/select/click", "/a/.b", "/a/b.", "/0-9_z.", "/a/...x"})
    path(text);
  XrPath atom = XR_NULL_PATH;
  for (const char* text :
       {"", "/", "a", "a/b", "/a/", "/a//b", "//", "/a/.", "/a/../b", "/...", "/A", "/a b", "/a\xc3\xa4"})
    EXPECT_XR(XR_ERROR_PATH_FORMAT_INVALID, xrStringToPath(instance, text, &atom)) << text;
  EXPECT_XR(XR_SUCCESS, xrStringToPath(instance, ("/" + std::string(XR_MAX_PATH_LENGTH - 2, 'a')).c_str(), &atom));
  EXPECT_XR(XR_ERROR_PATH_FORMAT_INVALID,
            xrStringToPath(instance, ("/" + std::string(XR_MAX_PATH_LENGTH - 1, 'a')).c_str(), &atom));
}

// "xrPathToString [...] the string, including the terminating null character"; XR_ERROR_PATH_INVALID.
TEST_F(MockInstance, PathsAndStringsConvertBothWays) {
  const char* const text = "/user/hand/right";
  const XrPath atom = path(text);
  EXPECT_EQ(path(text), atom);
  EXPECT_NE(path("/user/hand/left"), atom);
  std::uint32_t count = 0;
  ASSERT_XR(XR_SUCCESS, xrPathToString(instance, atom, 0, &count, nullptr));
  ASSERT_EQ(count, std::strlen(text) + 1);
  std::vector<char> buffer(count);
  ASSERT_XR(XR_SUCCESS, xrPathToString(instance, atom, count, &count, buffer.data()));
  EXPECT_STREQ(buffer.data(), text);
  EXPECT_XR(XR_ERROR_PATH_INVALID, xrPathToString(instance, XR_NULL_PATH, 0, &count, nullptr));
}

}  // namespace
}  // namespace hrt::mock
