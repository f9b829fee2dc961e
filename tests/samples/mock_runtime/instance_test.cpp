// Negotiation, instance, system, handles, paths and conversions. The comment above each test quotes
// the tested sentence of the OpenXR specification 1.0 or of the loader specification.
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

// "When a [parent] handle is destroyed, all its child handles become invalid"; handles are never
// reused, also not for objects of another type. errors_test.cpp tests null and invalid handles.
TEST_F(MockInstance, DestroyingASessionDestroysItsChildren) {
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

// "XR_UNKNOWN_SUCCESS_ [or] XR_UNKNOWN_FAILURE_ concatenated with the result value" for unknown values.
TEST_F(MockInstance, ResultsAndStructureTypesHaveNames) {
  for (const auto& [result, expected] : {std::pair{XR_ERROR_POSE_INVALID, "XR_ERROR_POSE_INVALID"},
                                         {static_cast<XrResult>(-123456), "XR_UNKNOWN_FAILURE_-123456"},
                                         {static_cast<XrResult>(123456), "XR_UNKNOWN_SUCCESS_123456"}}) {
    std::array<char, XR_MAX_RESULT_STRING_SIZE> text{};
    ASSERT_XR(XR_SUCCESS, xrResultToString(instance, result, text.data()));
    EXPECT_STREQ(text.data(), expected);
  }
  for (const auto& [type, expected] : {std::pair{XR_TYPE_SYSTEM_GET_INFO, "XR_TYPE_SYSTEM_GET_INFO"},
                                       {XR_TYPE_SPACES_LOCATE_INFO, "XR_TYPE_SPACES_LOCATE_INFO"},
                                       {static_cast<XrStructureType>(123456), "XR_UNKNOWN_STRUCTURE_TYPE_123456"}}) {
    std::array<char, XR_MAX_STRUCTURE_NAME_SIZE> text{};
    ASSERT_XR(XR_SUCCESS, xrStructureTypeToString(instance, type, text.data()));
    EXPECT_STREQ(text.data(), expected);
  }
}

}  // namespace
}  // namespace hrt::mock
