"""What each host's own code uses of the C interface: functions, fields of the structs that it fills with the constants
that these take, and in Godot the errors. A name that a host neither uses nor leaves out, with a reason, is reported; so
are a reason that no longer holds, and a name that the headers have no more."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from abi import Abi

_SOURCES = {
    "godot": ("godot/*.cpp", "godot/*.h"),
    "python": ("python/haptic_retargeting/*.py",),
    "unity": ("unity/com.haptic-retargeting/Runtime/*.cs",),
    "unreal": ("unreal/HapticRetargeting/Source/HapticRetargeting/Private/*.cpp",),
    "web": ("web/*.mjs",),
}
# Structs that a host's own code fills, field by field; the others are generated there.
_FILLED = {
    "godot": ("hrt_target_config", "hrt_reach_config", "hrt_sample"),
    "unreal": ("hrt_target_config", "hrt_reach_config", "hrt_sample"),
    "python": ("hrt_reach_config", "hrt_sample"),
}
# In C++ a field's constants have the headers' names.
_CPP = ("godot", "unreal")
# What is generated and uses the interface.
_USES = ("Calls.cs",)
# Names of this project that the headers do not have, or have inline.
_OWN = {"hrt_result", "hrt_godot", "hrt_web_open", "hrt_session_config_from_plate", "HRT_LIBRARY", "HRT_PLATE_LIBRARY", "HRT_ERROR_"}
_COMMENTS = re.compile(r'//[^\n]*|/\*.*?\*/|"""(?:[^"]|"(?!""))*"""|(?m:^\s*#[^\n]*)', re.S)

_ALL = "godot python unity unreal web"
# Hosts, names, and why those hosts do without.
_LEFT_OUT = (
    ("godot", "hrt_person_get_state", "update_simulated_finger() has the place"),
    (_ALL, "hrt_result_string", "an error has the text of hrt_last_error()"),
    ("godot python unreal web", "hrt_set_host", "what a recording has lost is reported when it stops"),
    ("godot", "hrt_scene_get_info hrt_scene_get_target", "find_target() has the ids, the node itself moves to the plate"),
    ("unity", "hrt_scene_get_target", "a registered target is read from the session"),
    ("godot unreal", "hrt_replay", "recordings are replayed in Python"),
    ("unreal", "hrt_target_list", "a Blueprint has the ids"),
    ("unreal", "hrt_target_assign hrt_profile_get_conditions hrt_profile_set_conditions hrt_person_get_state",
     "C++ calls the C interface with GetSession()"),
    ("godot unreal web", "hrt_setup_get_residual", "a plot of slides is made in Python, C# and C"),
    ("python", "hrt_sample::joint_rotation", "a set-up's fingertip is found in engines and C"),
    ("unreal", "hrt_get_version", "the library is part of the plugin"),
    ("web", "hrt_plate_open hrt_plate_set hrt_plate_stop hrt_plate_get hrt_plate_close hrt_plate_last_error",
     "a web page has no serial lines of the system's: samples/web drives a plate by Web Serial"),
    ("unreal", "hrt_plate_stop", "a plate that gets no command holds"),
    ("unreal", "hrt_sample::finger_direction_deg", "C++ has UpdateSample()"),
    ("godot unreal", "HRT_PLACE_DIRECTION", "the default"),
    ("godot unreal", "hrt_target_config::radius_m", "a contact is given with its place and deviation"),
    ("unreal", "hrt_target_config::served_by", "C++ reads it with GetSession()"),
    ("godot unreal", "HRT_PLACE_PLATE_POSITION", "places are given in the world"),
    ("godot unreal", "HRT_REACH_START_AT_FINGER", "a reach starts at the start of the settings"),
    ("unreal", "HRT_TARGET_REAL HRT_TARGET_VIRTUAL", "EHapticTargetRole has their numbers"),
    ("unreal", "HRT_SAMPLE_DIRECTION HRT_SAMPLE_PLATE_POSITION HRT_SAMPLE_LIFTED", "C++ has UpdateSample()"),
    ("godot", "HRT_ERROR_STRUCT_SIZE HRT_ERROR_BUFFER_TOO_SMALL HRT_ERROR_INTERNAL", "a defect of the node: ERR_BUG"),
)


def missing(abi: Abi, plate: Abi, bindings: Path, notice: str) -> Iterator[str]:
    """A line for each name and host."""
    functions = {f.name for f in abi.functions + plate.functions}
    known = _OWN | {x.name for model in (abi, plate) for x in (*model.functions, *model.constants, *model.structs)}
    known |= {f"{struct.name}_init" for struct in abi.structs}
    for host, patterns in _SOURCES.items():
        paths = [path for pattern in patterns for path in bindings.glob(pattern)]
        texts = [path.read_text(encoding="utf-8") for path in paths if path.name not in _USES]
        text = "\n".join(t for t in texts if notice not in t.partition("\n")[0])  # what is generated uses nothing
        text += "".join(path.read_text(encoding="utf-8") for path in paths if path.name in _USES)
        wanted = functions | {c.name for c in abi.constants if host == "godot" and c.name.startswith("HRT_ERROR_")}
        words = set(re.findall(r"\b\w+", _COMMENTS.sub(" ", text)))
        fields = {f"{struct}::{f.name}": f.name for struct in _FILLED.get(host, ()) for f in abi.struct(struct).fields
                  if f.name not in ("struct_size", "reserved")}
        wanted |= set(fields)
        taken = {f.enumeration for struct in _FILLED.get(host, ()) for f in abi.struct(struct).fields} - {""}
        if host in _CPP:
            wanted |= {c.name for e in abi.enumerations if e.prefix in taken for c in e.members}
        used = words & wanted | {name for name, field in fields.items() if field in words}
        left_out = {name for hosts, names, _ in _LEFT_OUT if host in hosts.split() for name in names.split()}
        for name in sorted(wanted - used - left_out):
            yield f"{host} does not use {name}: use it, or say in generator/wrappers.py why it is left out"
        for name in sorted(left_out & used | left_out - wanted):
            yield f"{host} uses {name}, or there is no such name: generator/wrappers.py lists it as left out"
        for name in sorted(word for word in words - known if re.match(r"hrt_|HRT_", word)):
            yield f"{host} uses {name}, which the headers do not have"
