"""Recordings, read as arrays or replayed."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any, TypeVar

import numpy as np

from . import _abi
from ._abi import ReplayReport, SessionConfig, TargetConfig
from ._library import library, output
from ._struct import Struct
from .arrays import COMMAND, SAMPLE, Array
from .record import ReachRecord


@dataclass(frozen=True)
class Recording:
    """A recording, read."""

    reaches: list[ReachRecord]
    complete: bool
    """It has its end, and no calls were lost. replay() checks too that nothing was altered."""
    targets: list[TargetConfig]
    """All that were ever added or changed, in that order."""


class RecordingError(ValueError):
    """A file is not a recording; the text names the line."""


# The columns of each field, in the order of its elements; other fields have columns of their own names.
_SAMPLES = {
    "time_ns": ["time_ns"], "flags": ["sample_flags"], "finger_direction_deg": ["sample_direction_deg"],
    "finger_position_m": ["sample_x_m", "sample_y_m", "sample_z_m"], "plate_orientation_deg": ["measured_plate_deg"],
    "plate_position_m": ["plate_x_m", "plate_y_m", "plate_z_m"], "plate_rotation": ["plate_qx", "plate_qy", "plate_qz", "plate_qw"],
}
_COMMANDS = {name: [name] for name in COMMAND.names or () if name != "struct_size"} | {"flags": ["command_flags"]}
_AIM = ("real_direction_deg", "virtual_direction_deg", "real_distance_m", "start_right_m", "start_away_m")
_TEXTS = ("call", "refused_argument", "setup")
_WHOLE: dict[str, type[np.signedinteger[Any] | np.unsignedinteger[Any]]] = {
    "result": np.int32, "time_ns": np.int64, "sample_flags": np.uint32, "command_flags": np.uint32, "step": np.int64}
_CALLS = ("begin", "update", "retarget", "touched", "cancel", "end")
_NEEDED = (*_TEXTS, *_WHOLE, *sum(_SAMPLES.values(), []), *_AIM)

_Row = dict[str, Any]
_S = TypeVar("_S", bound=Struct)


@dataclass
class _Rows:
    """The rows of one reach."""

    config: SessionConfig
    begin: _Row
    updates: list[_Row] = field(default_factory=list)
    end: _Row | None = None  # or of its cancelling

    def record(self) -> ReachRecord:
        # A reach that starts where the finger is first seen is aimed there.
        aimed = next((row for row in self.updates if row.get("real_distance_m") is not None), self.begin)
        start = np.array(self.config.start_position_m)
        start[0], start[2] = aimed["start_right_m"], -aimed["start_away_m"]
        final_deg = (self.end or {}).get("finger_direction_deg")
        return ReachRecord(
            config=self.config, real_direction_deg=aimed["real_direction_deg"],
            virtual_direction_deg=aimed["virtual_direction_deg"], real_distance_m=aimed["real_distance_m"],
            start_position_m=start, samples=self._array(SAMPLE, _SAMPLES, 0), commands=self._array(COMMAND, _COMMANDS, np.nan),
            results=np.array([row["result"] for row in self.updates], np.int32),
            final_direction_deg=np.nan if final_deg is None else final_deg)

    def _array(self, dtype: np.dtype[Any], fields: dict[str, list[str]], missing: float) -> Array:
        """`missing` where a row has no value; of whole numbers, flags of 0 and step -1."""
        out: Array = np.zeros(len(self.updates), dtype)
        out["struct_size"] = dtype.itemsize
        for name, columns in fields.items():
            default = {"step": -1, "flags": 0}.get(name, missing)
            numbers = np.array([[default if row.get(c) is None else row[c] for c in columns] for row in self.updates])
            out[name] = numbers.reshape(out[name].shape)
        return out


def read_recording(path: str | os.PathLike[str]) -> Recording:
    """Reads a recording to arrays. Needs no library. RecordingError if the file is not one.

    What follows a gap, where calls were lost, is left out.
    """
    with open(path, encoding="utf-8", newline="") as file:
        try:
            return _read(file)
        except UnicodeDecodeError as error:
            raise RecordingError(f"{os.fspath(path)} is not text: {error}") from error
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
            raise RecordingError("line 1: not a recording of version 4")
        if not line.endswith("\n") or line.startswith("# lost"):
            break  # cut off within the line, or calls are missing
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
            raise RecordingError(f"line {number}: {error}") from error
    if not header:
        raise RecordingError(f"line {number}: the line of column names is missing")
    return Recording([rows.record() for rows in reaches], complete, targets)


def _from_json(kind: type[_S], text: str) -> _S:
    """A struct with the values of the text; what only newer structs have is left out."""
    values = json.loads(text)
    return kind(**{name: values[name] for name in kind.names() if name in values})


def _row(header: list[str], line: str) -> _Row:
    cells = line.split(",")
    if len(cells) != len(header):
        raise ValueError(f"the row has {len(cells)} columns; {len(header)} are needed")
    return {name: cell if name in _TEXTS else _number(name, cell) for name, cell in zip(header, cells)}


def _number(name: str, cell: str) -> float | None:
    if not cell:
        return None
    if name not in _WHOLE:
        return float(cell)
    number, kind = int(cell), _WHOLE[name]
    if not np.iinfo(kind).min <= number <= np.iinfo(kind).max:
        raise ValueError(f"{name} is {cell}, which is beyond {kind.__name__}")
    return number


def _take(row: _Row, config: SessionConfig | None, reaches: list[_Rows]) -> None:
    if config is None:
        raise ValueError("a row before the configuration")
    call, done = row["call"], row["result"] == _abi.OK
    if call.startswith("setup_"):
        return  # replay() repeats them
    if call not in _CALLS:
        raise ValueError(f"the row's call is {call!r}; allowed: {', '.join(_CALLS)}")
    if call == "begin" and done:
        if missing := [column for column in _AIM if row[column] is None]:
            raise ValueError(f"{missing[0]} is missing")
        reaches.append(_Rows(config, row))
    elif call == "update" and not row["refused_argument"] and reaches and not reaches[-1].end:
        reaches[-1].updates.append(row)
    elif call in ("cancel", "end") and done and reaches:
        reaches[-1].end = row


def replay(path: str | os.PathLike[str]) -> ReplayReport:
    """Runs the recorded calls again and compares what comes out, bit for bit."""
    return output(ReplayReport, library().hrt_replay, os.fsencode(path), None, 0)
