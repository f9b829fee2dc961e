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
from .arrays import COMMAND, SAMPLE
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


_SAMPLE_COLUMNS = {
    "finger_direction_deg": ("sample_direction_deg",),
    "finger_position_m": ("sample_x_m", "sample_y_m", "sample_z_m"),
    "plate_orientation_deg": ("measured_plate_deg",),
    "plate_position_m": ("plate_x_m", "plate_y_m", "plate_z_m"),
    "plate_rotation": ("plate_qx", "plate_qy", "plate_qz", "plate_qw"),
}
_COMMAND_COLUMNS = tuple(name for name in COMMAND.names or () if name not in ("struct_size", "flags", "step"))
_BEGIN_COLUMNS = ("real_direction_deg", "virtual_direction_deg", "real_distance_m", "start_right_m", "start_away_m")
_INTEGERS: dict[str, type[np.signedinteger[Any] | np.unsignedinteger[Any]]] = {
    "result": np.int32, "time_ns": np.int64, "sample_flags": np.uint32, "command_flags": np.uint32, "step": np.int64}
_TEXTS = ("call", "refused_argument", "setup")
_CALLS = ("begin", "update", "retarget", "touched", "cancel", "end")

_NEEDED_COLUMNS = (*_TEXTS, *_INTEGERS, *sum(_SAMPLE_COLUMNS.values(), ()), *_BEGIN_COLUMNS)

_Row = dict[str, Any]
_S = TypeVar("_S", bound=Struct)


@dataclass
class _Rows:
    """The rows of one reach."""

    config: SessionConfig
    begin: _Row
    updates: list[_Row] = field(default_factory=list)
    ended: bool = False
    final_direction_deg: float = np.nan

    def record(self) -> ReachRecord:
        n = len(self.updates)
        samples, commands = np.zeros(n, SAMPLE), np.zeros(n, COMMAND)
        samples["struct_size"], commands["struct_size"] = SAMPLE.itemsize, COMMAND.itemsize
        samples["time_ns"] = self._column("time_ns", 0)
        samples["flags"] = self._column("sample_flags", 0)
        for name, columns in _SAMPLE_COLUMNS.items():
            numbers = np.array([self._column(column, 0.0) for column in columns]).T
            samples[name] = numbers if len(columns) > 1 else numbers[:, 0]
        commands["flags"] = self._column("command_flags", 0)
        commands["step"] = self._column("step", -1)
        for name in _COMMAND_COLUMNS:
            commands[name] = self._column(name, np.nan)
        # A reach that starts where the finger is first seen is aimed there.
        aimed = next((row for row in self.updates if row.get("real_distance_m") is not None), self.begin)
        start = np.array(self.config.start_position_m)
        start[0], start[2] = aimed["start_right_m"], -aimed["start_away_m"]
        return ReachRecord(
            config=self.config, real_direction_deg=aimed["real_direction_deg"],
            virtual_direction_deg=aimed["virtual_direction_deg"], real_distance_m=aimed["real_distance_m"],
            start_position_m=start, samples=samples, commands=commands,
            results=np.array(self._column("result", 0), np.int32), final_direction_deg=self.final_direction_deg)

    def _column(self, name: str, missing: float) -> list[float]:
        """`missing` where a row has no value."""
        return [missing if row.get(name) is None else row[name] for row in self.updates]


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
    header: list[str] | None = None
    complete = False
    number = 0
    for number, line in enumerate(lines, 1):
        if number == 1 and line.rstrip("\r\n") != "# haptic retargeting recording, version 4":
            raise RecordingError("line 1: not a recording of version 4")
        if not line.endswith("\n"):
            break  # cut off within the line
        line = line.rstrip("\r\n")
        try:
            if line.startswith("# lost"):
                break
            if line.startswith("# end "):
                complete = True
            elif line.startswith("# config "):
                config = _from_json(SessionConfig, line.removeprefix("# config "))
            elif line.startswith(("# target added ", "# target set ")):
                targets.append(_from_json(TargetConfig, line.split(" ", 4)[4]))
            elif line.startswith("#"):
                continue
            elif header is None:
                header = _header(line)
            else:
                _take(_row(header, line), config, reaches)
        except (ValueError, KeyError, TypeError, IndexError, RecursionError) as error:
            raise RecordingError(f"line {number}: {error}") from error
    if header is None:
        raise RecordingError(f"line {number}: the line of column names is missing")
    return Recording([rows.record() for rows in reaches], complete, targets)


def _from_json(kind: type[_S], text: str) -> _S:
    """A struct with the values of the text; what only newer structs have is left out."""
    values = json.loads(text)
    return kind(**{name: values[name] for name in kind.names() if name in values})


def _header(line: str) -> list[str]:
    names = line.split(",")
    for column in _NEEDED_COLUMNS:
        if column not in names:
            raise ValueError(f"the column {column} is missing")
    return names


def _row(header: list[str], line: str) -> _Row:
    cells = line.split(",")
    if len(cells) != len(header):
        raise ValueError(f"the row has {len(cells)} columns; {len(header)} are needed")
    return {name: cell if name in _TEXTS else _number(name, cell) for name, cell in zip(header, cells)}


def _number(name: str, cell: str) -> float | None:
    if not cell:
        return None
    kind = _INTEGERS.get(name)
    if kind is None:
        return float(cell)
    number = int(cell)
    if not np.iinfo(kind).min <= number <= np.iinfo(kind).max:
        raise ValueError(f"{name} is {cell}, which is beyond {kind.__name__}")
    return number


def _take(row: _Row, config: SessionConfig | None, reaches: list[_Rows]) -> None:
    if config is None:
        raise ValueError("a row before the configuration")
    if str(row["call"]).startswith("setup_"):
        return  # replay() repeats them
    if row["call"] not in _CALLS:
        raise ValueError(f"the row's call is {row['call']!r}; allowed: {', '.join(_CALLS)}")
    if row["call"] == "begin" and row["result"] == _abi.OK:
        for column in _BEGIN_COLUMNS:
            if row[column] is None:
                raise ValueError(f"{column} is missing")
        reaches.append(_Rows(config, row))
    elif row["call"] == "update" and not row["refused_argument"] and reaches and not reaches[-1].ended:
        reaches[-1].updates.append(row)
    elif row["call"] == "cancel" and row["result"] == _abi.OK and reaches:
        reaches[-1].ended = True
    elif row["call"] == "end" and row["result"] == _abi.OK and reaches:
        reaches[-1].ended = True
        direction_deg = row.get("finger_direction_deg")
        reaches[-1].final_direction_deg = np.nan if direction_deg is None else direction_deg


def replay(path: str | os.PathLike[str]) -> ReplayReport:
    """Runs the recorded calls again and compares what comes out, bit for bit."""
    return output(ReplayReport, library().hrt_replay, os.fsencode(path), None, 0)
