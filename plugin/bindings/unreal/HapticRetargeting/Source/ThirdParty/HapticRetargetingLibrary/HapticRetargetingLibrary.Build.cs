// The plugin's own library and its C headers, built elsewhere.

using System.IO;
using UnrealBuildTool;

public class HapticRetargetingLibrary : ModuleRules
{
	public HapticRetargetingLibrary(ReadOnlyTargetRules Target) : base(Target)
	{
		Type = ModuleType.External;
		PublicSystemIncludePaths.Add(Path.Combine(ModuleDirectory, "include"));

		if (Target.Platform == UnrealTargetPlatform.Win64)
		{
			string Folder = Path.Combine(ModuleDirectory, "Win64");
			PublicAdditionalLibraries.Add(Path.Combine(Folder, "haptic_retargeting.lib"));
			// Loaded by the module, from where the plugin has it: Windows would not look there.
			PublicDelayLoadDLLs.Add("haptic_retargeting.dll");
			Stage(Folder, "haptic_retargeting.dll");
		}
		else if (Target.Platform == UnrealTargetPlatform.Linux)
		{
			string Folder = Path.Combine(ModuleDirectory, "Linux");
			PublicAdditionalLibraries.Add(Path.Combine(Folder, "libhaptic_retargeting.so"));
			PublicRuntimeLibraryPaths.Add(Folder);
			// Linked by the one name, loaded by the other.
			Stage(Folder, "libhaptic_retargeting.so");
			Stage(Folder, "libhaptic_retargeting.so.0");
		}
		else
		{
			throw new BuildException("Haptic Retargeting has no library for " + Target.Platform);
		}
	}

	/// Has packaged games carry the file.
	private void Stage(string Folder, string Name)
	{
		RuntimeDependencies.Add(Path.Combine(Folder, Name));
	}
}
