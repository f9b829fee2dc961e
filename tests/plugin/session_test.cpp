// Sessions: made, configured, refused, destroyed.
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>
#include <vector>

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

#if !defined(__EMSCRIPTEN__)  // has one thread
TEST(Results, LastErrorBelongsToTheThread) {
  EXPECT_EQ(hrt_session_destroy({0}), HRT_ERROR_INVALID_HANDLE);
  EXPECT_STREQ(hrt_last_error(), "hrt_session_destroy: session 0 does not exist");
  std::thread([] { EXPECT_STREQ(hrt_last_error(), ""); }).join();
}
#endif

TEST(SessionConfig, DefaultsAreTheModels) {
  const hrt_session_config config = session_config();
  EXPECT_EQ(config.struct_size, sizeof config);
  EXPECT_EQ(config.horizon, 3u);
  EXPECT_EQ(config.step_period_ns, 100'000'000);
  EXPECT_EQ(config.plate_bound_deg, 84.5);
  EXPECT_EQ(config.tactile_weight, 0.2);
  EXPECT_EQ(config.motor_variance_deg2, 0.5);
  EXPECT_EQ(config.sensory_variance_deg2, 0.1);
}

TEST_F(SessionTest, ConfigComesBackAsGiven) {
  hrt_session_config config = session_config();
  config.horizon = 7;
  config.tactile_weight = 0.2;
  ASSERT_OK(hrt_session_set_config(session, &config));
  auto back = output<hrt_session_config>();
  ASSERT_OK(hrt_session_get_config(session, &back));
  EXPECT_EQ(std::memcmp(&back, &config, sizeof config), 0);
}

TEST_F(SessionTest, DestroyedHandleIsRefusedForEver) {
  const hrt_session first = session;
  ASSERT_OK(hrt_session_destroy(session));
  expect_error(hrt_session_destroy(first), HRT_ERROR_INVALID_HANDLE, "does not exist");
  session.value = 0;
  for (int i = 0; i < 200; ++i) {
    create(session_config());
    EXPECT_NE(session.value, first.value);
    EXPECT_EQ(hrt_session_destroy(first), HRT_ERROR_INVALID_HANDLE);
  }
}

TEST(Session, ManyFitAndOneMoreIsRefused) {
  const hrt_session_config config = session_config();
  std::vector<hrt_session> all(HRT_SESSIONS_MAX);
  for (hrt_session& session : all) ASSERT_OK(hrt_session_create(&config, &session));
  hrt_session one_more{42};
  expect_error(hrt_session_create(&config, &one_more), HRT_ERROR_LIMIT_REACHED, "there are 1024 sessions");
  EXPECT_EQ(one_more.value, 42u);
  for (const hrt_session session : all) ASSERT_OK(hrt_session_destroy(session));
}

TEST(SessionConfig, EveryFieldIsChecked) {
  struct Case {
    const char* field;
    double hrt_session_config::* value;
    double below, above;
  };
  const Case cases[] = {
      {"perceived_weight", &hrt_session_config::perceived_weight, 0.0, 2e6},
      {"actual_weight", &hrt_session_config::actual_weight, -1e-300, 2e6},
      {"plate_bound_deg", &hrt_session_config::plate_bound_deg, 0.0, 90.0001},
      {"plate_max_speed_deg_s", &hrt_session_config::plate_max_speed_deg_s, -1.0, 2e6},
      {"plate_max_acceleration_deg_s2", &hrt_session_config::plate_max_acceleration_deg_s2, -1.0, 2e8},
      {"plate_lower_stop_deg", &hrt_session_config::plate_lower_stop_deg, -3601.0, 3601.0},
      {"plate_upper_stop_deg", &hrt_session_config::plate_upper_stop_deg, -3601.0, 3601.0},
      {"tactile_weight_sd", &hrt_session_config::tactile_weight_sd, 0.0, 0.5},
      {"tracker_noise_m", &hrt_session_config::tracker_noise_m, -1e-9, 0.2},
      {"plate_radius_m", &hrt_session_config::plate_radius_m, 0.0, 1001.0},
      {"lift_height_m", &hrt_session_config::lift_height_m, 0.0, 1001.0},
      {"fixed_plate_orientation_deg", &hrt_session_config::fixed_plate_orientation_deg, -181.0, 181.0},
      {"tactile_weight", &hrt_session_config::tactile_weight, 0.0, 0.5},
      {"motor_variance_deg2", &hrt_session_config::motor_variance_deg2, -1.0, 1e5},
      {"sensory_variance_deg2", &hrt_session_config::sensory_variance_deg2, 0.0, 1e5},
      {"bias_deg", &hrt_session_config::bias_deg, -45.1, 45.1},
      {"motor_variance_sd_deg2", &hrt_session_config::motor_variance_sd_deg2, 0.0, 10.1},
      {"initial_variance_deg2", &hrt_session_config::initial_variance_deg2, -1.0, 1e5},
  };
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Case& c : cases) {
    for (const double bad : {c.below, c.above, infinity, -infinity, std::nan("")}) {
      hrt_session_config config = session_config();
      config.*c.value = bad;
      hrt_session session{7};
      expect_error(hrt_session_create(&config, &session), HRT_ERROR_OUT_OF_RANGE, c.field);
      EXPECT_EQ(session.value, 7u);
    }
  }
}

TEST(SessionConfig, WholeNumbersAreChecked) {
  const auto refused = [](auto change, const char* field) {
    hrt_session_config config = session_config();
    change(config);
    hrt_session session{7};
    expect_error(hrt_session_create(&config, &session), HRT_ERROR_OUT_OF_RANGE, field);
  };
  refused([](hrt_session_config& c) { c.horizon = 0; }, "horizon is 0; allowed: 1 to 50");
  refused([](hrt_session_config& c) { c.horizon = 51; }, "horizon is 51");
  refused([](hrt_session_config& c) { c.step_period_ns = 999'999; }, "step_period_ns");
  refused([](hrt_session_config& c) { c.step_period_ns = -1; }, "step_period_ns is -1");
  refused([](hrt_session_config& c) { c.control = 2; }, "control");
  refused([](hrt_session_config& c) { c.guidance = 2; }, "guidance");
  refused([](hrt_session_config& c) { c.adaptation = 3; }, "adaptation");
  refused([](hrt_session_config& c) { c.flags = 4; }, "flags is 4");
  refused([](hrt_session_config& c) { c.plate_latency_ns = -1; }, "plate_latency_ns");
  refused([](hrt_session_config& c) { c.plate_latency_ns = 800'000'001; }, "plate_latency_ns");
  refused([](hrt_session_config& c) { c.plate_upper_stop_deg = 179.0; }, "at least 180 above");
  refused([](hrt_session_config& c) { c.start_position_m[1] = 1001.0; }, "start_position_m");
  refused([](hrt_session_config& c) { c.plate_position_m[0] = std::nan(""); }, "plate_position_m");
  refused([](hrt_session_config& c) { c.plate_rotation[3] = 0.9; }, "plate_rotation");
  refused([](hrt_session_config& c) { c.plate_rotation[0] = std::nan(""); }, "plate_rotation");
}

TEST(SessionConfig, StructSizeIsChecked) {
  hrt_session_config config = session_config();
  hrt_session session{7};
  for (const uint32_t size : {0u, 4u, static_cast<uint32_t>(sizeof config - 8),
                              static_cast<uint32_t>(sizeof config + 4), 4104u, 0xffffffffu}) {
    config.struct_size = size;
    expect_error(hrt_session_create(&config, &session), HRT_ERROR_STRUCT_SIZE, "config: struct_size is");
  }
  expect_error(hrt_session_config_default(&config, 8), HRT_ERROR_STRUCT_SIZE, "out_config");
}

// A caller that was compiled against a later header, whose struct has a further field.
TEST(SessionConfig, LargerStructPassesWithZerosBeyond) {
  struct Later {
    hrt_session_config config;
    double further;
  } later{session_config(), 0.0};
  later.config.struct_size = sizeof later;
  hrt_session session{};
  ASSERT_OK(hrt_session_create(&later.config, &session));
  later.further = 3.0;
  ASSERT_OK(hrt_session_get_config(session, &later.config));
  EXPECT_EQ(later.config.struct_size, sizeof later);
  EXPECT_EQ(later.further, 0.0);
  ASSERT_OK(hrt_session_destroy(session));

  later.further = 3.0;
  expect_error(hrt_session_create(&later.config, &session), HRT_ERROR_STRUCT_SIZE, "not 0");
}

TEST(Session, NullPointersAreRefused) {
  const hrt_session_config config = session_config();
  hrt_session session{};
  expect_error(hrt_session_create(nullptr, &session), HRT_ERROR_NULL_ARGUMENT, "config is null");
  expect_error(hrt_session_create(&config, nullptr), HRT_ERROR_NULL_ARGUMENT, "out_session is null");
  expect_error(hrt_session_config_default(nullptr, sizeof config), HRT_ERROR_NULL_ARGUMENT, "out_config");
}

}  // namespace
}  // namespace hrt::test
