#include <gtest/gtest.h>

#include "readme_example.h"

namespace {

TEST(UnrealReadme, SteersTheFingerToTheCylinder) {
  ADesk desk;
  EXPECT_EQ(desk.GetRootComponent(), desk.Plate);
  desk.BeginPlay();
  EXPECT_TRUE(desk.PrimaryActorTick.bCanEverTick);
  for (int frame = 0; frame < 220; ++frame) {
    FPlatformTime::Now = 1000 + frame / 90.0;
    desk.Tick(1 / 90.0f);
  }
  EXPECT_TRUE(desk.Plate->IsReaching());
  // The cylinder is 10 cm from the start, 5 degrees to the right.
  EXPECT_TRUE(desk.Finger->GetComponentLocation().Equals(FVector(4.96, 0.87, 0), 0.6));
  EXPECT_EQ(desk.Ridges->GetRelativeRotation().Yaw, desk.Plate->GetCommand().PlateYaw);
  desk.Plate->BeginDestroy();
}

TEST(UnrealReadme, MeasuresTheSimulatedPerson) {
  ASetUpDesk desk;
  desk.BeginPlay();
  for (int frame = 0; frame < 10000; ++frame) {
    FPlatformTime::Now = 0.011111111 * frame;
    desk.Tick(1 / 90.0f);
  }
  EXPECT_FALSE(desk.Plate->IsSettingUp());
  EXPECT_NE(FLogCategory::Lines.back().find("Tactile weight: 0.20"), std::string::npos) << FLogCategory::Lines.back();
  desk.Plate->BeginDestroy();
}

}  // namespace
