#!/usr/bin/env python3
"""Whole runs of mrsim beside FreeCAD's PathSimulator: freecad_times.py MRSIM [--grid 0.25] [--runs 3] [--only NAME] [--programs FOLDER]

Runs each class of class_times.py, and each FOLDER/NAME.nc with its arguments (--stock box:..., --tool 1=...) in NAME.args, by both,
one after the other, and prints wall and CPU seconds of the whole processes (medians) and their ratios. FreeCAD's part is its height map on
a grid of as many mm as mrsim's voxels: BeginSimulation, SetToolShape, ApplyCommand for each motion, GetResultMesh; it has one tool, no
undercuts and no exact walls. Needs Debian's package freecad-python3.
"""

import argparse
import math
import os
import re
import resource
import shlex
import statistics
import subprocess
import sys
import tempfile
import time

import class_times

LIBRARIES = ("/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib")
TOOL_HEIGHT = 60.0  # mm


def words_of(spec):
    """`endmill:d=2.5` as its type and its sizes in mm and degrees."""
    kind, _, sizes = spec.partition(":")
    return kind, {key: float(value) for key, value in (word.split("=") for word in sizes.split(",") if word)}


def tool_shape(spec):
    """A solid with its tip at the origin: the profile in (r, z), revolved about Z."""
    import FreeCAD
    import Part

    kind, size = words_of(spec)
    radius, top = size.get("d", 1) / 2, TOOL_HEIGHT
    point = lambda r, z: FreeCAD.Vector(r, 0, z)
    edges, at = [], point(0, 0)

    def line(r, z):
        nonlocal at
        edges.append(Part.makeLine(at, point(r, z)))
        at = point(r, z)

    def arc(center, corner, start, end):
        nonlocal at
        on = lambda a: point(center + corner * math.cos(a), corner + corner * math.sin(a))
        edges.append(Part.Arc(on(start), on((start + end) / 2), on(end)).toShape())
        at = on(end)

    if kind in ("chamfer", "drill"):
        line(radius, radius / math.tan(math.radians(size.get("a", 90)) / 2))
    elif kind == "taper":
        lean, corner = math.radians(size["a"]), size.get("r", 0)
        if corner:
            arc(max(0.0, radius - corner), corner, -math.pi / 2, -lean)
        else:
            line(radius, 0)
        top = size.get("l", 20)
        line(at.x + (top - at.z) * math.tan(lean), top)
    else:
        corner = radius if kind == "ballmill" else size.get("r", 0)
        if radius > corner:
            line(radius - corner, 0)
        if corner:
            arc(radius - corner, corner, -math.pi / 2, 0)
    if at.z < top:
        line(at.x, top)
    line(0, top)
    line(0, 0)
    face = Part.Face(Part.Wire(edges))
    return face.revolve(FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(0, 0, 1), 360)


def commands_of(path):
    """The motions of a program in plain G0 to G3."""
    import Path

    word, at = "G0", {}
    for text in open(path, encoding="ascii", errors="replace"):
        text = re.sub(r"\(.*?\)|;.*", "", text)
        words = [(letter, float(value)) for letter, value in re.findall(r"([A-Z])\s*(-?[\d.]+)", text)]
        for letter, value in words:
            if letter == "G" and value in (0, 1, 2, 3):
                word = f"G{value:.0f}"
        to = {letter: value for letter, value in words if letter in "XYZIJ"}
        if any(letter in to for letter in "XYZ"):
            at.update({letter: to[letter] for letter in "XYZ" if letter in to})
            yield Path.Command(word, {**at, **{k: to.get(k, 0.0) for k in ("I", "J") if word in ("G2", "G3")}})


def simulate(path, stock, spec, grid):
    """What FreeCAD's own panel does, without the panel."""
    sys.path += LIBRARIES
    import FreeCAD
    import Part
    import Path  # noqa: F401  (PathSimulator needs it)
    import PathSimulator

    low = FreeCAD.Vector(*stock[:3])
    size = [b - a for a, b in zip(stock[:3], stock[3:])]
    simulator = PathSimulator.PathSim()
    simulator.BeginSimulation(Part.makeBox(*size, low), grid)
    shape = tool_shape(spec)
    try:
        simulator.SetToolShape(shape, grid)
    except TypeError:
        simulator.SetToolShape(shape)
    place = FreeCAD.Placement(FreeCAD.Vector(stock[0], stock[1], stock[5] + 20), FreeCAD.Rotation())
    count = 0
    for command in commands_of(path):
        place = simulator.ApplyCommand(place, command)
        count += 1
    outer, inner = simulator.GetResultMesh()
    print(f"{count} motions, {outer.CountFacets + inner.CountFacets} triangles")


def seconds(command, runs):
    """Medians of wall and CPU time."""
    found = []
    for _ in range(runs):
        before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        wall, after = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
        if done.returncode != 0:
            raise SystemExit(f"{shlex.join(command)}: exit {done.returncode}\n{done.stderr[-2000:]}")
        found.append((wall, after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime))
    return [statistics.median(times) for times in zip(*found)]


def cases(args, scratch):
    """Name, program, stock and tool of each case of one tool: FreeCAD's height map has one."""
    for name, make in class_times.programs().items():
        program = make()
        if len(program.tools) > 1:
            continue
        path = os.path.join(scratch, name + ".nc")
        with open(path, "w", encoding="ascii") as out:
            out.write(program.text())
        yield name, path, program.stock, program.tools[0]
    for file in sorted(os.listdir(args.programs)) if args.programs else []:
        if file.endswith(".args"):
            words = shlex.split(open(os.path.join(args.programs, file), encoding="ascii").read())
            if words.count("--tool") == 1 and "--stock" in words:
                stock, tool = words[words.index("--stock") + 1], words[words.index("--tool") + 1]
                yield file[:-5], os.path.join(args.programs, file[:-5] + ".nc"), stock, tool.partition("=")[2]


def main():
    if sys.argv[1:2] == ["--simulate"]:
        path, stock, spec, grid = sys.argv[2:6]
        return simulate(path, [float(x) for x in stock.split(":")[1].split(",")], spec, float(grid))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mrsim")
    parser.add_argument("--grid", default="0.25", help="mm")
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--only", default="", help="programs whose names begin so")
    parser.add_argument("--programs", help="folder with NAME.nc and NAME.args")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        print("| program | FreeCAD: wall, CPU, s | mrsim: wall, CPU, s | ratio: wall, CPU |\n|---|---|---|---|")
        for name, path, stock, tool in cases(args, scratch):
            if not name.startswith(args.only):
                continue
            theirs = seconds([sys.executable, __file__, "--simulate", path, stock, tool, args.grid], args.runs)
            ours = seconds([args.mrsim, path, "--stock", stock, "--tool", "1=" + tool, "--voxel", args.grid, "-o",
                            os.path.join(scratch, "part.stl")], args.runs)
            pairs = [theirs, ours, [b / a for a, b in zip(theirs, ours)]]
            print(f"| {name} | " + " | ".join(f"{wall:.2f}, {cpu:.2f}" for wall, cpu in pairs) + " |", flush=True)
    return None


if __name__ == "__main__":
    main()
