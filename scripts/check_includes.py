#!/usr/bin/env python3
"""Checks who includes whom: the stages of the pipeline know only what lies before them.

Each folder of src (a stage, or a room of one) lists in ROOMS the folders that it may include: earlier ones only.
Third-party headers stay in the few files that need them. Exit 1 and one line a breach.
"""

import os
import re
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)

# Folder of src -> the other folders (or single headers of them) that its files may include; each folder may include itself.
# Stages and rooms come in the order of the pipeline: a folder may name earlier ones only, so there are no circles.
CORE = ("core/",)
LANGUAGE = CORE + ("interp/text/", "interp/comments/", "interp/path/", "interp/language/")
CONTROL = LANGUAGE + ("interp/control/",)
WORDS = CONTROL + ("interp/frames/", "interp/tools/", "interp/moves/", "interp/words/")
CYCLES = WORDS + ("interp/calls/", "interp/statements/", "interp/cycles/")
SOLID = CORE + ("removal/field/",)
FORMS = SOLID + ("removal/tool/", "removal/simd/")
SWEEPS = FORMS + ("removal/forms/", "removal/columns/", "removal/sweep/")
SURFACE = SOLID + ("mesh/solid/", "mesh/points/", "mesh/cells/")
ROOMS = {
    "core": (),
    "interp/text": CORE,
    "interp/comments": CORE + ("interp/text/",),
    "interp/path": CORE + ("interp/text/",),
    "interp/language": CORE + ("interp/text/", "interp/comments/", "interp/path/"),
    "interp/recognise": CORE + ("interp/text/", "interp/comments/", "interp/language/"),
    "interp/show": CORE + ("interp/text/", "interp/path/"),
    "interp/control": LANGUAGE,
    "interp/frames": CONTROL,
    "interp/tools": CONTROL,
    "interp/moves": CONTROL + ("interp/frames/", "interp/tools/"),
    "interp/words": CONTROL + ("interp/frames/", "interp/tools/", "interp/moves/"),
    "interp/calls": CONTROL,
    "interp/statements": WORDS + ("interp/calls/",),
    "interp/cycles": WORDS + ("interp/calls/",),
    "interp/drilling": WORDS + ("interp/calls/", "interp/cycles/"),
    "interp/milling": CYCLES,
    "interp/turning": CYCLES,
    "interp/sinumerik": CYCLES + ("interp/drilling/", "interp/milling/", "interp/turning/"),
    "interp": CORE + ("interp/",),
    "timing": CORE,
    "setup": CORE,
    "removal/field": CORE,
    "removal/tool": CORE + ("removal/field/",),
    "removal/simd": CORE + ("removal/field/", "removal/tool/"),
    "removal/stock": CORE + ("removal/field/",),
    "removal/forms": FORMS,
    "removal/columns": FORMS + ("removal/forms/",),
    "removal/sweep": FORMS + ("removal/forms/", "removal/columns/"),
    "removal/prune": SWEEPS,
    "removal/part": SWEEPS + ("removal/stock/", "removal/prune/"),
    "removal/collision": SWEEPS + ("removal/prune/", "removal/part/"),
    "removal/history": SWEEPS + ("removal/stock/", "removal/prune/", "removal/part/"),
    "removal/vdb": CORE + ("removal/",),
    "mesh/solid": SOLID,
    "mesh/draw": SOLID + ("mesh/solid/",),
    "mesh/format": SOLID + ("mesh/solid/", "mesh/draw/"),
    "mesh/points": SOLID + ("mesh/solid/",),
    "mesh/cells": SOLID + ("mesh/solid/", "mesh/points/"),
    "mesh/surface": SURFACE,
    "mesh/simplify": SURFACE + ("mesh/surface/",),
    "mesh/tiles": SURFACE + ("mesh/surface/",),
    "mesh/turned": SURFACE,
    "mesh/reduce": SOLID + ("mesh/solid/",),
    "mesh": SURFACE + ("mesh/surface/", "mesh/simplify/", "mesh/tiles/", "mesh/turned/", "removal/part/stock.h"),
    "compare/step": CORE + ("mesh/",),
    "compare": CORE + ("mesh/", "compare/step/"),
    "cli": CORE,
    "": ("core/", "interp/", "timing/", "setup/", "removal/", "mesh/", "compare/"),
}
# What tests of a stage may include besides its own rooms.
TESTED = {"core": CORE, "interp": CORE + ("interp/",), "timing": CORE + ("timing/",), "setup": CORE + ("setup/",), "removal": CORE + ("removal/",),
          "mesh": CORE + ("mesh/", "removal/"), "compare": CORE + ("mesh/", "compare/"), "cli": CORE + ("cli/",)}
STAGES = set(TESTED)

# Functions of the facade that a stage defines itself.
FACADE_PARTS = {"src/interp/show/motion_text.h", "src/interp/show/path_picture.h"}

# Third-party header prefix -> files that may include it (regular expressions on the path).
THIRD_PARTY = {
    "openvdb/": r"src/removal/vdb/.*|tests/(removal|mesh|reference)/.*|bench/mesh_bench\.cpp",
    "CGAL/": r"src/mesh/solid/(solid_repair|wrap)\.cpp|tests/.*|bench/compare_bench\.cpp",
    "OpenMesh/": r"src/mesh/reduce/decimation\.cpp|tests/.*",
    "tbb/": r"src/core/parallel\.cpp|tests/.*|bench/.*",
    "oneapi/": r"src/core/parallel\.cpp|tests/.*|bench/.*",
    "embree3/": r"src/(mesh/draw|compare)/[^/]*\.cpp",
    "STEPControl_": r"src/compare/step/.*|tests/(compare|cli)/.*",
    "BRep": r"src/compare/step/.*|tests/(compare|cli)/.*",
    "png.h": r"src/mesh/draw/[^/]*\.cpp|tests/mesh/.*",
    "CLI/": r"src/cli/typed_options\.cpp",
    "toml++/": r"src/setup/([^/]*\.cpp|toml_text\.h)",
    "zlib.h": r"src/core/zip\.cpp|src/mesh/.*|tests/.*",
}
# Public header -> the public headers that it may include.
PUBLIC = {"events.h": set(), "types.h": {"events.h"}, "files.h": set(), "memory.h": {"types.h"}, "options.h": {"types.h"}, "collisions.h": {"types.h"}, "solid_files.h": {"types.h", "options.h", "compare.h"},
          "play.h": {"types.h"}, "mrsim.h": {"files.h", "types.h", "options.h", "collisions.h", "cycle_time.h", "history.h", "play.h"}, "job_file.h": {"types.h"},
          "compare.h": {"types.h", "options.h", "cycle_time.h", "play.h"}, "cycle_time.h": {"types.h"}, "history.h": {"types.h", "cycle_time.h"},
          "rest.h": {"types.h", "options.h"}}


def files(*folders):
    for folder in folders:
        for place, _, names in os.walk(os.path.join(ROOT, folder)):
            for name in sorted(names):
                if name.endswith((".h", ".cpp", ".inl")):
                    yield os.path.relpath(os.path.join(place, name), ROOT)


def room_of(path):
    """The folder of src that holds a file, by its key in ROOMS."""
    return os.path.dirname(path)[len("src/"):] if os.path.dirname(path) != "src" else ""


def own_headers_allowed(path):
    parts = path.split(os.sep)
    if parts[0] == "src":
        return ROOMS.get(room_of(path))
    if parts[0] == "tests" and parts[1] in TESTED:
        return TESTED[parts[1]] + ("support/", parts[1] + "/")
    return None  # benches, fuzz targets and helpers of tests may see all


def may_include(path, header, allowed):
    if header.startswith(allowed):
        return True
    if path.startswith("src/"):
        return os.path.dirname(header) == room_of(path)
    return os.path.exists(os.path.join(ROOT, os.path.dirname(path), header))  # a test's helper beside it


def check(path, breaches):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        included = INCLUDE.findall(file.read())
    allowed = own_headers_allowed(path)
    if path.startswith("src/") and allowed is None:
        breaches.append(f"{path}: its folder is missing in ROOMS of scripts/check_includes.py")
        return
    for header in included:
        for prefix, where in THIRD_PARTY.items():
            if header.startswith(prefix) and not re.fullmatch(where, path):
                breaches.append(f"{path}: <{header}> is not allowed here")
        if header.startswith("mrsim/"):
            if header == "mrsim/mrsim.h" and path not in FACADE_PARTS and re.match(
                    r"src/(core|interp|timing|setup|removal|mesh|compare)/", path):
                breaches.append(f"{path}: a stage must not include the facade")
            continue
        ours = header.split("/")[0] in STAGES or os.path.exists(os.path.join(ROOT, "src", header))
        if ours and allowed is not None and not may_include(path, header, allowed):
            breaches.append(f'{path}: "{header}" is not allowed here')


def check_order(breaches):
    """Rooms that a room may include stand before it in ROOMS; "x/" names the room x and all that begin with it."""
    order = list(ROOMS)
    for index, (room, allowed) in enumerate(ROOMS.items()):
        for prefix in allowed:
            rooms = [k for k in range(len(order)) if (order[k] + "/").startswith(prefix) and k != index]
            if any(k > index for k in rooms):
                breaches.append(f'{room}: "{prefix}" comes later in ROOMS of scripts/check_includes.py')


def check_public(breaches):
    for name in sorted(os.listdir(os.path.join(ROOT, "include", "mrsim"))):
        others = PUBLIC.get(name)
        if others is None:
            breaches.append(f"include/mrsim/{name}: missing in PUBLIC of scripts/check_includes.py")
            continue
        path = os.path.join("include", "mrsim", name)
        with open(os.path.join(ROOT, path), encoding="utf-8") as file:
            for header in INCLUDE.findall(file.read()):
                ours = header.startswith("mrsim/")
                if (ours and header[6:] not in others) or (not ours and not re.fullmatch(r"[a-z_0-9]+", header)):
                    breaches.append(f"{path}: <{header}> is not allowed in a public header")


def main():
    breaches = []
    count = 0
    for path in files("src", "tests", "bench", "include"):
        count += 1
        check(path, breaches)
    check_order(breaches)
    check_public(breaches)
    for breach in breaches:
        print(breach)
    print(f"{count} files, {len(breaches)} breaches of the include rule")
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main())
