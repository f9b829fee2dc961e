# Written by plugin/bindings/generate from the C headers.
"""The C interface as ctypes sees it. Meanings, units and ranges are those of the C headers."""

from __future__ import annotations

from ctypes import (
    CFUNCTYPE, POINTER, Array, c_char, c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint32, c_uint64, c_void_p,
)
from typing import TYPE_CHECKING, Annotated, Any

from ._struct import (
    Choice, Double, Flags, FunctionPointer, Int32, Int64, Pointer, Struct, UInt32, UInt64, laid_out,
)

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


VERSION = (0, 3, 0)
"""Of the headers that this was written from."""
ASSIGN_TARGETS_MAX = 1000
"""Maximum number of virtual targets, and of real ones, in hrt_target_assign()."""
OK = 0
CALIBRATIONS_MAX = 16
"""Maximum number of calibrations in a process."""
TOUCHES_MAX = 1000
"""Maximum number of touches in one call."""
POSE_COVARIANCES = 28
"""Numbers in the lower triangle of Registration.covariance."""
LATENCY_SAMPLES_MAX = 100000
"""Maximum number of samples in hrt_latency_fit()."""
SCENES_MAX = 64
"""Maximum number of scenes in a process."""
SESSIONS_MAX = 1024
"""Maximum number of sessions in a process."""
PERSON_WEIGHT = 0
"""w: slope of the felt shift w t - b t (t / 75)^2 over the plate's angle t"""
PERSON_CURVE = 1
"""b: 0 for a linear illusion"""
PERSON_GAIN = 2
"""rate at which they correct the direction they feel, 1/s"""
PERSON_BIAS = 3
"""goal minus virtual direction, degrees"""
PERSON_HABIT = 4
"""Curving: the goal's turn at the start, minus that at the end, halved, degrees."""
PERSON_EVENNESS = 5
"""of the pace: 0 minimum jerk, 1 even"""
PERSON_HEADING = 6
"""share of the goal's direction in which they set out"""
PERSON_LOG_RATE = 7
"""natural logarithm of one over a reach's duration in seconds"""
PERSON_FADING = 8
"""Share of touch that fades from one ridge to the next: 0 if all of the ridges is always felt, 1 if a
ridge is felt as it is crossed and then fades."""
PERSON_TRAITS = 9
"""Number of traits."""
PERSON_COVARIANCES = 45
"""Numbers in the lower triangle of their covariance."""
TARGETS_MAX = 1000000
"""Maximum number of targets in a session."""
NAME_SIZE = 64
"""Bytes of a name, including the terminating zero."""


__all__ = [
    "Adaptation", "Allocator", "AssignFlag", "Authority", "CalibrationComparison", "CalibrationConfig",
    "CalibrationResult", "CalibrationSlide", "Command", "CommandFlag", "ConditionFlag", "Conditions", "Control",
    "DiffersFlag", "Ending", "ErrorCode", "Fingertip", "Guidance", "Illusion", "Interval", "JointTouch",
    "LackOfFitFlag", "Latency", "LogLevel", "MarkTouch", "Place", "ReachConfig", "ReachFlag", "ReachSummary",
    "RecordingStatus", "RegisterFlag", "Registration", "RegistrationConfig", "RegistrationVerdict",
    "ReplayReport", "Role", "Sample", "SampleFlag", "SceneInfo", "SceneTarget", "SessionConfig", "SessionFlag",
    "Slide", "StateFlag", "TargetConfig", "TouchCheck",
]


class AssignFlag(Flags):
    """Flags of hrt_target_assign().

    EXCLUSIVE: A real target serves one virtual target at most. Otherwise it may serve any number.
    """

    EXCLUSIVE = 1


class ErrorCode(Choice):
    """OK or one of the errors below. Their numbers never change.

    NULL_ARGUMENT: A pointer that must not be null was null.
    INVALID_HANDLE: The handle or id is null, stale, of another session, or was never given out.
    STRUCT_SIZE: `struct_size` is below the first version's, or bytes that this library does not know are
        not zero.
    OUT_OF_RANGE: A value is outside its documented range, not a number, or infinite.
    WRONG_STATE: The call is not allowed now: for example an update without a reach.
    BUSY: Another thread is in a call on this session.
    TIME_REVERSED: The sample is older than the one before it.
    OUT_OF_MEMORY: An allocation failed.
    LIMIT_REACHED: The number of objects or samples is at its limit.
    NOT_FOUND: Nothing has this name.
    BUFFER_TOO_SMALL: The caller's buffer is too small for the output.
    NAME_TAKEN: Another target of this session has this name.
    SYSTEM: The operating system refused a file or a thread.
    BAD_FORMAT: A file or text is malformed. hrt_last_error() names the place.
    INSUFFICIENT_DATA: The data cannot determine the requested value. hrt_last_error() names what is
        missing.
    INTERNAL: A defect in this library. Please report it with the text of hrt_last_error().
    """

    NULL_ARGUMENT = -1
    INVALID_HANDLE = -2
    STRUCT_SIZE = -3
    OUT_OF_RANGE = -4
    WRONG_STATE = -5
    BUSY = -6
    TIME_REVERSED = -7
    OUT_OF_MEMORY = -8
    LIMIT_REACHED = -9
    NOT_FOUND = -10
    BUFFER_TOO_SMALL = -11
    NAME_TAKEN = -12
    SYSTEM = -13
    BAD_FORMAT = -14
    INSUFFICIENT_DATA = -15
    INTERNAL = -99


class Illusion(Choice):
    """Families of illusion curves: the felt shift over the offset t from the motion to the ridge normal.

    LINEAR: w t
    SATURATING: w t within the scale, constant beyond
    SINE: w 45 sin 2t
    TANH: w scale tanh(t / scale)
    DEAD_BAND: nothing within the scale, w (|t| - scale) beyond
    UNEQUAL: different slopes to the left and to the right
    CUBIC: w t - b t (t / 75)^2, the controller's model
    NONE: no family fits the slides
    """

    LINEAR = 0
    SATURATING = 1
    SINE = 2
    TANH = 3
    DEAD_BAND = 4
    UNEQUAL = 5
    CUBIC = 6
    NONE = 7


class LackOfFitFlag(Flags):
    """Patterns in what the fit leaves unexplained: CalibrationResult.lack_of_fit.

    ANGLE: Over the plate orientation: no curve fits. Check the plate's orientations and the goal direction.
    ORDER: Over the order of the slides: the user learns or tires. Let them practise or rest, and repeat.
    PATH: Along the paths: they bend as neither a habit nor the model's steering does. Ask for slower,
        longer and even slides, and repeat.
    """

    ANGLE = 1
    ORDER = 2
    PATH = 4


class Slide(Choice):
    """What became of a slide: CalibrationSlide.verdict.

    USED
    OUTLYING: unlike the others: left out
    ALONG_RIDGES: left out: the illusion flips along the ridges
    """

    USED = 0
    OUTLYING = 1
    ALONG_RIDGES = 2


class DiffersFlag(Flags):
    """Values of two calibrations that differ: CalibrationComparison.differing.

    TACTILE_WEIGHT
    MAX_GAP
    BIAS
    HABIT
    TRACKER_NOISE
    STEERING_RATE
    STEERING_DELAY
    """

    TACTILE_WEIGHT = 1
    MAX_GAP = 2
    BIAS = 4
    HABIT = 8
    TRACKER_NOISE = 16
    STEERING_RATE = 32
    STEERING_DELAY = 64


class LogLevel(Choice):
    """Level of a log message.

    WARNING
    ERROR
    """

    WARNING = 1
    ERROR = 2


class ConditionFlag(Flags):
    """How the conditions of the profile differ from those of now: Conditions.differing.

    PLATE
    TRACKER
    """

    PLATE = 1
    TRACKER = 2


class ReachFlag(Flags):
    """ReachConfig.flags.

    PLATE_ORIENTATION: `plate_orientation_deg` is given. Otherwise the plate is at the session's last
        command, at first 0.
    START_AT_FINGER: The reach starts where the finger is first seen, instead of at
        SessionConfig.start_position_m: directions and distances are measured from there. The plate stands
        ready for the configured start until then, and samples before it are not counted. In a reach of
        directions alone this has no effect. Since version 0.3.
    """

    PLATE_ORIENTATION = 1
    START_AT_FINGER = 2


class SampleFlag(Flags):
    """Sample.flags: the fields that are set. At most one of DIRECTION, PLATE_POSITION and WORLD_POSITION. With
    none of these and without LIFTED the sample is a dropout: the plate is held, and the model predicts.

    DIRECTION: finger_direction_deg
    PLATE_POSITION: finger_position_m, in plate coordinates
    PLATE_ORIENTATION: plate_orientation_deg, as measured
    LIFTED: the finger does not touch the plate: the model waits
    WORLD_POSITION: finger_position_m, in the engine's world
    PLATE_POSE: plate_position_m and plate_rotation, for WORLD_POSITION. Otherwise the session's
        configuration has them.
    """

    DIRECTION = 1
    PLATE_POSITION = 2
    PLATE_ORIENTATION = 4
    LIFTED = 8
    WORLD_POSITION = 16
    PLATE_POSE = 32


class CommandFlag(Flags):
    """Command.flags.

    HELD: no new decision: the former command is repeated
    PREDICTED: no sample in the last step; under ARRIVAL, none now
    SATURATED: the plate's bound or a stop limits the command
    RATE_LIMITED: the plate's speed limits the command
    UNREACHABLE: the plate cannot sustain the gap: see authority.h
    LIFTED: the finger does not touch the plate: the model waits
    OFF_PLATE: the finger is beyond the plate's edge
    MISFIT: The motion departs from the model more than its noise allows: the estimates, and UNREACHABLE,
        are not to be trusted.
    OFF_TARGET: The finger is going to end, or has ended, more than 1.5 degrees of bearing from the real
        target.
    RESTING: the finger rests within the reach: the plate is held
    APPROXIMATE: The solver's work was cut short; the command keeps its bounds.
    FAULT: A defect in this library: a value was not a finite number. The plate is held, and that value is
        0. The log says so once a session, when the session is next configured or destroyed.
    REGISTRATION: The plate's registration is older or worse than the configuration allows, or there is
        none: max_registration_age_ns, max_registration_sd_deg. Touch the marks again (registration.h). The
        log has it at the next call of hrt_session_set_config(), _destroy() or hrt_registration_apply().
    """

    HELD = 1
    PREDICTED = 2
    SATURATED = 4
    RATE_LIMITED = 8
    UNREACHABLE = 16
    LIFTED = 32
    OFF_PLATE = 64
    MISFIT = 128
    OFF_TARGET = 256
    RESTING = 512
    APPROXIMATE = 1024
    FAULT = 2048
    REGISTRATION = 4096


class Ending(Choice):
    """How a recording ends.

    COMPLETE: with its end line, and nothing was altered or lost
    CUT: without an end line: cut off, or the process ended while recording
    LOST_ROWS: at rows that a slow disk has lost: only those before were replayed
    ALTERED: with an end line whose checksum is not that of the text before it
    """

    COMPLETE = 0
    CUT = 1
    LOST_ROWS = 2
    ALTERED = 3


class RegisterFlag(Flags):
    """RegistrationConfig.flags.

    SCALE: The tracker's unit of length is fitted too: of use if it may be off by more than 1 in 100.
    UP: `up` is given. Without it, touches of which left and right were confused pass for those of a plate
        that lies upside down.
    """

    SCALE = 1
    UP = 2


class RegistrationVerdict(Choice):
    """Verdict on a set of touches. hrt_registration_advice() has what to do.

    HOLDS: a pose explains the touches, or all of them but one
    TOO_FEW: fewer than 3 touches
    DEGENERATE: the marks lie within 1 cm of a line: the plate could turn about it
    INCONSISTENT: no pose explains the touches, nor all of them but one
    UPSIDE_DOWN: the face looks away from `up`: marks were confused
    """

    HOLDS = 1
    TOO_FEW = 2
    DEGENERATE = 3
    INCONSISTENT = 4
    UPSIDE_DOWN = 5


class Control(Choice):
    """Source of the plate's commands.

    MPC: the model-predictive controller
    FIXED_PLATE: a plate that does not turn, as a baseline
    """

    MPC = 0
    FIXED_PLATE = 1


class Guidance(Choice):
    """What the controller steers the finger to, and so which controller it is.

    FIXED_DIRECTION: The real target's direction, seen from the start: the controller of the paper, for the
        person of its model.
    ARRIVAL: The real target's place, at arrival: the controller for people. It takes the pace of the
        motion, the whole curve of the illusion, bias, habits and the tracker's noise as unknown, and learns
        them. Needs positions: in a reach with directions alone this is FIXED_DIRECTION. Measured on
        simulated people only.
    LINE_OF_SIGHT: Name of ARRIVAL in version 0.2, whose line of sight it replaces.
    """

    FIXED_DIRECTION = 0
    ARRIVAL = 1
    LINE_OF_SIGHT = 1


class Adaptation(Choice):
    """Learning of the person: under GUIDANCE_ARRIVAL of all that person_mean holds, else of the tactile weight
    and the motor variance.

    OFF: tactile_weight and bias_deg are taken as known, the illusion as linear
    REACH: The person is learnt within each reach, which begins with what the configuration says of them.
    CARRIED: As REACH; the end of a reach also writes what it has learnt into the configuration, widened,
        because people change: person_mean and person_covariance, tactile_weight and its deviation. A reach
        that ends early or that the model does not fit (CommandFlag.MISFIT) writes nothing. Under
        FIXED_DIRECTION it writes tactile_weight and motor_variance_deg2; one reach changes the latter by a
        factor of 2 at most.
    """

    OFF = 0
    REACH = 1
    CARRIED = 2


class SessionFlag(Flags):
    """SessionConfig.flags.

    PLATE_WAITS: The plate stays where it stands until the finger moves. Otherwise it turns to where the
        first moment of the motion wants it as soon as a reach begins, which brings more fast reaches to the
        target. Set this if the finger rests on the ridges before a reach: a plate that turns under a
        resting finger is felt.
    REGISTERED: The plate's pose is from a registration made at registration_time_ns.
        hrt_registration_apply() sets this; hrt_scene_register(), which writes the scene's pose, clears it.
    """

    PLATE_WAITS = 1
    REGISTERED = 2


class StateFlag(Flags):
    """What a session is about: bits of hrt_session_get_state(). 0: idle, no reach can begin.

    READY: a real and a virtual target are there, and no reach is under way
    REACHING: a reach is under way
    CALIBRATING: A trial of a calibration that was created from this session is under way.
    RECORDING: the calls of the session are recorded
    """

    READY = 1
    REACHING = 2
    CALIBRATING = 4
    RECORDING = 8


class Role(Choice):
    """Role of a target.

    REAL: the hand is steered to it
    VIRTUAL: the user sees it and goes to it
    """

    REAL = 1
    VIRTUAL = 2


class Place(Choice):
    """How a target's place is given.

    DIRECTION: by `direction_deg` and `distance_m`
    PLATE_POSITION: by `position_m` in plate coordinates
    WORLD_POSITION: by `position_m` in the engine's world
    """

    DIRECTION = 1
    PLATE_POSITION = 2
    WORLD_POSITION = 3


AllocatorAllocate = CFUNCTYPE(c_void_p, c_void_p, c_size_t, c_size_t)
"""Returns `size` bytes (at least 1) at a multiple of `alignment` (a power of two), or null on failure."""
AllocatorRelease = CFUNCTYPE(None, c_void_p, c_void_p)
"""Releases memory that allocate() returned. As of free(), it gets no size: an allocator that needs it
keeps it beside the memory."""
LogCallback = CFUNCTYPE(None, c_void_p, c_uint32, c_char_p)
"""Receives what no call can return, for example that a recording's disk is full. `level` is LogLevel.
`text` is one line that names the session and, of a recording, the file; valid during the call. Called
on a thread of the library or within a call that is not real-time, one call at a time in the process. It
may not call this library or throw."""


@laid_out
class Allocator(Struct):
    """Source of the library's memory. Both functions are called from any thread, concurrently. Neither may
    call this library or throw.

    context: Passed to both functions. The library does not read it.
    allocate: Returns `size` bytes (at least 1) at a multiple of `alignment` (a power of two), or null on
        failure.
    release: Releases memory that allocate() returned. As of free(), it gets no size: an allocator that
        needs it keeps it beside the memory.
    """

    struct_size: UInt32
    reserved: UInt32
    context: Pointer
    allocate: Annotated[FunctionPointer, AllocatorAllocate]
    release: Annotated[FunctionPointer, AllocatorRelease]

    if TYPE_CHECKING:
        def __init__(
            self, *, context: int | None = ..., allocate: FunctionPointer = ..., release: FunctionPointer = ...,
        ) -> None: ...


@laid_out
class SessionHandle(Struct):
    """A session's handle. Zero is never a session. Handles are never reused.

    value
    """

    value: UInt64

    if TYPE_CHECKING:
        def __init__(
            self, *, value: int = ...,
        ) -> None: ...


@laid_out
class SessionConfig(Struct):
    """Configuration of a session.

    horizon: Steps that the controller plans ahead. With 1 most reaches miss; more than 3 changes little and
        costs time. 1 to 50. Default 3.
    step_period_ns: Duration of one step of the model and of the controller. The variances below are per
        step: scale them with it. 1 ms to 10 s. Default 100 ms.
    control: Control. Default Control.MPC.
    guidance: Guidance. Default Guidance.ARRIVAL.
    adaptation: Adaptation. Default Adaptation.CARRIED.
    flags: SessionFlag. Default 0. Named `reserved` before version 0.3.
    perceived_weight: Cost of the error that the user feels. Raising it keeps the felt direction closer to
        the virtual one and steers more slowly. 1e-6 to 1e6. Default 1.
    actual_weight: Cost of the finger's actual error. Raising it steers faster, with a larger felt error; 0
        steers not at all. 0 to 1e6. Default 1.
    plate_bound_deg: Maximum angle, modulo 180, between the plate orientation (base.h) and the virtual
        direction plus bias_deg. Raising it allows larger gaps; near 90 the ridges run along the motion and
        signal nothing. 0.1 to 90. Default 84.5.
    plate_max_speed_deg_s: Maximum speed of the plate's servo, within which the controller plans. 0 to 1e6
        degrees a second; 0: no limit. Default 0.
    plate_max_acceleration_deg_s2: Maximum acceleration of the servo, within which the controller plans. 0
        to 1e8 degrees a second squared; 0: no limit. Default 0.
    plate_latency_ns: Time from a command to the plate's first motion. The controller plans from where the
        plate will be by then. 0 to 1 s, and at most 8 step periods. Default 0.
    plate_lower_stop_deg: Mechanical stops, as plate orientations (base.h): no command lies beyond them.
        -3600 to 3600, the upper at least 180 above the lower; both 0: no stops. Default 0 and 0.
    plate_upper_stop_deg
    fixed_plate_orientation_deg: Plate orientation (base.h) under Control.FIXED_PLATE. With stops, the plate
        goes to the nearest orientation with the same ridges. -180 to 180. Default 0.
    tactile_weight: Share of touch in the direction that the user feels. At a higher weight, the same turn
        of the plate steers the hand further. Under GUIDANCE_ARRIVAL it is that of an illusion taken as
        linear, at 60 degrees; person_mean overrides it. 0.001 to 0.499. Default 0.2.
    tactile_weight_sd: Standard deviation of tactile_weight, from which adaptation starts. Raising it makes
        adaptation faster and less steady; under GUIDANCE_ARRIVAL it also makes the illusion's curve as
        uncertain in proportion. 0.001 to 0.49. Default 0.05.
    motor_variance_deg2: Variance of the user's motor command per step. Raising it makes the estimator
        follow the samples more closely. 1e-9 to 1e4. Default 0.5.
    sensory_variance_deg2: Variance of the felt direction per step. Raising it models a user who reacts to
        touch more slowly. 1e-9 to 1e4. Default 0.1.
    initial_variance_deg2: Variance of the user's felt direction before the first step. Raising it models a
        user who trusts touch more in the first steps. 0 to 1e4. Default 0.
    tracker_noise_m: Standard deviation of white noise in each tracked coordinate; under GUIDANCE_ARRIVAL of
        all noise, unless tracker_correlated_noise_m says how much of it is correlated. Raising it smooths
        positions more. 0 to 0.1, less than 1e-9 as 1e-9; 0: learnt from the samples. Default 0.
    start_position_m: Start of reaches in plate coordinates. Directions of targets are measured from here.
        Each within 1000. Default (0, 0, 0.05): on the mid-line, 5 cm towards the user.
    plate_radius_m: Radius of the plate: positions beyond it get CommandFlag.OFF_PLATE. 0.001 to 1000.
        Default 0.075.
    lift_height_m: Height above the plate: positions above it count as lifted. 0.0001 to 1000. Default
        0.015.
    plate_position_m: Centre of the plate in the engine's world. Each within 1000. Default (0, 0, 0).
    plate_rotation: Rotation of the plate's mount in the world: the unit quaternion x, y, z, w from plate
        coordinates to the world's axes. It does not turn with the ridges. Length 1 within 0.001. Default
        (0, 0, 0, 1).
    bias_deg: Perceptual bias: perceived minus true direction of a virtual target. The user goes to the
        virtual direction plus this bias. Found by calibration.h; GUIDANCE_ARRIVAL learns the rest. -45 to
        45. Default 0. Since version 0.2.
    motor_variance_sd_deg2: Standard deviation of motor_variance_deg2, from which adaptation starts. Raising
        it makes adaptation faster and less steady. 0.001 to 10. Default 0.5. Since version 0.2.
    max_felt_error_deg: Largest felt error that GUIDANCE_ARRIVAL asks the plate for: felt minus intended
        direction, as predicted. Lowering it keeps the illusion less noticeable and reaches somewhat fewer
        targets: of simulated people, 3.5 costs about 2 reaches in 100. What the person adds, by noise or by
        being other than estimated, comes on top. 0.1 to 45. Default 5. Since version 0.3.
    motion_bound_deg: Largest angle between the plate orientation and the finger's direction under
        GUIDANCE_ARRIVAL. Raising it allows larger gaps for people whose illusion still grows there;
        published data cover 60. Never beyond the peak of the person's illusion. 1 to 89. Default 75. Since
        version 0.3.
    tracker_latency_ns: Time from a motion to the time_ns of its sample, under GUIDANCE_ARRIVAL. 0 to 0.5 s.
        Default 0. Since version 0.3.
    person_mean: What is believed of the person under GUIDANCE_ARRIVAL: PERSON_*. Read if person_covariance
        is not 0: then the weight in 0.01 to 0.6, the curve -0.1 to 0.5, the gain 3 to 20, the bias -90 to
        90, the habit -45 to 45, the evenness 0 to 1, the heading -2 to 2, the logarithm of the rate -3 to
        2.4, the fading -0.2 to 1. Default 0. Since version 0.3.
    person_covariance: Covariance of person_mean: the lower triangle, row by row; positive definite, up to
        1e4. All 0: an unknown person, of whom only tactile_weight, tactile_weight_sd and bias_deg are read.
        Default 0. Since version 0.3.
    plate_scale: Length in the engine's world of 1 m on the plate: other than 1 if the tracker's unit is
        off. Divides positions and targets in the world, as seen from the plate's centre. 0.5 to 2. Default
        1. This and the following: since version 0.3.
    plate_covariance: Covariance of the plate's pose in its own plane, wherever the pose comes from: its
        turn about its normal (radians, counter-clockwise) and its centre's place to the right and away
        (metres); the lower triangle, row by row. Variances 0 to 1. All 0: the pose is exact. Under
        GUIDANCE_ARRIVAL it goes into UNREACHABLE and bearing_error_sd_deg; where the plate leads does not
        depend on it. Default 0.
    registration_time_ns: When the plate was registered, on the clock of the samples; read if
        SessionFlag.REGISTERED. Default 0.
    max_registration_age_ns: Largest age of a registration at a sample. Older ones, and a session without
        SessionFlag.REGISTERED, get CommandFlag.REGISTRATION. 0: not checked. Default 0.
    max_registration_sd_deg: Largest standard deviation that plate_covariance may give the bearing of the
        real target. Worse ones, and a session without SessionFlag.REGISTERED, get CommandFlag.REGISTRATION.
        0 to 180; 0: not checked. Default 0.
    tracker_correlated_noise_m: Standard deviation of the correlated part of the tracker's noise in each
        coordinate, under GUIDANCE_ARRIVAL; tracker_noise_m is then the white part alone. Found by
        calibration.h. 0 to 0.1; 0: not known. Default 0.
    tracker_correlation_s: Time in which that part decays to 1/e; read if it is not 0. 0.01 to 2 s. Default
        0.1.
    steering_rate_per_s: Rate at which the person corrects an error that they feel. Found by calibration.h,
        kept in the profile; the controller does not read it, as it gains nothing by it. 0 to 50 1/s; 0: not
        known. Default 0.
    steering_delay_s: Time from what the person feels to their answer, kept likewise. 0 to 0.5 s; 0: not
        known. Default 0.
    """

    struct_size: UInt32
    horizon: UInt32
    step_period_ns: Int64
    control: Control
    guidance: Guidance
    adaptation: Adaptation
    flags: SessionFlag
    perceived_weight: Double
    actual_weight: Double
    plate_bound_deg: Double
    plate_max_speed_deg_s: Double
    plate_max_acceleration_deg_s2: Double
    plate_latency_ns: Int64
    plate_lower_stop_deg: Double
    plate_upper_stop_deg: Double
    fixed_plate_orientation_deg: Double
    tactile_weight: Double
    tactile_weight_sd: Double
    motor_variance_deg2: Double
    sensory_variance_deg2: Double
    initial_variance_deg2: Double
    tracker_noise_m: Double
    start_position_m: Annotated[Array[c_double], c_double * 3]
    plate_radius_m: Double
    lift_height_m: Double
    plate_position_m: Annotated[Array[c_double], c_double * 3]
    plate_rotation: Annotated[Array[c_double], c_double * 4]
    bias_deg: Double
    motor_variance_sd_deg2: Double
    max_felt_error_deg: Double
    motion_bound_deg: Double
    tracker_latency_ns: Int64
    person_mean: Annotated[Array[c_double], c_double * 9]
    person_covariance: Annotated[Array[c_double], c_double * 45]
    plate_scale: Double
    plate_covariance: Annotated[Array[c_double], c_double * 6]
    registration_time_ns: Int64
    max_registration_age_ns: Int64
    max_registration_sd_deg: Double
    tracker_correlated_noise_m: Double
    tracker_correlation_s: Double
    steering_rate_per_s: Double
    steering_delay_s: Double

    if TYPE_CHECKING:
        def __init__(
            self, *, horizon: int = ..., step_period_ns: int = ..., control: Control = ..., guidance: Guidance = ...,
            adaptation: Adaptation = ..., flags: SessionFlag = ..., perceived_weight: float = ...,
            actual_weight: float = ..., plate_bound_deg: float = ..., plate_max_speed_deg_s: float = ...,
            plate_max_acceleration_deg_s2: float = ..., plate_latency_ns: int = ...,
            plate_lower_stop_deg: float = ..., plate_upper_stop_deg: float = ...,
            fixed_plate_orientation_deg: float = ..., tactile_weight: float = ..., tactile_weight_sd: float = ...,
            motor_variance_deg2: float = ..., sensory_variance_deg2: float = ..., initial_variance_deg2: float = ...,
            tracker_noise_m: float = ..., start_position_m: ArrayLike = ..., plate_radius_m: float = ...,
            lift_height_m: float = ..., plate_position_m: ArrayLike = ..., plate_rotation: ArrayLike = ...,
            bias_deg: float = ..., motor_variance_sd_deg2: float = ..., max_felt_error_deg: float = ...,
            motion_bound_deg: float = ..., tracker_latency_ns: int = ..., person_mean: ArrayLike = ...,
            person_covariance: ArrayLike = ..., plate_scale: float = ..., plate_covariance: ArrayLike = ...,
            registration_time_ns: int = ..., max_registration_age_ns: int = ..., max_registration_sd_deg: float = ...,
            tracker_correlated_noise_m: float = ..., tracker_correlation_s: float = ...,
            steering_rate_per_s: float = ..., steering_delay_s: float = ...,
        ) -> None: ...


@laid_out
class TargetHandle(Struct):
    """A target's id within its session. Zero is never a target. Ids are never reused, in any session.

    value
    """

    value: UInt64

    if TYPE_CHECKING:
        def __init__(
            self, *, value: int = ...,
        ) -> None: ...


@laid_out
class TargetConfig(Struct):
    """A target. Only the fields that `place` names are read.

    role: Role. Default Role.REAL.
    place: Place. Default Place.DIRECTION.
    direction_deg: Direction from the start (base.h), -180 to 180. Default 0.
    distance_m: Distance from the start along the plate, 0.001 to 1000. Default 0.1.
    position_m: Place in plate coordinates or in the world, at least 1 mm from the start in the plane of the
        plate; the height y has no effect. Each within 1000. Default (0, 0, 0).
    name: UTF-8, terminated by a zero; unique within the session unless empty. Default empty.
    """

    struct_size: UInt32
    role: Role
    place: Place
    reserved: UInt32
    direction_deg: Double
    distance_m: Double
    position_m: Annotated[Array[c_double], c_double * 3]
    name: Annotated[bytes, c_char * 64]

    if TYPE_CHECKING:
        def __init__(
            self, *, role: Role = ..., place: Place = ..., direction_deg: float = ..., distance_m: float = ...,
            position_m: ArrayLike = ..., name: str | bytes = ...,
        ) -> None: ...


@laid_out
class Authority(Struct):
    """Authority over one pair of targets.

    reachable: 1 if the plate can keep the finger on the real target's direction, else 0.
    real_target
    virtual_target
    gap_deg: The virtual direction plus the person's bias, minus the real direction; in [-180, 180).
    max_gap_deg: Largest gap, to either side, that the plate can sustain for the session's person and
        guidance.
    margin_deg: max_gap_deg minus the size of the gap; negative: unreachable.
    plate_orientation_deg: Plate orientation (base.h) that sustains the gap; at the bound if unreachable.
    settling_direction_deg: Direction in which the finger settles: the real target's, if reachable.
    paper_max_gap_deg: max_gap_deg as the paper has it, from tactile_weight and plate_bound_deg. Since
        version 0.3.
    """

    struct_size: UInt32
    reachable: UInt32
    real_target: TargetHandle
    virtual_target: TargetHandle
    gap_deg: Double
    max_gap_deg: Double
    margin_deg: Double
    plate_orientation_deg: Double
    settling_direction_deg: Double
    paper_max_gap_deg: Double

    if TYPE_CHECKING:
        def __init__(
            self, *, reachable: bool | int = ..., real_target: TargetHandle = ..., virtual_target: TargetHandle = ...,
            gap_deg: float = ..., max_gap_deg: float = ..., margin_deg: float = ...,
            plate_orientation_deg: float = ..., settling_direction_deg: float = ..., paper_max_gap_deg: float = ...,
        ) -> None: ...


@laid_out
class ReachConfig(Struct):
    """Configuration of a reach.

    flags: ReachFlag. Default 0.
    real_target: Target of the hand, less than 90 degrees from the virtual direction plus
        SessionConfig.bias_deg. Default null: to be set.
    virtual_target: Target that the user goes to. Default null: to be set.
    plate_orientation_deg: Plate orientation (base.h) before the reach, clamped to the stops. -3600 to 3600.
        Default 0.
    duration_s: Expected duration of the motion under GUIDANCE_ARRIVAL, if the host knows it; it is learnt
        from the finger's progress otherwise. 0.1 to 20 s; 0: unknown. Default 0. Since version 0.3.
    """

    struct_size: UInt32
    flags: ReachFlag
    real_target: TargetHandle
    virtual_target: TargetHandle
    plate_orientation_deg: Double
    duration_s: Double

    if TYPE_CHECKING:
        def __init__(
            self, *, flags: ReachFlag = ..., real_target: TargetHandle = ..., virtual_target: TargetHandle = ...,
            plate_orientation_deg: float = ..., duration_s: float = ...,
        ) -> None: ...


@laid_out
class Sample(Struct):
    """One sample of the tracked finger. Set it to zero, then set `struct_size` and the known fields. Only the
    fields that `flags` names are read.

    flags: SampleFlag.
    time_ns: The caller's monotonic clock, with any origin; never less than the last sample's.
    finger_direction_deg: Direction in which the finger moves, taken as exact. -180 to 180.
    finger_position_m: Position of the fingertip. Each within 1000.
    plate_orientation_deg: Measured plate orientation (base.h). With stops it is taken as measured. Without
        stops half turns do not count: the model takes the orientation with the same ridges that is nearest
        to the expected one. -3600 to 3600.
    plate_position_m: Pose of the plate in the world; see SessionConfig.
    plate_rotation
    """

    struct_size: UInt32
    flags: SampleFlag
    time_ns: Int64
    finger_direction_deg: Double
    finger_position_m: Annotated[Array[c_double], c_double * 3]
    plate_orientation_deg: Double
    plate_position_m: Annotated[Array[c_double], c_double * 3]
    plate_rotation: Annotated[Array[c_double], c_double * 4]

    if TYPE_CHECKING:
        def __init__(
            self, *, flags: SampleFlag = ..., time_ns: int = ..., finger_direction_deg: float = ...,
            finger_position_m: ArrayLike = ..., plate_orientation_deg: float = ..., plate_position_m: ArrayLike = ...,
            plate_rotation: ArrayLike = ...,
        ) -> None: ...


@laid_out
class Command(Struct):
    """Command for the plate, and its reasons.

    flags: CommandFlag.
    step: Model step, from 0; -1 before the finger moves.
    plate_orientation_deg: Plate orientation (base.h) to turn to now. Of the orientations with the same
        ridges between the stops it is the nearest one, if the configured speed and acceleration are
        unlimited. Otherwise the plate stays in one half turn for the whole reach, limited by the stops.
    finger_direction_deg: Direction of the finger in the last step, observed or predicted.
    perceived_direction_deg: Direction that the user feels under this command, as the model predicts it.
    aimed_direction_deg: Direction to which the finger is steered; see SessionConfig.guidance.
    distance_to_go_m: Distance along the plate to the real target; from the start until the first position.
    tactile_weight: Tactile weight that the controller assumes.
    tactile_weight_sd: Standard deviation of tactile_weight; 0: taken as known.
    time_to_go_s: Predicted time until the motion ends; 0 before it begins, and under FIXED_DIRECTION. Since
        version 0.3.
    felt_error_deg: Felt minus intended direction now, as estimated: what the person could notice. For
        visual redirection about 4.5 is noticed; no threshold is published for touch. 0 under
        FIXED_DIRECTION. Since version 0.3.
    predicted_miss_deg: Predicted bearing of the place of arrival, seen from the start, minus the real
        target's; 0 under FIXED_DIRECTION. Since version 0.3.
    normalised_innovation: Normalised innovation squared of the last positions, mean over about twenty:
        about 2 if the model fits, MISFIT from 4.5. 0 under FIXED_DIRECTION. Since version 0.3.
    bearing_error_sd_deg: Standard deviation of the finger's true place across the line to the real target,
        as a bearing from the start: by what the estimator knows of the place and by plate_covariance. At
        the end, of bearing_error_deg. 0 under FIXED_DIRECTION. Since version 0.3.
    """

    struct_size: UInt32
    flags: CommandFlag
    step: Int64
    plate_orientation_deg: Double
    finger_direction_deg: Double
    perceived_direction_deg: Double
    aimed_direction_deg: Double
    distance_to_go_m: Double
    tactile_weight: Double
    tactile_weight_sd: Double
    time_to_go_s: Double
    felt_error_deg: Double
    predicted_miss_deg: Double
    normalised_innovation: Double
    bearing_error_sd_deg: Double

    if TYPE_CHECKING:
        def __init__(
            self, *, flags: CommandFlag = ..., step: int = ..., plate_orientation_deg: float = ...,
            finger_direction_deg: float = ..., perceived_direction_deg: float = ..., aimed_direction_deg: float = ...,
            distance_to_go_m: float = ..., tactile_weight: float = ..., tactile_weight_sd: float = ...,
            time_to_go_s: float = ..., felt_error_deg: float = ..., predicted_miss_deg: float = ...,
            normalised_innovation: float = ..., bearing_error_sd_deg: float = ...,
        ) -> None: ...


@laid_out
class ReachSummary(Struct):
    """Result of a reach.

    flags: CommandFlag: UNREACHABLE at the end, MISFIT and REGISTRATION at any time, OFF_TARGET of where the
        finger ended, FAULT. Named `reserved` before version 0.3.
    samples: Samples, and those of them that were dropouts or rejected as outliers.
    dropped_samples
    steps: Model steps with samples, and predicted steps without. Under ARRIVAL the steps before the motion
        was seen count as predicted.
    predicted_steps
    saturated_steps: Steps with samples in which the plate's bound or a stop, or its speed, limited the
        command; its speed under FIXED_DIRECTION alone.
    rate_limited_steps
    final_direction_deg: Direction of the finger in the last step, and that direction minus the real
        target's.
    final_miss_deg
    perceived_direction_deg: Direction that the user felt in the last step, and that direction minus the
        virtual target's and the user's bias as it was known before the reach.
    perceived_error_deg
    distance_to_target_m: Distance along the plate from the last position to the real target; from the start
        without positions.
    tactile_weight: Tactile weight and deviation at the end; see Command.
    tactile_weight_sd
    tracker_noise_m: Standard deviation of noise in each tracked coordinate, learnt or configured: of white
        noise, and under ARRIVAL of all noise.
    motor_variance_deg2: Motor variance: the configured one, corrected by this reach. Since version 0.2.
    motor_variance_sd_deg2: Standard deviation of motor_variance_deg2; close to the configured one if the
        reach had too little data; 0: taken as known. Since version 0.2.
    bearing_error_deg: Bearing of the last position, seen from the start, minus the real target's; 0 without
        positions, or if the finger never moved, which distance_to_target_m shows. This and the following: 0
        under FIXED_DIRECTION, since version 0.3.
    peak_felt_error_deg: Largest size of Command.felt_error_deg, and its root mean square while the finger
        moved.
    rms_felt_error_deg
    normalised_innovation: Largest Command.normalised_innovation.
    illusion_curve: What the reach says of the person (PERSON_*), each with its standard deviation. An
        illusion_curve of more than 2 deviations says that the illusion is not linear, and tactile_weight
        holds at 60 degrees only.
    illusion_curve_sd
    gain_per_s
    gain_sd_per_s
    bias_deg
    bias_sd_deg
    habit_deg
    habit_sd_deg
    duration_s: Duration of the motion, as estimated.
    bearing_error_sd_deg: The last Command.bearing_error_sd_deg: standard deviation of bearing_error_deg.
    """

    struct_size: UInt32
    flags: CommandFlag
    samples: Int64
    dropped_samples: Int64
    steps: Int64
    predicted_steps: Int64
    saturated_steps: Int64
    rate_limited_steps: Int64
    final_direction_deg: Double
    final_miss_deg: Double
    perceived_direction_deg: Double
    perceived_error_deg: Double
    distance_to_target_m: Double
    tactile_weight: Double
    tactile_weight_sd: Double
    tracker_noise_m: Double
    motor_variance_deg2: Double
    motor_variance_sd_deg2: Double
    bearing_error_deg: Double
    peak_felt_error_deg: Double
    rms_felt_error_deg: Double
    normalised_innovation: Double
    illusion_curve: Double
    illusion_curve_sd: Double
    gain_per_s: Double
    gain_sd_per_s: Double
    bias_deg: Double
    bias_sd_deg: Double
    habit_deg: Double
    habit_sd_deg: Double
    duration_s: Double
    bearing_error_sd_deg: Double

    if TYPE_CHECKING:
        def __init__(
            self, *, flags: CommandFlag = ..., samples: int = ..., dropped_samples: int = ..., steps: int = ...,
            predicted_steps: int = ..., saturated_steps: int = ..., rate_limited_steps: int = ...,
            final_direction_deg: float = ..., final_miss_deg: float = ..., perceived_direction_deg: float = ...,
            perceived_error_deg: float = ..., distance_to_target_m: float = ..., tactile_weight: float = ...,
            tactile_weight_sd: float = ..., tracker_noise_m: float = ..., motor_variance_deg2: float = ...,
            motor_variance_sd_deg2: float = ..., bearing_error_deg: float = ..., peak_felt_error_deg: float = ...,
            rms_felt_error_deg: float = ..., normalised_innovation: float = ..., illusion_curve: float = ...,
            illusion_curve_sd: float = ..., gain_per_s: float = ..., gain_sd_per_s: float = ...,
            bias_deg: float = ..., bias_sd_deg: float = ..., habit_deg: float = ..., habit_sd_deg: float = ...,
            duration_s: float = ..., bearing_error_sd_deg: float = ...,
        ) -> None: ...


@laid_out
class CalibrationHandle(Struct):
    """A calibration's handle. Zero is never a calibration. Handles are never reused.

    value
    """

    value: UInt64

    if TYPE_CHECKING:
        def __init__(
            self, *, value: int = ...,
        ) -> None: ...


@laid_out
class CalibrationConfig(Struct):
    """Configuration of a calibration.

    max_trials: Maximum number of trials. 10 to 10000. Default 200.
    max_samples: Maximum number of samples of all trials; each takes 32 bytes at creation. 100 to 1000000.
        Default 100000: 18 minutes at 90 Hz.
    goal_direction_deg: Direction of the user's target. -180 to 180. Default 0: straight ahead, where the
        motor variance is accurate.
    lower_plate_deg: Range of the plate orientations that hrt_calibration_next_angle() chooses from,
        relative to the goal direction. -89 to 89, the upper at least 40 above the lower. Default -75 and
        75. Since version 0.3.
    upper_plate_deg
    enough_weight_width: Width of the 95 % interval of the tactile weight at which
        hrt_calibration_next_angle() reports enough slides. Lowering it asks for more. 0.001 to 0.5. Default
        0.02. Since version 0.3.
    """

    struct_size: UInt32
    max_trials: UInt32
    max_samples: UInt32
    reserved: UInt32
    goal_direction_deg: Double
    lower_plate_deg: Double
    upper_plate_deg: Double
    enough_weight_width: Double

    if TYPE_CHECKING:
        def __init__(
            self, *, max_trials: int = ..., max_samples: int = ..., goal_direction_deg: float = ...,
            lower_plate_deg: float = ..., upper_plate_deg: float = ..., enough_weight_width: float = ...,
        ) -> None: ...


@laid_out
class Interval(Struct):
    """An estimate with the ends of its 95 % interval. This struct never grows.

    value
    lower
    upper
    known: 1; or 0: the data cannot determine the value. Then the interval is the range that was searched,
        and the value its likeliest point.
    """

    value: Double
    lower: Double
    upper: Double
    known: UInt32
    reserved: UInt32

    if TYPE_CHECKING:
        def __init__(
            self, *, value: float = ..., lower: float = ..., upper: float = ..., known: bool | int = ...,
        ) -> None: ...


@laid_out
class CalibrationResult(Struct):
    """Parameters of the user; the fields are those of SessionConfig.

    slides_turning: Trials with a slide within which the plate turned by more than 5 degrees: they show the
        steering alone, and are not among trials_used. Named `reserved` before version 0.3.
    trials: Ended trials, and those of them with a slide of at least 30 mm over a plate at rest.
    trials_used
    tactile_weight: Felt shift over the offset of the ridge normal from the motion, at 60 degrees, mean of
        both sides. Known unless lack_of_fit is set or the interval is wider than 0.1. Of the share of touch
        that is felt at the slides' speed: people who feel ridges only as they cross them feel more at a
        higher one.
    bias_deg: Goal at the middle of the path minus target direction, left positive. Known unless lack_of_fit
        is set or the interval is wider than 10 degrees.
    motor_variance_deg2: Never known since version 0.3: slides of people who steer continuously look as
        those of the paper's person with other variances. The value is the likeliest of the paper's person.
    sensory_variance_deg2: As motor_variance_deg2.
    tracker_noise_m: Of the white part of the tracker's noise. Known with enough samples of the finger at
        rest, unless the parts of the noise may decay within 1.5 samples, which cannot be separated.
    illusion: Illusion, the likeliest family; LINEAR without a test with fewer than 7 plate orientations.
        Since version 0.3, as all fields below.
    lack_of_fit: LackOfFitFlag; 0: none was found, each at 1 % of people whom the model fits.
    slides_outlying: Slides that were left out: unlike the others, or with the motion within 5 to 12 degrees
        of along the ridges. hrt_calibration_get_residual() names them.
    slides_along_ridges
    illusion_scale_deg: Scale of the likeliest family, degrees; 0 if it has none.
    peak_offset_deg: Smallest offset at which the illusion is largest, 1 to 75: the motion bound for this
        user.
    person_weight: w and b of the controller's curve (PERSON_WEIGHT, PERSON_CURVE), and their correlation.
        The curve is known with 7 plate orientations or more.
    person_curve
    weight_curve_correlation
    max_gap_deg: Largest gap between real and virtual direction that can be held, on the weaker side, with
        the plate within 75 degrees of the motion. Known if the curve is, slides reach offsets of 60 to both
        sides, and the interval is at most 10 degrees wide.
    habit_deg: How far the user's goal turns over a path, halved (PERSON_HABIT). Known as bias_deg.
    correlated_noise_m: Correlated part of the tracker's noise, and the time in which it decays to 1/e.
    noise_correlation_s
    angle_p: Probabilities of residuals as patterned as these if the model fits: over the plate orientation,
        the order of the slides, the path.
    order_p
    path_p
    steering_rate_per_s: Rate at which the user corrects an error that they feel, 1/s, and the time from
        feeling to answer, with the tracker's latency and the arm's lag. Known with 6 turning slides or more
        unless lack_of_fit is set, steering_p is below 0.01, the rate's interval spans a factor above 2.5,
        or the delay's is wider than 0.1 s.
    steering_delay_s
    steering_p: As path_p, of the turning slides under the likeliest law of steering; 1 without such slides.
    """

    struct_size: UInt32
    slides_turning: UInt32
    trials: UInt32
    trials_used: UInt32
    tactile_weight: Interval
    bias_deg: Interval
    motor_variance_deg2: Interval
    sensory_variance_deg2: Interval
    tracker_noise_m: Interval
    illusion: Illusion
    lack_of_fit: LackOfFitFlag
    slides_outlying: UInt32
    slides_along_ridges: UInt32
    illusion_scale_deg: Double
    peak_offset_deg: Double
    person_weight: Interval
    person_curve: Interval
    weight_curve_correlation: Double
    max_gap_deg: Interval
    habit_deg: Interval
    correlated_noise_m: Interval
    noise_correlation_s: Interval
    angle_p: Double
    order_p: Double
    path_p: Double
    steering_rate_per_s: Interval
    steering_delay_s: Interval
    steering_p: Double

    if TYPE_CHECKING:
        def __init__(
            self, *, slides_turning: int = ..., trials: int = ..., trials_used: int = ...,
            tactile_weight: Interval = ..., bias_deg: Interval = ..., motor_variance_deg2: Interval = ...,
            sensory_variance_deg2: Interval = ..., tracker_noise_m: Interval = ..., illusion: Illusion = ...,
            lack_of_fit: LackOfFitFlag = ..., slides_outlying: int = ..., slides_along_ridges: int = ...,
            illusion_scale_deg: float = ..., peak_offset_deg: float = ..., person_weight: Interval = ...,
            person_curve: Interval = ..., weight_curve_correlation: float = ..., max_gap_deg: Interval = ...,
            habit_deg: Interval = ..., correlated_noise_m: Interval = ..., noise_correlation_s: Interval = ...,
            angle_p: float = ..., order_p: float = ..., path_p: float = ..., steering_rate_per_s: Interval = ...,
            steering_delay_s: Interval = ..., steering_p: float = ...,
        ) -> None: ...


@laid_out
class CalibrationSlide(Struct):
    """One slide of the last hrt_calibration_solve(). Angles are relative to the goal direction. Since version
    0.3.

    verdict: Slide.
    trial: Number of the trial, from 0; trials without a slide are left out.
    plate_deg
    direction_deg: Of the second half of the path, seen and fitted, and their difference.
    fitted_deg
    residual_deg
    """

    struct_size: UInt32
    verdict: Slide
    trial: UInt32
    reserved: UInt32
    plate_deg: Double
    direction_deg: Double
    fitted_deg: Double
    residual_deg: Double

    if TYPE_CHECKING:
        def __init__(
            self, *, verdict: Slide = ..., trial: int = ..., plate_deg: float = ..., direction_deg: float = ...,
            fitted_deg: float = ..., residual_deg: float = ...,
        ) -> None: ...


@laid_out
class CalibrationComparison(Struct):
    """Test and retest: two calibrations of a user, or of two users. Each field is the second value less the
    first, with the 95 % interval of the difference; known if both values are. Since version 0.3.

    differing: DiffersFlag, by Holm's procedure over the known values: if nothing has changed, any of them
        is set in 5 % of comparisons. 0 is no proof that nothing has changed: see the intervals.
    tactile_weight
    max_gap_deg
    bias_deg
    habit_deg
    tracker_noise_m
    steering_rate_per_s
    steering_delay_s
    """

    struct_size: UInt32
    differing: DiffersFlag
    tactile_weight: Interval
    max_gap_deg: Interval
    bias_deg: Interval
    habit_deg: Interval
    tracker_noise_m: Interval
    steering_rate_per_s: Interval
    steering_delay_s: Interval

    if TYPE_CHECKING:
        def __init__(
            self, *, differing: DiffersFlag = ..., tactile_weight: Interval = ..., max_gap_deg: Interval = ...,
            bias_deg: Interval = ..., habit_deg: Interval = ..., tracker_noise_m: Interval = ...,
            steering_rate_per_s: Interval = ..., steering_delay_s: Interval = ...,
        ) -> None: ...


@laid_out
class Conditions(Struct):
    """Conditions of a measurement. The plugin reads no clock and knows no devices: the host names them. Since
    version 0.3.

    differing: Output: ConditionFlag, of what both the profile and the host name, and not alike. Input: not
        read.
    time_s: Seconds since 1970, UTC. 0 to 253402300799, the end of the year 9999. 0: unknown.
    plate: Names of plate and tracker: UTF-8 without control characters, ended by a zero. Empty: unknown.
    tracker
    """

    struct_size: UInt32
    differing: ConditionFlag
    time_s: Int64
    plate: Annotated[bytes, c_char * 64]
    tracker: Annotated[bytes, c_char * 64]

    if TYPE_CHECKING:
        def __init__(
            self, *, differing: ConditionFlag = ..., time_s: int = ..., plate: str | bytes = ...,
            tracker: str | bytes = ...,
        ) -> None: ...


@laid_out
class RecordingStatus(Struct):
    """State of a recording.

    system_error: errno of the first failed write, after which nothing is written; 0: none.
    rows_written: Calls that the operating system has accepted for writing.
    rows_lost: Calls dropped because the disk was too slow or failed. 0 after stopping: the file is
        complete.
    """

    struct_size: UInt32
    system_error: Int32
    rows_written: UInt64
    rows_lost: UInt64

    if TYPE_CHECKING:
        def __init__(
            self, *, system_error: int = ..., rows_written: int = ..., rows_lost: int = ...,
        ) -> None: ...


@laid_out
class ReplayReport(Struct):
    """Result of a replay.

    complete: 1 if `ending` is Ending.COMPLETE, else 0.
    rows: Rows replayed.
    first_different_line: Line, from 1, of the first row whose result or any number differs from the
        recorded one; 0: all rows are equal, bit for bit.
    hash: FNV-1a hash of the replayed commands, equal on every host: for each successful row "update", flags
        as 8 bytes, step and the eleven numbers after it, least significant byte first.
    ending: Ending. Since version 0.3.
    """

    struct_size: UInt32
    complete: UInt32
    rows: UInt64
    first_different_line: UInt64
    hash: UInt64
    ending: Ending
    reserved: UInt32

    if TYPE_CHECKING:
        def __init__(
            self, *, complete: bool | int = ..., rows: int = ..., first_different_line: int = ..., hash: int = ...,
            ending: Ending = ...,
        ) -> None: ...


@laid_out
class MarkTouch(Struct):
    """A touch of a mark. This struct never grows.

    mark_m: The mark in plate coordinates. Each within 1000.
    touched_m: Where the tracker saw the fingertip, in the engine's world. Each within 1000.
    """

    mark_m: Annotated[Array[c_double], c_double * 3]
    touched_m: Annotated[Array[c_double], c_double * 3]

    if TYPE_CHECKING:
        def __init__(
            self, *, mark_m: ArrayLike = ..., touched_m: ArrayLike = ...,
        ) -> None: ...


@laid_out
class RegistrationConfig(Struct):
    """Configuration of a registration.

    flags: RegisterFlag. Default 0.
    touch_sd_m: Standard deviation of each coordinate of a touch, as expected; the residuals correct it.
        Raising it accepts worse touches. 1e-5 to 0.1. Default 0.003.
    up: Up in the engine's world, of any length: the plate's face must look that way within 60 degrees. Each
        within 1000, and not all 0. Default (0, 1, 0).
    """

    struct_size: UInt32
    flags: RegisterFlag
    touch_sd_m: Double
    up: Annotated[Array[c_double], c_double * 3]

    if TYPE_CHECKING:
        def __init__(
            self, *, flags: RegisterFlag = ..., touch_sd_m: float = ..., up: ArrayLike = ...,
        ) -> None: ...


@laid_out
class Registration(Struct):
    """A registered pose. Its numbers mean something if it HOLDS; INCONSISTENT and UPSIDE_DOWN have those of
    the fit to all touches, to look at.

    verdict: RegistrationVerdict.
    touches: Touches that were given.
    left_out: Index of the one touch that does not fit the others and was left out; -1: none.
    plate_position_m: Pose and scale, as SessionConfig has them. The scale is 1 unless fitted.
    plate_rotation
    plate_scale
    covariance: Covariance of the rotation about the plate's x, y and z (radians), the position in the world
        (metres) and the scale: the lower triangle, row by row. 0 for a scale that was not fitted.
    touch_sd_m: Standard deviation of a touch's coordinate: as expected and as seen, weighted.
    residual_m: Root mean square distance of the touches from their marks.
    turn_sd_deg: Standard deviation of the plate's turn about its normal, which turns every reach.
    """

    struct_size: UInt32
    verdict: RegistrationVerdict
    touches: UInt32
    left_out: Int32
    plate_position_m: Annotated[Array[c_double], c_double * 3]
    plate_rotation: Annotated[Array[c_double], c_double * 4]
    plate_scale: Double
    covariance: Annotated[Array[c_double], c_double * 28]
    touch_sd_m: Double
    residual_m: Double
    turn_sd_deg: Double

    if TYPE_CHECKING:
        def __init__(
            self, *, verdict: RegistrationVerdict = ..., touches: int = ..., left_out: int = ...,
            plate_position_m: ArrayLike = ..., plate_rotation: ArrayLike = ..., plate_scale: float = ...,
            covariance: ArrayLike = ..., touch_sd_m: float = ..., residual_m: float = ..., turn_sd_deg: float = ...,
        ) -> None: ...


@laid_out
class TouchCheck(Struct):
    """Result of hrt_registration_check().

    holds: 1 if the touch agrees with the registration; else 0: register again.
    distance_m: Distance of the touch from where its mark should be.
    allowed_m: Distance within which 999 touches in 1000 are while the registration is true. A plate that
        has moved by less may pass.
    """

    struct_size: UInt32
    holds: UInt32
    distance_m: Double
    allowed_m: Double

    if TYPE_CHECKING:
        def __init__(
            self, *, holds: bool | int = ..., distance_m: float = ..., allowed_m: float = ...,
        ) -> None: ...


@laid_out
class JointTouch(Struct):
    """A tracked joint, in touches while its fingertip is on a mark. This struct never grows.

    position_m: Position of the joint in the engine's world. Each within 1000.
    rotation: Rotation of the joint: the unit quaternion x, y, z, w from its axes to the world's. Length 1
        within 0.001.
    """

    position_m: Annotated[Array[c_double], c_double * 3]
    rotation: Annotated[Array[c_double], c_double * 4]

    if TYPE_CHECKING:
        def __init__(
            self, *, position_m: ArrayLike = ..., rotation: ArrayLike = ...,
        ) -> None: ...


@laid_out
class Fingertip(Struct):
    """Where the skin that touches is, in the joint's axes: at position + rotation * offset_m in the world. Of
    one hand.

    known: 1 if every deviation is below 5 mm; else 0: the joint was not turned enough, and the numbers are
        0.
    offset_m
    sd_m: Its standard deviations.
    """

    struct_size: UInt32
    known: UInt32
    offset_m: Annotated[Array[c_double], c_double * 3]
    sd_m: Annotated[Array[c_double], c_double * 3]

    if TYPE_CHECKING:
        def __init__(
            self, *, known: bool | int = ..., offset_m: ArrayLike = ..., sd_m: ArrayLike = ...,
        ) -> None: ...


@laid_out
class Latency(Struct):
    """Latency of a tracker.

    known: 1 if the 95 % interval is at most 40 ms wide; else 0, and the numbers are 0.
    latency_ns: For SessionConfig.tracker_latency_ns: the best fit, or 0 if that is negative.
    lower_ns: Ends of the 95 % interval; the lower one may be negative.
    upper_ns
    residual_m: Standard deviation of a coordinate from the circle on which the finger was carried.
    radius_m: Radius of that circle.
    """

    struct_size: UInt32
    known: UInt32
    latency_ns: Int64
    lower_ns: Int64
    upper_ns: Int64
    residual_m: Double
    radius_m: Double

    if TYPE_CHECKING:
        def __init__(
            self, *, known: bool | int = ..., latency_ns: int = ..., lower_ns: int = ..., upper_ns: int = ...,
            residual_m: float = ..., radius_m: float = ...,
        ) -> None: ...


@laid_out
class SceneHandle(Struct):
    """A scene's handle. Zero is never a scene. Handles are never reused.

    value
    """

    value: UInt64

    if TYPE_CHECKING:
        def __init__(
            self, *, value: int = ...,
        ) -> None: ...


@laid_out
class SceneInfo(Struct):
    """The plate of a scene.

    target_count: Number of targets, real and virtual.
    plate_position_m: Pose of the plate in the world; see SessionConfig.
    plate_rotation
    plate_radius_m
    plate_max_speed_deg_s: Maximum speed of the servo, degrees per second; 0: not in the file.
    start_position_m: Start of reaches, in plate coordinates.
    """

    struct_size: UInt32
    target_count: UInt32
    plate_position_m: Annotated[Array[c_double], c_double * 3]
    plate_rotation: Annotated[Array[c_double], c_double * 4]
    plate_radius_m: Double
    plate_max_speed_deg_s: Double
    start_position_m: Annotated[Array[c_double], c_double * 3]

    if TYPE_CHECKING:
        def __init__(
            self, *, target_count: int = ..., plate_position_m: ArrayLike = ..., plate_rotation: ArrayLike = ...,
            plate_radius_m: float = ..., plate_max_speed_deg_s: float = ..., start_position_m: ArrayLike = ...,
        ) -> None: ...


@laid_out
class SceneTarget(Struct):
    """A target of a scene.

    role: Role.
    served_by: Index of the real target that serves this virtual one: the one that the file names, or else
        the nearest in direction, the first among equals; -1 for a real target.
    position_m: In plate coordinates; y is the height above the plate.
    world_position_m
    direction_deg: From the start, along the plate.
    distance_m
    radius_m: 0: not in the file.
    name
    """

    struct_size: UInt32
    role: Role
    served_by: Int32
    reserved: UInt32
    position_m: Annotated[Array[c_double], c_double * 3]
    world_position_m: Annotated[Array[c_double], c_double * 3]
    direction_deg: Double
    distance_m: Double
    radius_m: Double
    name: Annotated[bytes, c_char * 64]

    if TYPE_CHECKING:
        def __init__(
            self, *, role: Role = ..., served_by: int = ..., position_m: ArrayLike = ...,
            world_position_m: ArrayLike = ..., direction_deg: float = ..., distance_m: float = ...,
            radius_m: float = ..., name: str | bytes = ...,
        ) -> None: ...


FUNCTIONS: dict[str, tuple[Any, ...]] = {
    "hrt_result_string": (c_char_p, c_int32),
    "hrt_last_error": (c_char_p,),
    "hrt_get_version": (None, POINTER(c_uint32), POINTER(c_uint32), POINTER(c_uint32)),
    "hrt_set_allocator": (c_int32, POINTER(Allocator)),
    "hrt_set_log_callback": (c_int32, LogCallback, c_void_p),
    "hrt_session_config_default": (c_int32, POINTER(SessionConfig), c_uint32),
    "hrt_session_create": (c_int32, POINTER(SessionConfig), POINTER(SessionHandle)),
    "hrt_session_is_valid": (c_uint32, SessionHandle),
    "hrt_session_get_state": (c_int32, SessionHandle, POINTER(c_uint32)),
    "hrt_session_destroy": (c_int32, SessionHandle),
    "hrt_session_set_log_callback": (c_int32, SessionHandle, LogCallback, c_void_p),
    "hrt_session_get_config": (c_int32, SessionHandle, POINTER(SessionConfig)),
    "hrt_session_set_config": (c_int32, SessionHandle, POINTER(SessionConfig)),
    "hrt_target_config_default": (c_int32, POINTER(TargetConfig), c_uint32),
    "hrt_target_add": (c_int32, SessionHandle, POINTER(TargetConfig), POINTER(TargetHandle)),
    "hrt_target_set": (c_int32, SessionHandle, TargetHandle, POINTER(TargetConfig)),
    "hrt_target_get": (c_int32, SessionHandle, TargetHandle, POINTER(TargetConfig)),
    "hrt_target_remove": (c_int32, SessionHandle, TargetHandle),
    "hrt_target_find": (c_int32, SessionHandle, c_char_p, POINTER(TargetHandle)),
    "hrt_target_list": (c_int32, SessionHandle, c_uint32, c_uint64, POINTER(TargetHandle), POINTER(c_uint64)),
    "hrt_authority_query": (c_int32, SessionHandle, TargetHandle, TargetHandle, POINTER(Authority)),
    "hrt_authority_query_all": (c_int32, SessionHandle, c_uint64, POINTER(Authority), POINTER(c_uint64)),
    "hrt_authority_query_best": (c_int32, SessionHandle, TargetHandle, POINTER(Authority)),
    "hrt_target_assign": (c_int32, SessionHandle, POINTER(TargetHandle), c_uint64, POINTER(TargetHandle), c_uint64, c_uint32, c_uint64, POINTER(Authority)),
    "hrt_reach_config_default": (c_int32, POINTER(ReachConfig), c_uint32),
    "hrt_reach_begin": (c_int32, SessionHandle, POINTER(ReachConfig)),
    "hrt_reach_update": (c_int32, SessionHandle, POINTER(Sample), POINTER(Command)),
    "hrt_reach_retarget": (c_int32, SessionHandle, TargetHandle, TargetHandle),
    "hrt_reach_cancel": (c_int32, SessionHandle),
    "hrt_reach_end": (c_int32, SessionHandle, POINTER(ReachSummary)),
    "hrt_calibration_config_default": (c_int32, POINTER(CalibrationConfig), c_uint32),
    "hrt_calibration_create": (c_int32, SessionHandle, POINTER(CalibrationConfig), POINTER(CalibrationHandle)),
    "hrt_calibration_destroy": (c_int32, CalibrationHandle),
    "hrt_calibration_begin_trial": (c_int32, CalibrationHandle, c_double),
    "hrt_calibration_add_sample": (c_int32, CalibrationHandle, POINTER(Sample)),
    "hrt_calibration_end_trial": (c_int32, CalibrationHandle),
    "hrt_calibration_cancel_trial": (c_int32, CalibrationHandle),
    "hrt_calibration_next_angle": (c_int32, CalibrationHandle, POINTER(c_double), POINTER(c_uint32)),
    "hrt_calibration_solve": (c_int32, CalibrationHandle, POINTER(CalibrationResult)),
    "hrt_calibration_get_residual": (c_int32, CalibrationHandle, c_uint32, POINTER(CalibrationSlide)),
    "hrt_calibration_compare": (c_int32, POINTER(CalibrationResult), POINTER(CalibrationResult), POINTER(CalibrationComparison)),
    "hrt_calibration_apply": (c_int32, SessionHandle, POINTER(CalibrationResult)),
    "hrt_profile_set_conditions": (c_int32, SessionHandle, POINTER(Conditions)),
    "hrt_profile_get_conditions": (c_int32, SessionHandle, POINTER(Conditions)),
    "hrt_profile_save": (c_int32, SessionHandle, c_uint64, POINTER(c_char), POINTER(c_uint64)),
    "hrt_profile_load": (c_int32, SessionHandle, c_char_p, c_uint64),
    "hrt_recording_start": (c_int32, SessionHandle, c_char_p),
    "hrt_recording_get_status": (c_int32, SessionHandle, POINTER(RecordingStatus)),
    "hrt_recording_stop": (c_int32, SessionHandle, POINTER(RecordingStatus)),
    "hrt_replay_text": (c_int32, c_char_p, c_uint64, POINTER(ReplayReport)),
    "hrt_replay_file": (c_int32, c_char_p, POINTER(ReplayReport)),
    "hrt_registration_config_default": (c_int32, POINTER(RegistrationConfig), c_uint32),
    "hrt_registration_fit": (c_int32, POINTER(RegistrationConfig), POINTER(MarkTouch), c_uint64, c_uint64, POINTER(c_double), POINTER(Registration)),
    "hrt_registration_advice": (c_char_p, c_uint32),
    "hrt_registration_apply": (c_int32, SessionHandle, POINTER(Registration), c_int64),
    "hrt_registration_check": (c_int32, POINTER(Registration), POINTER(MarkTouch), POINTER(TouchCheck)),
    "hrt_registration_confirm": (c_int32, SessionHandle, POINTER(Registration), POINTER(MarkTouch), c_int64, POINTER(TouchCheck)),
    "hrt_fingertip_fit": (c_int32, POINTER(RegistrationConfig), POINTER(JointTouch), c_uint64, POINTER(Fingertip)),
    "hrt_fingertip_place": (c_int32, POINTER(Fingertip), POINTER(JointTouch), POINTER(Sample)),
    "hrt_latency_fit": (c_int32, POINTER(Sample), c_uint64, POINTER(Latency)),
    "hrt_scene_load_file": (c_int32, c_char_p, POINTER(SceneHandle)),
    "hrt_scene_load_memory": (c_int32, c_void_p, c_uint64, c_char_p, POINTER(SceneHandle)),
    "hrt_scene_destroy": (c_int32, SceneHandle),
    "hrt_scene_get_info": (c_int32, SceneHandle, POINTER(SceneInfo)),
    "hrt_scene_get_target": (c_int32, SceneHandle, c_uint32, POINTER(SceneTarget)),
    "hrt_scene_register": (c_int32, SceneHandle, SessionHandle, c_uint64, POINTER(TargetHandle)),
}
"""The types of each function's result and parameters."""
