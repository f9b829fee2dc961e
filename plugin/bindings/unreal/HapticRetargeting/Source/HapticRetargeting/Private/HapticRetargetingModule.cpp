// Loads the plugin's library where the linker leaves that to us, which is on Windows.

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
		bLibraryIsMissing = Library == nullptr;
		if (bLibraryIsMissing)
		{
			UE_LOG(LogLoad, Error, TEXT("haptic_retargeting.dll is not in %s: every call of Haptic Retargeting is refused"), *Folder);
		}
#endif
	}

	virtual void ShutdownModule() override
	{
		if (Library)
		{
			FPlatformProcess::FreeDllHandle(Library);
			Library = nullptr;
		}
	}

private:
	void* Library = nullptr;
};

IMPLEMENT_MODULE(FHapticRetargetingModule, HapticRetargeting)
