#!/usr/bin/env python3
"""Times of whole runs on classes of programs: class_times.py MRSIM [--voxel 0.25] [--runs 3] [--only NAME] [--growth]

Prints a row for each program: moves, seconds of wall and CPU time (medians), peak memory, triangles. `wave-TOOL` is one path by
several tools, so that their rows compare the tools; `wave-flat-x10` has ten times the moves, for growth.
"""

import argparse
import math
import os
import re
import resource
import statistics
import subprocess
import tempfile
import time

WAVE_TOOLS = {
    "ball": "ballmill:d=3",
    "flat": "endmill:d=3",
    "bull": "bullmill:d=3,r=0.5",
    "vee": "chamfer:d=6,a=60",
    "taper": "taper:d=1,a=5,r=0.5,l=20",
}


class Program:
    """Begins with the first of its tools, T1."""

    def __init__(self, stock, *tools):
        self.stock, self.tools, self.moves = stock, tools, 0
        self.lines = ["%", "O7001", "G90 G94 G17 G21", "T1 M6", "S12000 M3", "G54"]

    def options(self):
        tools = [word for number, tool in enumerate(self.tools, 1) for word in ("--tool", f"{number}={tool}")]
        return ["--stock", self.stock] + tools

    def change_to(self, number):
        self.lines += ["G0 Z20.", f"T{number} M6", "S12000 M3"]

    def rapid(self, **to):
        self._add("G0", to)

    def cut(self, **to):
        self._add("G1", to)
        self.moves += 1

    def arc(self, word, **to):
        self._add(word, to)
        self.moves += 1

    def _add(self, word, to):
        self.lines.append(word + "".join(f" {axis.upper()}{value:.4f}" for axis, value in to.items()) + " F800")

    def text(self):
        return "\n".join(self.lines + ["G0 Z20.", "M30", "%", ""])


def wave(tool, moves):
    """Parallel rows over hills with steep flanks, 60 x 60 x 12 mm."""
    p = Program("box:-3,-3,-14,63,63,0", tool)
    rows = max(2, round(math.sqrt(moves / 2)))
    for row in range(rows):
        y = 60 * row / (rows - 1)
        for i in range(moves // rows + 1):
            x = 60 * i * rows / moves
            x = 60 - x if row % 2 else x
            hill = math.exp(-(((x - 30) ** 2 + (y - 28) ** 2) / 180)) + 0.12 * math.sin(0.9 * x) * math.sin(1.1 * y)
            z = -9 + 8 * hill - (2.5 if math.hypot(x - 14, y - 44) < 9 else 0)
            if i == 0 and row == 0:
                p.rapid(x=x, y=y, z=3)
            p.cut(x=x, y=y, z=z)
    return p


def letters(moves):
    """Curved strokes of a V-bit, deep in the middle and shallow at the ends."""
    p = Program("box:0,0,-5,80,40,0", "chamfer:d=8,a=60")
    strokes = max(1, moves // 90)
    for k in range(strokes):
        x, y, turn = 4 + 70 * (k * 0.618 % 1), 4 + 32 * (k * 0.382 % 1), 2 * math.pi * (k * 0.7548 % 1)
        p.rapid(x=x, y=y, z=1)
        for i in range(91):
            t = i / 90
            turn += 0.03 * math.sin(5 * t + k)
            x, y = min(79, max(1, x + 0.07 * math.cos(turn))), min(39, max(1, y + 0.07 * math.sin(turn)))
            p.cut(x=x, y=y, z=-0.1 - 1.6 * math.sin(math.pi * t))
        p.rapid(z=1)
    return p


def ramps(moves):
    """Pockets entered along helices and cleared in level rings, with ramps along arcs between the levels."""
    p = Program("box:0,0,-16,120,90,0", "endmill:d=6")
    pockets = max(1, moves // 40)
    columns = math.ceil(math.sqrt(pockets * 120 / 90))
    for k in range(pockets):
        cx, cy = 8 + 104 * (k % columns) / max(1, columns - 1), 8 + 74 * (k // columns) / max(1, pockets // columns)
        p.rapid(x=cx + 2, y=cy)
        p.rapid(z=1)
        p.cut(z=0)
        for turn in range(1, 6):
            p.arc("G3", x=cx + 2, y=cy, z=-turn, i=-2, j=0)
        for level in range(5, 13):
            for radius in (2, 3.5, 4.5):
                p.cut(x=cx + radius, y=cy, z=-level)
                p.arc("G3", x=cx + radius, y=cy, i=-radius, j=0)
            p.arc("G3", x=cx - 4.5, y=cy, z=-level - 1, i=-4.5, j=0)
            p.arc("G3", x=cx + 4.5, y=cy, z=-level - 1, i=4.5, j=0)
        p.rapid(z=2)
    return p


def drilled(moves):
    """Holes drilled in six pecks each, some of them twice."""
    p = Program("box:0,0,-20,100,100,0", "drill:d=3.3,a=118")
    side = max(1, round(math.sqrt(moves / 6)))
    for k in range(side * side):
        p.rapid(x=4 + 92 * (k % side) / max(1, side - 1), y=4 + 92 * (k // side) / max(1, side - 1))
        for peck in range(6):
            p.rapid(z=1 if peck == 0 else -3 * peck + 0.3)
            p.cut(z=-3 * (peck + 1) if k % 5 else -15)
            p.rapid(z=1)
    return p


def fins(moves):
    """Slots side by side, as deep as twelve times their width, a millimetre a pass."""
    slots = max(1, moves // 24)
    p = Program(f"box:0,0,-15,{4 + 2.2 * slots:.1f},60,0", "endmill:d=1")
    for k in range(slots):
        x = 3 + 2.2 * k
        p.rapid(x=x, y=-3)
        p.rapid(z=1)
        for depth in range(1, 13):
            p.cut(x=x, z=-depth)
            p.cut(y=63 if depth % 2 else -3)
        p.rapid(z=2)
    return p


def wheel(moves):
    """A toothed contour of short moves at four depths."""
    p = Program("box:-45,-45,-8,45,45,0", "endmill:d=2")
    points = max(24, moves // 4)
    for depth in range(1, 5):
        p.rapid(x=42, y=0)
        p.rapid(z=1)
        p.cut(z=-2 * depth)
        for k in range(1, points + 1):
            at = 2 * math.pi * k / points
            radius = 36 + 3 * math.tanh(3 * math.sin(24 * at))
            p.cut(x=radius * math.cos(at), y=radius * math.sin(at))
        p.rapid(z=2)
    return p


def ring(p, cx, cy, half_x, half_y, corner):
    """Once round a rectangle with rounded corners, from the middle of its lower side."""
    ways = ((1, 0), (0, 1), (-1, 0), (0, -1))
    for k, (x, y) in enumerate(((half_x, -half_y), (half_x, half_y), (-half_x, half_y), (-half_x, -half_y))):
        (ax, ay), (bx, by) = ways[k], ways[(k + 1) % 4]
        p.cut(x=cx + x - corner * ax, y=cy + y - corner * ay)
        p.arc("G3", x=cx + x + corner * bx, y=cy + y + corner * by, i=corner * bx, j=corner * by)
    p.cut(x=cx, y=cy - half_y)


def zigzag_pocket(p, cx, cy, half):
    """Two levels of rows that leave cusps at the walls."""
    rows = max(2, math.ceil(2 * half / 4.5) + 1)
    for depth in (3, 6):
        p.rapid(x=cx - half, y=cy - half)
        p.rapid(z=2)
        p.cut(z=-depth)
        for row in range(rows):
            y, side = cy - half + 2 * half * row / (rows - 1), 1 if row % 2 else -1
            p.cut(x=cx + side * half, y=y)
            p.cut(x=cx - side * half, y=y)
        p.rapid(z=2)


def bore(p, cx, cy, radius):
    """Down a helix in steps of a millimetre, and once round."""
    p.rapid(x=cx + radius, y=cy)
    p.rapid(z=1)
    for depth in range(0, 9):
        p.arc("G3", x=cx + radius, y=cy, z=-depth, i=-radius, j=0)
    p.arc("G3", x=cx + radius, y=cy, i=-radius, j=0)
    p.rapid(z=2)


def plate(moves):
    """Faced, pockets and bores milled, drilled, its outline cut in steps, all edges chamfered: five features of three kinds."""
    p = Program("box:-4,-4,-12,164,124,1", "endmill:d=20", "endmill:d=6", "drill:d=5,a=118", "chamfer:d=8,a=90")
    p.rapid(x=-12, y=0, z=3)
    for row in range(9):
        p.cut(x=-12 if row % 2 == 0 else 172, y=15 * row, z=0)
        p.cut(x=172 if row % 2 == 0 else -12, y=15 * row)
    across = max(2, math.ceil(math.sqrt(moves / 36)))
    down = max(2, math.ceil(across * 0.7))
    pitch = min(148 / across, 108 / down)
    places = [(6 + pitch * (i + 0.5), 6 + pitch * (j + 0.5), (i + 2 * j) % 3) for j in range(down) for i in range(across)]
    half = max(0.5, 0.42 * pitch - 3)
    p.change_to(2)
    for x, y, kind in places:
        if kind == 0:
            zigzag_pocket(p, x, y, half)
        elif kind == 1:
            bore(p, x, y, half)
    for depth in (3, 6, 9, 12):
        p.rapid(x=80, y=-3)
        p.rapid(z=2)
        p.cut(z=-depth)
        ring(p, 80, 60, 83, 63, 11)
        p.rapid(z=2)
    p.change_to(3)
    for x, y, kind in places:
        for dx, dy in ((-1, -1), (1, -1), (1, 1), (-1, 1)) if kind == 2 and half > 3 else ():
            p.rapid(x=x + dx * half, y=y + dy * half)
            for above, depth in ((1, 4), (-3.5, 8), (-7.5, 14)):
                p.rapid(z=above)
                p.cut(z=-depth)
            p.rapid(z=2)
    p.change_to(4)
    p.rapid(x=80, y=-1.5)
    p.rapid(z=2)
    p.cut(z=-2)
    ring(p, 80, 60, 81.5, 61.5, 9.5)
    p.rapid(z=2)
    for x, y, kind in places:
        if kind < 2:
            p.rapid(x=x, y=y - half - 1.5)
            p.cut(z=-2)
            ring(p, x, y, half + 1.5, half + 1.5, 1.5 if kind == 0 else half + 1.5)
            p.rapid(z=2)
    return p


def programs(more=1):
    """Makers by name; `more` times the moves."""
    found = {f"wave-{name}": lambda tool=tool: wave(tool, 20000 * more) for name, tool in WAVE_TOOLS.items()}
    found["wave-flat-x10"] = lambda: wave(WAVE_TOOLS["flat"], 200000 * more)
    found["letters"] = lambda: letters(6000 * more)
    found["ramps"] = lambda: ramps(2000 * more)
    found["drilled"] = lambda: drilled(2400 * more)
    found["fins"] = lambda: fins(576 * more)
    found["wheel"] = lambda: wheel(2400 * more)
    found["plate"] = lambda: plate(1000 * more)
    return found


def measure(command):
    """Wall and CPU seconds, peak memory in MB, triangles."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.monotonic()
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    wall = time.monotonic() - start
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(command)}: exit {done.returncode}\n{done.stderr[-2000:]}")
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    text = done.stdout + done.stderr
    triangles = re.search(r"triangles\s+([\d \u202f\u00a0]+?)\s{2}", text)
    memory = re.search(r"memory\s+([\d.]+) MB", text)
    return wall, cpu, memory.group(1) if memory else "-", triangles.group(1).strip() if triangles else "-"


def command_of(args, program, path, voxel, out):
    with open(path, "w", encoding="ascii") as file:
        file.write(program.text())
    command = [args.mrsim, path, *program.options(), "--verbose", "-o", out]
    return command if voxel == "default" else command + ["--voxel", voxel]


def print_times(args, folder, out):
    print("| program | moves | wall, s | CPU, s | MB | triangles |\n|---|---|---|---|---|---|")
    for name, make in programs().items():
        if not name.startswith(args.only):
            continue
        program = make()
        command = command_of(args, program, os.path.join(folder, name + ".nc"), args.voxel, out)
        runs = [measure(command) for _ in range(args.runs)]
        wall, cpu = (statistics.median(r[k] for r in runs) for k in (0, 1))
        print(f"| {name} | {program.moves} | {wall:.2f} | {cpu:.2f} | {runs[0][2]} | {runs[0][3]} |", flush=True)


def print_growth(args, folder, out):
    """CPU seconds: of ten times the moves, and of a voxel four times as coarse, each over that of the program itself."""
    coarse = f"{4 * float(args.voxel):g}"
    print(f"| program | CPU, s | ten times the moves | voxel {coarse} |\n|---|---|---|---|")
    tenfold = programs(10)
    for name, make in programs().items():
        if not name.startswith(args.only) or name.endswith("-x10"):
            continue
        path = os.path.join(folder, name + ".nc")
        found = []
        for program, voxel in ((make(), args.voxel), (tenfold[name](), args.voxel), (make(), coarse)):
            command = command_of(args, program, path, voxel, out)
            found.append(statistics.median(measure(command)[1] for _ in range(args.runs)))
        print(f"| {name} | {found[0]:.2f} | {found[1] / found[0]:.2f} x | {found[2] / found[0]:.2f} x |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mrsim")
    parser.add_argument("--voxel", default="0.25", help="mm, or 'default'")
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--only", default="", help="programs whose names begin so")
    parser.add_argument("--keep", help="folder for the programs")
    parser.add_argument("--growth", action="store_true", help="print how CPU time grows with moves and voxel")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = args.keep or scratch
        os.makedirs(folder, exist_ok=True)
        (print_growth if args.growth else print_times)(args, folder, os.path.join(scratch, "part.stl"))


if __name__ == "__main__":
    main()
