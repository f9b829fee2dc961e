// Runs the plugin's build rules for each platform, and checks that the files that they name exist in the plugin's folder.
//   Check.exe PLUGIN_FOLDER
using System;
using System.IO;
using System.Linq;
using UnrealBuildTool;

static class Check
{
	static void Expect(bool Right, string What)
	{
		if (!Right)
		{
			throw new InvalidDataException(What);
		}
	}

	static ReadOnlyTargetRules For(UnrealTargetPlatform Platform)
	{
		return new ReadOnlyTargetRules { Platform = Platform };
	}

	static void Main(string[] Arguments)
	{
		ModuleRules.Folder = Path.Combine(Arguments[0], "Source/ThirdParty/HapticRetargetingLibrary");
		var Linux = new HapticRetargetingLibrary(For(UnrealTargetPlatform.Linux));
		var Windows = new HapticRetargetingLibrary(For(UnrealTargetPlatform.Win64));
		Expect(Linux.Type == ModuleRules.ModuleType.External, "an external module");
		string Header = Path.Combine(Linux.PublicSystemIncludePaths.Single(), "haptic_retargeting/haptic_retargeting.h");
		foreach (string Named in Linux.PublicAdditionalLibraries.Concat(Linux.RuntimeDependencies.Files).Append(Header))
		{
			Expect(File.Exists(Named), Named + " exists");
		}
		string[] Dlls = { "haptic_retargeting.dll", "hrt_plate.dll" };
		string Folder = Path.Combine(Windows.ModuleDirectory, "Win64");
		Expect(Windows.RuntimeDependencies.Files.SequenceEqual(Dlls.Select(Dll => Path.Combine(Folder, Dll))), "staged from where the module loads them");
		Expect(Windows.PublicDelayLoadDLLs.SequenceEqual(Dlls), "and loaded late");
		var Module = new HapticRetargeting(For(UnrealTargetPlatform.Linux));
		Expect(Module.PublicDependencyModuleNames.Contains("HapticRetargetingLibrary"), "the module has the library");
		try
		{
			new HapticRetargetingLibrary(For(UnrealTargetPlatform.Mac));
			Expect(false, "a platform without library is refused");
		}
		catch (BuildException)
		{
		}
	}
}
