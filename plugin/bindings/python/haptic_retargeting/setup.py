"""Setting up in one loop: what the user is asked for, and whether they have done it."""

from __future__ import annotations

from ctypes import byref
from typing import TYPE_CHECKING, Any

from ._abi import Sample, SetupConfig, SetupFlag, SetupResidual, SetupResult, SetupStep, Step
from ._library import check, library, output

if TYPE_CHECKING:
    from .session import Session


class SetUp:
    """A set-up under way, as Session.set_up() begins it; leaving the context cancels what is not over.

        with session.set_up() as setup:
            while not setup.over:
                step = setup.update(finger(plate_deg))
                plate_deg = step.plate_orientation_deg
                show(step.text.decode(), step.place_m)
        print(setup.result)
    """

    def __init__(self, session: Session, what: SetupFlag, fields: dict[str, Any]) -> None:
        self._session = session.handle
        self.over = False
        """Nothing is left to be done."""
        self.result = SetupResult()
        """What was found so far."""
        check(library().hrt_setup_begin(self._session, what, byref(SetupConfig(**fields))))

    def update(self, sample: Sample) -> SetupStep:
        """Takes one sample and returns what to do now. Fits what was done as soon as it is enough, which takes up to a
        second."""
        step = output(SetupStep, library().hrt_setup_update, self._session, byref(sample))
        if step.instruction == Step.FINISH:
            self.result = output(SetupResult, library().hrt_setup_finish, self._session)
            self.over = self.result.left == 0
        return step

    def residual(self, slide: int) -> SetupResidual:
        """A slide of the last calibration that was found, from 0: seen and fitted direction, and whether it was left out."""
        return output(SetupResidual, library().hrt_setup_get_residual, self._session, slide)

    def cancel(self) -> None:
        """Ends it; what was found stays in the session's configuration."""
        check(library().hrt_setup_cancel(self._session))
        self.over = True

    def __enter__(self) -> SetUp:
        return self

    def __exit__(self, *_: object) -> None:
        if not self.over:
            self.cancel()
