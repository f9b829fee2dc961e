// What is kept of the component's user, and recordings.
#include "HapticRetargetingComponent.h"

#include "HapticConversions.h"
#include "HapticRetargetingModule.h"

#include <string>

using namespace HapticConversions;

bool UHapticRetargetingComponent::SaveProfile(FString& OutJson)
{
	uint64_t Length = 0;
	if (!Configure() || !HAPTIC_CALL(hrt_profile_save(Session, 0, nullptr, &Length)))
	{
		return false;
	}
	std::string Json(Length + 1, '\0');
	if (!HAPTIC_CALL(hrt_profile_save(Session, Json.size(), Json.data(), &Length)))
	{
		return false;
	}
	OutJson = UTF8_TO_TCHAR(Json.c_str());
	return true;
}

bool UHapticRetargetingComponent::LoadProfile(const FString& Json)
{
	const std::string Text = TCHAR_TO_UTF8(*Json);
	if (!Configure() || !HAPTIC_CALL(hrt_profile_load(Session, Text.data(), Text.size())))
	{
		return false;
	}
	TakeFromSession();
	return true;
}

bool UHapticRetargetingComponent::SetConditions(const FString& Plate, const FString& Tracker, int64 Time)
{
	hrt_conditions Now = hrt_conditions_init();
	Now.time_s = Time;
	// A name that is too long fills its field without a zero, which the plugin refuses.
	const std::string PlateName = TCHAR_TO_UTF8(*Plate), TrackerName = TCHAR_TO_UTF8(*Tracker);
	PlateName.copy(Now.plate, sizeof Now.plate);
	TrackerName.copy(Now.tracker, sizeof Now.tracker);
	return Configure() && HAPTIC_CALL(hrt_profile_set_conditions(Session, &Now));
}

bool UHapticRetargetingComponent::GetConditions(FString& OutPlate, FString& OutTracker, int64& OutTime, bool& bOutPlateDiffers, bool& bOutTrackerDiffers)
{
	hrt_conditions Measured = hrt_conditions_init();
	if (!Configure() || !HAPTIC_CALL(hrt_profile_get_conditions(Session, &Measured)))
	{
		return false;
	}
	OutPlate = UTF8_TO_TCHAR(Measured.plate);
	OutTracker = UTF8_TO_TCHAR(Measured.tracker);
	OutTime = Measured.time_s;
	bOutPlateDiffers = (Measured.differing & HRT_CONDITION_PLATE) != 0;
	bOutTrackerDiffers = (Measured.differing & HRT_CONDITION_TRACKER) != 0;
	return true;
}

bool UHapticRetargetingComponent::StartRecording(const FString& Path)
{
	return Configure() && HAPTIC_CALL(hrt_recording_start(Session, TCHAR_TO_UTF8(*Path)));
}

bool UHapticRetargetingComponent::GetRecordingStatus(int64& OutRowsWritten, int64& OutRowsLost)
{
	hrt_recording_status Status = hrt_recording_status_init();
	if (!HAPTIC_CALL(hrt_recording_get_status(Session, &Status)))
	{
		return false;
	}
	OutRowsWritten = static_cast<int64>(Status.rows_written);
	OutRowsLost = static_cast<int64>(Status.rows_lost);
	return true;
}

bool UHapticRetargetingComponent::StopRecording()
{
	hrt_recording_status Status = hrt_recording_status_init();
	if (!HAPTIC_CALL(hrt_recording_stop(Session, &Status)))
	{
		return false;
	}
	if (Status.rows_lost != 0)
	{
		UE_LOG(LogHapticRetargeting, Error, TEXT("%s"), TEXT("the recording lacks calls: the disk was too slow or failed"));
		return false;
	}
	return true;
}
