// Where the component's plate is, and the skin beside a tracked joint, from touches.
#include "HapticRetargetingComponent.h"

#include "HapticConversions.h"
#include "HapticRetargetingModule.h"

#include <vector>

using namespace HapticConversions;

bool UHapticRetargetingComponent::FitRegistration(const TArray<FHapticMarkTouch>& Touches, FHapticRegistration& OutRegistration,
	FString& OutAdvice)
{
	std::vector<hrt_mark_touch> Marks;
	for (const FHapticMarkTouch& Touch : Touches)
	{
		Marks.push_back(ToMarkTouch(Touch));
	}
	hrt_registration Fitted = hrt_registration_init();
	if (!HAPTIC_CALL(hrt_registration_fit(nullptr, Marks.data(), Marks.size(), 0, nullptr, &Fitted)))
	{
		return false;
	}
	Registration = Fitted;
	OutRegistration = FromRegistration(Fitted);
	OutAdvice = UTF8_TO_TCHAR(hrt_registration_advice(Fitted.verdict));
	return true;
}

bool UHapticRetargetingComponent::ApplyRegistration(double Time)
{
	if (!HasResult(Registration.struct_size, TEXT("no registration is fitted; call FitRegistration first")) || !Configure() ||
		!HAPTIC_CALL(hrt_registration_apply(Session, &Registration, ToNanoseconds(Time))))
	{
		return false;
	}
	MoveToPlate();
	return true;
}

bool UHapticRetargetingComponent::ConfirmRegistration(const FHapticMarkTouch& Touch, double Time, FHapticTouchCheck& OutCheck)
{
	const hrt_mark_touch Mark = ToMarkTouch(Touch);
	hrt_touch_check Check = hrt_touch_check_init();
	if (!HasResult(Registration.struct_size, TEXT("no registration is fitted; call FitRegistration first")) || !Configure() ||
		!HAPTIC_CALL(hrt_registration_confirm(Session, &Registration, &Mark, ToNanoseconds(Time), &Check)))
	{
		return false;
	}
	TakeFromSession();
	OutCheck = FromTouchCheck(Check);
	return true;
}

bool UHapticRetargetingComponent::FitFingertip(const TArray<FTransform>& Joints, FHapticFingertip& OutFingertip)
{
	std::vector<hrt_joint_touch> Touches;
	for (const FTransform& Joint : Joints)
	{
		Touches.push_back(ToJointTouch(Joint));
	}
	hrt_fingertip Fitted = hrt_fingertip_init();
	if (!HAPTIC_CALL(hrt_fingertip_fit(nullptr, Touches.data(), Touches.size(), &Fitted)))
	{
		return false;
	}
	Fingertip = Fitted;
	OutFingertip = FromFingertip(Fitted);
	return true;
}

bool UHapticRetargetingComponent::PlaceFingertip(const FTransform& Joint, FVector& OutLocation) const
{
	const hrt_joint_touch Touch = ToJointTouch(Joint);
	hrt_sample Sample = hrt_sample_init();
	if (!HasResult(Fingertip.struct_size, TEXT("no fingertip is fitted; call FitFingertip first")) ||
		!HAPTIC_CALL(hrt_fingertip_place(&Fingertip, &Touch, &Sample)))
	{
		return false;
	}
	OutLocation = FromMetres(Sample.finger_position_m);
	return true;
}
