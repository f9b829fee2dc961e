// The calibration of the component's user.
#include "HapticRetargetingComponent.h"

#include "HapticConversions.h"
#include "HapticRetargetingModule.h"

using namespace HapticConversions;

bool UHapticRetargetingComponent::BeginCalibration(double GoalYaw)
{
	if (!HasLibrary())
	{
		return false;
	}
	hrt_calibration_config Config = hrt_calibration_config_init();
	Config.goal_direction_deg = Turned(GoalYaw);
	return CreateCalibration(Config);
}

bool UHapticRetargetingComponent::BeginCalibrationWithin(double GoalYaw, double MaxPlateAngle, double EnoughWeightWidth)
{
	if (!HasLibrary())
	{
		return false;
	}
	hrt_calibration_config Config = hrt_calibration_config_init();
	Config.goal_direction_deg = Turned(GoalYaw);
	Config.lower_plate_deg = -MaxPlateAngle;
	Config.upper_plate_deg = MaxPlateAngle;
	Config.enough_weight_width = EnoughWeightWidth;
	return CreateCalibration(Config);
}

bool UHapticRetargetingComponent::CreateCalibration(const hrt_calibration_config& Config)
{
	hrt_calibration Begun{};
	if (!Configure() || !HAPTIC_CALL(hrt_calibration_create(Session, &Config, &Begun)))
	{
		return false;
	}
	if (Calibration.value != 0)
	{
		hrt_calibration_destroy(Calibration);
	}
	Calibration = Begun;
	if (User.struct_size != 0)
	{
		UserBefore = User;
	}
	User = {};
	return true;
}

bool UHapticRetargetingComponent::GetNextAngle(double& OutPlateYaw, bool& bOutEnough)
{
	double Orientation = 0;
	uint32_t Enough = 0;
	if (!HAPTIC_CALL(hrt_calibration_next_angle(Calibration, &Orientation, &Enough)))
	{
		return false;
	}
	OutPlateYaw = Turned(Orientation);
	bOutEnough = Enough != 0;
	return true;
}

bool UHapticRetargetingComponent::BeginTrial(double PlateYaw)
{
	return HAPTIC_CALL(hrt_calibration_begin_trial(Calibration, Turned(PlateYaw)));
}

bool UHapticRetargetingComponent::AddTrialSample(const FVector& Location, double Time)
{
	const hrt_sample Sample = FingerSample(Location, Time);
	return HAPTIC_CALL(hrt_calibration_add_sample(Calibration, &Sample));
}

bool UHapticRetargetingComponent::AddTrialSampleAndPlate(const FVector& Location, double PlateYaw, double Time)
{
	const hrt_sample Sample = FingerAndPlateSample(Location, PlateYaw, Time);
	return HAPTIC_CALL(hrt_calibration_add_sample(Calibration, &Sample));
}

bool UHapticRetargetingComponent::EndTrial()
{
	return HAPTIC_CALL(hrt_calibration_end_trial(Calibration));
}

bool UHapticRetargetingComponent::CancelTrial()
{
	return HAPTIC_CALL(hrt_calibration_cancel_trial(Calibration));
}

bool UHapticRetargetingComponent::SolveCalibration(FHapticCalibration& OutCalibration)
{
	hrt_calibration_result Solved = hrt_calibration_result_init();
	if (!HAPTIC_CALL(hrt_calibration_solve(Calibration, &Solved)))
	{
		return false;
	}
	User = Solved;
	OutCalibration = FromCalibration(User);
	return true;
}

bool UHapticRetargetingComponent::GetSlide(int32 Number, FHapticSlide& OutSlide)
{
	hrt_calibration_slide Slide = hrt_calibration_slide_init();
	if (!HAPTIC_CALL(hrt_calibration_get_residual(Calibration, static_cast<uint32_t>(Number), &Slide)))
	{
		return false;
	}
	OutSlide = FromSlide(Slide);
	return true;
}

bool UHapticRetargetingComponent::ApplyCalibration()
{
	if (!HasResult(User.struct_size, TEXT("no calibration is solved; call SolveCalibration first")) || !Configure() || !HAPTIC_CALL(hrt_calibration_apply(Session, &User)))
	{
		return false;
	}
	TakeFromSession();
	return true;
}

bool UHapticRetargetingComponent::EndCalibration()
{
	if (!HAPTIC_CALL(hrt_calibration_destroy(Calibration)))
	{
		return false;
	}
	Calibration = {};
	return true;
}

bool UHapticRetargetingComponent::CompareCalibrations(FHapticCalibrationComparison& OutComparison)
{
	constexpr const TCHAR* Missing = TEXT("a comparison needs two calibrations of this component that were solved");
	hrt_calibration_comparison Comparison = hrt_calibration_comparison_init();
	if (!HasResult(User.struct_size, Missing) || !HasResult(UserBefore.struct_size, Missing) ||
		!HAPTIC_CALL(hrt_calibration_compare(&UserBefore, &User, &Comparison)))
	{
		return false;
	}
	OutComparison = FromCalibrationComparison(Comparison);
	return true;
}
