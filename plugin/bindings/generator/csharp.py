"""P/Invoke declarations for C#: plain fields only, so that every struct is blittable.

A fixed array becomes a struct of its own (HrtDouble3: X, Y, Z; HrtChar64: eight words of eight bytes). The
names of constants and functions stay those of the C headers; structs and fields are in C#'s case.
"""

from __future__ import annotations

import textwrap
from xml.sax.saxutils import escape

from abi import Abi, Constant, Field, Function, Parameter, Struct, Type

_TYPES = {"int32_t": "int", "uint32_t": "uint", "int64_t": "long", "uint64_t": "ulong", "double": "double",
          "size_t": "UIntPtr", "void": "void"}
_COMPONENTS = {3: ("X", "Y", "Z"), 4: ("X", "Y", "Z", "W")}


def render(abi: Abi, notice: str) -> str:
    fields = [f for s in abi.structs for f in s.fields]
    arrays = {(f.type.name, f.length) for f in fields if f.length}
    parts = [_array(name, length) for name, length in sorted(arrays)]
    parts += [_struct(s) for s in abi.structs]
    parts += [_delegate(f) for f in abi.callbacks]
    parts.append("/// <summary>The C interface. Names and meanings are those of the C headers.</summary>\n"
                 "public static class NativeMethods\n{\n"
                 '#if UNITY_IOS && !UNITY_EDITOR || UNITY_WEBGL && !UNITY_EDITOR\n'
                 '    public const string Library = "__Internal";\n'
                 "#else\n"
                 '    public const string Library = "haptic_retargeting";\n'
                 "#endif\n\n"
                 + "".join(_constant(c) for c in abi.constants) + "\n"
                 + "\n".join(_function(f) for f in abi.functions) + "}\n")
    body = textwrap.indent("\n".join(parts), "    ", lambda line: line.strip() != "" and not line.startswith("#"))
    return (f"// {notice}\n"
            "using System;\nusing System.Runtime.InteropServices;\n\n"
            "namespace HapticRetargeting.Native\n{\n" + body + "}\n")


def _pascal(name: str) -> str:
    return "".join(part[:1].upper() + part[1:] for part in name.split("_"))


def _camel(name: str) -> str:
    text = _pascal(name)
    return text[:1].lower() + text[1:]


def _summary(text: str, indent: str = "") -> str:
    if not text:
        return ""
    lines = textwrap.wrap(escape(text), 100)
    if len(lines) == 1 and len(lines[0]) < 80:
        return f"{indent}/// <summary>{lines[0]}</summary>\n"
    return "".join(f"{indent}/// {line}\n" for line in ["<summary>", *lines, "</summary>"])


def _array_name(type_name: str, length: int) -> str:
    return f"Hrt{type_name.removesuffix('_t').capitalize()}{length}"


def _array(type_name: str, length: int) -> str:
    if type_name == "char":
        if length % 8:
            raise ValueError(f"char[{length}] is not a number of whole words")
        element, count, doc = "ulong", length // 8, f"{length} bytes of text, the first in the lowest byte of E0."
    else:
        element, count, doc = _TYPES[type_name], length, ""
    names = ("X", "Y", "Z", "W")[:count] if count in (3, 4) else tuple(f"E{i}" for i in range(count))
    return (_summary(doc) + "[StructLayout(LayoutKind.Sequential)]\n"
            f"public struct {_array_name(type_name, length)}\n{{\n    public {element} {', '.join(names)};\n}}\n")


def _struct(struct: Struct) -> str:
    text = _summary(struct.doc) + f"[StructLayout(LayoutKind.Sequential)]\npublic struct {_pascal(struct.name)}\n{{\n"
    for field in struct.fields:
        text += _summary(field.doc, "    ") + f"    public {_field_type(field)} {_pascal(field.name)};\n"
    return text + "}\n"


def _field_type(field: Field) -> str:
    if field.length:
        return _array_name(field.type.name, field.length)
    if field.type.pointer or field.type.callback:
        return "IntPtr"
    return _TYPES.get(field.type.name) or _pascal(field.type.name)


def _constant(constant: Constant) -> str:
    return ("".join(f"    // {line}\n" for line in textwrap.wrap(constant.group, 100))
            + _summary(constant.doc, "    ")
            + f"    public const {'uint' if constant.unsigned else 'int'} {constant.name} = {constant.value};\n")


def _value(type_: Type) -> str:
    if type_.pointer:
        return "IntPtr"
    return _TYPES.get(type_.name) or _pascal(type_.name)


def _parameter(parameter: Parameter) -> str:
    type_ = parameter.type
    if not type_.pointer or type_.name == "void" and not parameter.array:
        return f"{_value(type_)} {_camel(parameter.name)}"
    element = "byte" if type_.name in ("char", "void") else _TYPES.get(type_.name) or _pascal(type_.name)
    if parameter.array or type_.name == "char":
        direction = "[In]" if type_.const else "[Out]" if type_.name == "char" else "[In, Out]"
        return f"{direction} {element}[] {_camel(parameter.name)}"
    # A struct that is filled in brings its size, so it goes both ways.
    return f"{'in' if type_.const else 'ref'} {element} {_camel(parameter.name)}"


def _signature(function: Function) -> str:
    return ", ".join(_parameter(p) for p in function.parameters)


def _delegate(function: Function) -> str:
    # What a callback is given is only ever looked at through pointers.
    parameters = ", ".join(f"{_value(p.type)} {_camel(p.name)}" for p in function.parameters)
    return (_summary(function.doc) + "[UnmanagedFunctionPointer(CallingConvention.Cdecl)]\n"
            f"public delegate {_value(function.result)} {_pascal(function.name)}({parameters});\n")


def _function(function: Function) -> str:
    return (_summary(function.doc, "    ")
            + "    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]\n"
            + f"    public static extern {_value(function.result)} {function.name}({_signature(function)});\n")
