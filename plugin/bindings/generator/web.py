"""Constants and struct layouts for JavaScript, with TypeScript types. In wasm32 a pointer has 4 bytes."""

from __future__ import annotations

import json

from abi import Abi, Field, Struct

_POINTER_SIZE = 4
_ELEMENTS = {"char": "u8", "int32_t": "i32", "uint32_t": "u32", "int64_t": "i64", "uint64_t": "u64",
             "double": "f64", "size_t": "u32"}


def render_script(abi: Abi, notice: str) -> str:
    text = f"// {notice}\n"
    text += "".join(f"export const {c.name} = {c.value};\n" for c in abi.constants)
    text += "\n// Where each field of a struct is, in bytes; `length` of a fixed array. i64 and u64 are BigInt.\n"
    text += "export const structs = Object.freeze({\n"
    for struct in abi.structs:
        text += f"  {struct.name}: {{ size: {abi.layout(struct, _POINTER_SIZE)[1]}, fields: {{\n"
        text += "".join(f"    {name}: {json.dumps(place)},\n" for name, place in _places(abi, struct).items())
        text += "  } },\n"
    text += "});\n\n// Every function that the module exports.\nexport const functions = Object.freeze([\n"
    text += "".join(f'  "{f.name}",\n' for f in abi.functions)
    return text + "]);\n"


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
        "  readonly fields: Readonly<Record<Field, FieldPlace>>;\n"
        "}\n\n"
        "export declare const structs: {\n")
    for struct in abi.structs:
        names = " | ".join(f'"{f.name}"' for f in struct.fields)
        text += f"  readonly {struct.name}: StructLayout<{names}>;\n"
    text += "};\n\nexport declare const functions: readonly string[];\n\n"
    return text + "\n".join(_interface(abi, struct) for struct in abi.structs)


def _comment(text: str) -> str:
    return f"/** {text} */\n" if text else ""


def _element(abi: Abi, field: Field) -> str:
    if field.type.pointer or field.type.callback:
        return "pointer"
    if field.type.name in _ELEMENTS:
        return _ELEMENTS[field.type.name]
    inner = next(s for s in abi.structs if s.name == field.type.name)
    return "u64" if inner.is_handle else inner.name


def _places(abi: Abi, struct: Struct) -> dict[str, dict[str, object]]:
    places: dict[str, dict[str, object]] = {}
    for field, place in zip(struct.fields, abi.layout(struct, _POINTER_SIZE)[0]):
        places[field.name] = {"offset": place.offset, "type": _element(abi, field)}
        if field.length:
            places[field.name]["length"] = field.length
    return places


def _interface(abi: Abi, struct: Struct) -> str:
    """The struct as a JavaScript object."""
    text = _comment(struct.doc) + f"export interface {struct.name} {{\n"
    for field in struct.fields:
        element = _element(abi, field)
        kind = "bigint" if element in ("i64", "u64") else element if element.startswith("hrt_") else "number"
        if field.length:
            kind = "string" if field.type.name == "char" else f"{kind}[]"
        text += ("  " + _comment(field.doc) if field.doc else "") + f"  {field.name}: {kind};\n"
    return text + "}\n"
