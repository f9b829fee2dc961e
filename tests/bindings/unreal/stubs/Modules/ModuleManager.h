#pragma once

#include "CoreMinimal.h"

class IModuleInterface
{
public:
	virtual ~IModuleInterface() = default;
	virtual void StartupModule() {}
	virtual void ShutdownModule() {}
};

inline const FLogCategory LogLoad{"LogLoad"};

/** The module's only way out of its file: the test makes one. */
#define IMPLEMENT_MODULE(Class, Module) \
	IModuleInterface* MakeModule();     \
	IModuleInterface* MakeModule() { return new Class; }
