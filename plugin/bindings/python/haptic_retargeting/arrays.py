"""Samples and commands as numpy arrays, in the memory layout of the C structs, so that nothing is copied."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _abi
from ._abi import SampleFlag

SAMPLE = np.dtype(_abi.Sample)
"""One sample of the finger, with the fields of hrt_sample: an array of these is what a reach takes in."""
COMMAND = np.dtype(_abi.Command)
"""One command for the plate, with the fields of hrt_command: an array of these is what comes out."""

Array = NDArray[Any]


def samples(time_ns: ArrayLike, *, direction_deg: ArrayLike | None = None, position_m: ArrayLike | None = None,
            world_position_m: ArrayLike | None = None, plate_orientation_deg: ArrayLike | None = None,
            lifted: ArrayLike | None = None) -> Array:
    """An array of SAMPLE out of columns.

    Args:
        time_ns: when, in the clock of the caller; whole nanoseconds that never go back.
        direction_deg: the direction in which the finger moves, if it is known exactly.
        position_m: or the fingertip in plate coordinates, n x 3 (x right, y up, z towards the user).
        world_position_m: or the fingertip in the engine's world, n x 3.
        plate_orientation_deg: where the plate stands, if it is measured.
        lifted: True where the finger is off the plate.

    A number that is NaN is not known then: a finger without place or direction is a dropout.
    """
    times = np.asarray(time_ns)
    if times.size == 0:
        raise ValueError("time_ns is empty; at least one sample is needed")
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
        where = np.asarray(lifted, bool)
        if where.shape != out.shape and where.ndim != 0:
            raise ValueError(f"lifted must have the shape {out.shape}, as time_ns has, not {where.shape}")
        out["flags"][np.broadcast_to(where, out.shape)] |= np.uint32(SampleFlag.LIFTED)
    return out


def _put(out: Array, field: str, values: ArrayLike | None, flag: SampleFlag) -> None:
    if values is None:
        return
    try:
        given = np.asarray(values, np.float64)
    except (TypeError, ValueError) as error:
        raise TypeError(f"{field} must be numbers: {error}") from None
    column: Array = out[field]
    if given.shape != column.shape and given.ndim != 0:
        raise ValueError(f"{field} must have the shape {column.shape}, as time_ns has, not {given.shape}")
    given = np.broadcast_to(given, column.shape)
    known = ~np.isnan(given.reshape(len(out), -1)).any(axis=1)
    column[known] = given[known]
    out["flags"][known] |= np.uint32(flag)


def commands(n: int) -> Array:
    """An array of n COMMAND to be filled."""
    out = np.zeros(n, COMMAND)
    out["struct_size"] = COMMAND.itemsize
    return out


def expect_rows(array: Array, name: str, dtype: np.dtype[Any]) -> None:
    """Raises unless the library can be given the array's memory."""
    if not isinstance(array, np.ndarray):
        raise TypeError(f"{name} is a {type(array).__name__}: an array is needed, as samples() makes")
    if array.dtype != dtype or array.ndim != 1 or not array.flags.c_contiguous:
        kind = "SAMPLE" if dtype == SAMPLE else "COMMAND"
        raise TypeError(f"{name} must be one contiguous row of haptic_retargeting.{kind}, as {kind.lower()}s() makes")
    if (array["struct_size"] != dtype.itemsize).any():
        raise ValueError(f"{name} must have struct_size {dtype.itemsize} in each row")
