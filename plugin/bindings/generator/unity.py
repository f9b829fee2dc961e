"""Generates Unity's inspector settings: a part of the class HapticRetargeting, with tooltips, ranges and defaults."""

from __future__ import annotations

import re
import textwrap
from decimal import Decimal

import settings
from abi import Abi, HostError, Value
from csharp import Renderer, camel

_WIDTH = 87
_WIDEST_SLIDER = 360  # a slider over a larger range is too coarse
_FROM_SCENE = "start_position_m"  # given by a Transform, as is the plate's pose
_TYPES = {"int32_t": "int", "uint32_t": "int", "int64_t": "long", "uint64_t": "ulong", "double": "double"}


def render(abi: Abi, notice: str) -> str:
    names, text, taken, changed = Renderer(abi), "", "", ""
    for section, fields in settings.by_section(abi).items():
        for i, field in enumerate(f for f in fields if f.name != _FROM_SCENE):
            type_, default = _type(names, field)
            name = re.sub("Ns$", "Ms", camel(field.name))
            text += f'[Header("{section}")]\n' * (i == 0) + _tooltip(names, field) + _range(field)
            text += f"public {type_} {name}{default and ' = ' + default};\n\n"
            value = f"(long)Math.Round({name} * 1e6)" if field.unit == "ns" else f"(uint){name}" if type_ == "int" else name
            member = camel(field.name)
            taken += f"    config.{member} = {value};\n"
            changed += f"    if (!now.{member}.Equals(before.{member})) config.{member} = now.{member};\n"
    text += f"SessionConfig Configuration()\n{{\n    SessionConfig config = SessionConfig.Default;\n{taken}    return config;\n}}\n\n"
    text += ("// Returns `config` with the values of `now` for the settings that differ between `before` and `now`.\n"
             f"static SessionConfig Changed(SessionConfig config, SessionConfig before, SessionConfig now)\n{{\n{changed}    return config;\n}}\n")
    return (f"// {notice}\nusing System;\nusing UnityEngine;\n\nnamespace Hrt\n{{\n"
            "    // The fields of SessionConfig that the inspector shows. Transforms give the plate's pose and the start.\n"
            "    public sealed partial class HapticRetargeting\n    {\n"
            + textwrap.indent(text, " " * 8, lambda line: line.strip() != "") + "    }\n}\n")


def _type(names: Renderer, field: Value) -> tuple[str, str]:
    """Returns the C# type of a field and its default, which is "" for 0."""
    if field.values:
        return names.enumerations[field.values], names.constants.get(str(field.default), "")
    kind = "double" if field.unit == "ns" else "Double3" if field.count else _TYPES.get(field.type.name)
    if kind is None or field.type.pointer:
        raise HostError(f"hrt_session_config::{field.name} is of a type that generator/unity.py does not support")
    default = ", ".join(_shown(field, n) for n in field.defaults)
    return kind, f"new Double3({default})" if field.count and default else default


def _range(field: Value) -> str:
    if not field.bounded or field.values or field.count:
        return ""
    lower, upper = _shown(field, field.lowest), _shown(field, field.max)
    return f"[Range({lower}f, {upper}f)]\n" if Decimal(upper) - Decimal(lower) <= _WIDEST_SLIDER else f"[Min({lower}f)]\n"


def _shown(field: Value, number: Decimal) -> str:
    return f"{(number / 1_000_000 if field.unit == 'ns' else number).normalize():f}"


def _tooltip(names: Renderer, field: Value) -> str:
    text = names.renamed(field.doc).replace("\\", "\\\\").replace('"', '\\"').replace("`", "") + " Shown in milliseconds." * (field.unit == "ns")
    if field.values:
        members = names.abi.enumeration(field.values).members
        text = " ".join([text, *(f"{names.constants[m.name].partition('.')[2]}: {names.renamed(m.text)}" for m in members)])
    lines = textwrap.wrap(text, _WIDTH, drop_whitespace=False, break_on_hyphens=False)
    return '[Tooltip("' + '" +\n         "'.join(lines) + '")]\n'
