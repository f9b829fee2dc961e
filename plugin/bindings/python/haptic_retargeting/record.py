"""The data of one reach as arrays."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._abi import Place, ReachSummary, SampleFlag, SessionConfig, TargetConfig
from .arrays import Array

Numbers = NDArray[np.float64]


@dataclass(frozen=True, repr=False, eq=False)
class ReachRecord:
    """One reach that was run or read from a recording. A row of `samples`, `commands` and `results` is one update."""

    config: SessionConfig
    """Configuration at the beginning of the reach. The next four fields are also from its beginning or, if the reach
    starts at the finger, from the first position."""
    real_direction_deg: float
    virtual_direction_deg: float
    real_distance_m: float
    start_position_m: Numbers
    samples: Array
    """Input of the reach, of dtype SAMPLE."""
    commands: Array
    """Output of the reach, of dtype COMMAND. For calls that failed: NaN, no flags, and paper_step -1."""
    results: NDArray[np.int32]
    """Result of each call: 0, or an ErrorCode."""
    summary: ReachSummary | None = None
    """Result of the reach; None if it was cancelled or has not ended."""

    def __repr__(self) -> str:
        duration = float(self.time_s[-1]) if len(self.samples) else 0.0
        return (f"<{type(self).__name__}: {len(self.samples)} samples in {duration:.2f} s, real target "
                f"{self.real_direction_deg:+.2f} deg, virtual {self.virtual_direction_deg:+.2f} deg, "
                f"final bearing {self.final_bearing_deg:+.2f} deg>")

    @property
    def final_bearing_deg(self) -> float:
        """ReachSummary.bearing_deg; NaN without a summary."""
        return np.nan if self.summary is None else self.summary.bearing_deg

    @property
    def time_s(self) -> Numbers:
        """Seconds since the first sample."""
        times = self.samples["time_ns"]
        return np.asarray((times - times[:1]) * 1e-9)

    @property
    def position_m(self) -> Numbers:
        """The fingertip in plate coordinates, n x 3; NaN for samples without a position."""
        samples, config = self.samples, self.config

        def has(flag: SampleFlag) -> NDArray[np.bool_]:
            return np.asarray((samples["flags"] & flag) != 0)[:, None]

        tip = samples["finger_position_m"]
        skin = tip + _rotated(np.array(config.fingertip_offset_m), samples["joint_rotation"])
        plate = np.where(has(SampleFlag.PLATE_POSE), samples["plate_position_m"], np.array(config.plate_position_m))
        rotation = np.where(has(SampleFlag.PLATE_POSE), samples["plate_rotation"], np.array(config.plate_rotation))
        skin = world_to_plate(np.where(has(SampleFlag.JOINT_ROTATION), skin, tip), plate, rotation, config.plate_scale)
        seen = np.where(has(SampleFlag.WORLD_POSITION), skin, np.nan)
        return np.where(has(SampleFlag.PLATE_POSITION), tip, seen)

    @property
    def felt_position_m(self) -> Numbers:
        """Perceived position of the fingertip by the model, in plate coordinates, n x 3: after the onset, each step of
        the path is rotated by the perceived direction minus the direction of motion over eleven positions. NaN for
        samples without a position."""
        position = self.position_m
        seen = ~np.isnan(position[:, 0])
        out = np.full_like(position, np.nan)
        if not seen.any():
            return out
        right, height, towards = position[seen].T
        path = right - 1j * towards
        at = np.arange(len(path))
        motion = np.angle((path[np.minimum(at + 5, at[-1])] - path[np.maximum(at - 5, 0)]) / 1j)
        turn = np.radians(np.nan_to_num(self.commands["perceived_direction_deg"][seen])) - motion
        angle = np.where(np.nan_to_num(self.commands["bearing_deg"][seen]) != 0, turn, 0.0)
        steps = np.exp(1j * angle[1:]) * np.diff(path)  # counter-clockwise, seen from above
        felt = right[0] - 1j * towards[0] + np.concatenate(([0], np.cumsum(steps)))
        out[seen] = np.stack((felt.real, height, -felt.imag), axis=1)
        return out

    def bearing_deg(self, position_m: ArrayLike, least_m: float = 0.02) -> Numbers:
        """Returns bearings of positions in plate coordinates, from the start; NaN within `least_m` of the start."""
        right, _, towards = (np.asarray(position_m, np.float64) - self.start_position_m).T
        return np.where(np.hypot(right, towards) < least_m, np.nan, np.degrees(np.arctan2(-right, -towards)))

    @property
    def measured_plate_deg(self) -> Numbers:
        """Measured plate orientation; NaN for samples that have no measured orientation."""
        known = (self.samples["flags"] & SampleFlag.PLATE_ORIENTATION) != 0
        return np.where(known, self.samples["plate_orientation_deg"], np.nan)


@dataclass(frozen=True, repr=False, eq=False)
class RunRecord(ReachRecord):
    """A reach that Session.run_reach() ran, which always has a summary."""

    summary: ReachSummary = field(default_factory=ReachSummary)


def _rotated(vector: Numbers, rotation: Numbers) -> Numbers:
    """Rotates vectors v by quaternions x, y, z, w: v + 2 w (q x v) + 2 q x (q x v), where q is (x, y, z)."""
    axis, scalar = rotation[..., :3], rotation[..., 3:]
    once = np.cross(axis, vector)
    return np.asarray(vector + 2 * scalar * once + 2 * np.cross(axis, once))


def world_to_plate(position_m: ArrayLike, plate_position_m: ArrayLike, plate_rotation: ArrayLike, plate_scale: float = 1.0) -> Numbers:
    """Converts positions in the world to plate coordinates. `plate_rotation` is a quaternion x, y, z, w."""
    away = (np.asarray(position_m, np.float64) - np.asarray(plate_position_m, np.float64)) / plate_scale
    return _rotated(away, np.asarray(plate_rotation, np.float64) * (-1, -1, -1, 1))


def target_place(target: TargetConfig, config: SessionConfig) -> tuple[float, float]:
    """Returns direction (degrees) and distance (metres) of a target from the start."""
    if target.place == Place.DIRECTION:
        return target.direction_deg, target.distance_m
    position = np.array(target.position_m)
    if target.place == Place.WORLD_POSITION:
        position = world_to_plate(position, list(config.plate_position_m), list(config.plate_rotation), config.plate_scale)
    right, _, towards = position - np.array(config.start_position_m)
    return float(np.degrees(np.arctan2(-right, -towards))), float(np.hypot(right, towards))
