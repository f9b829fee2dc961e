"""Generates tables for the C++ of the libraries: fields of structs (plugin/src/abi/field.h), with assertions about
their layout; columns of recordings; names of calls, flags and results."""

from __future__ import annotations

from collections.abc import Iterator

import c
from abi import Abi, Struct, Value

_CPP = {"char": "char", "int32_t": "std::int32_t", "uint32_t": "std::uint32_t", "int64_t": "std::int64_t",
        "uint64_t": "std::uint64_t", "double": "double"}


# Columns of a recording after "call" and "result", in their order. The columns of a struct have the names of its
# fields, except those given here.
_RECORDED = (
    ("", ("time_ns",)),
    ("hrt_sample", {"flags": "sample_flags", "finger_direction_deg": "sample_direction_deg", "finger_position_m": "sample_{}_m",
                    "plate_orientation_deg": "measured_plate_deg", "plate_position_m": "plate_{}_m", "plate_rotation": "plate_q{}",
                    "joint_rotation": "joint_q{}"}),
    ("", ("reach_flags", "real_target", "virtual_target", "duration_s", "real_direction_deg",
          "virtual_direction_deg", "real_distance_m", "start_right_m", "start_away_m")),
    ("hrt_command", {"flags": "command_flags"}),
    ("hrt_reach_summary", {"flags": "summary_flags", "distance_to_target_m": "distance_to_go_m", "duration_s": "duration_learnt_s",
                           "paper_final_direction_deg": "paper_finger_direction_deg",
                           "paper_perceived_direction_deg": "perceived_direction_deg"}),
    ("", ("setup",)),
    ("hrt_contact", {"flags": "contact_flags", "position_m": "contact_{}_m", "sd_m": "contact_sd_m"}),
)


def render(abi: Abi, notice: str, others: str = '"plugin/src/abi/field.h"') -> str:
    """Renders the tables; `others` is the header to include."""
    structs = [s for s in abi.structs if s.size and not s.is_handle]
    return (f"// {notice}\n// clang-format off\n#pragma once\n\n"
            + "".join(f'#include "haptic_retargeting/{name}"\n' for name in abi.headers)
            + f"#include {others}" + "\n\nnamespace hrt::plugin {\n\n"
            + "\n".join(_fields(abi, s) for s in structs)
            + "".join(_defaults(s) for s in structs if s.has_default)
            + (_columns(abi) + _calls(abi) + _flag_words(abi) + _results(abi) if any(s.name == "hrt_command" for s in structs) else "") + "\n}  // namespace hrt::plugin\n")


def _flag_words(abi: Abi) -> str:
    flags = abi.enumeration("HRT_COMMAND")
    rows = "".join(f'    {{{m.value}u, "{flags.short(m).lower().replace("_", " ")}"}},\n' for m in flags.members)
    return f"\ninline constexpr std::pair<std::uint32_t, std::string_view> command_flag_words[] = {{\n{rows}}};\n"


def _results(abi: Abi) -> str:
    rows = "".join(f'    {{{name}, "{name}"}},\n' for name in ["HRT_OK", *(m.name for m in abi.enumeration("HRT_ERROR").members)])
    return f"\ninline constexpr std::pair<hrt_result, const char*> result_names[] = {{\n{rows}}};\n"


def _calls(abi: Abi) -> str:
    """Renders a table of functions, and of the names of their parameters, which error texts can contain."""
    handles = {s.name for s in abi.structs if s.is_handle}
    rows = "".join(f'    {{"{f.name}", "{" ".join(p.name for p in f.params)}"}},\n' for f in abi.functions if f.returns_result
                   and any(p.type.pointer or p.type.name in handles for p in f.params))
    return f"\ninline constexpr Call calls[] = {{\n{rows}}};\n"


def _fields(abi: Abi, struct: Struct) -> str:
    fields = [f for f in struct.fields if f.name != "struct_size"]
    text = f"template <>\nstruct Fields<{struct.name}> {{\n  using S = {struct.name};\n"
    for f in fields:
        attributes = "".join(f", .{name} = {value}" for name, value in _attributes(abi, struct, f).items())
        text += f'  static constexpr Field<S, {_kind(f)}> {f.name}{{.name = "{f.name}", .offset = offsetof(S, {f.member}){attributes}}};\n'
        # Ranges of elements that have their own constant, such as HRT_PERSON_WEIGHT.
        if elements := [e for e in abi.constants if f.elements and e.name.startswith(f"{f.elements}_") and e.min is not None]:
            rows = "".join(f'      {{"{f.name}[{e.name}]", {f.literal(e.min)}, {f.literal(e.max)}}},\n' for e in elements)
            text += f"  static constexpr Element {f.name}_elements[] = {{\n{rows}  }};\n"
    return (text + f"  static constexpr auto all = std::tuple({', '.join(f.name for f in fields)});\n}};\n"
            + f'static_assert(sizeof({struct.name}) == {struct.size}, "as in api.json");\n'
            + "".join(f"static_assert(offsetof({struct.name}, {f.member}) == {f.offset});\n" for f in struct.fields))


def _kind(f: Value) -> str:
    return _CPP.get(f.type.name, f.type.name) + (f"[{f.count}]" if f.count else "")


def _attributes(abi: Abi, struct: Struct, f: Value) -> dict[str, str]:
    """Returns the initialisers of Field after name and offset."""
    if f.name == "reserved":
        return {"kind": "FieldKind::reserved"}
    attributes = {}
    if f.values:
        enumeration = abi.enumeration(f.values)
        values = [m.value for m in enumeration.members]
        attributes = ({"kind": "FieldKind::flags", "high": f"{sum(values)}u"} if enumeration.flags else
                      {"kind": "FieldKind::number", "low": f"{min(values)}u", "high": f"{max(values)}u"})
    elif f.min is not None:
        upper = f.literal(f.max) if f.max is not None else f"std::numeric_limits<{_CPP[f.type.name]}>::max()"
        attributes = {"kind": "FieldKind::number", "low": f.literal(f.min), "high": upper}
    if f.zero:
        attributes["zero"] = "true"
    if f.profile:
        by = next((g for g in struct.fields if g.name == f.profile), None)
        known = f"&is_set<S, {_kind(by)}, offsetof(S, {by.member})>" if by else "&always<S>"
        attributes |= {"in_profile": known} | ({"optional": "true"} if by else {})
    return attributes


def _defaults(struct: Struct) -> str:
    return (f"\ntemplate <>\ninline constexpr {struct.name} defaults<{struct.name}> = [] {{\n"
            f"  {struct.name} value{{}};\n{c.fill(struct)}  return value;\n}}();\n")


def recorded(abi: Abi) -> Iterator[tuple[Struct, dict[str, list[str]]]]:
    """Yields the structs of a recording, with the columns of each field."""
    for struct, names in _RECORDED:
        if struct:
            yield abi.struct(struct), {f.name: [names.get(f.name, f.name).format(axis) for axis in "xyzw"[:f.count or 1]]
                                       for f in abi.struct(struct).shown}


def _columns(abi: Abi) -> str:
    """Renders the columns of a recording, and the first column of each field."""
    columns = ["call", "result"]
    text = ""
    structs = recorded(abi)
    for struct, names in _RECORDED:
        if struct:
            new = next(structs)[1].values()
            columns += [column for field in new for column in field if column not in columns]
            firsts = ", ".join(str(columns.index(field[0])) for field in new)
            text += f"template <>\ninline constexpr std::size_t columns_of<{struct}>[] = {{{firsts}}};\n"
        else:
            columns += names
    quoted = ", ".join(f'"{column}"' for column in columns)
    return (f"\ninline constexpr std::string_view recording_columns[] = {{{quoted}}};\n\n"
            "/// Index of the first column of each field, in the order of Fields<S>.\ntemplate <class S>\n"
            "inline constexpr std::size_t columns_of[1] = {};\n" + text)
