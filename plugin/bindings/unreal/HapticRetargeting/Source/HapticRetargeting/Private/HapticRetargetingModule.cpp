// Loads the plugin's libraries on Windows, where Unreal's delay-loaded DLLs are not found in the plugin's folder.

#include "HapticRetargetingModule.h"

#include "HAL/PlatformProcess.h"
#include "Interfaces/IPluginManager.h"
#include "Misc/Paths.h"
#include "Modules/ModuleManager.h"

namespace
{
bool bLibraryIsMissing = false;
}

bool HapticLibraryIsLoaded()
{
	return !bLibraryIsMissing;
}

class FHapticRetargetingModule : public IModuleInterface
{
public:
	virtual void StartupModule() override
	{
#if PLATFORM_WINDOWS
		const FString Folder = FPaths::Combine(IPluginManager::Get().FindPlugin(TEXT("HapticRetargeting"))->GetBaseDir(),
			TEXT("Source/ThirdParty/HapticRetargetingLibrary/Win64"));
		Library = FPlatformProcess::GetDllHandle(*FPaths::Combine(Folder, TEXT("haptic_retargeting.dll")));
		PlateLibrary = FPlatformProcess::GetDllHandle(*FPaths::Combine(Folder, TEXT("hrt_plate.dll")));
		bLibraryIsMissing = Library == nullptr || PlateLibrary == nullptr;
		if (bLibraryIsMissing)
		{
			UE_LOG(LogLoad, Error, TEXT("haptic_retargeting.dll and hrt_plate.dll cannot be loaded from %s: every call of Haptic Retargeting is refused. Copy both files there"), *Folder);
		}
#endif
	}

	virtual void ShutdownModule() override
	{
		for (void** Handle : {&Library, &PlateLibrary})
		{
			if (*Handle)
			{
				FPlatformProcess::FreeDllHandle(*Handle);
				*Handle = nullptr;
			}
		}
	}

private:
	void* Library = nullptr;
	void* PlateLibrary = nullptr;
};

IMPLEMENT_MODULE(FHapticRetargetingModule, HapticRetargeting)
