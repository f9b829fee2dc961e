"""A set-up, which instructs the user in one loop and applies the results."""

from __future__ import annotations

from ctypes import byref
from typing import TYPE_CHECKING, Any

from ._abi import Sample, SetupConfig, SetupFlag, SetupResidual, SetupResult, SetupStep, Step
from ._library import check, library, output
from .arrays import known_sample

if TYPE_CHECKING:
    from .session import Session


class SetUp:
    """A set-up in progress, from Session.set_up(). Leaving the context cancels a set-up that is not over.

        with session.set_up() as setup:
            while not setup.over:
                step = setup.update(finger(plate_deg))
                plate_deg = step.plate_orientation_deg
                show(step.text, step.place_m)
        print(setup.result)
    """

    def __init__(self, session: Session, what: SetupFlag, fields: dict[str, Any]) -> None:
        self._session = session.handle
        self.over = False
        """True after every part has a result or was dropped, or the set-up was cancelled."""
        self.result = SetupResult()
        """Results of the finished parts."""
        check(library().hrt_setup_begin(self._session, what, byref(SetupConfig(**fields))))

    def update(self, sample: Sample) -> SetupStep:
        """Processes one sample and returns the next instruction. At Step.FINISH the user waits for a fit, which each
        update continues for at most a few milliseconds."""
        step = output(SetupStep, library().hrt_setup_update, self._session, byref(known_sample(sample)))
        if step.instruction == Step.FINISH:
            self.result = output(SetupResult, library().hrt_setup_finish, self._session)
            self.over = self.result.left == 0
        return step

    def residual(self, slide: int) -> SetupResidual:
        """Returns measured and fitted direction of slide `slide` (from 0) of the last calibration."""
        return output(SetupResidual, library().hrt_setup_get_residual, self._session, slide)

    def cancel(self) -> None:
        """Ends the set-up. Results of finished parts stay in the session's configuration."""
        check(library().hrt_setup_cancel(self._session))
        self.over = True

    def __enter__(self) -> SetUp:
        return self

    def __exit__(self, *_: object) -> None:
        if not self.over:
            self.cancel()
