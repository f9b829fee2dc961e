"""Reads recordings as arrays, and replays them."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any, TypeVar, cast

import numpy as np

from . import _abi
from ._abi import COLUMNS, Command, ReachSummary, ReplayReport, Sample, SessionConfig, TargetConfig
from ._library import library, output
from ._struct import Struct
from .arrays import Array
from .record import ReachRecord


@dataclass(frozen=True)
class Recording:
    reaches: list[ReachRecord]
    complete: bool
    """True if the file has its last line and no calls were lost. replay() also checks that nothing was altered."""
    targets: list[TargetConfig]
    """Targets as they were added or changed, in the order of these calls."""


class RecordingError(ValueError):
    """Raised if the file is not a recording of this version, or is malformed. The message names the file and the line;
    for a file that is not UTF-8, only the file."""


def _dtype(kind: type[Struct]) -> np.dtype[np.void]:
    return np.dtype(cast("type[np.void]", kind))


_AIM = ("real_direction_deg", "virtual_direction_deg", "real_distance_m", "start_right_m", "start_away_m")
_TEXTS = ("call", "setup")
_KINDS: tuple[type[Struct], ...] = (Sample, Command, ReachSummary)
_STRUCTS = {kind: COLUMNS[kind.__name__] for kind in _KINDS}
_DTYPES = {"result": np.dtype(np.int32)} | {
    column: _dtype(kind)[name] for kind, fields in _STRUCTS.items() for name, columns in fields.items() for column in columns}
_WHOLE = {column: dtype for column, dtype in _DTYPES.items() if dtype.kind in "iu"}
_CALLS = ("begin", "update", "retarget", "touched", "cancel", "end")
_NEEDED = (*_TEXTS, *_DTYPES, *_AIM)

_Row = dict[str, Any]
_S = TypeVar("_S", bound=Struct)


@dataclass
class _Rows:
    config: SessionConfig
    begin: _Row
    updates: list[_Row] = field(default_factory=list)
    end: _Row | None = None
    over: bool = False

    def record(self) -> ReachRecord:
        # The geometry of a reach that starts at the finger is in the first update with a position.
        aimed = next((row for row in self.updates if row.get("real_distance_m") is not None), self.begin)
        start = np.array(self.config.start_position_m)
        start[0], start[2] = aimed["start_right_m"], -aimed["start_away_m"]
        return ReachRecord(
            config=self.config, real_direction_deg=aimed["real_direction_deg"],
            virtual_direction_deg=aimed["virtual_direction_deg"], real_distance_m=aimed["real_distance_m"],
            start_position_m=start, samples=_array(Sample, self.updates, 0), commands=_array(Command, self.updates, np.nan),
            results=np.array([row["result"] for row in self.updates], np.int32),
            summary=ReachSummary.from_buffer_copy(_array(ReachSummary, [self.end], 0).tobytes()) if self.end else None)


def _array(kind: type[Struct], rows: list[_Row], missing: float) -> Array:
    """Converts rows to structs. Values that a row lacks are `missing`; flags are 0 and paper_step is -1."""
    out: Array = np.zeros(len(rows), _dtype(kind))
    out["struct_size"] = out.dtype.itemsize
    for name, columns in _STRUCTS[kind].items():
        default = {"paper_step": -1, "flags": 0}.get(name, missing)
        numbers = np.array([[default if row.get(c) is None else row[c] for c in columns] for row in rows])
        out[name] = numbers.reshape(out[name].shape)
    return out


def read_recording(path: str | os.PathLike[str]) -> Recording:
    """Reads a recording to arrays, without the library. Rows after a gap, where calls were lost, are not read."""
    with open(path, encoding="utf-8", newline="") as file:
        try:
            return _read(file)
        except UnicodeDecodeError as error:
            raise RecordingError(f"{os.fspath(path)} is not text ({error}); pass a recording") from error
        except RecordingError as error:
            raise RecordingError(f"{os.fspath(path)}, {error}") from error


def _read(lines: Iterable[str]) -> Recording:
    reaches: list[_Rows] = []
    targets: list[TargetConfig] = []
    config: SessionConfig | None = None
    header: list[str] = []
    complete = False
    number = 0
    for number, line in enumerate(lines, 1):
        if number == 1 and line.rstrip("\r\n") != "# haptic retargeting recording, version 4":
            raise RecordingError("line 1: not a recording of version 4; pass one, or record again")
        if not line.endswith("\n") or line.startswith("# lost"):
            break  # the line is cut off, or calls are missing
        line = line.rstrip("\r\n")
        try:
            if line.startswith("# end "):
                complete = True
            elif line.startswith("# config "):
                config = _from_json(SessionConfig, line.removeprefix("# config "))
            elif line.startswith(("# target added ", "# target set ")):
                targets.append(_from_json(TargetConfig, line.split(" ", 4)[4]))
            elif not line.startswith("#") and not header:
                header = line.split(",")
                if missing := [column for column in _NEEDED if column not in header]:
                    raise ValueError(f"the column {missing[0]} is missing")
            elif not line.startswith("#"):
                _take(_row(header, line), config, reaches)
        except (ValueError, KeyError, TypeError, IndexError, RecursionError) as error:
            reason = error if isinstance(error, (ValueError, TypeError)) else "the line is malformed"
            raise RecordingError(f"line {number}: {reason}; record again") from error
    if not header:
        raise RecordingError(f"line {max(number, 1)}: the line of column names is missing; record again")
    return Recording([rows.record() for rows in reaches], complete, targets)


def _from_json(kind: type[_S], text: str) -> _S:
    """Returns a struct with the values of a JSON text. Fields that this version does not have are ignored."""
    try:
        values = json.loads(text)
    except json.JSONDecodeError as error:
        raise ValueError(f"the JSON is invalid at its character {error.pos + 1}: {error.msg}") from None
    return kind(**{name: values[name] for name in kind.names() if name in values})


def _row(header: list[str], line: str) -> _Row:
    cells = line.split(",")
    if len(cells) != len(header):
        raise ValueError(f"the row has {len(cells)} columns; {len(header)} are needed")
    return {name: cell if name in _TEXTS else _number(name, cell) for name, cell in zip(header, cells)}


def _number(name: str, cell: str) -> float | None:
    if not cell:
        return None
    try:
        number: float = int(cell) if name in _WHOLE else float(cell)
    except ValueError:
        raise ValueError(f"{name} is {cell!r}, which is not a {'whole ' if name in _WHOLE else ''}number") from None
    if name not in _WHOLE:
        return number
    kind = _WHOLE[name]
    if not np.iinfo(kind).min <= number <= np.iinfo(kind).max:
        raise ValueError(f"{name} is {cell}, which does not fit into {kind.name}")
    return number


def _take(row: _Row, config: SessionConfig | None, reaches: list[_Rows]) -> None:
    if config is None:
        raise ValueError('the line "# config" is missing before this row')
    call, done = row["call"], row["result"] == _abi.OK
    if call.startswith("setup_"):
        return  # a record of reaches has no set-ups
    if call not in _CALLS:
        raise ValueError(f"the row's call is {call!r}; allowed: {', '.join(_CALLS)}, setup_...")
    if call == "begin" and done:
        if missing := [column for column in _AIM if row[column] is None]:
            raise ValueError(f"{missing[0]} is missing")
        reaches.append(_Rows(config, row))
    elif call == "update" and reaches and not reaches[-1].over:
        reaches[-1].updates.append(row)
    elif call in ("cancel", "end") and done and reaches:
        reaches[-1].over = True
        reaches[-1].end = row if call == "end" else None


def replay(path: str | os.PathLike[str]) -> ReplayReport:
    """Repeats the recorded calls and compares the results, bit for bit."""
    return output(ReplayReport, library().hrt_recording_replay, os.fsencode(path), None, 0)
