// Written by plugin/bindings/generate from the C headers. They tell what each call does.
using System;
using System.Runtime.InteropServices;

namespace Hrt
{
    public static class Constants
    {
        /// <summary>Version of these headers; hrt_get_version() tells that of the library.</summary>
        public const int VersionMajor = 0;
        public const int VersionMinor = 2;
        public const int VersionPatch = 0;
        /// <summary>Calibrations that can exist at the same time in a process.</summary>
        public const int CalibrationsMax = 16;
        /// <summary>Scenes that can be loaded at the same time in a process.</summary>
        public const int ScenesMax = 64;
        /// <summary>Sessions that can exist at the same time in a process.</summary>
        public const int SessionsMax = 64;
        /// <summary>Targets that a session can hold.</summary>
        public const int TargetsMax = 1000000;
        /// <summary>Bytes of a name, with its terminating zero.</summary>
        public const int NameSize = 64;
    }

    /// <summary>What became of a call.</summary>
    public enum Result : int
    {
        Ok = 0,
        /// <summary>A pointer that must not be null was null.</summary>
        NullArgument = -1,
        /// <summary>The handle or id is null, was never given out, is of another session, or of something
        /// destroyed.</summary>
        InvalidHandle = -2,
        /// <summary><c>structSize</c> is below the first version's, or bytes beyond what this library knows
        /// are not zero.</summary>
        StructSize = -3,
        /// <summary>A value is outside its documented range, not a number, or infinite.</summary>
        OutOfRange = -4,
        /// <summary>Not now: for example an update without a reach, or a new configuration during
        /// one.</summary>
        WrongState = -5,
        /// <summary>Another thread is in a call on this session.</summary>
        Busy = -6,
        /// <summary>The sample's time is before that of the sample before it.</summary>
        TimeReversed = -7,
        OutOfMemory = -8,
        /// <summary>There are as many of these as there can be.</summary>
        LimitReached = -9,
        /// <summary>Nothing has this name.</summary>
        NotFound = -10,
        /// <summary>The caller's buffer cannot hold the answer.</summary>
        BufferTooSmall = -11,
        /// <summary>Another target of this session has this name.</summary>
        NameTaken = -12,
        /// <summary>The operating system refused: a file, a thread.</summary>
        System = -13,
        /// <summary>A text is not what it should be; hrt_last_error() tells where.</summary>
        BadFormat = -14,
        /// <summary>The data do not tell what was asked of them; hrt_last_error() tells what is
        /// missing.</summary>
        InsufficientData = -15,
        /// <summary>A defect in this library; please report it with the text of hrt_last_error().</summary>
        Internal = -99,
    }

    public enum LogLevel : uint
    {
        /// <summary>LogCallback: how bad it is.</summary>
        Warning = 1,
        Error = 2,
    }

    /// <summary>What decides the plate's orientation.</summary>
    public enum Control : uint
    {
        /// <summary>the model-predictive controller</summary>
        Mpc = 0,
        /// <summary>none, as a baseline: the plate stays where it is told to</summary>
        FixedPlate = 1,
    }

    /// <summary>Where the finger is wanted.</summary>
    public enum Guidance : uint
    {
        /// <summary>in the real target's direction from the start</summary>
        FixedDirection = 0,
        /// <summary>In the direction from where the finger is to where the real target is, held once less
        /// than a fifth of the path remains. Takes effect when positions are streamed; with directions alone
        /// it is as above.</summary>
        LineOfSight = 1,
    }

    /// <summary>Whether the user's share of touch and motor variance are learnt.</summary>
    public enum Adaptation : uint
    {
        /// <summary>no: they are taken as known</summary>
        Off = 0,
        /// <summary>The share of touch within each reach, from tactileWeight and its deviation. The reach's
        /// summary also tells the motor variance, from motorVarianceDeg2 and its deviation.</summary>
        Reach = 1,
        /// <summary>As REACH; and what a reach has learnt becomes the configuration's: tactileWeight and
        /// tactileWeightSd, the latter no less than 0.01, and motorVarianceDeg2 and motorVarianceSdDeg2, the
        /// latter no less than 0.1, as people change. One reach changes the motor variance by a factor of two
        /// at most, in which case its deviation stays; it is kept within 0.05 to 5.</summary>
        Carried = 2,
    }

    public enum TargetRole : uint
    {
        /// <summary>What a target is.</summary>
        Real = 1,
        Virtual = 2,
    }

    /// <summary>How a target's place is given.</summary>
    public enum Place : uint
    {
        /// <summary>by <c>directionDeg</c> and <c>distanceM</c></summary>
        Direction = 1,
        /// <summary>by <c>positionM</c> in plate coordinates</summary>
        PlatePosition = 2,
        /// <summary>By <c>positionM</c> in the engine's world; see SessionConfig.platePositionM.</summary>
        WorldPosition = 3,
    }

    /// <summary>ReachConfig.flags.</summary>
    [Flags]
    public enum ReachFlags : uint
    {
        None = 0,
        /// <summary><c>plateOrientationDeg</c> is given; without this the plate is where the session's last
        /// command left it (at first 0).</summary>
        PlateOrientation = 1,
    }

    /// <summary>Sample.flags: which fields hold something. Of DIRECTION, PLATE_POSITION and WORLD_POSITION at
    /// most one may be given. With none of them, nor LIFTED, the sample is a dropout: the plate is held, and
    /// the model predicts until the finger is seen again.</summary>
    [Flags]
    public enum SampleFlags : uint
    {
        None = 0,
        /// <summary>fingerDirectionDeg</summary>
        Direction = 1,
        /// <summary>fingerPositionM, in plate coordinates</summary>
        PlatePosition = 2,
        /// <summary>plateOrientationDeg, measured by the device</summary>
        PlateOrientation = 4,
        /// <summary>The finger is off the plate, and so feels nothing: the model waits.</summary>
        Lifted = 8,
        /// <summary>fingerPositionM, in the engine's world</summary>
        WorldPosition = 16,
        /// <summary>platePositionM and plateRotation: the plate has moved in the world; else it is where the
        /// session's configuration has it. Goes with WORLD_POSITION.</summary>
        PlatePose = 32,
    }

    /// <summary>Command.flags.</summary>
    [Flags]
    public enum CommandFlags : uint
    {
        None = 0,
        /// <summary>between steps: nothing new was decided in this call</summary>
        Held = 1,
        /// <summary>the last step had no direction and was predicted</summary>
        Predicted = 2,
        /// <summary>the plate's bound or a stop holds the command</summary>
        Saturated = 4,
        /// <summary>the plate's speed holds the command</summary>
        RateLimited = 8,
        /// <summary>the real direction cannot be held: see authority.h</summary>
        Unreachable = 16,
        /// <summary>the finger is above the plate: the model waits</summary>
        Lifted = 32,
        /// <summary>the finger is beyond the plate's edge</summary>
        OffPlate = 64,
    }

    /// <summary>A session's handle. Zero is never a session. A handle of a destroyed session is never valid
    /// again.</summary>
    [Serializable]
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SessionHandle
    {
        public ulong value;
    }

    /// <summary>Everything that a session is made from. hrt_session_config_default() fills every
    /// field.</summary>
    [Serializable]
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SessionConfig
    {
        public uint structSize;
        /// <summary>Steps that the controller looks ahead, 1 to 50. Default 3.</summary>
        public uint horizon;
        /// <summary>Time of one step of the participant's model and of the controller, 1 ms to 10 s. Default
        /// 100 ms.</summary>
        public long stepPeriodNs;
        /// <summary>Control. Default Control.Mpc.</summary>
        public Control control;
        /// <summary>Guidance. Default Guidance.LineOfSight.</summary>
        public Guidance guidance;
        /// <summary>Adaptation. Default Adaptation.Off.</summary>
        public Adaptation adaptation;
        public uint reserved;
        /// <summary>Weight of the perceived error in the controller's cost, 1e-6 to 1e6. Default 1.</summary>
        public double perceivedWeight;
        /// <summary>Weight of the actual error in the controller's cost, 0 to 1e6. Default 1.</summary>
        public double actualWeight;
        /// <summary>The plate stays within this of the direction that the user goes for, the virtual target's
        /// and biasDeg, or of what feels the same; 0.1 to 90. Default 84.5.</summary>
        public double plateBoundDeg;
        /// <summary>The plate's servo: its highest speed, 0 to 1e6 degrees a second; 0: no limit. Default
        /// 0.</summary>
        public double plateMaxSpeedDegS;
        /// <summary>Its highest acceleration, 0 to 1e8 degrees a second squared; 0: no limit. Default
        /// 0.</summary>
        public double plateMaxAccelerationDegS2;
        /// <summary>The time from a command to the plate's first motion, 0 to 1 s and to 8 step periods.
        /// Default 0.</summary>
        public long plateLatencyNs;
        /// <summary>The plate's stops, -3600 to 3600, the upper at least 180 above the lower; both 0: it
        /// turns freely. Default 0 and 0.</summary>
        public double plateLowerStopDeg;
        public double plateUpperStopDeg;
        /// <summary>Where the plate stays under Control.FixedPlate, -180 to 180: there, or at what feels the
        /// same between the stops and is nearer to where it stands. Default 0.</summary>
        public double fixedPlateOrientationDeg;
        /// <summary>Share of touch in the direction that the user feels, 0.001 to 0.499. Default
        /// 0.15.</summary>
        public double tactileWeight;
        /// <summary>Standard deviation of that, for adaptation to start from, 0.001 to 0.49. Default
        /// 0.05.</summary>
        public double tactileWeightSd;
        /// <summary>Variance of the user's motor command per step, 1e-9 to 1e4. Default 0.5.</summary>
        public double motorVarianceDeg2;
        /// <summary>Variance of what the user feels per step, 1e-9 to 1e4. Default 0.1.</summary>
        public double sensoryVarianceDeg2;
        /// <summary>Variance of the user's perceived direction before the first step, 0 to 1e4. Default
        /// 0.</summary>
        public double initialVarianceDeg2;
        /// <summary>White noise of each coordinate of a tracked position, standard deviation, 0 to 0.1; 0:
        /// learn it from the samples. Default 0.</summary>
        public double trackerNoiseM;
        /// <summary>Where reaches start, in plate coordinates; target directions are measured from here, in
        /// the plane of the plate. Each within 1000. Default (0, 0, 0.05): on the mid-line, 5 cm towards the
        /// user.</summary>
        public Double3 startPositionM;
        /// <summary>Beyond this from the plate's centre a position is off the plate, 0.001 to 1000. Default
        /// 0.075.</summary>
        public double plateRadiusM;
        /// <summary>Higher than this above the plate a position is lifted, 0.0001 to 1000. Default
        /// 0.015.</summary>
        public double liftHeightM;
        /// <summary>The plate's centre in the engine's world, each within 1000. Default (0, 0, 0).</summary>
        public Double3 platePositionM;
        /// <summary>How the plate's mount is turned in the world, as the unit quaternion x, y, z, w that
        /// takes plate coordinates to the world's axes. It does not turn with the ridges. Default (0, 0, 0,
        /// 1).</summary>
        public Double4 plateRotation;
        /// <summary>The user's own bias: how much further to the left than it is they take a virtual target
        /// to lie, -45 to 45. They go for its direction and this. Known from calibration.h, not learnt in
        /// reaches. Default 0. Since version 0.2.</summary>
        public double biasDeg;
        /// <summary>Standard deviation of motorVarianceDeg2, for adaptation to start from, 0.001 to 10.
        /// Default 0.5. Since version 0.2.</summary>
        public double motorVarianceSdDeg2;
    }

    /// <summary>A target's id within its session. Zero is never a target. The id of a removed target is never
    /// valid again, in no session.</summary>
    [Serializable]
    [StructLayout(LayoutKind.Sequential)]
    public partial struct TargetId
    {
        public ulong value;
    }

    /// <summary>A target. hrt_target_config_default() fills every field. Fields that <c>place</c> does not
    /// name are not read.</summary>
    [Serializable]
    [StructLayout(LayoutKind.Sequential)]
    public partial struct TargetConfig
    {
        public uint structSize;
        /// <summary>TargetRole. Default TargetRole.Real.</summary>
        public TargetRole role;
        /// <summary>Place. Default Place.Direction.</summary>
        public Place place;
        public uint reserved;
        /// <summary>Direction from the start, -180 to 180. Default 0.</summary>
        public double directionDeg;
        /// <summary>Distance from the start along the plate, 0.001 to 1000. Default 0.1.</summary>
        public double distanceM;
        /// <summary>Place in plate coordinates or in the world, each within 1000; at least 1 mm from the
        /// start in the plane of the plate; the height y is kept and not used. Default (0, 0, 0).</summary>
        public Double3 positionM;
        /// <summary>UTF-8, ended by a zero; unique within the session unless empty. Default empty.</summary>
        public Name name;
    }

    /// <summary>What can be held for one pair. Set <c>structSize</c> before the call.</summary>
    [Serializable]
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Authority
    {
        public uint structSize;
        /// <summary>1 if the finger can be held on the real target's direction, else 0.</summary>
        public uint reachable;
        public TargetId realTarget;
        public TargetId virtualTarget;
        /// <summary>Where the user goes, the virtual target's direction and SessionConfig.biasDeg, less the
        /// real target's direction; in [-180, 180).</summary>
        public double gapDeg;
        /// <summary>The largest gap, either way, that can be held with the session's tactile weight and plate
        /// bound.</summary>
        public double largestGapDeg;
        /// <summary>largestGapDeg less the size of the gap; negative if out of reach.</summary>
        public double marginDeg;
        /// <summary>Where the plate must stand to hold it; on its bound if out of reach.</summary>
        public double plateOrientationDeg;
        /// <summary>Where the finger settles: the real target's direction if it can be held.</summary>
        public double settlingDirectionDeg;
    }

    /// <summary>What a reach is. hrt_reach_config_default() fills every field.</summary>
    [Serializable]
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ReachConfig
    {
        public uint structSize;
        /// <summary>ReachFlags. Default 0.</summary>
        public ReachFlags flags;
        /// <summary>Its direction and the one that the user goes for, the virtual target's and
        /// SessionConfig.biasDeg, are less than 90 degrees apart. Default null: to be set.</summary>
        public TargetId realTarget;
        public TargetId virtualTarget;
        /// <summary>Where the plate stands before the reach, -3600 to 3600; beyond a stop means at the stop.
        /// Default 0.</summary>
        public double plateOrientationDeg;
    }

    /// <summary>One sample of the tracked finger. Set it to zero, then <c>structSize</c> and what is known.
    /// Fields that <c>flags</c> does not name are not read, whatever is in them.</summary>
    [Serializable]
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Sample
    {
        public uint structSize;
        /// <summary>SampleFlags.</summary>
        public SampleFlags flags;
        /// <summary>The caller's monotonic clock; any origin. Not before the last sample's; the same time
        /// again is taken.</summary>
        public long timeNs;
        /// <summary>The direction in which the finger moves, -180 to 180; taken as exact.</summary>
        public double fingerDirectionDeg;
        /// <summary>The fingertip, each within 1000. Of a tracked pose this is the position; how the finger
        /// is turned is not asked for.</summary>
        public Double3 fingerPositionM;
        /// <summary>Where the plate stands, -3600 to 3600. A plate without stops may count its turns as it
        /// likes: of the orientations that feel the same, the one nearest to where it is expected is taken.
        /// With stops it is taken as it is.</summary>
        public double plateOrientationDeg;
        /// <summary>The plate in the world, as in SessionConfig.</summary>
        public Double3 platePositionM;
        public Double4 plateRotation;
    }

    /// <summary>What the plate is to do now, and why. Set <c>structSize</c> before the call.</summary>
    [Serializable]
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Command
    {
        public uint structSize;
        /// <summary>CommandFlags.</summary>
        public CommandFlags flags;
        /// <summary>The model step, from 0; -1 before the finger moves.</summary>
        public long step;
        /// <summary>Turn the plate here. Ridges repeat every 180 degrees. If the session's configuration
        /// gives the plate no highest speed or acceleration, this is the nearest of the orientations that
        /// feel the same and lie between the stops. If it does, the plate keeps to one half turn for a whole
        /// reach, so that it swings round at the start or not at all; a command beyond a stop is held at the
        /// stop.</summary>
        public double plateOrientationDeg;
        /// <summary>The finger's direction in the last step, observed or predicted.</summary>
        public double fingerDirectionDeg;
        /// <summary>The direction that the user feels, as the model predicts it under this command.</summary>
        public double perceivedDirectionDeg;
        /// <summary>Where the finger is wanted; see SessionConfig.guidance.</summary>
        public double aimedDirectionDeg;
        /// <summary>Along the plate to the real target; from the start until a position is
        /// streamed.</summary>
        public double distanceToGoM;
        /// <summary>The share of touch that the controller assumes.</summary>
        public double tactileWeight;
        /// <summary>Its standard deviation; 0: it is taken as known.</summary>
        public double tactileWeightSd;
    }

    /// <summary>What became of a reach. Set <c>structSize</c> before the call.</summary>
    [Serializable]
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ReachSummary
    {
        public uint structSize;
        public uint reserved;
        /// <summary>Samples taken in, and of these the dropouts and what was left out as an
        /// outlier.</summary>
        public long samples;
        public long droppedSamples;
        /// <summary>Model steps with samples, and steps without, which were predicted.</summary>
        public long steps;
        public long predictedSteps;
        /// <summary>Of the steps with samples, those whose command the plate's bound, a stop, or its speed
        /// held.</summary>
        public long saturatedSteps;
        public long rateLimitedSteps;
        /// <summary>The finger's direction in the last step, and that less the real target's.</summary>
        public double finalDirectionDeg;
        public double finalMissDeg;
        /// <summary>What the user felt in the last step, and that less where they went: the virtual target's
        /// direction and SessionConfig.biasDeg.</summary>
        public double perceivedDirectionDeg;
        public double perceivedErrorDeg;
        /// <summary>From the last position along the plate to the real target; from the start if none was
        /// streamed.</summary>
        public double distanceToTargetM;
        /// <summary>What the controller assumed at the end; see Command.</summary>
        public double tactileWeight;
        public double tactileWeightSd;
        /// <summary>White noise of each coordinate of the tracked positions, standard deviation, as learnt or
        /// configured.</summary>
        public double trackerNoiseM;
        /// <summary>The user's motor variance as this reach corrects what the configuration assumes. Since
        /// version 0.2.</summary>
        public double motorVarianceDeg2;
        /// <summary>Its standard deviation; close to SessionConfig.motorVarianceSdDeg2 if the reach could not
        /// tell; 0: it is taken as known. Since version 0.2.</summary>
        public double motorVarianceSdDeg2;
    }

    /// <summary>A calibration's handle. Zero is never a calibration. A handle of a destroyed one is never
    /// valid again.</summary>
    [Serializable]
    [StructLayout(LayoutKind.Sequential)]
    public partial struct CalibrationHandle
    {
        public ulong value;
    }

    /// <summary>What a calibration is. hrt_calibration_config_default() fills every field.</summary>
    [Serializable]
    [StructLayout(LayoutKind.Sequential)]
    public partial struct CalibrationConfig
    {
        public uint structSize;
        /// <summary>Trials that it can hold, 10 to 10000. Default 200.</summary>
        public uint maxTrials;
        /// <summary>Samples that all trials together can hold, 100 to 1000000; 24 bytes each, taken at
        /// creation. Default 100000: 18 minutes at 90 Hz.</summary>
        public uint maxSamples;
        public uint reserved;
        /// <summary>Where the user is told to go, -180 to 180. Default 0: straight ahead.</summary>
        public double goalDirectionDeg;
    }

    /// <summary>An estimate with the ends of its 95 % interval. This struct never grows.</summary>
    [Serializable]
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Interval
    {
        public double value;
        public double lower;
        public double upper;
        /// <summary>1, or 0: the data can't tell. Then the interval is what was searched, and the value no
        /// more than its likeliest point.</summary>
        public uint known;
        public uint reserved;
    }

    /// <summary>What the slides tell of the user. The fields are those of SessionConfig. Set
    /// <c>structSize</c> before the call.</summary>
    [Serializable]
    [StructLayout(LayoutKind.Sequential)]
    public partial struct CalibrationResult
    {
        public uint structSize;
        public uint reserved;
        /// <summary>Trials that were ended, and of these the ones with a slide of 30 mm or more, which alone
        /// count.</summary>
        public uint trials;
        public uint trialsUsed;
        /// <summary>Always known; otherwise hrt_calibration_solve() refuses.</summary>
        public Interval tactileWeight;
        /// <summary>Always known.</summary>
        public Interval biasDeg;
        /// <summary>Known if the tracker is good enough to show it; one with 1.2 mm of noise hardly
        /// is.</summary>
        public Interval motorVarianceDeg2;
        /// <summary>As motorVarianceDeg2.</summary>
        public Interval sensoryVarianceDeg2;
        /// <summary>Always known.</summary>
        public Interval trackerNoiseM;
    }

    /// <summary>Where the library's memory comes from. The functions may be called from any thread, at the
    /// same time; they must not call this library, and must not throw.</summary>
    [Serializable]
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Allocator
    {
        public uint structSize;
        public uint reserved;
        /// <summary>Passed to both functions; never read.</summary>
        public IntPtr context;
        /// <summary>Returns <c>size</c> bytes (at least 1) at a multiple of <c>alignment</c> (a power of
        /// two), or null if it can't.</summary>
        public IntPtr allocate;
        /// <summary>Takes back what allocate() returned.</summary>
        public IntPtr release;
    }

    /// <summary>How a recording does. Set <c>structSize</c> before the call.</summary>
    [Serializable]
    [StructLayout(LayoutKind.Sequential)]
    public partial struct RecordingStatus
    {
        public uint structSize;
        /// <summary>The errno of the first write that failed, after which nothing more is written; 0: none
        /// did.</summary>
        public int systemError;
        /// <summary>Calls recorded, as far as the operating system has taken them.</summary>
        public ulong rowsWritten;
        /// <summary>Calls that are not in the file, because the disk was too slow or failed. 0 at the end: it
        /// is complete.</summary>
        public ulong rowsLost;
    }

    /// <summary>What a replay found. Set <c>structSize</c> before the call.</summary>
    [Serializable]
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ReplayReport
    {
        public uint structSize;
        /// <summary>1 if the recording is whole: it has its end, and no rows were lost; else 0, and what
        /// precedes the gap was replayed.</summary>
        public uint complete;
        /// <summary>Rows replayed.</summary>
        public ulong rows;
        /// <summary>The line of the file, from 1, of the first row that came out otherwise than recorded, in
        /// its result or any number; 0: all came out the same, bit for bit.</summary>
        public ulong firstDifferentLine;
        /// <summary>FNV-1a of the commands as replayed, which is the same on every host: of each row "update"
        /// without error, flags as 8 bytes, step, and the seven numbers after them, least significant byte
        /// first.</summary>
        public ulong hash;
    }

    /// <summary>A scene's handle. Zero is never a scene. A handle of a destroyed scene is never valid
    /// again.</summary>
    [Serializable]
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SceneHandle
    {
        public ulong value;
    }

    /// <summary>The plate of a scene. Set <c>structSize</c> before the call.</summary>
    [Serializable]
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SceneInfo
    {
        public uint structSize;
        /// <summary>How many targets the scene has, real and virtual.</summary>
        public uint targetCount;
        /// <summary>The plate in the world, as in SessionConfig.</summary>
        public Double3 platePositionM;
        public Double4 plateRotation;
        public double plateRadiusM;
        /// <summary>Of the plate's servo; 0 if the file does not tell.</summary>
        public double plateMaxSpeedDegS;
        /// <summary>In plate coordinates.</summary>
        public Double3 startPositionM;
    }

    /// <summary>A target of a scene. Set <c>structSize</c> before the call.</summary>
    [Serializable]
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SceneTarget
    {
        public uint structSize;
        /// <summary>TargetRole.</summary>
        public TargetRole role;
        /// <summary>Of a virtual target: the index of the real one that serves it; of a real one
        /// -1.</summary>
        public int servedBy;
        public uint reserved;
        /// <summary>In plate coordinates; y is the height above the plate.</summary>
        public Double3 positionM;
        public Double3 worldPositionM;
        /// <summary>Seen from the start, along the plate.</summary>
        public double directionDeg;
        public double distanceM;
        /// <summary>0 if the file does not tell.</summary>
        public double radiusM;
        public Name name;
    }

    /// <summary>Returns <c>size</c> bytes (at least 1) at a multiple of <c>alignment</c> (a power of two), or
    /// null if it can't.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal delegate IntPtr AllocatorAllocate(IntPtr context, UIntPtr size, UIntPtr alignment);

    /// <summary>Takes back what allocate() returned.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal delegate void AllocatorRelease(IntPtr context, IntPtr memory);

    /// <summary>Hears what no call can return, such as that a recording's disk is full. <c>text</c> is one
    /// line, valid during the call. Called from a thread of the library's own, never from within a call of
    /// the host's; must not call this library, and must not throw.</summary>
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
        internal static extern Result hrt_session_config_default(
            ref SessionConfig outConfig, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_session_create(
            ref SessionConfig config, out SessionHandle outSession);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_session_destroy(SessionHandle session);

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
            SessionHandle session, uint role, uint capacity, [In, Out] TargetId[] outTargets,
            out uint outCount);

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
        internal static extern Result hrt_reach_config_default(ref ReachConfig outConfig, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_reach_begin(SessionHandle session, ref ReachConfig config);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_reach_update(
            SessionHandle session, ref Sample sample, ref Command outCommand);

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
        internal static extern Result hrt_calibration_solve(
            CalibrationHandle calibration, ref CalibrationResult outResult);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_calibration_apply(
            SessionHandle session, ref CalibrationResult result);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_set_allocator(ref Allocator allocator);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_set_log_callback(LogCallback callback, IntPtr context);

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
            SceneHandle scene, SessionHandle session, uint capacity, [In, Out] TargetId[] outTargets);
    }
}
