"""A simulated person, who feels the plate and is bent by it."""

from __future__ import annotations

from ctypes import byref
from typing import Any

from . import _abi
from ._abi import PersonConfig, PersonState, Sample
from ._closing import Closing
from ._keywords import PersonKeywords
from ._library import check, library, output
from .reach import HasHandle, handle_of
from .session import Session


class Person(PersonKeywords, Closing):
    """A finger for first programs and tests: a model, and no measurement of people. The same seed and keywords, which are
    the fields of PersonConfig, are the same person on every host.

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

    def begin(self, session: Session, virtual: HasHandle) -> None:
        """At rest at the session's start, for 0.6 s; then they slide to the virtual target."""
        check(library().hrt_person_begin(self.handle, session.handle, handle_of(virtual, "virtual")))

    def move(self, time_ns: int, plate_orientation_deg: float) -> Sample:
        """Commands the plate's servo, lets time pass until `time_ns`, and returns what tracker and servo report."""
        return output(Sample, library().hrt_person_move, self.handle, time_ns, plate_orientation_deg)

    @property
    def state(self) -> PersonState:
        """Where the finger is, and where it is felt."""
        return output(PersonState, library().hrt_person_get_state, self.handle)
