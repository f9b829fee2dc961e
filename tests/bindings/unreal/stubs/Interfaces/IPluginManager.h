#pragma once

#include "CoreMinimal.h"

#include <memory>

struct IPlugin
{
	FString GetBaseDir() const { return TEXT("plugins/HapticRetargeting"); }
};

struct IPluginManager
{
	static IPluginManager Get() { return {}; }
	std::shared_ptr<IPlugin> FindPlugin(const TCHAR*) const { return std::make_shared<IPlugin>(); }
};
