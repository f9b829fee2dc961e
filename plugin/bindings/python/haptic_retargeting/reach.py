"""One reach, which receives samples of the finger and returns commands for the plate."""

from __future__ import annotations

import ctypes
from ctypes import byref
from typing import TYPE_CHECKING

from . import _abi
from ._abi import Command, Contact, ContactFlag, ReachConfig, ReachFlag, ReachSummary, RecordingStatus, Sample, SampleFlag
from ._struct import Numbers
from ._library import LOG, Error, check, error, library, output
from .arrays import COMMAND, SAMPLE, Array, commands, expect_rows, known, known_sample

if TYPE_CHECKING:
    from .session import Session, Target


_ROWS = 4096  # rows between two waits for the disk of a recording; the library's buffer holds 8192


def _given(struct: Sample | Contact, field: str, value: object, flag: int) -> int:
    """Sets a field if a value is given. Returns the field's flag, or 0 without a value."""
    if value is None:
        return 0
    setattr(struct, field, value)
    return int(flag)


class Reach:
    """A reach in progress, from Session.reach(). Leaving the context ends the reach and sets `summary`; it cancels a
    reach that had no sample, and a reach after an exception."""

    def __init__(self, session: Session, real: Target, virtual: Target, plate_orientation_deg: float | None,
                 start_at_finger: bool, duration_s: float) -> None:
        config = ReachConfig(real_target=real, virtual_target=virtual, duration_s=duration_s)
        if plate_orientation_deg is not None:
            config.flags |= ReachFlag.PLATE_ORIENTATION
            config.plate_orientation_deg = plate_orientation_deg
        if start_at_finger:
            config.flags |= ReachFlag.START_AT_FINGER
        check(library().hrt_reach_begin(session.handle, byref(config)))
        self._session = session.handle
        self._command = Command()
        self._cancelled = False
        self._summary: ReachSummary | None = None

    @property
    def summary(self) -> ReachSummary:
        """The result of the reach. Raises RuntimeError before its end, and if it was cancelled."""
        if self._summary is None:
            raise RuntimeError("the reach was cancelled, so it has no summary" if self._cancelled else "the reach has not ended: call end() first")
        return self._summary

    def update(self, time_ns: int, *, direction_deg: float | None = None, position_m: Numbers | None = None,
               world_position_m: Numbers | None = None, plate_orientation_deg: float | None = None,
               lifted: bool = False) -> Command:
        """Processes one sample and returns the command for the plate. The arguments are those of samples(). A sample
        with neither direction nor position, or with NaN in them, is a dropout, unless `lifted`."""
        sample = Sample(time_ns=time_ns)
        sample.flags = SampleFlag((SampleFlag.LIFTED if lifted else 0)
                                  | _given(sample, "finger_direction_deg", direction_deg, SampleFlag.DIRECTION)
                                  | _given(sample, "finger_position_m", position_m, SampleFlag.PLATE_POSITION)
                                  | _given(sample, "finger_position_m", world_position_m, SampleFlag.WORLD_POSITION)
                                  | _given(sample, "plate_orientation_deg", plate_orientation_deg, SampleFlag.PLATE_ORIENTATION))
        return self.update_sample(sample)

    def update_sample(self, sample: Sample) -> Command:
        """Does the same as update() with a Sample that the caller has filled."""
        check(library().hrt_reach_update(self._session, byref(known_sample(sample)), byref(self._command)))
        return Command.from_buffer_copy(self._command)

    def run(self, samples: Array, out: Array | None = None) -> Array:
        """Processes an array of SAMPLE and returns an array of COMMAND, which is `out` if given. After an error, `out`
        has the commands of the samples before the failed one. Arrays are not copied, unless a field with its flag has
        NaN, which counts as unknown."""
        expect_rows(samples, "samples", SAMPLE)
        if out is None:
            out = commands(len(samples))
        expect_rows(out, "out", COMMAND)
        if len(out) != len(samples) or not out.flags.writeable:
            raise ValueError(f"out must be writeable and have {len(samples)} rows, as samples has")
        samples = known(samples)
        update, samples_at, commands_at = _update_at(), samples.ctypes.data, out.ctypes.data
        for row in range(len(samples)):
            if row % _ROWS == 0:  # waits for the disk of a recording; without a recording, the call fails without effect
                library().hrt_recording_flush(self._session, byref(RecordingStatus()))
            result = update(self._session, samples_at + row * SAMPLE.itemsize, commands_at + row * COMMAND.itemsize)
            if result != _abi.OK:
                raise error(result, f"samples[{row}]: ")
        return out

    def retarget(self, real: Target, virtual: Target) -> None:
        """Redirects the reach to other targets, or to the same targets after they were moved."""
        check(library().hrt_reach_retarget(self._session, real.handle, virtual.handle))

    def touched(self, position_m: Numbers | None = None, sd_m: float = 0.0, *,
                world_position_m: Numbers | None = None) -> None:
        """Reports contact of the finger with the real object: at the near side of the real target, or at a position on
        the plate or in the world. `sd_m` is the standard deviation of a coordinate; 0: the radius of the real target,
        or 10 mm if the radius is unknown. The contact corrects the tracked positions of later reaches. Requires a
        registration. Allowed once per reach, also after its end."""
        contact = Contact(sd_m=sd_m)
        contact.flags = ContactFlag(_given(contact, "position_m", position_m, ContactFlag.PLATE_POSITION)
                                    | _given(contact, "position_m", world_position_m, ContactFlag.WORLD_POSITION))
        check(library().hrt_reach_touched(self._session, byref(contact)))

    def cancel(self) -> None:
        """Ends the reach without a summary, and discards its estimates and its contact."""
        check(library().hrt_reach_cancel(self._session))
        self._cancelled = True
        self._log()

    def end(self) -> ReachSummary:
        """Ends the reach and returns its summary."""
        self._summary = output(ReachSummary, library().hrt_reach_end, self._session)
        self._log()
        return self._summary

    def _log(self) -> None:
        """Logs warnings that updates have stored, because updates may not block."""
        check(library().hrt_host_set_log(self._session, byref(LOG)))

    def __enter__(self) -> Reach:
        return self

    def __exit__(self, kind: object, *_: object) -> None:
        if self._summary is not None or self._cancelled:
            return
        try:
            if kind is None:
                self.end()
            else:
                self.cancel()
        except Error as failed:
            if kind is None and failed.code == _abi.ErrorCode.INSUFFICIENT_DATA:
                self.cancel()  # a reach without a sample has no summary
            elif kind is None:  # otherwise the exception within the context is reported
                raise


def _update_at() -> ctypes._FuncPointer:
    """Returns hrt_reach_update() with a prototype that accepts addresses, which are faster than objects."""
    prototype = ctypes.CFUNCTYPE(ctypes.c_int32, _abi.SessionHandle, ctypes.c_void_p, ctypes.c_void_p)
    return prototype(ctypes.cast(library().hrt_reach_update, ctypes.c_void_p).value or 0)
