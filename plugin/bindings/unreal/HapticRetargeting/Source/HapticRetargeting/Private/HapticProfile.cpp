// Profiles of the component's user, and recordings.
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
	const bool bLoaded = Configure() && HAPTIC_CALL(hrt_profile_load(Session, Text.data(), Text.size()));
	if (bLoaded)
	{
		TakeFromSession();
	}
	return bLoaded;
}

bool UHapticRetargetingComponent::StartRecording(const FString& Path)
{
	return Configure() && HAPTIC_CALL(hrt_recording_start(Session, TCHAR_TO_UTF8(*Path)));
}

bool UHapticRetargetingComponent::GetRecordingStatus(int64& OutRowsWritten, int64& OutRowsLost)
{
	hrt_recording_status Status = hrt_recording_status_init();
	const bool bRecording = HAPTIC_CALL(hrt_recording_get_status(Session, &Status));
	OutRowsWritten = static_cast<int64>(Status.rows_written);
	OutRowsLost = static_cast<int64>(Status.rows_lost);
	return bRecording;
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
		UE_LOG(LogHapticRetargeting, Error, TEXT("%s"), TEXT("the recording lacks calls, because the disk was too slow or failed: record to a faster disk"));
		return false;
	}
	return true;
}
