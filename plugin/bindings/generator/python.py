"""ctypes declarations for Python."""

from __future__ import annotations

import textwrap

from abi import Abi, Field, Function, Struct, Type

_CTYPES = {"char": "c_char", "int32_t": "c_int32", "uint32_t": "c_uint32", "int64_t": "c_int64",
           "uint64_t": "c_uint64", "double": "c_double", "size_t": "c_size_t"}


def render(abi: Abi, notice: str) -> str:
    parts = [
        f"# {notice}\n"
        '"""The C interface as ctypes sees it. Names and meanings are those of the C headers."""\n\n'
        "from __future__ import annotations\n\n"
        "import ctypes\n"
        "from ctypes import (\n"
        "    CDLL, CFUNCTYPE, POINTER, Structure, c_char, c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint32,\n"
        "    c_uint64, c_void_p,\n"
        ")\n"
        "from typing import TYPE_CHECKING\n"
    ]
    parts.append("".join(_constant(c.name, c.value, c.doc, c.group) for c in abi.constants))
    parts.append("".join(_callback(f) for f in abi.callbacks))
    parts.extend(_struct(s) for s in abi.structs)
    parts.append(
        "def declare(library: CDLL) -> None:\n"
        '    """Tells ctypes the type of every function; AttributeError names one that the library lacks."""\n'
        + "".join(f"    library.{f.name}.argtypes = ({_list([_type(p.type) for p in f.parameters])})\n"
                  f"    library.{f.name}.restype = {_type(f.result)}\n" for f in abi.functions))
    return "\n\n".join(part.rstrip("\n") + "\n" for part in parts)


def _constant(name: str, value: int, doc: str, group: str) -> str:
    return _comment(group, before="\n") + f"{name} = {value}\n" + (_docstring(doc, "") if doc else "")


def _comment(text: str, before: str) -> str:
    return before + "".join(f"# {line}\n" for line in textwrap.wrap(text, 108)) if text else ""


def _docstring(text: str, indent: str) -> str:
    lines = textwrap.wrap(text.replace("\\", "\\\\"), 110 - len(indent) - 6)
    return indent + '"""' + f"\n{indent}".join(lines) + '"""\n'


def _callback(function: Function) -> str:
    types = [_type(function.result)] + [_type(p.type) for p in function.parameters]
    return f"{function.name} = CFUNCTYPE({', '.join(types)})\n" + _docstring(function.doc, "")


def _struct(struct: Struct) -> str:
    text = f"class {struct.name}(Structure):\n" + _docstring(struct.doc, "    ")
    text += "\n    if TYPE_CHECKING:\n"
    for f in struct.fields:
        text += f"        {f.name}: {_hint(f)}\n" + (_docstring(f.doc, "        ") if f.doc else "")
    fields = [f'("{f.name}", {_type(f.type)}{f" * {f.length}" if f.length else ""})' for f in struct.fields]
    return text + "\n    _fields_ = (\n" + "".join(f"        {f},\n" for f in fields) + "    )\n"


def _type(type_: Type) -> str:
    if not type_.pointer:
        return "None" if type_.name == "void" else _CTYPES.get(type_.name, type_.name)
    if type_.name == "void":
        return "c_void_p"
    if type_.name == "char":
        return "c_char_p" if type_.const else "POINTER(c_char)"
    return f"POINTER({_CTYPES.get(type_.name, type_.name)})"


def _hint(field: Field) -> str:
    if field.length:
        return "bytes" if field.type.name == "char" else f"ctypes.Array[{_CTYPES[field.type.name]}]"
    if field.type.pointer:
        return "int | None"
    if field.type.name == "double":
        return "float"
    return "int" if field.type.name in _CTYPES else ("object" if field.type.callback else field.type.name)


def _list(items: list[str]) -> str:
    return ", ".join(items) + ("," if len(items) == 1 else "")
