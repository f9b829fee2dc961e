// Stubs of the parts of UnrealBuildTool that the plugin's build rules use.

using System;
using System.Collections.Generic;

namespace UnrealBuildTool
{
	public class UnrealTargetPlatform
	{
		readonly string Name;
		UnrealTargetPlatform(string Name) { this.Name = Name; }
		public override string ToString() { return Name; }

		public static readonly UnrealTargetPlatform Win64 = new UnrealTargetPlatform("Win64");
		public static readonly UnrealTargetPlatform Linux = new UnrealTargetPlatform("Linux");
		public static readonly UnrealTargetPlatform Mac = new UnrealTargetPlatform("Mac");
	}

	public class BuildException : Exception
	{
		public BuildException(string Text) : base(Text) {}
	}

	public class ReadOnlyTargetRules
	{
		public UnrealTargetPlatform Platform;
	}

	public class FileList
	{
		public readonly List<string> Files = new List<string>();
		public void Add(string Path) { Files.Add(Path); }
	}

	public class ModuleRules
	{
		public enum ModuleType { CPlusPlus, External }
		public enum PCHUsageMode { Default, UseExplicitOrSharedPCHs }

		/// Folder of the file with the rules; set before rules are created.
		public static string Folder;
		public string ModuleDirectory { get { return Folder; } }

		public ModuleType Type;
		public PCHUsageMode PCHUsage;
		public List<string> PublicSystemIncludePaths = new List<string>();
		public List<string> PublicAdditionalLibraries = new List<string>();
		public List<string> PublicDelayLoadDLLs = new List<string>();
		public List<string> PublicRuntimeLibraryPaths = new List<string>();
		public List<string> PublicDependencyModuleNames = new List<string>();
		public List<string> PrivateDependencyModuleNames = new List<string>();
		public FileList RuntimeDependencies = new FileList();

		public ModuleRules(ReadOnlyTargetRules Target) {}
	}
}
