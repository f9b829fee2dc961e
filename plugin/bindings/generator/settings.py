"""The settings that an engine's inspector shows: the fields of hrt_session_config that are a number or a choice. Left
out are the plate's pose, which is that of the object in the scene, and fixed arrays, which profiles and registrations
hold."""

from __future__ import annotations

from abi import Abi, Field

STRUCT = "hrt_session_config"
POSE = ("plate_position_m", "plate_rotation")
FOUND = ("fingertip_offset_m",)  # by a set-up


def shown(abi: Abi) -> list[Field]:
    return [f for f in abi.struct(STRUCT).fields if f.length in (0, 3) and f.name not in ("struct_size", "reserved", *POSE, *FOUND)]


def hidden(abi: Abi) -> list[Field]:
    """What is to be kept when a configuration is made from the settings."""
    return [f for f in abi.struct(STRUCT).fields if (f.length not in (0, 3) or f.name in FOUND) and f.name not in POSE]


def section(field: Field) -> str:
    """Where an inspector shows it."""
    words = field.name.split("_")
    if {"plate", "start", "lift"} & set(words[:2]):
        return "Plate"
    if words[0] == "tracker" or words[0] == "registration":
        return "Tracker"
    if words[0] in ("tactile", "bias", "motor", "sensory", "initial"):
        return "User"
    return "Controller"


def by_section(abi: Abi) -> dict[str, list[Field]]:
    sections: dict[str, list[Field]] = {"Controller": [], "Plate": [], "User": [], "Tracker": []}
    for field in shown(abi):
        sections[section(field)].append(field)
    return sections
