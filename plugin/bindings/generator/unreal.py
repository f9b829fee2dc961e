"""What Blueprints see of the C interface: enums and structs in Unreal's terms, and the conversions between the two.

Unreal has centimetres, seconds, and yaw, which is positive to the right. The end of a field's name says its unit; of
fields in degrees, a word of its name says whether it is a direction, which becomes a yaw, or a size.
"""

from __future__ import annotations

import re
import textwrap
from dataclasses import dataclass, replace
from decimal import Decimal

import comments
import settings
from abi import Abi, Constant, Enumeration, Field, HeaderError, Struct, pascal

_STRUCTS = {settings.STRUCT: "FHapticSettings", "hrt_command": "FHapticCommand", "hrt_reach_summary": "FHapticSummary",
            "hrt_gap": "FHapticGap", "hrt_scene_target": "FHapticSceneTarget",
            "hrt_setup_step": "FHapticSetupStep", "hrt_setup_result": "FHapticSetupResult"}
# The component's transform has the first; the plugin keeps the others.
_NOT_SHOWN = ("struct_size", "reserved", "plate_rotation", "covariance", "sd_m")
# Arguments of the component.
_ENUMERATIONS = ("HRT_TARGET_",)
_SIZES = {"max", "largest", "bound", "peak", "rms", "sd", "margin", "width", "scale", "distance", "span"}
_DIRECTIONS = {"direction", "orientation", "error", "miss", "bias", "habit", "gap", "stop", "turn", "plate", "fitted", "residual"}
_ACRONYMS = {"MPC"}
_WIDTH = 116


def _words(name: str) -> str:
    return "".join(word if word in _ACRONYMS else pascal(word) for word in name.split("_"))


@dataclass(frozen=True)
class _Member:
    """A field of the C interface as a member of Unreal's struct."""

    field: Field
    type: str
    name: str
    to: str  # the C field's value, with S for the struct of Unreal
    taken: str  # the member's value, with C for the struct of C
    default: str


class _Renderer:
    def __init__(self, abi: Abi) -> None:
        self.abi = abi
        self.enums = {p: f"EHaptic{n}" for p, n in
                      abi.enumeration_names({"HRT_TARGET_": "TargetRole"}, "Flags").items()}
        self.enumerations = {e.prefix: e for e in abi.enumerations}
        # A settings' flag is a bool of its own, so it needs no enum.
        shown = [f.enumeration for s in _STRUCTS for f in abi.struct(s).fields
                 if s != settings.STRUCT or not self.is_flags(f)]
        self.shown = [e for e in abi.enumerations if e.prefix in shown or e.prefix in _ENUMERATIONS]
        self.constants = {c.name: f"{self.enums[e.prefix]}::{_words(e.short(c))}" for e in self.shown for c in e.members}
        self.members = {name: self.members_of(abi.struct(name)) for name in _STRUCTS}
        self.names = {m.field.name: m.name for members in self.members.values() for m in members if "_" in m.field.name}

    def is_flags(self, field: Field) -> bool:
        return bool(field.enumeration) and self.enumerations[field.enumeration].flags

    def is_yaw(self, struct: Struct, field: Field) -> bool:
        words = set(field.name.split("_"))
        if field.unit != "deg" or words & _SIZES:
            return False
        if not words & _DIRECTIONS:
            raise HeaderError(f"{struct.name}::{field.name}: a direction or a size? generator/unreal.py lists the "
                              "words of both")
        return True

    # Members

    def members_of(self, struct: Struct) -> list[_Member]:
        if struct.name != settings.STRUCT:
            fields = [f for f in struct.fields if f.name not in _NOT_SHOWN]
            return [m for f in fields for m in (self.interval(struct, f) if f.type.name == "hrt_interval" else [self.member(struct, f)])]
        members = []
        for f in (f for fields in settings.by_section(self.abi).values() for f in fields):
            if self.is_flags(f):
                members += [self.flag(f, c) for c in self.enumerations[f.enumeration].members]
            else:
                members.append(self.member(struct, f))
        return members

    def flag(self, field: Field, constant: Constant) -> _Member:
        name = "b" + _words(constant.name.removeprefix(field.enumeration))
        return _Member(replace(field, shared_doc=constant.doc), "bool", name, f"S.{name} ? {constant.name} : 0u",
                       f"(C.{field.member} & {constant.name}) != 0", "false")

    def member(self, struct: Struct, field: Field) -> _Member:
        base = field.name.removesuffix("_" + field.unit) if field.unit else field.name
        yaw = self.is_yaw(struct, field)
        name = _words(base)
        if yaw:
            name = re.sub("(Direction|Orientation)$", "", name) + "Yaw"
        elif field.boolean:
            name = "b" + name
        # To mirror is to exchange the ends of a range.
        other = re.sub("([_.])(lower|upper)_", lambda m: m[1] + {"lower": "upper_", "upper": "lower_"}[m[2]], field.member)
        source = other if yaw else field.member
        of_other = re.sub("Lower|Upper", lambda m: {"Lower": "Upper", "Upper": "Lower"}[m[0]], name) if yaw else name
        type_, to, taken = self.conversion(field, yaw)
        return _Member(field, type_, name, to.format(f"S.{of_other}"), taken.format(f"C.{source}"),
                       self.default(field, type_, yaw))

    def interval(self, struct: Struct, field: Field) -> list[_Member]:
        """Value, ends and whether it is known: bias_deg is BiasYaw, BiasYawLower, BiasYawUpper, bBiasYawKnown."""
        yaw = self.is_yaw(struct, field)
        name = _words(field.name.removesuffix("_" + field.unit) if field.unit else field.name) + ("Yaw" if yaw else "")
        ends = ("upper", "lower") if yaw else ("lower", "upper")
        value = "Turned(C.{}.{})" if yaw else "C.{}.{}"

        def member(end: str, part: str, doc: str) -> _Member:
            part_of = replace(field, name=f"{field.name}_{end.lower()}", doc=doc)
            if end == "Known":
                return _Member(part_of, "bool", f"b{name}Known", "", f"C.{field.member}.known != 0", "false")
            return _Member(part_of if end else field, "double", name + end, "", value.format(field.member, part), "0.0")

        return [member("", "value", ""), member("Lower", ends[0], "Lower end of its 95 % interval."),
                member("Upper", ends[1], "Upper end of its 95 % interval."), member("Known", "", "True if the data determine it.")]

    def conversion(self, field: Field, yaw: bool) -> tuple[str, str, str]:
        """The type in Unreal, and how it is converted to C and back."""
        kind, length = field.type.name, field.length
        if field.enumeration:
            if self.is_flags(field):
                return "int32", "static_cast<uint32_t>({})", "static_cast<int32>({})"
            return (self.enums[field.enumeration], "static_cast<uint32_t>({})",
                    f"static_cast<{self.enums[field.enumeration]}>({{}})")
        if field.type.pointer or field.type.callback or length == 3 and field.unit != "m":
            raise HeaderError(f"{field.name} is of a type that generator/unreal.py does not show")
        if (kind, length) == ("double", 3):
            return "FVector", "ToMetres({})", "FromMetres({})"
        if kind == "char" and length:
            return "FString", "", "FString(UTF8_TO_TCHAR({}))"
        if length:
            raise HeaderError(f"{field.name}: an array, which generator/unreal.py does not show")
        if kind == "hrt_target":
            return "FHapticTarget", "ToTarget({})", "FromTarget({})"
        if field.boolean:
            return "bool", "{} ? 1u : 0u", "{} != 0"
        if field.unit == "ns":
            return "double", "ToNanoseconds({})", "static_cast<double>({}) / NanosecondsPerSecond"
        if kind in ("uint32_t", "int32_t"):
            return "int32", f"static_cast<{kind}>({{}})", "static_cast<int32>({})"
        if kind in ("uint64_t", "int64_t"):
            return "int64", f"static_cast<{kind}>({{}})", "static_cast<int64>({})"
        if field.unit == "m":
            return "double", "{} / CentimetresPerMetre", "{} * CentimetresPerMetre"
        return ("double", "Turned({})", "Turned({})") if yaw else ("double", "{}", "{}")

    def default(self, field: Field, type_: str, yaw: bool) -> str:
        given = field.numbers.default
        if isinstance(given, str):
            return self.constants[given]
        if type_.startswith("EHaptic"):
            enumeration = self.enumerations[field.enumeration]
            return f"{type_}::{_words(enumeration.short(enumeration.members[0]))}"
        if type_ == "FVector":
            x, y, z = (given or (Decimal(0),) * 3) if len(given or ()) in (0, 3) else (Decimal(0),) * 3
            return f"FVector({_literal(-z * 100)}, {_literal(x * 100)}, {_literal(y * 100)})"
        if type_ in ("FHapticTarget", "FString"):
            return ""
        number = _shown(field, given[0]) if given else Decimal(0)
        return {"bool": "false", "double": _literal(-number if yaw and number else number)}.get(type_, f"{number:f}")

    # Text

    def doc(self, text: str, indent: str = "\t") -> str:
        text = re.sub(r"\b(hrt_\w+)::(\w+)", lambda m: self.names.get(m[2], _words(m[2])), text)
        text = re.sub(r"\bhrt_\w+\b(?!\()", lambda m: _STRUCTS.get(m[0], m[0]), text)
        text = re.sub(r" \(HRT_[A-Z_]+_\*\)", "", text)
        text = re.sub(r"^HRT_[A-Z_]+_\*, (.)", lambda m: m[1].upper(), text)
        text = re.sub(r"(^| |`)HRT_[A-Z_]+_\*(?:: ?)?", r"\1", text).replace(" (base.h)", "")
        text = text.replace("; y is the height", "; Z is the height")
        text = re.sub(r"\b(?:HRT_)?([A-Z]+_[A-Z0-9_]+)\b", self.constant, text)
        text = re.sub(r"\b[a-z]+(?:_[a-z0-9]+)+\b(?!\()", lambda m: self.names.get(m[0], m[0]), text)
        text = re.sub(r" ?(Named `reserved` before|Since) version [\d.]+\.", "", text).replace("`", "").strip(" .:;")
        if not text:
            return ""
        end = "\N{NO-BREAK SPACE}*/"  # never a line of its own
        lines = textwrap.wrap(f"/** {text}.{end}", _WIDTH - 4, subsequent_indent=" *  ", break_on_hyphens=False)
        return "".join(f"{indent}{line}\n" for line in lines).replace(end, " */")

    def constant(self, found: re.Match[str]) -> str:
        """FIXED_DIRECTION of a comment, with or without what is before it, as it is called here."""
        known = self.constants.get("HRT_" + found[1])
        short = found[0].removeprefix("HRT_SESSION_")
        return known or (short if short.startswith("HRT_") else pascal(short))

    def enum(self, enumeration: Enumeration) -> str:
        flags = enumeration.flags
        spec = 'meta = (Bitflags, UseEnumValuesAsMaskValuesInEditor = "true")' if flags else "BlueprintType"
        text = self.doc(re.sub(r"^hrt_\w+::flags\.", "", enumeration.doc), "") + f"UENUM({spec})\n"
        text += f"enum class {self.enums[enumeration.prefix]} : {'int32' if flags else 'uint8'}\n{{\n"
        # Unreal wants a value for 0.
        rows = [] if any(m.value == 0 for m in enumeration.members) else ["\tNone = 0 UMETA(Hidden)"]
        rows += [self.doc(m.doc) + f"\t{_words(enumeration.short(m))} = {m.value}" for m in enumeration.distinct]
        return text + ",\n".join(rows) + "\n};\n"

    def comment(self, member: _Member) -> str:
        """Without range and default, which Unreal shows in its own way and unit, except where they need words."""
        field = member.field
        if self.is_flags(field) and member.type == "bool":
            return self.doc(field.shared_doc)
        if field.enumeration and not self.is_flags(field):
            return self.doc(self.enumerations[field.enumeration].doc)
        text = comments.without_range(field.shared_doc)
        if field.boolean:
            text = re.sub("^1; or 0: ", "False: ", re.sub(r"^1 if (.*), else 0\b", r"True if \1", text))
            text = re.sub(r"^1 if (.*?); else 0:", r"True if \1; else false:", text)
        if member.name.endswith("Yaw"):
            text = text.replace("left positive", "right positive").replace("counter-clockwise", "clockwise")
        zero = re.search(r"; (both )?(0: [^.;]*)", field.shared_doc)
        if zero and zero[2] not in text:
            text += f" {(zero[1] or '').capitalize()}{zero[2]}."
        unit = {"m": " In cm.", "deg_s": " In degrees a second.", "deg_s2": " In degrees a second squared.",
                "ns": " In seconds.", "s": " In seconds."}.get(field.unit, "")
        return self.doc(text.rstrip(". ") + "." + unit)

    def property(self, struct: str, member: _Member) -> str:
        if struct == settings.STRUCT:
            meta = self.meta(member)
            head = f'EditAnywhere, BlueprintReadWrite, Category = "{settings.section(member.field)}"'
        else:
            bitmask = f'Bitmask, BitmaskEnum = "/Script/HapticRetargeting.{self.enums.get(member.field.enumeration)}"'
            meta = bitmask if self.is_flags(member.field) else ""
            head = 'BlueprintReadOnly, Category = "Haptic Retargeting"'
        line = f"\tUPROPERTY({head}, meta = ({meta}))"
        head += ("" if not meta else f", meta = ({meta})" if len(line) < _WIDTH else f",\n\t\tmeta = ({meta})")
        default = f" = {member.default}" if member.default else ""
        return f"\n{self.comment(member)}\tUPROPERTY({head})\n\t{member.type} {member.name}{default};\n"

    def meta(self, member: _Member) -> str:
        field, numbers = member.field, member.field.numbers
        units = {"m": "cm", "ns": "s", "s": "s", "deg": "deg"}.get(field.unit)
        items = [f'Units = "{units}"'] if units and member.type == "double" else []
        if numbers.lowest is not None and numbers.upper is not None and member.type in ("double", "int32"):
            ends = sorted((-1 if member.name.endswith("Yaw") else 1) * _shown(field, n)
                          for n in (numbers.lowest, numbers.upper))
            items += [f'ClampMin = "{ends[0].normalize():f}"', f'ClampMax = "{ends[1].normalize():f}"']
        return ", ".join(items)

    def struct(self, name: str) -> str:
        doc = {settings.STRUCT: "A session's assumptions of user, plate and tracker."}.get(name, self.abi.struct(name).doc)
        doc = re.sub(r" ?(Set `struct_size` before the call|This struct never grows)\.", "", doc)
        doc = re.sub(r"; the fields are those of hrt_session_config", "", doc)
        return (self.doc(doc, "") + f"USTRUCT(BlueprintType)\nstruct {_STRUCTS[name]}\n{{\n\tGENERATED_BODY()\n"
                + "".join(self.property(name, m) for m in self.members[name]) + "};\n")

    # Conversions

    def from_(self, name: str, storage: str = "") -> str:
        short = _STRUCTS[name].removeprefix("FHaptic")
        return (f"\t{storage}{_STRUCTS[name]} From{short}(const {name}& C)\n\t{{\n\t\t{_STRUCTS[name]} Result;\n"
                + "".join(f"\t\tResult.{m.name} = {m.taken};\n" for m in self.members[name])
                + "\t\treturn Result;\n\t}\n")

    def to_config(self) -> str:
        text, done = "", set()
        for m in self.members[settings.STRUCT]:
            if m.field.name in done:
                continue
            done.add(m.field.name)
            same = [o for o in self.members[settings.STRUCT] if o.field.name == m.field.name]
            if m.type == "FVector":
                text += f"\t\tToMetres(S.{m.name}, Config.{m.field.member});\n"
            else:
                value = m.to if len(same) == 1 else " | ".join(f"({o.to})" for o in same)
                text += f"\t\tConfig.{m.field.member} = {value};\n"
        return ("\thrt_session_config ToConfig(const FHapticSettings& S, const FTransform& Plate, "
                "const hrt_session_config& Before)\n\t{\n"
                "\t\thrt_session_config Config = hrt_session_config_init();\n" + text
                + "\t\tToMetres(Plate.GetLocation(), Config.plate.position_m);\n"
                "\t\tToQuaternion(Plate.GetRotation(), Config.plate.rotation);\n"
                + "".join(f"\t\tstd::memcpy(Config.{f.member}, Before.{f.member}, sizeof Config.{f.member});\n"
                          for f in settings.hidden(self.abi)) + "\t\treturn Config;\n\t}\n")

    def take_changes(self) -> str:
        members = ", ".join(f"&FHapticSettings::{m.name}" for m in self.members[settings.STRUCT])
        return ("\t/** Members that differ between `Before` and `Now` become those of `Now`. */\n"
                "\ttemplate <typename... Members>\n"
                "\tstatic void TakeMembers(const FHapticSettings& Before, const FHapticSettings& Now, FHapticSettings& S,\n"
                "\t\tMembers... Member)\n\t{\n"
                "\t\tconst auto Take = [](const auto& Old, const auto& New, auto& Into)\n\t\t{\n"
                "\t\t\tif (std::memcmp(&Old, &New, sizeof New) != 0)\n\t\t\t{\n\t\t\t\tInto = New;\n\t\t\t}\n\t\t};\n"
                "\t\t(Take(Before.*Member, Now.*Member, S.*Member), ...);\n\t}\n\n"
                "\tvoid TakeChanges(const hrt_session_config& Before, const hrt_session_config& C, FHapticSettings& S)\n"
                "\t{\n\t\tTakeMembers(FromSettings(Before), FromSettings(C), S,\n"
                + textwrap.fill(members + ");", _WIDTH - 8, initial_indent="\t\t\t", subsequent_indent="\t\t\t",
                                expand_tabs=False) + "\n\t}\n")


def _shown(field: Field, number: Decimal) -> Decimal:
    return {"m": number * 100, "ns": number / 1_000_000_000}.get(field.unit, number)


def _literal(number: Decimal) -> str:
    text = f"{number.normalize() + 0:f}"
    return text if "." in text else text + ".0"


def render_types(abi: Abi, notice: str) -> str:
    r = _Renderer(abi)
    target = ("/** Names a target of one component. */\nUSTRUCT(BlueprintType)\nstruct FHapticTarget\n{\n\tGENERATED_BODY()\n\n"
              '\tUPROPERTY(BlueprintReadOnly, Category = "Haptic Retargeting")\n\tint64 Id = 0;\n};\n')
    return (f"// {notice}\n//\n"
            "// What Blueprints see of the plugin. Everything is in Unreal's terms: centimetres, seconds, and yaw, which is\n"
            "// positive to the right (clockwise seen from above); the C interface has metres, nanoseconds, and directions\n"
            "// that are positive to the left. Directions are measured from the plate's mid-line, its X axis, straight away\n"
            "// from the user.\n#pragma once\n\n"
            '#include "CoreMinimal.h"\n#include "HapticRetargetingTypes.generated.h"\n\n'
            + "\n".join([r.enum(e) for e in r.shown] + [target] + [r.struct(name) for name in _STRUCTS]))


def render_header(notice: str) -> str:
    outputs = [name for name in _STRUCTS if name != settings.STRUCT]
    return (f"// {notice}\n#pragma once\n\n"
            '#include "HapticRetargetingTypes.h"\n#include "haptic_retargeting/setup.h"\n\n'
            "namespace HapticConversions\n{\n"
            "\t/** What the settings do not show is as in `Before`. */\n"
            "\thrt_session_config ToConfig(const FHapticSettings& S, const FTransform& Plate, "
            "const hrt_session_config& Before);\n"
            "\t/** Takes what differs from `Before` into the settings; others may have been set and wait. */\n"
            "\tvoid TakeChanges(const hrt_session_config& Before, const hrt_session_config& C, FHapticSettings& S);\n"
            + "".join(f"\t{_STRUCTS[n]} From{_STRUCTS[n].removeprefix('FHaptic')}(const {n}& C);\n" for n in outputs)
            + "}\n")


def render_conversions(abi: Abi, notice: str) -> str:
    r = _Renderer(abi)
    outputs = [name for name in _STRUCTS if name != settings.STRUCT]
    return (f"// {notice}\n#include \"HapticStructs.h\"\n\n#include <cstring>\n\n#include \"HapticConversions.h\"\n\n"
            "namespace HapticConversions\n{\n"
            + "\n".join([r.to_config(), r.from_(settings.STRUCT, "static "), r.take_changes()]
                        + [r.from_(name) for name in outputs]) + "}\n")
