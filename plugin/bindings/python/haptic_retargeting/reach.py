"""One reach: samples of the finger in, commands for the plate out."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from ctypes import byref
from typing import TYPE_CHECKING

from . import _abi
from ._abi import Command, ReachConfig, ReachFlag, ReachSummary, Sample, SampleFlag
from ._library import Error, check, library
from .arrays import COMMAND, SAMPLE, Array, commands

if TYPE_CHECKING:
    from .session import Session, Target


class Reach:
    """A reach under way, made by Session.reach(). Leaving its context ends it and fills in `summary`."""

    def __init__(self, session: Session, real: Target, virtual: Target, plate_orientation_deg: float | None) -> None:
        config = ReachConfig()
        check(library().hrt_reach_config_default(byref(config), ctypes.sizeof(config)))
        config.real_target = real.handle
        config.virtual_target = virtual.handle
        if plate_orientation_deg is not None:
            config.flags = ReachFlag.PLATE_ORIENTATION
            config.plate_orientation_deg = plate_orientation_deg
        check(library().hrt_reach_begin(session.handle, byref(config)))
        self._session = session
        self._command = Command()
        self.summary: ReachSummary | None = None
        """What became of the reach, once it has ended."""

    def update(self, time_ns: int, *, direction_deg: float | None = None, position_m: Sequence[float] | None = None,
               world_position_m: Sequence[float] | None = None, plate_orientation_deg: float | None = None,
               lifted: bool = False) -> Command:
        """Takes one sample in and tells what the plate is to do now. The arguments are those of samples(); without
        a direction or position the finger is not seen."""
        sample = Sample(time_ns=time_ns)
        flags = SampleFlag.LIFTED if lifted else SampleFlag(0)
        if direction_deg is not None:
            flags |= SampleFlag.DIRECTION
            sample.finger_direction_deg = direction_deg
        if position_m is not None:
            flags |= SampleFlag.PLATE_POSITION
            setattr(sample, "finger_position_m", position_m)
        if world_position_m is not None:
            flags |= SampleFlag.WORLD_POSITION
            setattr(sample, "finger_position_m", world_position_m)
        if plate_orientation_deg is not None:
            flags |= SampleFlag.PLATE_ORIENTATION
            sample.plate_orientation_deg = plate_orientation_deg
        sample.flags = flags
        return self.update_sample(sample)

    def update_sample(self, sample: Sample) -> Command:
        """As update(), with a Sample that the caller has filled."""
        check(library().hrt_reach_update(self._session.handle, byref(sample), byref(self._command)))
        return Command.from_buffer_copy(self._command)

    def run(self, samples: Array, out: Array | None = None) -> Array:
        """Takes an array of SAMPLE in, one after the other, and returns the array of COMMAND.

        Neither array is copied. With `out`, commands go there; after an error it has those before it.
        """
        _expect_rows(samples, "samples", SAMPLE)
        if out is None:
            out = commands(len(samples))
        _expect_rows(out, "out", COMMAND)
        if len(out) != len(samples) or not out.flags.writeable:
            raise ValueError(f"out must be writeable and have {len(samples)} rows, as samples has")
        out["struct_size"] = COMMAND.itemsize
        update = _update_at()
        handle, sample, command = self._session.handle, samples.ctypes.data, out.ctypes.data
        for row in range(len(samples)):
            result = update(handle, sample, command)
            if result != _abi.OK:
                text = library().hrt_last_error().decode(errors="replace")
                raise Error(result, f"samples[{row}]: {text}")
            sample += SAMPLE.itemsize
            command += COMMAND.itemsize
        return out

    def end(self) -> ReachSummary:
        """Ends the reach and tells what became of it."""
        summary = ReachSummary()
        check(library().hrt_reach_end(self._session.handle, byref(summary)))
        self.summary = summary
        return summary

    def __enter__(self) -> Reach:
        return self

    def __exit__(self, kind: object, *_: object) -> None:
        if self.summary is None:
            try:
                self.end()
            except Error:
                # What went wrong within the context is what is to be seen.
                if kind is None:
                    raise


def _expect_rows(array: Array, name: str, dtype: object) -> None:
    if array.dtype != dtype or array.ndim != 1 or not array.flags.c_contiguous:
        raise TypeError(f"{name} must be one contiguous row of {dtype}, as haptic_retargeting.samples() makes")


def _update_at() -> ctypes._FuncPointer:
    """hrt_reach_update() by addresses, which is quicker than by objects."""
    prototype = ctypes.CFUNCTYPE(ctypes.c_int32, _abi.SessionHandle, ctypes.c_void_p, ctypes.c_void_p)
    return prototype(ctypes.cast(library().hrt_reach_update, ctypes.c_void_p).value or 0)
