"""The C interface as a model, read from its headers: constants, structs, functions, and their comments.

The C preprocessor and pycparser read the declarations; comments are taken from the text of the headers, above
or behind what they describe.
"""

from __future__ import annotations

import re
import subprocess
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

from pycparser import c_ast, c_parser

import comments

SIZES = {"char": 1, "int32_t": 4, "uint32_t": 4, "int64_t": 8, "uint64_t": 8, "double": 8}


# Headers that are written from the others.
WRITTEN = ("init.h", "functions.h")


class HeaderError(Exception):
    """A header has something that the model has no place for."""


@dataclass(frozen=True)
class Type:
    """`name` is a key of SIZES, "size_t", "void", or the name of a struct or a callback."""

    name: str
    pointer: bool = False
    const: bool = False  # what is pointed to
    callback: bool = False


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

    @property
    def enumeration(self) -> str:
        """The prefix of the constants that it takes, or nothing."""
        named = re.search(r"\b(HRT_[A-Z_]+_)\*", self.doc)
        return named[1] if named and self.type == Type("uint32_t") else ""

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
        return comments.numbers(self.shared_doc, self.unit, self.place)


@dataclass(frozen=True)
class Place:
    offset: int
    size: int  # of all elements


@dataclass(frozen=True)
class Struct:
    name: str
    fields: tuple[Field, ...]
    doc: str

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


def read(include: Path, plate: bool = False) -> Abi:
    """The interface that `include`/haptic_retargeting/*.h declare: of the plugin, or of the library that drives the plate."""
    headers = sorted(p for p in (include / "haptic_retargeting").glob("*.h")
                     if p.name not in WRITTEN and (p.name == "plate.h") == plate)
    if not headers:
        raise HeaderError(f"no headers in {include}/haptic_retargeting")
    # The header of all includes what is written from the model.
    names = [path.name for path in headers if path.name != "haptic_retargeting.h"]
    texts = {str(path): path.read_text(encoding="utf-8") for path in headers}
    macros = [name for text in texts.values() for name in re.findall(r"^#define (HRT_\w+) +[^\s_]", text, re.M)]
    macros = [name for name in macros if name not in ("HRT_API", "HRT_NODISCARD", "HRT_NOEXCEPT")]
    try:
        tree = c_parser.CParser().parse(_preprocess([include], names, macros))
    except c_parser.ParseError as error:
        raise HeaderError(f"{error}: not C that pycparser reads") from error

    abi = Abi(headers=names)
    for node in tree.ext:
        if str(node.coord.file) in texts:
            _take(node, texts[str(node.coord.file)], abi)
    values = {e.name: e.value for node in tree.ext if _is_values(node) for e in node.type.values.enumerators}
    for text in texts.values():
        for name in macros:
            at = re.search(rf"^#define {name}\b", text, re.M)
            if at:
                value, unsigned = _evaluate(values[name + "_value"])
                abi.constants.append(Constant(name, value, unsigned, *_constant_doc(text, at.start())))
    _check_types(abi)
    return abi


def _check_types(abi: Abi) -> None:
    known = {*SIZES, "size_t", *(s.name for s in abi.structs), *(c.name for c in abi.callbacks)}
    used = [(f"{s.name}::{f.name}", f.type) for s in abi.structs for f in s.fields]
    used += [(f"{f.name}({p.name})", p.type) for f in abi.functions + abi.callbacks for p in f.parameters]
    for place, type_ in used:
        if type_.name not in known and not (type_.pointer and type_.name == "void"):
            raise HeaderError(f"{place}: {type_.name} is none of the types that every host has: {', '.join(SIZES)}")


# What the headers need of the C library, in types whose size says what they are.
_STDINT = """
typedef int int32_t; typedef unsigned int uint32_t;
typedef long long int64_t; typedef unsigned long long uint64_t;
#define UINT32_C(x) x##u
#define INT64_C(x) x##ll
"""
_STDDEF = "typedef unsigned long size_t;\n#define NULL 0\n"


def _preprocess(folders: list[Path], headers: list[str], macros: list[str]) -> str:
    """All headers, and an enumerator NAME_value for each macro, so that the parser sees what it stands for."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "stdint.h").write_text(_STDINT)
        (Path(folder) / "stddef.h").write_text(_STDDEF)
        source = "".join(f"#include <haptic_retargeting/{name}>\n" for name in headers)
        source += "enum { " + ", ".join(f"{name}_value = {name}" for name in macros) + " };\n"
        command = ["cpp", "-nostdinc", "-D__attribute__(x)=", "-I", folder, *(f"-I{f}" for f in folders), "-"]
        done = subprocess.run(command, input=source, text=True, capture_output=True, check=False)
    if done.returncode != 0:
        raise HeaderError(done.stderr)
    return done.stdout


def _is_values(node: c_ast.Node) -> bool:
    return isinstance(node, c_ast.Decl) and isinstance(node.type, c_ast.Enum)


def _evaluate(node: c_ast.Node) -> tuple[int, bool]:
    if isinstance(node, c_ast.Constant) and "int" in node.type:
        return int(node.value.rstrip("uUlL"), 0), "u" in node.value.lower()
    if isinstance(node, c_ast.UnaryOp) and node.op == "-":
        value, unsigned = _evaluate(node.expr)
        return -value, unsigned
    raise HeaderError(f"{node.coord}: a constant is an integer, or minus one")


def _take(node: c_ast.Node, text: str, abi: Abi) -> None:
    if isinstance(node, c_ast.Decl) and isinstance(node.type, c_ast.FuncDecl):
        abi.functions.append(_function(node.name, node.type, _doc(text, rf"\b{node.name}\(")))
        return
    if not isinstance(node, c_ast.Typedef):
        raise HeaderError(f"{node.coord}: neither a typedef nor a function")
    doc = _doc(text, rf"\btypedef [^;{{]*\b{node.name}\b")
    if isinstance(node.type, c_ast.PtrDecl) and isinstance(node.type.type, c_ast.FuncDecl):
        abi.callbacks.append(_function(node.name, node.type.type, doc))
    elif isinstance(node.type, c_ast.TypeDecl) and isinstance(node.type.type, c_ast.Struct):
        abi.structs.append(_struct(node.name, node.type.type, text, doc, abi))
    elif node.name == "hrt_result":
        abi.result_doc = doc
    else:
        raise HeaderError(f"{node.coord}: {node.name} is neither a struct nor a callback")


def _struct(name: str, node: c_ast.Struct, text: str, doc: str, abi: Abi) -> Struct:
    body = text[text.index(f"typedef struct {name} {{") :]
    fields: list[Field] = []
    for decl in node.decls:
        field_doc = _doc(body, rf"\b{decl.name}\b[^;]*;")
        type_, length = decl.type, 0
        if isinstance(type_, c_ast.ArrayDecl):
            type_, length = type_.type, _evaluate(type_.dim)[0]
        if isinstance(type_, c_ast.PtrDecl) and isinstance(type_.type, c_ast.FuncDecl):
            abi.callbacks.append(_function(f"{name}_{decl.name}", type_.type, field_doc))
            kind = Type(f"{name}_{decl.name}", callback=True)
        else:
            kind = _type(type_)
        before = fields[-1] if fields and not field_doc and fields[-1].type == kind and not length else None
        fields.append(Field(decl.name, kind, length, field_doc, before.shared_doc if before else field_doc,
                            before.place + 1 if before else 0))
    return Struct(name, tuple(fields), doc)


def _function(name: str, node: c_ast.FuncDecl, doc: str) -> Function:
    declared = [p for p in node.args.params if not (isinstance(p.type, c_ast.TypeDecl) and p.name is None)]
    types = [_type(p.type) for p in declared]
    names = [p.name for p in declared]
    parameters = []
    for i, (parameter, type_) in enumerate(zip(names, types)):
        before, after = names[i - 1] if i > 0 else "", names[i + 1] if i + 1 < len(names) else ""
        counted = before == "capacity" or after in ("length", "count") or after.endswith("_count") and type_.const
        parameters.append(Parameter(parameter, type_, type_.pointer and counted))
    return Function(name, _type(node.type), tuple(parameters), doc)


def _type(node: c_ast.Node) -> Type:
    if isinstance(node, c_ast.PtrDecl):
        if not isinstance(node.type, c_ast.TypeDecl):
            raise HeaderError(f"{node.coord}: a pointer to a pointer or function")
        return Type(_type(node.type).name, pointer=True, const="const" in node.type.quals)
    if isinstance(node, c_ast.TypeDecl) and isinstance(node.type, c_ast.IdentifierType):
        name = " ".join(node.type.names)
        if name == "hrt_result":
            return Type("int32_t")
        return Type(name, callback=name.endswith("_callback"))
    raise HeaderError(f"{node.coord}: a type that bindings have no name for")


_COMMENT = re.compile(r"/\*.*?\*/", re.S)
_DIRECTIVE = re.compile(r"^#(?:\\\n|.)*$", re.M)
_COMMENT_BEFORE = re.compile(r"/\*\*(?!<)((?:[^*]|\*(?!/))*)\*/\s*$")
_DEFINE = re.compile(r"#define (HRT_\w+) ")
_COMMENT_BEHIND = re.compile(r"[^\n]*?(?:\\\n[^\n]*?)?/\*\*<((?:[^*]|\*(?!/))*)\*/")


def _doc(text: str, pattern: str) -> str:
    """The comment before the first declaration with `pattern`."""
    code = text
    for other in (_COMMENT, _DIRECTIVE):
        code = other.sub(lambda found: " " * len(found.group()), code)
    match = re.search(pattern, code)
    if match is None:
        raise HeaderError(f"nothing in the header looks like {pattern}")
    declaration_at = max(code.rfind(end, 0, match.start()) for end in ";{}") + 1
    first_token_at = match.start() - len(code[declaration_at : match.start()].lstrip())
    comment = _COMMENT_BEFORE.search(text[:first_token_at])
    return _plain(comment.group(1)) if comment else ""


def _constant_doc(text: str, at: int) -> tuple[str, str]:
    """What is said of the constant defined at `at`, and of the group that it begins."""
    before = _COMMENT_BEFORE.search(text[:at])
    behind = _COMMENT_BEHIND.match(text[at:])
    if behind:
        return _plain(behind.group(1)), _plain(before.group(1)) if before else ""
    if not before:
        return "", ""
    prefix = prefix_of(_DEFINE.match(text[at:]).group(1))
    next_one = _DEFINE.match(text[text.index("\n", at) + 1 :])
    is_first = prefix not in {prefix_of(name) for name in _DEFINE.findall(text[:at])}
    if is_first and next_one and prefix_of(next_one[1]) == prefix:  # no comment stands between: this one is of all
        return "", _plain(before.group(1))
    earlier = _COMMENT_BEFORE.search(text[: before.start()])
    return _plain(before.group(1)), _plain(earlier.group(1)) if earlier else ""


def _plain(comment: str) -> str:
    return " ".join(re.sub(r"^\s*\*? ?", "", line).strip() for line in comment.strip().splitlines())
