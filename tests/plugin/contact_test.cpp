// Contacts with the real object, which reveal an error of the tracker's frame.
#include <functional>

#include "core/plate/plate_frame.h"
#include "core/simulation/random.h"
#include "tests/plugin/guided_person.h"

namespace hrt::test {
namespace {

constexpr PlatePoint start{0.0, -50.0};

hrt_contact contact_at(const PlatePoint& place, double sd_m) {
  auto contact = output<hrt_contact>();
  contact.flags = HRT_CONTACT_PLATE_POSITION;
  contact.position_m[0] = place.right_mm / mm_per_m;
  contact.position_m[2] = -place.away_mm / mm_per_m;
  contact.sd_m = sd_m;
  return contact;
}

hrt_contact contact_in(double direction_deg, double sd_m = 0.001) {
  return contact_at(point_ahead(start, direction_deg, 100.0), sd_m);
}

bool has_no_contacts(const hrt_session_config& config) {
  const hrt_session_config none = session_config();
  return same(config.registration.contact_correction, none.registration.contact_correction) &&
         same(config.registration.contact_covariance, none.registration.contact_covariance);
}

class ContactTest : public SessionTest {
 protected:
  void SetUp() override { create(registered()); }

  static hrt_session_config registered() {
    hrt_session_config config = session_config();
    config.flags = HRT_SESSION_REGISTERED;
    config.tracker.noise_m = 0.0001;
    return config;
  }

  void begin_straight_ahead(double radius_m = 0.0) {
    hrt_target_config real = target_config(HRT_TARGET_REAL, 0.0);
    real.radius_m = radius_m;
    ASSERT_OK(begin(add(real), add(HRT_TARGET_VIRTUAL, 0.0)));
  }

  hrt_reach_summary reach_straight_ahead() {
    begin_straight_ahead();
    slide();
    return end();
  }

  hrt_result touch(const hrt_contact& contact) { return hrt_reach_touched(session, &contact); }
  void refused(const hrt_contact& contact, const char* part) {
    expect_error(touch(contact), HRT_ERROR_OUT_OF_RANGE, part);
  }
};

// The frame is rotated by 2 degrees: the finger is tracked at 0 degrees and is at -2 degrees. With a prior SD of 2 mm
// and an SD of the contact of 1 mm, 1.6 degrees are corrected, by which the estimated bias decreases.
TEST_F(ContactTest, OneContactCorrectsFourFifthsOfARotatedFrame) {
  EXPECT_NEAR(reach_straight_ahead().miss_deg, 0.0, 0.05);
  const double bias_deg = config_of(session).person.mean[HRT_PERSON_BIAS];
  ASSERT_OK(touch(contact_in(-2.0)));
  const hrt_session_config after = config_of(session);
  EXPECT_NEAR(after.person.mean[HRT_PERSON_BIAS], bias_deg - 1.6, 0.05);
  const hrt_reach_summary summary = reach_straight_ahead();
  EXPECT_NEAR(summary.miss_deg, -1.6, 0.05);
  EXPECT_NEAR(summary.miss_sd_deg, deg_per_rad * 0.02 / std::sqrt(5.0), 0.05);
  EXPECT_EQ(summary.flags & HRT_COMMAND_CONTACTS, 0u);
}

TEST_F(ContactTest, ContactBeforeOrAfterTheEndGivesTheSameCorrection) {
  reach_straight_ahead();
  ASSERT_OK(touch(contact_in(-2.0)));
  const hrt_session_config after = config_of(session);
  create(registered());
  begin_straight_ahead();
  slide();
  ASSERT_OK(touch(contact_in(-2.0)));
  EXPECT_TRUE(has_no_contacts(config_of(session))) << "the contact is applied at the end of the reach";
  end();
  EXPECT_TRUE(same(config_of(session), after));
}

TEST_F(ContactTest, ContactKeepsTheBiasUnlessEstimatesAreCarried) {
  hrt_session_config config = registered();
  config.adaptation = HRT_ADAPTATION_REACH;
  config.person.bias_deg = 3.0;
  create(config);
  reach_straight_ahead();
  ASSERT_OK(touch(contact_in(-2.0)));
  EXPECT_EQ(config_of(session).person.bias_deg, 3.0);
  EXPECT_EQ(config_of(session).person.mean[HRT_PERSON_BIAS], 0.0);
  EXPECT_FALSE(has_no_contacts(config_of(session)));
}

// The finger is tracked at 100 mm. The near side of an object of 20 mm radius is at 80 mm, with an SD of 20 mm. The
// prior SD of the correction is 0.02, which is 2 mm at 100 mm.
TEST_F(ContactTest, DefaultPositionIsTheNearSideOfTheRealTarget) {
  begin_straight_ahead(0.02);
  slide();
  ASSERT_OK(hrt_reach_touched(session, nullptr));
  end();
  EXPECT_NEAR(config_of(session).registration.contact_correction[3], 4e-4 * 0.1 / 4.04e-4 * -0.02, 1e-4);
  EXPECT_NEAR(config_of(session).registration.contact_covariance[9], 4e-4 * (1.0 - 4e-6 / 4.04e-4), 1e-8);
  create(registered());
  reach_straight_ahead();
  ASSERT_OK(touch(output<hrt_contact>()));
  EXPECT_NEAR(config_of(session).registration.contact_correction[3], 0.0, 1e-4);
  EXPECT_NEAR(config_of(session).registration.contact_covariance[9], 4e-4 * (1.0 - 4e-6 / 1.04e-4), 1e-7) << "10 mm";
}

TEST_F(ContactTest, ConvertsAWorldPositionToPlateCoordinates) {
  hrt_session_config config = registered();
  config.plate.position_m[0] = 1.0;
  config.plate.scale = 1.25;
  create(config);
  reach_straight_ahead();
  hrt_contact contact = contact_in(-2.0);
  contact.flags = HRT_CONTACT_WORLD_POSITION;
  contact.position_m[0] = 1.0 + 1.25 * contact.position_m[0];
  contact.position_m[2] *= 1.25;
  ASSERT_OK(touch(contact));
  EXPECT_NEAR(reach_straight_ahead().miss_deg, -1.6, 0.05);
}

// The paper's controller also uses corrected positions: after the contact, the reach ends 1.6 degrees off the target.
TEST_F(ContactTest, CorrectsPositionsUnderFixedDirection) {
  hrt_session_config config = paper_config();
  config.flags = HRT_SESSION_REGISTERED;
  config.tracker.noise_m = 0.0001;
  create(config);
  EXPECT_LT(reach_straight_ahead().distance_to_target_m, 0.0003);
  ASSERT_OK(touch(contact_in(-2.0)));
  EXPECT_NEAR(reach_straight_ahead().distance_to_target_m, 0.1 * 1.6 / deg_per_rad, 0.0003);
}

// A contact contradicts the registration if it moves the target by more than 3.717 prior SDs of 2 mm, or 7.4 mm.
TEST_F(ContactTest, FlagsAContactThatContradictsTheRegistration) {
  for (const bool contradicts : {false, true}) {
    create(registered());
    begin_straight_ahead();
    const hrt_contact contact = contact_at({contradicts ? 8.0 : 7.0, 50.0}, 0.0001);
    EXPECT_EQ(slide().flags & HRT_COMMAND_CONTACTS, 0u);
    ASSERT_OK(touch(contact));
    const std::uint32_t expected = contradicts ? HRT_COMMAND_CONTACTS : 0;
    EXPECT_EQ(end().flags & HRT_COMMAND_CONTACTS, expected);
    begin_straight_ahead();
    EXPECT_EQ(slide().flags & HRT_COMMAND_CONTACTS, expected);
    EXPECT_EQ(end().flags & HRT_COMMAND_CONTACTS, expected);
  }
}

TEST_F(ContactTest, RejectedContactsNameTheReasonAndChangeNothing) {
  expect_error(touch(contact_in(0.0)), HRT_ERROR_WRONG_STATE);
  begin_straight_ahead();
  expect_error(touch(contact_in(0.0)), HRT_ERROR_INSUFFICIENT_DATA);
  slide();
  hrt_contact contact = contact_in(0.0);
  contact.position_m[0] = std::nan("");
  refused(contact, "position_m[0]");
  contact = contact_in(0.0, std::nan(""));
  refused(contact, "sd_m");
  refused(contact_in(0.0, 0.00001), "sd_m");
  contact.flags = HRT_CONTACT_PLATE_POSITION | HRT_CONTACT_WORLD_POSITION;
  refused(contact, "flags");
  contact.flags = 4;
  refused(contact, "flags");
  refused(contact_at({0.0, -41.0}, 0.001), "start_position_m; allowed: at least 0.01");
  refused(contact_at({0.0, -50.0}, 0.001), "0 m from start_position_m");
  refused(contact_at({35.0, 50.0}, 0.001), "allowed: up to 0.0");
  ASSERT_OK(touch(contact_at({25.0, 50.0}, 0.001)));
  expect_error(touch(contact_in(0.0)), HRT_ERROR_WRONG_STATE);
  ASSERT_OK(hrt_reach_cancel(session));
  EXPECT_TRUE(has_no_contacts(config_of(session))) << "a cancelled reach discards its contact";
  expect_error(touch(contact_in(0.0)), HRT_ERROR_WRONG_STATE);
  reach_straight_ahead();
  const hrt_session_config config = config_of(session);
  ASSERT_OK(hrt_session_set(session, &config));
  expect_error(touch(contact_in(0.0)), HRT_ERROR_WRONG_STATE);
  create(session_config());
  reach_straight_ahead();
  expect_error(touch(contact_in(0.0)), HRT_ERROR_WRONG_STATE);
}

class KnownContactTest : public ContactTest {
 protected:
  void SetUp() override {
    ContactTest::SetUp();
    reach_straight_ahead();
    ASSERT_OK(touch(contact_in(-2.0)));
    known = config_of(session);
    ASSERT_FALSE(has_no_contacts(known));
  }

  hrt_session_config loaded(const std::string& profile, const hrt_session_config& config) {
    create(config);
    EXPECT_OK(load_profile(profile));
    return config_of(session);
  }

  hrt_session_config known{};
};

// Loading adds a variance of 0.002^2 to each element of the correction, because the tracker may have drifted.
TEST_F(KnownContactTest, ProfileWithTheSamePoseRestoresContactsAndAddsDrift) {
  const hrt_session_config back = loaded(save_profile(), registered());
  EXPECT_TRUE(same(back.registration.contact_correction, known.registration.contact_correction));
  for (int row = 0, at = 0; row < 4; ++row)
    for (int column = 0; column <= row; ++column, ++at)
      EXPECT_NEAR(back.registration.contact_covariance[at],
                  known.registration.contact_covariance[at] + (row == column ? 4e-6 : 0.0), 1e-18);
}

TEST_F(KnownContactTest, ProfileWithoutContactsKeepsThoseOfTheSession) {
  ASSERT_OK(load_profile(profile_with("")));
  const hrt_session_config back = config_of(session);
  EXPECT_TRUE(same(back.registration.contact_correction, known.registration.contact_correction));
  EXPECT_TRUE(same(back.registration.contact_covariance, known.registration.contact_covariance));
}

TEST_F(KnownContactTest, ProfileWithAnotherPoseDiscardsContacts) {
  const std::string profile = save_profile();
  for (const int coordinate : {0, 1, 2}) {
    hrt_session_config elsewhere = registered();
    elsewhere.plate.position_m[coordinate] = 0.001;
    const hrt_session_config back = loaded(profile, elsewhere);
    EXPECT_TRUE(has_no_contacts(back));
    EXPECT_EQ(back.plate.position_m[coordinate], 0.001);
    EXPECT_EQ(back.person.mean[HRT_PERSON_BIAS], known.person.mean[HRT_PERSON_BIAS]);
  }
}

TEST_F(KnownContactTest, SettingAnotherPoseDiscardsContacts) {
  hrt_session_config config = known;
  config.paper.horizon = 4;
  ASSERT_OK(hrt_session_set(session, &config));
  EXPECT_FALSE(has_no_contacts(config_of(session)));
  config.plate.scale = 1.01;
  ASSERT_OK(hrt_session_set(session, &config));
  EXPECT_TRUE(has_no_contacts(config_of(session)));
}

TEST_F(KnownContactTest, RegisteringASceneDiscardsContacts) {
  known.registration.time_ns = 5;
  known.plate.covariance[0] = 1e-4;
  ASSERT_OK(hrt_session_set(session, &known));
  hrt_scene scene{};
  ASSERT_OK(hrt_scene_load(HRT_DESK_SCENE, nullptr, 0, &scene));
  ASSERT_OK(hrt_scene_register(scene, session, 0, nullptr));
  ASSERT_OK(hrt_scene_destroy(scene));
  const hrt_session_config config = config_of(session);
  EXPECT_TRUE(has_no_contacts(config));
  EXPECT_EQ(config.flags, 0u);
  EXPECT_EQ(config.registration.time_ns, 0);
  for (const double covariance : config.plate.covariance) EXPECT_EQ(covariance, 0.0);
}

TEST_F(KnownContactTest, NewRegistrationDiscardsContacts) {
  GuidedPerson person = quiet_person();
  set_up(session, HRT_SETUP_REGISTRATION, &person);
  EXPECT_TRUE(has_no_contacts(config_of(session)));
}

TEST_F(KnownContactTest, ImpossibleCorrectionsAreRejected) {
  const auto refuses = [&](const std::function<void(hrt_session_config&)>& spoil, const char* part) {
    hrt_session_config config = known;
    spoil(config);
    expect_error(hrt_session_set(session, &config), HRT_ERROR_OUT_OF_RANGE, part);
  };
  refuses([](auto& c) { c.registration.contact_covariance[0] = 0.0; }, "contact_covariance");
  refuses([](auto& c) { c.registration.contact_covariance[9] = -1e-6; }, "contact_covariance");
}

}  // namespace
}  // namespace hrt::test
