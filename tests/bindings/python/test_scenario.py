"""The scenario of all hosts (../scenario.txt), through Session and the functions beside it."""

import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import haptic_retargeting as hrt

SCENARIO = Path(os.environ["HRT_SCENARIO"])


class Player:
    def __init__(self) -> None:
        self.session = hrt.Session()
        self.targets: dict[str, hrt.Target] = {}
        self.reach: Any = None

    def configure(self, tactile_weight: str) -> None:
        self.session.configure(tactile_weight=float(tactile_weight))

    def target(self, role: str, name: str, direction_deg: str, distance_m: str) -> None:
        add = self.session.add_real if role == "real" else self.session.add_virtual
        self.targets[name] = add(name, direction_deg=float(direction_deg), distance_m=float(distance_m))

    def remove(self, name: str) -> None:
        self.targets[name].remove()

    def gap(self, real: str, virtual: str) -> hrt.Gap:
        return self.session.gap(self.targets[real], self.targets[virtual])

    def begin(self, real: str, virtual: str) -> None:
        self.reach = self.session.reach(self.targets[real], self.targets[virtual])
        self.reach.__enter__()

    def retarget(self, real: str, virtual: str) -> None:
        self.reach.retarget(self.targets[real], self.targets[virtual])

    def touched(self, at: str, sd_m: str) -> None:
        self.reach.touched(numbers(at), float(sd_m))

    def update(self, time_ns: str, at: str) -> hrt.Command:
        return self.reach.update(int(time_ns), position_m=numbers(at))

    def lost(self, time_ns: str) -> hrt.Command:
        return self.reach.update(int(time_ns))

    def slide(self, to: str, frames: str) -> None:
        places = np.linspace([0, 0, 0.05], numbers(to), int(frames))
        self.reach.run(hrt.samples(np.arange(int(frames)) * 11_111_111, position_m=places))

    def cancel(self) -> None:
        self.reach.cancel()

    def end(self) -> hrt.ReachSummary:
        return self.reach.end()

    def save_profile(self) -> None:
        self.saved = self.session.profile

    def load_profile(self, text: str | None = None) -> None:
        self.session.load_profile(self.saved if text is None else text)


def numbers(text: str) -> list[float]:
    return [float(part) for part in text.split(",")]


def words(text: str) -> dict[str, str]:
    return dict(word.split("=", 1) for word in text.split())


def lines() -> list[str]:
    return [line for line in SCENARIO.read_text(encoding="utf-8").splitlines() if line and not line.startswith("#")]


def test_scenario_of_all_hosts() -> None:
    player = Player()
    for line in lines():
        call, _, refused = line.partition(" ! ")
        call, _, gives = call.partition(" -> ")
        name, _, arguments = call.partition(" ")
        if refused:
            code, text = refused.split(" ", 1)
            with pytest.raises(hrt.Error, match=text) as caught:
                getattr(player, name)(**words(arguments))
            assert caught.value.code.name == code, line
            continue
        answer = getattr(player, name)(**words(arguments))
        for field, wanted in words(gives).items():
            value = answer[field] if isinstance(answer, dict) else getattr(answer, field)
            assert value & int(wanted) if field == "flags" else value == pytest.approx(float(wanted), abs=1e-4), line
    assert len(lines()) > 30
