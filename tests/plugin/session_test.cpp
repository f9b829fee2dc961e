#include <limits>
#include <thread>

#include "fixture.h"

namespace hrt::test {
namespace {

TEST(Results, HaveNames) {
  EXPECT_STREQ(hrt_result_string(HRT_OK), "HRT_OK");
  EXPECT_STREQ(hrt_result_string(HRT_ERROR_BUSY), "HRT_ERROR_BUSY");
  EXPECT_STREQ(hrt_result_string(1), "unknown result");
  EXPECT_STREQ(hrt_result_string(std::numeric_limits<hrt_result>::min()), "unknown result");
}

TEST(Results, VersionIsThatOfTheHeaders) {
  uint32_t major = 99, minor = 99, patch = 99;
  hrt_get_version(&major, &minor, &patch);
  EXPECT_EQ(major, unsigned{HRT_VERSION_MAJOR});
  EXPECT_EQ(minor, unsigned{HRT_VERSION_MINOR});
  EXPECT_EQ(patch, unsigned{HRT_VERSION_PATCH});
  hrt_get_version(nullptr, nullptr, nullptr);
}

TEST(Results, HeadersOfAnotherMinorVersionAreRejected) {
  hrt_session session{7};
  for (const std::uint32_t other : {0u, HRT_VERSION - 100u, HRT_VERSION + 100u, HRT_VERSION + 10000u, ~0u})
    expect_error(hrt_session_create(other, nullptr, &session), HRT_ERROR_OUT_OF_RANGE,
                 "version is " + std::to_string(other) + ", that of incompatible headers; this library is 0.");
  EXPECT_EQ(session.value, 7u);
  ASSERT_OK(hrt_session_create(HRT_VERSION + 1, nullptr, &session)) << "a later patch";
  EXPECT_OK(hrt_session_destroy(session));
}

#if !defined(__EMSCRIPTEN__)  // a program in WebAssembly has one thread
TEST(Results, LastErrorBelongsToTheThread) {
  EXPECT_EQ(hrt_session_destroy({0}), HRT_ERROR_INVALID_HANDLE);
  EXPECT_TRUE(std::string_view(hrt_last_error()).starts_with("hrt_session_destroy: session 0 "));
  std::thread([] { EXPECT_STREQ(hrt_last_error(), ""); }).join();
}
#endif

// Plate, tracker and registration are kept, because they do not belong to the user.
TEST_F(SessionTest, ProfileResetMakesThePersonUnknownAndKeepsThePlate) {
  const hrt_session_config defaults = session_config();
  hrt_session_config apparatus = defaults;
  apparatus.flags = HRT_SESSION_REGISTERED;
  apparatus.plate.position_m[0] = 0.3;
  apparatus.tracker.latency_ns = 30'000'000;
  apparatus.paper.horizon = 7;
  hrt_session_config known = apparatus;
  known.person.tactile_weight = 0.3;
  known.person.bias_deg = -2.0;
  known.person.motion_bound_deg = 50.0;
  known.fingertip_offset_m[2] = 0.01;
  know_person(&known, {0.2, 0.0, 14.0, 1.0, 0.0, 0.1, -0.5, 0.0, 1.2, 0.5});
  ASSERT_OK(hrt_session_set(session, &known));
  ASSERT_OK(hrt_profile_reset(session));
  EXPECT_TRUE(same(config_of(session), apparatus));
}

TEST_F(SessionTest, GetReturnsWhatSetStoredAndNullSetsTheDefaults) {
  const hrt_session_config defaults = session_config();
  hrt_session_config other = defaults;
  other.paper.horizon = 7;
  ASSERT_OK(hrt_session_set(session, &other));
  EXPECT_TRUE(same(config_of(session), other));
  ASSERT_OK(hrt_session_set(session, nullptr));
  EXPECT_TRUE(same(config_of(session), defaults));
  ASSERT_OK(hrt_session_destroy(session));
  ASSERT_OK(hrt_session_create(HRT_VERSION, nullptr, &session));
  EXPECT_TRUE(same(config_of(session), defaults));
}

TEST_F(SessionTest, DestroyedHandleIsNeverValidAgain) {
  const hrt_session first = session;
  ASSERT_OK(hrt_session_destroy(session));
  expect_error(hrt_session_destroy(first), HRT_ERROR_INVALID_HANDLE, "session");
  session.value = 0;
  for (int i = 0; i < 200; ++i) {
    create(session_config());
    EXPECT_NE(session.value, first.value);
    EXPECT_EQ(hrt_session_destroy(first), HRT_ERROR_INVALID_HANDLE);
  }
}

TEST(Session, OneSessionMoreThanTheMaximumIsRejected) {
  const hrt_session_config config = session_config();
  std::vector<hrt_session> all(HRT_SESSIONS_MAX);
  for (hrt_session& session : all) ASSERT_OK(hrt_session_create(HRT_VERSION, &config, &session));
  hrt_session one_more{42};
  expect_error(hrt_session_create(HRT_VERSION, &config, &one_more), HRT_ERROR_LIMIT_REACHED, "1024");
  EXPECT_EQ(one_more.value, 42u);
  for (const hrt_session session : all) ASSERT_OK(hrt_session_destroy(session));
}

TEST(SessionConfig, FieldsThatDependOnEachOtherAreChecked) {
  const auto refused = [](auto change, const char* field) {
    hrt_session_config config = session_config();
    change(config);
    hrt_session session{7};
    expect_error(hrt_session_create(HRT_VERSION, &config, &session), HRT_ERROR_OUT_OF_RANGE, field);
  };
  refused([](hrt_session_config& c) { c.plate.latency_ns = 800'000'001; },
          "plate_latency_ns is 800000001; allowed: 0 to 800000000");
  refused([](hrt_session_config& c) { c.plate.upper_stop_deg = 179.0; }, "plate_upper_stop_deg");
  refused([](hrt_session_config& c) { c.plate.rotation[3] = 0.9; }, "plate_rotation");
  refused([](hrt_session_config& c) { c.plate.rotation[0] = std::nan(""); }, "plate_rotation");
  refused([](hrt_session_config& c) { c.plate.covariance[2] = -0.01; }, "plate_covariance");
  refused([](hrt_session_config& c) { c.plate.covariance[1] = 1e-6; }, "plate_covariance");
}

// The caller was compiled with a later header, whose struct has an additional field.
TEST(SessionConfig, LargerStructIsAcceptedWithZerosBeyond) {
  struct Later {
    hrt_session_config config;
    double further;
  } later{session_config(), 0.0};
  later.config.struct_size = sizeof later;
  hrt_session session{};
  ASSERT_OK(hrt_session_create(HRT_VERSION, &later.config, &session));
  later.further = 3.0;
  ASSERT_OK(hrt_session_get(session, &later.config, nullptr));
  EXPECT_EQ(later.config.struct_size, sizeof later);
  EXPECT_EQ(later.further, 0.0);
  ASSERT_OK(hrt_session_destroy(session));

  later.further = 3.0;
  expect_error(hrt_session_create(HRT_VERSION, &later.config, &session), HRT_ERROR_STRUCT_SIZE, "not 0");
}

}  // namespace
}  // namespace hrt::test
