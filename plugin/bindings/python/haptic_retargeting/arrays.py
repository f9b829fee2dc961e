"""Samples and commands as numpy arrays in the memory layout of the C structs, which a reach can use without a copy."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _abi
from ._abi import SampleFlag
from ._struct import numbers_of

SAMPLE = np.dtype(_abi.Sample)
"""Data type of a sample of the finger, with the fields of Sample."""
COMMAND = np.dtype(_abi.Command)
"""Data type of a command for the plate, with the fields of Command."""

Array = NDArray[Any]

_READ_BY = (  # fields that the library reads if a sample has one of the flags
    (SampleFlag.DIRECTION, "finger_direction_deg"), (SampleFlag.PLATE_POSITION | SampleFlag.WORLD_POSITION, "finger_position_m"),
    (SampleFlag.PLATE_ORIENTATION, "plate_orientation_deg"), (SampleFlag.PLATE_POSE, "plate_position_m"),
    (SampleFlag.PLATE_POSE, "plate_rotation"), (SampleFlag.JOINT_ROTATION, "joint_rotation"))
_FINGER = sum(SampleFlag) & ~(SampleFlag.PLATE_ORIENTATION | SampleFlag.LIFTED)


def samples(time_ns: ArrayLike, *, direction_deg: ArrayLike | None = None, position_m: ArrayLike | None = None,
            world_position_m: ArrayLike | None = None, plate_orientation_deg: ArrayLike | None = None,
            lifted: ArrayLike | None = None) -> Array:
    """Makes an array of SAMPLE from columns.

    Args:
        time_ns: time of the caller's clock; whole nanoseconds that never decrease.
        direction_deg: direction in which the finger moves, if it is known exactly.
        position_m: alternatively, the fingertip in plate coordinates, n x 3 (x right, y up, z towards the user).
        world_position_m: alternatively, the fingertip in the engine's world, n x 3.
        plate_orientation_deg: orientation of the plate, if it is measured.
        lifted: True for samples in which the finger is above the plate.

    A number that is NaN or masked is unknown. A sample with neither position nor direction is a dropout, unless lifted.
    """
    times = np.asarray(time_ns)
    if np.any(getattr(time_ns, "mask", False)):
        raise ValueError("time_ns has masked numbers; every sample needs its time")
    if times.ndim != 1 or times.dtype.kind not in "iu":
        raise ValueError(f"time_ns must be one row of whole numbers, not {times.dtype} of the shape {times.shape}")
    out: Array = np.zeros(len(times), SAMPLE)
    out["struct_size"] = SAMPLE.itemsize
    out["time_ns"] = times
    _put(out, "finger_direction_deg", direction_deg, SampleFlag.DIRECTION)
    _put(out, "finger_position_m", position_m, SampleFlag.PLATE_POSITION)
    _put(out, "finger_position_m", world_position_m, SampleFlag.WORLD_POSITION)
    _put(out, "plate_orientation_deg", plate_orientation_deg, SampleFlag.PLATE_ORIENTATION)
    if lifted is not None:
        where = np.asarray(lifted, bool) & ~np.asarray(getattr(lifted, "mask", False))
        if where.shape != out.shape and where.ndim != 0:
            raise ValueError(f"lifted must have the shape {out.shape}, as time_ns has, not {where.shape}")
        out["flags"][np.broadcast_to(where, out.shape)] |= np.uint32(SampleFlag.LIFTED)
    return out


def _put(out: Array, field: str, values: ArrayLike | None, flag: SampleFlag) -> None:
    if values is None:
        return
    try:
        given = numbers_of(values)
    except (TypeError, ValueError) as error:
        raise TypeError(f"{field} must be numbers: {error}") from None
    column: Array = out[field]
    if given.shape != column.shape and given.ndim != 0:
        raise ValueError(f"{field} must have the shape {column.shape}, as time_ns has, not {given.shape}")
    given = np.broadcast_to(given, column.shape)
    known = ~np.isnan(given.reshape(len(out), -1)).any(axis=1)
    column[known] = given[known]
    out["flags"][known] |= np.uint32(flag)


def known(rows: Array) -> Array:
    """Returns the samples without the flags of fields that have NaN. NaN in any of these fields but
    plate_orientation_deg also removes the flags of the finger's position and direction."""
    flags = rows["flags"].copy()
    for flag, field in _READ_BY:
        unknown = ((flags & np.uint32(flag)) != 0) & np.isnan(rows[field].T).any(axis=tuple(range(rows[field].ndim - 1)))
        flags[unknown] &= ~np.uint32(_FINGER if flag & _FINGER else flag)
    if (flags != rows["flags"]).any():
        rows = rows.copy()
        rows["flags"] = flags
    return rows


def known_sample(sample: _abi.Sample) -> _abi.Sample:
    """Does the same as known() for one sample."""
    numbers = np.frombuffer(memoryview(sample), np.float64)[2:]  # without size, flags and time
    if not np.isnan(numbers.dot(numbers)):
        return sample
    return _abi.Sample.from_buffer_copy(known(np.frombuffer(memoryview(sample), SAMPLE)).tobytes())


def commands(n: int) -> Array:
    """Creates an array of n COMMAND to be filled."""
    out = np.zeros(n, COMMAND)
    out["struct_size"] = COMMAND.itemsize
    return out


def expect_rows(array: Array, name: str, dtype: np.dtype[Any]) -> None:
    """Raises TypeError or ValueError unless the array has the memory layout of C structs with their size set."""
    if not isinstance(array, np.ndarray):
        raise TypeError(f"{name} is a {type(array).__name__}: an array is needed, as samples() makes")
    if array.dtype != dtype or array.ndim != 1 or not array.flags.c_contiguous:
        kind = "SAMPLE" if dtype == SAMPLE else "COMMAND"
        raise TypeError(f"{name} must be one contiguous row of haptic_retargeting.{kind}, as {kind.lower()}s() makes")
    if (array["struct_size"] != dtype.itemsize).any():
        raise ValueError(f"{name} must have struct_size {dtype.itemsize} in each row")
