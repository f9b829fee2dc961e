"""ctypes declarations for Python: hrt_session_config becomes SessionConfig, the handle hrt_session SessionHandle,
and constants that belong together an enumeration."""

from __future__ import annotations

import re
import textwrap

from abi import Abi, Enumeration, Field, Function, Struct, Type, pascal
from fields import default_of

_CTYPES = {"char": "c_char", "int32_t": "c_int32", "uint32_t": "c_uint32", "int64_t": "c_int64",
           "uint64_t": "c_uint64", "double": "c_double", "size_t": "c_size_t"}
# Of _struct.py.
_ANNOTATED = {"int32_t": "Int32", "uint32_t": "UInt32", "int64_t": "Int64", "uint64_t": "UInt64", "double": "Double"}
# Whose names in Python are not those of the headers.
_ENUMERATIONS = {"HRT_ERROR_": "ErrorCode", "HRT_LOG_": "LogLevel", "HRT_TARGET_": "Role"}
# Classes of the package whose methods take fields of a struct by keyword: method, what it takes before them, and what
# it hands them to.
_KEYWORDS = {
    "SessionKeywords": ("hrt_session_config", (("__init__", "", "_create"), ("configure", "", "_configure"))),
    "TargetKeywords": ("hrt_target_config", (("configure", "", "_configure"),)),
    "PersonKeywords": ("hrt_person_config", (("__init__", "seed: int = 0, ", "_create"),)),
}


def render(abi: Abi, notice: str) -> str:
    names = _Names(abi)
    members = {m.name for e in abi.enumerations for m in e.members}
    constants = [c for c in abi.constants if c.name not in members]
    version = ", ".join(str(c.value) for c in constants if c.name.startswith("HRT_VERSION_"))
    number = next((c.value for c in constants if c.name == "HRT_VERSION"), 0)
    parts = [
        f"# {notice}\n"
        '"""The C interface as ctypes sees it. Meanings, units and ranges are those of the C headers."""\n\n'
        "from __future__ import annotations\n\n"
        "from ctypes import (\n"
        "    CFUNCTYPE, POINTER, Array, c_char, c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint32, c_uint64, c_void_p,\n"
        ")\n"
        "from typing import TYPE_CHECKING, Annotated, Any\n\n"
        "from ._struct import (\n"
        "    Choice, Double, Flags, FunctionPointer, Int32, Int64, Pointer, Struct, UInt32, UInt64, laid_out,\n"
        ")\n\n"
        "if TYPE_CHECKING:\n    from numpy.typing import ArrayLike\n",
        (f'VERSION = ({version})\n"""Of the headers that this was written from."""\nVERSION_NUMBER = {number}\n' if version else "")
        + "".join(f"{c.name.removeprefix('HRT_')} = {c.value}\n" + _docstring(c.doc, "", names)
                  for c in constants if not c.name.startswith("HRT_VERSION")),
    ]
    parts.extend(_enumeration(e, names) for e in abi.enumerations)
    parts.append("".join(_callback(f, names) for f in abi.callbacks))
    parts.extend(_struct(s, names) for s in abi.structs)
    public = sorted([*names.enums.values(), *(names.structs[s.name] for s in abi.structs if not s.is_handle)])
    parts.insert(2, "__all__ = [\n" + textwrap.fill(", ".join(f'"{n}"' for n in public), 112, initial_indent="    ",
                                                      subsequent_indent="    ") + ",\n]\n")
    parts.append(
        "FUNCTIONS: dict[str, tuple[Any, ...]] = {\n"
        + "".join(f'    "{f.name}": ({_list([_type(t, names) for t in (f.result, *(p.type for p in f.parameters))])}),\n'
                  for f in abi.functions)
        + '}\n"""The types of each function\'s result and parameters."""\n')
    return "\n\n".join(part.rstrip("\n") + "\n" for part in parts if part)


def render_keywords(abi: Abi, notice: str) -> str:
    names = _Names(abi)
    used = sorted({names.enums[f.enumeration] for struct, _ in _KEYWORDS.values()
                   for f in abi.struct(struct).fields if f.enumeration})
    text = (f"# {notice}\n"
            '"""Methods whose keywords are fields of a struct, so that type checkers and editors know them; None: not given."""\n\n'
            "from __future__ import annotations\n\nfrom typing import Any\n\n"
            f"from ._abi import {', '.join(used)}\nfrom ._struct import Numbers\n\n\n"
            "def _given(arguments: dict[str, Any]) -> dict[str, Any]:\n"
            "    return {name: value for name, value in arguments.items()\n"
            '            if value is not None and name not in ("self", "seed")}\n')
    for name, (struct, methods) in _KEYWORDS.items():
        text += f'\n\nclass {name}:\n    """The fields of {names.structs[struct]}, by keyword."""\n'
        for method, before, to in methods:
            keywords = [f"{f.name}: {_given_hint(f, names)} | None = None"
                        for f in abi.struct(struct).fields if f.name not in ("struct_size", "reserved")]
            text += f"\n    def {method}(\n" + _wrapped([f"self, {before}*", *keywords], 12) + "\n    ) -> None:\n"
            text += f"        self.{to}({before.partition(':')[0] + ', ' if before else ''}_given(locals()))\n"
            taken = before.replace(" = 0", "")
            text += (f"\n    def {to}(self, {taken}fields: dict[str, Any]) -> None:\n"
                     "        raise NotImplementedError\n")
    return text


class _Names:
    """What structs, callbacks and enumerations are called here."""

    def __init__(self, abi: Abi) -> None:
        self.structs = {s.name: pascal(s.name.removeprefix("hrt_")) + "Handle" * s.is_handle for s in abi.structs}
        self.structs |= {f.name: pascal(f.name.removeprefix("hrt_")) for f in abi.callbacks}
        self.enums = abi.enumeration_names(_ENUMERATIONS, "Flag")
        self.members = {m.name: f"{self.enums[e.prefix]}.{e.short(m)}" for e in abi.enumerations for m in e.members}


def _enumeration(enumeration: Enumeration, names: _Names) -> str:
    lines = textwrap.wrap(_renamed(enumeration.doc, names), 104) + [""]
    values = ""
    for member in enumeration.members:
        short = enumeration.short(member)
        values += f"    {short} = {member.value}\n"
        lines += textwrap.wrap(f"{short}: {_renamed(member.doc, names)}" if member.doc else short, 104,
                               subsequent_indent="    ")
    doc = "\n    ".join(lines).replace("\n    \n", "\n\n")
    kind = "Flags" if enumeration.flags else "Choice"
    return f'class {names.enums[enumeration.prefix]}({kind}):\n    """{doc}\n    """\n\n{values}'


def _docstring(text: str, indent: str, names: _Names) -> str:
    if not text:
        return ""
    lines = textwrap.wrap(_renamed(text, names).replace("\\", "\\\\"), 110 - len(indent) - 6)
    return indent + '"""' + f"\n{indent}".join(lines) + '"""\n'


def _callback(function: Function, names: _Names) -> str:
    types = [_type(function.result, names)] + [_type(p.type, names) for p in function.parameters]
    return f"{names.structs[function.name]} = CFUNCTYPE({', '.join(types)})\n" + _docstring(function.doc, "", names)


def _struct(struct: Struct, names: _Names) -> str:
    # What help() shows has the fields too.
    lines = textwrap.wrap(_renamed(struct.doc, names), 104) + [""]
    for f in struct.fields:
        if f.doc:
            lines += textwrap.wrap(f"{f.name}: {_renamed(f.doc, names)}", 104, subsequent_indent="    ")
        elif f.name not in ("struct_size", "reserved"):
            lines.append(f.name)
    fields = "".join(f"    {f.name}: {_stored(f, names)}\n" for f in struct.fields)
    keywords = [f"{f.name}: {_given_hint(f, names, 'ArrayLike')} = ..." for f in struct.fields
                if f.name not in ("struct_size", "reserved")]
    doc = "\n    ".join(lines).rstrip().replace("\n    \n", "\n\n")
    doc = f'    """{doc}\n    """\n' if "\n" in doc else f'    """{doc}"""\n'
    if struct.has_default:
        fields += f"    _defaults_ = {{{_defaults(struct, names)}}}\n"
    return (f"@laid_out\nclass {names.structs[struct.name]}(Struct):\n{doc}\n{fields}\n"
            f"    if TYPE_CHECKING:\n        def __init__(\n{_wrapped(['self, *', *keywords], 12)}\n"
            "        ) -> None: ...\n")


def _defaults(struct: Struct, names: _Names) -> str:
    """What is not 0."""
    given = {f.name: default_of(f) for f in struct.fields}
    return ", ".join(f'"{f.name}": ' + (f"({_list(given[f.name])})" if f.length else names.members.get(given[f.name][0], given[f.name][0]))
                     for f in struct.fields if any(n.strip("0.") for n in given[f.name]))


def _renamed(doc: str, names: _Names) -> str:
    """The headers' text with the names of this module."""
    for prefix, name in names.enums.items():
        doc = doc.replace(f"{prefix}*", name).replace(prefix, f"{name}.")
    doc = re.sub(r"\b(hrt_\w+)::", lambda found: names.structs.get(found[1], found[1]) + ".", doc)
    doc = re.sub(r"\bhrt_\w+\b(?!\()", lambda found: names.structs.get(found[0], found[0]), doc)
    doc = re.sub(r"\bHRT_(?=[A-Z])", "", doc)
    return re.sub(r" ?(Set `struct_size` before the call|hrt_\w+_init\(\) fills every field)\.", "", doc)


def _type(type_: Type, names: _Names) -> str:
    name = _CTYPES.get(type_.name) or names.structs.get(type_.name)
    if not type_.pointer:
        return name or "None"
    if type_.name == "void":
        return "c_void_p"
    if type_.name == "char":
        return "c_char_p" if type_.const else "POINTER(c_char)"
    return f"POINTER({name})"


def _stored(field: Field, names: _Names) -> str:
    """The type that a script reads, annotated with the one of ctypes where that is another."""
    if field.enumeration:
        return names.enums[field.enumeration]
    stored = _type(field.type, names)
    if field.length:
        return f"Annotated[{'bytes' if field.type.name == 'char' else f'Array[{stored}]'}, {stored} * {field.length}]"
    if field.type.callback:
        return f"Annotated[FunctionPointer, {stored}]"
    return "Pointer" if field.type.pointer else _ANNOTATED.get(field.type.name, stored)


def _given_hint(field: Field, names: _Names, numbers: str = "Numbers") -> str:
    """The type of what may be given."""
    if field.length:
        return "str | bytes" if field.type.name == "char" else numbers
    if field.boolean:
        return "bool | int"
    if field.enumeration:
        return names.enums[field.enumeration]
    if field.type.callback:
        return "FunctionPointer"
    if field.type.pointer:
        return "int | None"
    return "float" if field.type.name == "double" else names.structs.get(field.type.name, "int")


def _wrapped(parameters: list[str], indent: int) -> str:
    """Lines that break between parameters only."""
    text = ", ".join(parameter.replace(" ", "\N{NO-BREAK SPACE}") for parameter in parameters) + ","
    lines = textwrap.wrap(text, 118 - indent, break_long_words=False, break_on_hyphens=False)
    return textwrap.indent("\n".join(lines), " " * indent).replace("\N{NO-BREAK SPACE}", " ")


def _list(items: list[str]) -> str:
    return ", ".join(items) + ("," if len(items) == 1 else "")
