// The device that turns the plate. Only ClosePlate, which OpenPlate calls, waits for it, for at most 0.5 s.
#include "HapticRetargetingComponent.h"

#include "HapticConversions.h"
#include "HapticRetargetingModule.h"

using namespace HapticConversions;

bool UHapticRetargetingComponent::OpenPlate(const FString& Name)
{
	if (!HasLibrary())
	{
		return false;
	}
	ClosePlate();
	bDeviceIsTaken = bDeviceIsRefused = false;
	const bool bOpened = hrt_plate_open(TCHAR_TO_UTF8(*Name), nullptr, &Device) == HRT_OK;
	if (!bOpened)
	{
		RefusePlate(hrt_plate_last_error());
	}
	return bOpened;
}

/** Logs only the first failure of a device, because each frame may command a plate that has failed. */
void UHapticRetargetingComponent::RefusePlate(const char* Reason)
{
	if (!bDeviceIsRefused)
	{
		UE_LOG(LogHapticRetargeting, Error, TEXT("%s"), UTF8_TO_TCHAR(Reason));
	}
	bDeviceIsRefused = true;
}

bool UHapticRetargetingComponent::IsPlateReady()
{
	hrt_plate_report Report{};
	Report.struct_size = sizeof Report;
	if (Device.value == 0 || hrt_plate_get(Device, &Report) != HRT_OK)
	{
		return false;
	}
	const bool bReady = Report.state == HRT_PLATE_STATE_READY;
	if (Report.state == HRT_PLATE_STATE_FAILED)
	{
		RefusePlate(Report.message);
	}
	bPlateIsMeasured = bReady && (Report.flags & HRT_PLATE_REPORT_ORIENTATION) != 0;
	MeasuredPlateYaw = Turned(Report.orientation_deg);
	if (bReady && !bDeviceIsTaken && !bReaching && !bSettingUp)
	{
		const hrt_session_config Before = ToConfig(Settings, GetComponentTransform(), Configured);
		hrt_session_config After = Before;
		hrt_session_config_from_plate(&After, &Report);
		TakeChanges(Before, After, Settings);
		bDeviceIsTaken = true;
	}
	return bReady;
}

void UHapticRetargetingComponent::TurnPlate(double OrientationDeg)
{
	OnPlateCommanded.Broadcast(Turned(OrientationDeg));
	if (IsPlateReady() && hrt_plate_set(Device, OrientationDeg) != HRT_OK)
	{
		RefusePlate(hrt_plate_last_error());
	}
}

void UHapticRetargetingComponent::ClosePlate()
{
	if (Device.value != 0)
	{
		hrt_plate_close(Device);
		Device = {};
		bPlateIsMeasured = false;
	}
}
