// The host's locale has a decimal comma. Texts that the library reads and writes must not depend on it.
#include <clocale>
#include <cstdlib>

#include "tests/plugin/recording/recording_fixture.h"

namespace hrt::test {
namespace {

class LocaleTest : public RecordingTest {
 protected:
  void SetUp() override {
    ASSERT_EQ(setenv("LOCPATH", HRT_LOCALES, 1), 0);
    ASSERT_NE(std::setlocale(LC_ALL, "de_DE.UTF-8"), nullptr) << "no such locale in " << HRT_LOCALES;
    char text[8];
    std::snprintf(text, sizeof text, "%.1f", 2.5);
    ASSERT_STREQ(text, "2,5");
    RecordingTest::SetUp();
  }
  void TearDown() override {
    RecordingTest::TearDown();
    std::setlocale(LC_ALL, "C");
  }
};

TEST_F(LocaleTest, ProfilesAreUnchangedByADecimalComma) {
  hrt_session_config config = session_config();
  config.paper.sensory_variance_deg2 = 2.7;
  config.tracker.noise_m = 1.25e-5;
  create(config);
  const std::string profile = save_profile();
  EXPECT_NE(profile.find("\"sensory_variance_deg2\":2.7,"), std::string::npos) << profile;
  create(session_config());
  ASSERT_OK(load_profile(profile));
  EXPECT_TRUE(same(config_of(session), config));
}

TEST_F(LocaleTest, RecordingsReplayWithADecimalComma) {
  create(session_config());
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  begin_reach();
  for (int i = 0; i < 50; ++i) update(position_sample(i * 11'111'111, 0.0001 * i, 0.001 * i - 0.05));
  end();
  stop();
  const hrt_replay_report report = replay(read(path()));
  expect_same(report);
  EXPECT_EQ(report.rows, 52u);
  expect_golden_bits();
}

TEST_F(LocaleTest, ScenesHaveTheSamePositionsWithADecimalComma) {
  std::vector<hrt_scene_target> targets[2];
  for (std::vector<hrt_scene_target>& places : targets) {
    hrt_scene scene{};
    ASSERT_OK(hrt_scene_load(HRT_DESK_SCENE, nullptr, 0, &scene));
    auto info = output<hrt_scene_info>();
    ASSERT_OK(hrt_scene_get_info(scene, &info));
    for (uint32_t i = 0; i < info.target_count; ++i) {
      places.push_back(output<hrt_scene_target>());
      ASSERT_OK(hrt_scene_get_target(scene, i, &places.back()));
    }
    ASSERT_OK(hrt_scene_destroy(scene));
    std::setlocale(LC_ALL, "C");
  }
  ASSERT_GE(targets[0].size(), 2u);
  ASSERT_EQ(targets[0].size(), targets[1].size());
  for (std::size_t i = 0; i < targets[0].size(); ++i)
    EXPECT_TRUE(same(targets[0][i], targets[1][i])) << targets[0][i].name;
}

TEST_F(LocaleTest, ErrorTextsHaveDecimalPoints) {
  hrt_session_config config = session_config();
  config.person.tactile_weight = 0.625;
  hrt_session other{};
  expect_error(hrt_session_create(HRT_VERSION, &config, &other), HRT_ERROR_OUT_OF_RANGE,
               "tactile_weight is 0.625; allowed: 0.001 to 0.499");
  const std::string scene = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[
    {"name":"plate","extras":{"haptic":{"role":"plate","radius_m":-2.5}}}]})";
  hrt_scene loaded{};
  expect_error(hrt_scene_load("scene.gltf", scene.data(), scene.size(), &loaded), HRT_ERROR_BAD_FORMAT, "-2.5");
}

}  // namespace
}  // namespace hrt::test
