#pragma once

#include "CoreMinimal.h"

struct FPlatformProcess
{
	static inline std::vector<std::string> Opened;
	static inline bool Missing = false;
	static void* GetDllHandle(const TCHAR* Path)
	{
		Opened.push_back(Stub::ToUtf8(Path));
		return Missing ? nullptr : &Opened;
	}
	static void FreeDllHandle(void*) {}
};
