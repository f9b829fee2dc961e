"""One reach: samples of the finger in, commands for the plate out."""

from __future__ import annotations

import ctypes
import time
from ctypes import byref
from typing import Protocol

from . import _abi
from ._abi import Command, Contact, ContactFlag, ReachConfig, ReachFlag, ReachSummary, RecordingStatus, Sample, SampleFlag
from ._struct import Numbers
from ._library import Error, check, library, output
from .arrays import COMMAND, SAMPLE, Array, commands, expect_rows


class Pace:
    """Has a run over an array wait for the disk of its recording, which it would outrun, so that calls were lost. Single
    steps never wait: a plate may hang on them."""

    ROWS = 1024  # between two looks; the library holds 8192
    STALLED_S = 5.0

    def __init__(self, session: _abi.SessionHandle) -> None:
        self._session = session
        self.calls = 0

    def wait(self) -> None:
        """Returns once the disk is not far behind the calls made, or has stalled."""
        status = RecordingStatus()
        give_up = time.monotonic() + self.STALLED_S
        while time.monotonic() < give_up:
            if library().hrt_recording_get_status(self._session, byref(status)) != _abi.OK:
                return  # the recording has ended before the reach
            if self.calls - status.rows_written - status.rows_lost <= 4 * self.ROWS:
                return
            time.sleep(0.001)


class HasHandle(Protocol):
    """A Target."""

    handle: _abi.TargetHandle


def handle_of(target: HasHandle, name: str) -> _abi.TargetHandle:
    """The handle of what should be a Target; TypeError names the argument that is none."""
    handle = getattr(target, "handle", None)
    if not isinstance(handle, _abi.TargetHandle):
        raise TypeError(f"{name} is {target!r}: a Target is needed, as add_real(), add_virtual() and target() return")
    return handle


def _given(struct: Sample | Contact, field: str, value: object, flag: int) -> int:
    """Sets a field that is given, and returns the flag that says so, or 0."""
    if value is None:
        return 0
    setattr(struct, field, value)
    return int(flag)


class Reach:
    """A running reach, made by Session.reach(). Leaving its context ends it and fills in `summary`."""

    def __init__(self, session: _abi.SessionHandle, real: _abi.TargetHandle, virtual: _abi.TargetHandle,
                 plate_orientation_deg: float | None, start_at_finger: bool, duration_s: float, pace: Pace | None) -> None:
        config = ReachConfig(real_target=real, virtual_target=virtual, duration_s=duration_s)
        if plate_orientation_deg is not None:
            config.flags |= ReachFlag.PLATE_ORIENTATION
            config.plate_orientation_deg = plate_orientation_deg
        if start_at_finger:
            config.flags |= ReachFlag.START_AT_FINGER
        check(library().hrt_reach_begin(session, byref(config)))
        self._session = session
        self._pace = pace
        self._command = Command()
        self._cancelled = False
        self._summary: ReachSummary | None = None

    @property
    def summary(self) -> ReachSummary:
        """What became of the reach. RuntimeError before its end, and of a reach that was cancelled."""
        if self._summary is None:
            raise RuntimeError("the reach was cancelled" if self._cancelled else "the reach has not ended")
        return self._summary

    def update(self, time_ns: int, *, direction_deg: float | None = None, position_m: Numbers | None = None,
               world_position_m: Numbers | None = None, plate_orientation_deg: float | None = None,
               lifted: bool = False) -> Command:
        """Processes one sample and returns the command for the plate. The arguments are those of samples(); without
        a direction or position the finger is not seen."""
        sample = Sample(time_ns=time_ns)
        sample.flags = SampleFlag((SampleFlag.LIFTED if lifted else 0)
                                  | _given(sample, "finger_direction_deg", direction_deg, SampleFlag.DIRECTION)
                                  | _given(sample, "finger_position_m", position_m, SampleFlag.PLATE_POSITION)
                                  | _given(sample, "finger_position_m", world_position_m, SampleFlag.WORLD_POSITION)
                                  | _given(sample, "plate_orientation_deg", plate_orientation_deg, SampleFlag.PLATE_ORIENTATION))
        return self.update_sample(sample)

    def update_sample(self, sample: Sample) -> Command:
        """As update(), with a Sample that the caller has filled."""
        check(library().hrt_reach_update(self._session, byref(sample), byref(self._command)))
        if self._pace is not None:
            self._pace.calls += 1
        return Command.from_buffer_copy(self._command)

    def run(self, samples: Array, out: Array | None = None) -> Array:
        """Takes an array of SAMPLE in, one after the other, and returns the array of COMMAND.

        Neither array is copied. With `out`, commands go there; after an error it has those before it.
        """
        expect_rows(samples, "samples", SAMPLE)
        if out is None:
            out = commands(len(samples))
        expect_rows(out, "out", COMMAND)
        if len(out) != len(samples) or not out.flags.writeable:
            raise ValueError(f"out must be writeable and have {len(samples)} rows, as samples has")
        for first in range(0, len(samples), Pace.ROWS):
            rows = range(first, min(first + Pace.ROWS, len(samples)))
            if self._pace is not None:
                self._pace.wait()
                self._pace.calls += len(rows)
            self._run_rows(rows, samples.ctypes.data, out.ctypes.data)
        return out

    def _run_rows(self, rows: range, samples_at: int, commands_at: int) -> None:
        """By addresses, which is quicker than by objects."""
        update, session = _update_at(), self._session
        for row in rows:
            result = update(session, samples_at + row * SAMPLE.itemsize, commands_at + row * COMMAND.itemsize)
            if result != _abi.OK:
                text = library().hrt_last_error().decode(errors="replace")
                raise Error(result, f"samples[{row}]: {text}")

    def retarget(self, real: HasHandle, virtual: HasHandle) -> None:
        """Leads the reach to other targets from now on, or to the same ones after they were moved."""
        check(library().hrt_reach_retarget(
            self._session, handle_of(real, "real"), handle_of(virtual, "virtual")))

    def touched(self, position_m: Numbers | None = None, sd_m: float = 0.0, *,
                world_position_m: Numbers | None = None) -> None:
        """The finger has met the real object: at the real target's near side, or at a place on the plate or in the world
        that is known to `sd_m`, by default to the real target's radius. Later reaches correct the tracker's frame, about
        a registration. Once a reach, before its end or after it."""
        contact = Contact(sd_m=sd_m)
        contact.flags = ContactFlag(_given(contact, "position_m", position_m, ContactFlag.PLATE_POSITION)
                                    | _given(contact, "position_m", world_position_m, ContactFlag.WORLD_POSITION))
        check(library().hrt_reach_touched(self._session, byref(contact)))

    def cancel(self) -> None:
        """Ends the reach without a summary; nothing is learnt from it."""
        check(library().hrt_reach_cancel(self._session))
        self._cancelled = True

    def end(self) -> ReachSummary:
        """Ends the reach and returns its summary."""
        self._summary = output(ReachSummary, library().hrt_reach_end, self._session)
        return self._summary

    def __enter__(self) -> Reach:
        return self

    def __exit__(self, kind: object, *_: object) -> None:
        if self._summary is None and not self._cancelled:
            try:
                self.end()
            except Error as error:
                if error.code == _abi.ErrorCode.INSUFFICIENT_DATA:
                    self.cancel()  # without a sample there is no summary
                elif kind is None:  # else what went wrong within the context is what is to be seen
                    raise


def _update_at() -> ctypes._FuncPointer:
    """hrt_reach_update(), to be called with addresses."""
    prototype = ctypes.CFUNCTYPE(ctypes.c_int32, _abi.SessionHandle, ctypes.c_void_p, ctypes.c_void_p)
    return prototype(ctypes.cast(library().hrt_reach_update, ctypes.c_void_p).value or 0)
