using UnrealBuildTool;

public class HapticRetargeting : ModuleRules
{
	public HapticRetargeting(ReadOnlyTargetRules Target) : base(Target)
	{
		PCHUsage = PCHUsageMode.UseExplicitOrSharedPCHs;
		PublicDependencyModuleNames.AddRange(new string[] { "Core", "CoreUObject", "Engine", "HapticRetargetingLibrary" });
		PrivateDependencyModuleNames.Add("Projects");
	}
}
