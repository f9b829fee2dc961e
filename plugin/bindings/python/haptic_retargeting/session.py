"""Sessions, their targets and gaps, and the profile of the user."""

from __future__ import annotations

import ctypes
import json
import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from ctypes import byref
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _abi
from ._abi import (
    AssignFlag, Conditions, Gap, Place, RecordingStatus, Role, SessionConfig, SetupFlag, StateFlag, TargetConfig,
)
from ._keywords import SessionKeywords, TargetKeywords
from ._library import LOG, Closing, Error, check, library, output
from ._struct import short
from .arrays import SAMPLE, Array, expect_rows
from .reach import Reach
from .record import RunRecord, target_place
from .setup import SetUp


class Target(TargetKeywords):
    """A virtual target, which is displayed to the user, or a real target, to which the hand is steered."""

    def __init__(self, session: Session, handle: _abi.TargetHandle) -> None:
        self.session = session
        self.handle = handle

    @property
    def id(self) -> int:
        """The id of the target. The id of a removed target is never used again."""
        return self.handle.value

    @property
    def config(self) -> TargetConfig:
        """A copy of the target's configuration."""
        return output(TargetConfig, library().hrt_target_get, self.session.handle, self.handle).belongs_to(self.session)

    @property
    def name(self) -> str:
        """The target's name, which may be empty."""
        return self.config.name

    @property
    def role(self) -> Role:
        return self.config.role

    def _configure(self, fields: dict[str, Any]) -> None:
        """Sets fields of TargetConfig and keeps the others. A reach in progress keeps the previous target until
        Reach.retarget()."""
        config = self.config
        for name, value in fields.items():
            setattr(config, name, value)
        check(library().hrt_target_set(self.session.handle, self.handle, byref(config)))

    def remove(self) -> None:
        """Removes the target. A reach in progress keeps its copy."""
        check(library().hrt_target_remove(self.session.handle, self.handle))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Target) and self.id == other.id

    def __hash__(self) -> int:
        return hash(self.id)

    def __repr__(self) -> str:
        try:
            config = self.config
        except Error:
            return f"<Target {self.id}, removed>"
        name = f" {config.name!r}" if config.name else ""
        place = (f"{config.direction_deg:g} deg, {config.distance_m:g} m" if config.place == Place.DIRECTION else
                 f"{[round(x, 4) for x in config.position_m]} m {Place(config.place).name.split('_')[0].lower()}")
        return f"<Target{name}, {Role(config.role).name.lower()}, {place}>"


def own_targets(session: Session, handles: ctypes.Array[_abi.TargetHandle]) -> list[Target]:
    """Converts an array of handles that the library has filled."""
    return [Target(session, _abi.TargetHandle(value=handle.value)) for handle in handles]


def _handles(targets: Sequence[Target]) -> ctypes.Array[_abi.TargetHandle]:
    return (_abi.TargetHandle * len(targets))(*(target.handle for target in targets))


class Session(SessionKeywords, Closing):
    """One user, one plate, and the assumptions of the controller about both.

        with Session(horizon=20, adaptation=Adaptation.REACH) as session:
            cylinder = session.add_real("cylinder", direction_deg=-5)
            cup = session.add_virtual("cup", direction_deg=5)
            record = session.run_reach(cylinder, cup, samples)

    The keywords are the fields of SessionConfig, whose documentation has their units, ranges and defaults. A session is
    for one thread at a time. Warnings that no call can return, such as a clock or unit that is probably wrong, go to
    the logger "haptic_retargeting". Closing a session removes its targets, cancels its reach or set-up, and ends its
    recording.
    """

    def _create(self, fields: dict[str, Any]) -> None:
        self.handle = _abi.SessionHandle()
        check(library().hrt_session_create(_abi.VERSION_NUMBER, byref(SessionConfig(**fields)), byref(self.handle)))
        self._own(self.handle, library().hrt_session_destroy)
        check(library().hrt_host_set_log(self.handle, byref(LOG)))
        self._running: Reach | SetUp | None = None

    def __repr__(self) -> str:
        if not self._destroy.alive:
            return "<Session, closed>"
        return f"<Session: {len(self.targets())} targets, {short(self.state) if self.state else 'idle'}>"

    @property
    def config(self) -> SessionConfig:
        """A copy of the configuration."""
        config = SessionConfig()
        check(library().hrt_session_get(self.handle, byref(config), None))
        return config

    def _configure(self, fields: dict[str, Any]) -> None:
        """Sets fields of SessionConfig between reaches and keeps the others."""
        config = self.config
        for name, value in fields.items():
            setattr(config, name, value)
        check(library().hrt_session_set(self.handle, byref(config)))

    def new_person(self) -> None:
        """Resets the parameters and the fingertip's offset of the user, for another person."""
        check(library().hrt_profile_reset(self.handle))

    def cancel(self) -> None:
        """Cancels the reach or the set-up in progress. Raises Error with WRONG_STATE if nothing is in progress."""
        if self._running is not None and self.state & (StateFlag.REACHING | StateFlag.SETTING_UP):
            self._running.cancel()
        else:
            check(library().hrt_reach_cancel(self.handle))

    def add_real(self, name: str = "", *, direction_deg: float | None = None, distance_m: float | None = None,
                 position_m: ArrayLike | None = None, world_position_m: ArrayLike | None = None) -> Target:
        """Adds a real target, to which the hand is steered. Its position is given by its direction (and distance) from
        the start, in plate coordinates, or in the engine's world."""
        return self._add(Role.REAL, name, direction_deg, distance_m, position_m, world_position_m)

    def add_virtual(self, name: str = "", *, direction_deg: float | None = None, distance_m: float | None = None,
                    position_m: ArrayLike | None = None, world_position_m: ArrayLike | None = None) -> Target:
        """Adds a virtual target, which is displayed to the user. Its position is given as for add_real()."""
        return self._add(Role.VIRTUAL, name, direction_deg, distance_m, position_m, world_position_m)

    def _add(self, role: Role, name: str, direction_deg: float | None, distance_m: float | None,
             position_m: ArrayLike | None, world_position_m: ArrayLike | None) -> Target:
        by_direction = direction_deg is not None or distance_m is not None
        if by_direction + (position_m is not None) + (world_position_m is not None) != 1:
            raise TypeError("a target is placed by direction_deg (with or without distance_m), by position_m, or by "
                            "world_position_m: give exactly one of them")
        place = (Place.DIRECTION if by_direction else
                 Place.PLATE_POSITION if world_position_m is None else Place.WORLD_POSITION)
        fields: dict[str, Any] = {
            "direction_deg": direction_deg, "distance_m": distance_m,
            "position_m": position_m if world_position_m is None else world_position_m,
            "role": role, "place": place, "name": name}
        config = TargetConfig(**{field: value for field, value in fields.items() if value is not None})
        handle = _abi.TargetHandle()
        check(library().hrt_target_add(self.handle, byref(config), byref(handle)))
        return Target(self, handle)

    def target(self, name: str) -> Target:
        """Returns the target with this name. Raises KeyError without such a target."""
        for target in self.targets():
            if target.name == name:
                return target
        raise KeyError(f"no target has the name {name!r}; add the target first")

    def targets(self, role: Role | None = None) -> list[Target]:
        """Returns all targets, or the targets of a role, in the order in which they were added."""
        wanted = 0 if role is None else int(role)
        count = ctypes.c_uint64()
        check(library().hrt_target_list(self.handle, wanted, 0, None, byref(count)))
        handles = (_abi.TargetHandle * count.value)()
        check(library().hrt_target_list(self.handle, wanted, count, handles, byref(count)))
        return own_targets(self, handles)

    def gap(self, real: Target, virtual: Target) -> Gap:
        """Returns the gap between two targets, and the largest feasible gap. Needs no reach."""
        return output(Gap, library().hrt_gap_query, self.handle, real.handle, virtual.handle).belongs_to(self)

    def assign(self, virtuals: Sequence[Target], reals: Sequence[Target], *, exclusive: bool = False) -> list[Gap]:
        """Assigns real targets to as many virtual ones as possible, so that the largest ratio of a gap to the largest
        feasible gap is minimal. With `exclusive`, each real target is assigned to at most one virtual target. A virtual
        target without a real target is not `reachable`."""
        out = (Gap * len(virtuals))(*(Gap() for _ in virtuals))
        check(library().hrt_gap_assign(
            self.handle, _handles(virtuals), len(virtuals), _handles(reals), len(reals),
            AssignFlag.EXCLUSIVE if exclusive else 0, len(out), out))
        return [gap.belongs_to(self) for gap in out]

    @property
    def state(self) -> StateFlag:
        """The state of the session; 0: idle, but no reach can begin, as the real or the virtual target is missing."""
        state = ctypes.c_uint32()
        check(library().hrt_session_get(self.handle, None, byref(state)))
        return StateFlag(state.value)

    def reach(self, real: Target, virtual: Target, *, plate_orientation_deg: float | None = None,
              start_at_finger: bool = False, duration_s: float = 0.0) -> Reach:
        """Begins a reach. `plate_orientation_deg` is the current plate orientation; default: that of the session's last
        command, or 0 before the first. With `start_at_finger`, directions are measured from the finger's first
        position. `duration_s` is the expected duration of the motion, 0 if unknown.

            with session.reach(cylinder, cup) as reach:
                command = reach.update(time_ns, position_m=(x, y, z))
            print(reach.summary.miss_deg)
        """
        self._running = reach = Reach(self, real, virtual, plate_orientation_deg, start_at_finger, duration_s)
        return reach

    def run_reach(self, real: Target, virtual: Target, samples: Array, *,
                  plate_orientation_deg: float | None = None) -> RunRecord:
        """Runs a whole reach over an array of SAMPLE, as Reach.run() does."""
        expect_rows(samples, "samples", SAMPLE)
        config = self.config
        real_deg, real_distance_m = target_place(real.config, config)
        virtual_deg, _ = target_place(virtual.config, config)
        with self.reach(real, virtual, plate_orientation_deg=plate_orientation_deg) as reach:
            commands = reach.run(samples)
            summary = reach.end()
        return RunRecord(
            config=config, real_direction_deg=real_deg, virtual_direction_deg=virtual_deg,
            real_distance_m=real_distance_m, start_position_m=np.array(config.start_position_m), samples=samples,
            commands=commands, results=np.zeros(len(samples), np.int32), summary=summary)

    @contextmanager
    def recording(self, path: str | os.PathLike[str]) -> Iterator[RecordingStatus]:
        """Records the reaches and set-ups within the context to a file. Yields the status, which is set at the end.
        Raises OSError or RuntimeError if the file is not complete."""
        status = RecordingStatus()
        check(library().hrt_recording_start(self.handle, os.fsencode(path)))
        try:
            yield status
        finally:
            check(library().hrt_recording_stop(self.handle, byref(status)))
        if status.system_error != 0:
            raise OSError(status.system_error, os.strerror(status.system_error), os.fspath(path))
        if status.rows_lost != 0:
            raise RuntimeError(f"{os.fspath(path)} lacks {status.rows_lost} calls: the disk was too slow; record to a faster disk")

    def set_up(self, what: SetupFlag = SetupFlag.ALL_MISSING, **fields: Any) -> SetUp:
        """Begins a set-up: a loop that asks the user for touches and slides, and applies the results. The keywords are
        the fields of SetupConfig."""
        self._running = set_up = SetUp(self, what, fields)
        return set_up

    @property
    def profile(self) -> dict[str, Any]:
        """The profile of the user, for json.dump() and load_profile()."""
        length = ctypes.c_uint64()
        check(library().hrt_profile_save(self.handle, 0, None, byref(length)))
        text = ctypes.create_string_buffer(length.value + 1)
        check(library().hrt_profile_save(self.handle, len(text), text, byref(length)))
        return dict(json.loads(text.value))

    def set_conditions(self, *, plate: str = "", tracker: str = "", time_s: int = 0) -> None:
        """Sets the names of plate and tracker, and the time in seconds since 1970; empty and 0: unknown. A calibration
        stores these conditions. If a loaded profile has other names, the library logs a warning."""
        check(library().hrt_profile_set_conditions(self.handle, byref(Conditions(plate=plate, tracker=tracker, time_s=time_s))))

    @property
    def conditions(self) -> Conditions:
        """Conditions under which the user was measured. `differing` flags those that differ from the present ones."""
        return output(Conditions, library().hrt_profile_get_conditions, self.handle)

    def load_profile(self, profile: Mapping[str, Any] | str | bytes) -> None:
        """Copies a profile, a mapping or JSON text, into the configuration. Of the fields that the profile lacks, those
        of the user's traits and of correlated noise are reset to their defaults, and the others are kept."""
        if isinstance(profile, Mapping):
            profile = json.dumps(dict(profile))
        text = profile.encode() if isinstance(profile, str) else profile
        check(library().hrt_profile_load(self.handle, text, len(text)))
