"""Reads the parts and tables that the target plate_model writes, and intersects the parts with lines.

Needs numpy. Lengths are in millimetres: +X to the user's right, +Y along the mid-line, z = 0 on the plate's face.
"""
import collections
import json
import math
import pathlib

import numpy as np

BOUGHT = ["bearing", "servo", "horn", "xl330", "xl330_horn"]
Screw = collections.namedtuple("Screw", "name through into length face at counted")


class Solid:
    """Triangles whose corners are counter-clockwise seen from outside."""

    def __init__(self, triangles):
        self.triangles = triangles
        self.low, self.high = triangles.min(axis=1), triangles.max(axis=1)
        self.box = self.low.min(axis=0).tolist(), self.high.max(axis=0).tolist()

    def crossings(self, point, axis=2):
        """Intersections of the surface with the line through `point` along an axis, ascending. The part is between the first
        and the second, the third and the fourth, and so on. Choose `point` so that the line passes no edge."""
        u, v = [(axis + 1) % 3, (axis + 2) % 3]
        if any(not self.box[0][side] <= point[side] <= self.box[1][side] for side in (u, v)):
            return np.empty(0)
        near = np.ones(len(self.triangles), bool)
        for side in (u, v):
            near &= (self.low[:, side] <= point[side]) & (point[side] <= self.high[:, side])
        a = self.triangles[near] - np.asarray(point, float)
        b, c = np.roll(a, -1, axis=1), np.roll(a, -2, axis=1)
        # Twice the areas of the triangles that the point forms with each side, seen along the axis. They are the
        # weights of the corners in the interpolation.
        areas = b[..., u] * c[..., v] - c[..., u] * b[..., v]
        hit = (areas > 0).all(axis=1) | (areas < 0).all(axis=1)
        return np.sort((areas[hit] * a[hit][..., axis]).sum(axis=1) / areas[hit].sum(axis=1) + point[axis])


def read_stl(path):
    corners = [line.split()[1:] for line in path.read_text().splitlines() if line.lstrip().startswith("vertex")]
    return np.array(corners, float).reshape(-1, 3, 3)


def tables(folder):
    """Lines of the model's tables, without the text that OpenSCAD adds."""
    lines = (pathlib.Path(folder) / "tables.echo").read_text().splitlines()
    return [line.removeprefix('ECHO: "').removesuffix('"') for line in lines]


def rows(folder, kind):
    return [json.loads(line.removeprefix(kind)) for line in tables(folder) if line.startswith(kind + "[")]


def printed(folder):
    """Printed parts by name, in their orientation on the printer's bed."""
    return {row[0]: Solid(read_stl(pathlib.Path(folder) / f"{row[0]}.stl")) for row in rows(folder, "bed")}


def installed(folder):
    """All parts by name, at their positions in the plate."""
    parts = {name: Solid(read_stl(pathlib.Path(folder) / "bought" / f"{name}.stl")) for name in BOUGHT}
    on_bed = printed(folder)
    for name, height, over_deg, turned_deg in rows(folder, "bed"):
        c, s, way = math.cos(math.radians(turned_deg)), math.sin(math.radians(turned_deg)), -1 if over_deg else 1
        placed = on_bed[name].triangles @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
        parts[name] = Solid(placed * [way, 1, way] + [0, 0, height])
    return parts


def screws(folder):
    """Screws through one part into another: the shaft is above the head at z = `face`, or below it if `length` is negative."""
    return [Screw(*row) for row in rows(folder, "screw")]


def at_direction(radius, direction_deg):
    """Point in the plane at a direction from the centre, counter-clockwise from +Y."""
    return (-radius * math.sin(math.radians(direction_deg)), radius * math.cos(math.radians(direction_deg)))


def on_circle(radius, count, first_deg=0.0):
    return [at_direction(radius, first_deg + 360 * i / count) for i in range(count)]
