"""Godot's tables: fields as properties and Dictionary keys, and the constants of scripts."""

from __future__ import annotations

import settings
from abi import Abi, Enumeration, Field, pascal

# What a script gets as a Dictionary, by its table in fields.h.
_RECORDS = {"command": "hrt_command", "summary": "hrt_reach_summary", "gap": "hrt_gap",
            "step": "hrt_setup_step", "result": "hrt_setup_result", "conditions": "hrt_conditions",
            "recording": "hrt_recording_status"}
# Of no Dictionary and no property: the marks of a set-up are the start and five places on the rim.
_NO_KEYS = ("struct_size", "reserved", "mark_count", "marks_m")
# Of no property or Dictionary: methods return Godot's own errors.
_NO_CONSTANTS = ("HRT_ERROR_", "HRT_LOG_")
_ACRONYMS = {"MPC"}
_PARTS = {"": "value", "_lower": "lower", "_upper": "upper", "_known": "known"}  # of an interval


def render_tables(abi: Abi, plate: Abi, notice: str) -> str:
    tables = {"config": _table(abi, settings.STRUCT, settings.shown(abi))}
    for name, struct in _RECORDS.items():
        tables[name] = _table(abi, struct, [f for f in abi.struct(struct).fields
                                            if f.name not in _NO_KEYS])
    tables["device"] = _table(plate, "hrt_plate_report", [f for f in plate.struct("hrt_plate_report").fields
                                                          if f.name not in _NO_KEYS])
    tables["setup"] = _table(abi, "hrt_setup_config", [f for f in abi.struct("hrt_setup_config").fields
                                                       if f.name not in _NO_KEYS], "setup_")
    return (f"// {notice}\n// clang-format off\n#include \"fields.h\"\n\n#include <haptic_retargeting/plate.h>\n\n"
            "#include <cstring>\n\nnamespace hrt_godot {\nnamespace {\n\n"
            + "".join(f"constexpr Field k{name.capitalize()}[] = {{\n{rows}}};\n\n" for name, rows in tables.items())
            + "constexpr Constant kConstants[] = {\n"
            + "".join(f'    {{"{pascal(e.prefix.removeprefix("HRT_").strip("_"))}", "{m.name.removeprefix("HRT_")}", {m.value}, '
                      f'{"true" if e.flags else "false"}}},\n' for e in _shown(abi) + _shown(plate) for m in e.members)
            + "};\n\n}  // namespace\n\n"
            + "".join(f"constinit const std::span<const Field> {name}_fields = k{name.capitalize()};\n" for name in tables)
            + "constinit const std::span<const Constant> constants = kConstants;\n\n"
            + f"void copy_hidden(const {settings.STRUCT}& from, {settings.STRUCT}& to) {{\n"
            + "".join(f"  std::memcpy(to.{f.name}, from.{f.name}, sizeof to.{f.name});\n" for f in settings.hidden(abi))
            + "}\n\n}  // namespace hrt_godot\n")


def _table(abi: Abi, struct: str, fields: list[Field], prefix: str = "") -> str:
    return "".join(_row(abi, struct, field, prefix) for field in fields)


def _row(abi: Abi, struct: str, field: Field, prefix: str) -> str:
    if field.type.name == "hrt_interval":
        return "".join(f'    make_field<&{struct}::{field.name}, &hrt_interval::{part}>("{field.name}{end}"),\n'
                       for end, part in _PARTS.items())
    choices = ""
    if field.enumeration:
        enumeration = next(e for e in abi.enumerations if e.prefix == field.enumeration)
        if not enumeration.flags:
            choices = f', "{_choices(enumeration)}"'
    return f'    make_field<&{struct}::{field.name}>("{prefix}{field.name}"{choices}),\n'


def _shown(abi: Abi) -> list[Enumeration]:
    return [e for e in abi.enumerations if e.prefix not in _NO_CONSTANTS and e.members]


def _choices(enumeration: Enumeration) -> str:
    """As the inspector offers them: "MPC,Fixed Plate"; with its number where that is not the place: "Real:1"."""
    texts = []
    for i, member in enumerate(enumeration.distinct):
        short = enumeration.short(member)
        text = " ".join(word if word in _ACRONYMS else pascal(word) for word in short.split("_"))
        texts.append(text if member.value == i else f"{text}:{member.value}")
    return ",".join(texts)


def render_constants(abi: Abi, plate: Abi, notice: str) -> str:
    text = (f"# {notice}\n# The numbers of properties and flags; session.h, reach.h and plate.h say what they mean.\n"
            "#\n#   const HRT = preload(\"res://addons/haptic_retargeting/constants.gd\")\n"
            "#   if flags & HRT.COMMAND_SATURATED: ...\n")
    for enumeration in _shown(abi) + _shown(plate):
        text += "\n" + "".join(f"const {m.name.removeprefix('HRT_')} = {m.value}\n" for m in enumeration.members)
    return text
