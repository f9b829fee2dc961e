"""A reach as arrays, and what a notebook shows of it without matplotlib: a table of its numbers, and a picture from above."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._abi import CommandFlag, Place, ReachSummary, SampleFlag, SessionConfig, TargetConfig
from .arrays import Array

Numbers = NDArray[np.float64]

# As in plot.py.
_REAL, _VIRTUAL, _FINGER = "#0072B2", "#D55E00", "#000000"
_POINTS_MAX = 500  # of the finger's path


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

    def _repr_html_(self) -> str:
        """What a notebook shows."""
        return _html(self)

    def _repr_svg_(self) -> str:
        """The reach, seen from above."""
        return _svg(self)

    @property
    def final_miss_deg(self) -> float:
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



def _svg(record: ReachRecord) -> str:
    """Plate, ridges where the plate stands last, targets and the finger's path; x to the right, the user below."""
    radius = 1000 * record.config.plate_radius_m
    start_x, start_y = _start(record)
    ends = [_end(record, start_x, start_y, direction) for direction in (record.real_direction_deg,
                                                                         record.virtual_direction_deg)]
    margin = 10.0
    corners = np.array([(-radius, -radius), (radius, radius), (start_x, start_y), *ends])
    (left, top), (right, bottom) = corners.min(0) - margin, corners.max(0) + margin
    parts = [f'<circle r="{radius:.1f}" fill="#f2f2f2" stroke="#999"/>', _ridges(record, radius)]
    for (x, y), colour in zip(ends, (_REAL, _VIRTUAL)):
        parts.append(f'<path d="M{start_x:.1f} {start_y:.1f}L{x:.1f} {y:.1f}" stroke="{colour}" stroke-dasharray="2 2"/>'
                     f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="none" stroke="{colour}" stroke-width="1.5"/>')
    parts.append(_path(record))
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{left:.1f} {top:.1f} {right - left:.1f} {bottom - top:.1f}" '
            f'width="240" height="{240 * (bottom - top) / (right - left):.0f}">{"".join(parts)}</svg>')


def _html(record: ReachRecord) -> str:
    """The numbers beside the picture."""
    rows = [("samples", f"{len(record.samples)}"), ("real target", _deg(record.real_direction_deg)),
            ("virtual target", _deg(record.virtual_direction_deg)), ("from the real target at last", _miss(record)),
            ("direction of the last step", _deg(record.final_direction_deg))]
    if record.summary is not None:
        rows += [("bearing error", _deg(record.summary.bearing_error_deg)),
                 ("largest felt error", _deg(record.summary.peak_felt_error_deg)),
                 ("weight of touch", f"{record.summary.tactile_weight:.3f} ± {record.summary.tactile_weight_sd:.3f}")]
    seen = CommandFlag(int(np.bitwise_or.reduce(record.commands["flags"], initial=0)))
    rows.append(("flags of its commands", ", ".join(seen.names()) or "none"))
    cells = "".join(f"<tr><td>{name}</td><td>{value}</td></tr>" for name, value in rows)
    return f'<div style="display:flex;gap:1em">{_svg(record)}<table>{cells}</table></div>'


def _deg(angle: float) -> str:
    return "unknown" if math.isnan(angle) else f"{angle:+.2f}°"


def _miss(record: ReachRecord) -> str:
    """Distance along the plate from the last position to the real target."""
    seen = record.position_m[~np.isnan(record.position_m[:, 0])]
    if len(seen) == 0:
        return "unknown"
    x, y = _end(record, *_start(record), record.real_direction_deg)
    return f"{math.hypot(1000 * seen[-1, 0] - x, 1000 * seen[-1, 2] - y):.1f} mm"


def _start(record: ReachRecord) -> tuple[float, float]:
    return 1000 * float(record.start_position_m[0]), 1000 * float(record.start_position_m[2])


def _end(record: ReachRecord, start_x: float, start_y: float, direction_deg: float) -> tuple[float, float]:
    angle, far = math.radians(direction_deg), 1000 * record.real_distance_m
    return start_x - far * math.sin(angle), start_y - far * math.cos(angle)


def _ridges(record: ReachRecord, radius: float) -> str:
    orientations = record.commands["plate_orientation_deg"]
    known = orientations[~np.isnan(orientations)]
    if len(known) == 0:
        return ""
    spacing = radius / 10
    lines = ""
    for i in range(-9, 10):
        half = math.sqrt(radius**2 - (i * spacing) ** 2)
        lines += f"M{-half:.1f} {i * spacing:.1f}H{half:.1f}"
    return f'<path d="{lines}" stroke="#ccc" transform="rotate({-known[-1]:.1f})"/>'


def _path(record: ReachRecord) -> str:
    """A line through the positions, broken where the finger was not seen; of many, some."""
    positions = 1000 * record.position_m[:: len(record.samples) // _POINTS_MAX + 1]
    text, pen = "", "M"
    for x, _, y in positions:
        if math.isnan(x):
            pen = "M"
        else:
            text += f"{pen}{x:.1f} {y:.1f}"
            pen = "L"
    return f'<path d="{text}" fill="none" stroke="{_FINGER}"/>' if text else ""
