// The Unreal component, compiled against stubs of the engine's types; see stubs/CoreMinimal.h for what that
// shows.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cinttypes>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <random>
#include <sstream>

#include "HAL/PlatformProcess.h"
#include "HapticConversions.h"
#include "HapticRetargetingComponent.h"
#include "Modules/ModuleManager.h"

IModuleInterface* MakeModule();

namespace {

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

  void begin() {
    FHapticTarget real, felt;
    ASSERT_TRUE(component_.AddTarget(kReal, TEXT("cylinder"), 5, 10, real));
    ASSERT_TRUE(component_.AddTarget(kVirtual, TEXT("cup"), -5, 10, felt));
    ASSERT_TRUE(component_.BeginReach(real, felt)) << last_log();
  }

  UHapticRetargetingComponent component_;
};

/** Moved, and turned about no axis of its own. */
FTransform somewhere() {
  const double third = 1 / std::sqrt(3.0);
  return {FQuat(FVector(third, -third, third), 2.0), FVector(120, -45, 80)};
}

std::array<double, 3> metres(const FVector& centimetres) {
  double out[3];
  HapticConversions::ToMetres(centimetres, out);
  return {out[0], out[1], out[2]};
}

// X away from the user, Y right, Z up; and x right, y up, z towards the user.
TEST(UnrealAxes, AreTurnedIntoThePlates) {
  EXPECT_EQ(metres(FVector(100, 0, 0)), (std::array<double, 3>{0, 0, -1}));
  EXPECT_EQ(metres(FVector(0, 100, 0)), (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(metres(FVector(0, 0, 100)), (std::array<double, 3>{0, 1, 0}));
}

// A quarter turn to the right, in Unreal from X to Y, is one from -z to x about -y.
TEST(UnrealAxes, TurnRotationsTheOtherWay) {
  double rotation[4];
  HapticConversions::ToQuaternion(FQuat(FVector(0, 0, 1), std::numbers::pi / 2), rotation);
  EXPECT_DOUBLE_EQ(rotation[0], 0);
  EXPECT_DOUBLE_EQ(rotation[1], -std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(rotation[2], 0);
  EXPECT_DOUBLE_EQ(rotation[3], std::sqrt(0.5));
}

// To place a point in Unreal's world and convert it is to convert it and place it in the plugin's.
TEST(UnrealAxes, ConvertPosesAsTheyConvertPoints) {
  const FTransform plate = somewhere();
  double q[4];
  HapticConversions::ToQuaternion(plate.GetRotation(), q);
  for (const FVector& point : {FVector(1, 0, 0), FVector(0, 2, 0), FVector(0, 0, 3), FVector(-4, 5, 6)}) {
    const auto [x, y, z] = metres(point);
    // v + 2 q x (q x v + w v)
    const double tx = q[1] * z - q[2] * y + q[3] * x;
    const double ty = q[2] * x - q[0] * z + q[3] * y;
    const double tz = q[0] * y - q[1] * x + q[3] * z;
    const auto origin = metres(plate.GetLocation());
    const auto world = metres(plate.TransformPosition(point));
    EXPECT_NEAR(world[0], origin[0] + x + 2 * (q[1] * tz - q[2] * ty), 1e-12);
    EXPECT_NEAR(world[1], origin[1] + y + 2 * (q[2] * tx - q[0] * tz), 1e-12);
    EXPECT_NEAR(world[2], origin[2] + z + 2 * (q[0] * ty - q[1] * tx), 1e-12);
  }
}

TEST(UnrealSettings, AreTheLibrarysDefaults) {
  const hrt_session_config defaults = hrt_session_config_init();
  const hrt_session_config config = HapticConversions::ToConfig(FHapticSettings(), FTransform(), defaults);
  EXPECT_EQ(std::memcmp(&config, &defaults, sizeof config), 0);
}

// Each set to something else, each must show: a field that the component does not know would keep its
// default.
TEST(UnrealSettings, ReachEveryFieldOfTheConfiguration) {
  FHapticSettings s;
  s.Control = EHapticControl::FixedPlate;
  s.Guidance = EHapticGuidance::FixedDirection;
  s.Adaptation = EHapticAdaptation::Reach;
  s.bPlateWaits = true;
  s.MaxFeltError = 4;
  s.MotionBound = 60;
  s.TrackerLatency = 0.02;
  s.Horizon = 4;
  s.StepPeriod = 0.05;
  s.PerceivedWeight = s.ActualWeight = 2;
  s.PlateBound = 80;
  s.PlateMaxSpeed = 300;
  s.PlateMaxAcceleration = 5000;
  s.PlateLatency = 0.01;
  s.PlateLowerStopYaw = -100;
  s.PlateUpperStopYaw = 110;
  s.FixedPlateYaw = 12;
  s.PlateRadius = 8;
  s.LiftHeight = 2;
  s.StartPosition = FVector(-4, 1, 0.5);
  s.TactileWeight = 0.25;
  s.TactileWeightSd = 0.04;
  s.BiasYaw = 3;
  s.MotorVariance = 0.6;
  s.MotorVarianceSd = 0.4;
  s.SensoryVariance = 0.2;
  s.InitialVariance = 0.3;
  s.TrackerNoise = 0.1;
  const hrt_session_config config = HapticConversions::ToConfig(s, somewhere(), hrt_session_config_init());
  hrt_session session;
  ASSERT_EQ(hrt_session_create(&config, &session), HRT_OK) << hrt_last_error();
  hrt_session_destroy(session);
  EXPECT_EQ(config.step_period_ns, 50'000'000);
  EXPECT_EQ(config.plate_lower_stop_deg, -110);
  EXPECT_EQ(config.plate_upper_stop_deg, 100);
  EXPECT_EQ(config.fixed_plate_orientation_deg, -12);
  EXPECT_DOUBLE_EQ(config.start_position_m[2], 0.04);

  const hrt_session_config defaults = hrt_session_config_init();
  const auto same = [&](size_t offset, size_t size) {
    return std::memcmp(reinterpret_cast<const char*>(&config) + offset,
                       reinterpret_cast<const char*>(&defaults) + offset, size) == 0;
  };
  for (size_t offset = 0; offset < sizeof config; offset += 4) {
    const bool number = offset >= offsetof(hrt_session_config, perceived_weight) ||
                        offset == offsetof(hrt_session_config, step_period_ns);
    if (offset == offsetof(hrt_session_config, struct_size)) continue;
    if (offset == offsetof(hrt_session_config, person_mean)) break;  // of profiles, not of settings
    EXPECT_FALSE(same(offset, number ? 8 : 4)) << "the word at " << offset << " is as by default";
    if (number) offset += 4;
  }
}

TEST_F(Component, HasNoStepBeforeTheFirstCommand) {
  EXPECT_EQ(component_.GetCommand().Step, -1);
}

TEST_F(Component, CallsRightPositive) {
  FHapticTarget right, ahead;
  ASSERT_TRUE(component_.AddTargetAt(kReal, TEXT("right"), FVector(-5, 10, 2), right));
  ASSERT_TRUE(component_.AddTargetAt(kVirtual, TEXT("ahead"), FVector(5, 0, 0), ahead));
  FHapticAuthority authority;
  ASSERT_TRUE(component_.GetAuthority(right, ahead, authority));
  EXPECT_NEAR(authority.GapYaw, -90, 1e-9);
  EXPECT_FALSE(authority.bReachable);
  ASSERT_TRUE(component_.RemoveTarget(right));
  ASSERT_TRUE(component_.AddTarget(kReal, TEXT("near"), 3, 10, right));
  ASSERT_TRUE(component_.GetBestAuthority(ahead, authority));
  EXPECT_EQ(authority.RealTarget.Id, right.Id);
  EXPECT_NEAR(authority.GapYaw, -3, 1e-9);
  EXPECT_TRUE(authority.bReachable);
  ASSERT_TRUE(component_.MoveTarget(ahead, FVector(5, 1, 0)));
  ASSERT_TRUE(component_.GetAuthority(right, ahead, authority));
  EXPECT_NEAR(authority.GapYaw, std::atan2(1.0, 10.0) * 180 / std::numbers::pi - 3, 1e-9);
}

// The same samples through the component's own terms and through the C interface's.
TEST_F(Component, TakesAMeasuredPlate) {
  FHapticTarget real, felt;
  ASSERT_TRUE(component_.AddTarget(kReal, TEXT("real"), 5, 10, real));
  ASSERT_TRUE(component_.AddTarget(kVirtual, TEXT("felt"), -5, 10, felt));
  const auto run = [&](const std::function<bool(const FVector&, double, double)>& update) {
    EXPECT_TRUE(component_.BeginReachAt(real, felt, 30, 2)) << last_log();
    for (int frame = 0; frame <= 180; ++frame) {
      const double part = frame / 180.0;
      EXPECT_TRUE(update(FVector(-5 + 10 * part, 0.4 * part, 0.2), 30 - 70 * part, frame / 90.0)) << last_log();
    }
    const hrt_command command = component_.GetRawCommand();
    EXPECT_TRUE(component_.CancelReach());
    return command;
  };
  const hrt_command measured = run([&](const FVector& place, double plate_yaw, double time) {
    return component_.UpdateFingerAndPlate(place, plate_yaw, time);
  });
  const hrt_command raw = run([&](const FVector& place, double plate_yaw, double time) {
    hrt_sample sample{};
    sample.flags = HRT_SAMPLE_WORLD_POSITION | HRT_SAMPLE_PLATE_ORIENTATION;
    sample.time_ns = HapticConversions::ToNanoseconds(time);
    HapticConversions::ToMetres(place, sample.finger_position_m);
    sample.plate_orientation_deg = -plate_yaw;
    return component_.UpdateSample(sample);
  });
  const hrt_command without = run([&](const FVector& place, double, double time) {
    return component_.UpdateFinger(place, time);
  });
  EXPECT_EQ(std::memcmp(&measured, &raw, sizeof raw), 0);
  EXPECT_NE(measured.plate_orientation_deg, without.plate_orientation_deg);
  EXPECT_FALSE(component_.BeginReachAt(real, felt, kNan, 2));
  EXPECT_FALSE(component_.BeginReachAt(real, felt, 0, 0.01));
  EXPECT_NE(last_log().find("duration_s"), std::string::npos) << last_log();
}

/** The command after a slide that goes 0.6 mm a frame to the right, on a plate that is where it is put. */
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

TEST(UnrealPlate, MayStandAnywhere) {
  const FHapticCommand here = slide_on(FTransform());
  const FHapticCommand there = slide_on(somewhere());
  EXPECT_GT(here.FingerYaw, 3) << "a finger that goes right";
  EXPECT_LT(here.PlateYaw, -5) << "the plate turns left of what is felt to send the hand right";
  EXPECT_GT(here.DistanceToGo, 0.1);
  EXPECT_LT(here.DistanceToGo, 0.5) << "centimetres";
  EXPECT_NEAR(there.FingerYaw, here.FingerYaw, 1e-6);
  EXPECT_NEAR(there.PlateYaw, here.PlateYaw, 1e-6);
  EXPECT_NEAR(there.DistanceToGo, here.DistanceToGo, 1e-6);
}

TEST_F(Component, BroadcastsCommandsFlagsAndTheEnd) {
  std::vector<double> yaws;
  std::vector<int32> flags;
  std::vector<double> misses;
  component_.OnPlateCommanded.Add([&](double yaw) { yaws.push_back(yaw); });
  component_.OnFlagsChanged.Add([&](int32 changed) { flags.push_back(changed); });
  component_.OnReachEnded.Add([&](const FHapticSummary& summary) { misses.push_back(summary.FinalMissYaw); });
  begin();
  EXPECT_TRUE(component_.IsReaching());
  hrt_sample sample{};
  sample.flags = HRT_SAMPLE_DIRECTION;
  ASSERT_TRUE(component_.UpdateSample(sample));
  sample.time_ns = 50'000'000;
  ASSERT_TRUE(component_.UpdateSample(sample));
  EXPECT_EQ(yaws, std::vector<double>{component_.GetCommand().PlateYaw})
      << "one step, and a sample between steps";
  EXPECT_TRUE(flags.empty());
  ASSERT_TRUE(component_.UpdateLost(0.25));
  ASSERT_EQ(flags.size(), 1u);
  EXPECT_TRUE(flags[0] & static_cast<int32>(EHapticCommandFlags::Predicted));
  FHapticSummary summary;
  ASSERT_TRUE(component_.EndReach(summary));
  EXPECT_EQ(summary.Samples, 3);
  EXPECT_EQ(misses, std::vector<double>{summary.FinalMissYaw});
  EXPECT_FALSE(component_.IsReaching());
}

TEST_F(Component, RefusesAndSaysWhy) {
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
  EXPECT_FALSE(component_.AddTarget(EHapticTargetRole::None, TEXT("a"), 0, 10, target));
  EXPECT_NE(last_log().find("role"), std::string::npos) << last_log();
  const std::u16string max(63, u'a');
  EXPECT_FALSE(component_.AddTarget(kReal, (max + u"a").c_str(), 0, 10, target));
  EXPECT_TRUE(component_.AddTarget(kReal, max.c_str(), 0, 10, target));
  EXPECT_TRUE(component_.AddTarget(kReal, TEXT("\u00e9lan"), 0, 10, target));
  EXPECT_FALSE(component_.AddTarget(kReal, TEXT("far"), kNan, 10, target));
  begin();
  EXPECT_TRUE(component_.UpdateFinger(FVector(), 1));
  for (const double time : {kNan, -1e300, 1e300})
    EXPECT_FALSE(component_.UpdateFinger(FVector(), time)) << time;
  EXPECT_TRUE(component_.UpdateFinger(FVector(), 2));
  ASSERT_TRUE(component_.EndReach(summary));
  component_.SetWorldTransform(FTransform(FQuat(), FVector(), FVector(2, 2, 2)));
  EXPECT_FALSE(component_.BeginReach(target, target));
  EXPECT_NE(last_log().find("scaled"), std::string::npos) << last_log();
}

TEST_F(Component, KeepsWhatIsKnownOfTheUser) {
  component_.Settings.TactileWeight = 0.2;
  FString profile;
  ASSERT_TRUE(component_.SaveProfile(profile));
  UHapticRetargetingComponent other;
  ASSERT_TRUE(other.LoadProfile(profile));
  EXPECT_EQ(other.Settings.TactileWeight, 0.2);
  EXPECT_FALSE(other.LoadProfile(TEXT("{")));
  other.BeginDestroy();

  component_.Settings.Adaptation = EHapticAdaptation::Carried;
  begin();
  for (int frame = 0; frame <= 270; ++frame)
    ASSERT_TRUE(component_.UpdateFinger(FVector(-5 + frame / 27.0, 0, 0.2), frame / 90.0));
  component_.Settings.PlateMaxSpeed = 123;  // waits for the end of the reach
  FHapticSummary summary;
  ASSERT_TRUE(component_.EndReach(summary));
  EXPECT_EQ(component_.Settings.PlateMaxSpeed, 123);
  EXPECT_EQ(component_.Settings.PlateRadius, 7.5);
  EXPECT_EQ(component_.Settings.TactileWeight, summary.TactileWeight);
  EXPECT_NE(component_.Settings.TactileWeight, 0.2);
}

/** A slide of a user whose share of touch is 0.2 and whose bias is 2 degrees to the right, over a plate at
 * rest. At rest what they feel, 0.2 T + 0.8 P, is where they go; `noise` is what keeps any two slides apart.
 */
void slide(UHapticRetargetingComponent& component, double plate_yaw, std::mt19937& random) {
  std::normal_distribution<double> noise;
  const double bias = 2;
  double yaw = (bias - 0.2 * plate_yaw) / 0.8;
  FVector finger(-5, 0, 0.2);
  ASSERT_TRUE(component.BeginTrial(plate_yaw)) << last_log();
  for (int frame = 0; frame < 315; ++frame) {
    if (frame > 45) {
      if (frame % 9 == 0) yaw = (bias - 0.2 * plate_yaw) / 0.8 + 0.7 * noise(random);
      const double radians = yaw * std::numbers::pi / 180;
      finger = finger + FVector(std::cos(radians), std::sin(radians), 0) * (10 / 270.0);
    }
    const FVector seen = finger + FVector(noise(random), noise(random), 0) * 0.03;
    ASSERT_TRUE(component.AddTrialSample(seen, frame / 90.0)) << last_log();
  }
  ASSERT_TRUE(component.EndTrial());
}

TEST_F(Component, CalibratesAUser) {
  EXPECT_FALSE(component_.BeginTrial(0));
  ASSERT_TRUE(component_.BeginCalibration(0));
  FHapticCalibration user;
  EXPECT_FALSE(component_.SolveCalibration(user));
  EXPECT_FALSE(component_.ApplyCalibration());
  EXPECT_NE(last_log().find("no calibration is solved"), std::string::npos) << last_log();
  std::mt19937 random(1);
  for (int round = 0; round < 4; ++round)
    for (const double plate_yaw : {-60, -30, 0, 30, 60}) slide(component_, plate_yaw, random);
  ASSERT_TRUE(component_.BeginTrial(30));
  for (int frame = 0; frame < 180; ++frame)  // over a plate that turns from 30 degrees to -30
    ASSERT_TRUE(component_.AddTrialSampleAndPlate(FVector(-5 + 0.1 * std::max(frame - 60, 0), 0.01 * (frame % 3), 0.2),
                                                  std::clamp(120.0 - frame, -30.0, 30.0), frame / 90.0))
        << last_log();
  ASSERT_TRUE(component_.EndTrial());
  ASSERT_TRUE(component_.BeginTrial(0));
  ASSERT_TRUE(component_.CancelTrial());
  ASSERT_TRUE(component_.SolveCalibration(user)) << last_log();
  EXPECT_EQ(user.TrialsUsed, 20);
  EXPECT_EQ(user.SlidesTurning, 1);
  EXPECT_TRUE(user.TactileWeight.bKnown);
  EXPECT_NEAR(user.TactileWeight.Value, 0.2, 0.02);
  EXPECT_NEAR(user.BiasYaw.Value, 2, 0.5);
  EXPECT_LT(user.BiasYaw.Lower, user.BiasYaw.Value);
  EXPECT_GT(user.BiasYaw.Upper, user.BiasYaw.Value);
  EXPECT_NEAR(user.TrackerNoise.Value, 0.03, 0.01);
  double yaw = 100;
  bool enough = true;
  ASSERT_TRUE(component_.GetNextAngle(yaw, enough)) << last_log();
  EXPECT_LE(std::abs(yaw), 75);
  FHapticSlide slide;
  ASSERT_TRUE(component_.GetSlide(0, slide)) << last_log();
  EXPECT_EQ(slide.Trial, 0);
  EXPECT_NEAR(slide.PlateYaw, -60, 1e-9);
  EXPECT_NEAR(slide.Yaw - slide.FittedYaw, slide.ResidualYaw, 1e-9);
  EXPECT_FALSE(component_.GetSlide(20, slide));
  EXPECT_NE(last_log().find("slide is 20"), std::string::npos) << last_log();
  ASSERT_TRUE(component_.SetConditions(TEXT("desk 1"), TEXT("Ultraleap"), 1767225600)) << last_log();
  ASSERT_TRUE(component_.ApplyCalibration()) << last_log();
  EXPECT_EQ(component_.Settings.TactileWeight, user.TactileWeight.Value);
  EXPECT_EQ(component_.Settings.BiasYaw, user.BiasYaw.Value);
  ASSERT_TRUE(component_.SetConditions(TEXT("desk 2"), TEXT("Ultraleap"), 0)) << last_log();
  FString plate, tracker;
  int64 time = 0;
  bool plate_differs = false, tracker_differs = true;
  ASSERT_TRUE(component_.GetConditions(plate, tracker, time, plate_differs, tracker_differs)) << last_log();
  EXPECT_EQ(Stub::ToUtf8(*plate), "desk 1");
  EXPECT_EQ(time, 1767225600);
  EXPECT_TRUE(plate_differs);
  EXPECT_FALSE(tracker_differs);
  FHapticCalibrationComparison change;
  EXPECT_FALSE(component_.CompareCalibrations(change));
  EXPECT_NE(last_log().find("needs two calibrations"), std::string::npos) << last_log();
  ASSERT_TRUE(component_.BeginCalibration(0));
  for (int round = 0; round < 4; ++round)
    for (const double plate_yaw : {-60, -30, 0, 30, 60}) ::slide(component_, plate_yaw, random);
  FHapticCalibration again;
  ASSERT_TRUE(component_.SolveCalibration(again)) << last_log();
  ASSERT_TRUE(component_.CompareCalibrations(change)) << last_log();
  EXPECT_NEAR(change.TactileWeight.Value, again.TactileWeight.Value - user.TactileWeight.Value, 1e-12);
  EXPECT_NEAR(change.BiasYaw.Value, again.BiasYaw.Value - user.BiasYaw.Value, 1e-12);
  EXPECT_LT(change.BiasYaw.Lower, change.BiasYaw.Upper);
  EXPECT_TRUE(component_.EndCalibration());
  EXPECT_FALSE(component_.EndCalibration());
}

// The apparatus of the desk stands at (0.12, 0.75, -0.32) m, turned by 20 degrees to the left.
TEST_F(Component, LoadsASceneAndAssignsItsTargets) {
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

  TArray<FHapticAuthority> served;
  ASSERT_TRUE(component_.AssignTargets({ids[1], ids[2], ids[3]}, {ids[0]}, false, served)) << last_log();
  ASSERT_EQ(served.Num(), 3);
  EXPECT_EQ(served[0].RealTarget.Id, ids[0].Id);
  ASSERT_TRUE(component_.AssignTargets({ids[1], ids[2], ids[3]}, {ids[0]}, true, served)) << last_log();
  EXPECT_EQ(served[0].bReachable + served[1].bReachable + served[2].bReachable, 1);
  EXPECT_FALSE(component_.AssignTargets({}, {ids[0]}, true, served));
  EXPECT_EQ(served.Num(), 3);
  ASSERT_TRUE(component_.BeginReach(ids[0], ids[1])) << last_log();
  ASSERT_TRUE(component_.CancelReach());
  EXPECT_FALSE(component_.LoadScene(Stub::ToUtf16(HRT_DESK).c_str(), ids, targets));  // the names are taken
  EXPECT_FALSE(component_.LoadScene(TEXT("/nowhere.gltf"), ids, targets));
  EXPECT_EQ(ids.Num(), 4);
}

TEST_F(Component, IsRegisteredByTouchesOfMarks) {
  EXPECT_FALSE(component_.ApplyRegistration(0));
  EXPECT_NE(last_log().find("call FitRegistration first"), std::string::npos) << last_log();
  const FTransform plate(FQuat(FVector(0, 0, 1), 0.7), FVector(120, -45, 80));
  const FVector start(-5, 0, 0);
  TArray<FHapticMarkTouch> touches;
  FHapticRegistration found;
  FString advice;
  ASSERT_TRUE(component_.FitRegistration(touches, found, advice)) << last_log();
  EXPECT_EQ(found.Verdict, EHapticRegistrationVerdict::TooFew);
  EXPECT_GT(Stub::ToUtf8(*advice).size(), 10u);
  for (const FVector& mark : {start, FVector(-4.4, 7.6, 0), FVector(4.4, 7.6, 0), FVector(4.4, -7.6, 0), FVector(-4.4, -7.6, 0)})
    touches.Add({mark, plate.TransformPosition(mark)});
  ASSERT_TRUE(component_.FitRegistration(touches, found, advice)) << last_log();
  ASSERT_EQ(found.Verdict, EHapticRegistrationVerdict::Holds);
  EXPECT_EQ(found.LeftOut, -1);
  EXPECT_TRUE(found.PlatePosition.Equals(plate.GetLocation(), 1e-6));

  ASSERT_TRUE(component_.ApplyRegistration(5)) << last_log();
  EXPECT_TRUE(component_.GetComponentTransform().Equals(plate, 1e-6));
  EXPECT_TRUE(component_.Settings.bRegistered);
  FHapticTouchCheck check;
  ASSERT_TRUE(component_.ConfirmRegistration({start, plate.TransformPosition(start)}, 6, check)) << last_log();
  EXPECT_TRUE(check.bHolds);
  EXPECT_LT(check.Distance, 1e-6);
  EXPECT_EQ(component_.Settings.RegistrationTime, 6);
  ASSERT_TRUE(component_.ConfirmRegistration({start, FVector(0, 0, 0)}, 7, check)) << last_log();
  EXPECT_FALSE(check.bHolds);
  EXPECT_FALSE(component_.Settings.bRegistered);

  ASSERT_TRUE(component_.ApplyRegistration(8)) << last_log();
  component_.SetWorldTransform(somewhere());
  EXPECT_FALSE(component_.ConfirmRegistration({start, plate.TransformPosition(start)}, 9, check));
  EXPECT_NE(last_log().find("registration is not that of the session"), std::string::npos) << last_log();
  EXPECT_FALSE(component_.Settings.bRegistered);
}

// A joint 0.8 cm above the skin and 0.5 cm behind it, which touches one mark in several ways.
TEST_F(Component, PlacesTheSkinByItsOffsetFromTheJoint) {
  FVector skin;
  EXPECT_FALSE(component_.PlaceFingertip(FTransform(), skin));
  EXPECT_NE(last_log().find("call FitFingertip first"), std::string::npos) << last_log();
  const FVector mark(40, 30, 75), offset(0.5, 0, -0.8);
  TArray<FTransform> joints;
  for (const FQuat& turn : {FQuat(), FQuat(FVector(1, 0, 0), 0.7), FQuat(FVector(1, 0, 0), -0.6), FQuat(FVector(0, 1, 0), 0.8),
                            FQuat(FVector(0, 0, 1), 0.6), FQuat(FVector(0, 1, 0), -0.7)})
    joints.Add(FTransform(turn, mark + turn.RotateVector(offset) * -1.0));
  FHapticFingertip fingertip;
  ASSERT_TRUE(component_.FitFingertip(joints, fingertip)) << last_log();
  EXPECT_TRUE(fingertip.bKnown);
  EXPECT_TRUE(fingertip.Offset.Equals(offset, 1e-6));
  for (const FTransform& joint : joints) {
    ASSERT_TRUE(component_.PlaceFingertip(joint, skin)) << last_log();
    EXPECT_TRUE(skin.Equals(mark, 1e-6));
  }
}

TEST_F(Component, Records) {
  // Two programs of this file may run at a time.
  const std::string path = testing::TempDir() + "/unreal_recording_" + std::to_string(PLATFORM_WINDOWS) + ".csv";
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
  EXPECT_EQ(line, "# haptic retargeting recording, version 3");
  EXPECT_FALSE(component_.StopRecording());
  EXPECT_FALSE(component_.StartRecording(TEXT("/nowhere/recording.csv")));
}

// Of sessions a process has 64, of calibrations 16.
TEST(UnrealComponents, EndTheirSessions) {
  for (int i = 0; i < 200; ++i) {
    UHapticRetargetingComponent component;
    FHapticTarget target;
    ASSERT_TRUE(component.AddTarget(kReal, TEXT("real"), 0, 10, target)) << last_log();
    ASSERT_TRUE(component.BeginCalibration(0)) << last_log();
    if (i % 2)
      component.OnComponentDestroyed(false);
    else
      component.BeginDestroy();
  }
}

#if PLATFORM_WINDOWS
TEST(UnrealModule, LoadsTheLibraryFromThePluginsFolder) {
  const std::unique_ptr<IModuleInterface> module(MakeModule());
  module->StartupModule();
  ASSERT_EQ(FPlatformProcess::Opened.size(), 1u);
  EXPECT_EQ(
      FPlatformProcess::Opened[0],
      "plugins/HapticRetargeting/Source/ThirdParty/HapticRetargetingLibrary/Win64/haptic_retargeting.dll");
  module->ShutdownModule();
  FPlatformProcess::Missing = true;
  module->StartupModule();
  EXPECT_NE(last_log().find("Error: haptic_retargeting.dll is not in plugins/HapticRetargeting"), std::string::npos);

  UHapticRetargetingComponent component;
  const FHapticTarget none;
  FHapticTarget target;
  FHapticSummary summary;
  const size_t logged = FLogCategory::Lines.size();
  EXPECT_FALSE(component.AddTarget(EHapticTargetRole::Real, TEXT("cylinder"), 5.0, 10.0, target));
  EXPECT_FALSE(component.BeginReach(none, none));
  EXPECT_FALSE(component.BeginCalibration(0.0));
  EXPECT_FALSE(component.BeginCalibrationWithin(0.0, 60.0, 0.1));
  double yaw = 0;
  bool enough = false;
  EXPECT_FALSE(component.GetNextAngle(yaw, enough));
  FHapticSlide slide;
  EXPECT_FALSE(component.GetSlide(0, slide));
  int64 written = 0, lost = 0;
  EXPECT_FALSE(component.GetRecordingStatus(written, lost));
  TArray<FHapticTarget> targets;
  TArray<FHapticSceneTarget> descriptions;
  EXPECT_FALSE(component.LoadScene(TEXT("desk.gltf"), targets, descriptions));
  FHapticRegistration registration;
  FString advice;
  EXPECT_FALSE(component.FitRegistration({}, registration, advice));
  FHapticFingertip fingertip;
  EXPECT_FALSE(component.FitFingertip({}, fingertip));
  for (int frame = 0; frame < 90; ++frame) EXPECT_FALSE(component.UpdateFinger({}, frame / 90.0));
  EXPECT_FALSE(component.EndReach(summary));
  EXPECT_EQ(FLogCategory::Lines.size(), logged + 1);
  EXPECT_NE(last_log().find("the plugin's library is missing"), std::string::npos);
  component.BeginDestroy();
  FPlatformProcess::Missing = false;
  module->StartupModule();  // what the other tests need
}
#else
TEST(UnrealModule, LeavesLoadingToTheLinker) {
  const std::unique_ptr<IModuleInterface> module(MakeModule());
  module->StartupModule();
  EXPECT_TRUE(FPlatformProcess::Opened.empty());
  module->ShutdownModule();
}
#endif

uint64_t hash_word(uint64_t hash, uint64_t word) {
  for (int byte = 0; byte < 8; ++byte) hash = (hash ^ (word >> (8 * byte) & 0xff)) * 0x100000001b3u;
  return hash;
}

uint64_t hash_command(uint64_t hash, const hrt_command& command) {
  hash = hash_word(hash, command.flags);
  hash = hash_word(hash, static_cast<uint64_t>(command.step));
  for (const double number : {command.plate_orientation_deg, command.finger_direction_deg,
                              command.perceived_direction_deg, command.aimed_direction_deg,
                              command.distance_to_go_m, command.tactile_weight, command.tactile_weight_sd,
 command.time_to_go_s, command.felt_error_deg, command.predicted_miss_deg, command.normalised_innovation})
    hash = hash_word(hash, std::bit_cast<uint64_t>(number));
  return hash;
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

  std::ifstream recording(HRT_REACH);
  std::map<std::string, size_t> columns;
  uint64_t hash = 0xcbf29ce484222325u;
  for (std::string line; std::getline(recording, line);) {
    if (line.starts_with('#')) continue;
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    cells.resize(64);
    if (columns.empty())
      for (size_t i = 0; i < cells.size(); ++i) columns.emplace(cells[i], i);
    if (cells[columns.at("call")] != "update") continue;
    const auto real = [&](const char* name) { return std::strtod(cells[columns.at(name)].c_str(), nullptr); };
    hrt_sample sample{};
    sample.flags = static_cast<uint32_t>(real("sample_flags"));
    sample.time_ns = std::strtoll(cells[columns.at("time_ns")].c_str(), nullptr, 10);
    sample.finger_position_m[0] = real("sample_x_m");
    sample.finger_position_m[1] = real("sample_y_m");
    sample.finger_position_m[2] = real("sample_z_m");
    sample.plate_orientation_deg = real("measured_plate_deg");
    ASSERT_TRUE(component_.UpdateSample(sample)) << last_log();
    hash = hash_command(hash, component_.GetRawCommand());
  }
  FHapticSummary summary;
  ASSERT_TRUE(component_.EndReach(summary));

  std::string expected;
  std::ifstream(HRT_REACH_HASH) >> expected;
  char found[32];
  std::snprintf(found, sizeof found, "0x%016" PRIx64, hash);
  std::printf("hash %s\n", found);
  EXPECT_EQ(found, expected);
}

}  // namespace
