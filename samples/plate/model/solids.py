"""The model's parts as the target plate_model writes them, their screws, and where a line meets a part.

Needs numpy. Millimetres: +X to the user's right, +Y along the mid-line, z = 0 on the plate's face.
"""
import math
import pathlib

import numpy as np

BOUGHT = ["bearing", "servo", "horn", "xl330", "xl330_horn"]


class Solid:
    """Triangles whose corners are counter-clockwise seen from outside."""

    def __init__(self, triangles):
        self.triangles = triangles
        self.low, self.high = triangles.min(axis=1), triangles.max(axis=1)
        self.box = self.low.min(axis=0).tolist(), self.high.max(axis=0).tolist()

    def crossings(self, point, axis=2):
        """Where the line through `point` along an axis meets the surface, ascending: inside are the stretches from the
        first to the second, the third to the fourth, and so on. It must pass no edge: give `point` odd coordinates."""
        u, v = [(axis + 1) % 3, (axis + 2) % 3]
        if any(not self.box[0][side] <= point[side] <= self.box[1][side] for side in (u, v)):
            return np.empty(0)
        near = np.ones(len(self.triangles), bool)
        for side in (u, v):
            near &= (self.low[:, side] <= point[side]) & (point[side] <= self.high[:, side])
        a = self.triangles[near] - np.asarray(point, float)
        b, c = np.roll(a, -1, axis=1), np.roll(a, -2, axis=1)
        # Twice the areas of the point with each side, seen along the axis: the weights of the corners.
        areas = b[..., u] * c[..., v] - c[..., u] * b[..., v]
        hit = (areas > 0).all(axis=1) | (areas < 0).all(axis=1)
        return np.sort((areas[hit] * a[hit][..., axis]).sum(axis=1) / areas[hit].sum(axis=1) + point[axis])


def read_stl(path):
    corners = [line.split()[1:] for line in path.read_text().splitlines() if line.lstrip().startswith("vertex")]
    return np.array(corners, float).reshape(-1, 3, 3)


def tables(folder):
    """Lines that the model's tables print, without OpenSCAD's frame."""
    lines = (pathlib.Path(folder) / "tables.echo").read_text().splitlines()
    return [line.removeprefix('ECHO: "').removesuffix('"') for line in lines]


def printed(folder):
    """Printed parts by name, as they lie on the printer's bed."""
    names = [line.split(",")[1] for line in tables(folder) if line.startswith("bed,")]
    return {name: Solid(read_stl(pathlib.Path(folder) / f"{name}.stl")) for name in names}


def installed(folder):
    """All parts by name, in place."""
    parts = {name: Solid(read_stl(pathlib.Path(folder) / "bought" / f"{name}.stl")) for name in BOUGHT}
    on_bed = printed(folder)
    for line in tables(folder):
        if line.startswith("bed,"):
            _, name, height, turned = line.split(",")
            turn = -1 if turned == "true" else 1
            parts[name] = Solid(on_bed[name].triangles * [turn, 1, turn] + [0, 0, float(height)])
    return parts


def at_direction(radius, direction_deg):
    """In the plane, from the centre: counter-clockwise from +Y."""
    return (-radius * math.sin(math.radians(direction_deg)), radius * math.cos(math.radians(direction_deg)))


def on_circle(radius, count, first_deg=0.0):
    return [at_direction(radius, first_deg + 360 * i / count) for i in range(count)]


class Screws:
    """Through one part into another; from under the head at z = `face` upwards, or down if `length` is negative."""

    def __init__(self, through, into, length, face, at, counted=True):
        self.through, self.into, self.length, self.face, self.at, self.counted = through, into, length, face, at, counted


POSTS = [(x, y) for x in (-28, 28) for y in (14, -34)]
SCREWS = {
    "hub": Screws("hub", "plate", 8, -10.5, on_circle(27, 6)),
    "horn": Screws("retainer", "horn", -6, -23.5, on_circle(7, 4, 45)),
    "retainer": Screws("retainer", "hub", 16, -28, on_circle(16, 4)),
    "servo": Screws("servo", "servo_mount", -8, -41.5, [(x, y - 10.15) for x in (-5, 5) for y in (24.75, -24.75)]),
    "mount": Screws("servo_mount", "deck", 30, -47.5, POSTS),
    "xl330_retainer": Screws("xl330_retainer", "hub", 16, -28, on_circle(16, 4), counted=False),
    "xl330_mount": Screws("xl330_mount", "deck", 30, -47.5, POSTS, counted=False),
    "object": Screws("bridge", "object", -16, 49, [(0, 50)]),
    "object_cup": Screws("bridge", "object_cup", -16, 49, [(0, 50)], counted=False),
    "bridge": Screws("deck", "bridge", 16, -11, [at_direction(86, -20), at_direction(86, 20)]),
    "drum": Screws("drum", "deck", 16, -31, on_circle(88, 6)),
}
