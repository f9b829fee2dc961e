// Written by plugin/bindings/generate from the C headers.
//
// What Blueprints see of the plugin. Everything is in Unreal's terms: centimetres, seconds, and yaw, which is
// positive to the right (clockwise seen from above); the C interface has metres, nanoseconds, and directions
// that are positive to the left. Directions are measured from the plate's mid-line, its X axis, straight away
// from the user.
#pragma once

#include "CoreMinimal.h"
#include "HapticRetargetingTypes.generated.h"

/** Families of illusion curves: the felt shift over the offset t from the motion to the ridge normal. */
UENUM(BlueprintType)
enum class EHapticIllusion : uint8
{
	/** w t. */
	Linear = 0,
	/** w t within the scale, constant beyond. */
	Saturating = 1,
	/** w 45 sin 2t. */
	Sine = 2,
	/** w scale tanh(t / scale). */
	Tanh = 3,
	/** nothing within the scale, w (|t| - scale) beyond. */
	DeadBand = 4,
	/** different slopes to the left and to the right. */
	Unequal = 5,
	/** w t - b t (t / 75)^2, the controller's model. */
	Cubic = 6,
	/** no family fits the slides. */
	None = 7
};

/** Patterns in what the fit leaves unexplained: LackOfFit. */
UENUM(meta = (Bitflags, UseEnumValuesAsMaskValuesInEditor = "true"))
enum class EHapticLackOfFitFlags : int32
{
	None = 0 UMETA(Hidden),
	/** Over the plate orientation: no curve fits. Check the plate's orientations and the goal direction. */
	Angle = 1,
	/** Over the order of the slides: the user learns or tires. Let them practise or rest, and repeat. */
	Order = 2,
	/** Along the paths: they bend as neither a habit nor the model's steering does. Ask for slower, longer and even
	 *  slides, and repeat. */
	Path = 4
};

/** What became of a slide: Verdict. */
UENUM(BlueprintType)
enum class EHapticSlide : uint8
{
	Used = 0,
	/** unlike the others: left out. */
	Outlying = 1,
	/** left out: the illusion flips along the ridges. */
	AlongRidges = 2
};

/** Values of two calibrations that differ: Differing. */
UENUM(meta = (Bitflags, UseEnumValuesAsMaskValuesInEditor = "true"))
enum class EHapticDiffersFlags : int32
{
	None = 0 UMETA(Hidden),
	TactileWeight = 1,
	MaxGap = 2,
	Bias = 4,
	Habit = 8,
	TrackerNoise = 16,
	SteeringRate = 32,
	SteeringDelay = 64
};

UENUM(meta = (Bitflags, UseEnumValuesAsMaskValuesInEditor = "true"))
enum class EHapticCommandFlags : int32
{
	None = 0 UMETA(Hidden),
	/** no new decision: the former command is repeated. */
	Held = 1,
	/** no sample in the last step; under ARRIVAL, none now. */
	Predicted = 2,
	/** the plate's bound or a stop limits the command. */
	Saturated = 4,
	/** the plate's speed limits the command. */
	RateLimited = 8,
	/** the plate cannot sustain the gap: see authority.h. */
	Unreachable = 16,
	/** the finger does not touch the plate: the model waits. */
	Lifted = 32,
	/** the finger is beyond the plate's edge. */
	OffPlate = 64,
	/** The motion departs from the model more than its noise allows: the estimates, and UNREACHABLE, are not to be
	 *  trusted. */
	Misfit = 128,
	/** The finger is going to end, or has ended, more than 1.5 degrees of bearing from the real target. */
	OffTarget = 256,
	/** the finger rests within the reach: the plate is held. */
	Resting = 512,
	/** The solver's work was cut short; the command keeps its bounds. */
	Approximate = 1024,
	/** A defect in this library: a value was not a finite number. The plate is held, and that value is 0. The log
	 *  says so once a session, when the session is next configured or destroyed. */
	Fault = 2048,
	/** The plate's registration is older or worse than the configuration allows, or there is none:
	 *  MaxRegistrationAge, MaxRegistrationSd. Touch the marks again (registration.h). The log has it at the next
	 *  call of hrt_session_set_config(), _destroy() or hrt_registration_apply(). */
	Registration = 4096
};

/** Verdict on a set of touches. hrt_registration_advice() has what to do. */
UENUM(BlueprintType)
enum class EHapticRegistrationVerdict : uint8
{
	None = 0 UMETA(Hidden),
	/** a pose explains the touches, or all of them but one. */
	Holds = 1,
	/** fewer than 3 touches. */
	TooFew = 2,
	/** the marks lie within 1 cm of a line: the plate could turn about it. */
	Degenerate = 3,
	/** no pose explains the touches, nor all of them but one. */
	Inconsistent = 4,
	/** the face looks away from up: marks were confused. */
	UpsideDown = 5
};

/** Source of the plate's commands. */
UENUM(BlueprintType)
enum class EHapticControl : uint8
{
	/** the model-predictive controller. */
	MPC = 0,
	/** a plate that does not turn, as a baseline. */
	FixedPlate = 1
};

/** What the controller steers the finger to, and so which controller it is. */
UENUM(BlueprintType)
enum class EHapticGuidance : uint8
{
	/** The real target's direction, seen from the start: the controller of the paper, for the person of its
	 *  model. */
	FixedDirection = 0,
	/** The real target's place, at arrival: the controller for people. It takes the pace of the motion, the whole
	 *  curve of the illusion, bias, habits and the tracker's noise as unknown, and learns them. Needs positions: in
	 *  a reach with directions alone this is FixedDirection. Measured on simulated people only. */
	Arrival = 1
};

/** Learning of the person: under EHapticGuidance::Arrival of all that person_mean holds, else of the tactile
 *  weight and the motor variance. */
UENUM(BlueprintType)
enum class EHapticAdaptation : uint8
{
	/** TactileWeight and BiasYaw are taken as known, the illusion as linear. */
	Off = 0,
	/** The person is learnt within each reach, which begins with what the configuration says of them. */
	Reach = 1,
	/** As REACH; the end of a reach also writes what it has learnt into the configuration, widened, because people
	 *  change: person_mean and person_covariance, TactileWeight and its deviation. A reach that ends early or that
	 *  the model does not fit (EHapticCommandFlags::Misfit) writes nothing. Under FixedDirection it writes
	 *  TactileWeight and MotorVariance; one reach changes the latter by a factor of 2 at most. */
	Carried = 2
};

/** Role of a target. */
UENUM(BlueprintType)
enum class EHapticTargetRole : uint8
{
	None = 0 UMETA(Hidden),
	/** the hand is steered to it. */
	Real = 1,
	/** the user sees it and goes to it. */
	Virtual = 2
};

/** Names a target of one component. */
USTRUCT(BlueprintType)
struct FHapticTarget
{
	GENERATED_BODY()

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int64 Id = 0;
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

	/** False: the data cannot determine the value. Then the interval is the range that was searched, and the value
	 *  its likeliest point. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	bool bKnown = false;
};

/** A session's assumptions of user, plate and tracker. */
USTRUCT(BlueprintType)
struct FHapticSettings
{
	GENERATED_BODY()

	/** Steps that the controller plans ahead. With 1 most reaches miss; more than 3 changes little and costs
	 *  time. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller", meta = (ClampMin = "1", ClampMax = "50"))
	int32 Horizon = 3;

	/** Duration of one step of the model and of the controller. The variances below are per step: scale them with
	 *  it. In seconds. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller",
		meta = (Units = "s", ClampMin = "0.001", ClampMax = "10"))
	double StepPeriod = 0.1;

	/** Source of the plate's commands. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller")
	EHapticControl Control = EHapticControl::MPC;

	/** What the controller steers the finger to, and so which controller it is. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller")
	EHapticGuidance Guidance = EHapticGuidance::Arrival;

	/** Learning of the person: under EHapticGuidance::Arrival of all that person_mean holds, else of the tactile
	 *  weight and the motor variance. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller")
	EHapticAdaptation Adaptation = EHapticAdaptation::Carried;

	/** The plate stays where it stands until the finger moves. Otherwise it turns to where the first moment of the
	 *  motion wants it as soon as a reach begins, which brings more fast reaches to the target. Set this if the
	 *  finger rests on the ridges before a reach: a plate that turns under a resting finger is felt. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller")
	bool bPlateWaits = false;

	/** The plate's pose is from a registration made at RegistrationTime. hrt_registration_apply() sets this;
	 *  hrt_scene_register(), which writes the scene's pose, clears it. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller")
	bool bRegistered = false;

	/** Cost of the error that the user feels. Raising it keeps the felt direction closer to the virtual one and
	 *  steers more slowly. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller",
		meta = (ClampMin = "0.000001", ClampMax = "1000000"))
	double PerceivedWeight = 1.0;

	/** Cost of the finger's actual error. Raising it steers faster, with a larger felt error; 0 steers not at
	 *  all. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller",
		meta = (ClampMin = "0", ClampMax = "1000000"))
	double ActualWeight = 1.0;

	/** Largest felt error that EHapticGuidance::Arrival asks the plate for: felt minus intended direction, as
	 *  predicted. Lowering it keeps the illusion less noticeable and reaches somewhat fewer targets: of simulated
	 *  people, 3.5 costs about 2 reaches in 100. What the person adds, by noise or by being other than estimated,
	 *  comes on top. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller",
		meta = (Units = "deg", ClampMin = "0.1", ClampMax = "45"))
	double MaxFeltError = 5.0;

	/** Largest angle between the plate orientation and the finger's direction under EHapticGuidance::Arrival.
	 *  Raising it allows larger gaps for people whose illusion still grows there; published data cover 60. Never
	 *  beyond the peak of the person's illusion. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller",
		meta = (Units = "deg", ClampMin = "1", ClampMax = "89"))
	double MotionBound = 75.0;

	/** Largest age of a registration at a sample. Older ones, and a session without Registered, get
	 *  EHapticCommandFlags::Registration. 0: not checked. In seconds. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller", meta = (Units = "s"))
	double MaxRegistrationAge = 0.0;

	/** Largest standard deviation that plate_covariance may give the bearing of the real target. Worse ones, and a
	 *  session without Registered, get EHapticCommandFlags::Registration. 0: not checked. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller",
		meta = (Units = "deg", ClampMin = "0", ClampMax = "180"))
	double MaxRegistrationSd = 0.0;

	/** Rate at which the person corrects an error that they feel. Found by calibration.h, kept in the profile; the
	 *  controller does not read it, as it gains nothing by it. 0: not known. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller", meta = (ClampMin = "0", ClampMax = "50"))
	double SteeringRate = 0.0;

	/** Time from what the person feels to their answer, kept likewise. 0: not known. In seconds. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Controller",
		meta = (Units = "s", ClampMin = "0", ClampMax = "0.5"))
	double SteeringDelay = 0.0;

	/** Maximum angle, modulo 180, between the plate orientation and the virtual direction plus BiasYaw. Raising it
	 *  allows larger gaps; near 90 the ridges run along the motion and signal nothing. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate",
		meta = (Units = "deg", ClampMin = "0.1", ClampMax = "90"))
	double PlateBound = 84.5;

	/** Maximum speed of the plate's servo, within which the controller plans. 0: no limit. In degrees a second. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate", meta = (ClampMin = "0", ClampMax = "1000000"))
	double PlateMaxSpeed = 0.0;

	/** Maximum acceleration of the servo, within which the controller plans. 0: no limit. In degrees a second
	 *  squared. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate", meta = (ClampMin = "0", ClampMax = "100000000"))
	double PlateMaxAcceleration = 0.0;

	/** Time from a command to the plate's first motion. The controller plans from where the plate will be by then.
	 *  In seconds. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate",
		meta = (Units = "s", ClampMin = "0", ClampMax = "1"))
	double PlateLatency = 0.0;

	/** Mechanical stops, as plate orientations: no command lies beyond them. Both 0: no stops. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate",
		meta = (Units = "deg", ClampMin = "-3600", ClampMax = "3600"))
	double PlateLowerStopYaw = 0.0;

	/** Mechanical stops, as plate orientations: no command lies beyond them. Both 0: no stops. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate",
		meta = (Units = "deg", ClampMin = "-3600", ClampMax = "3600"))
	double PlateUpperStopYaw = 0.0;

	/** Plate orientation under EHapticControl::FixedPlate. With stops, the plate goes to the nearest orientation
	 *  with the same ridges. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate",
		meta = (Units = "deg", ClampMin = "-180", ClampMax = "180"))
	double FixedPlateYaw = 0.0;

	/** Start of reaches in plate coordinates. Directions of targets are measured from here. In cm. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate")
	FVector StartPosition = FVector(-5.0, 0.0, 0.0);

	/** Radius of the plate: positions beyond it get EHapticCommandFlags::OffPlate. In cm. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate",
		meta = (Units = "cm", ClampMin = "0.1", ClampMax = "100000"))
	double PlateRadius = 7.5;

	/** Height above the plate: positions above it count as lifted. In cm. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate",
		meta = (Units = "cm", ClampMin = "0.01", ClampMax = "100000"))
	double LiftHeight = 1.5;

	/** Length in the engine's world of 1 m on the plate: other than 1 if the tracker's unit is off. Divides
	 *  positions and targets in the world, as seen from the plate's centre. This and the following: since version
	 *  0.3. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Plate", meta = (ClampMin = "0.5", ClampMax = "2"))
	double PlateScale = 1.0;

	/** Share of touch in the direction that the user feels. At a higher weight, the same turn of the plate steers
	 *  the hand further. Under EHapticGuidance::Arrival it is that of an illusion taken as linear, at 60 degrees;
	 *  person_mean overrides it. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "User", meta = (ClampMin = "0.001", ClampMax = "0.499"))
	double TactileWeight = 0.2;

	/** Standard deviation of TactileWeight, from which adaptation starts. Raising it makes adaptation faster and
	 *  less steady; under EHapticGuidance::Arrival it also makes the illusion's curve as uncertain in
	 *  proportion. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "User", meta = (ClampMin = "0.001", ClampMax = "0.49"))
	double TactileWeightSd = 0.05;

	/** Variance of the user's motor command per step. Raising it makes the estimator follow the samples more
	 *  closely. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "User",
		meta = (ClampMin = "0.000000001", ClampMax = "10000"))
	double MotorVariance = 0.5;

	/** Variance of the felt direction per step. Raising it models a user who reacts to touch more slowly. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "User",
		meta = (ClampMin = "0.000000001", ClampMax = "10000"))
	double SensoryVariance = 0.1;

	/** Variance of the user's felt direction before the first step. Raising it models a user who trusts touch more
	 *  in the first steps. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "User", meta = (ClampMin = "0", ClampMax = "10000"))
	double InitialVariance = 0.0;

	/** Perceptual bias: perceived minus true direction of a virtual target. The user goes to the virtual direction
	 *  plus this bias. Found by calibration.h; EHapticGuidance::Arrival learns the rest. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "User",
		meta = (Units = "deg", ClampMin = "-45", ClampMax = "45"))
	double BiasYaw = 0.0;

	/** Standard deviation of MotorVariance, from which adaptation starts. Raising it makes adaptation faster and
	 *  less steady. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "User", meta = (ClampMin = "0.001", ClampMax = "10"))
	double MotorVarianceSd = 0.5;

	/** Standard deviation of white noise in each tracked coordinate; under EHapticGuidance::Arrival of all noise,
	 *  unless TrackerCorrelatedNoise says how much of it is correlated. Raising it smooths positions more. 0:
	 *  learnt from the samples. In cm. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Tracker",
		meta = (Units = "cm", ClampMin = "0", ClampMax = "10"))
	double TrackerNoise = 0.0;

	/** Time from a motion to the time_ns of its sample, under EHapticGuidance::Arrival. In seconds. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Tracker",
		meta = (Units = "s", ClampMin = "0", ClampMax = "0.5"))
	double TrackerLatency = 0.0;

	/** When the plate was registered, on the clock of the samples; read if Registered. In seconds. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Tracker", meta = (Units = "s"))
	double RegistrationTime = 0.0;

	/** Standard deviation of the correlated part of the tracker's noise in each coordinate, under
	 *  EHapticGuidance::Arrival; TrackerNoise is then the white part alone. Found by calibration.h. 0: not known.
	 *  In cm. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Tracker",
		meta = (Units = "cm", ClampMin = "0", ClampMax = "10"))
	double TrackerCorrelatedNoise = 0.0;

	/** Time in which that part decays to 1/e; read if it is not 0. In seconds. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Tracker",
		meta = (Units = "s", ClampMin = "0.01", ClampMax = "2"))
	double TrackerCorrelation = 0.1;
};

/** Command for the plate, and its reasons. */
USTRUCT(BlueprintType)
struct FHapticCommand
{
	GENERATED_BODY()

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting",
		meta = (Bitmask, BitmaskEnum = "/Script/HapticRetargeting.EHapticCommandFlags"))
	int32 Flags = 0;

	/** Model step, from 0; -1 before the finger moves. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int64 Step = 0;

	/** Plate orientation to turn to now. Of the orientations with the same ridges between the stops it is the
	 *  nearest one, if the configured speed and acceleration are unlimited. Otherwise the plate stays in one half
	 *  turn for the whole reach, limited by the stops. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double PlateYaw = 0.0;

	/** Direction of the finger in the last step, observed or predicted. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double FingerYaw = 0.0;

	/** Direction that the user feels under this command, as the model predicts it. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double PerceivedYaw = 0.0;

	/** Direction to which the finger is steered; see Guidance. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double AimedYaw = 0.0;

	/** Distance along the plate to the real target; from the start until the first position. In cm. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double DistanceToGo = 0.0;

	/** Tactile weight that the controller assumes. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double TactileWeight = 0.0;

	/** Standard deviation of TactileWeight; 0: taken as known. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double TactileWeightSd = 0.0;

	/** Predicted time until the motion ends; 0 before it begins, and under FixedDirection. In seconds. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double TimeToGo = 0.0;

	/** Felt minus intended direction now, as estimated: what the person could notice. For visual redirection about
	 *  4.5 is noticed; no threshold is published for touch. 0 under FixedDirection. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double FeltErrorYaw = 0.0;

	/** Predicted bearing of the place of arrival, seen from the start, minus the real target's; 0 under
	 *  FixedDirection. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double PredictedMissYaw = 0.0;

	/** Normalised innovation squared of the last positions, mean over about twenty: about 2 if the model fits,
	 *  MISFIT from 4.5. 0 under FixedDirection. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double NormalisedInnovation = 0.0;

	/** Standard deviation of the finger's true place across the line to the real target, as a bearing from the
	 *  start: by what the estimator knows of the place and by plate_covariance. At the end, of BearingErrorYaw. 0
	 *  under FixedDirection. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double BearingErrorSd = 0.0;
};

/** Result of a reach. */
USTRUCT(BlueprintType)
struct FHapticSummary
{
	GENERATED_BODY()

	/** UNREACHABLE at the end, MISFIT and REGISTRATION at any time, OffTarget of where the finger ended, FAULT. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting",
		meta = (Bitmask, BitmaskEnum = "/Script/HapticRetargeting.EHapticCommandFlags"))
	int32 Flags = 0;

	/** Samples, and those of them that were dropouts or rejected as outliers. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int64 Samples = 0;

	/** Samples, and those of them that were dropouts or rejected as outliers. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int64 DroppedSamples = 0;

	/** Model steps with samples, and predicted steps without. Under ARRIVAL the steps before the motion was seen
	 *  count as predicted. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int64 Steps = 0;

	/** Model steps with samples, and predicted steps without. Under ARRIVAL the steps before the motion was seen
	 *  count as predicted. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int64 PredictedSteps = 0;

	/** Steps with samples in which the plate's bound or a stop, or its speed, limited the command; its speed under
	 *  FixedDirection alone. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int64 SaturatedSteps = 0;

	/** Steps with samples in which the plate's bound or a stop, or its speed, limited the command; its speed under
	 *  FixedDirection alone. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int64 RateLimitedSteps = 0;

	/** Direction of the finger in the last step, and that direction minus the real target's. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double FinalYaw = 0.0;

	/** Direction of the finger in the last step, and that direction minus the real target's. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double FinalMissYaw = 0.0;

	/** Direction that the user felt in the last step, and that direction minus the virtual target's and the user's
	 *  bias as it was known before the reach. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double PerceivedYaw = 0.0;

	/** Direction that the user felt in the last step, and that direction minus the virtual target's and the user's
	 *  bias as it was known before the reach. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double PerceivedErrorYaw = 0.0;

	/** Distance along the plate from the last position to the real target; from the start without positions. In
	 *  cm. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double DistanceToTarget = 0.0;

	/** Tactile weight and deviation at the end; see FHapticCommand. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double TactileWeight = 0.0;

	/** Tactile weight and deviation at the end; see FHapticCommand. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double TactileWeightSd = 0.0;

	/** Standard deviation of noise in each tracked coordinate, learnt or configured: of white noise, and under
	 *  ARRIVAL of all noise. In cm. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double TrackerNoise = 0.0;

	/** Motor variance: the configured one, corrected by this reach. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double MotorVariance = 0.0;

	/** Standard deviation of MotorVariance; close to the configured one if the reach had too little data; 0: taken
	 *  as known. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double MotorVarianceSd = 0.0;

	/** Bearing of the last position, seen from the start, minus the real target's; 0 without positions, or if the
	 *  finger never moved, which DistanceToTarget shows. This and the following: 0 under FixedDirection, since
	 *  version 0.3. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double BearingErrorYaw = 0.0;

	/** Largest size of FeltErrorYaw, and its root mean square while the finger moved. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double PeakFeltError = 0.0;

	/** Largest size of FeltErrorYaw, and its root mean square while the finger moved. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double RmsFeltError = 0.0;

	/** Largest NormalisedInnovation. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double NormalisedInnovation = 0.0;

	/** What the reach says of the person, each with its standard deviation. An IllusionCurve of more than 2
	 *  deviations says that the illusion is not linear, and TactileWeight holds at 60 degrees only. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double IllusionCurve = 0.0;

	/** What the reach says of the person, each with its standard deviation. An IllusionCurve of more than 2
	 *  deviations says that the illusion is not linear, and TactileWeight holds at 60 degrees only. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double IllusionCurveSd = 0.0;

	/** What the reach says of the person, each with its standard deviation. An IllusionCurve of more than 2
	 *  deviations says that the illusion is not linear, and TactileWeight holds at 60 degrees only. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double Gain = 0.0;

	/** What the reach says of the person, each with its standard deviation. An IllusionCurve of more than 2
	 *  deviations says that the illusion is not linear, and TactileWeight holds at 60 degrees only. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double GainSd = 0.0;

	/** What the reach says of the person, each with its standard deviation. An IllusionCurve of more than 2
	 *  deviations says that the illusion is not linear, and TactileWeight holds at 60 degrees only. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double BiasYaw = 0.0;

	/** What the reach says of the person, each with its standard deviation. An IllusionCurve of more than 2
	 *  deviations says that the illusion is not linear, and TactileWeight holds at 60 degrees only. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double BiasSd = 0.0;

	/** What the reach says of the person, each with its standard deviation. An IllusionCurve of more than 2
	 *  deviations says that the illusion is not linear, and TactileWeight holds at 60 degrees only. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double HabitYaw = 0.0;

	/** What the reach says of the person, each with its standard deviation. An IllusionCurve of more than 2
	 *  deviations says that the illusion is not linear, and TactileWeight holds at 60 degrees only. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double HabitSd = 0.0;

	/** Duration of the motion, as estimated. In seconds. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double Duration = 0.0;

	/** The last BearingErrorSd: standard deviation of BearingErrorYaw. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double BearingErrorSd = 0.0;
};

/** Authority over one pair of targets. */
USTRUCT(BlueprintType)
struct FHapticAuthority
{
	GENERATED_BODY()

	/** True if the plate can keep the finger on the real target's direction. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	bool bReachable = false;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticTarget RealTarget;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticTarget VirtualTarget;

	/** The virtual direction plus the person's bias, minus the real direction; in [-180, 180). */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double GapYaw = 0.0;

	/** Largest gap, to either side, that the plate can sustain for the session's person and guidance. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double MaxGap = 0.0;

	/** MaxGap minus the size of the gap; negative: unreachable. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double Margin = 0.0;

	/** Plate orientation that sustains the gap; at the bound if unreachable. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double PlateYaw = 0.0;

	/** Direction in which the finger settles: the real target's, if reachable. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double SettlingYaw = 0.0;

	/** MaxGap as the paper has it, from TactileWeight and PlateBound. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double PaperMaxGap = 0.0;
};

/** Parameters of the user. */
USTRUCT(BlueprintType)
struct FHapticCalibration
{
	GENERATED_BODY()

	/** Trials with a slide within which the plate turned by more than 5 degrees: they show the steering alone, and
	 *  are not among TrialsUsed. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int32 SlidesTurning = 0;

	/** Ended trials, and those of them with a slide of at least 30 mm over a plate at rest. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int32 Trials = 0;

	/** Ended trials, and those of them with a slide of at least 30 mm over a plate at rest. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int32 TrialsUsed = 0;

	/** Felt shift over the offset of the ridge normal from the motion, at 60 degrees, mean of both sides. Known
	 *  unless LackOfFit is set or the interval is wider than 0.1. Of the share of touch that is felt at the slides'
	 *  speed: people who feel ridges only as they cross them feel more at a higher one. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval TactileWeight;

	/** Goal at the middle of the path minus target direction, right positive. Known unless LackOfFit is set or the
	 *  interval is wider than 10 degrees. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval BiasYaw;

	/** Never known since version 0.3: slides of people who steer continuously look as those of the paper's person
	 *  with other variances. The value is the likeliest of the paper's person. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval MotorVariance;

	/** As MotorVariance. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval SensoryVariance;

	/** Of the white part of the tracker's noise. Known with enough samples of the finger at rest, unless the parts
	 *  of the noise may decay within 1.5 samples, which cannot be separated. In cm. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval TrackerNoise;

	/** Families of illusion curves: the felt shift over the offset t from the motion to the ridge normal. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	EHapticIllusion Illusion = EHapticIllusion::Linear;

	/** 0: none was found, each at 1 % of people whom the model fits. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting",
		meta = (Bitmask, BitmaskEnum = "/Script/HapticRetargeting.EHapticLackOfFitFlags"))
	int32 LackOfFit = 0;

	/** Slides that were left out: unlike the others, or with the motion within 5 to 12 degrees of along the ridges.
	 *  hrt_calibration_get_residual() names them. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int32 SlidesOutlying = 0;

	/** Slides that were left out: unlike the others, or with the motion within 5 to 12 degrees of along the ridges.
	 *  hrt_calibration_get_residual() names them. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int32 SlidesAlongRidges = 0;

	/** Scale of the likeliest family, degrees; 0 if it has none. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double IllusionScale = 0.0;

	/** Smallest offset at which the illusion is largest, 1 to 75: the motion bound for this user. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double PeakOffset = 0.0;

	/** w and b of the controller's curve (HRT_PERSON_WEIGHT, HRT_PERSON_CURVE), and their correlation. The curve is
	 *  known with 7 plate orientations or more. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval PersonWeight;

	/** w and b of the controller's curve (HRT_PERSON_WEIGHT, HRT_PERSON_CURVE), and their correlation. The curve is
	 *  known with 7 plate orientations or more. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval PersonCurve;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double WeightCurveCorrelation = 0.0;

	/** Largest gap between real and virtual direction that can be held, on the weaker side, with the plate within
	 *  75 degrees of the motion. Known if the curve is, slides reach offsets of 60 to both sides, and the interval
	 *  is at most 10 degrees wide. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval MaxGap;

	/** How far the user's goal turns over a path, halved (HRT_PERSON_HABIT). Known as BiasYaw. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval HabitYaw;

	/** Correlated part of the tracker's noise, and the time in which it decays to 1/e. In cm. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval CorrelatedNoise;

	/** Correlated part of the tracker's noise, and the time in which it decays to 1/e. In seconds. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval NoiseCorrelation;

	/** Probabilities of residuals as patterned as these if the model fits: over the plate orientation, the order of
	 *  the slides, the path. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double AngleP = 0.0;

	/** Probabilities of residuals as patterned as these if the model fits: over the plate orientation, the order of
	 *  the slides, the path. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double OrderP = 0.0;

	/** Probabilities of residuals as patterned as these if the model fits: over the plate orientation, the order of
	 *  the slides, the path. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double PathP = 0.0;

	/** Rate at which the user corrects an error that they feel, 1/s, and the time from feeling to answer, with the
	 *  tracker's latency and the arm's lag. Known with 6 turning slides or more unless LackOfFit is set, SteeringP
	 *  is below 0.01, the rate's interval spans a factor above 2.5, or the delay's is wider than 0.1 s. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval SteeringRate;

	/** Rate at which the user corrects an error that they feel, 1/s, and the time from feeling to answer, with the
	 *  tracker's latency and the arm's lag. Known with 6 turning slides or more unless LackOfFit is set, SteeringP
	 *  is below 0.01, the rate's interval spans a factor above 2.5, or the delay's is wider than 0.1 s. In
	 *  seconds. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval SteeringDelay;

	/** As PathP, of the turning slides under the likeliest law of steering; 1 without such slides. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double SteeringP = 0.0;
};

/** One slide of the last hrt_calibration_solve(). Angles are relative to the goal direction. */
USTRUCT(BlueprintType)
struct FHapticSlide
{
	GENERATED_BODY()

	/** What became of a slide: Verdict. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	EHapticSlide Verdict = EHapticSlide::Used;

	/** Number of the trial, from 0; trials without a slide are left out. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int32 Trial = 0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double PlateYaw = 0.0;

	/** Of the second half of the path, seen and fitted, and their difference. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double Yaw = 0.0;

	/** Of the second half of the path, seen and fitted, and their difference. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double FittedYaw = 0.0;

	/** Of the second half of the path, seen and fitted, and their difference. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double ResidualYaw = 0.0;
};

/** Test and retest: two calibrations of a user, or of two users. Each field is the second value less the first,
 *  with the 95 % interval of the difference; known if both values are. */
USTRUCT(BlueprintType)
struct FHapticCalibrationComparison
{
	GENERATED_BODY()

	/** By Holm's procedure over the known values: if nothing has changed, any of them is set in 5 % of comparisons.
	 *  0 is no proof that nothing has changed: see the intervals. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting",
		meta = (Bitmask, BitmaskEnum = "/Script/HapticRetargeting.EHapticDiffersFlags"))
	int32 Differing = 0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval TactileWeight;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval MaxGap;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval BiasYaw;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval HabitYaw;

	/** In cm. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval TrackerNoise;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval SteeringRate;

	/** In seconds. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FHapticInterval SteeringDelay;
};

/** A registered pose. Its numbers mean something if it HOLDS; INCONSISTENT and UpsideDown have those of the fit
 *  to all touches, to look at. */
USTRUCT(BlueprintType)
struct FHapticRegistration
{
	GENERATED_BODY()

	/** Verdict on a set of touches. hrt_registration_advice() has what to do. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	EHapticRegistrationVerdict Verdict = EHapticRegistrationVerdict::Holds;

	/** Touches that were given. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int32 Touches = 0;

	/** Index of the one touch that does not fit the others and was left out; -1: none. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int32 LeftOut = 0;

	/** Pose and scale, as FHapticSettings has them. The scale is 1 unless fitted. In cm. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FVector PlatePosition = FVector(0.0, 0.0, 0.0);

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double PlateScale = 0.0;

	/** Standard deviation of a touch's coordinate: as expected and as seen, weighted. In cm. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double TouchSd = 0.0;

	/** Root mean square distance of the touches from their marks. In cm. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double Residual = 0.0;

	/** Standard deviation of the plate's turn about its normal, which turns every reach. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double TurnSd = 0.0;
};

/** Result of hrt_registration_check(). */
USTRUCT(BlueprintType)
struct FHapticTouchCheck
{
	GENERATED_BODY()

	/** True if the touch agrees with the registration; else false: register again. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	bool bHolds = false;

	/** Distance of the touch from where its mark should be. In cm. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double Distance = 0.0;

	/** Distance within which 999 touches in 1000 are while the registration is true. A plate that has moved by less
	 *  may pass. In cm. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double Allowed = 0.0;
};

/** Where the skin that touches is, in the joint's axes: at position + rotation * Offset in the world. Of one
 *  hand. */
USTRUCT(BlueprintType)
struct FHapticFingertip
{
	GENERATED_BODY()

	/** True if every deviation is below 5 mm; else false: the joint was not turned enough, and the numbers are
	 *  0. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	bool bKnown = false;

	/** In cm. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FVector Offset = FVector(0.0, 0.0, 0.0);
};

/** A target of a scene. */
USTRUCT(BlueprintType)
struct FHapticSceneTarget
{
	GENERATED_BODY()

	/** Role of a target. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	EHapticTargetRole Role = EHapticTargetRole::Real;

	/** Index of the real target that serves this virtual one: the one that the file names, or else the nearest in
	 *  direction, the first among equals; -1 for a real target. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	int32 ServedBy = 0;

	/** In plate coordinates; Z is the height above the plate. In cm. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FVector Position = FVector(0.0, 0.0, 0.0);

	/** In cm. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FVector WorldPosition = FVector(0.0, 0.0, 0.0);

	/** From the start, along the plate. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double Yaw = 0.0;

	/** From the start, along the plate. In cm. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double Distance = 0.0;

	/** 0: not in the file. In cm. */
	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	double Radius = 0.0;

	UPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")
	FString Name;
};
