// A reach of the component: samples in, commands out.
#include "HapticRetargetingComponent.h"

#include "HapticConversions.h"
#include "HapticRetargetingModule.h"

using namespace HapticConversions;

namespace
{
	hrt_sample WithPlate(hrt_sample Sample, double PlateYaw)
	{
		Sample.flags |= HRT_SAMPLE_PLATE_ORIENTATION;
		Sample.plate_orientation_deg = Turned(PlateYaw);
		return Sample;
	}
}

bool UHapticRetargetingComponent::BeginReach(const FHapticTarget& Real, const FHapticTarget& Virtual)
{
	if (!HasLibrary())
	{
		return false;
	}
	hrt_reach_config Config = hrt_reach_config_init();
	Config.real_target = ToTarget(Real);
	Config.virtual_target = ToTarget(Virtual);
	return Begin(Config);
}

bool UHapticRetargetingComponent::BeginReachAt(const FHapticTarget& Real, const FHapticTarget& Virtual, double PlateYaw,
	double Duration)
{
	if (!HasLibrary())
	{
		return false;
	}
	hrt_reach_config Config = hrt_reach_config_init();
	Config.real_target = ToTarget(Real);
	Config.virtual_target = ToTarget(Virtual);
	Config.flags = HRT_REACH_PLATE_ORIENTATION;
	Config.plate_orientation_deg = Turned(PlateYaw);
	Config.duration_s = Duration;
	return Begin(Config);
}

bool UHapticRetargetingComponent::Begin(const hrt_reach_config& Config)
{
	if (!Configure() || !HAPTIC_CALL(hrt_reach_begin(Session, &Config)))
	{
		return false;
	}
	Command = {};
	bReaching = true;
	return true;
}

hrt_sample UHapticRetargetingComponent::FingerSample(const FVector& Location, double Time) const
{
	hrt_sample Sample = hrt_sample_init();
	Sample.flags = HRT_SAMPLE_WORLD_POSITION | HRT_SAMPLE_PLATE_POSE;
	Sample.time_ns = ToNanoseconds(Time);
	ToMetres(Location, Sample.finger_position_m);
	PlatePose(Sample.plate_position_m, Sample.plate_rotation);
	return Sample;
}

bool UHapticRetargetingComponent::UpdateFinger(const FVector& Location, double Time)
{
	return UpdateSample(FingerSample(Location, Time));
}

bool UHapticRetargetingComponent::UpdateFingerAndPlate(const FVector& Location, double PlateYaw, double Time)
{
	return UpdateSample(WithPlate(FingerSample(Location, Time), PlateYaw));
}

hrt_sample UHapticRetargetingComponent::JointSample(const FTransform& Joint, double Time) const
{
	hrt_sample Sample = FingerSample(Joint.GetLocation(), Time);
	Sample.flags |= HRT_SAMPLE_JOINT_ROTATION;
	ToQuaternion(Joint.GetRotation(), Sample.joint_rotation);
	return Sample;
}

bool UHapticRetargetingComponent::UpdateJoint(const FTransform& Joint, double Time)
{
	return UpdateSample(JointSample(Joint, Time));
}

bool UHapticRetargetingComponent::UpdateJointAndPlate(const FTransform& Joint, double PlateYaw, double Time)
{
	return UpdateSample(WithPlate(JointSample(Joint, Time), PlateYaw));
}

bool UHapticRetargetingComponent::UpdateLost(double Time)
{
	hrt_sample Sample{};
	Sample.time_ns = ToNanoseconds(Time);
	return UpdateSample(Sample);
}

bool UHapticRetargetingComponent::UpdateSample(const hrt_sample& Filled)
{
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
		OnPlateCommanded.Broadcast(Turned(Decided.plate_orientation_deg));
	}
	return true;
}

bool UHapticRetargetingComponent::RetargetReach(const FHapticTarget& Real, const FHapticTarget& Virtual)
{
	return HAPTIC_CALL(hrt_reach_retarget(Session, ToTarget(Real), ToTarget(Virtual)));
}

bool UHapticRetargetingComponent::CancelReach()
{
	if (!HAPTIC_CALL(hrt_reach_cancel(Session)))
	{
		return false;
	}
	bReaching = false;
	return true;
}

bool UHapticRetargetingComponent::EndReach(FHapticSummary& OutSummary)
{
	hrt_reach_summary Summary = hrt_reach_summary_init();
	if (!HAPTIC_CALL(hrt_reach_end(Session, &Summary)))
	{
		return false;
	}
	bReaching = false;
	if (Configured.adaptation == HRT_ADAPTATION_CARRIED)
	{
		TakeFromSession();
	}
	OutSummary = FromSummary(Summary);
	OnReachEnded.Broadcast(OutSummary);
	return true;
}

FHapticCommand UHapticRetargetingComponent::GetCommand() const
{
	FHapticCommand None;
	None.Step = -1;
	return Command.struct_size == 0 ? None : FromCommand(Command);
}

bool UHapticRetargetingComponent::BeginSimulatedFinger(const FHapticTarget& Virtual, int64 Seed)
{
	hrt_person Created{};
	if (!Configure() || !HAPTIC_CALL(hrt_person_create(nullptr, static_cast<uint64_t>(Seed), &Created)))
	{
		return false;
	}
	if (!HAPTIC_CALL(hrt_person_begin(Created, Session, ToTarget(Virtual))))
	{
		hrt_person_destroy(Created);
		return false;
	}
	if (Person.value != 0)
	{
		hrt_person_destroy(Person);
	}
	Person = Created;
	return true;
}

bool UHapticRetargetingComponent::UpdateSimulatedFinger(double Time, FVector& OutLocation)
{
	hrt_sample Sample = hrt_sample_init();
	const double PlateDeg = bSettingUp ? Step.plate_orientation_deg : Command.plate_orientation_deg;
	if (!HAPTIC_CALL(hrt_person_move(Person, ToNanoseconds(Time), PlateDeg, &Sample)) || !UpdateSample(Sample))
	{
		return false;
	}
	OutLocation = GetComponentTransform().TransformPosition(FromMetres(Sample.finger_position_m));
	return true;
}
