"""The settings in Unity's inspector, with tooltips, ranges and defaults: a part of the component HapticRetargeting."""

from __future__ import annotations

import re
import textwrap
from decimal import Decimal

import settings
from abi import Abi, Field, HeaderError
from csharp import Renderer, camel

_WIDTH = 110
_WIDEST_SLIDER = 360  # beyond, a slider is too coarse
_FROM_SCENE = "start_position_m"  # a Transform, as the plate's pose
_TYPES = {"int32_t": "int", "uint32_t": "int", "int64_t": "long", "uint64_t": "ulong", "double": "double"}


def render(abi: Abi, notice: str) -> str:
    names = Renderer(abi)
    text, shown = "", []
    for section, fields in settings.by_section(abi).items():
        for i, field in enumerate(f for f in fields if f.name != _FROM_SCENE):
            text += ("\n" if text else "") + (f'[Header("{section}")]\n' if i == 0 else "") + _setting(names, field)
            shown.append(field)
    text += ("\nSessionConfig Configuration()\n{\n    SessionConfig config = SessionConfig.Default;\n"
             + "".join(f"    config.{camel(f.name)} = {_value(f)};\n" for f in shown)
             + "    return config;\n}\n")
    body = textwrap.indent(text, " " * 8, lambda line: line.strip() != "")
    return (f"// {notice}\nusing System;\nusing UnityEngine;\n\nnamespace Hrt\n{{\n"
            "    // The fields of SessionConfig; a Transform of the scene gives its plate's pose and its start.\n"
            "    public sealed partial class HapticRetargeting\n    {\n" + body + "    }\n}\n")


def _name(field: Field) -> str:
    return re.sub("Ns$", "Ms", camel(field.name))


def _type(names: Renderer, field: Field) -> str:
    if field.enumeration:
        return names.enums[field.enumeration]
    if field.unit == "ns":
        return "double"
    kind = "Double3" if field.length else _TYPES.get(field.type.name)
    if kind is None or field.type.pointer:
        raise HeaderError(f"hrt_session_config::{field.name} is of a type that generator/unity.py does not show")
    return kind


def _value(field: Field) -> str:
    if field.unit == "ns":
        return f"(long)Math.Round({_name(field)} * 1e6)"
    return f"(uint){_name(field)}" if field.type.name == "uint32_t" and not field.enumeration else _name(field)


def _setting(names: Renderer, field: Field) -> str:
    numbers = field.numbers
    attributes = _tooltip(names, field)
    if numbers.lowest is not None and numbers.upper is not None and not field.enumeration and not field.length:
        lower, upper = _shown(field, numbers.lowest), _shown(field, numbers.upper)
        attributes += (f"[Range({lower}f, {upper}f)]\n" if Decimal(upper) - Decimal(lower) <= _WIDEST_SLIDER
                       else f"[Min({lower}f)]\n")
    default = ""
    if field.length:
        given = ", ".join(_shown(field, n) for n in numbers.default or ())
        default = f" = new Double3({given})" if given.strip("0, ") else ""
    elif isinstance(numbers.default, str):
        default = " = " + ".".join(names.members[numbers.default])
    elif numbers.default and numbers.default[0] != 0:
        default = f" = {_shown(field, numbers.default[0])}"
    return attributes + f"public {_type(names, field)} {_name(field)}{default};\n"


def _shown(field: Field, number: Decimal) -> str:
    return f"{(number / 1_000_000 if field.unit == 'ns' else number).normalize():f}"


def _tooltip(names: Renderer, field: Field) -> str:
    text = names.renamed(field.shared_doc).replace(" (base.h)", "").replace("\\", "\\\\").replace('"', '\\"')
    text = re.sub(r" (Named `reserved` before|Since) version [\d.]+\.", "", text).replace("`", "")
    if field.unit == "ns":
        text += " Shown in milliseconds."
    if field.enumeration:
        members = next(e.distinct for e in names.abi.enumerations if e.prefix == field.enumeration)
        text = re.sub(r"^\w+\. ", "", text)
        text = " ".join(f"{names.members[m.name][1]}: {names.renamed(m.doc).rstrip('.')}." for m in members) + " " + text
    lines = textwrap.wrap(text, _WIDTH - 8 - 15, drop_whitespace=False, break_on_hyphens=False)
    return '[Tooltip("' + '" +\n         "'.join(lines) + '")]\n'
