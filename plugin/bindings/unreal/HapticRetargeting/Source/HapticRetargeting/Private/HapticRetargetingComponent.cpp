#include "HapticRetargetingComponent.h"

#include "HapticConversions.h"
#include "HapticRetargetingModule.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <string>
#include <vector>

DEFINE_LOG_CATEGORY(LogHapticRetargeting);

using namespace HapticConversions;

/** Whether a call of the plugin succeeded; otherwise the log has the reason. */
bool UHapticRetargetingComponent::Succeeded(hrt_result Result) const
{
	if (Result == HRT_OK)
	{
		return true;
	}
	UE_LOG(LogHapticRetargeting, Error, TEXT("%s"), UTF8_TO_TCHAR(hrt_last_error()));
	return false;
}

/** Whether the library is there; otherwise the log has it, once. */
bool UHapticRetargetingComponent::HasLibrary() const
{
	if (HapticLibraryIsLoaded())
	{
		return true;
	}
	if (!bSaidMissing)
	{
		UE_LOG(LogHapticRetargeting, Error, TEXT("%s"), TEXT("the plugin's library is missing: see what the log says of haptic_retargeting.dll"));
	}
	bSaidMissing = true;
	return false;
}

/** A call of the plugin, not made without its library. */
#define HAPTIC_CALL(Call) (HasLibrary() && Succeeded(Call))

/** Brings the session to the settings and the component's place, between reaches. */
bool UHapticRetargetingComponent::Configure()
{
	if (!HasLibrary())
	{
		return false;
	}
	if (bReaching)
	{
		return true;
	}
	if (!IsPose(GetComponentTransform()))
	{
		UE_LOG(LogHapticRetargeting, Error, TEXT("%s"), TEXT("the component is scaled; allowed: moved and turned"));
		return false;
	}
	if (bPlacedByPlugin && !IsAtPlate())
	{
		bPlacedByPlugin = false;
		Settings.bRegistered = false;
	}
	hrt_session_config Config = ToConfig(Settings, GetComponentTransform(), Configured);
	PlatePose(Config.plate_position_m, Config.plate_rotation);
	if (Session.value == 0)
	{
		if (!HAPTIC_CALL(hrt_session_create(&Config, &Session)))
		{
			return false;
		}
	}
	else if (std::memcmp(&Config, &Configured, sizeof Config) != 0)
	{
		if (!HAPTIC_CALL(hrt_session_set_config(Session, &Config)))
		{
			return false;
		}
	}
	Configured = Config;
	return true;
}

/** Whether there is a result of an earlier call; otherwise the log has the message. */
bool UHapticRetargetingComponent::HasResult(uint32_t StructSize, const TCHAR* Message) const
{
	if (StructSize == 0)
	{
		UE_LOG(LogHapticRetargeting, Error, TEXT("%s"), Message);
		return false;
	}
	return true;
}

bool UHapticRetargetingComponent::IsAtPlate() const
{
	return bPlacedByPlugin && GetComponentTransform().Equals(PlatePlace, 0.0);
}

/** Puts the component where the session has the plate. */
void UHapticRetargetingComponent::MoveToPlate()
{
	TakeFromSession();
	SetWorldTransform(FTransform(FromQuaternion(Configured.plate_rotation), FromMetres(Configured.plate_position_m)));
	PlatePlace = GetComponentTransform();
	bPlacedByPlugin = true;
}

/** Of the component; where the plugin has placed it, the plugin's own numbers, which units and parents may round. */
void UHapticRetargetingComponent::PlatePose(double (&OutPosition)[3], double (&OutRotation)[4]) const
{
	if (IsAtPlate())
	{
		std::copy(std::begin(Configured.plate_position_m), std::end(Configured.plate_position_m), OutPosition);
		std::copy(std::begin(Configured.plate_rotation), std::end(Configured.plate_rotation), OutRotation);
		return;
	}
	const FTransform& Plate = GetComponentTransform();
	ToMetres(Plate.GetLocation(), OutPosition);
	ToQuaternion(Plate.GetRotation(), OutRotation);
}

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
	if (!HasLibrary())
	{
		return false;
	}
	hrt_target_config Config = ToTarget(Role, Name);
	Config.direction_deg = Turned(Yaw);
	Config.distance_m = Distance / 100.0;
	return Add(Config, OutTarget);
}

bool UHapticRetargetingComponent::AddTargetAt(EHapticTargetRole Role, const FString& Name, const FVector& Location,
	FHapticTarget& OutTarget)
{
	if (!HasLibrary())
	{
		return false;
	}
	hrt_target_config Config = ToTarget(Role, Name);
	Config.place = HRT_PLACE_WORLD_POSITION;
	ToMetres(Location, Config.position_m);
	return Add(Config, OutTarget);
}

bool UHapticRetargetingComponent::MoveTarget(const FHapticTarget& Target, const FVector& Location)
{
	hrt_target_config Config{};
	Config.struct_size = sizeof Config;
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

bool UHapticRetargetingComponent::GetAuthority(const FHapticTarget& Real, const FHapticTarget& Virtual,
	FHapticAuthority& OutAuthority)
{
	hrt_authority Authority{};
	Authority.struct_size = sizeof Authority;
	if (!Configure() || !HAPTIC_CALL(hrt_authority_query(Session, ToTarget(Real), ToTarget(Virtual), &Authority)))
	{
		return false;
	}
	OutAuthority = FromAuthority(Authority);
	return true;
}

bool UHapticRetargetingComponent::GetBestAuthority(const FHapticTarget& Virtual, FHapticAuthority& OutAuthority)
{
	hrt_authority Authority{};
	Authority.struct_size = sizeof Authority;
	if (!Configure() || !HAPTIC_CALL(hrt_authority_query_best(Session, ToTarget(Virtual), &Authority)))
	{
		return false;
	}
	OutAuthority = FromAuthority(Authority);
	return true;
}

bool UHapticRetargetingComponent::AssignTargets(const TArray<FHapticTarget>& Virtual, const TArray<FHapticTarget>& Real,
	bool bExclusive, TArray<FHapticAuthority>& OutAuthorities)
{
	std::vector<hrt_target> VirtualIds, RealIds;
	for (const FHapticTarget& Target : Virtual)
	{
		VirtualIds.push_back(ToTarget(Target));
	}
	for (const FHapticTarget& Target : Real)
	{
		RealIds.push_back(ToTarget(Target));
	}
	hrt_authority Sized{};
	Sized.struct_size = sizeof Sized;
	// One more than is filled, because the plugin reads the first one's size.
	std::vector<hrt_authority> Authorities(VirtualIds.size() + 1, Sized);
	const uint32_t Flags = bExclusive ? HRT_ASSIGN_EXCLUSIVE : 0u;
	if (!Configure() || !HAPTIC_CALL(hrt_target_assign(Session, VirtualIds.data(), VirtualIds.size(), RealIds.data(), RealIds.size(), Flags,
							VirtualIds.size(), Authorities.data())))
	{
		return false;
	}
	OutAuthorities.Reset();
	for (size_t i = 0; i < VirtualIds.size(); ++i)
	{
		OutAuthorities.Add(FromAuthority(Authorities[i]));
	}
	return true;
}

bool UHapticRetargetingComponent::LoadScene(const FString& Path, TArray<FHapticTarget>& OutTargets,
	TArray<FHapticSceneTarget>& OutDescriptions)
{
	hrt_scene Scene{};
	if (!Configure() || !HAPTIC_CALL(hrt_scene_load_file(TCHAR_TO_UTF8(*Path), &Scene)))
	{
		return false;
	}
	hrt_scene_info Info{};
	Info.struct_size = sizeof Info;
	bool bLoaded = HAPTIC_CALL(hrt_scene_get_info(Scene, &Info));
	std::vector<hrt_target> Ids(Info.target_count);
	std::vector<hrt_scene_target> Targets(Info.target_count);
	for (uint32_t i = 0; bLoaded && i < Info.target_count; ++i)
	{
		Targets[i].struct_size = sizeof Targets[i];
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
	MoveToPlate();
	return true;
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

hrt_sample UHapticRetargetingComponent::FingerAndPlateSample(const FVector& Location, double PlateYaw, double Time) const
{
	hrt_sample Sample = FingerSample(Location, Time);
	Sample.flags |= HRT_SAMPLE_PLATE_ORIENTATION;
	Sample.plate_orientation_deg = Turned(PlateYaw);
	return Sample;
}

hrt_sample UHapticRetargetingComponent::FingerSample(const FVector& Location, double Time) const
{
	hrt_sample Sample{};
	Sample.struct_size = sizeof Sample;
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
	return UpdateSample(FingerAndPlateSample(Location, PlateYaw, Time));
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
	hrt_command Decided{};
	Decided.struct_size = sizeof Decided;
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
	hrt_reach_summary Summary{};
	Summary.struct_size = sizeof Summary;
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

bool UHapticRetargetingComponent::BeginCalibrationWithin(double GoalYaw, double LargestPlateAngle, double EnoughWeightWidth)
{
	if (!HasLibrary())
	{
		return false;
	}
	hrt_calibration_config Config = hrt_calibration_config_init();
	Config.goal_direction_deg = Turned(GoalYaw);
	Config.lower_plate_deg = -LargestPlateAngle;
	Config.upper_plate_deg = LargestPlateAngle;
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
	hrt_calibration_result Solved{};
	Solved.struct_size = sizeof Solved;
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
	hrt_calibration_slide Slide{};
	Slide.struct_size = sizeof Slide;
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
	hrt_calibration_comparison Comparison{};
	Comparison.struct_size = sizeof Comparison;
	if (!HasResult(User.struct_size, Missing) || !HasResult(UserBefore.struct_size, Missing) ||
		!HAPTIC_CALL(hrt_calibration_compare(&UserBefore, &User, &Comparison)))
	{
		return false;
	}
	OutComparison = FromCalibrationComparison(Comparison);
	return true;
}

bool UHapticRetargetingComponent::FitRegistration(const TArray<FHapticMarkTouch>& Touches, FHapticRegistration& OutRegistration,
	FString& OutAdvice)
{
	std::vector<hrt_mark_touch> Marks;
	for (const FHapticMarkTouch& Touch : Touches)
	{
		Marks.push_back(ToMarkTouch(Touch));
	}
	hrt_registration Fitted{};
	Fitted.struct_size = sizeof Fitted;
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
	hrt_touch_check Check{};
	Check.struct_size = sizeof Check;
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
	hrt_fingertip Fitted{};
	Fitted.struct_size = sizeof Fitted;
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
	hrt_sample Sample{};
	Sample.struct_size = sizeof Sample;
	if (!HasResult(Fingertip.struct_size, TEXT("no fingertip is fitted; call FitFingertip first")) ||
		!HAPTIC_CALL(hrt_fingertip_place(&Fingertip, &Touch, &Sample)))
	{
		return false;
	}
	OutLocation = FromMetres(Sample.finger_position_m);
	return true;
}

/** Takes what the plugin has learnt of the user into the settings. */
void UHapticRetargetingComponent::TakeFromSession()
{
	const hrt_session_config Before = Configured;
	if (HAPTIC_CALL(hrt_session_get_config(Session, &Configured)))
	{
		TakeChanges(Before, Configured, Settings);
	}
}

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
	hrt_conditions Now{};
	Now.struct_size = sizeof Now;
	Now.time_s = Time;
	// A name that is too long fills its field without a zero, which the plugin refuses.
	const std::string PlateName = TCHAR_TO_UTF8(*Plate), TrackerName = TCHAR_TO_UTF8(*Tracker);
	PlateName.copy(Now.plate, sizeof Now.plate);
	TrackerName.copy(Now.tracker, sizeof Now.tracker);
	return Configure() && HAPTIC_CALL(hrt_profile_set_conditions(Session, &Now));
}

bool UHapticRetargetingComponent::GetConditions(FString& OutPlate, FString& OutTracker, int64& OutTime, bool& bOutPlateDiffers, bool& bOutTrackerDiffers)
{
	hrt_conditions Measured{};
	Measured.struct_size = sizeof Measured;
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
	hrt_recording_status Status{};
	Status.struct_size = sizeof Status;
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
	hrt_recording_status Status{};
	Status.struct_size = sizeof Status;
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

void UHapticRetargetingComponent::CloseSession()
{
	if (Calibration.value != 0)
	{
		hrt_calibration_destroy(Calibration);
		Calibration = {};
	}
	if (Session.value != 0)
	{
		hrt_session_destroy(Session);
		Session = {};
		bReaching = false;
	}
}

void UHapticRetargetingComponent::OnComponentDestroyed(bool bDestroyingHierarchy)
{
	CloseSession();
	Super::OnComponentDestroyed(bDestroyingHierarchy);
}

/** Also comes to components that were never part of a level. */
void UHapticRetargetingComponent::BeginDestroy()
{
	CloseSession();
	Super::BeginDestroy();
}
