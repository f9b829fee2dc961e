"""The C interface for C#, in Unity's manner: enums, blittable structs with plain fields, P/Invoke declarations.

Types and members are in C#'s case and without hrt_; functions keep their names. Constants that belong together become
an enum; a field is of that enum if its comment in the headers says so ("HRT_CONTROL_*").
"""

from __future__ import annotations

import re
import textwrap

import fields
from abi import Abi, Enumeration, Field, Function, Parameter, Struct, Type, pascal

# Whose names in C# are not those of the headers.
_ENUMS = {"HRT_ERROR_": "Result", "HRT_LOG_": "LogLevel", "HRT_TARGET_": "TargetRole"}
_HANDLES = {"hrt_target": "TargetId"}
_TYPES = {"int32_t": "int", "uint32_t": "uint", "int64_t": "long", "uint64_t": "ulong", "double": "double",
          "size_t": "UIntPtr", "void": "void"}
# Written by hand in Runtime/Values.cs.
_ARRAYS = {("double", 3): "Double3", ("double", 4): "Double4", ("char", 64): "Name"}
_WIDTH = 110


def render_plate(abi: Abi, plugin: Abi, notice: str) -> str:
    """Of libhrt_plate, whose comments refer to the plugin's structs."""
    names, others = Renderer(abi, "hrt_plate", "PlateNative"), Renderer(plugin)
    names.types, names.fields = others.types | names.types, others.fields | names.fields
    return names.render(notice)


def camel(name: str) -> str:
    text = pascal(name)
    return text[:1].lower() + text[1:]


class Renderer:
    def __init__(self, abi: Abi, library: str = "haptic_retargeting", native: str = "Native") -> None:
        """`native` is the class of the declarations."""
        self.abi, self.library, self.native = abi, library, native
        self.types = {s.name: _HANDLES.get(s.name) or pascal(s.name.removeprefix("hrt_")) + ("Handle" * s.is_handle)
                      for s in abi.structs}
        self.types |= {c.name: pascal(c.name.removeprefix("hrt_")) for c in abi.callbacks}
        self.fields = {f.name: camel(f.name) for s in abi.structs for f in s.fields if "_" in f.name}
        self.enums = abi.enumeration_names(_ENUMS, "Flags")
        self.members = {c.name: ("Constants", pascal(c.name.removeprefix("HRT_"))) for c in abi.constants}
        self.members |= {c.name: (self.enums[e.prefix], pascal(e.short(c)))
                         for e in abi.enumerations for c in e.members} | {"HRT_OK": ("Result", "Ok")}
        self.arrays = {(s.name, f.name): self.array_name(s, f) for s in abi.structs for f in s.fields if f.length}

    def render(self, notice: str) -> str:
        parts = [self.constants()] if any(enum == "Constants" for enum, _ in self.members.values()) else []
        parts += [self.enum(e) for e in self.abi.enumerations if e.members]
        parts += [self.struct(s) for s in self.abi.structs]
        parts += [self.array(s, f) for s in self.abi.structs for f in s.fields
                  if f.length and (f.type.name, f.length) not in _ARRAYS]
        parts += [self.callback(c) for c in self.abi.callbacks]
        parts.append(f"internal static class {self.native}\n{{\n"
                     f'    internal const string Library = "{self.library}";\n\n'
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

    def enum(self, enumeration: Enumeration) -> str:
        name = self.enums[enumeration.prefix]
        text = self.doc(enumeration.doc, "") + ("[Flags]\n" if enumeration.flags else "")
        text += f"public enum {name} : {'int' if name == 'Result' else 'uint'}\n{{\n"
        text += "    None = 0,\n" if enumeration.flags else "    Ok = 0,\n" if name == "Result" else ""
        return text + "".join(self.doc(c.doc, "    ") + f"    {self.members[c.name][1]} = {c.value},\n" for c in enumeration.members) + "}\n"

    def struct(self, struct: Struct) -> str:
        name = self.types[struct.name]
        text = self.doc(struct.doc, "") + "[Serializable, StructLayout(LayoutKind.Sequential)]\n"
        text += f"public partial struct {name}\n{{\n"
        for f in struct.fields:
            text += self.doc(f.doc, "    ") + f"    public {self.field_type(struct, f)} {camel(f.name)};\n"
        if struct.has_default:
            values = "".join(f"        {camel(f.name)} = {value},\n" for f in struct.fields if (value := self.default(struct, f)))
            text += (f"\n    /// <summary>Every field with its default.</summary>\n    public static {name} Default => new {name}\n"
                     f"    {{\n        structSize = SizeOf<{name}>.Value,\n{values}    }};\n")
        return text + "}\n"

    def default(self, struct: Struct, field: Field) -> str:
        """Empty: zero."""
        given = fields.default_of(field)
        if not any(number.strip("0.") for number in given):
            return ""
        if given[0] in self.members:
            return ".".join(self.members[given[0]])
        return f"new {self.field_type(struct, field)}({', '.join(given)})" if field.length else given[0]

    def field_type(self, struct: Struct, field: Field) -> str:
        if field.length:
            return self.arrays[struct.name, field.name]
        if field.enumeration:
            return self.enums[field.enumeration]
        return "IntPtr" if field.type.callback else self.value(field.type)

    def array_name(self, struct: Struct, field: Field) -> str:
        """PersonMean; of a field of one word with its struct's: RegistrationCovariance."""
        known = _ARRAYS.get((field.type.name, field.length))
        return known or ("" if "_" in field.name else self.types[struct.name]) + pascal(field.name)

    def array(self, struct: Struct, field: Field) -> str:
        """A fixed array, which C# has not. Its elements are named by the constants of which the comment speaks."""
        if field.type.name == "char":
            return self.text(struct, field)
        prefix = field.named_prefix
        names = {c.value: camel(c.name.removeprefix(prefix)) for c in reversed(self.abi.constants) if prefix and c.name.startswith(prefix)}
        text = self.doc(field.doc, "") + "[Serializable, StructLayout(LayoutKind.Sequential)]\n"
        text += f"public struct {self.arrays[struct.name, field.name]}\n{{\n"
        elements = ", ".join(names.get(i, f"value{i}") for i in range(field.length))
        lines = textwrap.wrap(f"public {_TYPES[field.type.name]} {elements};", _WIDTH - 12)
        return text + textwrap.indent("\n".join(lines).replace("\n", "\n    "), "    ") + "\n}\n"

    def text(self, struct: Struct, field: Field) -> str:
        """A fixed array of characters, in words of eight bytes."""
        words = ", ".join(f"word{i}" for i in range(field.length // 8))
        declared = "\n        ".join(textwrap.wrap(f"public ulong {words};", _WIDTH - 16))
        passed = "\n        ".join(textwrap.wrap(f"{words});", _WIDTH - 16))
        return (self.doc(field.doc, "") + "[Serializable, StructLayout(LayoutKind.Sequential)]\n"
                f"public struct {self.arrays[struct.name, field.name]}\n{{\n    {declared}\n\n"
                f"    public override string ToString() => Utf8.Read(\n        {passed}\n}}\n")

    def callback(self, function: Function) -> str:
        # What a callback is given is only ever looked at through pointers.
        parameters = ", ".join(f"{self.value(p.type)} {camel(p.name)}" for p in function.parameters)
        return (self.doc(function.doc, "") + "[UnmanagedFunctionPointer(CallingConvention.Cdecl)]\n"
                f"internal delegate {self.value(function.result)} {self.types[function.name]}({parameters});\n")

    def function(self, function: Function) -> str:
        result = "Result" if function.result == Type("int32_t") else self.value(function.result)
        parameters = [self.parameter(p) for p in function.parameters]
        text = f"    internal static extern {result} {function.name}({', '.join(parameters)});"
        if len(text) + 4 > _WIDTH:
            # Lines break between parameters only.
            listed = ", ".join(parameter.replace(" ", "\N{NO-BREAK SPACE}") for parameter in parameters) + ");"
            lines = textwrap.wrap(listed, _WIDTH - 4, initial_indent=" " * 8, subsequent_indent=" " * 8, break_on_hyphens=False)
            text = "\n".join([f"    internal static extern {result} {function.name}(", *lines]).replace("\N{NO-BREAK SPACE}", " ")
        return "    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]\n" + text + "\n"

    def parameter(self, parameter: Parameter) -> str:
        type_, name = parameter.type, camel(parameter.name)
        if not type_.pointer or type_.name == "void" and not parameter.array:
            return f"{self.value(type_)} {name}"
        element = "byte" if type_.name in ("char", "void") else _TYPES.get(type_.name) or self.types[type_.name]
        if parameter.array or element == "byte":
            return f"{'[In]' if type_.const else '[In, Out]'} {element}[] {name}"
        # A struct that is filled in brings its size, so it goes both ways.
        return f"{'out' if type_.name in _TYPES or self.abi.struct(type_.name).is_handle else 'ref'} {element} {name}"

    def value(self, type_: Type) -> str:
        return "IntPtr" if type_.pointer else _TYPES.get(type_.name) or self.types[type_.name]

    def renamed(self, text: str) -> str:
        """A header's comment with the names as they are here."""
        text = re.sub(r"\b(hrt_\w+)::(\w+)",
                      lambda m: f"{self.types.get(m[1], m[1])}.{self.fields.get(m[2], m[2])}", text)
        text = re.sub(r"\b(HRT_[A-Z_]+_)\*", lambda m: self.enums.get(m[1], m[0]), text)
        text = re.sub(r"\b(?:HRT_)?([A-Z]+_[A-Z0-9_]+)\b",
                      lambda m: ".".join(self.members.get("HRT_" + m[1], (m[0],))), text)
        text = re.sub(r"\bhrt_\w+\b(?!\()", lambda m: self.types.get(m[0], m[0]), text)
        return re.sub(r"\b[a-z]+(?:_[a-z0-9]+)+\b(?!\()", lambda m: self.fields.get(m[0], m[0]), text)

    def doc(self, text: str, indent: str) -> str:
        """A header's comment as C#'s."""
        if not text:
            return ""
        text = self.renamed(text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;"))
        text = re.sub(r"`([^`]*)`", r"<c>\1</c>", text)
        lines = textwrap.wrap(f"<summary>{text}</summary>", _WIDTH - 8 - len(indent), break_on_hyphens=False)
        return "".join(f"{indent}/// {line}\n" for line in lines)
