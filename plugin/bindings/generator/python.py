"""ctypes declarations for Python: hrt_session_config becomes SessionConfig, the handle hrt_session SessionHandle,
and constants that belong together an enumeration."""

from __future__ import annotations

import re
import textwrap

from abi import Abi, Constant, Field, Function, Struct, Type

_CTYPES = {"char": "c_char", "int32_t": "c_int32", "uint32_t": "c_uint32", "int64_t": "c_int64",
           "uint64_t": "c_uint64", "double": "c_double", "size_t": "c_size_t"}
_ENUMERATIONS = {"ERROR": "ErrorCode", "CONTROL": "Control", "GUIDANCE": "Guidance", "ADAPTATION": "Adaptation",
                 "TARGET": "Role", "PLACE": "Place", "LOG": "LogLevel", "REACH": "ReachFlag", "SAMPLE": "SampleFlag",
                 "COMMAND": "CommandFlag", "SESSION": "SessionFlag", "ENDING": "Ending",
                 "STATE": "StateFlag"}


def render(abi: Abi, notice: str) -> str:
    names = _class_names(abi)
    enumerations, constants = _sorted_constants(abi)
    version = ", ".join(str(c.value) for c in constants if c.name.startswith("HRT_VERSION_"))
    parts = [
        f"# {notice}\n"
        '"""The C interface as ctypes sees it. Meanings, units and ranges are those of the C headers."""\n\n'
        "from __future__ import annotations\n\n"
        "import ctypes\n"
        "from ctypes import (\n"
        "    CDLL, CFUNCTYPE, POINTER, c_char, c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint32, c_uint64, c_void_p,\n"
        ")\n"
        "from enum import IntEnum, IntFlag\n"
        "from typing import TYPE_CHECKING\n\n"
        "from ._struct import Struct\n",
        f'VERSION = ({version})\n"""Of the headers that this was written from."""\n'
        + "".join(f"{c.name.removeprefix('HRT_')} = {c.value}\n" + _docstring(c.doc, "", names)
                  for c in constants if not c.name.startswith("HRT_VERSION_")),
    ]
    parts.extend(_enumeration(name, prefix, members, names) for prefix, (name, members) in enumerations.items())
    parts.append("".join(_callback(f, names) for f in abi.callbacks))
    parts.extend(_struct(s, names) for s in abi.structs)
    parts.append(
        "def declare(library: CDLL) -> None:\n"
        '    """Declares the types of every function to ctypes; AttributeError names one that the library lacks."""\n'
        + "".join(f"    library.{f.name}.argtypes = ({_list([_type(p.type, names) for p in f.parameters])})\n"
                  f"    library.{f.name}.restype = {_type(f.result, names)}\n" for f in abi.functions))
    return "\n\n".join(part.rstrip("\n") + "\n" for part in parts)


def _class_names(abi: Abi) -> dict[str, str]:
    def name(c_name: str) -> str:
        return "".join(part.capitalize() for part in c_name.removeprefix("hrt_").split("_"))
    return ({s.name: name(s.name) + ("Handle" if s.is_handle else "") for s in abi.structs}
            | {f.name: name(f.name) for f in abi.callbacks})


def _sorted_constants(abi: Abi) -> tuple[dict[str, tuple[str, list[Constant]]], list[Constant]]:
    enumerations: dict[str, tuple[str, list[Constant]]] = {p: (name, []) for p, name in _ENUMERATIONS.items()}
    others = []
    for constant in abi.constants:
        prefix = constant.name.split("_")[1]
        if prefix in enumerations:
            enumerations[prefix][1].append(constant)
        else:
            others.append(constant)
    return enumerations, others


def _enumeration(name: str, prefix: str, members: list[Constant], names: dict[str, str]) -> str:
    kind = "IntFlag" if members[0].unsigned else "IntEnum"
    lines = textwrap.wrap(_renamed(members[0].group, names) or f"The C headers' HRT_{prefix}_*.", 104) + [""]
    values = ""
    for member in members:
        short = member.name.removeprefix(f"HRT_{prefix}_")
        values += f"    {short} = {member.value}\n"
        lines += textwrap.wrap(f"{short}: {_renamed(member.doc, names)}" if member.doc else short, 104,
                               subsequent_indent="    ")
    doc = "\n    ".join(lines).replace("\n    \n", "\n\n")
    return f'class {name}({kind}):\n    """{doc}\n    """\n\n{values}'


def _docstring(text: str, indent: str, names: dict[str, str]) -> str:
    if not text:
        return ""
    lines = textwrap.wrap(_renamed(text, names).replace("\\", "\\\\"), 110 - len(indent) - 6)
    return indent + '"""' + f"\n{indent}".join(lines) + '"""\n'


def _callback(function: Function, names: dict[str, str]) -> str:
    types = [_type(function.result, names)] + [_type(p.type, names) for p in function.parameters]
    return f"{names[function.name]} = CFUNCTYPE({', '.join(types)})\n" + _docstring(function.doc, "", names)


def _struct(struct: Struct, names: dict[str, str]) -> str:
    # What help() shows has the fields too; they stand where a type checker sees them.
    lines = textwrap.wrap(_renamed(struct.doc, names), 104) + [""]
    hints, fields = "", ""
    for f in struct.fields:
        hints += f"        {f.name}: {_hint(f, names)}\n"
        fields += f'        ("{f.name}", {_type(f.type, names)}{f" * {f.length}" if f.length else ""}),\n'
        if f.doc:
            lines += textwrap.wrap(f"{f.name}: {_renamed(f.doc, names)}", 104, subsequent_indent="    ")
        elif f.name not in ("struct_size", "reserved"):
            lines.append(f.name)
    doc = "\n    ".join(lines).rstrip().replace("\n    \n", "\n\n")
    doc = f'    """{doc}\n    """\n' if "\n" in doc else f'    """{doc}"""\n'
    return (f"class {names[struct.name]}(Struct):\n{doc}\n    if TYPE_CHECKING:\n{hints}\n"
            f"    _fields_ = (\n{fields}    )\n")


def _renamed(doc: str, names: dict[str, str]) -> str:
    """The headers' text with the names of this module."""
    for prefix, name in _ENUMERATIONS.items():
        doc = doc.replace(f"HRT_{prefix}_*", name).replace(f"HRT_{prefix}_", f"{name}.")
    doc = re.sub(r"\b(hrt_\w+)::", lambda found: names.get(found[1], found[1]) + ".", doc)
    doc = re.sub(r"\bhrt_\w+\b(?!\()", lambda found: names.get(found[0], found[0]), doc)
    doc = doc.replace("HRT_PERSON_", "PERSON_")
    return re.sub(r" ?(Set `struct_size` before the call|hrt_\w+_default\(\) fills every field)\.", "", doc)


def _type(type_: Type, names: dict[str, str]) -> str:
    name = _CTYPES.get(type_.name) or names.get(type_.name)
    if not type_.pointer:
        return name or "None"
    if type_.name == "void":
        return "c_void_p"
    if type_.name == "char":
        return "c_char_p" if type_.const else "POINTER(c_char)"
    return f"POINTER({name})"


def _hint(field: Field, names: dict[str, str]) -> str:
    if field.length:
        return "bytes" if field.type.name == "char" else f"ctypes.Array[{_CTYPES[field.type.name]}]"
    if field.type.callback:
        return "ctypes._FuncPointer"
    if field.type.pointer:
        return "int | None"
    if field.type.name == "double":
        return "float"
    return names.get(field.type.name, "int")


def _list(items: list[str]) -> str:
    return ", ".join(items) + ("," if len(items) == 1 else "")
