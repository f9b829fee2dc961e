"""Runs the scenario of all hosts (../scenario.txt) by Session and the functions of the package."""

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import haptic_retargeting as hrt
from haptic_retargeting import _abi

SCENARIO = Path(os.environ["HRT_SCENARIO"])


def calls_of(session: hrt.Session) -> dict[str, Callable[..., Any]]:
    """Returns the calls of the scenario by name; their arguments are texts."""
    targets: dict[str, hrt.Target] = {}
    kept: dict[str, Any] = {}  # the running reach, and the saved profile

    def target(role: str, name: str, direction_deg: str, distance_m: str) -> None:
        add = session.add_real if role == "real" else session.add_virtual
        targets[name] = add(name, direction_deg=float(direction_deg), distance_m=float(distance_m))

    def slide(**a: str) -> hrt.Command:
        reach, frames = kept["reach"], int(a["frames"])
        places = np.linspace(numbers(a.get("from", "0,0,0.05")), numbers(a["to"]), frames)
        for i in range(frames):
            if "real" in a:
                reach.retarget(targets[a["real"]], targets[a["virtual"]])
            time_ns = int(a.get("begin_ns", 0)) + i * int(a.get("every_ns", 11_111_111))
            command = reach.update(time_ns, position_m=places[i - i % int(a.get("copies", 1))])
        return command

    def set_up(what: str, frames: str) -> hrt.SetupResult:
        plate_deg = 0.0
        with session.set_up(hrt.SetupFlag(int(what))) as setup, hrt.Person(seed=1) as person:
            person.begin(session)
            for frame in range(int(frames)):
                if not setup.over:
                    plate_deg = setup.update(person.move(frame * 11_111_111, plate_deg)).plate_orientation_deg
            return setup.result

    return {
        "target": target, "slide": slide, "set_up": set_up,
        "configure": lambda tactile_weight: session.configure(tactile_weight=float(tactile_weight)),
        "remove": lambda name: targets[name].remove(),
        "gap": lambda real, virtual: session.gap(targets[real], targets[virtual]),
        "begin": lambda real, virtual: kept.update(reach=session.reach(targets[real], targets[virtual])),
        "retarget": lambda real, virtual: kept["reach"].retarget(targets[real], targets[virtual]),
        "touched": lambda at, sd_m: kept["reach"].touched(numbers(at), float(sd_m)),
        "update": lambda time_ns, at: kept["reach"].update(int(time_ns), position_m=numbers(at)),
        "lost": lambda time_ns: kept["reach"].update(int(time_ns)),
        "cancel": lambda: kept["reach"].cancel(),
        "end": lambda: kept["reach"].end(),
        "save_profile": lambda: kept.update(profile=session.profile),
        "load_profile": lambda text=None: session.load_profile(kept["profile"] if text is None else text),
    }


def numbers(text: str) -> list[float]:
    return [float(part) for part in text.split(",")]


def words(text: str) -> dict[str, str]:
    return dict(word.split("=", 1) for word in text.split())


def lines() -> list[str]:
    return [line for line in SCENARIO.read_text(encoding="utf-8").splitlines() if line and not line.startswith("#")]


def test_scenario_of_all_hosts() -> None:
    calls = calls_of(hrt.Session())
    for line in lines():
        call, _, refused = line.partition(" ! ")
        call, _, gives = call.partition(" -> ")
        name, _, arguments = call.partition(" ")
        if refused:
            code, text = refused.split(" ", 1)
            with pytest.raises(hrt.Error, match=_abi.NAMES.get(text, text)) as caught:
                calls[name](**words(arguments))
            assert caught.value.code.name == code, line
            continue
        answer = calls[name](**words(arguments))
        for field, wanted in words(gives).items():
            value = answer[field] if isinstance(answer, dict) else getattr(answer, field)
            assert value & int(wanted) if field == "flags" else value == pytest.approx(float(wanted), abs=1e-4), line
    assert len(lines()) > 30
