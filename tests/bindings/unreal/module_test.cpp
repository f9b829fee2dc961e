#include <gtest/gtest.h>

#include <memory>

#include "HAL/PlatformProcess.h"
#include "HapticRetargetingComponent.h"
#include "Modules/ModuleManager.h"

IModuleInterface* MakeModule();

namespace {

#if PLATFORM_WINDOWS
TEST(UnrealModule, LoadsTheLibraryFromThePluginsFolder) {
  const std::unique_ptr<IModuleInterface> module(MakeModule());
  module->StartupModule();
  const std::string folder = "plugins/HapticRetargeting/Source/ThirdParty/HapticRetargetingLibrary/Win64/";
  EXPECT_EQ(FPlatformProcess::Opened,
            (std::vector{folder + "haptic_retargeting.dll", folder + "hrt_plate.dll"}));
  module->ShutdownModule();
  FPlatformProcess::Missing = true;
  module->StartupModule();
  EXPECT_NE(FLogCategory::Lines.back().find("Error: haptic_retargeting.dll and hrt_plate.dll cannot be loaded from "), std::string::npos);

  UHapticRetargetingComponent component;
  const FHapticTarget none;
  FHapticTarget target;
  FHapticSummary summary;
  const size_t logged = FLogCategory::Lines.size();
  EXPECT_FALSE(component.AddTarget(EHapticTargetRole::Real, TEXT("cylinder"), 5.0, 10.0, target));
  EXPECT_FALSE(component.BeginReach(none, none));
  EXPECT_FALSE(component.BeginSimulatedFinger(none, 1));
  EXPECT_FALSE(component.OpenPlate(TEXT("serial:COM3")));
  EXPECT_EQ(component.GetSession().value, 0u);
  for (int frame = 0; frame < 90; ++frame) EXPECT_FALSE(component.UpdateFinger({}, frame / 90.0));
  EXPECT_FALSE(component.EndReach(summary));
  EXPECT_EQ(FLogCategory::Lines.size(), logged + 1);
  EXPECT_NE(FLogCategory::Lines.back().find("the plugin's library is missing"), std::string::npos);
  component.BeginDestroy();
  FPlatformProcess::Missing = false;
  module->StartupModule();  // the other tests need the library
}
#else
TEST(UnrealModule, LeavesLoadingToTheLinker) {
  const std::unique_ptr<IModuleInterface> module(MakeModule());
  module->StartupModule();
  EXPECT_TRUE(FPlatformProcess::Opened.empty());
  module->ShutdownModule();
}
#endif

}  // namespace
