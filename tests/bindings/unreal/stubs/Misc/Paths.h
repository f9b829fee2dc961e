#pragma once

#include "CoreMinimal.h"

struct FPaths
{
	static FString Combine(const FString& Folder, const TCHAR* Name)
	{
		return FString((std::u16string(*Folder) + u"/" + Name).c_str());
	}
};
