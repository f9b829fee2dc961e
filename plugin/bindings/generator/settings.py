"""The settings that an engine's inspector shows: numbers, choices and vectors of hrt_session_config, without the
plate's pose, which an object of the scene gives, and without the arrays that set-ups, reaches and profiles write."""

from __future__ import annotations

from abi import HIDDEN, Abi, Value

STRUCT = "hrt_session_config"
POSE = ("plate_position_m", "plate_rotation")
FOUND = ("fingertip_offset_m",)  # measured by a set-up


def shown(abi: Abi) -> list[Value]:
    return [f for f in abi.struct(STRUCT).fields if f.count in (0, 3) and f.name not in (*HIDDEN, *POSE, *FOUND)]


def hidden(abi: Abi) -> list[Value]:
    """Returns the fields that the settings lack, and that components keep when the settings change."""
    return [f for f in abi.struct(STRUCT).fields if (f.count not in (0, 3) or f.name in FOUND) and f.name not in POSE]


_SECTIONS = {"Plate": ("plate", "start", "lift"), "User": ("tactile", "bias", "motor", "sensory", "initial"),
             "Tracker": ("tracker", "registration")}


def section(field: Value) -> str:
    """Returns the group in which an inspector shows a field, by the first word of its name."""
    first = field.name.removeprefix("fixed_").partition("_")[0]
    return next((name for name, words in _SECTIONS.items() if first in words), "Controller")


def by_section(abi: Abi) -> dict[str, list[Value]]:
    return {name: [f for f in shown(abi) if section(f) == name] for name in ("Controller", *_SECTIONS)}
