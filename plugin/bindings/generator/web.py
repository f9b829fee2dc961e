"""Generates constants and struct layouts of wasm32 for JavaScript, with TypeScript types."""

from __future__ import annotations

import json

from abi import Abi, HostError, Struct, Type

_ELEMENTS = {"char": "u8", "int32_t": "i32", "uint32_t": "u32", "int64_t": "i64", "uint64_t": "u64",
             "double": "f64", "size_t": "u32", "hrt_result": "i32"}
# JavaScript that writes and reads a field of each type without creating objects, with the functions of web/numbers.mjs.
# {0} is the offset of the field, {1} its name.
_FRAME_TYPES = {"double": ("view.setFloat64(at + {0}, {1}, true)", "view.getFloat64(at + {0}, true)"),
                "uint32_t": ('writeU32(view, at + {0}, "{1}", {1})', "view.getUint32(at + {0}, true)"),
                "int64_t": ('writeI64(view, at + {0}, "{1}", {1})', "readI64(view, at + {0})")}


def render_script(abi: Abi, notice: str) -> str:
    text = f"// {notice}\n"
    text += "".join(f"export const {c.name} = {c.value};\n" for c in abi.constants)
    text += "\n// Layouts: sizes and offsets in bytes; `length` of fixed arrays. i64 and u64 are BigInt.\n"
    text += "export const structs = Object.freeze({\n"
    for struct in (s for s in abi.structs if s.size):
        text += f"  {struct.name}: {{ size: {struct.size}, fields: {{\n"
        for f in struct.fields:
            place = {"offset": f.offset, "type": _element(abi, f.type)} | ({"length": f.count} if f.count else {})
            text += f"    {f.name}: {json.dumps(place)},\n"
        text += "  }" + (f", defaults: {{ {_defaults(abi, struct)} }}" if struct.has_default else "") + " },\n"
    text += "});\n\n// Functions of the C interface that the module exports, with their parameters; i64 and u64 are BigInt.\n"
    text += "export const functions = Object.freeze([\n"
    for f in abi.functions:
        parameters = ", ".join(f"{p.name}: {_element(abi, p.type)}" for p in f.params)
        text += f'  "{f.name}",{parameters and "  // " + parameters}\n'
    return text + "]);\n"


def render_frames(abi: Abi, notice: str) -> str:
    """Renders access to the structs that are read or written in each frame. The code has a statement for each field, so
    that a frame creates no objects and looks up no names."""
    text = f"// {notice}\n" + 'import { writeF64s, writeI64, writeU32, readI64 } from "./numbers.mjs";\n'
    for name, title in (("hrt_sample", "Sample"), ("hrt_command", "Command")):
        fields, writes, reads, starts, arrays = abi.struct(name).shown, "", "", "", []
        for f in fields:
            if f.type.name not in _FRAME_TYPES:
                raise HostError(f"{name}::{f.name}: the web's frames have {', '.join(_FRAME_TYPES)}, not {f.type.name}")
            write, read = _FRAME_TYPES[f.type.name]
            if f.count:
                arrays.append(f"{f.name}: [...this.{f.name}]")
                starts += f"  {f.name} = new Float64Array({f.count});\n"
                writes += f'  writeF64s(view, at + {f.offset}, "{f.name}", {f.name}, {f.count});\n'
                reads += "".join(f"  into.{f.name}[{i}] = {read.format(f.offset + 8 * i)};\n" for i in range(f.count))
            else:
                starts += f"  {f.name} = 0;\n"
                writes += f"  {write.format(f.offset, f.name)};\n"
                reads += f"  into.{f.name} = {read.format(f.offset)};\n"
        text += f"\nexport class {title} {{\n{starts}  constructor() {{ Object.preventExtensions(this); }}\n"
        text += f"  toJSON() {{ return {{ ...this, {', '.join(arrays)} }}; }}\n" * bool(arrays) + "}\n"
        if title == "Sample":
            text += f"\nexport function write{title}(view, at, {{ {', '.join(f.name for f in fields)} }}) {{\n{writes}}}\n"
        text += f"\nexport function read{title}(view, at, into) {{\n{reads}}}\n"
    return text


def _defaults(abi: Abi, struct: Struct) -> str:
    values = {c.name: str(c.value) for c in abi.constants}
    given = {f.name: [values.get(n, n) + "n" * (f.unit == "ns") for n in f.literals] for f in struct.fields if f.literals}
    return ", ".join(f"{name}: {v[0]}" if len(v) == 1 else f"{name}: [{', '.join(v)}]" for name, v in given.items())


_LAYOUT_TYPES = """
export interface FieldPlace {
  readonly offset: number;
  /** Number type or name of a struct. "id" is the u64 of a target, which a number represents exactly. */
  readonly type: "u8" | "i32" | "u32" | "i64" | "u64" | "id" | "f64" | string;
  readonly length?: number;
}

export interface StructLayout<Field extends string> {
  readonly size: number;
  /** Defaults that are not 0. */
  readonly defaults?: Readonly<Partial<Record<Field, unknown>>>;
  readonly fields: Readonly<Record<Field, FieldPlace>>;
}

export declare const functions: readonly string[];

export declare const structs: {
"""


def render_types(abi: Abi, notice: str) -> str:
    text = f"// {notice}\n"
    begun = {e.members[0].name: "\n" + _comment(e.text) for e in abi.enumerations}
    for c in abi.constants:
        text += begun.get(c.name, "") + _comment(c.doc) + f"export declare const {c.name} = {c.value};\n"
    structs = [s for s in abi.structs if s.size]
    text += _LAYOUT_TYPES + "".join(f"  readonly {s.name}: StructLayout<keyof {s.name}>;\n" for s in structs) + "};\n"
    for s in structs:
        text += f"\n{_comment(s.text)}export interface {s.name} {{\n"
        for f in s.fields:
            element = _element(abi, f.type)
            kind = "bigint" if element in ("i64", "u64") else element if element.startswith("hrt_") else "number"
            kind = kind if not f.count else "string" if element == "u8" else f"{kind}[]"
            text += ("  " + _comment(f.doc) if f.doc else "") + f"  {f.name}: {kind};\n"
        text += "}\n"
    return text


def _comment(text: str) -> str:
    return f"/** {text} */\n" if text else ""


def _element(abi: Abi, type_: Type) -> str:
    if type_.pointer:
        return "pointer"
    if type_.name in _ELEMENTS:
        return _ELEMENTS[type_.name]
    inner = abi.struct(type_.name)
    return "id" if inner.name == "hrt_target" else "u64" if inner.is_handle else inner.name
