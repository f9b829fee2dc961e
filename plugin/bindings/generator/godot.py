"""Generates tables.cpp for Godot: properties, Dictionary keys, constants, methods, their names in error texts, and the
class reference."""

from __future__ import annotations

import re
from decimal import Decimal
from pathlib import Path
from xml.sax.saxutils import escape

import settings
from abi import Abi, Enumeration, Value, pascal

# Structs that scripts receive as a Dictionary, in addition to hrt_plate_report of libhrt_plate.
_RECORDS = ("hrt_command", "hrt_reach_summary", "hrt_gap", "hrt_setup_step", "hrt_setup_result", "hrt_conditions",
            "hrt_recording_status")
# Fields that are neither Dictionary keys nor properties. Set-ups of a node use the default marks.
_NO_KEYS = ("struct_size", "reserved", "mark_count", "marks_m")
# Enumerations without constants: methods return Godot's own errors, and messages go to Godot's log.
_NO_CONSTANTS = ("HRT_ERROR", "HRT_LOG")
_ACRONYMS = {"MPC"}
# Error texts name methods instead of C functions: "end" for hrt_reach_end, "begin_setup" for hrt_setup_begin. These
# functions have methods with other names.
_CALLS = {
    "session_create": "HapticRetargeting", "session_set": "HapticRetargeting", "session_get": "HapticRetargeting",
    "profile_reset": "new_person", "target_add": "add_real_target", "target_set": "move_target_to", "target_get": "find_target",
    "target_list": "find_target", "gap_assign": "assign_targets", "gap_query": "get_gap", "scene_register": "load_scene",
    "scene_load": "load_scene", "setup_update": "update", "setup_finish": "update", "profile_set_conditions": "set_conditions",
    "profile_get_conditions": "get_conditions", "recording_get_status": "get_recording_status",
    "person_create": "begin_simulated_finger", "person_begin": "begin_simulated_finger", "person_move": "update_simulated_finger",
    "plate_open": "open_device", "plate_set": "turn_device", "plate_stop": "stop_device", "plate_get": "get_device_report",
    "plate_close": "close_device",
}
_SETUP = "hrt_setup_config"
_UNITS = {"deg": "°", "deg/s": "°/s", "deg/s^2": "°/s²", "deg^2": "°²", "1/s": "/s", "1": ""}
_GODOT = Path(__file__).parent.parent / "godot"
_PARTS = {"": "value", "_lower": "lower", "_upper": "upper", "_known": "known"}  # fields of an interval, by the end of their key


def render_tables(abi: Abi, plate: Abi, notice: str) -> str:
    setup = [f for f in abi.struct(_SETUP).fields if f.name not in _NO_KEYS]
    properties = [_property(abi, "session", f, "", group) for group, fields in settings.by_section(abi).items() for f in fields]
    properties += [_property(abi, "setup", f, "setup_", "Setup") for f in setup]
    constants = [f'{{"{_enum(e)}", "{m.name.removeprefix("HRT_")}", {m.value}, {str(e.flags).lower()}}}'
                 for e in _shown(abi) + _shown(plate) for m in e.members]
    return (f"// {notice}\n// clang-format off\n#include \"plate_node.h\"\n\nnamespace hrt_godot {{\n\n"
            + "".join(_record(abi, struct) for struct in _RECORDS) + _record(plate, "hrt_plate_report")
            + _table("Property", "properties", properties) + _table("Constant", "constants", constants)
            + _table("Method", "methods", _methods()) + _table("ScriptName", "script_names_of_calls", _script_names(abi, plate))
            + f'constinit const char* const class_reference = R"xml({_reference(abi, plate, setup)})xml";\n\n'
            + "}  // namespace hrt_godot\n")


def _table(type_: str, name: str, rows: list[str]) -> str:
    own = f"k{pascal(name)}"
    return (f"static const {type_} {own}[] = {{\n" + "".join(f"    {row},\n" for row in rows) + "};\n"
            f"constinit const std::span<const {type_}> {name} = {own};\n\n")


def _record(abi: Abi, struct: str) -> str:
    text = f"Record to_record(const {struct}& of) {{\n  if (of.struct_size == 0) return {{}};\n  return {{\n"
    for field in (f for f in abi.struct(struct).fields if f.name not in _NO_KEYS):
        for end, part in _PARTS.items() if field.type.name == "hrt_interval" else [("", "")]:
            text += f'    {{"{field.name}{end}", to_value(of.{field.member}{part and "." + part})}},\n'
    return text + "  };\n}\n\n"


def _methods() -> list[str]:
    header = (_GODOT / "plate_node.h").read_text(encoding="utf-8")
    shown = header.split("// Methods for scripts")[1].split(" private:")[0]
    methods = [(name, re.sub(r"[\w:]+ (\w+)", r'"\1"', arguments))
               for name, arguments in re.findall(r"^  [\w:]+ (\w+)\(([^)]*)\)", shown, re.M)]
    return [f'bind<&PlateNode::{name}>("{name}", {{{names}}}, &PlateNode::{name})' for name, names in methods]


def _script_names(abi: Abi, plate: Abi) -> list[str]:
    rows = []
    for function in (f.name.removeprefix("hrt_") for f in abi.functions + plate.functions):
        noun, _, verb = function.partition("_")
        method = _CALLS.get(function) or (verb if noun == "reach" else f"{verb}_{noun}")
        rows.append(f'{{"hrt_{function}", "{method}"}}')
    return rows


def _property(abi: Abi, of: str, field: Value, prefix: str, group: str) -> str:
    hint, text = "kNone", ""
    if field.values:
        enumeration = abi.enumeration(field.values)
        hint, text = ("kFlags" if enumeration.flags else "kEnum"), _choices(enumeration)
    elif field.bounded and not field.count:
        unit = _UNITS.get(field.unit, field.unit)
        hint, text = "kRange", ",".join(f"{n.normalize():f}" for n in (field.lowest, field.max, _step(field)))
        text += f",suffix:{unit}" if unit else ""
    place = f"[](Properties& of) -> Place {{ return &of.{of}.{field.member}; }}"
    return f'{{"{prefix}{field.name}", {place}, Hint::{hint}, "{text}", "{group}"}}'


def _step(field: Value) -> Decimal:
    """Returns the step to which the inspector rounds."""
    lowest, upper = field.lowest, field.max
    if field.type.name != "double":
        return Decimal(1)
    return min(abs(lowest) or 1, Decimal("0.001"), Decimal(10) ** ((upper - lowest).adjusted() - 6))


def _reference(abi: Abi, plate: Abi, setup: list[Value]) -> str:
    """Renders the editor's class reference: properties and constants from the headers, the rest from the README."""
    def doc(comment: str) -> str:
        comment = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", comment)  # drops the addresses of links
        return escape(re.sub(r"\bHRT_([A-Z])", r"\1", re.sub(r"`([^`]*)`", r"[code]\1[/code]", comment)))

    members = [(f.name, f) for f in settings.shown(abi)] + [(f"setup_{f.name}", f) for f in setup]
    readme = (_GODOT / "README.md").read_text(encoding="utf-8")
    first = next(part.replace("\n", " ") for part in readme.split("\n\n") if "A node of this" in part)
    intro = first[first.index("A node of this class is"):]
    text = ('<class name="HapticRetargeting" inherits="Node3D">\n<brief_description>A ridged plate and the user whose hand it '
            f"guides.</brief_description>\n<description>{doc(intro)}</description>\n")
    for kind in ("method", "signal"):
        text += f"<{kind}s>\n"
        for calls, cell in re.findall(r"^\| (`.*?) \| (.*) \|$", readme.split(f"\n| {kind} | ")[1].split("\n\n")[0], re.M):
            for name in re.findall(r"`(\w+)\(", calls):
                text += f'<{kind} name="{name}"><description>{doc(cell)}</description></{kind}>\n'
        text += f"</{kind}s>\n"
    text += "<members>\n"
    for name, f in members:
        type_ = "Vector3" if f.count else "float" if f.type.name == "double" else "int"
        text += f'<member name="{name}" type="{type_}" setter="set_{name}" getter="get_{name}">{doc(f.doc)}</member>\n'
    text += "</members>\n<constants>\n"
    for e in _shown(abi) + _shown(plate):
        for m in e.members:
            text += f'<constant name="{m.name.removeprefix("HRT_")}" value="{m.value}" enum="{_enum(e)}">{doc(m.text)}</constant>\n'
    return text + "</constants>\n</class>\n"


def _enum(enumeration: Enumeration) -> str:
    return pascal(enumeration.name.removeprefix("HRT_"))


def _shown(abi: Abi) -> list[Enumeration]:
    return [e for e in abi.enumerations if e.name not in _NO_CONSTANTS and e.members]


def _choices(enumeration: Enumeration) -> str:
    """Returns the inspector's choices: "MPC,Fixed Plate". Flags, and constants that differ from their index, have a
    number: "Real:1"."""
    texts = []
    for i, member in enumerate(enumeration.members):
        short = enumeration.short(member)
        text = " ".join(word if word in _ACRONYMS else pascal(word) for word in short.split("_"))
        texts.append(text if member.value == i and not enumeration.flags else f"{text}:{member.value}")
    return ",".join(texts)
