// Reaches of the component, and the simulated finger.
#include "HapticRetargetingComponent.h"

#include "HapticConversions.h"
#include "HapticRetargetingModule.h"

using namespace HapticConversions;

bool UHapticRetargetingComponent::BeginReach(const FHapticTarget& Real, const FHapticTarget& Virtual, double Duration)
{
	IsPlateReady();  // reads the orientation of the plate
	hrt_reach_config Config = hrt_reach_config_init();
	Config.real_target = ToTarget(Real);
	Config.virtual_target = ToTarget(Virtual);
	Config.flags = bPlateIsMeasured ? HRT_REACH_PLATE_ORIENTATION : 0;
	Config.plate_orientation_deg = Turned(MeasuredPlateYaw);
	Config.duration_s = Duration;
	if (!Configure() || !HAPTIC_CALL(hrt_reach_begin(Session, &Config)))
	{
		return false;
	}
	Command = {};
	bReaching = true;
	return true;
}

hrt_sample UHapticRetargetingComponent::FingerSample(const FVector& Location, double Time)
{
	IsPlateReady();  // reads the orientation of the plate
	hrt_sample Sample = hrt_sample_init();
	Sample.flags = HRT_SAMPLE_WORLD_POSITION | HRT_SAMPLE_PLATE_POSE | (bPlateIsMeasured ? HRT_SAMPLE_PLATE_ORIENTATION : 0);
	Sample.time_ns = ToNanoseconds(Time);
	Sample.plate_orientation_deg = Turned(MeasuredPlateYaw);
	ToMetres(Location, Sample.finger_position_m);
	PlatePose(Sample.plate_position_m, Sample.plate_rotation);
	return Sample;
}

bool UHapticRetargetingComponent::UpdateFinger(const FVector& Location, double Time)
{
	return UpdateSample(FingerSample(Location, Time));
}

bool UHapticRetargetingComponent::UpdateJoint(const FTransform& Joint, double Time)
{
	hrt_sample Sample = FingerSample(Joint.GetLocation(), Time);
	Sample.flags |= HRT_SAMPLE_JOINT_ROTATION;
	ToQuaternion(Joint.GetRotation(), Sample.joint_rotation);
	return UpdateSample(Sample);
}

bool UHapticRetargetingComponent::UpdateLost(double Time)
{
	hrt_sample Sample{};
	Sample.time_ns = ToNanoseconds(Time);
	return UpdateSample(Sample);
}

bool UHapticRetargetingComponent::UpdateSample(const hrt_sample& Filled)
{
	if (Filled.time_ns == INT64_MIN)
	{
		UE_LOG(LogHapticRetargeting, Error, TEXT("%s"), TEXT("the time of the sample is invalid; allowed: between -9e9 and 9e9 s. Pass the seconds of one clock"));
		return false;
	}
	hrt_sample Sample = Filled;
	Sample.struct_size = sizeof Sample;
	if (bSettingUp)
	{
		return Guide(Sample);
	}
	hrt_command Decided = hrt_command_init();
	if (!HAPTIC_CALL(hrt_reach_update(Session, &Sample, &Decided)))
	{
		return false;
	}
	const uint32_t Changed = (Decided.flags ^ Command.flags) & ~HRT_COMMAND_HELD;
	Command = Decided;
	if (Changed != 0)
	{
		OnFlagsChanged.Broadcast(static_cast<int32>(Decided.flags));
	}
	if ((Decided.flags & HRT_COMMAND_HELD) == 0)
	{
		TurnPlate(Decided.plate_orientation_deg);
	}
	return true;
}

bool UHapticRetargetingComponent::RetargetReach(const FHapticTarget& Real, const FHapticTarget& Virtual)
{
	return HAPTIC_CALL(hrt_reach_retarget(Session, ToTarget(Real), ToTarget(Virtual)));
}

bool UHapticRetargetingComponent::ReachTouched(const FVector& Location, double PositionSd)
{
	hrt_contact Contact = hrt_contact_init();
	Contact.flags = HRT_CONTACT_WORLD_POSITION;
	ToMetres(Location, Contact.position_m);
	Contact.sd_m = PositionSd / CentimetresPerMetre;
	return TakeContact(&Contact);
}

bool UHapticRetargetingComponent::ReachTouchedRealTarget()
{
	return TakeContact(nullptr);
}

bool UHapticRetargetingComponent::TakeContact(const hrt_contact* Contact)
{
	if (!HAPTIC_CALL(hrt_reach_touched(Session, Contact)))
	{
		return false;
	}
	if (!bReaching)
	{
		TakeFromSession();
	}
	return true;
}

bool UHapticRetargetingComponent::CancelReach()
{
	const bool bCancelled = HAPTIC_CALL(hrt_reach_cancel(Session)) && TakeLog();
	bReaching = bReaching && !bCancelled;
	return bCancelled;
}

bool UHapticRetargetingComponent::EndReach(FHapticSummary& OutSummary)
{
	hrt_reach_summary Summary = hrt_reach_summary_init();
	if (!HAPTIC_CALL(hrt_reach_end(Session, &Summary)))
	{
		return false;
	}
	bReaching = false;
	TakeFromSession();  // estimates of the user, and a contact
	TakeLog();
	OutSummary = FromSummary(Summary);
	OnReachEnded.Broadcast(OutSummary);
	return true;
}

FHapticCommand UHapticRetargetingComponent::GetCommand() const
{
	FHapticCommand None;
	None.PaperStep = -1;
	return Command.struct_size == 0 ? None : FromCommand(Command);
}

bool UHapticRetargetingComponent::BeginSimulatedFinger(const FHapticTarget& Virtual, int64 Seed)
{
	if (!Configure())
	{
		return false;
	}
	if (Person.value != 0 && Seed != PersonSeed)
	{
		hrt_person_destroy(Person);
		Person = {};
	}
	if (Person.value == 0 && !HAPTIC_CALL(hrt_person_create(nullptr, static_cast<uint64_t>(Seed), &Person)))
	{
		return false;
	}
	PersonSeed = Seed;
	return HAPTIC_CALL(hrt_person_begin(Person, Session, ToTarget(Virtual)));
}

bool UHapticRetargetingComponent::UpdateSimulatedFinger(double Time, FVector& OutLocation)
{
	hrt_sample Sample = hrt_sample_init();
	const double PlateDeg = bSettingUp ? Step.plate_orientation_deg : Command.plate_orientation_deg;
	if (!HAPTIC_CALL(hrt_person_move(Person, ToNanoseconds(Time), PlateDeg, &Sample)) || !UpdateSample(Sample))
	{
		return false;
	}
	const FVector Position = FromMetres(Sample.finger_position_m);
	const bool bInWorld = (Sample.flags & HRT_SAMPLE_WORLD_POSITION) != 0;  // a joint, in a set-up
	OutLocation = bInWorld ? Position : GetComponentTransform().TransformPosition(Position);
	return true;
}
