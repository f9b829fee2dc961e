"""What the comment of a field says of it in the house's order, each a sentence of its own: meaning; range; default; whether
profiles have it. Its unit is the end of its name."""

from __future__ import annotations

import re
from dataclasses import dataclass
from decimal import Decimal

_NUMBER = r"-?\d+(?:\.\d+)?(?:e-?\d+)?"
_UNITS = {"ms": Decimal(1_000_000), "s": Decimal(1_000_000_000)}  # of a field in nanoseconds
_ZERO = r"(?P<zero>; (?:both )?0: [^.]*)?\."
# The forms of a range.
_RANGES = tuple(re.compile(form) for form in (
    rf"(?P<lower>{_NUMBER})(?: (?P<lower_unit>ms|s))? to (?P<upper>{_NUMBER})(?: (?P<unit>ms|s|1/s|degrees a second(?: squared)?))?"
    rf"(?P<also>, [^;]*?)?{_ZERO}",
    rf"Each within (?P<size>{_NUMBER})(?P<also>, [^.]*)?\.",
    rf"(?P<lower>{_NUMBER}) or more{_ZERO}",
    r"(?P<named>HRT_[A-Z_]+_)\*(?P<also>: [^.]*)?\.",
    r"(?P<unit_length>Length 1 within 0\.001)\.",
    r"UTF-8(?P<also>[ ,][^.]*)?\.",
    r"Any\.",
))
_DEFAULT = re.compile(rf"Default (?:(?P<name>HRT_\w+)|\((?P<each>[^)]*)\)|empty|null|(?P<number>{_NUMBER})(?: (?P<unit>ms|s))?"
                      rf"(?: and (?P<second>{_NUMBER}))?)(?:: [^.]*)?\.")
_PROFILE = re.compile(r"In profiles(?: if (?P<known_by>\w+) is not 0)?\.")


@dataclass(frozen=True)
class Numbers:
    """Of a field, in its own unit. `default` has a number for each element, or is a constant's name."""

    has_range: bool = False
    lower: Decimal | None = None
    upper: Decimal | None = None
    zero: bool = False  # 0 is allowed too, below `lower`
    unit_length: bool = False
    has_default: bool = False
    default: tuple[Decimal, ...] | str | None = None
    in_profiles: bool = False
    known_by: str = ""  # the field that is not 0 if profiles have this one

    @property
    def lowest(self) -> Decimal | None:
        return min(self.lower, Decimal(0)) if self.zero and self.lower is not None else self.lower


def numbers(comment: str, unit: str, place: int) -> Numbers:
    """`unit` is "ns" for times in nanoseconds; `place` is 0, or 1 for the second field that shares the comment."""
    sentences = re.split(r"(?<=\.) ", comment)
    profile = _taken(sentences, _PROFILE)
    given = _taken(sentences, _DEFAULT)
    found = _taken(sentences, *_RANGES)
    parts = found.groupdict() if found else {}
    lower = upper = None
    if parts.get("size"):
        upper = Decimal(parts["size"])
        lower = -upper
    elif parts.get("lower"):
        lower = _scaled(parts["lower"], parts.get("lower_unit") or parts.get("unit"), unit)
        upper = _scaled(parts["upper"], parts["unit"], unit) if parts.get("upper") else None
    zero = bool(parts.get("zero")) and lower is not None and lower > 0
    return Numbers(found is not None, lower, upper, zero, bool(parts.get("unit_length")), given is not None,
                   _default(given, unit, place) if given else None,
                   profile is not None, profile["known_by"] or "" if profile else "")


def _taken(sentences: list[str], *forms: re.Pattern[str]) -> re.Match[str] | None:
    """The last sentence, if it has one of the forms."""
    for form in forms:
        if sentences and (found := form.fullmatch(sentences[-1])):
            sentences.pop()
            return found
    return None


def _default(given: re.Match[str], unit: str, place: int) -> tuple[Decimal, ...] | str | None:
    if given["name"]:
        return given["name"]
    if given["each"]:
        return tuple(Decimal(number) for number in given["each"].split(","))
    if given["number"] is None:
        return None
    return (_scaled((given["number"], given["second"] or given["number"])[place], given["unit"], unit),)


def _scaled(number: str, written_in: str | None, unit: str) -> Decimal:
    return Decimal(number) * (_UNITS.get(written_in or "", 1) if unit == "ns" else 1)


def without_range(comment: str) -> str:
    """The comment up to its range and default, for a host that shows those in its own way."""
    sentences = re.split(r"(?<=\.) ", comment)
    kept = [s for s in sentences if not re.match(rf"Default |Each within |In profiles|Any\.|{_NUMBER}( ms| s)? (to|or more)\b", s)]
    return " ".join(kept)
