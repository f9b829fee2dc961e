// Loads the plugin's library where the linker leaves that to us, which is on Windows.

#include "HAL/PlatformProcess.h"
#include "Interfaces/IPluginManager.h"
#include "Misc/Paths.h"
#include "Modules/ModuleManager.h"

class FHapticRetargetingModule : public IModuleInterface
{
public:
	virtual void StartupModule() override
	{
#if PLATFORM_WINDOWS
		const FString Folder = FPaths::Combine(IPluginManager::Get().FindPlugin(TEXT("HapticRetargeting"))->GetBaseDir(),
			TEXT("Source/ThirdParty/HapticRetargetingLibrary/Win64"));
		Library = FPlatformProcess::GetDllHandle(*FPaths::Combine(Folder, TEXT("haptic_retargeting.dll")));
		if (!Library)
		{
			UE_LOG(LogLoad, Fatal, TEXT("haptic_retargeting.dll is not in %s"), *Folder);
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
