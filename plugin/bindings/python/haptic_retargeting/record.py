"""A reach as arrays."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._abi import Place, ReachSummary, SampleFlag, SessionConfig, TargetConfig
from .arrays import Array

Numbers = NDArray[np.float64]


@dataclass(frozen=True, repr=False, eq=False)
class ReachRecord:
    """One reach, as it was run or read from a recording. Rows of the three arrays belong together."""

    config: SessionConfig
    real_direction_deg: float
    """This and the next three as the reach began."""
    virtual_direction_deg: float
    real_distance_m: float
    start_position_m: Numbers
    samples: Array
    """What went in, of dtype SAMPLE."""
    commands: Array
    """What came out, of dtype COMMAND; NaN, and step -1, where the call failed."""
    results: NDArray[np.int32]
    """What became of each call: 0, or an ErrorCode."""
    final_direction_deg: float
    """Of the finger in the last step; NaN if the reach did not end."""
    summary: ReachSummary | None = None
    """The library's own account; None of a reach that was read."""

    def __repr__(self) -> str:
        duration = float(self.time_s[-1]) if len(self.samples) else 0.0
        return (f"<{type(self).__name__}: {len(self.samples)} samples in {duration:.2f} s, real target "
                f"{self.real_direction_deg:+.2f} deg, virtual {self.virtual_direction_deg:+.2f} deg, "
                f"last step {self.final_direction_deg:+.2f} deg>")

    @property
    def paper_miss_deg(self) -> float:
        """The final direction less the real target's."""
        return self.final_direction_deg - self.real_direction_deg

    @property
    def time_s(self) -> Numbers:
        """Seconds since the first sample."""
        times = self.samples["time_ns"]
        return np.asarray((times - times[:1]) * 1e-9)

    @property
    def position_m(self) -> Numbers:
        """The fingertip in plate coordinates, n x 3; NaN where it was not seen."""
        flags = self.samples["flags"]
        out = np.full((len(flags), 3), np.nan)
        on_plate = (flags & SampleFlag.PLATE_POSITION) != 0
        in_world = (flags & SampleFlag.WORLD_POSITION) != 0
        moved = (flags & SampleFlag.PLATE_POSE) != 0
        out[on_plate] = self.samples["finger_position_m"][on_plate]
        plate = np.where(moved[:, None], self.samples["plate_position_m"], np.array(self.config.plate_position_m))
        rotation = np.where(moved[:, None], self.samples["plate_rotation"], np.array(self.config.plate_rotation))
        in_plate = world_to_plate(self.samples["finger_position_m"], plate, rotation)
        out[in_world] = in_plate[in_world]
        return out

    @property
    def measured_plate_deg(self) -> Numbers:
        """Where the plate said that it stands; NaN where it did not."""
        known = (self.samples["flags"] & SampleFlag.PLATE_ORIENTATION) != 0
        return np.where(known, self.samples["plate_orientation_deg"], np.nan)


@dataclass(frozen=True, repr=False, eq=False)
class RunRecord(ReachRecord):
    """A reach that was run here, and so has its summary."""

    summary: ReachSummary = field(default_factory=ReachSummary)


def world_to_plate(position_m: ArrayLike, plate_position_m: ArrayLike, plate_rotation: ArrayLike) -> Numbers:
    """Positions in plate coordinates, for a plate at a place in the world, turned by the quaternion x, y, z, w."""
    rotation = np.asarray(plate_rotation, np.float64)
    away = np.asarray(position_m, np.float64) - np.asarray(plate_position_m, np.float64)
    # By the conjugate: v + 2 w (v x q) + 2 (v x q) x q
    vector, scalar = rotation[..., :3], rotation[..., 3:]
    once = np.cross(away, vector)
    return np.asarray(away + 2 * scalar * once + 2 * np.cross(once, vector))


def target_place(target: TargetConfig, config: SessionConfig) -> tuple[float, float]:
    """Direction (degrees) and distance (metres) of a target from the start."""
    if target.place == Place.DIRECTION:
        return target.direction_deg, target.distance_m
    position = np.array(target.position_m)
    if target.place == Place.WORLD_POSITION:
        position = world_to_plate(position, list(config.plate_position_m), list(config.plate_rotation))
    right, _, towards = position - np.array(config.start_position_m)
    return float(np.degrees(np.arctan2(-right, -towards))), float(np.hypot(right, towards))
