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

	static HapticRetargetingLibrary Rules(UnrealTargetPlatform Platform)
	{
		return new HapticRetargetingLibrary(new ReadOnlyTargetRules { Platform = Platform });
	}

	static void Main(string[] Arguments)
	{
		ModuleRules.Folder = Path.Combine(Arguments[0], "Source/ThirdParty/HapticRetargetingLibrary");
		HapticRetargetingLibrary Linux = Rules(UnrealTargetPlatform.Linux), Windows = Rules(UnrealTargetPlatform.Win64);
		Expect(Linux.Type == ModuleRules.ModuleType.External, "an external module");
		string Header = Path.Combine(Linux.PublicSystemIncludePaths.Single(), "haptic_retargeting/haptic_retargeting.h");
		foreach (string Named in Linux.PublicAdditionalLibraries.Concat(Linux.RuntimeDependencies.Files).Append(Header))
		{
			Expect(File.Exists(Named), Named + " exists");
		}
		Expect(Linux.RuntimeDependencies.Files.Count == 4, "both libraries are staged by both names");

		string[] Libraries = { "haptic_retargeting", "hrt_plate" };
		Expect(Windows.PublicAdditionalLibraries.Select(Path.GetFileName).SequenceEqual(Libraries.Select(Each => Each + ".lib")), "import libraries");
		string[] Dlls = Libraries.Select(Each => Path.Combine(Windows.ModuleDirectory, "Win64", Each + ".dll")).ToArray();
		Expect(Windows.RuntimeDependencies.Files.SequenceEqual(Dlls), "staged from where the module loads them");
		Expect(Windows.PublicDelayLoadDLLs.SequenceEqual(Dlls.Select(Path.GetFileName)), "and loaded late");

		HapticRetargeting Module = new HapticRetargeting(new ReadOnlyTargetRules { Platform = UnrealTargetPlatform.Linux });
		Expect(Module.PublicDependencyModuleNames.Contains("HapticRetargetingLibrary"), "the module has the library");
		try
		{
			Rules(UnrealTargetPlatform.Mac);
			Expect(false, "a platform without library is refused");
		}
		catch (BuildException)
		{
		}
	}
}
