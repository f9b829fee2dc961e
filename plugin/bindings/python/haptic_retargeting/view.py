"""What a notebook shows of a reach: a table of its numbers, and a picture from above, without matplotlib."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ._abi import CommandFlag

if TYPE_CHECKING:
    from .record import ReachRecord

# As in plot.py.
_REAL, _VIRTUAL, _FINGER = "#0072B2", "#D55E00", "#000000"
_POINTS_MAX = 500  # of the finger's path


def svg(record: ReachRecord) -> str:
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


def html(record: ReachRecord) -> str:
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
    return f'<div style="display:flex;gap:1em">{svg(record)}<table>{cells}</table></div>'


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
