// Profiles: JSON out, and in again.
#include <string>

#include "fixture.h"

namespace hrt::test {
namespace {

using ProfileTest = SessionTest;

std::string save(hrt_session session) {
  uint64_t length = 0;
  EXPECT_OK(hrt_profile_save(session, 0, nullptr, &length));
  std::string text(static_cast<std::size_t>(length) + 1, '?');
  EXPECT_OK(hrt_profile_save(session, text.size(), text.data(), &length));
  EXPECT_EQ(text.back(), '\0');
  text.pop_back();
  EXPECT_EQ(text.size(), length);
  return text;
}

hrt_result load(hrt_session session, const std::string& text) {
  return hrt_profile_load(session, text.data(), text.size());
}

TEST_F(ProfileTest, IsWhatTheHeaderSays) {
  EXPECT_EQ(
      save(session),
      "{\"format\":\"haptic retargeting profile\",\"version\":1,\"tactile_weight\":0.2,"
      "\"tactile_weight_sd\":0.05,\"bias_deg\":0,\"motor_variance_deg2\":0.5,\"motor_variance_sd_deg2\":0.5,"
      "\"sensory_variance_deg2\":0.1,\"initial_variance_deg2\":0,\"tracker_noise_m\":0}\n");
}

TEST_F(ProfileTest, ComesBackToTheLastBit) {
  hrt_session_config config = session_config();
  config.tactile_weight = 0.1 + 1e-17 + 0.02;
  config.motor_variance_deg2 = 1.0 / 3.0;
  config.horizon = 9;
  ASSERT_OK(hrt_session_set_config(session, &config));
  const std::string text = save(session);
  create(session_config());
  ASSERT_OK(load(session, text));
  auto back = output<hrt_session_config>();
  ASSERT_OK(hrt_session_get_config(session, &back));
  EXPECT_EQ(back.tactile_weight, config.tactile_weight);
  EXPECT_EQ(back.motor_variance_deg2, config.motor_variance_deg2);
  EXPECT_EQ(back.horizon, 3u) << "a profile is the participant's, not the session's";
}

// As libraries of version 0.1 wrote them.
TEST_F(ProfileTest, EarlierProfilesLoadAndLeaveTheRest) {
  hrt_session_config config = session_config();
  config.bias_deg = 1.5;
  config.motor_variance_sd_deg2 = 0.25;
  config.tracker_noise_m = 0.001;
  ASSERT_OK(hrt_session_set_config(session, &config));
  ASSERT_OK(load(
      session,
      R"({"format":"haptic retargeting profile","version":1,"tactile_weight":0.2,"tactile_weight_sd":0.02,)"
      R"("motor_variance_deg2":0.6,"sensory_variance_deg2":0.2,"initial_variance_deg2":0.1})"));
  auto back = output<hrt_session_config>();
  ASSERT_OK(hrt_session_get_config(session, &back));
  EXPECT_EQ(back.tactile_weight, 0.2);
  EXPECT_EQ(back.motor_variance_deg2, 0.6);
  EXPECT_EQ(back.bias_deg, 1.5);
  EXPECT_EQ(back.motor_variance_sd_deg2, 0.25);
  EXPECT_EQ(back.tracker_noise_m, 0.001);
}

TEST_F(ProfileTest, SmallBufferIsRefused) {
  const std::string whole = save(session);
  std::string text(whole.size(), '?');
  uint64_t length = 99;
  expect_error(hrt_profile_save(session, text.size(), text.data(), &length), HRT_ERROR_BUFFER_TOO_SMALL,
               "capacity");
  EXPECT_EQ(length, 99u);
  EXPECT_EQ(text, std::string(whole.size(), '?'));
}

TEST_F(ProfileTest, WhatIsNotAProfileIsRefusedAndChangesNothing) {
  const auto profile = [](const std::string& fields) {
    return R"({"format":"haptic retargeting profile","version":1)" + fields + "}";
  };
  const std::string before = save(session);
  expect_error(load(session, ""), HRT_ERROR_BAD_FORMAT, "not a JSON object");
  expect_error(load(session, "[]"), HRT_ERROR_BAD_FORMAT, "not a JSON object");
  expect_error(load(session, before.substr(0, 50)), HRT_ERROR_BAD_FORMAT, "not a JSON object");
  expect_error(load(session, std::string(50'000, '[')), HRT_ERROR_BAD_FORMAT, "not a JSON object");
  expect_error(load(session, std::string(70'000, ' ')), HRT_ERROR_BAD_FORMAT, "70000 bytes");
  expect_error(load(session, "{}"), HRT_ERROR_BAD_FORMAT, "format");
  expect_error(load(session, R"({"format":"haptic retargeting profile","version":2})"), HRT_ERROR_BAD_FORMAT,
               "version");
  expect_error(load(session, profile(",\"horizon\":4")), HRT_ERROR_BAD_FORMAT, "\"horizon\"");
  expect_error(load(session, profile(",\"tactile_weight\":\"0.2\"")), HRT_ERROR_BAD_FORMAT, "tactile_weight");
  expect_error(load(session, profile(",\"tactile_weight\":0.9")), HRT_ERROR_OUT_OF_RANGE,
               "tactile_weight is 0.9");
  expect_error(load(session, profile(",\"tactile_weight\":1e999")), HRT_ERROR_BAD_FORMAT,
               "not a JSON object");
  expect_error(hrt_profile_load(session, nullptr, 5), HRT_ERROR_NULL_ARGUMENT, "text");
  begin_reach();
  expect_error(load(session, before), HRT_ERROR_WRONG_STATE, "under way");
  EXPECT_EQ(save(session), before);
}

}  // namespace
}  // namespace hrt::test
