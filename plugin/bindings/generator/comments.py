"""What the comment of a field says of it in the house's order: meaning; range, unit; default."""

from __future__ import annotations

import re
from dataclasses import dataclass
from decimal import Decimal

_NUMBER = r"-?\d+(?:\.\d+)?(?:e-?\d+)?"
_UNITS = {"ms": Decimal(1_000_000), "s": Decimal(1_000_000_000)}  # of a field in nanoseconds
_RANGE = re.compile(rf"(?:^|[.,] )({_NUMBER})( ms| s)? to ({_NUMBER})( ms| s)?(?![\d\w])")
_DEFAULT = re.compile(rf"\bDefault (?:(HRT_\w+)|\(([^)]*)\)|({_NUMBER})( ms| s)?(?: and ({_NUMBER}))?)")
_ZERO_TOO = re.compile(r"; (?:both )?0: ")


@dataclass(frozen=True)
class Numbers:
    """Of a field, in its own unit. `default` has a number for each element, or is a constant's name."""

    lower: Decimal | None = None
    upper: Decimal | None = None
    default: tuple[Decimal, ...] | str | None = None


def numbers(comment: str, unit: str, place: int) -> Numbers:
    """`unit` is "ns" for times in nanoseconds; `place` is 0, or 1 for the second field that shares the comment."""
    lower = upper = None
    default: tuple[Decimal, ...] | str | None = None
    before, _, _ = comment.partition("Default ")
    found = None
    for found in _RANGE.finditer(before):
        pass
    if found:
        lower = _scaled(found[1], found[2] or found[4], unit)
        upper = _scaled(found[3], found[4], unit)
        if _ZERO_TOO.search(before, found.end()):
            lower, upper = min(lower, Decimal(0)), max(upper, Decimal(0))
    given = _DEFAULT.search(comment)
    if given and given[1]:
        default = given[1]
    elif given and given[2]:
        default = tuple(Decimal(number) for number in given[2].split(","))
    elif given:
        both = (given[3], given[5] or given[3])
        default = (_scaled(both[place], given[4], unit),)
    return Numbers(lower, upper, default)


def _scaled(number: str, written_in: str | None, unit: str) -> Decimal:
    value = Decimal(number)
    return value * _UNITS[written_in.strip()] if written_in and unit == "ns" else value


def without_range(comment: str) -> str:
    """The comment up to its range and default, for a host that shows those in its own way."""
    sentences = re.split(r"(?<=\.) ", comment)
    kept = [s for s in sentences if not re.match(rf"Default |Each within |{_NUMBER}( ms| s)? to ", s)]
    return " ".join(kept)
