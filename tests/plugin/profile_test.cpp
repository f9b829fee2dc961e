#include <iterator>

#include "tests/plugin/guided_person.h"

namespace hrt::test {
namespace {

using ProfileTest = SessionTest;

TEST_F(ProfileTest, TextIsThatOfTheHeadersExample) {
  EXPECT_EQ(save_profile(),
            "{\"format\":\"haptic retargeting profile\",\"version\":1,\"tracker_noise_m\":0,\"tactile_weight\":0.2,"
            "\"tactile_weight_sd\":0.05,\"bias_deg\":0,\"motor_variance_deg2\":0.5,\"motor_variance_sd_deg2\":0.5,"
            "\"sensory_variance_deg2\":0.1,\"initial_variance_deg2\":0}\n");
}

TEST_F(ProfileTest, LoadingASavedProfileRestoresItBitForBit) {
  hrt_session_config config = session_config();
  config.person.tactile_weight = 0.1 + 1e-17 + 0.02;
  config.paper.motor_variance_deg2 = 1.0 / 3.0;
  config.paper.horizon = 9;
  ASSERT_OK(hrt_session_set(session, &config));
  const std::string text = save_profile();
  create(session_config());
  ASSERT_OK(load_profile(text));
  const hrt_session_config back = config_of(session);
  EXPECT_EQ(back.person.tactile_weight, config.person.tactile_weight);
  EXPECT_EQ(back.paper.motor_variance_deg2, config.paper.motor_variance_deg2);
  EXPECT_EQ(back.paper.horizon, 3u) << "a profile is the participant's, not the session's";
}

TEST_F(ProfileTest, MissingFieldsKeepTheirValues) {
  hrt_session_config config = session_config();
  config.person.bias_deg = 1.5;
  config.paper.motor_variance_sd_deg2 = 0.25;
  config.tracker.noise_m = 0.001;
  ASSERT_OK(hrt_session_set(session, &config));
  ASSERT_OK(load_profile(profile_with(R"(,"tactile_weight":0.2,"tactile_weight_sd":0.02,"motor_variance_deg2":0.6)")));
  const hrt_session_config back = config_of(session);
  EXPECT_EQ(back.person.tactile_weight, 0.2);
  EXPECT_EQ(back.paper.motor_variance_deg2, 0.6);
  EXPECT_EQ(back.person.bias_deg, 1.5);
  EXPECT_EQ(back.paper.motor_variance_sd_deg2, 0.25);
  EXPECT_EQ(back.tracker.noise_m, 0.001);
}

TEST_F(ProfileTest, TooSmallBufferIsRejected) {
  const std::string whole = save_profile();
  std::string text(whole.size(), '?');
  uint64_t length = 99;
  expect_error(hrt_profile_save(session, text.size(), text.data(), &length), HRT_ERROR_BUFFER_TOO_SMALL, "capacity");
  EXPECT_EQ(length, 99u);
  EXPECT_EQ(text, std::string(whole.size(), '?'));
}

struct BadProfile {
  std::string text;
  hrt_result result;
  const char* named = "";
};

TEST_F(ProfileTest, MalformedProfilesAreRejectedAndChangeNothing) {
  const std::string before = save_profile();
  const BadProfile refused[] = {
      {"", HRT_ERROR_BAD_FORMAT, "not valid JSON at byte 1"},
      {"[]", HRT_ERROR_BAD_FORMAT, "not a JSON object"},
      {before.substr(0, 50), HRT_ERROR_BAD_FORMAT, "not valid JSON at byte 51"},
      {std::string(50'000, '['), HRT_ERROR_BAD_FORMAT},
      {std::string(70'000, ' '), HRT_ERROR_BAD_FORMAT, "70000"},
      {"{}", HRT_ERROR_BAD_FORMAT, "format"},
      {R"({"format":"haptic retargeting profile","version":2})", HRT_ERROR_BAD_FORMAT, "version"},
      {profile_with(",\"horizon\":4"), HRT_ERROR_BAD_FORMAT, "\"horizon\""},
      {profile_with(",\"tactile_weight\":\"0.2\""), HRT_ERROR_BAD_FORMAT, "tactile_weight"},
      {profile_with(",\"tactile_weight\":true"), HRT_ERROR_BAD_FORMAT, "\"tactile_weight\" is or contains true"},
      {profile_with(",\"tactile_weight\":[{}]"), HRT_ERROR_BAD_FORMAT, "\"tactile_weight\" is or contains an object"},
      {profile_with(",\"tactile_weight\":0.9"), HRT_ERROR_OUT_OF_RANGE, "tactile_weight"},
      {profile_with(",\"tactile_weight\":1e999"), HRT_ERROR_BAD_FORMAT},
      {profile_with(R"(,"plate":7)"), HRT_ERROR_BAD_FORMAT, "plate"},
      {profile_with(R"(,"plate":")" + std::string(64, 'x') + '"'), HRT_ERROR_BAD_FORMAT, "plate"},
      {profile_with(R"(,"tracker":"a\tb")"), HRT_ERROR_OUT_OF_RANGE, "tracker"},
      {profile_with(R"(,"measured_at_s":1.5)"), HRT_ERROR_BAD_FORMAT, "measured_at_s"},
      {profile_with(R"(,"measured_at_s":-1)"), HRT_ERROR_OUT_OF_RANGE, "time_s"},
  };
  for (const BadProfile& bad : refused) expect_error(load_profile(bad.text), bad.result, bad.named);
  begin_reach();
  expect_error(load_profile(before), HRT_ERROR_WRONG_STATE);
  EXPECT_EQ(save_profile(), before);
}

hrt_conditions conditions(const char* plate, const char* tracker, std::int64_t time_s = 0) {
  auto now = output<hrt_conditions>();
  now.time_s = time_s;
  std::snprintf(now.plate, sizeof now.plate, "%s", plate);
  std::snprintf(now.tracker, sizeof now.tracker, "%s", tracker);
  return now;
}

class ConditionsTest : public ProfileTest {
 protected:
  void set(const hrt_conditions& now) { ASSERT_OK(hrt_profile_set_conditions(session, &now)); }
  hrt_conditions measured() {
    auto out = output<hrt_conditions>();
    EXPECT_OK(hrt_profile_get_conditions(session, &out));
    return out;
  }
  Log log;
  const std::string of_desk_1 = profile_with(R"(,"measured_at_s":5,"plate":"desk 1","tracker":"Ultraleap")");
};

TEST_F(ConditionsTest, CalibrationStoresConditionsAndProfilesRestoreThem) {
  set(conditions("desk \"1\" \\ \u00fc", "Ultraleap", 1'767'225'600));
  EXPECT_STREQ(measured().plate, "") << "nothing was measured yet";
  GuidedPerson person = quiet_person(true);
  EXPECT_EQ(set_up(session, HRT_SETUP_CALIBRATION, &person).done, HRT_SETUP_CALIBRATION);
  set(conditions("another", "another", 1));
  const std::string text = save_profile();
  EXPECT_NE(text.find(R"("measured_at_s":1767225600,"plate":"desk \"1\" \\ ü","tracker":"Ultraleap"})"),
            std::string::npos)
      << text;
  create(session_config());
  ASSERT_OK(load_profile(text));
  const hrt_conditions back = measured();
  EXPECT_EQ(back.time_s, 1'767'225'600);
  EXPECT_STREQ(back.plate, "desk \"1\" \\ \u00fc");
  EXPECT_STREQ(back.tracker, "Ultraleap");
  EXPECT_EQ(back.differing, 0u) << "the present conditions are unknown";
  EXPECT_EQ(save_profile(), text);
}

TEST_F(ConditionsTest, DifferentConditionsLogAWarning) {
  set(conditions("desk 1", "Ultraleap"));
  ASSERT_OK(load_profile(of_desk_1));
  const std::string text = save_profile();
  EXPECT_EQ(log.text, "");
  set(conditions("desk 2", "Ultraleap"));
  EXPECT_EQ(measured().differing, HRT_CONDITION_PLATE);
  EXPECT_NE(log.text.find("measured with another plate, \"desk 1\";"), std::string::npos) << log.text;
  log.text.clear();
  set(conditions("desk 1", "Quest"));
  ASSERT_OK(load_profile(text));
  EXPECT_EQ(measured().differing, HRT_CONDITION_TRACKER);
  EXPECT_NE(log.text.find("measured with another tracker, \"Ultraleap\";"), std::string::npos) << log.text;
  log.text.clear();
  {
    const Log own(session);
    set(conditions("desk 2", "Ultraleap"));
    EXPECT_NE(own.text.find("another plate"), std::string::npos) << own.text;
    EXPECT_EQ(log.text, "") << "the session has a log of its own";
  }
  set(conditions("desk 2", "Quest"));
  EXPECT_EQ(measured().differing, HRT_CONDITION_PLATE | HRT_CONDITION_TRACKER);
  EXPECT_NE(log.text.find("another plate, \"desk 1\", and tracker, \"Ultraleap\";"), std::string::npos) << log.text;
  log.text.clear();
  set(conditions("", ""));
  EXPECT_EQ(measured().differing, 0u) << "an unknown condition does not differ";
  ASSERT_OK(load_profile(profile_with(",\"tactile_weight\":0.2")));
  set(conditions("desk 2", "Quest"));
  EXPECT_EQ(measured().differing, 0u) << "a profile without conditions";
  EXPECT_EQ(log.text, "");
}

TEST_F(ConditionsTest, ResetClearsTheConditionsOfTheMeasurement) {
  ASSERT_OK(load_profile(of_desk_1));
  ASSERT_OK(hrt_profile_reset(session));
  EXPECT_STREQ(measured().plate, "");
  EXPECT_STREQ(measured().tracker, "");
  EXPECT_EQ(measured().time_s, 0);
  set(conditions("desk 2", "Quest"));
  EXPECT_EQ(measured().differing, 0u);
  EXPECT_EQ(log.text, "");
}

TEST_F(ConditionsTest, InvalidConditionsAreRejectedAndChangeNothing) {
  ASSERT_OK(load_profile(of_desk_1));
  const auto refused = [&](const hrt_conditions& bad, hrt_result code, const char* part) {
    expect_error(hrt_profile_set_conditions(session, &bad), code, part);
  };
  refused(conditions("a\nb", ""), HRT_ERROR_OUT_OF_RANGE, "plate");
  refused(conditions("", "\xff"), HRT_ERROR_OUT_OF_RANGE, "tracker");
  hrt_conditions endless = conditions("", "");
  std::fill(std::begin(endless.tracker), std::end(endless.tracker), 'x');
  refused(endless, HRT_ERROR_OUT_OF_RANGE, "tracker");
  EXPECT_STREQ(measured().plate, "desk 1");
  EXPECT_EQ(measured().time_s, 5);
  begin_reach();
  refused(conditions("desk 2", ""), HRT_ERROR_WRONG_STATE, "reach");
}

}  // namespace
}  // namespace hrt::test
