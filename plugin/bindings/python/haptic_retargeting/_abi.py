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


VERSION = (0, 3, 0)
"""Of the headers that this was written from."""
ASSIGN_EXCLUSIVE = 1
"""A real target serves one virtual target at most. Otherwise it may serve any number."""
ASSIGN_TARGETS_MAX = 1000
"""Maximum number of virtual targets, and of real ones, in hrt_target_assign()."""
OK = 0
CALIBRATIONS_MAX = 16
"""Maximum number of calibrations in a process."""
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


class ErrorCode(IntEnum):
    """The C headers' HRT_ERROR_*.

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


class Control(IntEnum):
    """Source of the plate's commands.

    MPC: the model-predictive controller
    FIXED_PLATE: a plate that does not turn, as a baseline
    """

    MPC = 0
    FIXED_PLATE = 1


class Guidance(IntEnum):
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


class Adaptation(IntEnum):
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


class Role(IntEnum):
    """Role of a target.

    REAL: the hand is steered to it
    VIRTUAL: the user sees it and goes to it
    """

    REAL = 1
    VIRTUAL = 2


class Place(IntEnum):
    """How a target's place is given.

    DIRECTION: by `direction_deg` and `distance_m`
    PLATE_POSITION: by `position_m` in plate coordinates
    WORLD_POSITION: by `position_m` in the engine's world
    """

    DIRECTION = 1
    PLATE_POSITION = 2
    WORLD_POSITION = 3


class LogLevel(IntEnum):
    """Level of a log message.

    WARNING
    ERROR
    """

    WARNING = 1
    ERROR = 2


class ReachFlag(IntFlag):
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


class SampleFlag(IntFlag):
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


class CommandFlag(IntFlag):
    """Command.flags.

    HELD: no new decision: the former command is repeated
    PREDICTED: the last step had no sample and was predicted
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
        0.
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


class SessionFlag(IntFlag):
    """SessionConfig.flags.

    PLATE_WAITS: The plate stays where it stands until the finger moves. Otherwise it turns to where the
        first moment of the motion wants it as soon as a reach begins, which brings more fast reaches to the
        target. Set this if the finger rests on the ridges before a reach: a plate that turns under a
        resting finger is felt.
    """

    PLATE_WAITS = 1


class Ending(IntEnum):
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


class StateFlag(IntFlag):
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


AllocatorAllocate = CFUNCTYPE(c_void_p, c_void_p, c_size_t, c_size_t)
"""Returns `size` bytes (at least 1) at a multiple of `alignment` (a power of two), or null on failure."""
AllocatorRelease = CFUNCTYPE(None, c_void_p, c_void_p)
"""Releases memory that allocate() returned. As of free(), it gets no size: an allocator that needs it
keeps it beside the memory."""
LogCallback = CFUNCTYPE(None, c_void_p, c_uint32, c_char_p)
"""Receives what no call can return, for example that a recording's disk is full. `level` is LogLevel.
`text` is one line that names the session and the file, valid during the call. Called on a thread of the
library, one call at a time. It may not call this library or throw."""


class SessionHandle(Struct):
    """A session's handle. Zero is never a session. Handles are never reused.

    value
    """

    if TYPE_CHECKING:
        value: int

    _fields_ = (
        ("value", c_uint64),
    )


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
    tracker_noise_m: Standard deviation of white noise in each tracked coordinate. Raising it smooths
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
    """

    if TYPE_CHECKING:
        struct_size: int
        horizon: int
        step_period_ns: int
        control: int
        guidance: int
        adaptation: int
        flags: int
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
        max_felt_error_deg: float
        motion_bound_deg: float
        tracker_latency_ns: int
        person_mean: ctypes.Array[c_double]
        person_covariance: ctypes.Array[c_double]

    _fields_ = (
        ("struct_size", c_uint32),
        ("horizon", c_uint32),
        ("step_period_ns", c_int64),
        ("control", c_uint32),
        ("guidance", c_uint32),
        ("adaptation", c_uint32),
        ("flags", c_uint32),
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
        ("max_felt_error_deg", c_double),
        ("motion_bound_deg", c_double),
        ("tracker_latency_ns", c_int64),
        ("person_mean", c_double * 9),
        ("person_covariance", c_double * 45),
    )


class TargetHandle(Struct):
    """A target's id within its session. Zero is never a target. Ids are never reused, in any session.

    value
    """

    if TYPE_CHECKING:
        value: int

    _fields_ = (
        ("value", c_uint64),
    )


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
    """Authority over one pair of targets.

    reachable: 1 if the plate can keep the finger on the real target's direction, else 0.
    real_target
    virtual_target
    gap_deg: The virtual direction plus the person's bias, minus the real direction; in [-180, 180).
    largest_gap_deg: Largest gap, to either side, that the plate can sustain for the session's person and
        guidance.
    margin_deg: largest_gap_deg minus the size of the gap; negative: unreachable.
    plate_orientation_deg: Plate orientation (base.h) that sustains the gap; at the bound if unreachable.
    settling_direction_deg: Direction in which the finger settles: the real target's, if reachable.
    paper_largest_gap_deg: largest_gap_deg as the paper has it, from tactile_weight and plate_bound_deg.
        Since version 0.3.
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
        paper_largest_gap_deg: float

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
        ("paper_largest_gap_deg", c_double),
    )


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

    if TYPE_CHECKING:
        struct_size: int
        flags: int
        real_target: TargetHandle
        virtual_target: TargetHandle
        plate_orientation_deg: float
        duration_s: float

    _fields_ = (
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("real_target", TargetHandle),
        ("virtual_target", TargetHandle),
        ("plate_orientation_deg", c_double),
        ("duration_s", c_double),
    )


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
        time_to_go_s: float
        felt_error_deg: float
        predicted_miss_deg: float
        normalised_innovation: float

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
        ("time_to_go_s", c_double),
        ("felt_error_deg", c_double),
        ("predicted_miss_deg", c_double),
        ("normalised_innovation", c_double),
    )


class ReachSummary(Struct):
    """Result of a reach.

    flags: CommandFlag: UNREACHABLE at the end, MISFIT at any time, OFF_TARGET of where the finger ended,
        FAULT. Named `reserved` before version 0.3.
    samples: Samples, and those of them that were dropouts or rejected as outliers.
    dropped_samples
    steps: Model steps with samples, and predicted steps without.
    predicted_steps
    saturated_steps: Steps with samples in which the plate's bound or a stop, or its speed, limited the
        command.
    rate_limited_steps
    final_direction_deg: Direction of the finger in the last step, and that direction minus the real
        target's.
    final_miss_deg
    perceived_direction_deg: Direction that the user felt in the last step, and that direction minus the
        virtual target's and SessionConfig.bias_deg.
    perceived_error_deg
    distance_to_target_m: Distance along the plate from the last position to the real target; from the start
        without positions.
    tactile_weight: Tactile weight and deviation at the end; see Command.
    tactile_weight_sd
    tracker_noise_m: Standard deviation of white noise in each tracked coordinate, learnt or configured.
    motor_variance_deg2: Motor variance: the configured one, corrected by this reach. Since version 0.2.
    motor_variance_sd_deg2: Standard deviation of motor_variance_deg2; close to the configured one if the
        reach had too little data; 0: taken as known. Since version 0.2.
    bearing_error_deg: Bearing of the last position, seen from the start, minus the real target's; 0 without
        positions. This and the following: 0 under FIXED_DIRECTION, since version 0.3.
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
    """

    if TYPE_CHECKING:
        struct_size: int
        flags: int
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
        bearing_error_deg: float
        peak_felt_error_deg: float
        rms_felt_error_deg: float
        normalised_innovation: float
        illusion_curve: float
        illusion_curve_sd: float
        gain_per_s: float
        gain_sd_per_s: float
        bias_deg: float
        bias_sd_deg: float
        habit_deg: float
        habit_sd_deg: float
        duration_s: float

    _fields_ = (
        ("struct_size", c_uint32),
        ("flags", c_uint32),
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
        ("bearing_error_deg", c_double),
        ("peak_felt_error_deg", c_double),
        ("rms_felt_error_deg", c_double),
        ("normalised_innovation", c_double),
        ("illusion_curve", c_double),
        ("illusion_curve_sd", c_double),
        ("gain_per_s", c_double),
        ("gain_sd_per_s", c_double),
        ("bias_deg", c_double),
        ("bias_sd_deg", c_double),
        ("habit_deg", c_double),
        ("habit_sd_deg", c_double),
        ("duration_s", c_double),
    )


class CalibrationHandle(Struct):
    """A calibration's handle. Zero is never a calibration. Handles are never reused.

    value
    """

    if TYPE_CHECKING:
        value: int

    _fields_ = (
        ("value", c_uint64),
    )


class CalibrationConfig(Struct):
    """Configuration of a calibration.

    max_trials: Maximum number of trials. 10 to 10000. Default 200.
    max_samples: Maximum number of samples of all trials; each takes 24 bytes at creation. 100 to 1000000.
        Default 100000: 18 minutes at 90 Hz.
    goal_direction_deg: Direction of the user's target. -180 to 180. Default 0: straight ahead, where the
        motor variance is accurate.
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
    known: 1; or 0: the data cannot determine the value. Then the interval is the range that was searched,
        and the value its likeliest point.
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
    """Parameters of the user; the fields are those of SessionConfig.

    trials: Ended trials, and those of them with a slide of at least 30 mm. Only the latter count.
    trials_used
    tactile_weight: Always known: otherwise hrt_calibration_solve() fails.
    bias_deg: Always known.
    motor_variance_deg2: Known with an accurate tracker; rarely at 1.2 mm of noise.
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
    """Source of the library's memory. Both functions are called from any thread, concurrently. Neither may
    call this library or throw.

    context: Passed to both functions. The library does not read it.
    allocate: Returns `size` bytes (at least 1) at a multiple of `alignment` (a power of two), or null on
        failure.
    release: Releases memory that allocate() returned. As of free(), it gets no size: an allocator that
        needs it keeps it beside the memory.
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
    """State of a recording.

    system_error: errno of the first failed write, after which nothing is written; 0: none.
    rows_written: Calls that the operating system has accepted for writing.
    rows_lost: Calls dropped because the disk was too slow or failed. 0 after stopping: the file is
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
    """Result of a replay.

    complete: 1 if `ending` is Ending.COMPLETE, else 0.
    rows: Rows replayed.
    first_different_line: Line, from 1, of the first row whose result or any number differs from the
        recorded one; 0: all rows are equal, bit for bit.
    hash: FNV-1a hash of the replayed commands, equal on every host: for each successful row "update", flags
        as 8 bytes, step and the eleven numbers after it, least significant byte first.
    ending: Ending. Since version 0.3.
    """

    if TYPE_CHECKING:
        struct_size: int
        complete: int
        rows: int
        first_different_line: int
        hash: int
        ending: int
        reserved: int

    _fields_ = (
        ("struct_size", c_uint32),
        ("complete", c_uint32),
        ("rows", c_uint64),
        ("first_different_line", c_uint64),
        ("hash", c_uint64),
        ("ending", c_uint32),
        ("reserved", c_uint32),
    )


class SceneHandle(Struct):
    """A scene's handle. Zero is never a scene. Handles are never reused.

    value
    """

    if TYPE_CHECKING:
        value: int

    _fields_ = (
        ("value", c_uint64),
    )


class SceneInfo(Struct):
    """The plate of a scene.

    target_count: Number of targets, real and virtual.
    plate_position_m: Pose of the plate in the world; see SessionConfig.
    plate_rotation
    plate_radius_m
    plate_max_speed_deg_s: Maximum speed of the servo, degrees per second; 0: not in the file.
    start_position_m: Start of reaches, in plate coordinates.
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
    served_by: Index of the real target that serves this virtual one: the one that the file names, or else
        the nearest in direction, the first among equals; -1 for a real target.
    position_m: In plate coordinates; y is the height above the plate.
    world_position_m
    direction_deg: From the start, along the plate.
    distance_m
    radius_m: 0: not in the file.
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
    """Declares the types of every function to ctypes; AttributeError names one that the library lacks."""
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
    library.hrt_session_is_valid.argtypes = (SessionHandle,)
    library.hrt_session_is_valid.restype = c_uint32
    library.hrt_session_get_state.argtypes = (SessionHandle, POINTER(c_uint32))
    library.hrt_session_get_state.restype = c_int32
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
    library.hrt_target_list.argtypes = (SessionHandle, c_uint32, c_uint64, POINTER(TargetHandle), POINTER(c_uint64))
    library.hrt_target_list.restype = c_int32
    library.hrt_authority_query.argtypes = (SessionHandle, TargetHandle, TargetHandle, POINTER(Authority))
    library.hrt_authority_query.restype = c_int32
    library.hrt_authority_query_all.argtypes = (SessionHandle, c_uint64, POINTER(Authority), POINTER(c_uint64))
    library.hrt_authority_query_all.restype = c_int32
    library.hrt_authority_query_best.argtypes = (SessionHandle, TargetHandle, POINTER(Authority))
    library.hrt_authority_query_best.restype = c_int32
    library.hrt_target_assign.argtypes = (SessionHandle, POINTER(TargetHandle), c_uint64, POINTER(TargetHandle), c_uint64, c_uint32, c_uint64, POINTER(Authority))
    library.hrt_target_assign.restype = c_int32
    library.hrt_reach_config_default.argtypes = (POINTER(ReachConfig), c_uint32)
    library.hrt_reach_config_default.restype = c_int32
    library.hrt_reach_begin.argtypes = (SessionHandle, POINTER(ReachConfig))
    library.hrt_reach_begin.restype = c_int32
    library.hrt_reach_update.argtypes = (SessionHandle, POINTER(Sample), POINTER(Command))
    library.hrt_reach_update.restype = c_int32
    library.hrt_reach_retarget.argtypes = (SessionHandle, TargetHandle, TargetHandle)
    library.hrt_reach_retarget.restype = c_int32
    library.hrt_reach_cancel.argtypes = (SessionHandle,)
    library.hrt_reach_cancel.restype = c_int32
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
    library.hrt_scene_register.argtypes = (SceneHandle, SessionHandle, c_uint64, POINTER(TargetHandle))
    library.hrt_scene_register.restype = c_int32
    library.hrt_profile_save.argtypes = (SessionHandle, c_uint64, POINTER(c_char), POINTER(c_uint64))
    library.hrt_profile_save.restype = c_int32
    library.hrt_profile_load.argtypes = (SessionHandle, c_char_p, c_uint64)
    library.hrt_profile_load.restype = c_int32
