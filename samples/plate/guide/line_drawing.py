"""Line drawings of solids, as SVG: what a parallel view shows of their edges, over a light fill.

A depth buffer decides what is hidden. Only Python's own library; a picture takes some seconds.
"""
import math

CREASE_DEG = 24  # an edge between faces that differ less is not drawn


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def unit(a):
    length = math.sqrt(dot(a, a))
    return (a[0] / length, a[1] / length, a[2] / length) if length > 0 else (0.0, 0.0, 0.0)


class View:
    """Parallel view from a direction: compass_deg from -Y counter-clockwise, elevation_deg above the plane."""

    def __init__(self, compass_deg, elevation_deg):
        compass, elevation = math.radians(compass_deg), math.radians(elevation_deg)
        self.right = (math.cos(compass), math.sin(compass), 0.0)
        self.towards = (math.cos(elevation) * math.sin(compass), -math.cos(elevation) * math.cos(compass),
                        math.sin(elevation))
        self.up = cross(self.towards, self.right)

    def seen(self, point):
        """Right, down and nearness of a point, millimetres."""
        return (dot(point, self.right), -dot(point, self.up), dot(point, self.towards))


class Drawing:
    def __init__(self, view, width_px, height_px, margin_px):
        self.view, self.width, self.height, self.margin = view, width_px, height_px, margin_px
        self.solids = []  # (triangles, fill, stroke)
        self.paths = []   # dashed lines in space
        self.labels = []

    def add(self, triangles, fill, stroke):
        self.solids.append((triangles, fill, stroke))

    def add_path(self, a, b):
        self.paths.append((a, b))

    def add_label(self, point, words):
        self.labels.append((point, words))

    def svg(self, caption, title):
        seen = [[tuple(self.view.seen(corner) for corner in triangle) for triangle in triangles]
                for triangles, _, _ in self.solids]
        points = [corner for solid in seen for triangle in solid for corner in triangle]
        low_x, high_x = min(p[0] for p in points), max(p[0] for p in points)
        low_y, high_y = min(p[1] for p in points), max(p[1] for p in points)
        room = self.height - 18 * len(caption)
        self.scale = min((self.width - 2 * self.margin) / (high_x - low_x), (room - 2 * self.margin) / (high_y - low_y))
        shift_x = (self.width - self.scale * (low_x + high_x)) / 2
        shift_y = (room - self.scale * (low_y + high_y)) / 2
        self.place = lambda p: (p[0] * self.scale + shift_x, p[1] * self.scale + shift_y, p[2])
        self.depth = [[-1e9] * self.width for _ in range(self.height)]
        self.owner = [[-1] * self.width for _ in range(self.height)]
        for index, (triangles, solid) in enumerate(zip((s[0] for s in self.solids), seen)):
            for triangle, corners in zip(triangles, solid):
                self.cover(2 * index, triangle, [self.place(corner) for corner in corners])
        lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}" '
                 f'width="{self.width}" height="{self.height}" role="img" aria-label="{title}">',
                 f"<title>{title}</title>", f'<rect width="{self.width}" height="{self.height}" fill="#fff"/>',
                 '<g fill="none" stroke-linecap="round" stroke-linejoin="round">']
        lines += self.fills()
        for triangles, _, stroke in self.solids:
            path = self.edges(triangles)
            if path:
                lines.append(f'<path stroke="{stroke}" stroke-width="1.1" d="{path}"/>')
        for a, b in self.paths:
            (ax, ay, _), (bx, by, _) = self.place(self.view.seen(a)), self.place(self.view.seen(b))
            lines.append(f'<path stroke="#c2410c" stroke-width="1.3" stroke-dasharray="6 4" '
                         f'd="M{ax:.1f} {ay:.1f}L{bx:.1f} {by:.1f}"/>')
        lines.append("</g>")
        for point, words in self.labels:
            x, y, _ = self.place(self.view.seen(point))
            lines.append(f'<text x="{x:.1f}" y="{y + 5:.1f}" text-anchor="middle" font-family="sans-serif" '
                         f'font-size="15" fill="#1f2937" stroke="#fff" stroke-width="4" paint-order="stroke">{words}</text>')
        for i, text in enumerate(caption):
            y = self.height - 18 * (len(caption) - i) + 8
            lines.append(f'<text x="14" y="{y}" font-family="sans-serif" font-size="15" fill="#1f2937">{text}</text>')
        return "\n".join(lines + ["</svg>"]) + "\n"

    def cover(self, owner, triangle, placed):
        """Enters a face that looks at the viewer into the depth buffer."""
        normal = unit(cross(sub(triangle[1], triangle[0]), sub(triangle[2], triangle[0])))
        if dot(normal, self.view.towards) <= 1e-6:
            return
        owner += 0 if abs(normal[2]) > 0.7 else 1  # sides are darker
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = placed
        area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
        if abs(area) < 1e-9:
            return
        slope_x = ((bz - az) * (cy - ay) - (cz - az) * (by - ay)) / area
        slope_y = ((cz - az) * (bx - ax) - (bz - az) * (cx - ax)) / area
        for row in range(max(0, math.ceil(min(ay, by, cy) - 0.5)), min(self.height - 1, int(max(ay, by, cy))) + 1):
            y = row + 0.5
            spans = [x0 + (y - y0) * (x1 - x0) / (y1 - y0) for (x0, y0), (x1, y1) in
                     (((ax, ay), (bx, by)), ((bx, by), (cx, cy)), ((cx, cy), (ax, ay))) if (y0 <= y) != (y1 <= y)]
            if len(spans) < 2:
                continue
            first, last = max(0, math.ceil(min(spans) - 0.5)), min(self.width - 1, math.ceil(max(spans) - 0.5) - 1)
            near = az + (first + 0.5 - ax) * slope_x + (y - ay) * slope_y
            depth, owners = self.depth[row], self.owner[row]
            for x in range(first, last + 1):
                if near > depth[x]:
                    depth[x] = near
                    owners[x] = owner
                near += slope_x

    def fills(self):
        """One path of strokes two pixels high for each tint."""
        runs = {}
        for row in range(0, self.height - 1, 2):
            start = 0
            owners = self.owner[row]
            for x in range(1, self.width + 1):
                if x == self.width or owners[x] != owners[start]:
                    if owners[start] >= 0:
                        runs.setdefault(owners[start], []).append(f"M{start} {row + 1}h{x - start}")
                    start = x
        return [f'<path stroke="{self.solids[owner // 2][1][owner % 2]}" stroke-width="2.2" stroke-linecap="butt" '
                f'd="{"".join(runs[owner])}"/>' for owner in sorted(runs)]

    def edges(self, triangles):
        faces = {}
        for triangle in triangles:
            normal = unit(cross(sub(triangle[1], triangle[0]), sub(triangle[2], triangle[0])))
            for i in range(3):
                a, b = triangle[i], triangle[(i + 1) % 3]
                faces.setdefault((a, b) if a < b else (b, a), []).append(normal)
        crease = math.cos(math.radians(CREASE_DEG))
        pieces = []
        for (a, b), normals in faces.items():
            sides = [dot(normal, self.view.towards) for normal in normals]
            if max(sides) <= 1e-6:
                continue
            outline = min(sides) <= 1e-6
            if len(normals) == 2 and not outline and dot(*normals) > crease:
                continue
            pieces += self.visible(self.place(self.view.seen(a)), self.place(self.view.seen(b)))
        return "".join(draw(simplify(chain)) for chain in chains(pieces))

    def visible(self, a, b):
        """The stretches of an edge that no face hides."""
        count = max(1, round(math.dist(a[:2], b[:2]) / 2))
        stretches, start = [], None
        at = lambda t: tuple(a[i] + (b[i] - a[i]) * t for i in range(3))
        for i in range(count):
            if self.shows(at((i + 0.5) / count)):
                start = i if start is None else start
            elif start is not None:
                stretches.append((start, i))
                start = None
        if start is not None:
            stretches.append((start, count))
        return [(tuple(round(v, 1) for v in at(s / count)[:2]), tuple(round(v, 1) for v in at(e / count)[:2]))
                for s, e in stretches]

    def shows(self, point):
        x, y, near = point
        column, row = int(x - 0.5), int(y - 0.5)
        for r in (row, row + 1):
            for c in (column, column + 1):
                if not (0 <= r < self.height and 0 <= c < self.width) or self.depth[r][c] <= near + 0.35:
                    return True
        return False


def chains(pieces):
    """Pieces joined end to end."""
    ends = {}
    for index, piece in enumerate(pieces):
        for end in piece:
            ends.setdefault(end, []).append(index)
    used = [False] * len(pieces)
    for index, (a, b) in enumerate(pieces):
        if used[index] or a == b:
            continue
        used[index] = True
        chain = [a, b]
        for _ in range(2):
            while True:
                following = [i for i in ends[chain[-1]] if not used[i]]
                if not following:
                    break
                used[following[0]] = True
                one, other = pieces[following[0]]
                chain.append(other if one == chain[-1] else one)
            chain.reverse()
        yield chain


def simplify(chain, tolerance=0.3):
    """Douglas and Peucker: leaves out points within the tolerance of the line."""
    keep, stack = {0, len(chain) - 1}, [(0, len(chain) - 1)]
    while stack:
        first, last = stack.pop()
        (ax, ay), (bx, by) = chain[first], chain[last]
        length = math.hypot(bx - ax, by - ay)
        worst, index = tolerance, None
        for i in range(first + 1, last):
            x, y = chain[i]
            away = (abs((bx - ax) * (ay - y) - (ax - x) * (by - ay)) / length if length > 0
                    else math.hypot(x - ax, y - ay))
            if away > worst:
                worst, index = away, i
        if index is not None:
            keep.add(index)
            stack += [(first, index), (index, last)]
    return [chain[i] for i in sorted(keep)]


def draw(chain):
    return "M" + " ".join(f"{x:g} {y:g}" for x, y in chain)
