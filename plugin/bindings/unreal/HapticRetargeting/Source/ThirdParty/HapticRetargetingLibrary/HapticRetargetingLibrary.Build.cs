// The libraries and the C headers, which plugin/bindings/unreal/CMakeLists.txt copies into this folder.

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
			foreach (string Name in new string[] { "haptic_retargeting", "hrt_plate" })
			{
				PublicAdditionalLibraries.Add(Path.Combine(Folder, Name + ".lib"));
				// The module loads the DLL from the plugin's folder, in which Windows does not search.
				PublicDelayLoadDLLs.Add(Name + ".dll");
				RuntimeDependencies.Add(Path.Combine(Folder, Name + ".dll"));
			}
		}
		else if (Target.Platform == UnrealTargetPlatform.Linux)
		{
			string Folder = Path.Combine(ModuleDirectory, "Linux");
			PublicRuntimeLibraryPaths.Add(Folder);
			foreach (string Name in new string[] { "libhaptic_retargeting.so", "libhrt_plate.so" })
			{
				PublicAdditionalLibraries.Add(Path.Combine(Folder, Name));
				RuntimeDependencies.Add(Path.Combine(Folder, Name));
			}
			// Sonames, by which the system loads the libraries.
			RuntimeDependencies.Add(Path.Combine(Folder, "libhaptic_retargeting.so.0.5"));
			RuntimeDependencies.Add(Path.Combine(Folder, "libhrt_plate.so.0.5"));
		}
		else
		{
			throw new BuildException("Haptic Retargeting has no library for " + Target.Platform + "; build for Win64 or Linux");
		}
	}
}
