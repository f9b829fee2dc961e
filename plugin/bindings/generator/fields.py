"""The fields of the structs for the library's own C++ (plugin/src/abi/field.h): names, ranges, defaults, what profiles have; and
what a compiler must see of their layout."""

from __future__ import annotations

from decimal import Decimal

import comments
from abi import Abi, Constant, Field, Struct

_CPP = {"char": "char", "int32_t": "std::int32_t", "uint32_t": "std::uint32_t", "int64_t": "std::int64_t",
        "uint64_t": "std::uint64_t", "double": "double"}


# What is recorded of a reach, in the order of a recording's columns, with the names of those that are not called as their field.
_RECORDED = (
    ("", ("time_ns",)),
    ("hrt_sample", {"flags": "sample_flags", "finger_direction_deg": "sample_direction_deg", "finger_position_m": "sample_{}_m",
                    "plate_orientation_deg": "measured_plate_deg", "plate_position_m": "plate_{}_m", "plate_rotation": "plate_q{}",
                    "joint_rotation": "joint_q{}"}),
    ("", ("reach_flags", "real_target", "virtual_target", "duration_s", "refused_argument", "struct_size", "real_direction_deg",
          "virtual_direction_deg", "real_distance_m", "start_right_m", "start_away_m")),
    ("hrt_command", {"flags": "command_flags"}),
    ("hrt_reach_summary", {"flags": "summary_flags", "final_direction_deg": "finger_direction_deg",
                           "distance_to_target_m": "distance_to_go_m", "duration_s": "duration_learnt_s"}),
    ("", ("setup",)),
    ("hrt_contact", {"flags": "contact_flags", "position_m": "contact_{}_m", "sd_m": "contact_sd_m"}),
)


def render(abi: Abi, notice: str, others: str = '"plugin/src/abi/field.h"') -> str:
    """`others` is the header to include."""
    structs = [s for s in abi.structs if not s.is_handle and not any(f.type.pointer or f.type.callback for f in s.fields)]
    return (f"// {notice}\n// clang-format off\n#pragma once\n\n"
            + "".join(f'#include "haptic_retargeting/{name}"\n' for name in abi.headers)
            + f"#include {others}" + "\n\nnamespace hrt::plugin {\n\n"
            + "\n".join(_fields(abi, s) for s in structs)
            + "".join(_defaults(s) for s in structs if s.has_default)
            + (_columns(abi) + _calls(abi) if any(s.name == "hrt_command" for s in structs) else "") + "\n}  // namespace hrt::plugin\n")


def _calls(abi: Abi) -> str:
    """What can be refused for an argument."""
    handles = {s.name for s in abi.structs if s.is_handle}
    rows = "".join(f'    {{"{f.name}", "{" ".join(p.name for p in f.parameters)}"}},\n' for f in abi.functions if f.returns_result
                   and any(p.type.pointer or p.type.callback or p.type.name in handles for p in f.parameters))
    return f"\ninline constexpr Call calls[] = {{\n{rows}}};\n"


def _fields(abi: Abi, struct: Struct) -> str:
    fields = [f for f in struct.fields if f.name != "struct_size"]
    text = f"template <>\nstruct Fields<{struct.name}> {{\n  using S = {struct.name};\n"
    for f in fields:
        kind = _kind(f)
        attributes = "".join(f", .{name} = {value}" for name, value in _attributes(abi, struct, f).items())
        text += (f'  static constexpr Field<S, {kind}> {f.name}{{.name = "{f.name}", '
                 f'.offset = offsetof(S, {f.member}){attributes}}};\n')
        elements = _elements(abi, f)
        if elements:
            rows = "".join(f'      {{"{f.name}[{c.name}]", {_literal(f, n.lower)}, {_literal(f, n.upper)}}},\n' for c, n in elements)
            text += f"  static constexpr Element {f.name}_elements[] = {{\n{rows}  }};\n"
    places, size = abi.layout(struct, 8)
    return (text + f"  static constexpr auto all = std::tuple({', '.join(f.name for f in fields)});\n}};\n"
            + f'static_assert(sizeof({struct.name}) == {size}, "of the model of the headers");\n'
            + "".join(f"static_assert(offsetof({struct.name}, {f.member}) == {place.offset});\n"
                      for f, place in zip(struct.fields, places)))


def _kind(f: Field) -> str:
    return _CPP.get(f.type.name, f.type.name) + (f"[{f.length}]" if f.length else "")


def _attributes(abi: Abi, struct: Struct, f: Field) -> dict[str, str]:
    """What Field has besides the name and the place."""
    numbers = f.numbers
    if f.name == "reserved":
        return {"kind": "FieldKind::reserved"}
    attributes = {}
    if f.enumeration and numbers.has_range:
        members = next(e for e in abi.enumerations if e.prefix == f.enumeration)
        values = [m.value for m in members.members]
        attributes = ({"kind": "FieldKind::flags", "high": f"{sum(values)}u"} if members.flags else
                      {"kind": "FieldKind::number", "low": f"{min(values)}u", "high": f"{max(values)}u"})
    elif numbers.lower is not None:
        upper = _literal(f, numbers.upper) if numbers.upper is not None else f"std::numeric_limits<{_CPP[f.type.name]}>::max()"
        attributes = {"kind": "FieldKind::number", "low": _literal(f, numbers.lower), "high": upper}
    if numbers.zero:
        attributes["zero"] = "true"
    if numbers.in_profiles:
        by = next((g for g in struct.fields if g.name == numbers.known_by), None)
        known = f"&is_set<S, {_kind(by)}, offsetof(S, {by.member})>" if by else "&always<S>"
        attributes |= {"in_profile": known} | ({"optional": "true"} if numbers.known_by else {})
    return attributes


def _elements(abi: Abi, f: Field) -> list[tuple[Constant, comments.Numbers]]:
    """Of an array whose elements constants name, with ranges of their own."""
    prefix = f.named_prefix if f.length and f.type.name == "double" else ""
    read = [(c, comments.numbers(c.doc, "", 0)) for c in abi.constants if prefix and c.name.startswith(prefix)]
    return [(c, n) for c, n in read if n.lower is not None]


def _defaults(struct: Struct) -> str:
    text, open_part = "", ""
    for f in struct.fields:
        part, name = f.member.split(".") if f.path else ("", f.name)
        if part != open_part:
            text += ("},\n" if open_part else "") + (f"    .{part} = {{" if part else "")
            open_part = part
        value = f"sizeof({struct.name})" if name == "struct_size" else _default(f)
        text += f".{name} = {value}, " if part else f"    .{name} = {value},\n"
    return (f"\ntemplate <>\ninline constexpr {struct.name} defaults<{struct.name}>{{\n"
            + text + ("},\n" if open_part else "") + "};\n")


def default_of(f: Field) -> list[str]:
    """Each number of its default, or a constant's name; empty: zero."""
    given = f.numbers.default
    return [given] if isinstance(given, str) else [_literal(f, number) for number in given or ()]


def _default(f: Field) -> str:
    given = default_of(f)
    if not any(number.strip("0.") for number in given):
        return "{}"
    return "{" + ", ".join(given) + "}" if f.length else given[0]


def _literal(f: Field, number: Decimal | None) -> str:
    assert number is not None
    if f.type.name != "double":
        return f"{int(number)}"
    text = f"{number:f}" if abs(number.adjusted()) < 7 else f"{number:e}"
    return text if "." in text or "e" in text else text + ".0"


def _columns(abi: Abi) -> str:
    """The columns of a recording, and the first one of each field."""
    columns = ["call", "result"]
    text = ""
    for struct, names in _RECORDED:
        firsts = []
        for f in (f for f in abi.struct(struct).fields if f.name not in ("struct_size", "reserved")) if struct else ():
            name = names.get(f.name, f.name)
            new = [name.format(axis) for axis in "xyzw"[:f.length]] if f.length else [name]
            columns += [c for c in new if c not in columns]
            firsts.append(str(columns.index(new[0])))
        if struct:
            text += f"template <>\ninline constexpr std::size_t columns_of<{struct}>[] = {{{', '.join(firsts)}}};\n"
        else:
            columns += names
    quoted = ", ".join(f'"{c}"' for c in columns)
    return (f"\ninline constexpr std::string_view recording_columns[] = {{{quoted}}};\n\n"
            "/// The first column of each field, in the order of Fields.\ntemplate <class S>\n"
            "inline constexpr std::size_t columns_of[1] = {};\n" + text)
