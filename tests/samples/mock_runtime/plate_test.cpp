// XR_HRTX_ridged_plate: the participant of the paper, as an application sees it.
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

#include "core/simulation/participant.h"
#include "core/simulation/random.h"
#include "tests/samples/mock_runtime/support.h"

namespace hrt::mock {
namespace {

class MockPlate : public MockRuntime {
 protected:
  void SetUp() override {
    MockRuntime::SetUp();
    ASSERT_XR(XR_SUCCESS,
              functions->apply_script(instance, R"({"participants": [{"tactile_weight": 0.15}]})"));
    begin_session();
    plate_space = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL, plate_pose);
    hand = create_hand_tracker();
  }

  void place_plate() {
    const XrPlatePlacementHRTX placement{XR_TYPE_PLATE_PLACEMENT_HRTX, nullptr, plate_space, identity_pose,
                                         0.075};
    ASSERT_XR(XR_SUCCESS, functions->place_plate(session, &placement));
  }

  void instruct(double goal_deg, double length_m = 0.1) {
    const XrReachInstructionHRTX instruction{XR_TYPE_REACH_INSTRUCTION_HRTX, nullptr,  XR_HAND_RIGHT_EXT,
                                             {0.0F, 0.007F, 0.05F},          goal_deg, length_m};
    ASSERT_XR(XR_SUCCESS, functions->instruct_reach(session, &instruction));
  }

  XrReachTruthHRTX truth() {
    XrReachTruthHRTX truth{XR_TYPE_REACH_TRUTH_HRTX};
    EXPECT_XR(XR_SUCCESS, functions->get_reach_truth(session, XR_HAND_RIGHT_EXT, &truth));
    return truth;
  }

  XrVector3f index_tip(XrTime time) {
    const Hand located = locate_hand(hand, plate_space, time);
    EXPECT_TRUE(located.active);
    return located.index_tip();
  }

  // In front of the user, turned a quarter to the left.
  static constexpr XrPosef plate_pose{{0.0F, 0.70710678F, 0.0F, 0.70710678F}, {0.1F, -0.4F, -0.3F}};
  XrSpace plate_space = XR_NULL_HANDLE;
  XrHandTrackerEXT hand = XR_NULL_HANDLE;
};

// The paper's model, made by hand: 30 steps of 1/30 of the path, noise of seed 1, reach 0.
TEST_F(MockPlate, FingertipFollowsThePaperModelWithThePlateAsItFeelsIt) {
  place_plate();
  ASSERT_XR(XR_SUCCESS, functions->set_plate_orientation(session, 40.0));
  frame();
  instruct(10.0);
  XrTime last = 0;
  while (!truth().isDone) last = frame();

  SimulatedParticipant participant(Participant{}, 10.0);
  double x_m = 0.0;
  double z_m = 0.05;
  for (std::uint32_t step = 0; step < 30; ++step) {
    const double direction = participant.finger_direction_deg() * std::numbers::pi / 180.0;
    x_m -= std::sin(direction) * 0.1 / 30.0;
    z_m -= std::cos(direction) * 0.1 / 30.0;
    participant.step(40.0, standard_normal({1, 0, 0, step}));
  }
  const XrReachTruthHRTX end = truth();
  EXPECT_EQ(end.stepCount, 30U);
  EXPECT_DOUBLE_EQ(end.trueDirection, participant.finger_direction_deg());
  EXPECT_DOUBLE_EQ(end.perceivedDirection, participant.perceived_direction_deg());
  const XrVector3f tip = index_tip(last);
  EXPECT_NEAR(static_cast<double>(tip.x), x_m, 1e-6);
  EXPECT_NEAR(static_cast<double>(tip.y), 0.007, 1e-6);
  EXPECT_NEAR(static_cast<double>(tip.z), z_m, 1e-6);
}

// The ridges lead the hand away from where the participant believes to go (paper, figure 8): at rest
// P = (G - w_T T) / (1 - w_T), which is -5.9 degrees for G = -5 and T = 0.
TEST_F(MockPlate, PlateHeldStillBendsThePathAsThePaperSays) {
  place_plate();
  double sum_deg = 0.0;
  constexpr int reaches = 40;
  for (int i = 0; i < reaches; ++i) {
    instruct(-5.0);
    while (!truth().isDone) frame();
    sum_deg += truth().trueDirection;
  }
  // The end of a reach has a variance of about 0.6 degrees squared.
  EXPECT_NEAR(sum_deg / reaches, -5.0 / 0.85, 4.0 * std::sqrt(0.6 / reaches));
}

// On every compiler and build: a recording made on one host must replay on another.
TEST_F(MockPlate, BytesOfAReachAreThoseOfEveryHost) {
  ASSERT_XR(XR_SUCCESS, xrDestroySession(session));
  ASSERT_XR(XR_SUCCESS, functions->apply_script(instance, R"({"seed": 3, "servo": {"speed_deg_per_s": 400},
      "participants": [{"tactile_weight": 0.15}],
      "tracker": {"noise_mm": 1.2, "rate_hz": 90, "latency_ms": 10}})"));
  begin_session();
  plate_space = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL, plate_pose);
  hand = create_hand_tracker();
  place_plate();
  instruct(5.0);
  std::uint64_t hash = 0xCBF29CE484222325;  // FNV-1a
  while (!truth().isDone) {
    const XrTime time = frame();
    const XrVector3f tip = index_tip(time);
    ASSERT_XR(XR_SUCCESS, functions->set_plate_orientation(session, static_cast<double>(time % 60)));
    std::array<unsigned char, sizeof(tip)> bytes{};
    std::memcpy(bytes.data(), &tip, sizeof(tip));
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x100000001B3;
  }
  EXPECT_EQ(hash, 1643045907662805376U);
}

// All joints of a hand on a path that turns, with noise: positions, axes and velocities.
TEST_F(MockPlate, BytesOfAPathAreThoseOfEveryHost) {
  ASSERT_XR(XR_SUCCESS, xrDestroySession(session));
  ASSERT_XR(XR_SUCCESS, functions->apply_script(instance, R"({"tracker": {"noise_mm": 1.2},
      "hands": {"right": {"path": [
        {"time_ms": 0, "position_m": [0.1, -0.3, -0.2], "orientation": [0.6, 0, 0, 0.8]},
        {"time_ms": 700, "position_m": [0.2, -0.4, -0.3], "orientation": [0, -0.8, 0, -0.6]},
        {"time_ms": 1100, "position_m": [0.15, -0.35, -0.3]}]}}})"));
  begin_session();
  plate_space = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL, plate_pose);
  hand = create_hand_tracker();
  std::uint64_t hash = 0xCBF29CE484222325;  // FNV-1a
  const auto add = [&](const void* data, std::size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i) hash = (hash ^ bytes[i]) * 0x100000001B3;
  };
  for (int i = 0; i < 120; ++i) {
    const Hand located = locate_hand(hand, plate_space, frame());
    for (const XrHandJointLocationEXT& joint : located.joints) add(&joint.pose, sizeof joint.pose);
    for (const XrHandJointVelocityEXT& joint : located.velocities) {
      add(&joint.linearVelocity, sizeof joint.linearVelocity);
      add(&joint.angularVelocity, sizeof joint.angularVelocity);
    }
  }
  EXPECT_EQ(hash, 6320616707752531313U);
}

TEST_F(MockPlate, OneReachWithOneSeedGivesTheSameBytes) {
  std::array<std::vector<XrVector3f>, 2> paths;
  for (auto& path : paths) {
    place_plate();
    instruct(5.0);
    while (!truth().isDone) {
      path.push_back(index_tip(frame()));
      ASSERT_XR(XR_SUCCESS,
                functions->set_plate_orientation(session, static_cast<double>(path.size() % 7) * 10.0));
    }
    TearDown();
    SetUp();
  }
  ASSERT_EQ(paths[0].size(), paths[1].size());
  EXPECT_EQ(std::memcmp(paths[0].data(), paths[1].data(), paths[0].size() * sizeof(XrVector3f)), 0);
}

}  // namespace
}  // namespace hrt::mock
