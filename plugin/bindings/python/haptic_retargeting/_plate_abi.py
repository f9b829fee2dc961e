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


__all__ = [
    "PlateFault", "PlateOptions", "PlateReport", "PlateReportFlag", "PlateState",
]


class PlateState(Choice):
    """What a plate is doing.

    OPENING: being greeted: up to 6 s, because boards start when their line is opened
    READY: takes commands
    FAILED: was stopped if it still heard; PlateReport.message has the reason
    """

    OPENING = 1
    READY = 2
    FAILED = 3


class PlateFault(Choice):
    """Why a plate has failed.

    NONE: it has not failed
    LINE: the line cannot be opened or set up, or is in use
    NO_ANSWER: nothing answers as such a plate
    UNPLUGGED: the line is gone, or takes nothing in
    SILENT: not heard for half a second
    NO_REPORT: does not report its orientation
    LIMITS: reports an angle beyond its limits, or refused one
    STUCK: commanded, and not moving
    RESTARTED: restarted, or announced itself anew
    EMERGENCY: its emergency stop is open
    DEVICE: reports a fault: voltage, temperature, overload ...
    PROTOCOL: answers what the protocol does not allow
    INTERNAL: out of memory, or a defect of this library
    """

    NONE = 0
    LINE = 1
    NO_ANSWER = 2
    UNPLUGGED = 3
    SILENT = 4
    NO_REPORT = 5
    LIMITS = 6
    STUCK = 7
    RESTARTED = 8
    EMERGENCY = 9
    DEVICE = 10
    PROTOCOL = 11
    INTERNAL = 12


class PlateReportFlag(Flags):
    """What a report holds.

    ORIENTATION: the orientation is known
    MEASURED: by a sensor; else it is assumed from the commands
    ROUND_TRIP: the line was measured
    COMMANDED: a command holds; else the plate stays where it is
    HOST_SILENT: stopped by PlateOptions.host_timeout_ns
    """

    ORIENTATION = 1
    MEASURED = 2
    ROUND_TRIP = 4
    COMMANDED = 8
    HOST_SILENT = 16


@laid_out
class PlateHandle(Struct):
    """A plate. Zero is never one.

    value
    """

    value: UInt64

    if TYPE_CHECKING:
        def __init__(
            self, *, value: int = ...,
        ) -> None: ...


@laid_out
class PlateOptions(Struct):
    """How to treat a plate.

    host_timeout_ns: After this time without hrt_plate_set(), hrt_plate_stop() or hrt_plate_get() the plate
        stops where it is: an application that hangs leaves no moving plate. The next hrt_plate_set() moves
        it again. 50 ms to 10 s, default 300 ms.
    """

    struct_size: UInt32
    reserved: UInt32
    host_timeout_ns: Int64

    if TYPE_CHECKING:
        def __init__(
            self, *, host_timeout_ns: int = ...,
        ) -> None: ...


@laid_out
class PlateReport(Struct):
    """What is known of a plate. All numbers are finite, and 0 while they are unknown.

    state: What it is doing: PlateState.
    fault: Why it has failed: PlateFault.
    flags: What the report holds: PlateReportFlag.
    orientation_deg: As last reported, degrees, -360 to 360; base.h defines it. For
        hrt_sample.plate_orientation_deg.
    command_deg: Orientation that was last sent, within the stops.
    age_ns: Time since the report of the orientation arrived.
    latency_ns: From a command to the plate's motion: the plate's own, and half of the round trip. For
        hrt_session_config.plate_latency_ns, if it is not 0.
    round_trip_ns: Of a message and its answer on the line, median.
    max_speed_deg_s: The plate's own, or less if it was seen to turn slower. For
        hrt_session_config.plate_max_speed_deg_s.
    lower_stop_deg: Stops, or both 0 if the plate turns freely. For hrt_session_config, if they are 180
        degrees apart or more.
    upper_stop_deg
    refused_messages: Messages that the plate refused, or that were damaged on their way.
    description: The device, in one line of UTF-8: "protocol 2, firmware 1.0.0, serial number 000042".
    message: Why the plate has failed, in one line of UTF-8: "the plate at /dev/ttyACM0 is unplugged".
    """

    struct_size: UInt32
    state: PlateState
    fault: PlateFault
    flags: PlateReportFlag
    orientation_deg: Double
    command_deg: Double
    age_ns: Int64
    latency_ns: Int64
    round_trip_ns: Int64
    max_speed_deg_s: Double
    lower_stop_deg: Double
    upper_stop_deg: Double
    refused_messages: UInt64
    description: Annotated[bytes, c_char * 128]
    message: Annotated[bytes, c_char * 256]

    if TYPE_CHECKING:
        def __init__(
            self, *, state: PlateState = ..., fault: PlateFault = ..., flags: PlateReportFlag = ...,
            orientation_deg: float = ..., command_deg: float = ..., age_ns: int = ..., latency_ns: int = ...,
            round_trip_ns: int = ..., max_speed_deg_s: float = ..., lower_stop_deg: float = ...,
            upper_stop_deg: float = ..., refused_messages: int = ..., description: str | bytes = ...,
            message: str | bytes = ...,
        ) -> None: ...


FUNCTIONS: dict[str, tuple[Any, ...]] = {
    "hrt_plate_options_default": (c_int32, POINTER(PlateOptions), c_uint32),
    "hrt_plate_open": (c_int32, c_char_p, POINTER(PlateOptions), POINTER(PlateHandle)),
    "hrt_plate_set": (c_int32, PlateHandle, c_double),
    "hrt_plate_stop": (c_int32, PlateHandle),
    "hrt_plate_get": (c_int32, PlateHandle, POINTER(PlateReport)),
    "hrt_plate_close": (c_int32, PlateHandle),
    "hrt_plate_last_error": (c_char_p,),
}
"""The types of each function's result and parameters."""
