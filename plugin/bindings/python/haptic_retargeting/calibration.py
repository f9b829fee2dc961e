"""Who is this user? Their parameters from slides over a plate that stands still."""

from __future__ import annotations

import ctypes
from ctypes import byref
from typing import Any

from . import _abi
from ._abi import CalibrationComparison, CalibrationConfig, CalibrationResult, CalibrationSlide
from ._closing import Closing
from ._keywords import CalibrationKeywords, SessionKeywords
from ._library import Error, check, library, output
from .arrays import SAMPLE, Array, expect_samples
from .session import Session


class Calibration(CalibrationKeywords, Closing):
    """Slides of one user, and the parameters fitted to them.

        with Calibration(session) as calibration:
            while True:
                plate_deg, enough = calibration.next_angle()
                if enough:
                    break
                calibration.add_trial(plate_deg, slide(plate_deg))   # yours: turns the plate, returns samples
            result = calibration.solve()
        session.apply_calibration(result)

    The keywords are the fields of CalibrationConfig. The plate's place, the lift height and the step period are
    those of the session as it is now. One thread at a time.
    """

    def _create(self, session: SessionKeywords, fields: dict[str, Any]) -> None:
        if not isinstance(session, Session):
            raise TypeError(f"session is {session!r}: a Session is needed")
        config = CalibrationConfig(**fields)
        self.handle = _abi.CalibrationHandle()
        check(library().hrt_calibration_create(session.handle, byref(config), byref(self.handle)))
        self._own(self.handle, library().hrt_calibration_destroy)

    def add_trial(self, plate_orientation_deg: float, samples: Array) -> None:
        """Adds one slide: an array of SAMPLE, with the plate at rest. After an error the trial is forgotten."""
        expect_samples(samples)
        check(library().hrt_calibration_begin_trial(self.handle, plate_orientation_deg))
        for row in range(len(samples)):
            sample = _abi.Sample.from_address(samples.ctypes.data + row * SAMPLE.itemsize)
            result = library().hrt_calibration_add_sample(self.handle, byref(sample))
            if result != _abi.OK:
                error = Error(result, f"samples[{row}]: {library().hrt_last_error().decode(errors='replace')}")
                check(library().hrt_calibration_end_trial(self.handle, 0))
                raise error
        check(library().hrt_calibration_end_trial(self.handle, 1))

    def next_angle(self) -> tuple[float, bool]:
        """Plate orientation for the next slide, degrees, and whether the slides so far are enough."""
        angle = ctypes.c_double()
        enough = ctypes.c_uint32()
        check(library().hrt_calibration_next_angle(self.handle, byref(angle), byref(enough)))
        return angle.value, enough.value != 0

    def residual(self, slide: int) -> CalibrationSlide:
        """A slide of the last solve(), from 0 to trials_used - 1: seen and fitted direction, and whether it
        was left out."""
        return output(CalibrationSlide, library().hrt_calibration_get_residual, self.handle, slide)

    def solve(self) -> CalibrationResult:
        """Fits the user to the trials, which stay. Takes some 50 microseconds a sample."""
        return output(CalibrationResult, library().hrt_calibration_solve, self.handle)


def compare_calibrations(first: CalibrationResult, second: CalibrationResult) -> CalibrationComparison:
    """Test and retest: which values of two calibrations differ, and the differences, second less first, with their
    95 % intervals."""
    return output(CalibrationComparison, library().hrt_calibration_compare, byref(first), byref(second))
