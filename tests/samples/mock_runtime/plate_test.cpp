// XR_HRTX_ridged_plate: reaches of simulated participants, as an application observes them.
#include <cmath>

#include "core/simulation/person.h"
#include "plugin/src/abi/hash.h"
#include "tests/samples/mock_runtime/support.h"

namespace hrt::mock {
namespace {

class MockPlate : public MockRuntime {
 protected:
  void SetUp() override {
    MockRuntime::SetUp();
    begin_on_plate(R"({"participants": [{"steering": "steps", "tactile_weight": 0.15}]})");
  }
  void begin_on_plate(const std::string& script) {
    begin_with(script);
    plate_space = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL, plate_pose);
  }
  void place_plate() { MockRuntime::place_plate(plate_space); }
  void instruct(double goal_deg) { MockRuntime::instruct(goal_deg, {0.0F, 0.007F, 0.05F}); }

  XrVector3f index_tip(XrTime time) {
    const Hand located = locate_hand(hand, plate_space, time);
    EXPECT_TRUE(located.active);
    return located.index_tip();
  }

  // Plate in front of the user, rotated 90 degrees to the left.
  static constexpr XrPosef plate_pose{{0.0F, 0.70710678F, 0.0F, 0.70710678F}, {0.1F, -0.4F, -0.3F}};
  XrSpace plate_space = XR_NULL_HANDLE;
};

template <typename Value>
void add(plugin::Hash& hash, const Value& value) {
  hash.add({reinterpret_cast<const char*>(&value), sizeof value});
}

const Person scripted_person{
    .illusion = {.family = IllusionFamily::saturating, .tactile_weight = 0.22, .scale_deg = 50.0},
    .steering = Steering::place,
    .gain_per_s = 7.0,
    .delay_s = 0.09,
    .noise_deg2_per_s = 5.0,
    .start_direction_deg = 1.5,
    .bias_deg = 2.0,
    .own_bias_deg = -1.0,
    .habit_deg = 4.0,
    .weight_drift = 0.03,
    .pace = Pace::stop_and_go,
    .duration_s = 1.3,
    .path_scale = 1.1};

// Every key of a participant takes effect: the reach equals that of a SlidingPerson with the same values.
TEST_F(MockPlate, ReachEqualsThatOfAPersonWithTheValuesOfTheScript) {
  begin_on_plate(R"({"seed": 6, "frame_rate_hz": 100, "participants": [{
      "illusion": "saturating", "illusion_scale_deg": 50, "tactile_weight": 0.22, "weight_drift": 0.03,
      "steering": "place", "gain_per_s": 7, "delay_ms": 90, "noise_deg2_per_s": 5, "start_direction_deg": 1.5,
      "bias_deg": 2, "own_bias_deg": -1, "habit_deg": 4, "pace": "stop_and_go", "duration_ms": 1300,
      "path_scale": 1.1, "reaction_ms": 250}]})");
  frame();  // the first frame begins immediately, each later one after 10 ms
  place_plate();
  instruct(5.0);
  SlidingPerson expected(scripted_person, {0.0, -50.0}, 5.0, 100.0, Draws(6, 1, 0, 0));
  XrTime now = 1'000'000'000;  // first time of a manual clock
  double plate_deg = 0.0, peak_deg = 0.0;
  for (int period = 0; !truth().isDone; ++period) {
    frame();
    now += 10'000'000;
    for (int millisecond = 0; period >= 25 && millisecond < 10; ++millisecond) {
      expected.advance(plate_deg);
      if (expected.elapsed_s() > 0.05 && expected.speed_mm_s() > 10.0)
        peak_deg = std::max(peak_deg, std::abs(expected.felt_error_deg()));
    }
    const XrVector3f tip = index_tip(now);
    EXPECT_NEAR(static_cast<double>(tip.x), 1e-3 * expected.position().right_mm, 1e-6);
    EXPECT_NEAR(static_cast<double>(tip.z), -1e-3 * expected.position().away_mm, 1e-6);
    plate_deg = 8.0 * (period % 13) - 50.0;
    ASSERT_XR(XR_SUCCESS, XR(xrSetPlateOrientationHRTX)(session, plate_deg));
  }
  EXPECT_TRUE(expected.done());
  EXPECT_NEAR(truth().perceivedDirection, 5.0 + expected.felt_error_deg(), 1e-12);
  EXPECT_EQ(truth().trueDirection, expected.direction_deg());
  EXPECT_EQ(truth().peakFeltError, peak_deg);
  EXPECT_GT(peak_deg, 1.0);
}

// Derived by hand: motion = goal + bias - own bias - shift. A plate at 75 degrees shifts the perceived direction by 75
// times the tactile weight to the left, and with the unequal illusion by half of that to the right.
TEST_F(MockPlate, TruthHasTheOutermostFeasibleDirections) {
  begin_on_plate(R"({"participants": [{"illusion": "unequal",
      "tactile_weight": 0.2, "bias_deg": 3, "own_bias_deg": 1}]})");
  place_plate();
  instruct(5.0);
  EXPECT_NEAR(truth().leftmostDirection, 5.0 + 3.0 - 1.0 + 7.5, 1e-12);
  EXPECT_NEAR(truth().rightmostDirection, 5.0 + 3.0 - 1.0 - 15.0, 1e-12);
}

TEST_F(MockPlate, ScriptedSlideEqualsAnInstructedReachAndRepeatsAfterItsRest) {
  const auto begin = [&](const std::string& hands) {
    begin_on_plate(R"({"participants": [{"tactile_weight": 0.2, "duration_ms": 800, "reaction_ms": 300}])" + hands +
                   "}");
    frame();
    place_plate();
    ASSERT_XR(XR_SUCCESS, XR(xrSetPlateOrientationHRTX)(session, 40.0));
  };
  constexpr int frames_of_a_slide = 98;  // almost 300 ms and 800 ms, at 90 Hz
  std::vector<float> instructed;
  begin("");
  instruct(5.0);
  for (int i = 0; i < frames_of_a_slide; ++i) instructed.push_back(index_tip(frame()).x);
  EXPECT_GT(std::abs(instructed.back() - instructed.front()), 0.002F);

  begin(R"(, "hands": {"right": {"slides": {"start_m": [0, 0.007, 0.05], "direction_deg": 5, "rest_ms": 400}}})");
  std::vector<float> along;
  for (int i = 0; i < 3 * frames_of_a_slide; ++i) {
    const XrVector3f tip = index_tip(frame());
    if (i < frames_of_a_slide) {
      EXPECT_EQ(tip.x, instructed[i]) << i;
    }
    along.push_back(tip.z);
  }
  std::vector<int> starts;
  for (int i = 1; i < static_cast<int>(along.size()); ++i)
    if (along[i] - along[i - 1] > 0.09F) starts.push_back(i);
  ASSERT_EQ(starts.size(), 2U);
  EXPECT_NEAR(starts[0], 1.5 * 90.0, 1.5);  // 300 ms, 800 ms and 400 ms
  EXPECT_NEAR(starts[1], 3.0 * 90.0, 3.0);
}

// The hash is the same for every compiler and build: a script and a seed give the same positions on every computer.
TEST_F(MockPlate, ReachesHaveTheSameHashOnEveryPlatform) {
  begin_on_plate(R"({"seed": 3, "servo": {"speed_deg_per_s": 400},
      "participants": [{}, {"illusion": "tanh", "steering": "heavy_arm"}, {"steering": "steps"}],
      "tracker": {"noise_mm": 1.2, "rate_hz": 90, "latency_ms": 10}})");
  place_plate();
  plugin::Hash hash;
  for (int reach = 0; reach < 3; ++reach) {
    instruct(5.0);
    while (!truth().isDone) {
      const XrTime time = frame();
      const XrVector3f tip = index_tip(time);
      ASSERT_XR(XR_SUCCESS, XR(xrSetPlateOrientationHRTX)(session, static_cast<double>(time % 60)));
      add(hash, tip);
    }
  }
  EXPECT_EQ(hash.value(), 6041797942353730450U);
}

TEST_F(MockPlate, JointsOfAHandOnAPathHaveTheSameHashOnEveryPlatform) {
  begin_on_plate(R"({"tracker": {"noise_mm": 1.2},
      "hands": {"right": {"path": [
        {"time_ms": 0, "position_m": [0.1, -0.3, -0.2], "orientation": [0.6, 0, 0, 0.8]},
        {"time_ms": 700, "position_m": [0.2, -0.4, -0.3], "orientation": [0, -0.8, 0, -0.6]},
        {"time_ms": 1100, "position_m": [0.15, -0.35, -0.3]}]}}})");
  plugin::Hash hash;
  for (int i = 0; i < 120; ++i) {
    const Hand located = locate_hand(hand, plate_space, frame());
    for (const XrHandJointLocationEXT& joint : located.joints) add(hash, joint.pose);
  }
  EXPECT_EQ(hash.value(), 13559203345539007447U);
}

}  // namespace
}  // namespace hrt::mock
