"""Constants and struct layouts for JavaScript, with TypeScript types. In wasm32 a pointer has 4 bytes."""

from __future__ import annotations

import json

import fields
from abi import Abi, Field, Function, HeaderError, Struct, Type

_POINTER_SIZE = 4
_ELEMENTS = {"char": "u8", "int32_t": "i32", "uint32_t": "u32", "int64_t": "i64", "uint64_t": "u64",
             "double": "f64", "size_t": "u32"}
_IN_FRAMES = ("f64", "u32", "i64")  # what numbers.mjs writes and reads without making objects


def render_script(abi: Abi, notice: str) -> str:
    text = f"// {notice}\n"
    text += "".join(f"export const {c.name} = {c.value};\n" for c in abi.constants)
    text += "\n// Where each field of a struct is, in bytes; `length` of a fixed array. i64 and u64 are BigInt.\n"
    text += "export const structs = Object.freeze({\n"
    for struct in abi.structs:
        text += f"  {struct.name}: {{ size: {abi.layout(struct, _POINTER_SIZE)[1]}, fields: {{\n"
        text += "".join(f"    {name}: {json.dumps(place)},\n" for name, place in _places(abi, struct).items())
        text += "  }" + (f", defaults: {{ {_defaults(abi, struct)} }}" if struct.has_default else "") + " },\n"
    text += "});\n\n// Every function that the module exports, with its parameters; i64 and u64 are BigInt.\n"
    text += "export const functions = Object.freeze([\n"
    text += "".join(f'  "{f.name}",{_parameters(abi, f)}\n' for f in abi.functions)
    return text + "]);\n"


def render_frames(abi: Abi, notice: str) -> str:
    """The structs that go to and from memory in each frame, as objects of numbers: unrolled, so that no frame makes
    objects and no name is looked up."""
    text = f"// {notice}\n" + 'import { writeF64s, writeI64, writeU32, readI64 } from "./numbers.mjs";\n'
    for name, title in (("hrt_sample", "Sample"), ("hrt_command", "Command")):
        places = {f: p for f, p in _places(abi, abi.struct(name)).items() if f not in ("struct_size", "reserved")}
        for field, place in places.items():
            if place["type"] not in _IN_FRAMES:
                raise HeaderError(f"{name}::{field}: the web's frames have {', '.join(_IN_FRAMES)}, not {place['type']}")
        arrays = [f for f, place in places.items() if "length" in place]
        text += f"\nexport class {title} {{\n"
        text += "".join(f"  {f} = " + (f"new Float64Array({place['length']})" if "length" in place else "0") + ";\n"
                        for f, place in places.items())
        text += "  constructor() { Object.preventExtensions(this); }\n"
        if arrays:
            parts = ", ".join(f"{f}: [...this.{f}]" for f in arrays)
            text += f"  toJSON() {{ return {{ ...this, {parts} }}; }}\n"
        text += "}\n"
        if title == "Sample":
            text += (f"\nexport function write{title}(view, at, {{ {', '.join(places)} }}) {{\n"
                     + "".join(f"  {_write(f, place)}\n" for f, place in places.items()) + "}\n")
        text += (f"\nexport function read{title}(view, at, into) {{\n"
                 + "".join(f"  {line}\n" for f, place in places.items() for line in _reads(f, place)) + "}\n")
    return text


def _defaults(abi: Abi, struct: Struct) -> str:
    values = {c.name: str(c.value) for c in abi.constants}
    given = {f.name: [values.get(n, n) + "n" * (f.unit == "ns") for n in fields.default_of(f)] for f in struct.fields}
    shown = {f.name: f"[{', '.join(given[f.name])}]" if f.length else given[f.name][0] for f in struct.fields
             if any(n.strip("0.n") for n in given[f.name])}
    return ", ".join(f"{name}: {value}" for name, value in shown.items())


def _parameters(abi: Abi, function: Function) -> str:
    return "".join(f"{', ' if i else '  // '}{p.name}: {_element(abi, p.type)}" for i, p in enumerate(function.parameters))


def _write(field: str, place: dict[str, object]) -> str:
    at = f"at + {place['offset']}"
    if "length" in place:
        return f'writeF64s(view, {at}, "{field}", {field}, {place["length"]});'
    if place["type"] == "f64":
        return f"view.setFloat64({at}, {field}, true);"
    return f'write{str(place["type"]).upper()}(view, {at}, "{field}", {field});'


def _reads(field: str, place: dict[str, object]) -> list[str]:
    offset = int(str(place["offset"]))
    if "length" not in place:
        return [f"into.{field} = {_read(place)};"]
    return [f"into.{field}[{i}] = {_read({**place, 'offset': offset + 8 * i})};" for i in range(int(str(place["length"])))]


def _read(place: dict[str, object]) -> str:
    at = f"at + {place['offset']}"
    if place["type"] == "i64":
        return f"readI64(view, {at})"
    return f"view.{ {'f64': 'getFloat64', 'u32': 'getUint32'}[str(place['type'])] }({at}, true)"


def render_types(abi: Abi, notice: str) -> str:
    text = f"// {notice}\n"
    for constant in abi.constants:
        text += ("\n" + _comment(constant.group) if constant.group else "") + _comment(constant.doc)
        text += f"export declare const {constant.name} = {constant.value};\n"
    text += (
        "\nexport interface FieldPlace {\n"
        "  readonly offset: number;\n"
        '  /** Or the name of a struct. A handle is its u64. */\n'
        '  readonly type: "u8" | "i32" | "u32" | "i64" | "u64" | "f64" | "pointer" | string;\n'
        "  readonly length?: number;\n"
        "}\n\n"
        "export interface StructLayout<Field extends string> {\n"
        "  readonly size: number;\n"
        "  /** What is not 0 by default. */\n"
        "  readonly defaults?: Readonly<Partial<Record<Field, unknown>>>;\n"
        "  readonly fields: Readonly<Record<Field, FieldPlace>>;\n"
        "}\n\n"
        "export declare const structs: {\n")
    text += "".join(f"  readonly {struct.name}: StructLayout<keyof {struct.name}>;\n" for struct in abi.structs)
    text += "};\n\nexport declare const functions: readonly string[];\n\n"
    return text + "\n".join(_interface(abi, struct) for struct in abi.structs)


def _comment(text: str) -> str:
    return f"/** {text} */\n" if text else ""


def _element(abi: Abi, type_: Type) -> str:
    if type_.pointer or type_.callback:
        return "pointer"
    if type_.name in _ELEMENTS:
        return _ELEMENTS[type_.name]
    inner = abi.struct(type_.name)
    return "u64" if inner.is_handle else inner.name


def _places(abi: Abi, struct: Struct) -> dict[str, dict[str, object]]:
    places: dict[str, dict[str, object]] = {}
    for field, place in zip(struct.fields, abi.layout(struct, _POINTER_SIZE)[0]):
        places[field.name] = {"offset": place.offset, "type": _element(abi, field.type)}
        if field.length:
            places[field.name]["length"] = field.length
    return places


def _interface(abi: Abi, struct: Struct) -> str:
    """The struct as a JavaScript object."""
    text = _comment(struct.doc) + f"export interface {struct.name} {{\n"
    for field in struct.fields:
        element = _element(abi, field.type)
        kind = "bigint" if element in ("i64", "u64") else element if element.startswith("hrt_") else "number"
        if field.length:
            kind = "string" if field.type.name == "char" else f"{kind}[]"
        text += ("  " + _comment(field.doc) if field.doc else "") + f"  {field.name}: {kind};\n"
    return text + "}\n"
