# Written by plugin/bindings/generate from the C headers.
"""The C interface as ctypes sees it. Meanings, units and ranges are those of the C headers."""

from __future__ import annotations

import ctypes
from ctypes import (
    CDLL, CFUNCTYPE, POINTER, c_char, c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint32, c_uint64, c_void_p,
)
from enum import IntEnum, IntFlag
from typing import TYPE_CHECKING

from ._struct import Struct


VERSION = (0, 2, 0)
"""Of the headers that this was written from."""
OK = 0
CALIBRATIONS_MAX = 16
"""Calibrations that can exist at the same time in a process."""
SCENES_MAX = 64
"""Scenes that can be loaded at the same time in a process."""
SESSIONS_MAX = 64
"""Sessions that can exist at the same time in a process."""
TARGETS_MAX = 1000000
"""Targets that a session can hold."""
NAME_SIZE = 64
"""Bytes of a name, with its terminating zero."""


class ErrorCode(IntEnum):
    """The C headers' HRT_ERROR_*.

    NULL_ARGUMENT: A pointer that must not be null was null.
    INVALID_HANDLE: The handle or id is null, was never given out, is of another session, or of something
        destroyed.
    STRUCT_SIZE: `struct_size` is below the first version's, or bytes beyond what this library knows are not
        zero.
    OUT_OF_RANGE: A value is outside its documented range, not a number, or infinite.
    WRONG_STATE: Not now: for example an update without a reach, or a new configuration during one.
    BUSY: Another thread is in a call on this session.
    TIME_REVERSED: The sample's time is before that of the sample before it.
    OUT_OF_MEMORY
    LIMIT_REACHED: There are as many of these as there can be.
    NOT_FOUND: Nothing has this name.
    BUFFER_TOO_SMALL: The caller's buffer cannot hold the answer.
    NAME_TAKEN: Another target of this session has this name.
    SYSTEM: The operating system refused: a file, a thread.
    BAD_FORMAT: A text is not what it should be; hrt_last_error() tells where.
    INSUFFICIENT_DATA: The data do not tell what was asked of them; hrt_last_error() tells what is missing.
    INTERNAL: A defect in this library; please report it with the text of hrt_last_error().
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


class Control(IntEnum):
    """What decides the plate's orientation.

    MPC: the model-predictive controller
    FIXED_PLATE: none, as a baseline: the plate stays where it is told to
    """

    MPC = 0
    FIXED_PLATE = 1


class Guidance(IntEnum):
    """Where the finger is wanted.

    FIXED_DIRECTION: in the real target's direction from the start
    LINE_OF_SIGHT: In the direction from where the finger is to where the real target is, held once less
        than a fifth of the path remains. Takes effect when positions are streamed; with directions alone it
        is as above.
    """

    FIXED_DIRECTION = 0
    LINE_OF_SIGHT = 1


class Adaptation(IntEnum):
    """Whether the user's share of touch and motor variance are learnt.

    OFF: no: they are taken as known
    REACH: The share of touch within each reach, from tactile_weight and its deviation. The reach's summary
        also tells the motor variance, from motor_variance_deg2 and its deviation.
    CARRIED: As REACH; and what a reach has learnt becomes the configuration's: tactile_weight and
        tactile_weight_sd, the latter no less than 0.01, and motor_variance_deg2 and motor_variance_sd_deg2,
        the latter no less than 0.1, as people change. One reach changes the motor variance by a factor of
        two at most, in which case its deviation stays; it is kept within 0.05 to 5.
    """

    OFF = 0
    REACH = 1
    CARRIED = 2


class Role(IntEnum):
    """The C headers' HRT_TARGET_*.

    REAL: What a target is.
    VIRTUAL
    """

    REAL = 1
    VIRTUAL = 2


class Place(IntEnum):
    """How a target's place is given.

    DIRECTION: by `direction_deg` and `distance_m`
    PLATE_POSITION: by `position_m` in plate coordinates
    WORLD_POSITION: By `position_m` in the engine's world; see SessionConfig.plate_position_m.
    """

    DIRECTION = 1
    PLATE_POSITION = 2
    WORLD_POSITION = 3


class LogLevel(IntEnum):
    """The C headers' HRT_LOG_*.

    WARNING: LogCallback: how bad it is.
    ERROR
    """

    WARNING = 1
    ERROR = 2


class ReachFlag(IntFlag):
    """ReachConfig.flags.

    PLATE_ORIENTATION: `plate_orientation_deg` is given; without this the plate is where the session's last
        command left it (at first 0).
    """

    PLATE_ORIENTATION = 1


class SampleFlag(IntFlag):
    """Sample.flags: which fields hold something. Of DIRECTION, PLATE_POSITION and WORLD_POSITION at most one
    may be given. With none of them, nor LIFTED, the sample is a dropout: the plate is held, and the model
    predicts until the finger is seen again.

    DIRECTION: finger_direction_deg
    PLATE_POSITION: finger_position_m, in plate coordinates
    PLATE_ORIENTATION: plate_orientation_deg, measured by the device
    LIFTED: The finger is off the plate, and so feels nothing: the model waits.
    WORLD_POSITION: finger_position_m, in the engine's world
    PLATE_POSE: plate_position_m and plate_rotation: the plate has moved in the world; else it is where the
        session's configuration has it. Goes with WORLD_POSITION.
    """

    DIRECTION = 1
    PLATE_POSITION = 2
    PLATE_ORIENTATION = 4
    LIFTED = 8
    WORLD_POSITION = 16
    PLATE_POSE = 32


class CommandFlag(IntFlag):
    """Command.flags.

    HELD: between steps: nothing new was decided in this call
    PREDICTED: the last step had no direction and was predicted
    SATURATED: the plate's bound or a stop holds the command
    RATE_LIMITED: the plate's speed holds the command
    UNREACHABLE: the real direction cannot be held: see authority.h
    LIFTED: the finger is above the plate: the model waits
    OFF_PLATE: the finger is beyond the plate's edge
    """

    HELD = 1
    PREDICTED = 2
    SATURATED = 4
    RATE_LIMITED = 8
    UNREACHABLE = 16
    LIFTED = 32
    OFF_PLATE = 64


AllocatorAllocate = CFUNCTYPE(c_void_p, c_void_p, c_size_t, c_size_t)
"""Returns `size` bytes (at least 1) at a multiple of `alignment` (a power of two), or null if it can't."""
AllocatorRelease = CFUNCTYPE(None, c_void_p, c_void_p)
"""Takes back what allocate() returned."""
LogCallback = CFUNCTYPE(None, c_void_p, c_uint32, c_char_p)
"""Hears what no call can return, such as that a recording's disk is full. `text` is one line, valid during
the call. Called from a thread of the library's own, never from within a call of the host's; must not
call this library, and must not throw."""


class SessionHandle(Struct):
    """A session's handle. Zero is never a session. A handle of a destroyed session is never valid again.

    value
    """

    if TYPE_CHECKING:
        value: int

    _fields_ = (
        ("value", c_uint64),
    )


class SessionConfig(Struct):
    """Everything that a session is made from.

    horizon: Steps that the controller looks ahead, 1 to 50. Default 3.
    step_period_ns: Time of one step of the participant's model and of the controller, 1 ms to 10 s. Default
        100 ms.
    control: Control. Default Control.MPC.
    guidance: Guidance. Default Guidance.LINE_OF_SIGHT.
    adaptation: Adaptation. Default Adaptation.OFF.
    perceived_weight: Weight of the perceived error in the controller's cost, 1e-6 to 1e6. Default 1.
    actual_weight: Weight of the actual error in the controller's cost, 0 to 1e6. Default 1.
    plate_bound_deg: The plate stays within this of the direction that the user goes for, the virtual
        target's and bias_deg, or of what feels the same; 0.1 to 90. Default 84.5.
    plate_max_speed_deg_s: The plate's servo: its highest speed, 0 to 1e6 degrees a second; 0: no limit.
        Default 0.
    plate_max_acceleration_deg_s2: Its highest acceleration, 0 to 1e8 degrees a second squared; 0: no limit.
        Default 0.
    plate_latency_ns: The time from a command to the plate's first motion, 0 to 1 s and to 8 step periods.
        Default 0.
    plate_lower_stop_deg: The plate's stops, -3600 to 3600, the upper at least 180 above the lower; both 0:
        it turns freely. Default 0 and 0.
    plate_upper_stop_deg
    fixed_plate_orientation_deg: Where the plate stays under Control.FIXED_PLATE, -180 to 180: there, or at
        what feels the same between the stops and is nearer to where it stands. Default 0.
    tactile_weight: Share of touch in the direction that the user feels, 0.001 to 0.499. Default 0.15.
    tactile_weight_sd: Standard deviation of that, for adaptation to start from, 0.001 to 0.49. Default
        0.05.
    motor_variance_deg2: Variance of the user's motor command per step, 1e-9 to 1e4. Default 0.5.
    sensory_variance_deg2: Variance of what the user feels per step, 1e-9 to 1e4. Default 0.1.
    initial_variance_deg2: Variance of the user's perceived direction before the first step, 0 to 1e4.
        Default 0.
    tracker_noise_m: White noise of each coordinate of a tracked position, standard deviation, 0 to 0.1; 0:
        learn it from the samples. Default 0.
    start_position_m: Where reaches start, in plate coordinates; target directions are measured from here,
        in the plane of the plate. Each within 1000. Default (0, 0, 0.05): on the mid-line, 5 cm towards the
        user.
    plate_radius_m: Beyond this from the plate's centre a position is off the plate, 0.001 to 1000. Default
        0.075.
    lift_height_m: Higher than this above the plate a position is lifted, 0.0001 to 1000. Default 0.015.
    plate_position_m: The plate's centre in the engine's world, each within 1000. Default (0, 0, 0).
    plate_rotation: How the plate's mount is turned in the world, as the unit quaternion x, y, z, w that
        takes plate coordinates to the world's axes. It does not turn with the ridges. Default (0, 0, 0, 1).
    bias_deg: The user's own bias: how much further to the left than it is they take a virtual target to
        lie, -45 to 45. They go for its direction and this. Known from calibration.h, not learnt in reaches.
        Default 0. Since version 0.2.
    motor_variance_sd_deg2: Standard deviation of motor_variance_deg2, for adaptation to start from, 0.001
        to 10. Default 0.5. Since version 0.2.
    """

    if TYPE_CHECKING:
        struct_size: int
        horizon: int
        step_period_ns: int
        control: int
        guidance: int
        adaptation: int
        reserved: int
        perceived_weight: float
        actual_weight: float
        plate_bound_deg: float
        plate_max_speed_deg_s: float
        plate_max_acceleration_deg_s2: float
        plate_latency_ns: int
        plate_lower_stop_deg: float
        plate_upper_stop_deg: float
        fixed_plate_orientation_deg: float
        tactile_weight: float
        tactile_weight_sd: float
        motor_variance_deg2: float
        sensory_variance_deg2: float
        initial_variance_deg2: float
        tracker_noise_m: float
        start_position_m: ctypes.Array[c_double]
        plate_radius_m: float
        lift_height_m: float
        plate_position_m: ctypes.Array[c_double]
        plate_rotation: ctypes.Array[c_double]
        bias_deg: float
        motor_variance_sd_deg2: float

    _fields_ = (
        ("struct_size", c_uint32),
        ("horizon", c_uint32),
        ("step_period_ns", c_int64),
        ("control", c_uint32),
        ("guidance", c_uint32),
        ("adaptation", c_uint32),
        ("reserved", c_uint32),
        ("perceived_weight", c_double),
        ("actual_weight", c_double),
        ("plate_bound_deg", c_double),
        ("plate_max_speed_deg_s", c_double),
        ("plate_max_acceleration_deg_s2", c_double),
        ("plate_latency_ns", c_int64),
        ("plate_lower_stop_deg", c_double),
        ("plate_upper_stop_deg", c_double),
        ("fixed_plate_orientation_deg", c_double),
        ("tactile_weight", c_double),
        ("tactile_weight_sd", c_double),
        ("motor_variance_deg2", c_double),
        ("sensory_variance_deg2", c_double),
        ("initial_variance_deg2", c_double),
        ("tracker_noise_m", c_double),
        ("start_position_m", c_double * 3),
        ("plate_radius_m", c_double),
        ("lift_height_m", c_double),
        ("plate_position_m", c_double * 3),
        ("plate_rotation", c_double * 4),
        ("bias_deg", c_double),
        ("motor_variance_sd_deg2", c_double),
    )


class TargetHandle(Struct):
    """A target's id within its session. Zero is never a target. The id of a removed target is never valid
    again, in no session.

    value
    """

    if TYPE_CHECKING:
        value: int

    _fields_ = (
        ("value", c_uint64),
    )


class TargetConfig(Struct):
    """A target. Fields that `place` does not name are not read.

    role: Role. Default Role.REAL.
    place: Place. Default Place.DIRECTION.
    direction_deg: Direction from the start, -180 to 180. Default 0.
    distance_m: Distance from the start along the plate, 0.001 to 1000. Default 0.1.
    position_m: Place in plate coordinates or in the world, each within 1000; at least 1 mm from the start
        in the plane of the plate; the height y is kept and not used. Default (0, 0, 0).
    name: UTF-8, ended by a zero; unique within the session unless empty. Default empty.
    """

    if TYPE_CHECKING:
        struct_size: int
        role: int
        place: int
        reserved: int
        direction_deg: float
        distance_m: float
        position_m: ctypes.Array[c_double]
        name: bytes

    _fields_ = (
        ("struct_size", c_uint32),
        ("role", c_uint32),
        ("place", c_uint32),
        ("reserved", c_uint32),
        ("direction_deg", c_double),
        ("distance_m", c_double),
        ("position_m", c_double * 3),
        ("name", c_char * 64),
    )


class Authority(Struct):
    """What can be held for one pair.

    reachable: 1 if the finger can be held on the real target's direction, else 0.
    real_target
    virtual_target
    gap_deg: Where the user goes, the virtual target's direction and SessionConfig.bias_deg, less the real
        target's direction; in [-180, 180).
    largest_gap_deg: The largest gap, either way, that can be held with the session's tactile weight and
        plate bound.
    margin_deg: largest_gap_deg less the size of the gap; negative if out of reach.
    plate_orientation_deg: Where the plate must stand to hold it; on its bound if out of reach.
    settling_direction_deg: Where the finger settles: the real target's direction if it can be held.
    """

    if TYPE_CHECKING:
        struct_size: int
        reachable: int
        real_target: TargetHandle
        virtual_target: TargetHandle
        gap_deg: float
        largest_gap_deg: float
        margin_deg: float
        plate_orientation_deg: float
        settling_direction_deg: float

    _fields_ = (
        ("struct_size", c_uint32),
        ("reachable", c_uint32),
        ("real_target", TargetHandle),
        ("virtual_target", TargetHandle),
        ("gap_deg", c_double),
        ("largest_gap_deg", c_double),
        ("margin_deg", c_double),
        ("plate_orientation_deg", c_double),
        ("settling_direction_deg", c_double),
    )


class ReachConfig(Struct):
    """What a reach is.

    flags: ReachFlag. Default 0.
    real_target: Its direction and the one that the user goes for, the virtual target's and
        SessionConfig.bias_deg, are less than 90 degrees apart. Default null: to be set.
    virtual_target
    plate_orientation_deg: Where the plate stands before the reach, -3600 to 3600; beyond a stop means at
        the stop. Default 0.
    """

    if TYPE_CHECKING:
        struct_size: int
        flags: int
        real_target: TargetHandle
        virtual_target: TargetHandle
        plate_orientation_deg: float

    _fields_ = (
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("real_target", TargetHandle),
        ("virtual_target", TargetHandle),
        ("plate_orientation_deg", c_double),
    )


class Sample(Struct):
    """One sample of the tracked finger. Set it to zero, then `struct_size` and what is known. Fields that
    `flags` does not name are not read, whatever is in them.

    flags: SampleFlag.
    time_ns: The caller's monotonic clock; any origin. Not before the last sample's; the same time again is
        taken.
    finger_direction_deg: The direction in which the finger moves, -180 to 180; taken as exact.
    finger_position_m: The fingertip, each within 1000. Of a tracked pose this is the position; how the
        finger is turned is not asked for.
    plate_orientation_deg: Where the plate stands, -3600 to 3600. A plate without stops may count its turns
        as it likes: of the orientations that feel the same, the one nearest to where it is expected is
        taken. With stops it is taken as it is.
    plate_position_m: The plate in the world, as in SessionConfig.
    plate_rotation
    """

    if TYPE_CHECKING:
        struct_size: int
        flags: int
        time_ns: int
        finger_direction_deg: float
        finger_position_m: ctypes.Array[c_double]
        plate_orientation_deg: float
        plate_position_m: ctypes.Array[c_double]
        plate_rotation: ctypes.Array[c_double]

    _fields_ = (
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("time_ns", c_int64),
        ("finger_direction_deg", c_double),
        ("finger_position_m", c_double * 3),
        ("plate_orientation_deg", c_double),
        ("plate_position_m", c_double * 3),
        ("plate_rotation", c_double * 4),
    )


class Command(Struct):
    """What the plate is to do now, and why.

    flags: CommandFlag.
    step: The model step, from 0; -1 before the finger moves.
    plate_orientation_deg: Turn the plate here. Ridges repeat every 180 degrees. If the session's
        configuration gives the plate no highest speed or acceleration, this is the nearest of the
        orientations that feel the same and lie between the stops. If it does, the plate keeps to one half
        turn for a whole reach, so that it swings round at the start or not at all; a command beyond a stop
        is held at the stop.
    finger_direction_deg: The finger's direction in the last step, observed or predicted.
    perceived_direction_deg: The direction that the user feels, as the model predicts it under this command.
    aimed_direction_deg: Where the finger is wanted; see SessionConfig.guidance.
    distance_to_go_m: Along the plate to the real target; from the start until a position is streamed.
    tactile_weight: The share of touch that the controller assumes.
    tactile_weight_sd: Its standard deviation; 0: it is taken as known.
    """

    if TYPE_CHECKING:
        struct_size: int
        flags: int
        step: int
        plate_orientation_deg: float
        finger_direction_deg: float
        perceived_direction_deg: float
        aimed_direction_deg: float
        distance_to_go_m: float
        tactile_weight: float
        tactile_weight_sd: float

    _fields_ = (
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("step", c_int64),
        ("plate_orientation_deg", c_double),
        ("finger_direction_deg", c_double),
        ("perceived_direction_deg", c_double),
        ("aimed_direction_deg", c_double),
        ("distance_to_go_m", c_double),
        ("tactile_weight", c_double),
        ("tactile_weight_sd", c_double),
    )


class ReachSummary(Struct):
    """What became of a reach.

    samples: Samples taken in, and of these the dropouts and what was left out as an outlier.
    dropped_samples
    steps: Model steps with samples, and steps without, which were predicted.
    predicted_steps
    saturated_steps: Of the steps with samples, those whose command the plate's bound, a stop, or its speed
        held.
    rate_limited_steps
    final_direction_deg: The finger's direction in the last step, and that less the real target's.
    final_miss_deg
    perceived_direction_deg: What the user felt in the last step, and that less where they went: the virtual
        target's direction and SessionConfig.bias_deg.
    perceived_error_deg
    distance_to_target_m: From the last position along the plate to the real target; from the start if none
        was streamed.
    tactile_weight: What the controller assumed at the end; see Command.
    tactile_weight_sd
    tracker_noise_m: White noise of each coordinate of the tracked positions, standard deviation, as learnt
        or configured.
    motor_variance_deg2: The user's motor variance as this reach corrects what the configuration assumes.
        Since version 0.2.
    motor_variance_sd_deg2: Its standard deviation; close to SessionConfig.motor_variance_sd_deg2 if the
        reach could not tell; 0: it is taken as known. Since version 0.2.
    """

    if TYPE_CHECKING:
        struct_size: int
        reserved: int
        samples: int
        dropped_samples: int
        steps: int
        predicted_steps: int
        saturated_steps: int
        rate_limited_steps: int
        final_direction_deg: float
        final_miss_deg: float
        perceived_direction_deg: float
        perceived_error_deg: float
        distance_to_target_m: float
        tactile_weight: float
        tactile_weight_sd: float
        tracker_noise_m: float
        motor_variance_deg2: float
        motor_variance_sd_deg2: float

    _fields_ = (
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("samples", c_int64),
        ("dropped_samples", c_int64),
        ("steps", c_int64),
        ("predicted_steps", c_int64),
        ("saturated_steps", c_int64),
        ("rate_limited_steps", c_int64),
        ("final_direction_deg", c_double),
        ("final_miss_deg", c_double),
        ("perceived_direction_deg", c_double),
        ("perceived_error_deg", c_double),
        ("distance_to_target_m", c_double),
        ("tactile_weight", c_double),
        ("tactile_weight_sd", c_double),
        ("tracker_noise_m", c_double),
        ("motor_variance_deg2", c_double),
        ("motor_variance_sd_deg2", c_double),
    )


class CalibrationHandle(Struct):
    """A calibration's handle. Zero is never a calibration. A handle of a destroyed one is never valid again.

    value
    """

    if TYPE_CHECKING:
        value: int

    _fields_ = (
        ("value", c_uint64),
    )


class CalibrationConfig(Struct):
    """What a calibration is.

    max_trials: Trials that it can hold, 10 to 10000. Default 200.
    max_samples: Samples that all trials together can hold, 100 to 1000000; 24 bytes each, taken at
        creation. Default 100000: 18 minutes at 90 Hz.
    goal_direction_deg: Where the user is told to go, -180 to 180. Default 0: straight ahead.
    """

    if TYPE_CHECKING:
        struct_size: int
        max_trials: int
        max_samples: int
        reserved: int
        goal_direction_deg: float

    _fields_ = (
        ("struct_size", c_uint32),
        ("max_trials", c_uint32),
        ("max_samples", c_uint32),
        ("reserved", c_uint32),
        ("goal_direction_deg", c_double),
    )


class Interval(Struct):
    """An estimate with the ends of its 95 % interval. This struct never grows.

    value
    lower
    upper
    known: 1, or 0: the data can't tell. Then the interval is what was searched, and the value no more than
        its likeliest point.
    """

    if TYPE_CHECKING:
        value: float
        lower: float
        upper: float
        known: int
        reserved: int

    _fields_ = (
        ("value", c_double),
        ("lower", c_double),
        ("upper", c_double),
        ("known", c_uint32),
        ("reserved", c_uint32),
    )


class CalibrationResult(Struct):
    """What the slides tell of the user. The fields are those of SessionConfig.

    trials: Trials that were ended, and of these the ones with a slide of 30 mm or more, which alone count.
    trials_used
    tactile_weight: Always known; otherwise hrt_calibration_solve() refuses.
    bias_deg: Always known.
    motor_variance_deg2: Known if the tracker is good enough to show it; one with 1.2 mm of noise hardly is.
    sensory_variance_deg2: As motor_variance_deg2.
    tracker_noise_m: Always known.
    """

    if TYPE_CHECKING:
        struct_size: int
        reserved: int
        trials: int
        trials_used: int
        tactile_weight: Interval
        bias_deg: Interval
        motor_variance_deg2: Interval
        sensory_variance_deg2: Interval
        tracker_noise_m: Interval

    _fields_ = (
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("trials", c_uint32),
        ("trials_used", c_uint32),
        ("tactile_weight", Interval),
        ("bias_deg", Interval),
        ("motor_variance_deg2", Interval),
        ("sensory_variance_deg2", Interval),
        ("tracker_noise_m", Interval),
    )


class Allocator(Struct):
    """Where the library's memory comes from. The functions may be called from any thread, at the same time;
    they must not call this library, and must not throw.

    context: Passed to both functions; never read.
    allocate: Returns `size` bytes (at least 1) at a multiple of `alignment` (a power of two), or null if it
        can't.
    release: Takes back what allocate() returned.
    """

    if TYPE_CHECKING:
        struct_size: int
        reserved: int
        context: int | None
        allocate: ctypes._FuncPointer
        release: ctypes._FuncPointer

    _fields_ = (
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("context", c_void_p),
        ("allocate", AllocatorAllocate),
        ("release", AllocatorRelease),
    )


class RecordingStatus(Struct):
    """How a recording does.

    system_error: The errno of the first write that failed, after which nothing more is written; 0: none
        did.
    rows_written: Calls recorded, as far as the operating system has taken them.
    rows_lost: Calls that are not in the file, because the disk was too slow or failed. 0 at the end: it is
        complete.
    """

    if TYPE_CHECKING:
        struct_size: int
        system_error: int
        rows_written: int
        rows_lost: int

    _fields_ = (
        ("struct_size", c_uint32),
        ("system_error", c_int32),
        ("rows_written", c_uint64),
        ("rows_lost", c_uint64),
    )


class ReplayReport(Struct):
    """What a replay found.

    complete: 1 if the recording is whole: it has its end, and no rows were lost; else 0, and what precedes
        the gap was replayed.
    rows: Rows replayed.
    first_different_line: The line of the file, from 1, of the first row that came out otherwise than
        recorded, in its result or any number; 0: all came out the same, bit for bit.
    hash: FNV-1a of the commands as replayed, which is the same on every host: of each row "update" without
        error, flags as 8 bytes, step, and the seven numbers after them, least significant byte first.
    """

    if TYPE_CHECKING:
        struct_size: int
        complete: int
        rows: int
        first_different_line: int
        hash: int

    _fields_ = (
        ("struct_size", c_uint32),
        ("complete", c_uint32),
        ("rows", c_uint64),
        ("first_different_line", c_uint64),
        ("hash", c_uint64),
    )


class SceneHandle(Struct):
    """A scene's handle. Zero is never a scene. A handle of a destroyed scene is never valid again.

    value
    """

    if TYPE_CHECKING:
        value: int

    _fields_ = (
        ("value", c_uint64),
    )


class SceneInfo(Struct):
    """The plate of a scene.

    target_count: How many targets the scene has, real and virtual.
    plate_position_m: The plate in the world, as in SessionConfig.
    plate_rotation
    plate_radius_m
    plate_max_speed_deg_s: Of the plate's servo; 0 if the file does not tell.
    start_position_m: In plate coordinates.
    """

    if TYPE_CHECKING:
        struct_size: int
        target_count: int
        plate_position_m: ctypes.Array[c_double]
        plate_rotation: ctypes.Array[c_double]
        plate_radius_m: float
        plate_max_speed_deg_s: float
        start_position_m: ctypes.Array[c_double]

    _fields_ = (
        ("struct_size", c_uint32),
        ("target_count", c_uint32),
        ("plate_position_m", c_double * 3),
        ("plate_rotation", c_double * 4),
        ("plate_radius_m", c_double),
        ("plate_max_speed_deg_s", c_double),
        ("start_position_m", c_double * 3),
    )


class SceneTarget(Struct):
    """A target of a scene.

    role: Role.
    served_by: Of a virtual target: the index of the real one that serves it; of a real one -1.
    position_m: In plate coordinates; y is the height above the plate.
    world_position_m
    direction_deg: Seen from the start, along the plate.
    distance_m
    radius_m: 0 if the file does not tell.
    name
    """

    if TYPE_CHECKING:
        struct_size: int
        role: int
        served_by: int
        reserved: int
        position_m: ctypes.Array[c_double]
        world_position_m: ctypes.Array[c_double]
        direction_deg: float
        distance_m: float
        radius_m: float
        name: bytes

    _fields_ = (
        ("struct_size", c_uint32),
        ("role", c_uint32),
        ("served_by", c_int32),
        ("reserved", c_uint32),
        ("position_m", c_double * 3),
        ("world_position_m", c_double * 3),
        ("direction_deg", c_double),
        ("distance_m", c_double),
        ("radius_m", c_double),
        ("name", c_char * 64),
    )


def declare(library: CDLL) -> None:
    """Tells ctypes the type of every function; AttributeError names one that the library lacks."""
    library.hrt_result_string.argtypes = (c_int32,)
    library.hrt_result_string.restype = c_char_p
    library.hrt_last_error.argtypes = ()
    library.hrt_last_error.restype = c_char_p
    library.hrt_get_version.argtypes = (POINTER(c_uint32), POINTER(c_uint32), POINTER(c_uint32))
    library.hrt_get_version.restype = None
    library.hrt_session_config_default.argtypes = (POINTER(SessionConfig), c_uint32)
    library.hrt_session_config_default.restype = c_int32
    library.hrt_session_create.argtypes = (POINTER(SessionConfig), POINTER(SessionHandle))
    library.hrt_session_create.restype = c_int32
    library.hrt_session_destroy.argtypes = (SessionHandle,)
    library.hrt_session_destroy.restype = c_int32
    library.hrt_session_get_config.argtypes = (SessionHandle, POINTER(SessionConfig))
    library.hrt_session_get_config.restype = c_int32
    library.hrt_session_set_config.argtypes = (SessionHandle, POINTER(SessionConfig))
    library.hrt_session_set_config.restype = c_int32
    library.hrt_target_config_default.argtypes = (POINTER(TargetConfig), c_uint32)
    library.hrt_target_config_default.restype = c_int32
    library.hrt_target_add.argtypes = (SessionHandle, POINTER(TargetConfig), POINTER(TargetHandle))
    library.hrt_target_add.restype = c_int32
    library.hrt_target_set.argtypes = (SessionHandle, TargetHandle, POINTER(TargetConfig))
    library.hrt_target_set.restype = c_int32
    library.hrt_target_get.argtypes = (SessionHandle, TargetHandle, POINTER(TargetConfig))
    library.hrt_target_get.restype = c_int32
    library.hrt_target_remove.argtypes = (SessionHandle, TargetHandle)
    library.hrt_target_remove.restype = c_int32
    library.hrt_target_find.argtypes = (SessionHandle, c_char_p, POINTER(TargetHandle))
    library.hrt_target_find.restype = c_int32
    library.hrt_target_list.argtypes = (SessionHandle, c_uint32, c_uint32, POINTER(TargetHandle), POINTER(c_uint32))
    library.hrt_target_list.restype = c_int32
    library.hrt_authority_query.argtypes = (SessionHandle, TargetHandle, TargetHandle, POINTER(Authority))
    library.hrt_authority_query.restype = c_int32
    library.hrt_authority_query_all.argtypes = (SessionHandle, c_uint64, POINTER(Authority), POINTER(c_uint64))
    library.hrt_authority_query_all.restype = c_int32
    library.hrt_authority_query_best.argtypes = (SessionHandle, TargetHandle, POINTER(Authority))
    library.hrt_authority_query_best.restype = c_int32
    library.hrt_reach_config_default.argtypes = (POINTER(ReachConfig), c_uint32)
    library.hrt_reach_config_default.restype = c_int32
    library.hrt_reach_begin.argtypes = (SessionHandle, POINTER(ReachConfig))
    library.hrt_reach_begin.restype = c_int32
    library.hrt_reach_update.argtypes = (SessionHandle, POINTER(Sample), POINTER(Command))
    library.hrt_reach_update.restype = c_int32
    library.hrt_reach_end.argtypes = (SessionHandle, POINTER(ReachSummary))
    library.hrt_reach_end.restype = c_int32
    library.hrt_calibration_config_default.argtypes = (POINTER(CalibrationConfig), c_uint32)
    library.hrt_calibration_config_default.restype = c_int32
    library.hrt_calibration_create.argtypes = (SessionHandle, POINTER(CalibrationConfig), POINTER(CalibrationHandle))
    library.hrt_calibration_create.restype = c_int32
    library.hrt_calibration_destroy.argtypes = (CalibrationHandle,)
    library.hrt_calibration_destroy.restype = c_int32
    library.hrt_calibration_begin_trial.argtypes = (CalibrationHandle, c_double)
    library.hrt_calibration_begin_trial.restype = c_int32
    library.hrt_calibration_add_sample.argtypes = (CalibrationHandle, POINTER(Sample))
    library.hrt_calibration_add_sample.restype = c_int32
    library.hrt_calibration_end_trial.argtypes = (CalibrationHandle,)
    library.hrt_calibration_end_trial.restype = c_int32
    library.hrt_calibration_cancel_trial.argtypes = (CalibrationHandle,)
    library.hrt_calibration_cancel_trial.restype = c_int32
    library.hrt_calibration_solve.argtypes = (CalibrationHandle, POINTER(CalibrationResult))
    library.hrt_calibration_solve.restype = c_int32
    library.hrt_calibration_apply.argtypes = (SessionHandle, POINTER(CalibrationResult))
    library.hrt_calibration_apply.restype = c_int32
    library.hrt_set_allocator.argtypes = (POINTER(Allocator),)
    library.hrt_set_allocator.restype = c_int32
    library.hrt_set_log_callback.argtypes = (LogCallback, c_void_p)
    library.hrt_set_log_callback.restype = c_int32
    library.hrt_profile_save.argtypes = (SessionHandle, c_uint64, POINTER(c_char), POINTER(c_uint64))
    library.hrt_profile_save.restype = c_int32
    library.hrt_profile_load.argtypes = (SessionHandle, c_char_p, c_uint64)
    library.hrt_profile_load.restype = c_int32
    library.hrt_recording_start.argtypes = (SessionHandle, c_char_p)
    library.hrt_recording_start.restype = c_int32
    library.hrt_recording_get_status.argtypes = (SessionHandle, POINTER(RecordingStatus))
    library.hrt_recording_get_status.restype = c_int32
    library.hrt_recording_stop.argtypes = (SessionHandle, POINTER(RecordingStatus))
    library.hrt_recording_stop.restype = c_int32
    library.hrt_replay_text.argtypes = (c_char_p, c_uint64, POINTER(ReplayReport))
    library.hrt_replay_text.restype = c_int32
    library.hrt_replay_file.argtypes = (c_char_p, POINTER(ReplayReport))
    library.hrt_replay_file.restype = c_int32
    library.hrt_scene_load_file.argtypes = (c_char_p, POINTER(SceneHandle))
    library.hrt_scene_load_file.restype = c_int32
    library.hrt_scene_load_memory.argtypes = (c_void_p, c_uint64, c_char_p, POINTER(SceneHandle))
    library.hrt_scene_load_memory.restype = c_int32
    library.hrt_scene_destroy.argtypes = (SceneHandle,)
    library.hrt_scene_destroy.restype = c_int32
    library.hrt_scene_get_info.argtypes = (SceneHandle, POINTER(SceneInfo))
    library.hrt_scene_get_info.restype = c_int32
    library.hrt_scene_get_target.argtypes = (SceneHandle, c_uint32, POINTER(SceneTarget))
    library.hrt_scene_get_target.restype = c_int32
    library.hrt_scene_register.argtypes = (SceneHandle, SessionHandle, c_uint32, POINTER(TargetHandle))
    library.hrt_scene_register.restype = c_int32
