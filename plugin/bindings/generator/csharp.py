"""The C interface for C#, in Unity's manner: enums, blittable structs with plain fields, P/Invoke declarations.

Types and members are in C#'s case and without hrt_; functions keep their names. Constants that belong together become
an enum; a field is of that enum if its comment in the headers says so ("HRT_CONTROL_*").
"""

from __future__ import annotations

import re
import textwrap

from abi import Abi, Constant, Field, Function, Parameter, Struct, Type

_ENUMS = {
    "HRT_ERROR_": "Result",
    "HRT_LOG_": "LogLevel",
    "HRT_CONTROL_": "Control",
    "HRT_GUIDANCE_": "Guidance",
    "HRT_ADAPTATION_": "Adaptation",
    "HRT_SESSION_": "SessionFlags",
    "HRT_STATE_": "StateFlags",
    "HRT_TARGET_": "TargetRole",
    "HRT_PLACE_": "Place",
    "HRT_REACH_": "ReachFlags",
    "HRT_SAMPLE_": "SampleFlags",
    "HRT_COMMAND_": "CommandFlags",
    "HRT_ENDING_": "Ending",
}
# Handles, whose names in C# say that they are.
_HANDLES = {"hrt_session": "SessionHandle", "hrt_target": "TargetId", "hrt_scene": "SceneHandle",
            "hrt_calibration": "CalibrationHandle"}
_TYPES = {"int32_t": "int", "uint32_t": "uint", "int64_t": "long", "uint64_t": "ulong", "double": "double",
          "size_t": "UIntPtr", "void": "void"}
# Written by hand in Runtime/Values.cs.
_ARRAYS = {("double", 3): "Double3", ("double", 4): "Double4", ("char", 64): "Name",
           ("double", 9): "PersonMean", ("double", 45): "PersonCovariance"}
_WIDTH = 110


def render(abi: Abi, notice: str) -> str:
    return _Renderer(abi).render(notice)


def _pascal(name: str) -> str:
    return "".join(part[:1].upper() + part[1:].lower() for part in name.split("_"))


def _camel(name: str) -> str:
    text = _pascal(name)
    return text[:1].lower() + text[1:]


def _member(constant: str) -> tuple[str, str]:
    """The enum of a constant, or the class of those that are in none, and its name there."""
    if constant == "HRT_OK":
        return "Result", "Ok"
    for prefix, enum in _ENUMS.items():
        if constant.startswith(prefix):
            return enum, _pascal(constant.removeprefix(prefix))
    return "Constants", _pascal(constant.removeprefix("HRT_"))


class _Renderer:
    def __init__(self, abi: Abi) -> None:
        self.abi = abi
        named = [s.name for s in abi.structs] + [c.name for c in abi.callbacks]
        self.types = {name: _HANDLES.get(name) or _pascal(name.removeprefix("hrt_")) for name in named}
        self.fields = {f.name: _camel(f.name) for s in abi.structs for f in s.fields if "_" in f.name}
        self.members = {c.name: _member(c.name) for c in abi.constants}

    def render(self, notice: str) -> str:
        parts = [self.constants()]
        parts += [self.enum(name) for name in _ENUMS.values()]
        parts += [self.struct(s) for s in self.abi.structs]
        parts += [self.callback(c) for c in self.abi.callbacks]
        parts.append("internal static class Native\n{\n"
                     '    internal const string Library = "haptic_retargeting";\n\n'
                     + "\n".join(self.function(f) for f in self.abi.functions) + "}\n")
        body = textwrap.indent("\n".join(parts), "    ", lambda line: line.strip() != "")
        return (f"// {notice} The headers say what each call does.\n"
                "using System;\nusing System.Runtime.InteropServices;\n\n"
                "namespace Hrt\n{\n" + body + "}\n")

    def constants(self) -> str:
        text = "public static class Constants\n{\n"
        for c in self.abi.constants:
            enum, name = self.members[c.name]
            if enum == "Constants":
                text += self.doc(c.doc or c.group, "    ") + f"    public const int {name} = {c.value};\n"
        return text + "}\n"

    def enum(self, name: str) -> str:
        constants = [c for c in self.abi.constants if self.members[c.name][0] == name]
        group = next((c.group for c in constants if c.group), "")
        flags = name.endswith("Flags")
        text = self.doc("HRT_OK or an error." if name == "Result" else group, "")
        text += "[Flags]\n" if flags else ""
        text += f"public enum {name} : {'int' if name == 'Result' else 'uint'}\n{{\n"
        text += "    None = 0,\n" if flags else ""
        return text + "".join(self.enumerator(c) for c in constants) + "}\n"

    def enumerator(self, constant: Constant) -> str:
        return self.doc(constant.doc, "    ") + f"    {self.members[constant.name][1]} = {constant.value},\n"

    def struct(self, struct: Struct) -> str:
        text = self.doc(struct.doc, "") + "[Serializable]\n[StructLayout(LayoutKind.Sequential)]\n"
        text += f"public partial struct {self.types[struct.name]}\n{{\n"
        for f in struct.fields:
            text += self.doc(f.doc, "    ") + f"    public {self.field_type(f)} {_camel(f.name)};\n"
        return text + "}\n"

    def field_type(self, field: Field) -> str:
        if field.length:
            return _ARRAYS[field.type.name, field.length]
        enum = re.search(r"\b(HRT_[A-Z]+_)\*", field.doc)
        if enum and field.type == Type("uint32_t"):
            return _ENUMS[enum[1]]
        return "IntPtr" if field.type.callback else self.value(field.type)

    def callback(self, function: Function) -> str:
        # What a callback is given is only ever looked at through pointers.
        parameters = ", ".join(f"{self.value(p.type)} {_camel(p.name)}" for p in function.parameters)
        return (self.doc(function.doc, "") + "[UnmanagedFunctionPointer(CallingConvention.Cdecl)]\n"
                f"internal delegate {self.value(function.result)} {self.types[function.name]}({parameters});\n")

    def function(self, function: Function) -> str:
        result = "Result" if function.result == Type("int32_t") else self.value(function.result)
        parameters = [self.parameter(p) for p in function.parameters]
        text = f"    internal static extern {result} {function.name}({', '.join(parameters)});"
        if len(text) + 4 > _WIDTH:
            text = f"    internal static extern {result} {function.name}("
            for i, parameter in enumerate(parameters):
                item = parameter + (");" if i + 1 == len(parameters) else ",")
                line = text.rpartition("\n")[2]
                fits = "\n" in text and len(line) + len(item) + 5 <= _WIDTH
                text += (" " if fits else "\n" + " " * 8) + item
        return "    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]\n" + text + "\n"

    def parameter(self, parameter: Parameter) -> str:
        type_, name = parameter.type, _camel(parameter.name)
        if not type_.pointer or type_.name == "void" and not parameter.array:
            return f"{self.value(type_)} {name}"
        element = "byte" if type_.name in ("char", "void") else _TYPES.get(type_.name) or self.types[type_.name]
        if parameter.array or element == "byte":
            return f"{'[In]' if type_.const else '[In, Out]'} {element}[] {name}"
        # A struct that is filled in brings its size, so it goes both ways.
        return f"{'out' if type_.name in _TYPES or type_.name in _HANDLES else 'ref'} {element} {name}"

    def value(self, type_: Type) -> str:
        return "IntPtr" if type_.pointer else _TYPES.get(type_.name) or self.types[type_.name]

    def doc(self, text: str, indent: str) -> str:
        """A header's comment as C#'s, with the names as they are there."""
        if not text:
            return ""
        text = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
        text = re.sub(r"\b(hrt_\w+)::(\w+)",
                      lambda m: f"{self.types.get(m[1], m[1])}.{self.fields.get(m[2], m[2])}", text)
        text = re.sub(r"\b(HRT_[A-Z]+_)\*", lambda m: _ENUMS.get(m[1], m[0]), text)
        text = re.sub(r"\bHRT_[A-Z0-9_]+\b", lambda m: ".".join(self.members.get(m[0], (m[0],))), text)
        text = re.sub(r"\bhrt_\w+\b(?!\()", lambda m: self.types.get(m[0], m[0]), text)
        text = re.sub(r"\b[a-z]+(?:_[a-z0-9]+)+\b(?!\()", lambda m: self.fields.get(m[0], m[0]), text)
        text = re.sub(r"`([^`]*)`", r"<c>\1</c>", text)
        lines = textwrap.wrap(f"<summary>{text}</summary>", _WIDTH - 8 - len(indent), break_on_hyphens=False)
        return "".join(f"{indent}/// {line}\n" for line in lines)
