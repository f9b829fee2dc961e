#include "HapticRetargetingComponent.h"

#include "HapticConversions.h"
#include "HapticRetargetingModule.h"

#include <cstring>

using namespace HapticConversions;

bool UHapticRetargetingComponent::BeginSetup(int32 What)
{
	if (!Configure() || !HAPTIC_CALL(hrt_setup_begin(Session, static_cast<uint32_t>(What), nullptr)))
	{
		return false;
	}
	Step = {};
	SetupDone = 0;
	bSettingUp = true;
	return true;
}

/** Processes a sample. Broadcasts OnPlateCommanded if the plate orientation changes, and OnSetupStepped if another
 *  field of the step changes. */
bool UHapticRetargetingComponent::Guide(const hrt_sample& Sample)
{
	hrt_setup_step Now = hrt_setup_step_init();
	if (!HAPTIC_CALL(hrt_setup_update(Session, &Sample, &Now)))
	{
		return false;
	}
	hrt_setup_step Last = Step;
	const bool bTurns = Last.struct_size == 0 || Last.plate_orientation_deg != Now.plate_orientation_deg;
	Last.plate_orientation_deg = Now.plate_orientation_deg;
	Step = Now;
	if (bTurns)
	{
		TurnPlate(Now.plate_orientation_deg);
	}
	if (std::memcmp(&Last, &Now, sizeof Now) != 0)
	{
		OnSetupStepped.Broadcast(FromSetupStep(Now));
	}
	return !bSettingUp || Now.instruction != HRT_STEP_FINISH || ContinueFit();
}

bool UHapticRetargetingComponent::ContinueFit()
{
	hrt_setup_result Result = hrt_setup_result_init();
	if (!HAPTIC_CALL(hrt_setup_finish(Session, &Result)))
	{
		return false;
	}
	bSettingUp = Result.left != 0;
	if (Result.done != SetupDone || !bSettingUp)
	{
		TakeFromSession();
	}
	SetupDone = Result.done;
	if (!bSettingUp)
	{
		OnSetupFinished.Broadcast(FromSetupResult(Result));
	}
	return true;
}

bool UHapticRetargetingComponent::CancelSetup()
{
	const bool bCancelled = HAPTIC_CALL(hrt_setup_cancel(Session));
	bSettingUp = bSettingUp && !bCancelled;
	return bCancelled;
}

bool UHapticRetargetingComponent::NewPerson()
{
	const bool bForgotten = HAPTIC_CALL(hrt_profile_reset(Session));
	if (bForgotten)
	{
		TakeFromSession();
	}
	return bForgotten;
}
