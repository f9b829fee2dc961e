// Written by plugin/bindings/generate from the C headers. The headers say what each call does.
using System;
using System.Runtime.InteropServices;

namespace Hrt
{
    public static class Constants
    {
        /// <summary>Maximum number of virtual targets, and of real ones, in hrt_target_assign().</summary>
        public const int AssignTargetsMax = 1000;
        /// <summary>Version of these headers. hrt_get_version() returns the library's.</summary>
        public const int VersionMajor = 0;
        public const int VersionMinor = 3;
        public const int VersionPatch = 0;
        /// <summary>Maximum number of calibrations in a process.</summary>
        public const int CalibrationsMax = 16;
        /// <summary>Maximum number of touches in one call.</summary>
        public const int TouchesMax = 1000;
        /// <summary>Numbers in the lower triangle of Registration.covariance.</summary>
        public const int PoseCovariances = 28;
        /// <summary>Maximum number of samples in hrt_latency_fit().</summary>
        public const int LatencySamplesMax = 100000;
        /// <summary>Maximum number of scenes in a process.</summary>
        public const int ScenesMax = 64;
        /// <summary>Maximum number of sessions in a process.</summary>
        public const int SessionsMax = 1024;
        /// <summary>w: slope of the felt shift w t - b t (t / 75)^2 over the plate's angle t</summary>
        public const int PersonWeight = 0;
        /// <summary>b: 0 for a linear illusion</summary>
        public const int PersonCurve = 1;
        /// <summary>rate at which they correct the direction they feel, 1/s</summary>
        public const int PersonGain = 2;
        /// <summary>goal minus virtual direction, degrees</summary>
        public const int PersonBias = 3;
        /// <summary>Curving: the goal's turn at the start, minus that at the end, halved, degrees.</summary>
        public const int PersonHabit = 4;
        /// <summary>of the pace: 0 minimum jerk, 1 even</summary>
        public const int PersonEvenness = 5;
        /// <summary>share of the goal's direction in which they set out</summary>
        public const int PersonHeading = 6;
        /// <summary>natural logarithm of one over a reach's duration in seconds</summary>
        public const int PersonLogRate = 7;
        /// <summary>Share of touch that fades from one ridge to the next: 0 if all of the ridges is always
        /// felt, 1 if a ridge is felt as it is crossed and then fades.</summary>
        public const int PersonFading = 8;
        /// <summary>Number of traits.</summary>
        public const int PersonTraits = 9;
        /// <summary>Numbers in the lower triangle of their covariance.</summary>
        public const int PersonCovariances = 45;
        /// <summary>Maximum number of targets in a session.</summary>
        public const int TargetsMax = 1000000;
        /// <summary>Bytes of a name, including the terminating zero.</summary>
        public const int NameSize = 64;
    }

    /// <summary>Flags of hrt_target_assign().</summary>
    [Flags]
    public enum AssignFlags : uint
    {
        None = 0,
        /// <summary>A real target serves one virtual target at most. Otherwise it may serve any
        /// number.</summary>
        Exclusive = 1,
    }

    /// <summary>HRT_OK or one of the errors below. Their numbers never change.</summary>
    public enum Result : int
    {
        Ok = 0,
        /// <summary>A pointer that must not be null was null.</summary>
        NullArgument = -1,
        /// <summary>The handle or id is null, stale, of another session, or was never given out.</summary>
        InvalidHandle = -2,
        /// <summary><c>structSize</c> is below the first version's, or bytes that this library does not know
        /// are not zero.</summary>
        StructSize = -3,
        /// <summary>A value is outside its documented range, not a number, or infinite.</summary>
        OutOfRange = -4,
        /// <summary>The call is not allowed now: for example an update without a reach.</summary>
        WrongState = -5,
        /// <summary>Another thread is in a call on this session.</summary>
        Busy = -6,
        /// <summary>The sample is older than the one before it.</summary>
        TimeReversed = -7,
        /// <summary>An allocation failed.</summary>
        OutOfMemory = -8,
        /// <summary>The number of objects or samples is at its limit.</summary>
        LimitReached = -9,
        /// <summary>Nothing has this name.</summary>
        NotFound = -10,
        /// <summary>The caller's buffer is too small for the output.</summary>
        BufferTooSmall = -11,
        /// <summary>Another target of this session has this name.</summary>
        NameTaken = -12,
        /// <summary>The operating system refused a file or a thread.</summary>
        System = -13,
        /// <summary>A file or text is malformed. hrt_last_error() names the place.</summary>
        BadFormat = -14,
        /// <summary>The data cannot determine the requested value. hrt_last_error() names what is
        /// missing.</summary>
        InsufficientData = -15,
        /// <summary>A defect in this library. Please report it with the text of hrt_last_error().</summary>
        Internal = -99,
    }

    /// <summary>Families of illusion curves: the felt shift over the offset t from the motion to the ridge
    /// normal.</summary>
    public enum Illusion : uint
    {
        /// <summary>w t</summary>
        Linear = 0,
        /// <summary>w t within the scale, constant beyond</summary>
        Saturating = 1,
        /// <summary>w 45 sin 2t</summary>
        Sine = 2,
        /// <summary>w scale tanh(t / scale)</summary>
        Tanh = 3,
        /// <summary>nothing within the scale, w (|t| - scale) beyond</summary>
        DeadBand = 4,
        /// <summary>different slopes to the left and to the right</summary>
        Unequal = 5,
        /// <summary>w t - b t (t / 75)^2, the controller's model</summary>
        Cubic = 6,
        /// <summary>no family fits the slides</summary>
        None = 7,
    }

    /// <summary>Patterns in what the fit leaves unexplained: CalibrationResult.lackOfFit.</summary>
    [Flags]
    public enum LackOfFitFlags : uint
    {
        None = 0,
        /// <summary>Over the plate orientation: no curve fits. Check the plate's orientations and the goal
        /// direction.</summary>
        Angle = 1,
        /// <summary>Over the order of the slides: the user learns or tires. Let them practise or rest, and
        /// repeat.</summary>
        Order = 2,
        /// <summary>Along the paths: they bend as neither a habit nor the model's steering does. Ask for
        /// slower, longer and even slides, and repeat.</summary>
        Path = 4,
    }

    /// <summary>What became of a slide: CalibrationSlide.verdict.</summary>
    public enum Slide : uint
    {
        Used = 0,
        /// <summary>unlike the others: left out</summary>
        Outlying = 1,
        /// <summary>left out: the illusion flips along the ridges</summary>
        AlongRidges = 2,
    }

    /// <summary>Values of two calibrations that differ: CalibrationComparison.differing.</summary>
    [Flags]
    public enum DiffersFlags : uint
    {
        None = 0,
        TactileWeight = 1,
        MaxGap = 2,
        Bias = 4,
        Habit = 8,
        TrackerNoise = 16,
        SteeringRate = 32,
        SteeringDelay = 64,
    }

    /// <summary>Level of a log message.</summary>
    public enum LogLevel : uint
    {
        Warning = 1,
        Error = 2,
    }

    /// <summary>How the conditions of the profile differ from those of now: Conditions.differing.</summary>
    [Flags]
    public enum ConditionFlags : uint
    {
        None = 0,
        Plate = 1,
        Tracker = 2,
    }

    /// <summary>ReachConfig.flags.</summary>
    [Flags]
    public enum ReachFlags : uint
    {
        None = 0,
        /// <summary><c>plateOrientationDeg</c> is given. Otherwise the plate is at the session's last
        /// command, at first 0.</summary>
        PlateOrientation = 1,
        /// <summary>The reach starts where the finger is first seen, instead of at
        /// SessionConfig.startPositionM: directions and distances are measured from there. The plate stands
        /// ready for the configured start until then, and samples before it are not counted. In a reach of
        /// directions alone this has no effect. Since version 0.3.</summary>
        StartAtFinger = 2,
    }

    /// <summary>Sample.flags: the fields that are set. At most one of DIRECTION, PLATE_POSITION and
    /// WORLD_POSITION. With none of these and without LIFTED the sample is a dropout: the plate is held, and
    /// the model predicts.</summary>
    [Flags]
    public enum SampleFlags : uint
    {
        None = 0,
        /// <summary>fingerDirectionDeg</summary>
        Direction = 1,
        /// <summary>fingerPositionM, in plate coordinates</summary>
        PlatePosition = 2,
        /// <summary>plateOrientationDeg, as measured</summary>
        PlateOrientation = 4,
        /// <summary>the finger does not touch the plate: the model waits</summary>
        Lifted = 8,
        /// <summary>fingerPositionM, in the engine's world</summary>
        WorldPosition = 16,
        /// <summary>platePositionM and plateRotation, for WORLD_POSITION. Otherwise the session's
        /// configuration has them.</summary>
        PlatePose = 32,
    }

    /// <summary>Command.flags.</summary>
    [Flags]
    public enum CommandFlags : uint
    {
        None = 0,
        /// <summary>no new decision: the former command is repeated</summary>
        Held = 1,
        /// <summary>no sample in the last step; under ARRIVAL, none now</summary>
        Predicted = 2,
        /// <summary>the plate's bound or a stop limits the command</summary>
        Saturated = 4,
        /// <summary>the plate's speed limits the command</summary>
        RateLimited = 8,
        /// <summary>the plate cannot sustain the gap: see authority.h</summary>
        Unreachable = 16,
        /// <summary>the finger does not touch the plate: the model waits</summary>
        Lifted = 32,
        /// <summary>the finger is beyond the plate's edge</summary>
        OffPlate = 64,
        /// <summary>The motion departs from the model more than its noise allows: the estimates, and
        /// UNREACHABLE, are not to be trusted.</summary>
        Misfit = 128,
        /// <summary>The finger is going to end, or has ended, more than 1.5 degrees of bearing from the real
        /// target.</summary>
        OffTarget = 256,
        /// <summary>the finger rests within the reach: the plate is held</summary>
        Resting = 512,
        /// <summary>The solver's work was cut short; the command keeps its bounds.</summary>
        Approximate = 1024,
        /// <summary>A defect in this library: a value was not a finite number. The plate is held, and that
        /// value is 0. The log says so once a session, when the session is next configured or
        /// destroyed.</summary>
        Fault = 2048,
        /// <summary>The plate's registration is older or worse than the configuration allows, or there is
        /// none: maxRegistrationAgeNs, maxRegistrationSdDeg. Touch the marks again (registration.h). The log
        /// has it at the next call of hrt_session_set_config(), _destroy() or
        /// hrt_registration_apply().</summary>
        Registration = 4096,
    }

    /// <summary>How a recording ends.</summary>
    public enum Ending : uint
    {
        /// <summary>with its end line, and nothing was altered or lost</summary>
        Complete = 0,
        /// <summary>without an end line: cut off, or the process ended while recording</summary>
        Cut = 1,
        /// <summary>at rows that a slow disk has lost: only those before were replayed</summary>
        LostRows = 2,
        /// <summary>with an end line whose checksum is not that of the text before it</summary>
        Altered = 3,
    }

    /// <summary>RegistrationConfig.flags.</summary>
    [Flags]
    public enum RegisterFlags : uint
    {
        None = 0,
        /// <summary>The tracker's unit of length is fitted too: of use if it may be off by more than 1 in
        /// 100.</summary>
        Scale = 1,
        /// <summary><c>up</c> is given. Without it, touches of which left and right were confused pass for
        /// those of a plate that lies upside down.</summary>
        Up = 2,
    }

    /// <summary>Verdict on a set of touches. hrt_registration_advice() has what to do.</summary>
    public enum RegistrationVerdict : uint
    {
        /// <summary>a pose explains the touches, or all of them but one</summary>
        Holds = 1,
        /// <summary>fewer than 3 touches</summary>
        TooFew = 2,
        /// <summary>the marks lie within 1 cm of a line: the plate could turn about it</summary>
        Degenerate = 3,
        /// <summary>no pose explains the touches, nor all of them but one</summary>
        Inconsistent = 4,
        /// <summary>the face looks away from <c>up</c>: marks were confused</summary>
        UpsideDown = 5,
    }

    /// <summary>Source of the plate's commands.</summary>
    public enum Control : uint
    {
        /// <summary>the model-predictive controller</summary>
        Mpc = 0,
        /// <summary>a plate that does not turn, as a baseline</summary>
        FixedPlate = 1,
    }

    /// <summary>What the controller steers the finger to, and so which controller it is.</summary>
    public enum Guidance : uint
    {
        /// <summary>The real target's direction, seen from the start: the controller of the paper, for the
        /// person of its model.</summary>
        FixedDirection = 0,
        /// <summary>The real target's place, at arrival: the controller for people. It takes the pace of the
        /// motion, the whole curve of the illusion, bias, habits and the tracker's noise as unknown, and
        /// learns them. Needs positions: in a reach with directions alone this is FIXED_DIRECTION. Measured
        /// on simulated people only.</summary>
        Arrival = 1,
        /// <summary>Name of ARRIVAL in version 0.2, whose line of sight it replaces.</summary>
        LineOfSight = 1,
    }

    /// <summary>Learning of the person: under Guidance.Arrival of all that personMean holds, else of the
    /// tactile weight and the motor variance.</summary>
    public enum Adaptation : uint
    {
        /// <summary>tactileWeight and biasDeg are taken as known, the illusion as linear</summary>
        Off = 0,
        /// <summary>The person is learnt within each reach, which begins with what the configuration says of
        /// them.</summary>
        Reach = 1,
        /// <summary>As REACH; the end of a reach also writes what it has learnt into the configuration,
        /// widened, because people change: personMean and personCovariance, tactileWeight and its deviation.
        /// A reach that ends early or that the model does not fit (CommandFlags.Misfit) writes nothing. Under
        /// FIXED_DIRECTION it writes tactileWeight and motorVarianceDeg2; one reach changes the latter by a
        /// factor of 2 at most.</summary>
        Carried = 2,
    }

    /// <summary>SessionConfig.flags.</summary>
    [Flags]
    public enum SessionFlags : uint
    {
        None = 0,
        /// <summary>The plate stays where it stands until the finger moves. Otherwise it turns to where the
        /// first moment of the motion wants it as soon as a reach begins, which brings more fast reaches to
        /// the target. Set this if the finger rests on the ridges before a reach: a plate that turns under a
        /// resting finger is felt.</summary>
        PlateWaits = 1,
        /// <summary>The plate's pose is from a registration made at registrationTimeNs.
        /// hrt_registration_apply() sets this; hrt_scene_register(), which writes the scene's pose, clears
        /// it.</summary>
        Registered = 2,
    }

    /// <summary>What a session is about: bits of hrt_session_get_state(). 0: idle, no reach can
    /// begin.</summary>
    [Flags]
    public enum StateFlags : uint
    {
        None = 0,
        /// <summary>a real and a virtual target are there, and no reach is under way</summary>
        Ready = 1,
        /// <summary>a reach is under way</summary>
        Reaching = 2,
        /// <summary>A trial of a calibration that was created from this session is under way.</summary>
        Calibrating = 4,
        /// <summary>the calls of the session are recorded</summary>
        Recording = 8,
    }

    /// <summary>Role of a target.</summary>
    public enum TargetRole : uint
    {
        /// <summary>the hand is steered to it</summary>
        Real = 1,
        /// <summary>the user sees it and goes to it</summary>
        Virtual = 2,
    }

    /// <summary>How a target's place is given.</summary>
    public enum Place : uint
    {
        /// <summary>by <c>directionDeg</c> and <c>distanceM</c></summary>
        Direction = 1,
        /// <summary>by <c>positionM</c> in plate coordinates</summary>
        PlatePosition = 2,
        /// <summary>by <c>positionM</c> in the engine's world</summary>
        WorldPosition = 3,
    }

    /// <summary>Source of the library's memory. Both functions are called from any thread, concurrently.
    /// Neither may call this library or throw.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct Allocator
    {
        public uint structSize;
        public uint reserved;
        /// <summary>Passed to both functions. The library does not read it.</summary>
        public IntPtr context;
        /// <summary>Returns <c>size</c> bytes (at least 1) at a multiple of <c>alignment</c> (a power of
        /// two), or null on failure.</summary>
        public IntPtr allocate;
        /// <summary>Releases memory that allocate() returned. As of free(), it gets no size: an allocator
        /// that needs it keeps it beside the memory.</summary>
        public IntPtr release;
    }

    /// <summary>A session's handle. Zero is never a session. Handles are never reused.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct SessionHandle
    {
        public ulong value;
    }

    /// <summary>Configuration of a session. hrt_session_config_default() fills every field.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct SessionConfig
    {
        public uint structSize;
        /// <summary>Steps that the controller plans ahead. With 1 most reaches miss; more than 3 changes
        /// little and costs time. 1 to 50. Default 3.</summary>
        public uint horizon;
        /// <summary>Duration of one step of the model and of the controller. The variances below are per
        /// step: scale them with it. 1 ms to 10 s. Default 100 ms.</summary>
        public long stepPeriodNs;
        /// <summary>Control. Default Control.Mpc.</summary>
        public Control control;
        /// <summary>Guidance. Default Guidance.Arrival.</summary>
        public Guidance guidance;
        /// <summary>Adaptation. Default Adaptation.Carried.</summary>
        public Adaptation adaptation;
        /// <summary>SessionFlags. Default 0. Named <c>reserved</c> before version 0.3.</summary>
        public SessionFlags flags;
        /// <summary>Cost of the error that the user feels. Raising it keeps the felt direction closer to the
        /// virtual one and steers more slowly. 1e-6 to 1e6. Default 1.</summary>
        public double perceivedWeight;
        /// <summary>Cost of the finger's actual error. Raising it steers faster, with a larger felt error; 0
        /// steers not at all. 0 to 1e6. Default 1.</summary>
        public double actualWeight;
        /// <summary>Maximum angle, modulo 180, between the plate orientation (base.h) and the virtual
        /// direction plus biasDeg. Raising it allows larger gaps; near 90 the ridges run along the motion and
        /// signal nothing. 0.1 to 90. Default 84.5.</summary>
        public double plateBoundDeg;
        /// <summary>Maximum speed of the plate's servo, within which the controller plans. 0 to 1e6 degrees a
        /// second; 0: no limit. Default 0.</summary>
        public double plateMaxSpeedDegS;
        /// <summary>Maximum acceleration of the servo, within which the controller plans. 0 to 1e8 degrees a
        /// second squared; 0: no limit. Default 0.</summary>
        public double plateMaxAccelerationDegS2;
        /// <summary>Time from a command to the plate's first motion. The controller plans from where the
        /// plate will be by then. 0 to 1 s, and at most 8 step periods. Default 0.</summary>
        public long plateLatencyNs;
        /// <summary>Mechanical stops, as plate orientations (base.h): no command lies beyond them. -3600 to
        /// 3600, the upper at least 180 above the lower; both 0: no stops. Default 0 and 0.</summary>
        public double plateLowerStopDeg;
        public double plateUpperStopDeg;
        /// <summary>Plate orientation (base.h) under Control.FixedPlate. With stops, the plate goes to the
        /// nearest orientation with the same ridges. -180 to 180. Default 0.</summary>
        public double fixedPlateOrientationDeg;
        /// <summary>Share of touch in the direction that the user feels. At a higher weight, the same turn of
        /// the plate steers the hand further. Under Guidance.Arrival it is that of an illusion taken as
        /// linear, at 60 degrees; personMean overrides it. 0.001 to 0.499. Default 0.2.</summary>
        public double tactileWeight;
        /// <summary>Standard deviation of tactileWeight, from which adaptation starts. Raising it makes
        /// adaptation faster and less steady; under Guidance.Arrival it also makes the illusion's curve as
        /// uncertain in proportion. 0.001 to 0.49. Default 0.05.</summary>
        public double tactileWeightSd;
        /// <summary>Variance of the user's motor command per step. Raising it makes the estimator follow the
        /// samples more closely. 1e-9 to 1e4. Default 0.5.</summary>
        public double motorVarianceDeg2;
        /// <summary>Variance of the felt direction per step. Raising it models a user who reacts to touch
        /// more slowly. 1e-9 to 1e4. Default 0.1.</summary>
        public double sensoryVarianceDeg2;
        /// <summary>Variance of the user's felt direction before the first step. Raising it models a user who
        /// trusts touch more in the first steps. 0 to 1e4. Default 0.</summary>
        public double initialVarianceDeg2;
        /// <summary>Standard deviation of white noise in each tracked coordinate; under Guidance.Arrival of
        /// all noise, unless trackerCorrelatedNoiseM says how much of it is correlated. Raising it smooths
        /// positions more. 0 to 0.1, less than 1e-9 as 1e-9; 0: learnt from the samples. Default 0.</summary>
        public double trackerNoiseM;
        /// <summary>Start of reaches in plate coordinates. Directions of targets are measured from here. Each
        /// within 1000. Default (0, 0, 0.05): on the mid-line, 5 cm towards the user.</summary>
        public Double3 startPositionM;
        /// <summary>Radius of the plate: positions beyond it get CommandFlags.OffPlate. 0.001 to 1000.
        /// Default 0.075.</summary>
        public double plateRadiusM;
        /// <summary>Height above the plate: positions above it count as lifted. 0.0001 to 1000. Default
        /// 0.015.</summary>
        public double liftHeightM;
        /// <summary>Centre of the plate in the engine's world. Each within 1000. Default (0, 0, 0).</summary>
        public Double3 platePositionM;
        /// <summary>Rotation of the plate's mount in the world: the unit quaternion x, y, z, w from plate
        /// coordinates to the world's axes. It does not turn with the ridges. Length 1 within 0.001. Default
        /// (0, 0, 0, 1).</summary>
        public Double4 plateRotation;
        /// <summary>Perceptual bias: perceived minus true direction of a virtual target. The user goes to the
        /// virtual direction plus this bias. Found by calibration.h; Guidance.Arrival learns the rest. -45 to
        /// 45. Default 0. Since version 0.2.</summary>
        public double biasDeg;
        /// <summary>Standard deviation of motorVarianceDeg2, from which adaptation starts. Raising it makes
        /// adaptation faster and less steady. 0.001 to 10. Default 0.5. Since version 0.2.</summary>
        public double motorVarianceSdDeg2;
        /// <summary>Largest felt error that Guidance.Arrival asks the plate for: felt minus intended
        /// direction, as predicted. Lowering it keeps the illusion less noticeable and reaches somewhat fewer
        /// targets: of simulated people, 3.5 costs about 2 reaches in 100. What the person adds, by noise or
        /// by being other than estimated, comes on top. 0.1 to 45. Default 5. Since version 0.3.</summary>
        public double maxFeltErrorDeg;
        /// <summary>Largest angle between the plate orientation and the finger's direction under
        /// Guidance.Arrival. Raising it allows larger gaps for people whose illusion still grows there;
        /// published data cover 60. Never beyond the peak of the person's illusion. 1 to 89. Default 75.
        /// Since version 0.3.</summary>
        public double motionBoundDeg;
        /// <summary>Time from a motion to the timeNs of its sample, under Guidance.Arrival. 0 to 0.5 s.
        /// Default 0. Since version 0.3.</summary>
        public long trackerLatencyNs;
        /// <summary>What is believed of the person under Guidance.Arrival: HRT_PERSON_*. Read if
        /// personCovariance is not 0: then the weight in 0.01 to 0.6, the curve -0.1 to 0.5, the gain 3 to
        /// 20, the bias -90 to 90, the habit -45 to 45, the evenness 0 to 1, the heading -2 to 2, the
        /// logarithm of the rate -3 to 2.4, the fading -0.2 to 1. Default 0. Since version 0.3.</summary>
        public PersonMean personMean;
        /// <summary>Covariance of personMean: the lower triangle, row by row; positive definite, up to 1e4.
        /// All 0: an unknown person, of whom only tactileWeight, tactileWeightSd and biasDeg are read.
        /// Default 0. Since version 0.3.</summary>
        public PersonCovariance personCovariance;
        /// <summary>Length in the engine's world of 1 m on the plate: other than 1 if the tracker's unit is
        /// off. Divides positions and targets in the world, as seen from the plate's centre. 0.5 to 2.
        /// Default 1. This and the following: since version 0.3.</summary>
        public double plateScale;
        /// <summary>Covariance of the plate's pose in its own plane, wherever the pose comes from: its turn
        /// about its normal (radians, counter-clockwise) and its centre's place to the right and away
        /// (metres); the lower triangle, row by row. Variances 0 to 1. All 0: the pose is exact. Under
        /// Guidance.Arrival it goes into UNREACHABLE and bearingErrorSdDeg; where the plate leads does not
        /// depend on it. Default 0.</summary>
        public PlateCovariance plateCovariance;
        /// <summary>When the plate was registered, on the clock of the samples; read if
        /// SessionFlags.Registered. Default 0.</summary>
        public long registrationTimeNs;
        /// <summary>Largest age of a registration at a sample. Older ones, and a session without
        /// SessionFlags.Registered, get CommandFlags.Registration. 0: not checked. Default 0.</summary>
        public long maxRegistrationAgeNs;
        /// <summary>Largest standard deviation that plateCovariance may give the bearing of the real target.
        /// Worse ones, and a session without SessionFlags.Registered, get CommandFlags.Registration. 0 to
        /// 180; 0: not checked. Default 0.</summary>
        public double maxRegistrationSdDeg;
        /// <summary>Standard deviation of the correlated part of the tracker's noise in each coordinate,
        /// under Guidance.Arrival; trackerNoiseM is then the white part alone. Found by calibration.h. 0 to
        /// 0.1; 0: not known. Default 0.</summary>
        public double trackerCorrelatedNoiseM;
        /// <summary>Time in which that part decays to 1/e; read if it is not 0. 0.01 to 2 s. Default
        /// 0.1.</summary>
        public double trackerCorrelationS;
        /// <summary>Rate at which the person corrects an error that they feel. Found by calibration.h, kept
        /// in the profile; the controller does not read it, as it gains nothing by it. 0 to 50 1/s; 0: not
        /// known. Default 0.</summary>
        public double steeringRatePerS;
        /// <summary>Time from what the person feels to their answer, kept likewise. 0 to 0.5 s; 0: not known.
        /// Default 0.</summary>
        public double steeringDelayS;

        /// <summary>Every field with its default.</summary>
        public static SessionConfig Default
        {
            get
            {
                HapticRetargetingLibrary.Load();
                var config = default(SessionConfig);
                uint size = SizeOf<SessionConfig>.Value;
                HapticRetargetingLibrary.Check(Native.hrt_session_config_default(ref config, size));
                return config;
            }
        }
    }

    /// <summary>A target's id within its session. Zero is never a target. Ids are never reused, in any
    /// session.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct TargetId
    {
        public ulong value;
    }

    /// <summary>A target. hrt_target_config_default() fills every field. Only the fields that <c>place</c>
    /// names are read.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct TargetConfig
    {
        public uint structSize;
        /// <summary>TargetRole. Default TargetRole.Real.</summary>
        public TargetRole role;
        /// <summary>Place. Default Place.Direction.</summary>
        public Place place;
        public uint reserved;
        /// <summary>Direction from the start (base.h), -180 to 180. Default 0.</summary>
        public double directionDeg;
        /// <summary>Distance from the start along the plate, 0.001 to 1000. Default 0.1.</summary>
        public double distanceM;
        /// <summary>Place in plate coordinates or in the world, at least 1 mm from the start in the plane of
        /// the plate; the height y has no effect. Each within 1000. Default (0, 0, 0).</summary>
        public Double3 positionM;
        /// <summary>UTF-8, terminated by a zero; unique within the session unless empty. Default
        /// empty.</summary>
        public Name name;

        /// <summary>Every field with its default.</summary>
        public static TargetConfig Default
        {
            get
            {
                HapticRetargetingLibrary.Load();
                var config = default(TargetConfig);
                uint size = SizeOf<TargetConfig>.Value;
                HapticRetargetingLibrary.Check(Native.hrt_target_config_default(ref config, size));
                return config;
            }
        }
    }

    /// <summary>Authority over one pair of targets. Set <c>structSize</c> before the call.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct Authority
    {
        public uint structSize;
        /// <summary>1 if the plate can keep the finger on the real target's direction, else 0.</summary>
        public uint reachable;
        public TargetId realTarget;
        public TargetId virtualTarget;
        /// <summary>The virtual direction plus the person's bias, minus the real direction; in [-180,
        /// 180).</summary>
        public double gapDeg;
        /// <summary>Largest gap, to either side, that the plate can sustain for the session's person and
        /// guidance.</summary>
        public double maxGapDeg;
        /// <summary>maxGapDeg minus the size of the gap; negative: unreachable.</summary>
        public double marginDeg;
        /// <summary>Plate orientation (base.h) that sustains the gap; at the bound if unreachable.</summary>
        public double plateOrientationDeg;
        /// <summary>Direction in which the finger settles: the real target's, if reachable.</summary>
        public double settlingDirectionDeg;
        /// <summary>maxGapDeg as the paper has it, from tactileWeight and plateBoundDeg. Since version
        /// 0.3.</summary>
        public double paperMaxGapDeg;
    }

    /// <summary>Configuration of a reach. hrt_reach_config_default() fills every field.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct ReachConfig
    {
        public uint structSize;
        /// <summary>ReachFlags. Default 0.</summary>
        public ReachFlags flags;
        /// <summary>Target of the hand, less than 90 degrees from the virtual direction plus
        /// SessionConfig.biasDeg. Default null: to be set.</summary>
        public TargetId realTarget;
        /// <summary>Target that the user goes to. Default null: to be set.</summary>
        public TargetId virtualTarget;
        /// <summary>Plate orientation (base.h) before the reach, clamped to the stops. -3600 to 3600. Default
        /// 0.</summary>
        public double plateOrientationDeg;
        /// <summary>Expected duration of the motion under Guidance.Arrival, if the host knows it; it is
        /// learnt from the finger's progress otherwise. 0.1 to 20 s; 0: unknown. Default 0. Since version
        /// 0.3.</summary>
        public double durationS;

        /// <summary>Every field with its default.</summary>
        public static ReachConfig Default
        {
            get
            {
                HapticRetargetingLibrary.Load();
                var config = default(ReachConfig);
                uint size = SizeOf<ReachConfig>.Value;
                HapticRetargetingLibrary.Check(Native.hrt_reach_config_default(ref config, size));
                return config;
            }
        }
    }

    /// <summary>One sample of the tracked finger. Set it to zero, then set <c>structSize</c> and the known
    /// fields. Only the fields that <c>flags</c> names are read.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct Sample
    {
        public uint structSize;
        /// <summary>SampleFlags.</summary>
        public SampleFlags flags;
        /// <summary>The caller's monotonic clock, with any origin; never less than the last
        /// sample's.</summary>
        public long timeNs;
        /// <summary>Direction in which the finger moves, taken as exact. -180 to 180.</summary>
        public double fingerDirectionDeg;
        /// <summary>Position of the fingertip. Each within 1000.</summary>
        public Double3 fingerPositionM;
        /// <summary>Measured plate orientation (base.h). With stops it is taken as measured. Without stops
        /// half turns do not count: the model takes the orientation with the same ridges that is nearest to
        /// the expected one. -3600 to 3600.</summary>
        public double plateOrientationDeg;
        /// <summary>Pose of the plate in the world; see SessionConfig.</summary>
        public Double3 platePositionM;
        public Double4 plateRotation;
    }

    /// <summary>Command for the plate, and its reasons. Set <c>structSize</c> before the call.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct Command
    {
        public uint structSize;
        /// <summary>CommandFlags.</summary>
        public CommandFlags flags;
        /// <summary>Model step, from 0; -1 before the finger moves.</summary>
        public long step;
        /// <summary>Plate orientation (base.h) to turn to now. Of the orientations with the same ridges
        /// between the stops it is the nearest one, if the configured speed and acceleration are unlimited.
        /// Otherwise the plate stays in one half turn for the whole reach, limited by the stops.</summary>
        public double plateOrientationDeg;
        /// <summary>Direction of the finger in the last step, observed or predicted.</summary>
        public double fingerDirectionDeg;
        /// <summary>Direction that the user feels under this command, as the model predicts it.</summary>
        public double perceivedDirectionDeg;
        /// <summary>Direction to which the finger is steered; see SessionConfig.guidance.</summary>
        public double aimedDirectionDeg;
        /// <summary>Distance along the plate to the real target; from the start until the first
        /// position.</summary>
        public double distanceToGoM;
        /// <summary>Tactile weight that the controller assumes.</summary>
        public double tactileWeight;
        /// <summary>Standard deviation of tactileWeight; 0: taken as known.</summary>
        public double tactileWeightSd;
        /// <summary>Predicted time until the motion ends; 0 before it begins, and under FIXED_DIRECTION.
        /// Since version 0.3.</summary>
        public double timeToGoS;
        /// <summary>Felt minus intended direction now, as estimated: what the person could notice. For visual
        /// redirection about 4.5 is noticed; no threshold is published for touch. 0 under FIXED_DIRECTION.
        /// Since version 0.3.</summary>
        public double feltErrorDeg;
        /// <summary>Predicted bearing of the place of arrival, seen from the start, minus the real target's;
        /// 0 under FIXED_DIRECTION. Since version 0.3.</summary>
        public double predictedMissDeg;
        /// <summary>Normalised innovation squared of the last positions, mean over about twenty: about 2 if
        /// the model fits, MISFIT from 4.5. 0 under FIXED_DIRECTION. Since version 0.3.</summary>
        public double normalisedInnovation;
        /// <summary>Standard deviation of the finger's true place across the line to the real target, as a
        /// bearing from the start: by what the estimator knows of the place and by plateCovariance. At the
        /// end, of bearingErrorDeg. 0 under FIXED_DIRECTION. Since version 0.3.</summary>
        public double bearingErrorSdDeg;
    }

    /// <summary>Result of a reach. Set <c>structSize</c> before the call.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct ReachSummary
    {
        public uint structSize;
        /// <summary>CommandFlags: UNREACHABLE at the end, MISFIT and REGISTRATION at any time, OFF_TARGET of
        /// where the finger ended, FAULT. Named <c>reserved</c> before version 0.3.</summary>
        public CommandFlags flags;
        /// <summary>Samples, and those of them that were dropouts or rejected as outliers.</summary>
        public long samples;
        public long droppedSamples;
        /// <summary>Model steps with samples, and predicted steps without. Under ARRIVAL the steps before the
        /// motion was seen count as predicted.</summary>
        public long steps;
        public long predictedSteps;
        /// <summary>Steps with samples in which the plate's bound or a stop, or its speed, limited the
        /// command; its speed under FIXED_DIRECTION alone.</summary>
        public long saturatedSteps;
        public long rateLimitedSteps;
        /// <summary>Direction of the finger in the last step, and that direction minus the real
        /// target's.</summary>
        public double finalDirectionDeg;
        public double finalMissDeg;
        /// <summary>Direction that the user felt in the last step, and that direction minus the virtual
        /// target's and the user's bias as it was known before the reach.</summary>
        public double perceivedDirectionDeg;
        public double perceivedErrorDeg;
        /// <summary>Distance along the plate from the last position to the real target; from the start
        /// without positions.</summary>
        public double distanceToTargetM;
        /// <summary>Tactile weight and deviation at the end; see Command.</summary>
        public double tactileWeight;
        public double tactileWeightSd;
        /// <summary>Standard deviation of noise in each tracked coordinate, learnt or configured: of white
        /// noise, and under ARRIVAL of all noise.</summary>
        public double trackerNoiseM;
        /// <summary>Motor variance: the configured one, corrected by this reach. Since version 0.2.</summary>
        public double motorVarianceDeg2;
        /// <summary>Standard deviation of motorVarianceDeg2; close to the configured one if the reach had too
        /// little data; 0: taken as known. Since version 0.2.</summary>
        public double motorVarianceSdDeg2;
        /// <summary>Bearing of the last position, seen from the start, minus the real target's; 0 without
        /// positions, or if the finger never moved, which distanceToTargetM shows. This and the following: 0
        /// under FIXED_DIRECTION, since version 0.3.</summary>
        public double bearingErrorDeg;
        /// <summary>Largest size of Command.feltErrorDeg, and its root mean square while the finger
        /// moved.</summary>
        public double peakFeltErrorDeg;
        public double rmsFeltErrorDeg;
        /// <summary>Largest Command.normalisedInnovation.</summary>
        public double normalisedInnovation;
        /// <summary>What the reach says of the person (HRT_PERSON_*), each with its standard deviation. An
        /// illusionCurve of more than 2 deviations says that the illusion is not linear, and tactileWeight
        /// holds at 60 degrees only.</summary>
        public double illusionCurve;
        public double illusionCurveSd;
        public double gainPerS;
        public double gainSdPerS;
        public double biasDeg;
        public double biasSdDeg;
        public double habitDeg;
        public double habitSdDeg;
        /// <summary>Duration of the motion, as estimated.</summary>
        public double durationS;
        /// <summary>The last Command.bearingErrorSdDeg: standard deviation of bearingErrorDeg.</summary>
        public double bearingErrorSdDeg;
    }

    /// <summary>A calibration's handle. Zero is never a calibration. Handles are never reused.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct CalibrationHandle
    {
        public ulong value;
    }

    /// <summary>Configuration of a calibration. hrt_calibration_config_default() fills every field.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct CalibrationConfig
    {
        public uint structSize;
        /// <summary>Maximum number of trials. 10 to 10000. Default 200.</summary>
        public uint maxTrials;
        /// <summary>Maximum number of samples of all trials; each takes 32 bytes at creation. 100 to 1000000.
        /// Default 100000: 18 minutes at 90 Hz.</summary>
        public uint maxSamples;
        public uint reserved;
        /// <summary>Direction of the user's target. -180 to 180. Default 0: straight ahead, where the motor
        /// variance is accurate.</summary>
        public double goalDirectionDeg;
        /// <summary>Range of the plate orientations that hrt_calibration_next_angle() chooses from, relative
        /// to the goal direction. -89 to 89, the upper at least 40 above the lower. Default -75 and 75. Since
        /// version 0.3.</summary>
        public double lowerPlateDeg;
        public double upperPlateDeg;
        /// <summary>Width of the 95 % interval of the tactile weight at which hrt_calibration_next_angle()
        /// reports enough slides. Lowering it asks for more. 0.001 to 0.5. Default 0.02. Since version
        /// 0.3.</summary>
        public double enoughWeightWidth;

        /// <summary>Every field with its default.</summary>
        public static CalibrationConfig Default
        {
            get
            {
                HapticRetargetingLibrary.Load();
                var config = default(CalibrationConfig);
                uint size = SizeOf<CalibrationConfig>.Value;
                HapticRetargetingLibrary.Check(Native.hrt_calibration_config_default(ref config, size));
                return config;
            }
        }
    }

    /// <summary>An estimate with the ends of its 95 % interval. This struct never grows.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct Interval
    {
        public double value;
        public double lower;
        public double upper;
        /// <summary>1; or 0: the data cannot determine the value. Then the interval is the range that was
        /// searched, and the value its likeliest point.</summary>
        public uint known;
        public uint reserved;
    }

    /// <summary>Parameters of the user; the fields are those of SessionConfig. Set <c>structSize</c> before
    /// the call.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct CalibrationResult
    {
        public uint structSize;
        /// <summary>Trials with a slide within which the plate turned by more than 5 degrees: they show the
        /// steering alone, and are not among trialsUsed. Named <c>reserved</c> before version 0.3.</summary>
        public uint slidesTurning;
        /// <summary>Ended trials, and those of them with a slide of at least 30 mm over a plate at
        /// rest.</summary>
        public uint trials;
        public uint trialsUsed;
        /// <summary>Felt shift over the offset of the ridge normal from the motion, at 60 degrees, mean of
        /// both sides. Known unless lackOfFit is set or the interval is wider than 0.1. Of the share of touch
        /// that is felt at the slides' speed: people who feel ridges only as they cross them feel more at a
        /// higher one.</summary>
        public Interval tactileWeight;
        /// <summary>Goal at the middle of the path minus target direction, left positive. Known unless
        /// lackOfFit is set or the interval is wider than 10 degrees.</summary>
        public Interval biasDeg;
        /// <summary>Never known since version 0.3: slides of people who steer continuously look as those of
        /// the paper's person with other variances. The value is the likeliest of the paper's
        /// person.</summary>
        public Interval motorVarianceDeg2;
        /// <summary>As motorVarianceDeg2.</summary>
        public Interval sensoryVarianceDeg2;
        /// <summary>Of the white part of the tracker's noise. Known with enough samples of the finger at
        /// rest, unless the parts of the noise may decay within 1.5 samples, which cannot be
        /// separated.</summary>
        public Interval trackerNoiseM;
        /// <summary>Illusion, the likeliest family; LINEAR without a test with fewer than 7 plate
        /// orientations. Since version 0.3, as all fields below.</summary>
        public Illusion illusion;
        /// <summary>LackOfFitFlags; 0: none was found, each at 1 % of people whom the model fits.</summary>
        public LackOfFitFlags lackOfFit;
        /// <summary>Slides that were left out: unlike the others, or with the motion within 5 to 12 degrees
        /// of along the ridges. hrt_calibration_get_residual() names them.</summary>
        public uint slidesOutlying;
        public uint slidesAlongRidges;
        /// <summary>Scale of the likeliest family, degrees; 0 if it has none.</summary>
        public double illusionScaleDeg;
        /// <summary>Smallest offset at which the illusion is largest, 1 to 75: the motion bound for this
        /// user.</summary>
        public double peakOffsetDeg;
        /// <summary>w and b of the controller's curve (Constants.PersonWeight, Constants.PersonCurve), and
        /// their correlation. The curve is known with 7 plate orientations or more.</summary>
        public Interval personWeight;
        public Interval personCurve;
        public double weightCurveCorrelation;
        /// <summary>Largest gap between real and virtual direction that can be held, on the weaker side, with
        /// the plate within 75 degrees of the motion. Known if the curve is, slides reach offsets of 60 to
        /// both sides, and the interval is at most 10 degrees wide.</summary>
        public Interval maxGapDeg;
        /// <summary>How far the user's goal turns over a path, halved (Constants.PersonHabit). Known as
        /// biasDeg.</summary>
        public Interval habitDeg;
        /// <summary>Correlated part of the tracker's noise, and the time in which it decays to 1/e.</summary>
        public Interval correlatedNoiseM;
        public Interval noiseCorrelationS;
        /// <summary>Probabilities of residuals as patterned as these if the model fits: over the plate
        /// orientation, the order of the slides, the path.</summary>
        public double angleP;
        public double orderP;
        public double pathP;
        /// <summary>Rate at which the user corrects an error that they feel, 1/s, and the time from feeling
        /// to answer, with the tracker's latency and the arm's lag. Known with 6 turning slides or more
        /// unless lackOfFit is set, steeringP is below 0.01, the rate's interval spans a factor above 2.5, or
        /// the delay's is wider than 0.1 s.</summary>
        public Interval steeringRatePerS;
        public Interval steeringDelayS;
        /// <summary>As pathP, of the turning slides under the likeliest law of steering; 1 without such
        /// slides.</summary>
        public double steeringP;
    }

    /// <summary>One slide of the last hrt_calibration_solve(). Angles are relative to the goal direction. Set
    /// <c>structSize</c> before the call. Since version 0.3.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct CalibrationSlide
    {
        public uint structSize;
        /// <summary>Slide.</summary>
        public Slide verdict;
        /// <summary>Number of the trial, from 0; trials without a slide are left out.</summary>
        public uint trial;
        public uint reserved;
        public double plateDeg;
        /// <summary>Of the second half of the path, seen and fitted, and their difference.</summary>
        public double directionDeg;
        public double fittedDeg;
        public double residualDeg;
    }

    /// <summary>Test and retest: two calibrations of a user, or of two users. Each field is the second value
    /// less the first, with the 95 % interval of the difference; known if both values are. Set
    /// <c>structSize</c> before the call. Since version 0.3.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct CalibrationComparison
    {
        public uint structSize;
        /// <summary>DiffersFlags, by Holm's procedure over the known values: if nothing has changed, any of
        /// them is set in 5 % of comparisons. 0 is no proof that nothing has changed: see the
        /// intervals.</summary>
        public DiffersFlags differing;
        public Interval tactileWeight;
        public Interval maxGapDeg;
        public Interval biasDeg;
        public Interval habitDeg;
        public Interval trackerNoiseM;
        public Interval steeringRatePerS;
        public Interval steeringDelayS;
    }

    /// <summary>Conditions of a measurement. The plugin reads no clock and knows no devices: the host names
    /// them. Since version 0.3.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct Conditions
    {
        public uint structSize;
        /// <summary>Output: ConditionFlags, of what both the profile and the host name, and not alike. Input:
        /// not read.</summary>
        public ConditionFlags differing;
        /// <summary>Seconds since 1970, UTC. 0 to 253402300799, the end of the year 9999. 0:
        /// unknown.</summary>
        public long timeS;
        /// <summary>Names of plate and tracker: UTF-8 without control characters, ended by a zero. Empty:
        /// unknown.</summary>
        public Name plate;
        public Name tracker;
    }

    /// <summary>State of a recording. Set <c>structSize</c> before the call.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct RecordingStatus
    {
        public uint structSize;
        /// <summary>errno of the first failed write, after which nothing is written; 0: none.</summary>
        public int systemError;
        /// <summary>Calls that the operating system has accepted for writing.</summary>
        public ulong rowsWritten;
        /// <summary>Calls dropped because the disk was too slow or failed. 0 after stopping: the file is
        /// complete.</summary>
        public ulong rowsLost;
    }

    /// <summary>Result of a replay. Set <c>structSize</c> before the call.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct ReplayReport
    {
        public uint structSize;
        /// <summary>1 if <c>ending</c> is Ending.Complete, else 0.</summary>
        public uint complete;
        /// <summary>Rows replayed.</summary>
        public ulong rows;
        /// <summary>Line, from 1, of the first row whose result or any number differs from the recorded one;
        /// 0: all rows are equal, bit for bit.</summary>
        public ulong firstDifferentLine;
        /// <summary>FNV-1a hash of the replayed commands, equal on every host: for each successful row
        /// "update", flags as 8 bytes, step and the eleven numbers after it, least significant byte
        /// first.</summary>
        public ulong hash;
        /// <summary>Ending. Since version 0.3.</summary>
        public Ending ending;
        public uint reserved;
    }

    /// <summary>A touch of a mark. This struct never grows.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct MarkTouch
    {
        /// <summary>The mark in plate coordinates. Each within 1000.</summary>
        public Double3 markM;
        /// <summary>Where the tracker saw the fingertip, in the engine's world. Each within 1000.</summary>
        public Double3 touchedM;
    }

    /// <summary>Configuration of a registration. hrt_registration_config_default() fills every
    /// field.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct RegistrationConfig
    {
        public uint structSize;
        /// <summary>RegisterFlags. Default 0.</summary>
        public RegisterFlags flags;
        /// <summary>Standard deviation of each coordinate of a touch, as expected; the residuals correct it.
        /// Raising it accepts worse touches. 1e-5 to 0.1. Default 0.003.</summary>
        public double touchSdM;
        /// <summary>Up in the engine's world, of any length: the plate's face must look that way within 60
        /// degrees. Each within 1000, and not all 0. Default (0, 1, 0).</summary>
        public Double3 up;

        /// <summary>Every field with its default.</summary>
        public static RegistrationConfig Default
        {
            get
            {
                HapticRetargetingLibrary.Load();
                var config = default(RegistrationConfig);
                uint size = SizeOf<RegistrationConfig>.Value;
                HapticRetargetingLibrary.Check(Native.hrt_registration_config_default(ref config, size));
                return config;
            }
        }
    }

    /// <summary>A registered pose. Set <c>structSize</c> before the call. Its numbers mean something if it
    /// HOLDS; INCONSISTENT and UPSIDE_DOWN have those of the fit to all touches, to look at.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct Registration
    {
        public uint structSize;
        /// <summary>RegistrationVerdict.</summary>
        public RegistrationVerdict verdict;
        /// <summary>Touches that were given.</summary>
        public uint touches;
        /// <summary>Index of the one touch that does not fit the others and was left out; -1: none.</summary>
        public int leftOut;
        /// <summary>Pose and scale, as SessionConfig has them. The scale is 1 unless fitted.</summary>
        public Double3 platePositionM;
        public Double4 plateRotation;
        public double plateScale;
        /// <summary>Covariance of the rotation about the plate's x, y and z (radians), the position in the
        /// world (metres) and the scale: the lower triangle, row by row. 0 for a scale that was not
        /// fitted.</summary>
        public RegistrationCovariance covariance;
        /// <summary>Standard deviation of a touch's coordinate: as expected and as seen, weighted.</summary>
        public double touchSdM;
        /// <summary>Root mean square distance of the touches from their marks.</summary>
        public double residualM;
        /// <summary>Standard deviation of the plate's turn about its normal, which turns every
        /// reach.</summary>
        public double turnSdDeg;
    }

    /// <summary>Result of hrt_registration_check(). Set <c>structSize</c> before the call.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct TouchCheck
    {
        public uint structSize;
        /// <summary>1 if the touch agrees with the registration; else 0: register again.</summary>
        public uint holds;
        /// <summary>Distance of the touch from where its mark should be.</summary>
        public double distanceM;
        /// <summary>Distance within which 999 touches in 1000 are while the registration is true. A plate
        /// that has moved by less may pass.</summary>
        public double allowedM;
    }

    /// <summary>A tracked joint, in touches while its fingertip is on a mark. This struct never
    /// grows.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct JointTouch
    {
        /// <summary>Position of the joint in the engine's world. Each within 1000.</summary>
        public Double3 positionM;
        /// <summary>Rotation of the joint: the unit quaternion x, y, z, w from its axes to the world's.
        /// Length 1 within 0.001.</summary>
        public Double4 rotation;
    }

    /// <summary>Where the skin that touches is, in the joint's axes: at position + rotation * offsetM in the
    /// world. Of one hand. Set <c>structSize</c> before the call.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct Fingertip
    {
        public uint structSize;
        /// <summary>1 if every deviation is below 5 mm; else 0: the joint was not turned enough, and the
        /// numbers are 0.</summary>
        public uint known;
        public Double3 offsetM;
        /// <summary>Its standard deviations.</summary>
        public Double3 sdM;
    }

    /// <summary>Latency of a tracker. Set <c>structSize</c> before the call.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct Latency
    {
        public uint structSize;
        /// <summary>1 if the 95 % interval is at most 40 ms wide; else 0, and the numbers are 0.</summary>
        public uint known;
        /// <summary>For SessionConfig.trackerLatencyNs: the best fit, or 0 if that is negative.</summary>
        public long latencyNs;
        /// <summary>Ends of the 95 % interval; the lower one may be negative.</summary>
        public long lowerNs;
        public long upperNs;
        /// <summary>Standard deviation of a coordinate from the circle on which the finger was
        /// carried.</summary>
        public double residualM;
        /// <summary>Radius of that circle.</summary>
        public double radiusM;
    }

    /// <summary>A scene's handle. Zero is never a scene. Handles are never reused.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct SceneHandle
    {
        public ulong value;
    }

    /// <summary>The plate of a scene. Set <c>structSize</c> before the call.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct SceneInfo
    {
        public uint structSize;
        /// <summary>Number of targets, real and virtual.</summary>
        public uint targetCount;
        /// <summary>Pose of the plate in the world; see SessionConfig.</summary>
        public Double3 platePositionM;
        public Double4 plateRotation;
        public double plateRadiusM;
        /// <summary>Maximum speed of the servo, degrees per second; 0: not in the file.</summary>
        public double plateMaxSpeedDegS;
        /// <summary>Start of reaches, in plate coordinates.</summary>
        public Double3 startPositionM;
    }

    /// <summary>A target of a scene. Set <c>structSize</c> before the call.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct SceneTarget
    {
        public uint structSize;
        /// <summary>TargetRole.</summary>
        public TargetRole role;
        /// <summary>Index of the real target that serves this virtual one: the one that the file names, or
        /// else the nearest in direction, the first among equals; -1 for a real target.</summary>
        public int servedBy;
        public uint reserved;
        /// <summary>In plate coordinates; y is the height above the plate.</summary>
        public Double3 positionM;
        public Double3 worldPositionM;
        /// <summary>From the start, along the plate.</summary>
        public double directionDeg;
        public double distanceM;
        /// <summary>0: not in the file.</summary>
        public double radiusM;
        public Name name;
    }

    /// <summary>What is believed of the person under Guidance.Arrival: HRT_PERSON_*. Read if personCovariance
    /// is not 0: then the weight in 0.01 to 0.6, the curve -0.1 to 0.5, the gain 3 to 20, the bias -90 to 90,
    /// the habit -45 to 45, the evenness 0 to 1, the heading -2 to 2, the logarithm of the rate -3 to 2.4,
    /// the fading -0.2 to 1. Default 0. Since version 0.3.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public struct PersonMean
    {
        public double weight, curve, gain, bias, habit, evenness, heading, logRate, fading;
    }

    /// <summary>Covariance of personMean: the lower triangle, row by row; positive definite, up to 1e4. All
    /// 0: an unknown person, of whom only tactileWeight, tactileWeightSd and biasDeg are read. Default 0.
    /// Since version 0.3.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public struct PersonCovariance
    {
        public double value0, value1, value2, value3, value4, value5, value6, value7, value8, value9,
            value10, value11, value12, value13, value14, value15, value16, value17, value18, value19, value20,
            value21, value22, value23, value24, value25, value26, value27, value28, value29, value30, value31,
            value32, value33, value34, value35, value36, value37, value38, value39, value40, value41, value42,
            value43, value44;
    }

    /// <summary>Covariance of the plate's pose in its own plane, wherever the pose comes from: its turn about
    /// its normal (radians, counter-clockwise) and its centre's place to the right and away (metres); the
    /// lower triangle, row by row. Variances 0 to 1. All 0: the pose is exact. Under Guidance.Arrival it goes
    /// into UNREACHABLE and bearingErrorSdDeg; where the plate leads does not depend on it. Default
    /// 0.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public struct PlateCovariance
    {
        public double value0, value1, value2, value3, value4, value5;
    }

    /// <summary>Covariance of the rotation about the plate's x, y and z (radians), the position in the world
    /// (metres) and the scale: the lower triangle, row by row. 0 for a scale that was not fitted.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public struct RegistrationCovariance
    {
        public double value0, value1, value2, value3, value4, value5, value6, value7, value8, value9,
            value10, value11, value12, value13, value14, value15, value16, value17, value18, value19, value20,
            value21, value22, value23, value24, value25, value26, value27;
    }

    /// <summary>Returns <c>size</c> bytes (at least 1) at a multiple of <c>alignment</c> (a power of two), or
    /// null on failure.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal delegate IntPtr AllocatorAllocate(IntPtr context, UIntPtr size, UIntPtr alignment);

    /// <summary>Releases memory that allocate() returned. As of free(), it gets no size: an allocator that
    /// needs it keeps it beside the memory.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal delegate void AllocatorRelease(IntPtr context, IntPtr memory);

    /// <summary>Receives what no call can return, for example that a recording's disk is full. <c>level</c>
    /// is LogLevel. <c>text</c> is one line that names the session and, of a recording, the file; valid
    /// during the call. Called on a thread of the library or within a call that is not real-time, one call at
    /// a time in the process. It may not call this library or throw.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal delegate void LogCallback(IntPtr context, uint level, IntPtr text);

    internal static class Native
    {
        internal const string Library = "haptic_retargeting";

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr hrt_result_string(int result);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr hrt_last_error();

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrt_get_version(out uint outMajor, out uint outMinor, out uint outPatch);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_set_allocator(ref Allocator allocator);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_set_log_callback(LogCallback callback, IntPtr context);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_session_config_default(
            ref SessionConfig outConfig, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_session_create(
            ref SessionConfig config, out SessionHandle outSession);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern uint hrt_session_is_valid(SessionHandle session);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_session_get_state(SessionHandle session, out uint outState);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_session_destroy(SessionHandle session);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_session_set_log_callback(
            SessionHandle session, LogCallback callback, IntPtr context);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_session_get_config(
            SessionHandle session, ref SessionConfig outConfig);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_session_set_config(SessionHandle session, ref SessionConfig config);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_target_config_default(ref TargetConfig outConfig, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_target_add(
            SessionHandle session, ref TargetConfig config, out TargetId outTarget);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_target_set(
            SessionHandle session, TargetId target, ref TargetConfig config);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_target_get(
            SessionHandle session, TargetId target, ref TargetConfig outConfig);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_target_remove(SessionHandle session, TargetId target);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_target_find(
            SessionHandle session, [In] byte[] name, out TargetId outTarget);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_target_list(
            SessionHandle session, uint role, ulong capacity, [In, Out] TargetId[] outTargets,
            out ulong outCount);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_authority_query(
            SessionHandle session, TargetId realTarget, TargetId virtualTarget, ref Authority outAuthority);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_authority_query_all(
            SessionHandle session, ulong capacity, [In, Out] Authority[] outAuthorities, out ulong outCount);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_authority_query_best(
            SessionHandle session, TargetId virtualTarget, ref Authority outAuthority);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_target_assign(
            SessionHandle session, [In] TargetId[] virtualTargets, ulong virtualCount,
            [In] TargetId[] realTargets, ulong realCount, uint flags, ulong capacity,
            [In, Out] Authority[] outAuthorities);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_reach_config_default(ref ReachConfig outConfig, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_reach_begin(SessionHandle session, ref ReachConfig config);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_reach_update(
            SessionHandle session, ref Sample sample, ref Command outCommand);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_reach_retarget(
            SessionHandle session, TargetId realTarget, TargetId virtualTarget);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_reach_cancel(SessionHandle session);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_reach_end(SessionHandle session, ref ReachSummary outSummary);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_calibration_config_default(
            ref CalibrationConfig outConfig, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_calibration_create(
            SessionHandle session, ref CalibrationConfig config, out CalibrationHandle outCalibration);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_calibration_destroy(CalibrationHandle calibration);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_calibration_begin_trial(
            CalibrationHandle calibration, double plateOrientationDeg);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_calibration_add_sample(
            CalibrationHandle calibration, ref Sample sample);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_calibration_end_trial(CalibrationHandle calibration);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_calibration_cancel_trial(CalibrationHandle calibration);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_calibration_next_angle(
            CalibrationHandle calibration, out double outPlateOrientationDeg, out uint outEnough);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_calibration_solve(
            CalibrationHandle calibration, ref CalibrationResult outResult);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_calibration_get_residual(
            CalibrationHandle calibration, uint slide, ref CalibrationSlide outSlide);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_calibration_compare(
            ref CalibrationResult first, ref CalibrationResult second,
            ref CalibrationComparison outComparison);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_calibration_apply(
            SessionHandle session, ref CalibrationResult result);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_profile_set_conditions(
            SessionHandle session, ref Conditions conditions);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_profile_get_conditions(
            SessionHandle session, ref Conditions outConditions);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_profile_save(
            SessionHandle session, ulong capacity, [In, Out] byte[] outText, out ulong outLength);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_profile_load(SessionHandle session, [In] byte[] text, ulong length);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_recording_start(SessionHandle session, [In] byte[] path);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_recording_get_status(
            SessionHandle session, ref RecordingStatus outStatus);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_recording_stop(
            SessionHandle session, ref RecordingStatus outStatus);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_replay_text(
            [In] byte[] text, ulong length, ref ReplayReport outReport);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_replay_file([In] byte[] path, ref ReplayReport outReport);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_registration_config_default(
            ref RegistrationConfig outConfig, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_registration_fit(
            ref RegistrationConfig config, [In] MarkTouch[] touches, ulong touchCount, ulong capacity,
            [In, Out] double[] outResidualsM, ref Registration outRegistration);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr hrt_registration_advice(uint verdict);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_registration_apply(
            SessionHandle session, ref Registration registration, long timeNs);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_registration_check(
            ref Registration registration, ref MarkTouch touch, ref TouchCheck outCheck);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_registration_confirm(
            SessionHandle session, ref Registration registration, ref MarkTouch touch, long timeNs,
            ref TouchCheck outCheck);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_fingertip_fit(
            ref RegistrationConfig config, [In] JointTouch[] touches, ulong touchCount,
            ref Fingertip outFingertip);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_fingertip_place(
            ref Fingertip fingertip, ref JointTouch joint, ref Sample outSample);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_latency_fit(
            [In] Sample[] samples, ulong sampleCount, ref Latency outLatency);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_scene_load_file([In] byte[] path, out SceneHandle outScene);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_scene_load_memory(
            [In] byte[] bytes, ulong length, [In] byte[] name, out SceneHandle outScene);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_scene_destroy(SceneHandle scene);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_scene_get_info(SceneHandle scene, ref SceneInfo outInfo);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_scene_get_target(
            SceneHandle scene, uint index, ref SceneTarget outTarget);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_scene_register(
            SceneHandle scene, SessionHandle session, ulong capacity, [In, Out] TargetId[] outTargets);
    }
}
