#include <gtest/gtest.h>

#include <algorithm>
#include <cinttypes>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <numbers>

#include "HapticConversions.h"
#include "HapticRetargetingComponent.h"
#include "plugin/src/abi/hash.h"
#include "tests/plugin/plate/eventually.h"

namespace {

using hrt::plate::eventually;

constexpr auto kReal = EHapticTargetRole::Real;
constexpr auto kVirtual = EHapticTargetRole::Virtual;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string last_log() {
  return FLogCategory::Lines.empty() ? "" : FLogCategory::Lines.back();
}

class Component : public testing::Test {
 protected:
  void SetUp() override { FLogCategory::Lines.clear(); }
  void TearDown() override { component_.BeginDestroy(); }

  void add_pair() {
    ASSERT_TRUE(component_.AddTarget(kReal, TEXT("cylinder"), 5, 10, real_));
    ASSERT_TRUE(component_.AddTarget(kVirtual, TEXT("cup"), -5, 10, felt_));
  }

  void begin() {
    add_pair();
    ASSERT_TRUE(component_.BeginReach(real_, felt_)) << last_log();
  }

  UHapticRetargetingComponent component_;
  FHapticTarget real_, felt_;
};

FTransform somewhere() {
  const double third = 1 / std::sqrt(3.0);
  return {FQuat(FVector(third, -third, third), 2.0), FVector(120, -45, 80)};
}

TEST(UnrealSettings, AreTheLibrarysDefaults) {
  const hrt_session_config defaults = hrt_session_config_init();
  const hrt_session_config config = HapticConversions::ToConfig(FHapticSettings(), FTransform(), defaults);
  EXPECT_EQ(std::memcmp(&config, &defaults, sizeof config), 0);
}

// Units are converted, and the ends of mirrored ranges exchanged.
TEST(UnrealSettings, AreConverted) {
  FHapticSettings s;
  s.Control = EHapticControl::FixedPlate;
  s.bPlateWaits = true;
  s.StepPeriod = 0.05;
  s.PlateLowerStopYaw = -100;
  s.PlateUpperStopYaw = 110;
  s.FixedPlateYaw = 12;
  s.StartPosition = FVector(-4, 1, 0.5);
  s.TrackerNoise = 0.1;
  const hrt_session_config config = HapticConversions::ToConfig(s, somewhere(), hrt_session_config_init());
  EXPECT_EQ(config.control, static_cast<uint32_t>(HRT_CONTROL_FIXED_PLATE));
  EXPECT_EQ(config.flags, HRT_SESSION_PLATE_WAITS);
  EXPECT_EQ(config.paper.step_period_ns, 50'000'000);
  EXPECT_EQ(config.plate.lower_stop_deg, -110);
  EXPECT_EQ(config.plate.upper_stop_deg, 100);
  EXPECT_EQ(config.fixed_plate_orientation_deg, -12);
  EXPECT_DOUBLE_EQ(config.start_position_m[2], 0.04);
  EXPECT_DOUBLE_EQ(config.tracker.noise_m, 0.001);
  EXPECT_DOUBLE_EQ(config.plate.position_m[2], -1.2);
}

TEST_F(Component, HasNoStepBeforeTheFirstCommand) {
  EXPECT_EQ(component_.GetCommand().PaperStep, -1);
}

TEST_F(Component, DirectionsToTheRightArePositive) {
  FHapticTarget right, ahead;
  ASSERT_TRUE(component_.AddTargetAt(kReal, TEXT("right"), FVector(-5, 10, 2), right));
  ASSERT_TRUE(component_.AddTargetAt(kVirtual, TEXT("ahead"), FVector(5, 0, 0), ahead));
  FHapticGap gap;
  ASSERT_TRUE(component_.GetGap(right, ahead, gap));
  EXPECT_NEAR(gap.GapYaw, -90, 1e-9);
  EXPECT_FALSE(gap.bReachable);
  ASSERT_TRUE(component_.MoveTarget(ahead, FVector(5, 1, 0)));
  ASSERT_TRUE(component_.GetGap(right, ahead, gap));
  EXPECT_NEAR(gap.GapYaw, std::atan2(1.0, 10.0) * 180 / std::numbers::pi - 90, 1e-9);
}

// The same samples in the component's terms and by the C interface give the same last command.
TEST_F(Component, UsesTheMeasuredOrientation) {
  add_pair();
  const auto run = [&](const std::function<bool(const FVector&, double, double)>& update) {
    component_.bPlateIsMeasured = true;
    component_.MeasuredPlateYaw = 30;
    EXPECT_TRUE(component_.BeginReach(real_, felt_, 2)) << last_log();
    for (int frame = 0; frame <= 180; ++frame) {
      const double part = frame / 180.0;
      EXPECT_TRUE(update(FVector(-5 + 10 * part, 0.4 * part, 0.2), 30 - 70 * part, frame / 90.0)) << last_log();
    }
    const hrt_command command = component_.GetRawCommand();
    EXPECT_TRUE(component_.CancelReach());
    return command;
  };
  const hrt_command measured = run([&](const FVector& place, double plate_yaw, double time) {
    component_.MeasuredPlateYaw = plate_yaw;
    return component_.UpdateFinger(place, time);
  });
  const hrt_command raw = run([&](const FVector& place, double plate_yaw, double time) {
    hrt_sample sample{};
    sample.flags = HRT_SAMPLE_WORLD_POSITION | HRT_SAMPLE_PLATE_ORIENTATION;
    sample.time_ns = HapticConversions::ToNanoseconds(time);
    HapticConversions::ToMetres(place, sample.finger_position_m);
    sample.plate_orientation_deg = -plate_yaw;
    return component_.UpdateSample(sample);
  });
  EXPECT_EQ(std::memcmp(&measured, &raw, sizeof raw), 0);
  component_.bPlateIsMeasured = true;
  component_.MeasuredPlateYaw = kNan;
  EXPECT_FALSE(component_.BeginReach(real_, felt_, 2));
  component_.MeasuredPlateYaw = 0;
  EXPECT_FALSE(component_.BeginReach(real_, felt_, 0.01));
  EXPECT_NE(last_log().find("duration_s"), std::string::npos) << last_log();
}

/** Returns the command after a slide of 10 cm forward and 0.8 cm to the right in 3 s, on a plate with this pose. */
FHapticCommand slide_on(const FTransform& plate) {
  UHapticRetargetingComponent component;
  component.SetWorldTransform(plate);
  FHapticTarget real, felt;
  EXPECT_TRUE(component.AddTargetAt(kReal, TEXT("real"), plate.TransformPosition(FVector(5, 1, 0)), real));
  EXPECT_TRUE(
      component.AddTargetAt(kVirtual, TEXT("felt"), plate.TransformPosition(FVector(5, -0.5, 0)), felt));
  EXPECT_TRUE(component.BeginReach(real, felt));
  for (int frame = 0; frame <= 270; ++frame) {
    const double part = frame / 270.0;
    EXPECT_TRUE(component.UpdateFinger(plate.TransformPosition(FVector(-5 + 10 * part, 0.8 * part, 0.2)),
                                       frame / 90.0));
  }
  const FHapticCommand command = component.GetCommand();
  component.BeginDestroy();
  return command;
}

TEST(UnrealPlate, MayHaveAnyPose) {
  const FHapticCommand here = slide_on(FTransform());
  const FHapticCommand there = slide_on(somewhere());
  EXPECT_GT(here.BearingYaw, 3) << "a finger that goes right";
  EXPECT_LT(here.PlateYaw, -5) << "the plate turns left to deflect the hand to the right";
  EXPECT_GT(here.DistanceToGo, 0.1);
  EXPECT_LT(here.DistanceToGo, 0.5) << "centimetres";
  EXPECT_NEAR(there.BearingYaw, here.BearingYaw, 1e-6);
  EXPECT_NEAR(there.PlateYaw, here.PlateYaw, 1e-6);
  EXPECT_NEAR(there.DistanceToGo, here.DistanceToGo, 1e-6);
}

TEST_F(Component, BroadcastsCommandsFlagsAndTheEnd) {
  std::vector<double> yaws;
  std::vector<int32> flags;
  std::vector<double> misses;
  component_.OnPlateCommanded.Add([&](double yaw) { yaws.push_back(yaw); });
  component_.OnFlagsChanged.Add([&](int32 changed) { flags.push_back(changed); });
  component_.OnReachEnded.Add([&](const FHapticSummary& summary) { misses.push_back(summary.MissYaw); });
  begin();
  EXPECT_TRUE(component_.IsReaching());
  hrt_sample sample{};
  sample.flags = HRT_SAMPLE_DIRECTION;
  ASSERT_TRUE(component_.UpdateSample(sample));
  sample.time_ns = 50'000'000;
  ASSERT_TRUE(component_.UpdateSample(sample));
  EXPECT_EQ(yaws, std::vector<double>{component_.GetCommand().PlateYaw})
      << "one step, and a sample between steps";
  const size_t changed = flags.size();  // not 0: the first sample has set MISS_UNKNOWN
  ASSERT_TRUE(component_.UpdateLost(0.25));
  ASSERT_EQ(flags.size(), changed + 1);
  EXPECT_TRUE(flags.back() & static_cast<int32>(EHapticCommandFlags::Predicted));
  FHapticSummary summary;
  ASSERT_TRUE(component_.EndReach(summary));
  EXPECT_EQ(summary.Samples, 3);
  EXPECT_EQ(misses, std::vector<double>{summary.MissYaw});
  EXPECT_FALSE(component_.IsReaching());
}

TEST_F(Component, LogsTheReasonOfARefusal) {
  FHapticSummary summary;
  EXPECT_FALSE(component_.EndReach(summary));
  FHapticTarget target;
  target.Id = 7;
  component_.Settings.Horizon = -1;
  EXPECT_FALSE(component_.AddTarget(kReal, TEXT("a"), 0, 10, target));
  EXPECT_NE(last_log().find("LogHapticRetargeting: Error: hrt_session_create: horizon"), std::string::npos)
      << last_log();
  EXPECT_EQ(target.Id, 7);
  component_.Settings.Horizon = 3;
  const std::u16string max(63, u'a');
  EXPECT_FALSE(component_.AddTarget(kReal, (max + u"a").c_str(), 0, 10, target));
  EXPECT_TRUE(component_.AddTarget(kReal, max.c_str(), 0, 10, target));
  begin();
  for (const double time : {kNan, -1e300, 1e300})
    EXPECT_FALSE(component_.UpdateFinger(FVector(), time)) << time;
  EXPECT_NE(last_log().find("time"), std::string::npos) << last_log();
  EXPECT_TRUE(component_.UpdateFinger(FVector(), 2));
  ASSERT_TRUE(component_.EndReach(summary));
  component_.SetWorldTransform(FTransform(FQuat(), FVector(), FVector(2, 2, 2)));
  EXPECT_FALSE(component_.BeginReach(target, target));
  EXPECT_NE(last_log().find("scaled"), std::string::npos) << last_log();
}

TEST_F(Component, TakesTheEstimatesOfAReach) {
  component_.Settings.Adaptation = EHapticAdaptation::Carried;
  begin();
  for (int frame = 0; frame <= 270; ++frame)
    ASSERT_TRUE(component_.UpdateFinger(FVector(-5 + frame / 27.0, 0, 0.2), frame / 90.0));
  component_.Settings.PlateMaxSpeed = 123;  // applied after the reach
  FHapticSummary summary;
  ASSERT_TRUE(component_.EndReach(summary));
  EXPECT_EQ(component_.Settings.PlateMaxSpeed, 123);
  EXPECT_EQ(component_.Settings.PlateRadius, 7.5);
  // The weights differ slightly, because the setting is from a second pass of the filter over the motion.
  EXPECT_NEAR(component_.Settings.TactileWeight, summary.TactileWeight, 0.01);
  EXPECT_NE(component_.Settings.TactileWeight, 0.2);
}

// In the axes of the file, the plate is at (0.12, 0.75, -0.32) m, rotated by 20 degrees to the left.
TEST_F(Component, LoadsAScene) {
  TArray<FHapticTarget> ids;
  TArray<FHapticSceneTarget> targets;
  ASSERT_TRUE(component_.LoadScene(Stub::ToUtf16(HRT_DESK).c_str(), ids, targets)) << last_log();
  ASSERT_EQ(ids.Num(), 4);
  ASSERT_EQ(targets.Num(), 4);
  const FTransform& plate = component_.GetComponentTransform();
  EXPECT_TRUE(plate.GetLocation().Equals(FVector(32, 12, 75), 1e-9));
  EXPECT_TRUE(plate.GetRotation().Equals(FQuat(FVector(0, 0, 1), -20 * std::numbers::pi / 180), 1e-9));
  EXPECT_EQ(component_.Settings.PlateMaxSpeed, 400);
  EXPECT_EQ(Stub::ToUtf8(*targets[1].Name), "bottle");
  EXPECT_EQ(targets[1].Role, kVirtual);
  EXPECT_EQ(targets[1].ServedBy, 0);
  EXPECT_NEAR(targets[1].Yaw, -6, 1e-6);  // to the left
  EXPECT_NEAR(targets[1].Distance, 10, 1e-6);
  EXPECT_TRUE(plate.TransformPosition(targets[1].Position).Equals(targets[1].WorldPosition, 1e-6));

  ASSERT_TRUE(component_.BeginReach(ids[0], ids[1])) << last_log();
  ASSERT_TRUE(component_.CancelReach());
  EXPECT_FALSE(component_.LoadScene(Stub::ToUtf16(HRT_DESK).c_str(), ids, targets));  // the names are taken
  EXPECT_FALSE(component_.LoadScene(TEXT("/nowhere.gltf"), ids, targets));
  EXPECT_EQ(ids.Num(), 4);
}

// In the plugin's axes, the simulated plate is at (0.3, 0.75, -0.4) m, rotated by 20 degrees to the left.
TEST_F(Component, SetupMovesThePlateToItsMeasuredPose) {
  const int32 both = static_cast<int32>(HRT_SETUP_FINGERTIP | HRT_SETUP_REGISTRATION);
  EXPECT_FALSE(component_.BeginSetup(0));
  ASSERT_TRUE(component_.BeginSetup(both)) << last_log();
  FHapticSetupResult result;
  component_.OnSetupFinished.Add([&](const FHapticSetupResult& found) { result = found; });
  hrt_person person{};
  ASSERT_EQ(hrt_person_create(nullptr, 1, &person), HRT_OK);
  ASSERT_EQ(hrt_person_begin(person, component_.GetSession(), {}), HRT_OK);
  for (int64_t frame = 0; component_.IsSettingUp() && frame < 5000; ++frame) {
    hrt_sample sample = hrt_sample_init();
    ASSERT_EQ(hrt_person_move(person, frame * 11'111'111, 0, &sample), HRT_OK);
    const FTransform joint(HapticConversions::FromQuaternion(sample.joint_rotation),
                           HapticConversions::FromMetres(sample.finger_position_m));
    ASSERT_TRUE(component_.UpdateJoint(joint, 1e-9 * static_cast<double>(sample.time_ns))) << last_log();
  }
  hrt_person_destroy(person);
  EXPECT_EQ(result.Done, both);
  const FTransform& plate = component_.GetComponentTransform();
  EXPECT_TRUE(plate.GetLocation().Equals(FVector(40, 30, 75), 0.3));
  EXPECT_TRUE(plate.GetRotation().Equals(FQuat(FVector(0, 0, 1), -20 * std::numbers::pi / 180), 0.02));
  EXPECT_TRUE(component_.Settings.bRegistered);
  ASSERT_TRUE(component_.BeginSetup(static_cast<int32>(HRT_SETUP_CHECK))) << "the session keeps the pose to the last bit";
  ASSERT_TRUE(component_.CancelSetup());
  EXPECT_FALSE(component_.CancelSetup());
  EXPECT_TRUE(component_.NewPerson());
  component_.SetWorldTransform(FTransform());
  EXPECT_NE(component_.GetSession().value, 0u);
  EXPECT_FALSE(component_.Settings.bRegistered) << "moved elsewhere";
}

TEST(UnrealSetup, IntervalsAreConverted) {
  hrt_setup_result found = hrt_setup_result_init();
  found.bias_deg = {.value = 2, .lower = 1, .upper = 4, .known = 1};
  const FHapticSetupResult result = HapticConversions::FromSetupResult(found);
  EXPECT_EQ(result.BiasYaw, -2);
  EXPECT_EQ(result.BiasYawLower, -4);
  EXPECT_EQ(result.BiasYawUpper, -1);
  EXPECT_TRUE(result.bBiasYawKnown);
}

TEST_F(Component, RunsAReachOfASimulatedFinger) {
  FVector place;
  EXPECT_FALSE(component_.UpdateSimulatedFinger(0, place));
  EXPECT_NE(last_log().find("person 0 does not exist"), std::string::npos) << last_log();
  component_.SetWorldTransform(somewhere());
  add_pair();
  EXPECT_FALSE(component_.BeginSimulatedFinger(real_, 1));
  ASSERT_TRUE(component_.BeginReach(real_, felt_));
  ASSERT_TRUE(component_.BeginSimulatedFinger(felt_, 1)) << last_log();
  for (int frame = 0; frame < 220; ++frame)
    ASSERT_TRUE(component_.UpdateSimulatedFinger(frame / 90.0, place)) << last_log();
  const double yaw = 5 * std::numbers::pi / 180;
  EXPECT_TRUE(place.Equals(somewhere().TransformPosition(FVector(-5 + 10 * std::cos(yaw), 10 * std::sin(yaw), 0)), 0.6));
}

TEST_F(Component, Records) {
  const std::string path = testing::TempDir() + "/unreal_recording.csv";
  ASSERT_TRUE(component_.StartRecording(Stub::ToUtf16(path).c_str()));
  begin();
  int64 written = -1, lost = -1;
  ASSERT_TRUE(component_.GetRecordingStatus(written, lost)) << last_log();
  EXPECT_GE(written, 0);
  EXPECT_EQ(lost, 0);
  ASSERT_TRUE(component_.StopRecording()) << last_log();
  EXPECT_FALSE(component_.GetRecordingStatus(written, lost));
  std::string line;
  std::ifstream file(path);
  std::getline(file, line);
  EXPECT_EQ(line, "# haptic retargeting recording, version 4");
  EXPECT_FALSE(component_.StopRecording());
  EXPECT_FALSE(component_.StartRecording(TEXT("/nowhere/recording.csv")));
}

// A process can have 1024 sessions and 64 simulated people.
TEST(UnrealComponents, DestroyTheirSessions) {
  for (int i = 0; i < 1100; ++i) {
    UHapticRetargetingComponent component;
    FHapticTarget target;
    ASSERT_TRUE(component.AddTarget(kReal, TEXT("real"), 0, 10, target)) << last_log();
    ASSERT_TRUE(component.AddTarget(kVirtual, TEXT("felt"), 0, 10, target)) << last_log();
    ASSERT_TRUE(component.BeginSimulatedFinger(target, 1)) << last_log();
    if (i % 2)
      component.OnComponentDestroyed(false);
    else
      component.BeginDestroy();
  }
}

TEST_F(Component, DeviceFollowsTheCommands) {
  const char* device = std::getenv("HRT_PLATE_FILE");
  ASSERT_NE(device, nullptr) << "run by with_plate";
  ASSERT_TRUE(component_.OpenPlate(FString(UTF8_TO_TCHAR(device)))) << last_log();
  ASSERT_TRUE(eventually([&] { return component_.IsPlateReady(); })) << last_log();
  EXPECT_EQ(component_.Settings.PlateMaxSpeed, 123.0);
  EXPECT_EQ(component_.Settings.PlateMaxAcceleration, 5000.0);
  EXPECT_TRUE(component_.bPlateIsMeasured);
  begin();
  ASSERT_TRUE(component_.UpdateFinger(FVector(-5, 0, 0.2), 0)) << last_log();
  ASSERT_TRUE(component_.UpdateFinger(FVector(-4, 0.1, 0.2), 0.1)) << last_log();
  const double wanted = -component_.GetRawCommand().plate_orientation_deg;
  ASSERT_GT(std::abs(wanted), 1.0);
  EXPECT_TRUE(eventually([&] {  // or an equivalent orientation
    return component_.IsPlateReady() && std::abs(std::remainder(component_.MeasuredPlateYaw - wanted, 180.0)) < 0.2;
  })) << component_.MeasuredPlateYaw << " for " << wanted;
  component_.ClosePlate();
  EXPECT_FALSE(component_.bPlateIsMeasured);
  EXPECT_FALSE(component_.IsPlateReady());
}

TEST_F(Component, LogsOnceWhyTheDeviceFails) {
  EXPECT_FALSE(component_.OpenPlate(TEXT("usb:0")));
  EXPECT_NE(last_log().find("device is of kind \"usb\""), std::string::npos) << last_log();
  ASSERT_TRUE(component_.OpenPlate(TEXT("serial:/nonexistent"))) << last_log();
  EXPECT_TRUE(eventually([&] { return !component_.IsPlateReady() && FLogCategory::Lines.size() == 2; }));
  EXPECT_NE(last_log().find("Error: the plate at /nonexistent cannot be opened"), std::string::npos) << last_log();
  begin();
  EXPECT_TRUE(component_.UpdateFinger(FVector(-5, 0, 0.2), 0));
  EXPECT_EQ(FLogCategory::Lines.size(), 2u);
}

// The reach that every host runs: plugin/bindings/README.md.
TEST_F(Component, RunsTheReachOfAllHosts) {
  FHapticSettings& settings = component_.Settings;
  settings.Horizon = 20;
  settings.Guidance = EHapticGuidance::Arrival;
  settings.Adaptation = EHapticAdaptation::Reach;
  settings.PlateMaxSpeed = 200;
  settings.PlateMaxAcceleration = 20000;
  settings.PlateLatency = 0.03;
  settings.PlateLowerStopYaw = -360;
  settings.PlateUpperStopYaw = 360;
  begin();

  hrt::plugin::Hash hash;
  int64_t seed = 7;
  const auto noise = [&] { return (seed = seed * 16807 % 2147483647) % 1001 - 500; };
  for (int64_t i = 1; i <= 170; ++i) {
    const int64_t moved = std::clamp<int64_t>(i - 10, 0, 120), distance_um = moved * moved * (180 - moved) * 25 / 216;
    const bool lost = i % 40 == 7 || (i > 40 && i <= 52), lifted = i > 65 && i <= 75;
    hrt_sample sample{};
    sample.flags = HRT_SAMPLE_PLATE_ORIENTATION | (lost ? 0u : HRT_SAMPLE_PLATE_POSITION) | (lifted ? HRT_SAMPLE_LIFTED : 0u);
    sample.time_ns = 20'000'000 * i + 400 * noise();
    sample.finger_position_m[0] = static_cast<double>(distance_um * 87 / 1000 + noise()) / 1e6;
    sample.finger_position_m[1] = lifted ? 0.03 : 0.002;
    sample.finger_position_m[2] = static_cast<double>(50'000 - distance_um + noise()) / 1e6;
    sample.plate_orientation_deg = component_.GetRawCommand().plate_orientation_deg;
    if (i > 105 && i <= 108) continue;  // frames that the host drops
    ASSERT_TRUE(component_.UpdateSample(sample)) << last_log();
    add(component_.GetRawCommand(), hash);
  }
  FHapticSummary summary;
  ASSERT_TRUE(component_.EndReach(summary));

  std::string expected;
  std::ifstream(HRT_REACH_HASH) >> expected;
  char found[32];
  std::snprintf(found, sizeof found, "0x%016" PRIx64, hash.value());
  std::printf("hash %s\n", found);
  EXPECT_EQ(found, expected);
}

}  // namespace
