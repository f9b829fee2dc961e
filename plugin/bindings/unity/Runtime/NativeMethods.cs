// Written by plugin/bindings/generate from the C headers.
using System;
using System.Runtime.InteropServices;

namespace HapticRetargeting.Native
{
    /// <summary>64 bytes of text, the first in the lowest byte of E0.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct HrtChar64
    {
        public ulong E0, E1, E2, E3, E4, E5, E6, E7;
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct HrtDouble3
    {
        public double X, Y, Z;
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct HrtDouble4
    {
        public double X, Y, Z, W;
    }

    /// <summary>
    /// A session's handle. Zero is never a session. A handle of a destroyed session is never valid again.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct HrtSession
    {
        public ulong Value;
    }

    /// <summary>
    /// Everything that a session is made from. hrt_session_config_default() fills every field.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct HrtSessionConfig
    {
        public uint StructSize;
        /// <summary>Steps that the controller looks ahead, 1 to 50. Default 3.</summary>
        public uint Horizon;
        /// <summary>
        /// Time of one step of the participant's model and of the controller, 1 ms to 10 s. Default 100 ms.
        /// </summary>
        public long StepPeriodNs;
        /// <summary>HRT_CONTROL_*. Default HRT_CONTROL_MPC.</summary>
        public uint Control;
        /// <summary>HRT_GUIDANCE_*. Default HRT_GUIDANCE_FIXED_DIRECTION.</summary>
        public uint Guidance;
        /// <summary>HRT_ADAPTATION_*. Default HRT_ADAPTATION_OFF.</summary>
        public uint Adaptation;
        public uint Reserved;
        /// <summary>Weight of the perceived error in the controller's cost, 1e-6 to 1e6. Default 1.</summary>
        public double PerceivedWeight;
        /// <summary>Weight of the actual error in the controller's cost, 0 to 1e6. Default 1.</summary>
        public double ActualWeight;
        /// <summary>
        /// The plate stays within this of the virtual target's direction, 0.1 to 90. Default 84.5.
        /// </summary>
        public double PlateBoundDeg;
        /// <summary>
        /// The plate's servo: its highest speed, 0 to 1e6 degrees a second; 0: no limit. Default 0.
        /// </summary>
        public double PlateMaxSpeedDegS;
        /// <summary>
        /// Its highest acceleration, 0 to 1e8 degrees a second squared; 0: no limit. Default 0.
        /// </summary>
        public double PlateMaxAccelerationDegS2;
        /// <summary>
        /// The time from a command to the plate's first motion, 0 to 1 s and to 8 step periods. Default 0.
        /// </summary>
        public long PlateLatencyNs;
        /// <summary>
        /// The plate's stops, -3600 to 3600, the upper at least 180 above the lower; both 0: it turns freely.
        /// Default 0 and 0.
        /// </summary>
        public double PlateLowerStopDeg;
        public double PlateUpperStopDeg;
        /// <summary>Where the plate stays under HRT_CONTROL_FIXED_PLATE, -180 to 180. Default 0.</summary>
        public double FixedPlateOrientationDeg;
        /// <summary>
        /// Share of touch in the direction that the user feels, 0.001 to 0.499. Default 0.15.
        /// </summary>
        public double TactileWeight;
        /// <summary>
        /// Standard deviation of that, for adaptation to start from, 0.001 to 0.49. Default 0.05.
        /// </summary>
        public double TactileWeightSd;
        /// <summary>Variance of the user's motor command per step, 1e-9 to 1e4. Default 0.5.</summary>
        public double MotorVarianceDeg2;
        /// <summary>Variance of what the user feels per step, 1e-9 to 1e4. Default 0.1.</summary>
        public double SensoryVarianceDeg2;
        /// <summary>
        /// Variance of the user's perceived direction before the first step, 0 to 1e4. Default 0.
        /// </summary>
        public double InitialVarianceDeg2;
        /// <summary>
        /// White noise of each coordinate of a tracked position, standard deviation, 0 to 0.1; 0: learn it from
        /// the samples. Default 0.
        /// </summary>
        public double TrackerNoiseM;
        /// <summary>
        /// Where reaches start, in plate coordinates; target directions are measured from here, in the plane of
        /// the plate. Each within 1000. Default (0, 0, 0.05): on the mid-line, 5 cm towards the user.
        /// </summary>
        public HrtDouble3 StartPositionM;
        /// <summary>
        /// Beyond this from the plate's centre a position is off the plate, 0.001 to 1000. Default 0.075.
        /// </summary>
        public double PlateRadiusM;
        /// <summary>
        /// Higher than this above the plate a position is lifted, 0.0001 to 1000. Default 0.015.
        /// </summary>
        public double LiftHeightM;
        /// <summary>The plate's centre in the engine's world, each within 1000. Default (0, 0, 0).</summary>
        public HrtDouble3 PlatePositionM;
        /// <summary>
        /// How the plate's mount is turned in the world, as the unit quaternion x, y, z, w that takes plate
        /// coordinates to the world's axes. It does not turn with the ridges. Default (0, 0, 0, 1).
        /// </summary>
        public HrtDouble4 PlateRotation;
    }

    /// <summary>
    /// A target's id within its session. Zero is never a target. The id of a removed target is never valid
    /// again, in no session.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct HrtTarget
    {
        public ulong Value;
    }

    /// <summary>
    /// A target. hrt_target_config_default() fills every field. Fields that `place` does not name are not
    /// read.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct HrtTargetConfig
    {
        public uint StructSize;
        /// <summary>HRT_TARGET_*. Default HRT_TARGET_REAL.</summary>
        public uint Role;
        /// <summary>HRT_PLACE_*. Default HRT_PLACE_DIRECTION.</summary>
        public uint Place;
        public uint Reserved;
        /// <summary>Direction from the start, -180 to 180. Default 0.</summary>
        public double DirectionDeg;
        /// <summary>Distance from the start along the plate, 0.001 to 1000. Default 0.1.</summary>
        public double DistanceM;
        /// <summary>
        /// Place in plate coordinates or in the world, each within 1000; at least 1 mm from the start in the
        /// plane of the plate; the height y is kept and not used. Default (0, 0, 0).
        /// </summary>
        public HrtDouble3 PositionM;
        /// <summary>UTF-8, ended by a zero; unique within the session unless empty. Default empty.</summary>
        public HrtChar64 Name;
    }

    /// <summary>What can be held for one pair. Set `struct_size` before the call.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct HrtAuthority
    {
        public uint StructSize;
        /// <summary>1 if the finger can be held on the real target's direction, else 0.</summary>
        public uint Reachable;
        public HrtTarget RealTarget;
        public HrtTarget VirtualTarget;
        /// <summary>Virtual less real direction, in [-180, 180).</summary>
        public double GapDeg;
        /// <summary>
        /// The largest gap, either way, that can be held with the session's tactile weight and plate bound.
        /// </summary>
        public double LargestGapDeg;
        /// <summary>largest_gap_deg less the size of the gap; negative if out of reach.</summary>
        public double MarginDeg;
        /// <summary>Where the plate must stand to hold it; on its bound if out of reach.</summary>
        public double PlateOrientationDeg;
        /// <summary>Where the finger settles: the real target's direction if it can be held.</summary>
        public double SettlingDirectionDeg;
    }

    /// <summary>
    /// Where the library's memory comes from. The functions may be called from any thread, at the same
    /// time; they must not call this library, and must not throw.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct HrtAllocator
    {
        public uint StructSize;
        public uint Reserved;
        /// <summary>Passed to both functions; never read.</summary>
        public IntPtr Context;
        /// <summary>
        /// Returns `size` bytes (at least 1) at a multiple of `alignment` (a power of two), or null if it
        /// can't.
        /// </summary>
        public IntPtr Allocate;
        /// <summary>Takes back what allocate() returned.</summary>
        public IntPtr Release;
    }

    /// <summary>What a reach is. hrt_reach_config_default() fills every field.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct HrtReachConfig
    {
        public uint StructSize;
        /// <summary>HRT_REACH_*. Default 0.</summary>
        public uint Flags;
        /// <summary>
        /// Its direction and the virtual target's are less than 90 degrees apart. Default null: to be set.
        /// </summary>
        public HrtTarget RealTarget;
        public HrtTarget VirtualTarget;
        /// <summary>Where the plate stands before the reach, -360 to 360. Default 0.</summary>
        public double PlateOrientationDeg;
    }

    /// <summary>
    /// One sample of the tracked finger. Set it to zero, then `struct_size` and what is known. Fields that
    /// `flags` does not name are not read, whatever is in them.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct HrtSample
    {
        public uint StructSize;
        /// <summary>HRT_SAMPLE_*.</summary>
        public uint Flags;
        /// <summary>
        /// The caller's monotonic clock; any origin. Not before the last sample's; the same time again is
        /// taken.
        /// </summary>
        public long TimeNs;
        /// <summary>The direction in which the finger moves, -180 to 180; taken as exact.</summary>
        public double FingerDirectionDeg;
        /// <summary>The fingertip, each within 1000.</summary>
        public HrtDouble3 FingerPositionM;
        /// <summary>Where the plate stands, -360 to 360.</summary>
        public double PlateOrientationDeg;
        /// <summary>The plate in the world, as in hrt_session_config.</summary>
        public HrtDouble3 PlatePositionM;
        public HrtDouble4 PlateRotation;
    }

    /// <summary>What the plate is to do now, and why. Set `struct_size` before the call.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct HrtCommand
    {
        public uint StructSize;
        /// <summary>HRT_COMMAND_*.</summary>
        public uint Flags;
        /// <summary>The model step, from 0; -1 before the finger moves.</summary>
        public long Step;
        /// <summary>
        /// Turn the plate here. Ridges repeat every 180 degrees: of the orientations that feel the same this is
        /// the nearest that the plate's stops allow.
        /// </summary>
        public double PlateOrientationDeg;
        /// <summary>The finger's direction in the last step, observed or predicted.</summary>
        public double FingerDirectionDeg;
        /// <summary>The direction that the user feels, as the model predicts it under this command.</summary>
        public double PerceivedDirectionDeg;
        /// <summary>Where the finger is wanted; see hrt_session_config::guidance.</summary>
        public double AimedDirectionDeg;
        /// <summary>
        /// Along the plate to the real target; from the start until a position is streamed.
        /// </summary>
        public double DistanceToGoM;
        /// <summary>The share of touch that the controller assumes.</summary>
        public double TactileWeight;
        /// <summary>Its standard deviation; 0: it is taken as known.</summary>
        public double TactileWeightSd;
    }

    /// <summary>What became of a reach. Set `struct_size` before the call.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct HrtReachSummary
    {
        public uint StructSize;
        public uint Reserved;
        /// <summary>
        /// Samples taken in, and of these the dropouts and what was left out as an outlier.
        /// </summary>
        public long Samples;
        public long DroppedSamples;
        /// <summary>Model steps with samples, and steps without, which were predicted.</summary>
        public long Steps;
        public long PredictedSteps;
        /// <summary>
        /// Of the steps with samples, those whose command the plate's bound or its speed held.
        /// </summary>
        public long SaturatedSteps;
        public long RateLimitedSteps;
        /// <summary>The finger's direction in the last step, and that less the real target's.</summary>
        public double FinalDirectionDeg;
        public double FinalMissDeg;
        /// <summary>What the user felt in the last step, and that less the virtual target's.</summary>
        public double PerceivedDirectionDeg;
        public double PerceivedErrorDeg;
        /// <summary>
        /// From the last position along the plate to the real target; from the start if none was streamed.
        /// </summary>
        public double DistanceToTargetM;
        /// <summary>What the controller assumed at the end; see hrt_command.</summary>
        public double TactileWeight;
        public double TactileWeightSd;
        /// <summary>
        /// White noise of each coordinate of the tracked positions, standard deviation, as learnt or
        /// configured.
        /// </summary>
        public double TrackerNoiseM;
    }

    /// <summary>How a recording does. Set `struct_size` before the call.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct HrtRecordingStatus
    {
        public uint StructSize;
        /// <summary>
        /// The errno of the first write that failed, after which nothing more is written; 0: none did.
        /// </summary>
        public int SystemError;
        /// <summary>Calls recorded, as far as the operating system has taken them.</summary>
        public ulong RowsWritten;
        /// <summary>
        /// Calls that are not in the file, because the disk was too slow or failed. 0 at the end: it is
        /// complete.
        /// </summary>
        public ulong RowsLost;
    }

    /// <summary>What a replay found. Set `struct_size` before the call.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct HrtReplayReport
    {
        public uint StructSize;
        /// <summary>
        /// 1 if the recording is whole: it has its end, and no rows were lost; else 0, and what precedes the
        /// gap was replayed.
        /// </summary>
        public uint Complete;
        /// <summary>Rows replayed.</summary>
        public ulong Rows;
        /// <summary>
        /// The line of the file, from 1, of the first row that came out otherwise than recorded; 0: all came
        /// out the same, bit for bit.
        /// </summary>
        public ulong FirstDifferentLine;
        /// <summary>
        /// FNV-1a of the commands as replayed, which is the same on every host: of each row "update" without
        /// error, flags as 8 bytes, step, and the seven numbers after them, least significant byte first.
        /// </summary>
        public ulong Hash;
    }

    /// <summary>
    /// A scene's handle. Zero is never a scene. A handle of a destroyed scene is never valid again.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct HrtScene
    {
        public ulong Value;
    }

    /// <summary>The plate of a scene. Set `struct_size` before the call.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct HrtSceneInfo
    {
        public uint StructSize;
        /// <summary>How many targets the scene has, real and virtual.</summary>
        public uint TargetCount;
        /// <summary>The plate in the world, as in hrt_session_config.</summary>
        public HrtDouble3 PlatePositionM;
        public HrtDouble4 PlateRotation;
        public double PlateRadiusM;
        /// <summary>Of the plate's servo; 0 if the file does not tell.</summary>
        public double PlateMaxSpeedDegS;
        /// <summary>In plate coordinates.</summary>
        public HrtDouble3 StartPositionM;
    }

    /// <summary>A target of a scene. Set `struct_size` before the call.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct HrtSceneTarget
    {
        public uint StructSize;
        /// <summary>HRT_TARGET_*.</summary>
        public uint Role;
        /// <summary>
        /// Of a virtual target: the index of the real one that serves it; of a real one -1.
        /// </summary>
        public int ServedBy;
        public uint Reserved;
        /// <summary>In plate coordinates; y is the height above the plate.</summary>
        public HrtDouble3 PositionM;
        public HrtDouble3 WorldPositionM;
        /// <summary>Seen from the start, along the plate.</summary>
        public double DirectionDeg;
        public double DistanceM;
        /// <summary>0 if the file does not tell.</summary>
        public double RadiusM;
        public HrtChar64 Name;
    }

    /// <summary>
    /// Returns `size` bytes (at least 1) at a multiple of `alignment` (a power of two), or null if it
    /// can't.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public delegate IntPtr HrtAllocatorAllocate(IntPtr context, UIntPtr size, UIntPtr alignment);

    /// <summary>Takes back what allocate() returned.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public delegate void HrtAllocatorRelease(IntPtr context, IntPtr memory);

    /// <summary>
    /// Hears what no call can return, such as that a recording's disk is full. `text` is one line, valid
    /// during the call. Called from a thread of the library's own, never from within a call of the host's;
    /// must not call this library, and must not throw.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public delegate void HrtLogCallback(IntPtr context, uint level, IntPtr text);

    /// <summary>The C interface. Names and meanings are those of the C headers.</summary>
    public static class NativeMethods
    {
#if UNITY_IOS && !UNITY_EDITOR || UNITY_WEBGL && !UNITY_EDITOR
        public const string Library = "__Internal";
#else
        public const string Library = "haptic_retargeting";
#endif

        /// <summary>Version of these headers; hrt_get_version() tells that of the library.</summary>
        public const int HRT_VERSION_MAJOR = 0;
        public const int HRT_VERSION_MINOR = 1;
        public const int HRT_VERSION_PATCH = 0;
        public const int HRT_OK = 0;
        /// <summary>A pointer that must not be null was null.</summary>
        public const int HRT_ERROR_NULL_ARGUMENT = -1;
        /// <summary>
        /// The handle or id is null, was never given out, is of another session, or of something destroyed.
        /// </summary>
        public const int HRT_ERROR_INVALID_HANDLE = -2;
        /// <summary>
        /// `struct_size` is below the first version's, or bytes beyond what this library knows are not zero.
        /// </summary>
        public const int HRT_ERROR_STRUCT_SIZE = -3;
        /// <summary>A value is outside its documented range, not a number, or infinite.</summary>
        public const int HRT_ERROR_OUT_OF_RANGE = -4;
        /// <summary>
        /// Not now: for example an update without a reach, or a new configuration during one.
        /// </summary>
        public const int HRT_ERROR_WRONG_STATE = -5;
        /// <summary>Another thread is in a call on this session.</summary>
        public const int HRT_ERROR_BUSY = -6;
        /// <summary>The sample's time is before that of the sample before it.</summary>
        public const int HRT_ERROR_TIME_REVERSED = -7;
        public const int HRT_ERROR_OUT_OF_MEMORY = -8;
        /// <summary>There are as many of these as there can be.</summary>
        public const int HRT_ERROR_LIMIT_REACHED = -9;
        /// <summary>Nothing has this name.</summary>
        public const int HRT_ERROR_NOT_FOUND = -10;
        /// <summary>The caller's buffer cannot hold the answer.</summary>
        public const int HRT_ERROR_BUFFER_TOO_SMALL = -11;
        /// <summary>Another target of this session has this name.</summary>
        public const int HRT_ERROR_NAME_TAKEN = -12;
        /// <summary>The operating system refused: a file, a thread.</summary>
        public const int HRT_ERROR_SYSTEM = -13;
        /// <summary>A text is not what it should be; hrt_last_error() tells where.</summary>
        public const int HRT_ERROR_BAD_FORMAT = -14;
        /// <summary>A defect in this library; please report it with the text of hrt_last_error().</summary>
        public const int HRT_ERROR_INTERNAL = -99;
        /// <summary>hrt_log_callback: how bad it is.</summary>
        public const int HRT_LOG_WARNING = 1;
        public const int HRT_LOG_ERROR = 2;
        // hrt_reach_config::flags.
        /// <summary>
        /// `plate_orientation_deg` is given; without this the plate is where the session's last command left it
        /// (at first 0).
        /// </summary>
        public const uint HRT_REACH_PLATE_ORIENTATION = 1;
        // hrt_sample::flags: which fields hold something. With none of DIRECTION, PLATE_POSITION and
        // WORLD_POSITION the sample is a dropout: the plate is held, and the model predicts until the finger
        // is seen again. More than one of these is an error.
        /// <summary>finger_direction_deg</summary>
        public const uint HRT_SAMPLE_DIRECTION = 1;
        /// <summary>finger_position_m, in plate coordinates</summary>
        public const uint HRT_SAMPLE_PLATE_POSITION = 2;
        /// <summary>plate_orientation_deg, measured by the device</summary>
        public const uint HRT_SAMPLE_PLATE_ORIENTATION = 4;
        /// <summary>the finger is off the plate, and so feels nothing: the model waits</summary>
        public const uint HRT_SAMPLE_LIFTED = 8;
        /// <summary>finger_position_m, in the engine's world</summary>
        public const uint HRT_SAMPLE_WORLD_POSITION = 16;
        /// <summary>
        /// plate_position_m and plate_rotation: the plate has moved in the world; else it is where the
        /// session's configuration has it. Goes with WORLD_POSITION.
        /// </summary>
        public const uint HRT_SAMPLE_PLATE_POSE = 32;
        // hrt_command::flags.
        /// <summary>between steps: nothing new was decided in this call</summary>
        public const uint HRT_COMMAND_HELD = 1;
        /// <summary>the last step had no direction and was predicted</summary>
        public const uint HRT_COMMAND_PREDICTED = 2;
        /// <summary>the plate's bound holds the command</summary>
        public const uint HRT_COMMAND_SATURATED = 4;
        /// <summary>the plate's speed holds the command</summary>
        public const uint HRT_COMMAND_RATE_LIMITED = 8;
        /// <summary>the real direction cannot be held: see authority.h</summary>
        public const uint HRT_COMMAND_UNREACHABLE = 16;
        /// <summary>the finger is above the plate: the model waits</summary>
        public const uint HRT_COMMAND_LIFTED = 32;
        /// <summary>the finger is beyond the plate's edge</summary>
        public const uint HRT_COMMAND_OFF_PLATE = 64;
        /// <summary>Scenes that can be loaded at the same time in a process.</summary>
        public const int HRT_SCENES_MAX = 64;
        /// <summary>Sessions that can exist at the same time in a process.</summary>
        public const int HRT_SESSIONS_MAX = 64;
        // What decides the plate's orientation.
        /// <summary>the model-predictive controller</summary>
        public const int HRT_CONTROL_MPC = 0;
        /// <summary>none, as a baseline: the plate stays where it is told to</summary>
        public const int HRT_CONTROL_FIXED_PLATE = 1;
        // Where the finger is wanted.
        /// <summary>in the real target's direction from the start</summary>
        public const int HRT_GUIDANCE_FIXED_DIRECTION = 0;
        /// <summary>
        /// In the direction from where the finger is to where the real target is, held once less than a fifth
        /// of the path remains. Takes effect when positions are streamed.
        /// </summary>
        public const int HRT_GUIDANCE_LINE_OF_SIGHT = 1;
        // Whether the user's share of touch is learnt.
        /// <summary>no: tactile_weight is taken as known</summary>
        public const int HRT_ADAPTATION_OFF = 0;
        /// <summary>within each reach, from tactile_weight and its deviation</summary>
        public const int HRT_ADAPTATION_REACH = 1;
        /// <summary>
        /// As REACH; and what a reach has learnt becomes the configuration's tactile_weight and
        /// tactile_weight_sd, the latter no less than 0.01, as people change.
        /// </summary>
        public const int HRT_ADAPTATION_CARRIED = 2;
        /// <summary>Targets that a session can hold.</summary>
        public const int HRT_TARGETS_MAX = 1000000;
        /// <summary>Bytes of a name, with its terminating zero.</summary>
        public const int HRT_NAME_SIZE = 64;
        /// <summary>What a target is.</summary>
        public const int HRT_TARGET_REAL = 1;
        public const int HRT_TARGET_VIRTUAL = 2;
        // How a target's place is given.
        /// <summary>by `direction_deg` and `distance_m`</summary>
        public const int HRT_PLACE_DIRECTION = 1;
        /// <summary>by `position_m` in plate coordinates</summary>
        public const int HRT_PLACE_PLATE_POSITION = 2;
        /// <summary>
        /// By `position_m` in the engine's world; see hrt_session_config::plate_position_m.
        /// </summary>
        public const int HRT_PLACE_WORLD_POSITION = 3;

        /// <summary>
        /// The name of a result, such as "HRT_ERROR_BUSY"; "unknown result" for any other number. Never null;
        /// lives as long as the library. [any-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern IntPtr hrt_result_string(int result);

        /// <summary>
        /// What went wrong in this thread's last failed call, in English, in one line: the call, the argument,
        /// its value and what is allowed. Empty if none has failed. Never null; valid until the next failed
        /// call of this thread. [any-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern IntPtr hrt_last_error();

        /// <summary>
        /// The library's version. Within a major version there are only additions. Null pointers are skipped.
        /// [any-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern void hrt_get_version(ref uint outMajor, ref uint outMinor, ref uint outPatch);

        /// <summary>
        /// Fills `*out_config` with the defaults. `struct_size` is sizeof *out_config. [any-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_session_config_default(ref HrtSessionConfig outConfig, uint structSize);

        /// <summary>
        /// Makes a session. Errors: OUT_OF_RANGE naming the field, STRUCT_SIZE, LIMIT_REACHED, OUT_OF_MEMORY.
        /// [any-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_session_create(in HrtSessionConfig config, ref HrtSession outSession);

        /// <summary>Ends the session, its targets and a reach that is under way. [one-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_session_destroy(HrtSession session);

        /// <summary>
        /// The configuration in use. `out_config-&gt;struct_size` must be set. [one-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_session_get_config(HrtSession session, ref HrtSessionConfig outConfig);

        /// <summary>
        /// Replaces the configuration, between reaches; targets stay. Errors: as hrt_session_create(), and
        /// WRONG_STATE during a reach. [one-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_session_set_config(HrtSession session, in HrtSessionConfig config);

        /// <summary>
        /// Fills `*out_config` with the defaults. `struct_size` is sizeof *out_config. [any-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_target_config_default(ref HrtTargetConfig outConfig, uint structSize);

        /// <summary>
        /// Adds a target. Errors: OUT_OF_RANGE naming the field, NAME_TAKEN, LIMIT_REACHED, OUT_OF_MEMORY.
        /// [one-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_target_add(HrtSession session, in HrtTargetConfig config, ref HrtTarget outTarget);

        /// <summary>
        /// Changes a target; its id stays. A reach that is under way keeps the target as it was. Errors: as
        /// hrt_target_add(). [one-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_target_set(HrtSession session, HrtTarget target, in HrtTargetConfig config);

        /// <summary>
        /// What a target was last set to. `out_config-&gt;struct_size` must be set. [one-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_target_get(HrtSession session, HrtTarget target, ref HrtTargetConfig outConfig);

        /// <summary>
        /// Removes a target. A reach that is under way goes on with it as it was. [one-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_target_remove(HrtSession session, HrtTarget target);

        /// <summary>Finds a target by its name. Errors: NOT_FOUND. [one-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_target_find(HrtSession session, [In] byte[] name, ref HrtTarget outTarget);

        /// <summary>
        /// Lists the targets of a role (0: of both) in the order in which they were added. With `capacity` 0
        /// only counts them, and `out_targets` may be null. Errors: BUFFER_TOO_SMALL. [one-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_target_list(HrtSession session, uint role, uint capacity, [In, Out] HrtTarget[] outTargets, ref uint outCount);

        /// <summary>What can be held for a pair. [one-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_authority_query(HrtSession session, HrtTarget realTarget, HrtTarget virtualTarget, ref HrtAuthority outAuthority);

        /// <summary>
        /// What can be held for every pair, by virtual target and then by real one, in the order in which they
        /// were added. `out_authorities[0].struct_size` must be set and is the size of every element. With
        /// `capacity` 0 only counts the pairs, and `out_authorities` may be null. Errors: BUFFER_TOO_SMALL.
        /// [one-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_authority_query_all(HrtSession session, ulong capacity, [In, Out] HrtAuthority[] outAuthorities, ref ulong outCount);

        /// <summary>
        /// The real target that serves a virtual one with the greatest margin; of equals the one added first.
        /// It may still be out of reach. Errors: NOT_FOUND if there is no real target. [one-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_authority_query_best(HrtSession session, HrtTarget virtualTarget, ref HrtAuthority outAuthority);

        /// <summary>
        /// Has all memory come from `allocator` from now on; null: from the C library, as at first. The struct
        /// is copied. Errors: WRONG_STATE while the library holds memory, so while a session exists. [any-
        /// thread], but not while another thread is in any call of this library.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_set_allocator(in HrtAllocator allocator);

        /// <summary>
        /// Has `callback` called with `context` from now on; null: nobody, as at first. Errors and thread rule:
        /// as hrt_set_allocator().
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_set_log_callback(HrtLogCallback callback, IntPtr context);

        /// <summary>
        /// Writes the profile of the session's participant, UTF-8, and a zero after it, into `out_text`; its
        /// length without the zero into `*out_length`. With `capacity` 0 only tells the length, and `out_text`
        /// may be null. Errors: BUFFER_TOO_SMALL unless capacity is above the length. [one-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_profile_save(HrtSession session, ulong capacity, [Out] byte[] outText, ref ulong outLength);

        /// <summary>
        /// Takes a profile of `length` bytes into the session's configuration, between reaches. Fields that it
        /// lacks stay as they are; unknown ones are refused. Errors: BAD_FORMAT, OUT_OF_RANGE naming the field,
        /// WRONG_STATE during a reach. [one-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_profile_load(HrtSession session, [In] byte[] text, ulong length);

        /// <summary>
        /// Fills `*out_config` with the defaults. `struct_size` is sizeof *out_config. [any-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_reach_config_default(ref HrtReachConfig outConfig, uint structSize);

        /// <summary>
        /// Starts a reach. Errors: INVALID_HANDLE or OUT_OF_RANGE naming the target, WRONG_STATE during a
        /// reach. [real-time]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_reach_begin(HrtSession session, in HrtReachConfig config);

        /// <summary>
        /// Takes one sample in and tells what the plate is to do now. Samples may come at any rate. Directions
        /// move the controller once in a step period, positions at each sample, as they tell ever more of the
        /// step; in between the command is held. Steps that pass without samples are predicted, at most 64 in
        /// one call. Errors: WRONG_STATE without a reach, OUT_OF_RANGE naming the field, TIME_REVERSED. [real-
        /// time]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_reach_update(HrtSession session, in HrtSample sample, ref HrtCommand outCommand);

        /// <summary>Ends the reach. Errors: WRONG_STATE without a reach. [real-time]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_reach_end(HrtSession session, ref HrtReachSummary outSummary);

        /// <summary>
        /// Records the session from now on into a file, which is created or replaced. Errors: SYSTEM if it
        /// can't be created, WRONG_STATE during a reach or while recording, OUT_OF_MEMORY. [one-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_recording_start(HrtSession session, [In] byte[] path);

        /// <summary>How the recording does. Errors: WRONG_STATE if there is none. [real-time]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_recording_get_status(HrtSession session, ref HrtRecordingStatus outStatus);

        /// <summary>
        /// Writes what is left, closes the file and tells how it went; may wait for the disk. Destroying the
        /// session does this too. Errors: WRONG_STATE if there is no recording. [one-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_recording_stop(HrtSession session, ref HrtRecordingStatus outStatus);

        /// <summary>
        /// Runs the recorded calls again and compares. Errors: BAD_FORMAT naming the line. [any-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_replay_text([In] byte[] text, ulong length, ref HrtReplayReport outReport);

        /// <summary>
        /// The same of a file of at most 1 GiB. Errors: SYSTEM if it can't be read. [any-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_replay_file([In] byte[] path, ref HrtReplayReport outReport);

        /// <summary>
        /// Loads a .gltf or .glb file. Errors: BAD_FORMAT naming the file, the node and the property,
        /// LIMIT_REACHED. If memory runs out while a file is read, the process may end: the JSON library
        /// underneath allocates when it cleans up. [any-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_scene_load_file([In] byte[] path, ref HrtScene outScene);

        /// <summary>
        /// The same from memory, which is not used after the call. `name` stands for the file in error texts.
        /// [any-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_scene_load_memory([In] byte[] bytes, ulong length, [In] byte[] name, ref HrtScene outScene);

        /// <summary>
        /// Forgets the scene; what was registered from it stays. Errors of this and the calls below:
        /// INVALID_HANDLE, and BUSY if another thread is in a call on this scene. [one-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_scene_destroy(HrtScene scene);

        /// <summary>[one-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_scene_get_info(HrtScene scene, ref HrtSceneInfo outInfo);

        /// <summary>
        /// The target of an index below hrt_scene_info::target_count. Errors: OUT_OF_RANGE. [one-thread]
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_scene_get_target(HrtScene scene, uint index, ref HrtSceneTarget outTarget);

        /// <summary>
        /// Sets the session's plate, start and, if the file tells it, the servo's highest speed, and adds all
        /// targets by their place on the plate. Their ids go to `out_targets` in the order of the scene; it may
        /// be null if `capacity` is 0. Errors, at which nothing is added: BUFFER_TOO_SMALL, NAME_TAKEN,
        /// WRONG_STATE during a reach. [one-thread] for both.
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int hrt_scene_register(HrtScene scene, HrtSession session, uint capacity, [In, Out] HrtTarget[] outTargets);
    }
}
