#!/usr/bin/env python3
"""Makes the meshes of data/ from closed forms, with the standard library only.

    python3 scripts/make_data.py [FOLDER]        (default: data beside this script)

block.stl, bar.stl             the stocks of PRIMER_2F and PRIMER_2S
PRIMER_2F.nominal.stl          the block less a slot 5 mm wide and 2 mm deep along three semicircles
PRIMER_2S.nominal.stl          the turned contour of PRIMER_2S revolved about Z

Every vertex lies on the exact solid (to float rounding), every triangle within 1 micrometre of it. Before
anything is written each mesh is checked: closed, oriented, and of the volume that its chords leave.
"""

import math
import os
import struct
import sys

CHORD = 0.00098  # mm, largest distance of a chord from its arc; below the 1 um that is promised


def f32(x):
    return struct.unpack("<f", struct.pack("<f", x))[0]


class Mesh:
    """Triangles as corner coordinates; corners are rounded to float so that equal points stay equal."""

    def __init__(self):
        self.triangles = []

    def add(self, a, b, c):
        a, b, c = (tuple(f32(v) + 0.0 for v in p) for p in (a, b, c))
        if a != b and b != c and c != a:
            self.triangles.append((a, b, c))

    def volume(self):
        return math.fsum(
            a[0] * (b[1] * c[2] - b[2] * c[1])
            + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0])
            for a, b, c in self.triangles
        ) / 6

    def check(self):
        edges = set()
        for t in self.triangles:
            for i in range(3):
                edge = (t[i], t[(i + 1) % 3])
                if edge in edges:
                    raise SystemExit(f"edge {edge} occurs twice in one direction")
                edges.add(edge)
        for a, b in edges:
            if (b, a) not in edges:
                raise SystemExit(f"edge {a} {b} is open")

    def write(self, path, title):
        """Binary STL. A normal is given where it is more than rounding: by the corners."""
        self.check()
        out = [title.encode().ljust(80)[:80], struct.pack("<I", len(self.triangles))]
        for a, b, c in self.triangles:
            u = [b[i] - a[i] for i in range(3)]
            v = [c[i] - a[i] for i in range(3)]
            n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
            size = math.sqrt(sum(x * x for x in n)) or 1.0
            out.append(struct.pack("<12fH", *(x / size for x in n), *a, *b, *c, 0))
        with open(path, "wb") as file:
            file.write(b"".join(out))
        print(f"{path}: {len(self.triangles)} triangles, volume {self.volume():.3f} mm3")


def steps(radius, angle, error=CHORD):
    """Chords that an arc needs so that none is farther than `error` from it."""
    return max(1, math.ceil(angle / (2 * math.acos(1 - error / radius))))


def arc(center, radius, start, sweep, count):
    """count + 1 points; angles in degrees, exact at the multiples of 90."""
    points = []
    for i in range(count + 1):
        degrees = start + sweep * i / count
        exact = {0: (1, 0), 90: (0, 1), 180: (-1, 0), 270: (0, -1)}.get(degrees % 360)
        c, s = exact or (math.cos(math.radians(degrees)), math.sin(math.radians(degrees)))
        points.append((center[0] + radius * c, center[1] + radius * s))
    return points


def triangulate(outline):
    """Ear clipping of a simple polygon, counter-clockwise; a bridge to a hole may be walked twice."""

    def turn(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    def inside(p, a, b, c):
        return turn(a, b, p) >= 0 and turn(b, c, p) >= 0 and turn(c, a, p) >= 0

    points, triangles, i, idle = list(outline), [], 0, 0
    while len(points) > 3:
        n = len(points)
        a, b, c = points[(i - 1) % n], points[i % n], points[(i + 1) % n]
        if turn(a, b, c) > 0 and not any(
            p not in (a, b, c) and inside(p, a, b, c) for p in points
        ):
            triangles.append((a, b, c))
            points.pop(i % n)
            i, idle = i - 1, 0
        else:
            i, idle = i + 1, idle + 1
            if idle > 2 * n:
                raise SystemExit("outline cannot be triangulated")
        i %= len(points)
    triangles.append(tuple(points))
    return triangles


def box(x0, y0, z0, x1, y1, z1):
    mesh = Mesh()
    corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    prism(mesh, corners, z0, z1)
    for a, b, c in ((0, 1, 2), (0, 2, 3)):
        mesh.add(*((*corners[i], z1) for i in (a, b, c)))
        mesh.add(*((*corners[i], z0) for i in (a, c, b)))
    return mesh


def prism(mesh, outline, z0, z1):
    """Walls over a closed outline, material to its left."""
    for p, q in zip(outline, outline[1:] + outline[:1]):
        mesh.add((*p, z0), (*q, z0), (*q, z1))
        mesh.add((*p, z0), (*q, z1), (*p, z1))


def slot():
    """The two sides of PRIMER_2F's slot and its caps, in the stock's coordinates."""
    y, half = -30.0, 2.5
    strips = []  # (inner or lower side, outer side) of each semicircle, from left to right
    for center, radius, start, sweep in (
        ((27.5, y), 15.0, 180.0, 180.0),
        ((50.0, y), 7.5, 180.0, -180.0),
        ((72.5, y), 15.0, 180.0, 180.0),
    ):
        count = steps(radius + half, math.pi, CHORD / 4)  # small enough a file to be finer
        near = arc(center, radius - half, start, sweep, count)
        far = arc(center, radius + half, start, sweep, count)
        # The side on the right of the path is the far one where the path turns left.
        strips.append((far, near) if sweep > 0 else (near, far))
    caps = [
        arc((12.5, y), half, 0.0, 180.0, steps(half, math.pi, CHORD / 4)),
        arc((87.5, y), half, 0.0, 180.0, steps(half, math.pi, CHORD / 4)),
    ]
    return strips, caps


def primer_2f():
    strips, caps = slot()
    rounded = lambda points: [(f32(x), f32(y)) for x, y in points]
    right = [p for strip in strips for p in rounded(strip[0])[:-1]] + rounded(strips[-1][0])[-1:]
    left = [p for strip in strips for p in rounded(strip[1])[:-1]] + rounded(strips[-1][1])[-1:]
    # Counter-clockwise round the slot: along its right side, round the end, back, round the start.
    hole = right + rounded(caps[1])[1:-1] + left[::-1] + rounded(caps[0])[1:-1]
    mesh = Mesh()
    corners = [(0.0, -60.0), (100.0, -60.0), (100.0, 0.0), (0.0, 0.0)]
    prism(mesh, corners, 0.0, 10.0)
    for a, b, c in ((0, 2, 1), (0, 3, 2)):
        mesh.add(*((*corners[i], 0.0) for i in (a, b, c)))
    prism(mesh, hole[::-1], 8.0, 10.0)
    for strip in strips:
        a, b = rounded(strip[0]), rounded(strip[1])
        for i in range(len(a) - 1):
            mesh.add((*a[i], 8.0), (*a[i + 1], 8.0), (*b[i + 1], 8.0))
            mesh.add((*a[i], 8.0), (*b[i + 1], 8.0), (*b[i], 8.0))
    for cap in caps:
        points = rounded(cap)
        for p, q in zip(points[1:], points[2:]):
            mesh.add((*points[0], 8.0), (*p, 8.0), (*q, 8.0))
    # The face round the slot, cut open between its lowest left corner and the slot's start.
    cut = hole[::-1]
    lead = cut.index(right[0])
    cut = cut[lead:] + cut[:lead]
    # From the corner to the slot, clockwise round it, back, and round the block.
    outline = [corners[0], *cut, cut[0], *corners]
    for a, b, c in triangulate(outline):
        mesh.add((*a, 10.0), (*b, 10.0), (*c, 10.0))
    exact = 60000 - 2 * (5 * 37.5 * math.pi + 6.25 * math.pi)
    return mesh, exact


def ring(radius, z, count, offset=0.0):
    """Points of a circle about Z; offset in steps."""
    return [(*p, z) for p in arc((0, 0), radius, 360.0 * offset / count, 360.0, count)[:-1]]


def band(mesh, lower, upper):
    """Triangles between two rings, their numbers of points may differ; outside to the right of `lower`."""
    n, m = len(lower), len(upper)
    angle = lambda p: math.atan2(p[1], p[0]) % (2 * math.pi)
    begin = lambda ring_: angle(ring_[0]) if angle(ring_[0]) < math.pi else 0.0
    i = j = 0
    while i < n or j < m:
        next_lower = begin(lower) + (i + 1) * 2 * math.pi / n
        next_upper = begin(upper) + (j + 1) * 2 * math.pi / m
        a, b = lower[i % n], upper[j % m]
        if j >= m or (i < n and next_lower <= next_upper + 1e-9):
            mesh.add(a, lower[(i + 1) % n], b)
            i += 1
        else:
            mesh.add(a, upper[(j + 1) % m], b)
            j += 1


def disc(mesh, points, up):
    """A flat face over a ring, as a balanced fan (no needles round one corner)."""
    while len(points) > 2:
        rest = points[::2]
        for i in range(0, len(points) - 1, 2):
            a, b, c = points[i], points[i + 1], points[(i + 2) % len(points)]
            mesh.add(*((a, b, c) if up else (a, c, b)))
        points = rest


def primer_2s():
    """Contour (radius, z) from the chuck upwards: 25, wall at Z25, concave R6, 15, convex R5, face at Z50."""
    turned = steps(21.0, 2 * math.pi)
    bar = ring(25.0, 0.0, steps(25.0, 2 * math.pi)), ring(25.0, 25.0, steps(25.0, 2 * math.pi))
    concave = arc((21.0, 31.0), 6.0, 270.0, -90.0, steps(6.0, math.pi / 2))
    rings = [ring(r, z, turned) for r, z in concave]
    # On the convex arc rings are shifted by half a step: equilateral triangles need the fewest.
    count = 52
    rings += [
        ring(r, z, turned, 0.5 * ((i + 1) % 2))
        for i, (r, z) in enumerate(arc((10.0, 45.0), 5.0, 0.0, 90.0, count))
    ]
    mesh = Mesh()
    disc(mesh, bar[0], False)
    band(mesh, bar[0], bar[1])
    band(mesh, bar[1], rings[0])
    for lower, upper in zip(rings, rings[1:]):
        band(mesh, lower, upper)
    disc(mesh, rings[-1], True)
    pi = math.pi
    fillet = 441 * 6 - 42 * 9 * pi + 144
    dome = 100 * 5 + 20 * 6.25 * pi + 250 / 3
    return mesh, pi * (625 * 25 + fillet + 225 * 14 + dome)


def bar():
    """Every vertex on the circle; 512 facets leave a chord error of 0.5 um."""
    mesh = Mesh()
    low, high = ring(25.0, 0.0, 512), ring(25.0, 51.0, 512)
    disc(mesh, low, False)
    band(mesh, low, high)
    disc(mesh, high, True)
    return mesh


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(here, "..", "data")
    box(0, -60, 0, 100, 0, 10).write(os.path.join(folder, "block.stl"), "mrsim block 100 x 60 x 10 mm")
    bar().write(os.path.join(folder, "bar.stl"), "mrsim bar diameter 50 mm, Z 0 to 51 mm")
    for name, (mesh, exact), slack in (
        ("PRIMER_2F", primer_2f(), 0.05),
        ("PRIMER_2S", primer_2s(), 4.0),
    ):
        if abs(mesh.volume() - exact) > slack:
            raise SystemExit(f"{name}: volume {mesh.volume()} is far from {exact}")
        mesh.write(os.path.join(folder, name + ".nominal.stl"), f"mrsim {name} nominal part, mm")
        print(f"  exact volume {exact:.3f} mm3")


if __name__ == "__main__":
    main()
