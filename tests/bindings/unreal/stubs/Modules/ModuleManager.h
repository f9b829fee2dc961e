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

/** Defines a function by which the test creates the module. */
#define IMPLEMENT_MODULE(Class, Module) \
	IModuleInterface* MakeModule();     \
	IModuleInterface* MakeModule() { return new Class; }
