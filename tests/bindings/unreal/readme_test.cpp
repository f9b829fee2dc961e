// The example of the Unreal plugin's README, run.

#include <gtest/gtest.h>

#include "readme_example.h"

namespace {

TEST(UnrealReadme, TurnsThePlateAsTheFingerSlides) {
  ADesk desk;
  desk.BeginPlay();
  EXPECT_TRUE(desk.PrimaryActorTick.bCanEverTick);
  for (int frame = 0; frame <= 270; ++frame) {
    FPlatformTime::Now = 1000 + frame / 90.0;
    desk.Finger->SetWorldTransform(FTransform(FQuat(), FVector(-5 + frame / 27.0, 0, 0.2)));
    desk.Tick(1 / 90.0f);
  }
  EXPECT_TRUE(desk.Plate->IsReaching());
  EXPECT_LT(desk.Ridges->GetRelativeRotation().Yaw, -20) << "left of the cup, to send the hand right of it";
  EXPECT_EQ(desk.Ridges->GetRelativeRotation().Yaw, desk.Plate->GetCommand().PlateYaw);
  desk.Plate->BeginDestroy();
}

}  // namespace
