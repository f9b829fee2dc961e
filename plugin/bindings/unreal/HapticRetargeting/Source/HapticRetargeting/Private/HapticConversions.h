// Conversions between Unreal's terms and those of the C interface.
//
// Unreal's axes are left-handed: X away from the user, Y right, Z up. The plate's are right-handed: x right, y up, z
// towards the user. So (x, y, z) = (Y, Z, -X) / 100, a reflection, which also reverses the axis of a rotation.
#pragma once

#include "HapticRetargetingComponent.h"
#include "HapticStructs.h"

namespace HapticConversions
{
	constexpr double CentimetresPerMetre = 100.0;
	constexpr double NanosecondsPerSecond = 1e9;

	void ToMetres(const FVector& Centimetres, double (&OutMetres)[3]);
	FVector FromMetres(const double (&Metres)[3]);
	void ToQuaternion(const FQuat& Rotation, double (&OutRotation)[4]);
	FQuat FromQuaternion(const double (&Rotation)[4]);
	int64_t ToNanoseconds(double Seconds);
	/** Converts a yaw to a direction, or a direction to a yaw; never -0. */
	inline double Turned(double Degrees) { return 0.0 - Degrees; }

	/** Returns true for a transform without scale. */
	bool IsPose(const FTransform& Transform);
	hrt_target_config ToTarget(EHapticTargetRole Role, const FString& Name);
	inline hrt_target ToTarget(const FHapticTarget& Target) { return {static_cast<uint64_t>(Target.Id)}; }
	FHapticTarget FromTarget(hrt_target Target);
}
