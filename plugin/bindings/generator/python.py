"""Generates ctypes declarations for Python: hrt_session_config becomes SessionConfig, the handle hrt_session becomes
SessionHandle, and a group of constants becomes an enumeration."""

from __future__ import annotations

import textwrap

import fields
from abi import Abi, Enumeration, Names, Struct, Type, Value, pascal

_CTYPES = {"char": "c_char", "int32_t": "c_int32", "hrt_result": "c_int32", "uint32_t": "c_uint32", "int64_t": "c_int64",
           "uint64_t": "c_uint64", "double": "c_double", "size_t": "c_size_t"}
# Annotated number types, which _struct.py defines.
_ANNOTATED = {"int32_t": "Int32", "uint32_t": "UInt32", "int64_t": "Int64", "uint64_t": "UInt64", "double": "Double"}
# Enumerations whose names do not follow from the C names.
_ENUMERATIONS = {"HRT_ERROR": "ErrorCode", "HRT_LOG": "LogLevel", "HRT_TARGET": "Role"}
# Error texts name methods instead of C functions: Reach.end for hrt_reach_end. The methods of these functions have
# other names.
_FUNCTIONS = {
    "session_create": "Session", "session_get": "Session.config", "session_set": "Session.configure", "session_destroy": "Session.close",
    "target_add": "Session.add_real", "target_set": "Target.configure", "target_get": "Target.config", "target_list": "Session.targets",
    "gap_assign": "Session.assign", "gap_query": "Session.gap", "reach_begin": "Session.reach", "setup_begin": "Session.set_up",
    "setup_finish": "SetUp.update", "setup_get_residual": "SetUp.residual", "profile_save": "Session.profile",
    "profile_load": "Session.load_profile", "profile_set_conditions": "Session.set_conditions",
    "profile_get_conditions": "Session.conditions", "profile_reset": "Session.new_person",
    "recording_start": "Session.recording", "recording_stop": "Session.recording",
    "recording_get_status": "Session.recording", "recording_flush": "Session.recording", "person_create": "Person",
    "person_destroy": "Person.close", "person_get_state": "Person.state", "scene_load": "Scene", "scene_destroy": "Scene.close",
    "scene_get_info": "Scene.info", "scene_get_target": "Scene.targets", "recording_replay": "replay",
    "plate_open": "Plate",
}
# Classes whose methods take the fields of a struct as keywords: the struct and, for each method, its name, its
# parameters before the keywords, and the method that receives the given fields.
_KEYWORDS = {
    "SessionKeywords": ("hrt_session_config", (("__init__", "", "_create"), ("configure", "", "_configure"))),
    "TargetKeywords": ("hrt_target_config", (("configure", "", "_configure"),)),
    "PersonKeywords": ("hrt_person_config", (("__init__", "seed: int = 0, ", "_create"),)),
}


_HEAD = '''"""The C interface as declarations for ctypes. Meanings, units and ranges are those of the C headers."""

from __future__ import annotations

from ctypes import CFUNCTYPE, POINTER, Array, c_char, c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint32, c_uint64, c_void_p
from typing import TYPE_CHECKING, Annotated, Any

from ._struct import Choice, Double, Flags, FunctionPointer, Int32, Int64, Pointer, Struct, UInt32, UInt64, laid_out

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .session import Target
else:
    Target = object

'''
_KEYWORDS_HEAD = '''"""Methods whose keywords are fields of a struct, declared for type checkers and editors. None means that a field is not given."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._struct import Numbers

if TYPE_CHECKING:
    from .session import Target


def _given(arguments: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in arguments.items() if value is not None and name not in ("self", "seed")}
'''


def render(abi: Abi, notice: str) -> str:
    names = _Host(abi)
    public = sorted([*names.enumerations.values(), *(names.types[s.name] for s in abi.structs if not s.is_handle)])
    text = f"# {notice}\n{_HEAD}__all__ = {public}\n\n"
    for c in (c for c in abi.constants if not c.enumeration):
        if c.name == "HRT_VERSION":
            text += f'VERSION = ({abi.version.replace(".", ", ")})\n"""Version of the C headers."""\nVERSION_NUMBER = {c.value}\n'
        elif not c.name.startswith("HRT_VERSION"):
            text += f"{c.name.removeprefix('HRT_')} = {c.value}\n" + _doc(c.text, [], names, "")
    text += "".join(_enumeration(e, names) for e in abi.enumerations)
    for f in abi.callbacks:
        text += (f"\n{names.types[f.name]} = CFUNCTYPE({', '.join(_type(t, names) for t in (f.result, *(p.type for p in f.params)))})\n"
                 + _doc(f.text, [], names, ""))
    text += "".join(_struct(s, names) for s in abi.structs) + "\n\nFUNCTIONS: dict[str, tuple[Any, ...]] = {\n"
    for f in abi.functions:
        text += f'    "{f.name}": ({"".join(_type(t, names) + ", " for t in (f.result, *(p.type for p in f.params)))}),\n'
    text += '}\n"""Types of each function\'s result and parameters."""\n\nNAMES = {\n'
    c_names = names.constants | {f"{e.name}_": f"{names.enumerations[e.name]}." for e in abi.enumerations}
    for function in (f.name.removeprefix("hrt_") for f in abi.functions if f.returns_result and f.name not in ("hrt_host_set", "hrt_host_set_log", "hrt_flags_text")):
        noun, _, verb = function.partition("_")
        method = f"{'SetUp' if noun == 'setup' else noun.capitalize()}.{verb}"
        c_names[f"hrt_{function}"] = _FUNCTIONS.get(function, method)
    text += "".join(f'    "{name}": "{shown}",\n' for name, shown in c_names.items() if name != shown)
    text += '}\n"""Names of this package for the C names in error texts."""\n'
    if any(s.name == "hrt_command" for s in abi.structs):
        text += "\nCOLUMNS: dict[str, dict[str, list[str]]] = {\n"
        for struct, columns in fields.recorded(abi):
            text += f'    "{names.types[struct.name]}": {columns},\n'
        text += '}\n"""Columns of each field in a recording."""\n'
    return text


def render_keywords(abi: Abi, notice: str) -> str:
    names = _Host(abi)
    hints = {_given_hint(f, names) for struct, _ in _KEYWORDS.values() for f in abi.struct(struct).shown}
    used = sorted(hints & {*names.enumerations.values(), *names.types.values()})
    text = f"# {notice}\n" + _KEYWORDS_HEAD.replace("from ._struct", f"from ._abi import {', '.join(used)}\nfrom ._struct")
    for name, (struct, methods) in _KEYWORDS.items():
        text += f'\n\nclass {name}:\n    """Keywords for the fields of {names.types[struct]}."""\n'
        keywords = ", ".join(f"{f.name}: {_given_hint(f, names)} | None = None" for f in abi.struct(struct).shown)
        for method, before, to in methods:
            passed = before.partition(":")[0] + ", " if before else ""
            text += (f"\n    def {method}(self, {before}*, {keywords}) -> None:\n        self.{to}({passed}_given(locals()))\n"
                     f"\n    def {to}(self, {before.replace(' = 0', '')}fields: dict[str, Any]) -> None:\n"
                     "        raise NotImplementedError\n")
    return text


class _Host(Names):
    def __init__(self, abi: Abi) -> None:
        self.callbacks = {f.name: pascal(f.name.removeprefix("hrt_")) for f in abi.callbacks}
        structs = {s.name: pascal(s.name.removeprefix("hrt_")) + "Handle" * s.is_handle for s in abi.structs}
        enumerations = abi.enumeration_names(_ENUMERATIONS, "Flag")
        self.members = {m.name: f"{enumerations[e.name]}.{e.short(m)}" for e in abi.enumerations for m in e.members}
        super().__init__(structs | self.callbacks, enumerations, {c.name: c.name.removeprefix("HRT_") for c in abi.constants} | self.members, {})


def _doc(text: str, items: list[tuple[str, str]], names: _Host, indent: str = "    ") -> str:
    """Renders a docstring that has, after the text, each item on a new line."""
    lines = textwrap.wrap(names.renamed(text), 104) + [""] * bool(items)
    for name, item in items:
        lines += textwrap.wrap(f"{name}: {names.renamed(item)}" if item else name, 104, subsequent_indent="    ")
    doc = f"\n{indent}".join(lines).replace(f"\n{indent}\n", "\n\n").replace("\\", "\\\\")
    return f'{indent}"""{doc}"""\n' if doc else ""


def _enumeration(enumeration: Enumeration, names: _Host) -> str:
    members = [(enumeration.short(m), m) for m in enumeration.members]
    return (f"\n\nclass {names.enumerations[enumeration.name]}({'Flags' if enumeration.flags else 'Choice'}):\n"
            + _doc(enumeration.text, [(short, m.text) for short, m in members], names)
            + "\n" + "".join(f"    {short} = {m.value}\n" for short, m in members))


def _struct(struct: Struct, names: _Host) -> str:
    text = (f"\n\n@laid_out\nclass {names.types[struct.name]}(Struct):\n"
            + _doc(struct.text, [(f.name, f.doc) for f in struct.shown], names) + "\n"
            + "".join(f"    {f.name}: {_stored(f, names)}\n" for f in struct.fields))
    if struct.has_default:
        values = {f.name: [names.members.get(n, n) for n in f.literals] for f in struct.fields if f.literals}
        text += "    _defaults_ = {" + ", ".join(f'"{f}": ' + (v[0] if len(v) == 1 else f"({', '.join(v)})")
                                                 for f, v in values.items()) + "}\n"
    keywords = ", ".join(f"{f.name}: {_given_hint(f, names, 'ArrayLike')} = ..." for f in struct.shown)
    return text + f"\n    if TYPE_CHECKING:\n        def __init__(self, *, {keywords}) -> None: ...\n"


def _type(type_: Type, names: _Host) -> str:
    name = _CTYPES.get(type_.name) or names.types.get(type_.name)
    if not type_.pointer:
        return name or "None"
    if type_.name == "void":
        return "c_void_p"
    if type_.name == "char":
        return "c_char_p" if type_.const else "POINTER(c_char)"
    return f"POINTER({name})"


def _stored(field: Value, names: _Host) -> str:
    """Returns the type that scripts read; if it is no enumeration and differs, with the ctypes type as annotation."""
    if field.values:
        return names.enumerations[field.values]
    stored = _type(field.type, names)
    if field.count:
        return f"Annotated[{'str' if field.type.name == 'char' else f'Array[{stored}]'}, {stored} * {field.count}]"
    if field.type.name == "hrt_target":
        return f"Annotated[Target | None, {stored}]"
    if field.type.name in names.callbacks:
        return f"Annotated[FunctionPointer, {stored}]"
    return "Pointer" if field.type.pointer else _ANNOTATED.get(field.type.name, stored)


def _given_hint(field: Value, names: _Host, numbers: str = "Numbers") -> str:
    if field.count:
        return "str | bytes" if field.type.name == "char" else numbers
    if field.boolean:
        return "bool | int"
    if field.values:
        return names.enumerations[field.values]
    if field.type.name in names.callbacks:
        return "FunctionPointer"
    if field.type.pointer:
        return "int | None"
    if field.type.name == "hrt_target":
        return "Target"
    return "float" if field.type.name == "double" else names.types.get(field.type.name, "int")
