"""Generates the C interface for C#: enums, blittable structs with public fields, P/Invoke declarations.

Types and members have names in the style of Unity: hrt_session_config becomes SessionConfig, struct_size becomes
structSize. Functions keep their names.
"""

from __future__ import annotations

import re
import textwrap

from abi import Abi, Enumeration, Function, Names, Struct, Type, Value, pascal

# Enumerations whose names do not follow from the C names.
_ENUMS = {"HRT_ERROR": "Result", "HRT_LOG": "LogLevel", "HRT_TARGET": "TargetRole"}
_HANDLES = {"hrt_target": "TargetId"}
# Handles that C# classes keep as numbers.
_OWNED = ("hrt_session", "hrt_person", "hrt_plate")
_TYPES = {"int32_t": "int", "uint32_t": "uint", "int64_t": "long", "uint64_t": "ulong", "double": "double",
          "hrt_result": "Result", "size_t": "UIntPtr", "void": "void"}
# Array types that several structs use.
_ARRAYS = {("double", 3): "Double3", ("double", 4): "Double4", ("char", 64): "Name"}
_SHARED = {
    "Double3": ("double", "x y z", "Three numbers in the axes of the library, for example a position in plate coordinates: metres, x right, y up, z towards the user."),
    "Double4": ("double", "x y z w", "Four numbers, for example a unit quaternion in the right-handed axes of the library."),
    "Name": ("ulong", " ".join(f"word{i}" for i in range(8)), "A name of at most 63 bytes of UTF-8, followed by a NUL."),
}
_WIDTH = 110


def camel(name: str) -> str:
    text = pascal(name)
    return text[:1].lower() + text[1:]


class Renderer(Names):
    def __init__(self, abi: Abi, plugin: Renderer | None = None) -> None:
        """`plugin`: renderer of the plugin's interface, to which the texts refer if `abi` is that of libhrt_plate."""
        self.abi, self.library, self.native = abi, "hrt_plate" if plugin else "haptic_retargeting", "PlateNative" if plugin else "Native"
        super().__init__({s.name: _HANDLES.get(s.name) or pascal(s.name.removeprefix("hrt_")) + "Handle" * s.is_handle for s in abi.structs}
                         | {c.name: pascal(c.name.removeprefix("hrt_")) for c in abi.callbacks},
                         abi.enumeration_names(_ENUMS, "Flags"), {},
                         {f.name: camel(f.name) for s in abi.structs for f in s.fields if "_" in f.name})
        self.callbacks = [c.name for c in abi.callbacks]
        self.constants = {c.name: f"Constants.{pascal(c.name.removeprefix('HRT_'))}" for c in abi.constants} | {"HRT_OK": "Result.Ok"}
        self.constants |= {c.name: f"{self.enumerations[e.name]}.{pascal(e.short(c))}" for e in abi.enumerations for c in e.members}
        # Types of arrays that are not in _ARRAYS are named after the field (PersonMean), with the name of the struct
        # before it if the field's name is one word.
        self.arrays = {(s.name, f.name): _ARRAYS.get((f.type.name, f.count)) or self.types[s.name] * ("_" not in f.name) + pascal(f.name)
                       for s in abi.structs for f in s.fields if f.count}
        if plugin:
            self.types, self.fields = plugin.types | self.types, plugin.fields | self.fields

    def render(self, notice: str) -> str:
        parts = [self.enum(e) for e in self.abi.enumerations]
        if constants := [c for c in self.abi.constants if self.constants[c.name].startswith("Constants.")]:
            parts.insert(0, "public static class Constants\n{\n" + "".join(map(self.constant, constants)) + "}\n")
        parts += [self.struct(s) for s in self.abi.structs]
        parts += [self.array(s, f) for s in self.abi.structs for f in s.fields
                  if f.count and (f.type.name, f.count) not in _ARRAYS]
        parts += [self.shared(name) for name in _SHARED if self.native == "Native"]
        parts += [self.callback(c) for c in self.abi.callbacks]
        parts.append(f"internal static class {self.native}\n{{\n"
                     f'    internal const string Library = "{self.library}";\n\n'
                     + "\n".join(self.function(f) for f in self.abi.functions) + "}\n")
        body = textwrap.indent("\n".join(parts), "    ", lambda line: line.strip() != "")
        return (f"// {notice} The headers say what each call does.\n"
                "using System;\nusing System.Runtime.InteropServices;\n\n"
                "namespace Hrt\n{\n" + body + "}\n")

    def constant(self, constant: Value) -> str:
        return self.doc(constant.text, "    ") + f"    public const int {self.constants[constant.name].partition('.')[2]} = {constant.value};\n"

    def enum(self, enumeration: Enumeration) -> str:
        name = self.enumerations[enumeration.name]
        zero = {True: "    None = 0,\n"}.get(enumeration.flags, "    Ok = 0,\n" * (name == "Result"))
        return (self.doc(enumeration.text, "") + "[Flags]\n" * enumeration.flags
                + f"public enum {name} : {'int' if name == 'Result' else 'uint'}\n{{\n{zero}"
                + "".join(self.doc(c.text, "    ") + f"    {pascal(enumeration.short(c))} = {c.value},\n" for c in enumeration.members) + "}\n")

    def struct(self, struct: Struct) -> str:
        name = self.types[struct.name]
        text = self.doc(struct.text, "") + "[Serializable, StructLayout(LayoutKind.Sequential)]\n"
        text += f"public partial struct {name}\n{{\n"
        for f in struct.fields:
            text += self.doc(f.doc, "    ") + f"    public {self.field_type(struct, f)} {camel(f.name)};\n"
        if struct.has_default:
            values = "".join(f"        {camel(f.name)} = {value},\n" for f in struct.fields if (value := self.default(struct, f)))
            text += (f"\n    /// <summary>Every field with its default.</summary>\n    public static {name} Default => new {name}\n"
                     f"    {{\n        structSize = SizeOf<{name}>.Value,\n{values}    }};\n")
        return text + "}\n"

    def default(self, struct: Struct, field: Value) -> str:
        if not field.literals or isinstance(field.default, str):
            return self.constants[field.default] if field.literals else ""
        return f"new {self.field_type(struct, field)}({', '.join(field.literals)})" if field.count else field.literals[0]

    def field_type(self, struct: Struct, field: Value) -> str:
        if field.count or field.values:
            return self.arrays[struct.name, field.name] if field.count else self.enumerations[field.values]
        return "IntPtr" if field.type.name in self.callbacks else self.value(field.type)

    def array(self, struct: Struct, field: Value) -> str:
        """Renders a fixed array as a struct, because C# 7.2 has fixed arrays in unsafe code only. 8 characters become a
        word."""
        prefix = f"{field.elements}_"
        names = {c.value: camel(c.name.removeprefix(prefix)) for c in reversed(self.abi.constants) if c.name.startswith(prefix)}
        text = field.type.name == "char"
        elements = ", ".join(f"word{i}" if text else names.get(i, f"value{i}") for i in range(field.count // (8 if text else 1)))
        return (self.doc(field.doc, "") + "[Serializable, StructLayout(LayoutKind.Sequential)]\n"
                f"public struct {self.arrays[struct.name, field.name]}\n{{\n"
                f"    public {'ulong' if text else _TYPES[field.type.name]} {elements};\n"
                + f"\n    public override string ToString() => Utf8.Read({elements});\n" * text + "}\n")

    def shared(self, name: str) -> str:
        type_, names, text = _SHARED[name]
        elements = names.split()
        is_text = type_ == "ulong"
        parameters = "string text" if is_text else ", ".join(f"double {e}" for e in elements)
        lines = ["ulong[] words = Utf8.Words(text, nameof(text));"] * is_text
        lines += [f"this.{e} = {f'words[{i}]' if is_text else e};" for i, e in enumerate(elements)]
        shown = f"Utf8.Read({', '.join(elements)})" if is_text else f'FormattableString.Invariant($"({", ".join(f"{{{e}}}" for e in elements)})")'
        return (self.doc(text, "") + "[Serializable, StructLayout(LayoutKind.Sequential)]\n"
                f"public struct {name}\n{{\n    public {type_} {', '.join(elements)};\n\n    public {name}({parameters})\n    {{\n"
                + "".join(f"        {line}\n" for line in lines) + "    }\n\n"
                + "    public static implicit operator Name(string text) => new Name(text);\n\n" * is_text
                + f"    public override string ToString() => {shown};\n}}\n")

    def callback(self, function: Function) -> str:
        parameters = ", ".join(f"{self.value(p.type)} {camel(p.name)}" for p in function.params)
        return (self.doc(function.text, "") + "[UnmanagedFunctionPointer(CallingConvention.Cdecl)]\n"
                f"internal delegate {self.value(function.result)} {self.types[function.name]}({parameters});\n")

    def function(self, function: Function) -> str:
        parameters = ", ".join(map(self.parameter, function.params))
        return ("    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]\n"
                f"    internal static extern {self.value(function.result)} {function.name}({parameters});\n")

    def parameter(self, parameter: Value) -> str:
        type_, name = parameter.type, camel(parameter.name)
        if not type_.pointer or type_.name == "void" and not parameter.count:
            return f"{self.value(type_)} {name}"
        if type_.name in _OWNED:
            return f"out ulong {name}"
        element = "byte" if type_.name in ("char", "void") else _TYPES.get(type_.name) or self.types[type_.name]
        if parameter.count or element == "byte":
            return f"{'[In]' if type_.const else '[In, Out]'} {element}[] {name}"
        # A struct that the function fills has its size set by the caller, so it is passed in both directions.
        return f"{'out' if type_.name in _TYPES or self.abi.struct(type_.name).is_handle else 'ref'} {element} {name}"

    def value(self, type_: Type) -> str:
        return "IntPtr" if type_.pointer else _TYPES.get(type_.name) or self.types[type_.name]

    def doc(self, text: str, indent: str) -> str:
        if not text:
            return ""
        text = self.renamed(text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;"))
        text = re.sub(r"`([^`]*)`", r"<c>\1</c>", text)
        lines = textwrap.wrap(f"<summary>{text}</summary>", _WIDTH - 8 - len(indent), break_on_hyphens=False)
        return "".join(f"{indent}/// {line}\n" for line in lines)
