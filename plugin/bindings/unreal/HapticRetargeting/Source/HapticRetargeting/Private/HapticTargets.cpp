// Targets of the component, their gaps, and scenes.
#include "HapticRetargetingComponent.h"

#include "HapticConversions.h"
#include "HapticRetargetingModule.h"

#include <vector>

using namespace HapticConversions;

bool UHapticRetargetingComponent::Add(const hrt_target_config& Config, FHapticTarget& OutTarget)
{
	hrt_target Target{};
	if (!Configure() || !HAPTIC_CALL(hrt_target_add(Session, &Config, &Target)))
	{
		return false;
	}
	OutTarget = FromTarget(Target);
	return true;
}

bool UHapticRetargetingComponent::AddTarget(EHapticTargetRole Role, const FString& Name, double Yaw, double Distance,
	FHapticTarget& OutTarget)
{
	hrt_target_config Config = ToTarget(Role, Name);
	Config.direction_deg = Turned(Yaw);
	Config.distance_m = Distance / 100.0;
	return Add(Config, OutTarget);
}

bool UHapticRetargetingComponent::AddTargetAt(EHapticTargetRole Role, const FString& Name, const FVector& Location,
	FHapticTarget& OutTarget)
{
	hrt_target_config Config = ToTarget(Role, Name);
	Config.place = HRT_PLACE_WORLD_POSITION;
	ToMetres(Location, Config.position_m);
	return Add(Config, OutTarget);
}

bool UHapticRetargetingComponent::MoveTarget(const FHapticTarget& Target, const FVector& Location)
{
	hrt_target_config Config = hrt_target_config_init();
	if (!Configure() || !HAPTIC_CALL(hrt_target_get(Session, ToTarget(Target), &Config)))
	{
		return false;
	}
	Config.place = HRT_PLACE_WORLD_POSITION;
	ToMetres(Location, Config.position_m);
	return HAPTIC_CALL(hrt_target_set(Session, ToTarget(Target), &Config));
}

bool UHapticRetargetingComponent::RemoveTarget(const FHapticTarget& Target)
{
	return HAPTIC_CALL(hrt_target_remove(Session, ToTarget(Target)));
}

bool UHapticRetargetingComponent::GetGap(const FHapticTarget& Real, const FHapticTarget& Virtual,
	FHapticGap& OutGap)
{
	hrt_gap Gap = hrt_gap_init();
	if (!Configure() || !HAPTIC_CALL(hrt_gap_query(Session, ToTarget(Real), ToTarget(Virtual), &Gap)))
	{
		return false;
	}
	OutGap = FromGap(Gap);
	return true;
}

bool UHapticRetargetingComponent::LoadScene(const FString& Path, TArray<FHapticTarget>& OutTargets,
	TArray<FHapticSceneTarget>& OutDescriptions)
{
	hrt_scene Scene{};
	if (!Configure() || !HAPTIC_CALL(hrt_scene_load(TCHAR_TO_UTF8(*Path), nullptr, 0, &Scene)))
	{
		return false;
	}
	hrt_scene_info Info = hrt_scene_info_init();
	bool bLoaded = HAPTIC_CALL(hrt_scene_get_info(Scene, &Info));
	std::vector<hrt_target> Ids(Info.target_count);
	std::vector<hrt_scene_target> Targets(Info.target_count, hrt_scene_target_init());
	for (uint32_t i = 0; bLoaded && i < Info.target_count; ++i)
	{
		bLoaded = HAPTIC_CALL(hrt_scene_get_target(Scene, i, &Targets[i]));
	}
	bLoaded = bLoaded && HAPTIC_CALL(hrt_scene_register(Scene, Session, Ids.size(), Ids.data()));
	hrt_scene_destroy(Scene);
	if (!bLoaded)
	{
		return false;
	}
	OutTargets.Reset();
	OutDescriptions.Reset();
	for (size_t i = 0; i < Ids.size(); ++i)
	{
		OutTargets.Add(FromTarget(Ids[i]));
		OutDescriptions.Add(FromSceneTarget(Targets[i]));
	}
	TakeFromSession();
	return true;
}
