"""The C interface, from api.json: constants, enumerations, structs, callbacks, functions. For other languages and
engines ("hosts"), the fields of a nested struct with the tag @flatten become fields of the outer struct, also in texts;
the tag gives their names: plate.max_speed_deg_s becomes plate_max_speed_deg_s."""

from __future__ import annotations

import json
import re
from dataclasses import dataclass, field, replace
from decimal import Decimal
from pathlib import Path
from typing import Any

API = Path(__file__).resolve().parent.parent / "api.json"
SIZES = {"char": 1, "int32_t": 4, "uint32_t": 4, "int64_t": 8, "uint64_t": 8, "double": 8}
HIDDEN = ("struct_size", "reserved")


class HostError(Exception):
    """The files of a host cannot be generated."""


@dataclass(frozen=True)
class Type:
    """`name` is a key of SIZES, "size_t", "void", "hrt_result", or the name of a struct or a callback."""

    name: str
    pointer: bool = False
    const: bool = False  # true if a pointer points to a const type

    def __str__(self) -> str:
        return ("const " if self.const else "") + self.name + ("*" if self.pointer else "")


@dataclass(frozen=True, kw_only=True)
class Value:
    """A constant, field or parameter, with its properties from api.json; Abi sets `member`."""

    name: str
    header: str = ""
    type: Type = Type("int32_t")
    count: Any = 0  # length of a fixed array; for a parameter, the name of the parameter with its length
    offset: int = 0
    member: str = ""  # path of a field in its struct: plate.max_speed_deg_s
    value: int = 0
    unsigned: bool = False
    enumeration: str = ""  # enumeration to which a constant belongs
    values: str = ""  # enumeration whose constants are allowed
    elements: str = ""
    unit: str = ""
    min: Decimal | None = None
    max: Decimal | None = None
    zero: bool = False  # true if 0 is allowed too, although `min` is greater
    norm: tuple[Decimal, ...] = ()
    unbounded: bool = False
    default: Any = None  # name of a constant, or the numbers of the elements
    boolean: bool = False
    ccw: bool = False
    profile: Any = False
    flatten: str = ""
    text: str = ""

    @property
    def lowest(self) -> Decimal | None:
        return min(self.min, Decimal(0)) if self.zero and self.min is not None else self.min

    @property
    def bounded(self) -> bool:
        return self.min is not None and self.max is not None

    @property
    def defaults(self) -> list[Decimal]:
        """Default of each element; [] if all are 0, if there is no default, or if it is the name of a constant."""
        return self.default if isinstance(self.default, list) and any(self.default) else []

    @property
    def literals(self) -> list[str]:
        """Default of each element as a literal or a constant's name; [] if all are 0 or there is no default."""
        return [self.default] if isinstance(self.default, str) else [self.literal(n) for n in self.defaults]

    def literal(self, number: Decimal) -> str:
        if self.type.name != "double":
            return f"{int(number)}"
        text = f"{number.normalize() + 0:f}" if abs(number.adjusted()) < 7 else str(number.normalize()).lower()
        return text if "." in text or "e" in text else text + ".0"

    @property
    def doc(self) -> str:
        """Returns the text with enumeration, range and default."""
        def amount(number: Decimal) -> str:
            seconds = number / 1_000_000_000 if self.unit == "ns" else Decimal(0)
            return f"{shown(seconds)} s" if seconds >= 1 else f"{shown(seconds * 1000)} ms" if seconds else shown(number)

        parts = [self.text, f"{self.values}_*." * bool(self.values)]
        if self.min is not None:
            parts.append("0 or " * self.zero + amount(self.min) + (f" to {amount(self.max)}." if self.max is not None else " or more."))
        if self.default is not None:
            parts.append(f"Default {self.default if isinstance(self.default, str) else ', '.join(map(amount, self.default))}.")
        return " ".join(filter(None, parts))


@dataclass(frozen=True, kw_only=True)
class Enumeration:
    """Allowed values of a field, parameter or result: one member or, if `flags` is true, any combination of members."""

    name: str
    header: str
    flags: bool
    type: Type
    text: str
    members: list[Value]

    def short(self, constant: Value) -> str:
        return constant.name.removeprefix(f"{self.name}_")


@dataclass(frozen=True, kw_only=True)
class Struct:
    name: str
    header: str
    text: str
    fields: list[Value]
    size: int = 0  # 0 for structs with pointers, whose size differs between machines

    @property
    def has_default(self) -> bool:
        return self.name.endswith(("_config", "_options"))

    @property
    def is_handle(self) -> bool:
        return self.fields[0].name == "value" and len(self.fields) == 1

    @property
    def shown(self) -> list[Value]:
        return [f for f in self.fields if f.name not in HIDDEN]


@dataclass(frozen=True, kw_only=True)
class Function:
    name: str
    result: Type
    params: list[Value] = field(default_factory=list)
    text: str = ""
    header: str = ""
    returns: str = ""
    thread: str = ""
    thread_text: str = ""

    @property
    def returns_result(self) -> bool:
        return self.result.name == "hrt_result"

    @property
    def declared(self) -> str:
        return ", ".join(f"{p.type} {p.name}" for p in self.params) or "void"

    @property
    def doc(self) -> str:
        return f"{self.text} Errors: {self.returns}" if self.returns_result and self.returns else self.text


class Abi:
    """The interface of libhaptic_retargeting or, if `plate` is true, of libhrt_plate, which drives the plate."""

    def __init__(self, plate: bool = False) -> None:
        text = API.read_text(encoding="utf-8")
        parts = {f["type"]: f for s in json.loads(text)["structs"] for f in s["fields"] if "*" in f.get("flatten", "")}
        names = {f"{parts[s['name']]['name']}.{f['name']}": f.get("flatten", parts[s["name"]]["flatten"]).replace("*", f["name"])
                 for s in json.loads(text)["structs"] if s["name"] in parts for f in s["fields"]}
        text = re.sub(rf"\b({'|'.join(map(re.escape, names))})\b", lambda m: names[m[0]], text)
        api = json.loads(text, parse_float=Decimal, object_hook=_made)
        self.version: str = api["version"]
        major, minor, _ = self.version.split(".")
        self.soversion = f"0.{minor}" if major == "0" else major

        def here(entries: list[Any]) -> list[Any]:
            return [e for e in entries if (e.header == "plate.h") == plate]

        def flat(whole: Value) -> list[Value]:
            """Returns the field itself or, if its struct is flattened, the fields of the struct."""
            return [replace(whole, member=whole.name)] if "*" not in whole.flatten else [
                replace(f, name=names[f"{whole.name}.{f.name}"], member=f"{whole.name}.{f.name}", offset=whole.offset + f.offset,
                        text=f.text + " Read under FIXED_DIRECTION only." * (whole.name == "paper" and whole.flatten == "*"))
                for s in api["structs"] if s.name == whole.type.name for f in s.fields]

        self.constants: list[Value] = here(api["constants"])
        self.enumerations: list[Enumeration] = here(api["enumerations"])
        for e in self.enumerations:
            e.members.extend(c for c in self.constants if c.enumeration == e.name)
        self.structs: list[Struct] = [replace(s, fields=[f for whole in s.fields for f in flat(whole)])
                                      for s in here(api["structs"]) if s.name not in parts]
        self.functions: list[Function] = here(api["functions"])
        self.callbacks: list[Function] = here(api["callbacks"])
        self.headers = sorted({s.header for s in self.structs})

    def struct(self, name: str) -> Struct:
        return next(s for s in self.structs if s.name == name)

    def enumeration(self, name: str) -> Enumeration:
        return next(e for e in self.enumerations if e.name == name)

    def size(self, value: Value) -> int:
        """Returns the size of all elements in bytes."""
        return (SIZES.get(value.type.name) or self.struct(value.type.name).size) * (value.count or 1)

    def enumeration_names(self, special: dict[str, str], flags: str) -> dict[str, str]:
        """Returns a type name for each enumeration: that in `special`, or else a name such as Guidance for
        HRT_GUIDANCE. Names of flags get the suffix `flags`."""
        return {e.name: special.get(e.name) or pascal(e.name.removeprefix("HRT_")) + (flags if e.flags else "")
                for e in self.enumerations}


def _made(entry: dict[str, Any]) -> Any:
    """Converts an object of api.json, except the outermost, to a Struct, Enumeration, Function or Value."""
    for key in entry.keys() & {"type", "result"}:
        text = entry[key]
        entry[key] = Type(text.removeprefix("const ").rstrip("*"), text.endswith("*"), text.startswith("const "))
    for key in entry.keys() & {"min", "max"}:
        entry[key] = Decimal(entry[key])
    if not isinstance(entry.get("default", ""), str):
        given = entry["default"]
        entry["default"] = [Decimal(number) for number in (given if isinstance(given, list) else [given])]
    if "version" in entry:
        return entry
    if "fields" in entry:
        return Struct(**entry)
    return Enumeration(**entry, members=[]) if "flags" in entry else Function(**entry) if "params" in entry else Value(**entry)


class Names:
    """Maps C names to the names of a host."""

    def __init__(self, types: dict[str, str], enumerations: dict[str, str], constants: dict[str, str], fields: dict[str, str]) -> None:
        self.types, self.enumerations, self.constants, self.fields = types, enumerations, constants, fields

    def renamed(self, text: str) -> str:
        """Replaces the C names of types, fields and constants in a text; constants may lack the prefix HRT_."""
        def name(found: re.Match[str]) -> str:
            struct, field, enumeration, constant = found.groups()
            if struct:
                return f"{self.types.get(struct, struct)}.{self.fields.get(field, field)}"
            if enumeration:
                return self.enumerations.get(enumeration, found[0].removeprefix("HRT_"))
            if constant:
                return self.constants.get(found[0]) or self.constants.get(f"HRT_{constant}", found[0])
            return self.types.get(found[0]) or self.fields.get(found[0], found[0])

        return re.sub(r"\b(hrt_\w+)::(\w+)|\b(HRT_[A-Z_]+)_\*|\b(?:HRT_)?([A-Z]+_[A-Z0-9_]+)\b|\b[a-z]+(?:_[a-z0-9]+)+\b(?!\()", name, text)


def shown(number: Decimal) -> str:
    text = f"{number.normalize() + 0:f}"
    return text if len(text) < 8 else str(number.normalize()).lower().replace("+", "")


def pascal(name: str) -> str:
    return "".join(part[:1].upper() + part[1:].lower() for part in name.split("_"))
