"""The C interface as a model: constants, structs, functions, and their comments. headers.py reads it."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

import comments

# Ends of the names of numbers without a unit: ratios, unit vectors, and arrays whose elements have units of their own.
_WITHOUT_UNIT = ("weight", "width", "scale", "rotation", "up", "mean", "covariance", "correction")
SIZES = {"char": 1, "int32_t": 4, "uint32_t": 4, "int64_t": 8, "uint64_t": 8, "double": 8}


class HeaderError(Exception):
    """A header has something that the model has no place for."""


@dataclass(frozen=True)
class Type:
    """`name` is a key of SIZES, "size_t", "void", or the name of a struct or a callback."""

    name: str
    pointer: bool = False
    const: bool = False  # what is pointed to
    callback: bool = False

    def __str__(self) -> str:
        """As C writes it."""
        return ("const " if self.const else "") + self.name + ("*" if self.pointer else "")


@dataclass(frozen=True)
class Constant:
    name: str
    value: int
    unsigned: bool
    doc: str
    group: str  # what heads the group that begins with this one


@dataclass(frozen=True)
class Enumeration:
    """Constants of which a field, parameter or result has one, or several as flags: HRT_CONTROL_*."""

    prefix: str  # with "_"
    members: tuple[Constant, ...]
    doc: str

    @property
    def flags(self) -> bool:
        """Of single bits, written as unsigned."""
        return all(m.unsigned and m.value.bit_count() == 1 for m in self.members)

    @property
    def distinct(self) -> list[Constant]:
        """Without further names of one value."""
        return [m for i, m in enumerate(self.members) if m.value not in [o.value for o in self.members[:i]]]

    def short(self, constant: Constant) -> str:
        return constant.name.removeprefix(self.prefix)


@dataclass(frozen=True)
class Field:
    name: str
    type: Type
    length: int  # of a fixed array; 0: a single value
    doc: str
    shared_doc: str  # its own, or that of the field before, which describes both
    place: int  # among those with this comment
    path: tuple[str, ...] = ()  # of a part's field: each member on the way to it

    @property
    def member(self) -> str:
        """As C writes it behind the struct: plate.max_speed_deg_s, of the field that others see as plate_max_speed_deg_s."""
        return ".".join(self.path) or self.name

    @property
    def named_prefix(self) -> str:
        """The prefix of the constants that its comment names, or nothing."""
        named = re.search(r"\b(HRT_[A-Z_]+_)\*", self.doc)
        return named[1] if named else ""

    @property
    def enumeration(self) -> str:
        """The prefix of the constants that it takes, or nothing."""
        return self.named_prefix if self.type == Type("uint32_t") else ""

    @property
    def boolean(self) -> bool:
        return self.type == Type("uint32_t") and re.match(r"1 if |1; or 0", self.doc) is not None

    @property
    def unit(self) -> str:
        """What its name ends with: deg, m, ns ..., or nothing."""
        found = re.search(r"_(deg_s2|deg_s|deg2|deg|per_s|ns|s|m)$", self.name)
        return found[1] if found else ""

    @property
    def numbers(self) -> comments.Numbers:
        if self.name in ("struct_size", "reserved"):
            return comments.Numbers()
        return comments.numbers(self.shared_doc, self.unit, self.place)

    def check(self, struct: str, needs_default: bool) -> None:
        """Of a struct that hosts fill in, a field without range, unit or default is an error."""
        numbers = self.numbers
        if self.type.name not in SIZES or self.type.pointer or self.name in ("struct_size", "reserved"):
            return  # no number or text that a host chooses
        if not numbers.has_range or needs_default and not numbers.has_default:
            raise HeaderError(f"{struct}::{self.name}: its comment does not end with a range{' and a default' * needs_default}, "
                              "as generator/comments.py reads them")
        word = self.name.removesuffix("_sd").rpartition("_")[2]
        if self.type.name == "double" and not self.unit and word not in _WITHOUT_UNIT:
            raise HeaderError(f"{struct}::{self.name}: its name has no unit at its end; generator/abi.py lists which need none")


@dataclass(frozen=True)
class Place:
    offset: int
    size: int  # of all elements


@dataclass(frozen=True)
class Struct:
    name: str
    fields: tuple[Field, ...]
    doc: str
    header: str

    @property
    def has_default(self) -> bool:
        """Of what is configured, every field has one."""
        return self.name.endswith(("_config", "_options"))

    @property
    def is_handle(self) -> bool:
        return [f.name for f in self.fields] == ["value"]


@dataclass(frozen=True)
class Parameter:
    name: str
    type: Type
    array: bool  # many elements, or none: a neighbour is its `capacity`, `count` or `length`


@dataclass(frozen=True)
class Function:
    name: str
    result: Type
    parameters: tuple[Parameter, ...]
    doc: str

    @property
    def returns_result(self) -> bool:
        """An hrt_result, which nothing else has the type of."""
        return self.result == Type("int32_t")

    @property
    def declared(self) -> str:
        """Its parameters as C has them."""
        return ", ".join(f"{p.type} {p.name}" for p in self.parameters) or "void"


@dataclass
class Abi:
    constants: list[Constant] = field(default_factory=list)
    structs: list[Struct] = field(default_factory=list)
    callbacks: list[Function] = field(default_factory=list)
    functions: list[Function] = field(default_factory=list)
    result_doc: str = ""
    headers: list[str] = field(default_factory=list)  # each includes what it needs

    def struct(self, name: str) -> Struct:
        found = [s for s in self.structs if s.name == name]
        if not found:
            raise HeaderError(f"no struct {name}, which a host shows")
        return found[0]

    @property
    def enumerations(self) -> list[Enumeration]:
        """Those of the errors, and all that a comment names as HRT_NAME_*."""
        texts = [f.doc for f in self.functions + self.callbacks]
        prefixes = {"HRT_ERROR_"} | {f.enumeration for s in self.structs for f in s.fields if f.enumeration}
        prefixes |= {prefix for text in texts for prefix in re.findall(r"\b(HRT_[A-Z_]+_)\*", text)}
        # Of prefixes that begin alike, a constant has the longest.
        of = {c.name: max((p for p in prefixes if c.name.startswith(p)), key=len, default="") for c in self.constants}
        found = []
        for prefix in dict.fromkeys(of[c.name] for c in self.constants if of[c.name]):
            members = tuple(c for c in self.constants if of[c.name] == prefix and not c.name.endswith("_MAX"))
            doc = next((c.group for c in members if c.group), "")
            found.append(Enumeration(prefix, members, self.result_doc if prefix == "HRT_ERROR_" else doc))
        return found

    def enumeration_names(self, special: dict[str, str], flags: str) -> dict[str, str]:
        """A type's name for each prefix: Guidance, SessionFlags with `flags` "Flags". One that is also a struct's gets
        its field's name too: RegistrationVerdict."""
        taken = {s.name.removeprefix("hrt_").upper() + "_" for s in self.structs if not s.is_handle}
        names = {}
        for e in self.enumerations:
            name = pascal(e.prefix.removeprefix("HRT_"))
            if not e.flags and e.prefix.removeprefix("HRT_") in taken:
                name += pascal(next(f.name for s in self.structs for f in s.fields if f.enumeration == e.prefix))
            names[e.prefix] = special.get(e.prefix) or name + (flags if e.flags else "")
        return names

    def layout(self, struct: Struct, pointer_size: int) -> tuple[list[Place], int]:
        """Where each field is, and the size of all."""
        places: list[Place] = []
        end = 0
        for f in struct.fields:
            size, alignment = self._size(f.type, pointer_size)
            offset = -(-end // alignment) * alignment
            places.append(Place(offset, size * max(f.length, 1)))
            end = offset + places[-1].size
        return places, -(-end // self._alignment(struct, pointer_size)) * self._alignment(struct, pointer_size)

    def _alignment(self, struct: Struct, pointer_size: int) -> int:
        return max(self._size(f.type, pointer_size)[1] for f in struct.fields)

    def _size(self, type_: Type, pointer_size: int) -> tuple[int, int]:
        if type_.pointer or type_.callback or type_.name == "size_t":
            return pointer_size, pointer_size
        if type_.name in SIZES:
            return SIZES[type_.name], SIZES[type_.name]
        inner = next(s for s in self.structs if s.name == type_.name)
        return self.layout(inner, pointer_size)[1], self._alignment(inner, pointer_size)


def prefix_of(constant: str) -> str:
    return "_".join(constant.split("_")[:2]) + "_"


def pascal(name: str) -> str:
    return "".join(part[:1].upper() + part[1:].lower() for part in name.split("_"))
