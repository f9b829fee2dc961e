"""Where is the plate? Its pose in the world from touches of marks on it, and whether that is still true.
How late is the tracker?"""

from __future__ import annotations

import ctypes
from ctypes import byref

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _abi
from ._abi import (
    Fingertip, Latency, RegisterFlag, Registration, RegistrationConfig, RegistrationVerdict, TouchCheck,
)
from ._library import library, output
from .arrays import SAMPLE, Array, expect_rows


def register(mark_m: ArrayLike, touched_m: ArrayLike, *, touch_sd_m: float | None = None, fit_scale: bool = False,
             up: ArrayLike | None = None) -> tuple[Registration, NDArray[np.float64]]:
    """Fits the plate's pose to touches of its marks.

        marks = [(0, 0, 0), (0, 0, 0.05), (0.075, 0, 0), (-0.075, 0, 0), (0, 0, -0.075)]
        registration, residuals_m = hrt.register(marks, touched_m, up=(0, 1, 0))
        if registration.verdict != hrt.RegistrationVerdict.HOLDS:
            print(hrt.registration_advice(registration.verdict))
        session.apply_registration(registration, time_ns)

    Args:
        mark_m: the marks in plate coordinates, n x 3 (x right, y up, z towards the user).
        touched_m: where the tracker saw the fingertip on each, n x 3 in the engine's world.
        touch_sd_m: standard deviation of each coordinate of a touch, as expected.
        fit_scale: whether the tracker's unit of length is fitted too.
        up: up in the world; without it a plate upside down is not found.

    Returns the registration and the distance of each touch from its mark.
    """
    marks, touched = (np.asarray(values, np.float64) for values in (mark_m, touched_m))
    if marks.ndim != 2 or marks.shape[1] != 3 or touched.shape != marks.shape:
        raise ValueError(f"mark_m and touched_m must be n x 3 both, not {marks.shape} and {touched.shape}")
    config = RegistrationConfig() if touch_sd_m is None else RegistrationConfig(touch_sd_m=touch_sd_m)
    if fit_scale:
        config.flags |= RegisterFlag.SCALE
    if up is not None:
        config.flags |= RegisterFlag.UP
        config.up = (ctypes.c_double * 3)(*np.asarray(up, np.float64))
    touches = (_abi.MarkTouch * len(marks))(*(_abi.MarkTouch(mark_m=m, touched_m=t) for m, t in zip(marks, touched)))
    residuals = np.zeros(len(marks))
    registration = output(Registration, library().hrt_registration_fit, byref(config), touches, len(marks), len(marks),
                          residuals.ctypes.data_as(ctypes.POINTER(ctypes.c_double)))
    return registration, residuals


def registration_advice(verdict: RegistrationVerdict | int) -> str:
    """What to do about a verdict, in one line for the user."""
    advice: bytes = library().hrt_registration_advice(verdict)
    return advice.decode()


def check_touch(registration: Registration, mark_m: ArrayLike, touched_m: ArrayLike) -> TouchCheck:
    """Whether a later touch of a mark agrees with a registration, as before a reach."""
    touch = _abi.MarkTouch(mark_m=mark_m, touched_m=touched_m)
    return output(TouchCheck, library().hrt_registration_check, byref(registration), byref(touch))


def fit_fingertip(position_m: ArrayLike, rotation: ArrayLike, *, touch_sd_m: float | None = None) -> Fingertip:
    """Fits the offset from a tracked joint to the skin, of one hand, to touches of one and the same mark with the
    finger held differently each time.

    Args:
        position_m: the joint, n x 3 in the engine's world.
        rotation: its unit quaternions x, y, z, w, n x 4.
        touch_sd_m: standard deviation of each coordinate, as expected.
    """
    positions, rotations = np.asarray(position_m, np.float64), np.asarray(rotation, np.float64)
    if positions.ndim != 2 or positions.shape[1] != 3 or rotations.shape != (len(positions), 4):
        raise ValueError(f"position_m must be n x 3 and rotation n x 4, not {positions.shape} and {rotations.shape}")
    config = RegistrationConfig() if touch_sd_m is None else RegistrationConfig(touch_sd_m=touch_sd_m)
    touches = (_abi.JointTouch * len(positions))(
        *(_abi.JointTouch(position_m=p, rotation=r) for p, r in zip(positions, rotations)))
    return output(Fingertip, library().hrt_fingertip_fit, byref(config), touches, len(positions))


def place_fingertip(fingertip: Fingertip, position_m: ArrayLike, rotation: ArrayLike) -> NDArray[np.float64]:
    """Where the skin that touches is in the world, from a joint's position and its unit quaternion x, y, z, w: for
    every sample of that hand, and for the touches of a registration that its reaches use."""
    joint = _abi.JointTouch(position_m=position_m, rotation=rotation)
    sample = output(_abi.Sample, library().hrt_fingertip_place, byref(fingertip), byref(joint))
    return np.array(sample.finger_position_m)


def fit_latency(samples: Array) -> Latency:
    """Finds how late the tracker is from an array of SAMPLE of a finger that rests on a mark near the rim while the
    plate turns to and fro under it, at uneven times: positions and plate orientations."""
    expect_rows(samples, "samples", SAMPLE)
    rows = ctypes.cast(samples.ctypes.data, ctypes.POINTER(_abi.Sample))
    return output(Latency, library().hrt_latency_fit, rows, len(samples))
