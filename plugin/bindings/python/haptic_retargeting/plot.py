"""Pictures of a reach, with matplotlib."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._abi import CommandFlag, SampleFlag
from .record import ReachRecord

# Colours of the palette of Okabe and Ito, for readers with a colour vision deficiency.
REAL, VIRTUAL, FINGER, PLATE = "#0072B2", "#D55E00", "#000000", "#009E73"


def reach(record: ReachRecord, title: str = "") -> Any:
    """Draws one reach from above, and its angles over time. Returns the matplotlib figure."""
    if len(record.samples) == 0:
        raise ValueError("the record has no samples, so there is nothing to draw: pass a record with samples")
    from matplotlib.figure import Figure

    figure = Figure(figsize=(11, 4.8), layout="constrained")
    path, time = figure.subplots(1, 2, width_ratios=(1, 1.4))
    from_above(path, record)
    over_time(time, record)
    figure.suptitle(title)
    return figure


def from_above(axes: Any, record: ReachRecord) -> None:
    """Draws plate, ridges, finger and targets from above, in mm: x to the user's right, the user below. The virtual
    target is drawn at the distance of the real one."""
    _draw_plate(axes, record)
    x, _, z = 1000 * record.position_m.T
    axes.plot(x, -z, ".", color=FINGER, markersize=2, label="finger, as tracked")
    felt_x, _, felt_z = 1000 * record.felt_position_m.T
    axes.plot(felt_x, -felt_z, "-", color=VIRTUAL, linewidth=1, alpha=0.6, label="felt, as the model predicts")
    start_x, _, start_z = 1000 * record.start_position_m
    axes.plot(start_x, -start_z, "+", color=FINGER, markersize=9, label="start")
    for name, colour, marker, direction in (("real target", REAL, "o", record.real_direction_deg),
                                            ("virtual target", VIRTUAL, "D", record.virtual_direction_deg)):
        angle, far = np.radians(direction), 1000 * record.real_distance_m
        end_x, end_y = start_x - far * np.sin(angle), -start_z + far * np.cos(angle)
        axes.plot([start_x, end_x], [-start_z, end_y], ":", color=colour, linewidth=1)
        axes.plot(end_x, end_y, marker, color=colour, markersize=8, fillstyle="none", markeredgewidth=2,
                  linestyle="none", label=f"{name}, {direction:+.1f}°")
    axes.set_aspect("equal")
    axes.set_xlabel("right of the mid-line (mm)")
    axes.set_ylabel("away from the user (mm)")
    lines, labels = axes.get_legend_handles_labels()
    _legend_below(axes, lines, labels, columns=2)


def _draw_plate(axes: Any, record: ReachRecord, spacing_mm: float = 5.0) -> None:
    """Draws the edge of the plate, and ridges at the orientation of the last sample: measured, or else commanded."""
    radius = 1000 * record.config.plate_radius_m
    around = np.linspace(0, 2 * np.pi, 181)
    axes.fill(radius * np.cos(around), radius * np.sin(around), facecolor="#f2f2f2", edgecolor="0.6")
    orientation = record.measured_plate_deg
    orientation = np.where(np.isnan(orientation), record.commands["plate_orientation_deg"], orientation)
    orientation = orientation[~np.isnan(orientation)]
    if len(orientation) == 0:
        return
    angle = np.radians(orientation[-1])
    normal, along = np.array((-np.sin(angle), np.cos(angle))), np.array((np.cos(angle), np.sin(angle)))
    for offset in np.arange(-radius + spacing_mm / 2, radius, spacing_mm):
        half = np.sqrt(radius**2 - offset**2)
        ends = np.array((offset * normal - half * along, offset * normal + half * along))
        axes.plot(*ends.T, color="0.85", linewidth=1, zorder=1)


def over_time(axes: Any, record: ReachRecord) -> None:
    """Draws bearings of the actual and the perceived path, seen from the start (left axis), and plate orientations
    (right axis) over time; grey while the finger is lifted or not tracked. Without positions, draws directions of
    motion instead of bearings."""
    time, commands = record.time_s, record.commands
    moving = np.nan_to_num(commands["bearing_deg"]) != 0
    plate_axes = axes.twinx()
    _shade(axes, time, (record.samples["flags"] & (SampleFlag.DIRECTION | SampleFlag.PLATE_POSITION
                                                   | SampleFlag.WORLD_POSITION)) == 0, "0.85", "finger not seen")
    _shade(axes, time, (commands["flags"] & CommandFlag.LIFTED) != 0, "0.93", "finger lifted")
    for name, colour, position_m, field in (
            ("finger", REAL, record.position_m, "bearing_deg"),
            ("felt, as the model predicts", VIRTUAL, record.felt_position_m, "perceived_direction_deg")):
        seen = not np.isnan(position_m).all()
        axes.plot(time, np.where(moving, record.bearing_deg(position_m) if seen else commands[field], np.nan), color=colour, label=name)
    axes.axhline(record.real_direction_deg, color=REAL, linestyle=":", label="real target")
    axes.axhline(record.virtual_direction_deg, color=VIRTUAL, linestyle=":", label="virtual target")
    plate_axes.plot(time, np.where(moving, commands["plate_orientation_deg"], np.nan), "--", color=PLATE, linewidth=1,
                    label="plate, commanded")
    plate_axes.plot(time, record.measured_plate_deg, "-", color=PLATE, linewidth=1, alpha=0.5, label="plate, measured")
    axes.set_xlabel("time (s)")
    axes.set_ylabel("bearing from the start (degrees to the left)")
    plate_axes.set_ylabel("plate's orientation (degrees)", color=PLATE)
    lines, labels = (a + b for a, b in zip(axes.get_legend_handles_labels(), plate_axes.get_legend_handles_labels()))
    _legend_below(axes, lines, labels, columns=3)


def _legend_below(axes: Any, lines: Any, labels: Any, columns: int) -> None:
    axes.legend(lines, labels, loc="upper center", bbox_to_anchor=(0.5, -0.13), ncols=columns, fontsize="small")


def _shade(axes: Any, time: Any, where: Any, colour: str, name: str) -> None:
    edges = np.flatnonzero(np.diff(np.concatenate(([False], where, [False])).astype(int)))
    for begin, end in edges.reshape(-1, 2):
        axes.axvspan(time[begin], time[min(end, len(time) - 1)], color=colour, linewidth=0,
                     label=name if begin == edges[0] else None)
