"""Reads the C headers, which keep to few forms of C: comments, #define of whole numbers, typedef of structs and callbacks,
functions; those inline are for C and C++ alone. `generate --check` compares the model with what a compiler sees."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from pathlib import Path

from abi import SIZES, Abi, Constant, Field, Function, HeaderError, Parameter, Struct, Type, prefix_of

# Parts of a struct whose fields keep their names where its parts are not shown. Others get the part's name before theirs.
_PLAIN_PARTS = ("paper", "counts", "learnt")
_PLAIN_FIELDS = ("contact_correction", "contact_covariance")
# Headers that are written from the others.
WRITTEN = ("init.h", "setup_init.h", "study_init.h", "functions.h")

_INSIDE = r"(?:[^*]|\*(?!/))*"
_NUMBER = r"(?:UINT32_C\((?P<macro>\w+)\)|\(?(?P<plain>-?\d\w*)\)?|\((?P<sum>HRT_\w+(?:[ ][*+][ ]\w+)+)\))"
_ITEM = re.compile(rf"""
    /\*\*(?!<)(?P<doc>{_INSIDE})\*/
  | /\*{_INSIDE}\*/
  | \#define[ ]+(?P<constant>HRT_\w+)[ ]+(?:\\\n\s*)?{_NUMBER}(?:[ ]*\\\n)?(?:[ ]*/\*\*<(?P<behind>{_INSIDE})\*/)?[ ]*(?=\n)
  | \#include[ ]"(?P<include>[\w./]+)"
  | \#(?:\\\n|[^\n])*
  | extern[ ]"C"[ ]\{{ | \}}
  | static[ ]inline[ ].*?\n\}}
  | typedef[ ]struct[ ](?P<struct>\w+)[ ]\{{\n(?P<fields>.*?)\n\}}[ ](?P=struct);
  | typedef[ ]int32_t[ ]hrt_result;(?P<result>)
  | typedef[ ](?P<callback_result>[\w ]+\*?)[ ]?\(\*(?P<callback>\w+)\)\((?P<callback_parameters>[^)]*)\);
  | (?:HRT_NODISCARD[ ])?HRT_(?:PLATE_)?API[ ](?P<function_result>[\w ]+?\*?)\s(?P<function>\w+)\((?P<parameters>[^)]*)\)\s*HRT_NOEXCEPT;
""", re.X | re.S)
_FIELD = re.compile(rf"""
    /\*\*(?P<doc>{_INSIDE})\*/
  | (?P<type>\w+)[ ](?P<name>\w+)(?:\[(?P<length>\w+)\])?;
  | (?P<result>[\w ]+\*?)[ ]?\(\*(?P<callback>\w+)\)\((?P<parameters>[^)]*)\);
  | (?P<pointer>\w+)\*[ ](?P<pointed>\w+);
""", re.X | re.S)


def read(include: Path, plate: bool = False) -> Abi:
    """The interface that `include`/haptic_retargeting/*.h declare: of the plugin, or of the library that drives the plate."""
    folder = include / "haptic_retargeting"
    names = sorted(p.name for p in folder.glob("*.h") if p.name not in (*WRITTEN, "haptic_retargeting.h")
                   and (p.name == "plate.h") == plate)
    if not names:
        raise HeaderError(f"no headers in {folder}")
    reader = _Reader(folder, names)
    for name in names:
        reader.read(name)
    reader.name_fields()
    for struct in reader.abi.structs:
        for f in struct.fields if reader.is_filled(struct) else ():
            f.check(struct.name, struct.has_default)
    _check_types(reader.abi)
    return reader.abi


class _Reader:
    def __init__(self, folder: Path, names: list[str]) -> None:
        self.folder, self.names, self.seen = folder, names, set[str]()
        self.abi = Abi(headers=names)
        self.parts: dict[str, Struct] = {}  # structs whose comment begins with "Part of "; hosts see their fields in the whole

    def read(self, name: str) -> None:
        """A header after those that it includes."""
        if name in self.seen or name not in self.names:
            return
        self.seen.add(name)
        text = (self.folder / name).read_text(encoding="utf-8")
        prefixes: set[str] = set()
        docs: list[str] = []  # the comments that stand directly before
        for found in _items(_ITEM, text, name):
            if found["include"]:
                self.read(found["include"])
            elif found["constant"]:
                self.abi.constants.append(self.constant(found, docs, prefixes))
            elif found["struct"]:
                self.struct(found["struct"], found["fields"], docs[-1] if docs else "", name)
            elif found["result"] is not None:
                self.abi.result_doc = docs[-1] if docs else ""
            elif found["callback"]:
                self.abi.callbacks.append(_function(found["callback"], found["callback_result"], found["callback_parameters"], docs))
            elif found["function"]:
                self.abi.functions.append(_function(found["function"], found["function_result"], found["parameters"], docs))
            docs = docs + [_plain(found["doc"])] if found["doc"] is not None else []

    def struct(self, name: str, body: str, doc: str, header: str) -> None:
        fields: list[Field] = []
        docs: list[str] = []
        for found in _items(_FIELD, body, f"{header}, {name}"):
            if found["doc"] is not None:
                docs.append(_plain(found["doc"]))
                continue
            own, length = docs[-1] if docs else "", self.number(found["length"])
            if found["callback"]:
                called = f"{name}_{found['callback']}"
                self.abi.callbacks.append(_function(called, found["result"], found["parameters"], docs))
                kind = Type(called, callback=True)
            else:
                kind = Type(found["pointer"], pointer=True) if found["pointer"] else Type(found["type"])
            before = fields[-1] if fields and not own and fields[-1].type == kind and not length else None
            fields.append(Field(found["name"] or found["callback"] or found["pointed"], kind, length, own,
                                before.shared_doc if before else own, before.place + 1 if before else 0))
            docs = []
        struct = Struct(name, tuple(g for f in fields for g in self.flat(f)), doc, header)
        if doc.startswith("Part of "):
            self.parts[name] = struct
        else:
            self.abi.structs.append(struct)

    def flat(self, field: Field) -> list[Field]:
        """The field, or those of the part that it is."""
        part = self.parts.get(field.type.name)
        if part is None:
            return [field]
        return [replace(f, name=_flat_name(field.name, f.name), path=(field.name, f.name)) for f in part.fields]

    def name_fields(self) -> None:
        """In comments, as hosts see them: plate.max_speed_deg_s is plate_max_speed_deg_s."""
        names = {f.member: f.name for s in self.abi.structs for f in s.fields if f.path}
        if not names:
            return
        form = re.compile(rf"\b(?:{'|'.join(map(re.escape, names))})\b")

        def named(item):
            texts = {key: form.sub(lambda found: names[found[0]], getattr(item, key)) for key in ("doc", "shared_doc", "group")
                     if hasattr(item, key)}
            return replace(item, **texts, **({"fields": tuple(map(named, item.fields))} if isinstance(item, Struct) else {}))

        abi = self.abi
        for items in (abi.constants, abi.structs, abi.callbacks, abi.functions):
            items[:] = map(named, items)

    def constant(self, found: re.Match[str], docs: list[str], prefixes: set[str]) -> Constant:
        """With what is said of it, and of the group that it begins."""
        if found["sum"]:
            value = sum(math.prod(map(self.number, term.split(" * "))) for term in found["sum"].split(" + "))
        else:
            value = int((found["macro"] or found["plain"]).rstrip("u"), 0)
        prefix = prefix_of(found["constant"])
        unsigned = found["macro"] is not None or (found["plain"] or "").endswith("u")
        doc, group = docs[-1] if docs else "", docs[-2] if len(docs) > 1 else ""
        if found["behind"] is not None:
            doc, group = _plain(found["behind"]), doc
        elif len(docs) == 1 and prefix not in prefixes and re.match(rf"\n#define {prefix}", found.string[found.end():]):
            doc, group = "", doc  # no comment stands between: this one is of all
        prefixes.add(prefix)
        return Constant(found["constant"], value, unsigned, doc, group)

    def number(self, written: str | None) -> int:
        if not written or written.isdigit():
            return int(written or 0)
        return next(c.value for c in self.abi.constants if c.name == written)

    def is_filled(self, struct: Struct) -> bool:
        """Whether hosts fill it in, so that every field needs a range; where a call gives defaults, a default too."""
        given = any(p.type == Type(struct.name, pointer=True, const=True) for f in self.abi.functions for p in f.parameters)
        return given and not struct.is_handle and "Set `struct_size` before the call" not in struct.doc


def _flat_name(part: str, name: str) -> str:
    whole = name if part in _PLAIN_PARTS or name in _PLAIN_FIELDS else f"{part}_{name}"
    return whole.replace("registration_max_", "max_registration_")


def _items(pattern: re.Pattern[str], text: str, where: str):
    at = 0
    while text[at:].strip():
        at += len(text[at:]) - len(text[at:].lstrip())
        found = pattern.match(text, at)
        if found is None:
            raise HeaderError(f"{where}: no form of C that generator/headers.py reads: {text[at:].splitlines()[0]}")
        if re.match(r"#define HRT_\w+\s+(\\\n\s*)?[-(\dU]", found.group()) and not found["constant"]:
            raise HeaderError(f"{where}: no form of a constant that generator/headers.py reads: {found.group()}")
        yield found
        at = found.end()


def _function(name: str, result: str, parameters: str, docs: list[str]) -> Function:
    declared = [] if parameters == "void" else [_declared(p) for p in parameters.split(",")]
    names = [parameter for _, parameter in declared]
    read = []
    for i, (type_, parameter) in enumerate(declared):
        before, after = names[i - 1] if i > 0 else "", names[i + 1] if i + 1 < len(names) else ""
        counted = before == "capacity" or after in ("length", "count") or after.endswith("_count") and type_.const
        read.append(Parameter(parameter, type_, type_.pointer and counted))
    return Function(name, _declared(f"{result} it")[0], tuple(read), docs[-1] if docs else "")


def _declared(text: str) -> tuple[Type, str]:
    found = re.fullmatch(r"(const )?(\w+)(\*)? (\w+)", " ".join(text.split()))
    if found is None:
        raise HeaderError(f"a type that bindings have no name for: {' '.join(text.split())}")
    name = "int32_t" if found[2] == "hrt_result" else found[2]
    return Type(name, found[3] is not None, found[1] is not None, name.endswith("_callback")), found[4]


def _check_types(abi: Abi) -> None:
    known = {*SIZES, "size_t", *(s.name for s in abi.structs), *(c.name for c in abi.callbacks)}
    used = [(f"{s.name}::{f.name}", f.type) for s in abi.structs for f in s.fields]
    used += [(f"{f.name}({p.name})", p.type) for f in abi.functions + abi.callbacks for p in f.parameters]
    for place, type_ in used:
        if type_.name not in known and not (type_.pointer and type_.name == "void"):
            raise HeaderError(f"{place}: {type_.name} is none of the types that every host has: {', '.join(SIZES)}")


def _plain(comment: str) -> str:
    return " ".join(re.sub(r"^\s*\*? ?|\s*\\$", "", line).strip() for line in comment.strip().splitlines())
