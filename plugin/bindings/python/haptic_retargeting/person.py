"""A simulated person, who feels the ridges of the plate and is deflected by them."""

from __future__ import annotations

from ctypes import byref
from typing import Any

from . import _abi
from ._abi import PersonConfig, PersonState, Sample
from ._keywords import PersonKeywords
from ._library import Closing, check, library, output
from .session import Session, Target


class Person(PersonKeywords, Closing):
    """A simulated finger for first programs and tests: a model, not a measurement of people. The keywords are the
    fields of PersonConfig. The same seed and keywords give the same person on every platform.

        with Person(seed=1) as person, session.reach(cylinder, cup) as reach:
            person.begin(session, cup)
            plate_deg = 0.0
            for frame in range(220):
                plate_deg = reach.update_sample(person.move(frame * 11_111_111, plate_deg)).plate_orientation_deg
    """

    def _create(self, seed: int, fields: dict[str, Any]) -> None:
        self.handle = _abi.PersonHandle()
        check(library().hrt_person_create(byref(PersonConfig(**fields)), seed, byref(self.handle)))
        self._own(self.handle, library().hrt_person_destroy)

    def begin(self, session: Session, virtual: Target | None = None) -> None:
        """Begins a reach: the finger rests at the session's start for 0.6 s, and then slides towards the virtual
        target. Without a target, the person follows the instructions of the session's set-up."""
        target = _abi.TargetHandle() if virtual is None else virtual.handle
        check(library().hrt_person_begin(self.handle, session.handle, target))

    def move(self, time_ns: int, plate_orientation_deg: float) -> Sample:
        """Commands the simulated servo, advances the simulation to `time_ns`, and returns a sample of tracker and
        servo."""
        return output(Sample, library().hrt_person_move, self.handle, time_ns, plate_orientation_deg)

    @property
    def state(self) -> PersonState:
        """True state, such as the actual and the perceived position of the finger. Not available in a set-up."""
        return output(PersonState, library().hrt_person_get_state, self.handle)
