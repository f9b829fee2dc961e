// What Blueprints see of the plugin. Everything is in Unreal's terms: centimetres, seconds, and yaw, which is
// positive to the right (clockwise seen from above); the C interface has metres, nanoseconds, and directions that are
// positive to the left. Directions are measured from the plate's mid-line, its X axis, straight away from the user.
#pragma once

#include "CoreMinimal.h"
#include "HapticRetargetingTypes.generated.h"

UENUM(BlueprintType)
enum class EHapticControl : uint8
{
	ModelPredictive,
	/** None, as a baseline: the plate stays at Fixed Plate Yaw. */
	FixedPlate
};

UENUM(BlueprintType)
enum class EHapticGuidance : uint8
{
	/** In the real target's direction from the start: the controller of the paper. */
	FixedDirection,
	/** In the real target's place, at arrival: the controller for people. */
	Arrival
};

UENUM(BlueprintType)
enum class EHapticAdaptation : uint8
{
	/** The user is taken as known: Tactile Weight, Bias Yaw and Motor Variance. */
	Off,
	/** The user is learnt within each reach. */
	Reach,
	/** As Reach; and the next reach begins with what this one has learnt. */
	Carried
};

UENUM(BlueprintType)
enum class EHapticTargetRole : uint8
{
	/** What the hand is led to. */
	Real,
	/** What the user sees or hears of, and is to feel that they go to. */
	Virtual
};

UENUM(meta = (Bitflags, UseEnumValuesAsMaskValuesInEditor = "true"))
enum class EHapticCommandFlags : int32
{
	None = 0 UMETA(Hidden),
	/** Nothing new was decided. */
	Held = 1,
	/** The last step had no direction and was predicted. */
	Predicted = 2,
	/** The plate's bound or a stop holds the command. */
	Saturated = 4,
	/** The plate's speed holds the command. */
	RateLimited = 8,
	/** The real direction cannot be held. */
	Unreachable = 16,
	/** The finger is above the plate: the model waits. */
	Lifted = 32,
	/** The finger is beyond the plate's edge. */
	OffPlate = 64,
	/** The motion departs from the model: the estimates are not to be trusted. */
	Misfit = 128,
	/** The finger is going to end, or has ended, beside the real target. */
	OffTarget = 256,
	/** The finger rests within the reach. */
	Resting = 512,
	/** The solver's work was cut short. */
	Approximate = 1024,
	/** A value was not finite: a defect of the plugin. */
	Fault = 2048
};

/** A session's assumptions of user, plate and tracker. Ranges: session.h of the plugin. */
USTRUCT(BlueprintType)
struct FHapticSettings
{
	GENERATED_BODY()

	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller")
	EHapticControl Control = EHapticControl::ModelPredictive;

	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller")
	EHapticGuidance Guidance = EHapticGuidance::Arrival;

	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller")
	EHapticAdaptation Adaptation = EHapticAdaptation::Carried;

	/** The plate stays where it stands until the finger moves. Set this if the finger rests on the ridges. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller")
	bool bPlateWaits = false;

	/** Largest felt error that Arrival asks the plate for. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller", meta = (Units = "deg"))
	double MaxFeltError = 5.0;

	/** Under Arrival, the plate stays within this of the finger's direction. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller", meta = (Units = "deg"))
	double MotionBound = 75.0;

	/** Steps that the controller looks ahead. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller", meta = (ClampMin = 1, ClampMax = 50))
	int32 Horizon = 3;

	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller", meta = (Units = "s"))
	double StepPeriod = 0.1;

	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller")
	double PerceivedWeight = 1.0;

	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller")
	double ActualWeight = 1.0;

	/** Under Fixed Direction, the plate stays within this of the direction that the user goes for. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate", meta = (Units = "deg"))
	double PlateBound = 84.5;

	/** Degrees a second; 0: no limit. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate")
	double PlateMaxSpeed = 0.0;

	/** Degrees a second squared; 0: no limit. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate")
	double PlateMaxAcceleration = 0.0;

	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate", meta = (Units = "s"))
	double PlateLatency = 0.0;

	/** The plate's stops; both 0: it turns freely. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate", meta = (Units = "deg"))
	double PlateLowerStopYaw = 0.0;

	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate", meta = (Units = "deg"))
	double PlateUpperStopYaw = 0.0;

	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate", meta = (Units = "deg"))
	double FixedPlateYaw = 0.0;

	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate", meta = (Units = "cm"))
	double PlateRadius = 7.5;

	/** Higher than this above the plate the finger is lifted. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate", meta = (Units = "cm"))
	double LiftHeight = 1.5;

	/** Where reaches start, in the component's coordinates: X away from the user, Y right, Z up. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate")
	FVector StartPosition = FVector(-5.0, 0.0, 0.0);

	/** Share of touch in the direction that the user feels. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "User")
	double TactileWeight = 0.2;

	/** Standard deviation of that, for adaptation to start from. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "User")
	double TactileWeightSd = 0.05;

	/** How much further to the right than it is they take a virtual target to lie. They go there. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "User", meta = (Units = "deg"))
	double BiasYaw = 0.0;

	/** Degrees squared per step, as those below. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "User")
	double MotorVariance = 0.5;

	/** Standard deviation of that, for adaptation to start from. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "User")
	double MotorVarianceSd = 0.5;

	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "User")
	double SensoryVariance = 0.1;

	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "User")
	double InitialVariance = 0.0;

	/** White noise of each tracked coordinate, standard deviation; 0: learn it. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Tracker", meta = (Units = "cm"))
	double TrackerNoise = 0.0;

	/** From a motion to the time of its sample. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Tracker", meta = (Units = "s"))
	double TrackerLatency = 0.0;
};

/** Names a target of one component. */
USTRUCT(BlueprintType)
struct FHapticTarget
{
	GENERATED_BODY()

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int64 Id = 0;
};

/** What the plate is to do now, and why. */
USTRUCT(BlueprintType)
struct FHapticCommand
{
	GENERATED_BODY()

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting",
		meta = (Bitmask, BitmaskEnum = "/Script/HapticRetargeting.EHapticCommandFlags"))
	int32 Flags = 0;

	/** The model step, from 0; -1 before the finger moves. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int64 Step = -1;

	/** Turn the plate here. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double PlateYaw = 0.0;

	/** The finger's direction in the last step. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double FingerYaw = 0.0;

	/** The direction that the user feels, as the model predicts it. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double PerceivedYaw = 0.0;

	/** Where the finger is wanted. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double AimedYaw = 0.0;

	/** Along the plate to the real target, cm. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double DistanceToGo = 0.0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double TactileWeight = 0.0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double TactileWeightSd = 0.0;

	/** Seconds until the motion ends, as predicted. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double TimeToGo = 0.0;

	/** Felt minus intended direction now: what the user could notice. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double FeltErrorYaw = 0.0;

	/** Bearing of the place of arrival minus the real target's, as predicted. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double PredictedMissYaw = 0.0;

	/** About 2 if the model fits; Misfit from 4.5. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double NormalisedInnovation = 0.0;
};

/** What became of a reach. */
USTRUCT(BlueprintType)
struct FHapticSummary
{
	GENERATED_BODY()

	/** Unreachable, Misfit, Off Target and Fault. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting",
		meta = (Bitmask, BitmaskEnum = "/Script/HapticRetargeting.EHapticCommandFlags"))
	int32 Flags = 0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int64 Samples = 0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int64 DroppedSamples = 0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int64 Steps = 0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int64 PredictedSteps = 0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int64 SaturatedSteps = 0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int64 RateLimitedSteps = 0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double FinalYaw = 0.0;

	/** That less the real target's. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double FinalMissYaw = 0.0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double PerceivedYaw = 0.0;

	/** That less where the user went: the virtual target's and their bias. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double PerceivedErrorYaw = 0.0;

	/** cm. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double DistanceToTarget = 0.0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double TactileWeight = 0.0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double TactileWeightSd = 0.0;

	/** cm. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double TrackerNoise = 0.0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double MotorVariance = 0.0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double MotorVarianceSd = 0.0;

	/** Bearing of the last position from the start, minus the real target's. This and the following: under Arrival. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double BearingErrorYaw = 0.0;

	/** Largest size of the felt error. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double PeakFeltError = 0.0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double RmsFeltError = 0.0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double NormalisedInnovation = 0.0;

	/** What the reach says of the user: the curve of their illusion, 0 if it is linear. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double IllusionCurve = 0.0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double IllusionCurveSd = 0.0;

	/** How fast they correct the felt direction, 1/s. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double Gain = 0.0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double GainSd = 0.0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double BiasYaw = 0.0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double BiasSd = 0.0;

	/** How they curve. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double HabitYaw = 0.0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double HabitSd = 0.0;

	/** Seconds. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double Duration = 0.0;
};

/** What can be held for a pair of targets. */
USTRUCT(BlueprintType)
struct FHapticAuthority
{
	GENERATED_BODY()

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	bool bReachable = false;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticTarget RealTarget;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticTarget VirtualTarget;

	/** Where the user goes, the virtual target's direction and their bias, less the real target's. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double GapYaw = 0.0;

	/** The largest gap, either way, that can be held. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double LargestGap = 0.0;

	/** Largest Gap less the size of the gap. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double Margin = 0.0;

	/** Where the plate must stand to hold it. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double PlateYaw = 0.0;

	/** Where the finger settles. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double SettlingYaw = 0.0;

	/** Largest Gap as the paper has it. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double PaperLargestGap = 0.0;
};

/** An estimate with the ends of its 95 % interval. */
USTRUCT(BlueprintType)
struct FHapticInterval
{
	GENERATED_BODY()

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double Value = 0.0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double Lower = 0.0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double Upper = 0.0;

	/** False: the data cannot determine it. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	bool bKnown = false;
};

/** Parameters of the user, from slides over a plate at rest; the names are those of the settings. */
USTRUCT(BlueprintType)
struct FHapticCalibration
{
	GENERATED_BODY()

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int32 Trials = 0;

	/** Those with a slide of 3 cm or more, which alone count. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int32 TrialsUsed = 0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval TactileWeight;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval BiasYaw;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval MotorVariance;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval SensoryVariance;

	/** cm. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval TrackerNoise;
};
