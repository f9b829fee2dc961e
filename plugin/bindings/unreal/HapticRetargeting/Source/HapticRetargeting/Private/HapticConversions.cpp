#include "HapticConversions.h"

#include <cmath>
#include <string>

namespace HapticConversions
{
	void ToMetres(const FVector& Centimetres, double (&OutMetres)[3])
	{
		OutMetres[0] = Centimetres.Y / CentimetresPerMetre;
		OutMetres[1] = Centimetres.Z / CentimetresPerMetre;
		OutMetres[2] = 0.0 - Centimetres.X / CentimetresPerMetre;
	}

	FVector FromMetres(const double (&Metres)[3])
	{
		return FVector(0.0 - Metres[2], Metres[0], Metres[1]) * CentimetresPerMetre;
	}

	void ToQuaternion(const FQuat& Rotation, double (&OutRotation)[4])
	{
		OutRotation[0] = 0.0 - Rotation.Y;
		OutRotation[1] = 0.0 - Rotation.Z;
		OutRotation[2] = Rotation.X;
		OutRotation[3] = Rotation.W;
	}

	FQuat FromQuaternion(const double (&Rotation)[4])
	{
		return FQuat(Rotation[2], 0.0 - Rotation[0], 0.0 - Rotation[1], Rotation[3]);
	}

	int64_t ToNanoseconds(double Seconds)
	{
		// llround is undefined for NaN, and for results that do not fit in 64 bits. INT64_MIN: the time is invalid.
		constexpr double Largest = 9e9;
		return std::abs(Seconds) < Largest ? static_cast<int64_t>(std::llround(Seconds * NanosecondsPerSecond)) : INT64_MIN;
	}

	bool IsPose(const FTransform& Transform)
	{
		return Transform.GetScale3D().Equals(FVector(1.0, 1.0, 1.0), 1e-3);
	}

	hrt_target_config ToTarget(EHapticTargetRole Role, const FString& Name)
	{
		hrt_target_config Config = hrt_target_config_init();
		Config.role = static_cast<uint32_t>(Role);
		// A name that does not fit has no terminating zero, which the plugin refuses.
		std::string(TCHAR_TO_UTF8(*Name)).copy(Config.name, sizeof Config.name);
		return Config;
	}

	FHapticTarget FromTarget(hrt_target Target)
	{
		FHapticTarget Result;
		Result.Id = static_cast<int64>(Target.value);
		return Result;
	}
}
