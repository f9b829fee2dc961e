"""Generates the C interface for Blueprints: enums and structs in Unreal's terms, and conversions from and to C.

Unreal uses centimetres, seconds, and clockwise yaw, so that the sign of every `ccw` angle changes.
"""

from __future__ import annotations

import re
import textwrap
from dataclasses import dataclass, replace
from decimal import Decimal

import settings
from abi import HIDDEN, Abi, Enumeration, HostError, Names, Struct, Value, pascal

_STRUCTS = {settings.STRUCT: "FHapticSettings", "hrt_command": "FHapticCommand", "hrt_reach_summary": "FHapticSummary",
            "hrt_gap": "FHapticGap", "hrt_scene_target": "FHapticSceneTarget",
            "hrt_setup_step": "FHapticSetupStep", "hrt_setup_result": "FHapticSetupResult"}
_OUTPUTS = [name for name in _STRUCTS if name != settings.STRUCT]
_TO_CONFIG = "hrt_session_config ToConfig(const FHapticSettings& S, const FTransform& Plate, const hrt_session_config& Before)"
# Enumerations of the component's arguments.
_ENUMERATIONS = ("HRT_TARGET",)
_ACRONYMS = {"MPC"}
_UNITS = {"m": "cm", "deg/s": "degrees a second", "deg/s^2": "degrees a second squared", "ns": "seconds", "s": "seconds"}
_WIDTH = 112


def _without_unit(field: Value) -> str:
    return re.sub("_(deg2|deg_s2?|deg|per_s|ns|s|m)$", "", field.name)


def _words(name: str) -> str:
    return "".join(word if word in _ACRONYMS else pascal(word) for word in name.split("_"))


@dataclass(frozen=True)
class _Member:
    """A field of the C interface, or a flag or part of one, as a member of an Unreal struct."""

    field: Value
    type: str
    name: str
    to: str  # C++ expression of the C field's value; S is the Unreal struct
    taken: str  # C++ expression of the member's value; C is the C struct
    default: str


class _Renderer(Names):
    def __init__(self, abi: Abi) -> None:
        self.abi = abi
        self.enums = {e.name: e for e in abi.enumerations}
        names = {e: f"EHaptic{name}" for e, name in abi.enumeration_names({"HRT_TARGET": "TargetRole"}, "Flags").items()}
        super().__init__(_STRUCTS, names, {c.name: f"{names[e.name]}::{_words(e.short(c))}" for e in abi.enumerations for c in e.members}, {})
        # Flags of the settings are separate bools, which need no enum.
        shown = [f.values for s in _STRUCTS for f in abi.struct(s).fields if s != settings.STRUCT or not self.is_flags(f)]
        self.shown = [e for e in abi.enumerations if e.name in (*shown, *_ENUMERATIONS)]
        self.members = {name: self.members_of(abi.struct(name)) for name in _STRUCTS}
        self.fields = {m.field.name: m.name for members in self.members.values() for m in members if "_" in m.field.name}

    def is_flags(self, field: Value) -> bool:
        return bool(field.values) and self.enums[field.values].flags

    def members_of(self, struct: Struct) -> list[_Member]:
        if struct.name != settings.STRUCT:
            fields = [f for f in struct.fields if f.name not in HIDDEN]
            return [m for f in fields for m in (self.interval(f) if f.type.name == "hrt_interval" else [self.member(f)])]
        members = []
        for f in (f for fields in settings.by_section(self.abi).values() for f in fields):
            if self.is_flags(f):
                members += [self.flag(f, c) for c in self.enums[f.values].members]
            else:
                members.append(self.member(f))
        return members

    def flag(self, field: Value, constant: Value) -> _Member:
        name = self.constants[constant.name] = "b" + _words(self.enums[field.values].short(constant))
        return _Member(replace(field, text=constant.text), "bool", name, f"S.{name} ? {constant.name} : 0u",
                       f"(C.{field.member} & {constant.name}) != 0", "false")

    def member(self, field: Value) -> _Member:
        name, member, of_other = _words(_without_unit(field)), field.member, ""
        if field.ccw:
            name = re.sub("(Direction|Orientation)$", "", name) + "Yaw"
            # The sign changes, so the lower end of a range becomes the upper one.
            member = re.sub("([_.])(lower|upper)_", lambda m: m[1] + {"lower": "upper_", "upper": "lower_"}[m[2]], member)
            of_other = re.sub("Lower|Upper", lambda m: {"Lower": "Upper", "Upper": "Lower"}[m[0]], name)
        elif field.boolean:
            name = "b" + name
        type_, to, taken, default = self.conversion(field)
        return _Member(field, type_, name, to.format(f"S.{of_other or name}"), taken.format(f"C.{member}"), default)

    def interval(self, field: Value) -> list[_Member]:
        """Returns the members of an interval: of bias_deg, BiasYaw, BiasYawLower, BiasYawUpper and bBiasYawKnown."""
        name = _words(_without_unit(field)) + "Yaw" * field.ccw
        value = "Turned(C.{}.{})" if field.ccw else "C.{}.{}"
        members = [_Member(field, "double", name, "", value.format(field.member, "value"), "0.0")]
        for end, of in (("Lower", "upper"), ("Upper", "lower")) if field.ccw else (("Lower", "lower"), ("Upper", "upper")):
            part = replace(field, name=f"{field.name}_{end.lower()}", text=f"{end} end of its 95 % interval.")
            members.append(_Member(part, "double", name + end, "", value.format(field.member, of), "0.0"))
        part = replace(field, name=f"{field.name}_known", text="True if the data determine the value.")
        return [*members, _Member(part, "bool", f"b{name}Known", "", f"C.{field.member}.known != 0", "false")]

    def conversion(self, field: Value) -> tuple[str, str, str, str]:
        """Returns the type in Unreal, the conversions to and from C, and the default."""
        kind, enum = field.type.name, self.enumerations.get(field.values, "")
        number = _shown(field, field.defaults[0]) if field.defaults and not field.count else Decimal(0)
        if field.values and not self.is_flags(field):
            default = self.constants[field.default or self.enums[field.values].members[0].name]
            return enum, "static_cast<uint32_t>({})", f"static_cast<{enum}>({{}})", default
        if kind == "double" and field.count == 3 and field.unit == "m":
            x, y, z = field.defaults or (Decimal(0),) * 3
            return ("FVector", "ToMetres({})", "FromMetres({})",
                    f"FVector({_literal(-z * 100)}, {_literal(x * 100)}, {_literal(y * 100)})")
        if kind == "char" and field.count:
            return "FString", "", "FString(UTF8_TO_TCHAR({}))", ""
        if field.type.pointer or field.count:
            raise HostError(f"{field.name} is of a type that generator/unreal.py does not support")
        if kind == "hrt_target":
            return "FHapticTarget", "ToTarget({})", "FromTarget({})", ""
        if field.boolean:
            return "bool", "{} ? 1u : 0u", "{} != 0", "false"
        if field.unit == "ns":
            return "double", "ToNanoseconds({})", "static_cast<double>({}) / NanosecondsPerSecond", _literal(number)
        if kind != "double":
            type_ = "int64" if "64" in kind else "int32"
            return type_, f"static_cast<{kind}>({{}})", f"static_cast<{type_}>({{}})", f"{number:f}"
        if field.unit == "m":
            return "double", "{} / CentimetresPerMetre", "{} * CentimetresPerMetre", _literal(number)
        if field.ccw:
            return "double", "Turned({})", "Turned({})", _literal(-number)
        return "double", "{}", "{}", _literal(number)

    def doc(self, text: str, indent: str = "\t") -> str:
        text = self.renamed(text).replace("; y is the height", "; Z is the height").replace("`", "").strip(" .:;")
        if not text:
            return ""
        end = "\N{NO-BREAK SPACE}*/"  # the no-break space keeps */ on the line of the last word
        lines = textwrap.wrap(f"/** {text}.{end}", _WIDTH, subsequent_indent=" *  ", break_on_hyphens=False)
        return "".join(f"{indent}{line}\n" for line in lines).replace(end, " */")

    def enum(self, enumeration: Enumeration) -> str:
        flags = enumeration.flags
        spec = 'meta = (Bitflags, UseEnumValuesAsMaskValuesInEditor = "true")' if flags else "BlueprintType"
        text = self.doc(enumeration.text, "") + f"UENUM({spec})\n"
        text += f"enum class {self.enumerations[enumeration.name]} : {'int32' if flags else 'uint8'}\n{{\n"
        # Unreal requires that an enum has a value 0.
        rows = [] if any(m.value == 0 for m in enumeration.members) else ["\tNone = 0 UMETA(Hidden)"]
        rows += [self.doc(m.text) + f"\t{_words(enumeration.short(m))} = {m.value}" for m in enumeration.members]
        return text + ",\n".join(rows) + "\n};\n"

    def comment(self, member: _Member) -> str:
        """Returns the member's comment, without the range, which Unreal shows in its own format and unit."""
        text = member.field.text
        if member.field.boolean:
            text = re.sub("^1 if ", "True if ", re.sub("^0 if ", "False if ", text))
        if member.field.ccw:
            text = text.replace("counter-clockwise", "clockwise")
        unit = _UNITS.get(member.field.unit) if member.type in ("double", "FVector") else None
        return self.doc(f"{text} In {unit}." if unit else text)

    def property(self, struct: str, member: _Member) -> str:
        head, meta = 'BlueprintReadOnly, Category = "Haptic Retargeting"', ""
        if struct == settings.STRUCT:
            head, meta = f'EditAnywhere, BlueprintReadWrite, Category = "{settings.section(member.field)}"', self.meta(member)
        elif self.is_flags(member.field):
            meta = f'Bitmask, BitmaskEnum = "/Script/HapticRetargeting.{self.enumerations[member.field.values]}"'
        head += f", meta = ({meta})" * bool(meta)
        default = f" = {member.default}" if member.default else ""
        return f"\n{self.comment(member)}\tUPROPERTY({head})\n\t{member.type} {member.name}{default};\n"

    def meta(self, member: _Member) -> str:
        field = member.field
        units = {"m": "cm", "ns": "s", "s": "s", "deg": "deg"}.get(field.unit)
        items = [f'Units = "{units}"'] if units and member.type == "double" else []
        if field.bounded and member.type in ("double", "int32"):
            ends = sorted((-1 if field.ccw else 1) * _shown(field, n) for n in (field.lowest, field.max))
            items += [f'ClampMin = "{ends[0].normalize():f}"', f'ClampMax = "{ends[1].normalize():f}"']
        return ", ".join(items)

    def struct(self, name: str) -> str:
        doc = {settings.STRUCT: "Assumptions of a session about user, plate and tracker."}.get(name, self.abi.struct(name).text)
        return (self.doc(doc, "") + f"USTRUCT(BlueprintType)\nstruct {_STRUCTS[name]}\n{{\n\tGENERATED_BODY()\n"
                + "".join(self.property(name, m) for m in self.members[name]) + "};\n")

    def from_(self, name: str, storage: str = "") -> str:
        short = _STRUCTS[name].removeprefix("FHaptic")
        return (f"\t{storage}{_STRUCTS[name]} From{short}(const {name}& C)\n\t{{\n\t\t{_STRUCTS[name]} Result;\n"
                + "".join(f"\t\tResult.{m.name} = {m.taken};\n" for m in self.members[name])
                + "\t\treturn Result;\n\t}\n")

    def to_config(self) -> str:
        members: dict[str, list[_Member]] = {}
        for m in self.members[settings.STRUCT]:
            members.setdefault(m.field.member, []).append(m)
        text = "".join(f"\t\tToMetres(S.{of[0].name}, Config.{field});\n" if of[0].type == "FVector" else
                       f"\t\tConfig.{field} = {of[0].to if len(of) == 1 else ' | '.join(f'({m.to})' for m in of)};\n"
                       for field, of in members.items())
        return (f"\t{_TO_CONFIG}\n\t{{\n\t\thrt_session_config Config = hrt_session_config_init();\n{text}"
                "\t\tToMetres(Plate.GetLocation(), Config.plate.position_m);\n"
                "\t\tToQuaternion(Plate.GetRotation(), Config.plate.rotation);\n"
                + "".join(f"\t\tstd::memcpy(Config.{f.member}, Before.{f.member}, sizeof Config.{f.member});\n"
                          for f in settings.hidden(self.abi)) + "\t\treturn Config;\n\t}\n")

    def take_changes(self) -> str:
        return ("\ttemplate <typename T>\n\tstatic void Take(const T& Old, const T& New, T& Into)\n\t{\n"
                "\t\tif (std::memcmp(&Old, &New, sizeof New) != 0)\n\t\t{\n\t\t\tInto = New;\n\t\t}\n\t}\n\n"
                "\tvoid TakeChanges(const hrt_session_config& Before, const hrt_session_config& C, FHapticSettings& S)\n"
                "\t{\n\t\tconst FHapticSettings Old = FromSettings(Before), New = FromSettings(C);\n"
                + "".join(f"\t\tTake(Old.{m.name}, New.{m.name}, S.{m.name});\n" for m in self.members[settings.STRUCT]) + "\t}\n")


def _shown(field: Value, number: Decimal) -> Decimal:
    return {"m": number * 100, "ns": number / 1_000_000_000}.get(field.unit, number)


def _literal(number: Decimal) -> str:
    text = f"{number.normalize() + 0:f}"
    return text if "." in text else text + ".0"


def render_types(abi: Abi, notice: str) -> str:
    r = _Renderer(abi)
    target = ("/** Id of a target of one component. */\nUSTRUCT(BlueprintType)\nstruct FHapticTarget\n{\n\tGENERATED_BODY()\n\n"
              '\tUPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")\n\tint64 Id = 0;\n};\n')
    return (f"// {notice}\n//\n"
            "// Types of the plugin for Blueprints, in Unreal's terms: centimetres, seconds, and yaw, which is\n"
            "// positive to the right (clockwise seen from above); the C interface has metres, nanoseconds, and directions\n"
            "// that are positive to the left. Directions are measured from the plate's mid-line, its X axis, straight away\n"
            "// from the user.\n#pragma once\n\n"
            '#include "CoreMinimal.h"\n#include "HapticRetargetingTypes.generated.h"\n\n'
            + "\n".join([r.enum(e) for e in r.shown] + [target] + [r.struct(name) for name in _STRUCTS]))


def render_header(abi: Abi, notice: str) -> str:
    headers = sorted({abi.struct(name).header for name in _STRUCTS})
    return (f"// {notice}\n#pragma once\n\n"
            '#include "HapticRetargetingTypes.h"\n' + "".join(f'#include "haptic_retargeting/{header}"\n' for header in headers)
            + "\nnamespace HapticConversions\n{\n"
            f"\t/** Returns the settings as a configuration. Fields that FHapticSettings lacks are from `Plate` and `Before`. */\n\t{_TO_CONFIG};\n"
            "\t/** Copies into S the fields of C that differ from those of Before. */\n"
            "\tvoid TakeChanges(const hrt_session_config& Before, const hrt_session_config& C, FHapticSettings& S);\n"
            + "".join(f"\t{_STRUCTS[n]} From{_STRUCTS[n].removeprefix('FHaptic')}(const {n}& C);\n" for n in _OUTPUTS) + "}\n")


def render_conversions(abi: Abi, notice: str) -> str:
    r = _Renderer(abi)
    return (f"// {notice}\n#include \"HapticStructs.h\"\n\n#include <cstring>\n\n#include \"HapticConversions.h\"\n\n"
            "namespace HapticConversions\n{\n"
            + "\n".join([r.to_config(), r.from_(settings.STRUCT, "static "), r.take_changes()]
                        + [r.from_(name) for name in _OUTPUTS]) + "}\n")
