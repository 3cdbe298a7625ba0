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
# Stages and rooms come in the order of the pipeline: a folder may name earlier ones only, so there are no circles. A folder
# that no include uses is a breach, too; core/ alone is open to all later stages.
CORE = ("core/",)
ROOMS = {
    "core/process": (),
    "core/numbers": ("core/process/",),
    "core/output": ("core/process/", "core/numbers/"),
    "core/text": ("core/process/", "core/output/"),
    "core/words": ("core/text/",),
    "interp/text": CORE,
    "interp/comments": CORE + ("interp/text/",),
    "interp/path": CORE + ("interp/text/",),
    "interp/language": CORE + ("interp/text/", "interp/comments/", "interp/path/"),
    "interp/recognise": CORE + ("interp/text/", "interp/comments/", "interp/language/"),
    "interp/show": CORE + ("interp/text/", "interp/path/"),
    "interp/control": CORE + ("interp/text/", "interp/path/"),
    "interp/frames": CORE + ("interp/text/code_table.h", "interp/control/"),
    "interp/tools": CORE + ("interp/text/", "interp/comments/", "interp/path/", "interp/control/"),
    "interp/moves": CORE + ("interp/text/", "interp/path/", "interp/control/", "interp/frames/", "interp/tools/"),
    "interp/words": CORE + ("interp/text/", "interp/comments/", "interp/control/", "interp/frames/", "interp/tools/",
        "interp/moves/"),
    "interp/calls": CORE + ("interp/text/", "interp/language/", "interp/control/"),
    "interp/statements": CORE + ("interp/text/", "interp/path/", "interp/language/", "interp/control/",
        "interp/frames/", "interp/tools/", "interp/words/", "interp/calls/"),
    "interp/cycles": CORE + ("interp/path/", "interp/language/", "interp/tools/", "interp/moves/", "interp/calls/"),
    "interp/drilling": CORE + ("interp/words/", "interp/cycles/"),
    "interp/milling": CORE + ("interp/path/", "interp/frames/", "interp/statements/", "interp/cycles/"),
    "interp/turning": CORE + ("interp/text/code_table.h", "interp/path/", "interp/tools/", "interp/moves/", "interp/statements/",
        "interp/cycles/"),
    "interp/sinumerik": CORE + ("interp/text/", "interp/path/", "interp/control/", "interp/frames/", "interp/tools/",
        "interp/moves/", "interp/words/", "interp/statements/", "interp/cycles/", "interp/milling/",
        "interp/turning/"),
    "interp": CORE + ("interp/",),
    "timing": CORE,
    "setup": CORE,
    "removal/field": CORE,
    "removal/tool": CORE,
    "removal/simd": CORE + ("removal/field/", "removal/tool/"),
    "removal/stock": CORE + ("removal/field/",),
    "removal/forms": CORE + ("removal/field/", "removal/tool/", "removal/simd/"),
    "removal/columns": CORE + ("removal/tool/", "removal/simd/", "removal/forms/"),
    "removal/sweep": CORE + ("removal/field/", "removal/tool/", "removal/simd/", "removal/forms/", "removal/columns/"),
    "removal/prune": CORE + ("removal/simd/", "removal/columns/", "removal/sweep/"),
    "removal/part": CORE + ("removal/field/", "removal/tool/", "removal/simd/", "removal/stock/", "removal/forms/",
        "removal/columns/", "removal/sweep/", "removal/prune/"),
    "removal/collision": CORE + ("removal/field/", "removal/tool/", "removal/forms/", "removal/sweep/",
        "removal/part/"),
    "removal/history": CORE + ("removal/field/", "removal/tool/", "removal/simd/", "removal/stock/",
        "removal/columns/", "removal/sweep/", "removal/part/"),
    "removal/vdb": CORE + ("removal/field/", "removal/simd/", "removal/prune/", "removal/part/", "removal/history/"),
    "mesh/solid": CORE + ("removal/field/",),
    "mesh/draw": CORE + ("mesh/solid/",),
    "mesh/format": CORE + ("mesh/solid/", "mesh/draw/"),
    "mesh/points": CORE + ("removal/field/", "mesh/solid/"),
    "mesh/cells": CORE + ("removal/field/", "mesh/solid/", "mesh/points/"),
    "mesh/surface": CORE + ("removal/field/", "mesh/solid/", "mesh/points/", "mesh/cells/"),
    "mesh/simplify": CORE + ("removal/field/", "mesh/solid/", "mesh/points/", "mesh/cells/", "mesh/surface/"),
    "mesh/tiles": CORE + ("removal/field/", "mesh/solid/", "mesh/cells/", "mesh/surface/"),
    "mesh/turned": CORE + ("removal/field/", "mesh/solid/", "mesh/points/", "mesh/cells/"),
    "mesh/reduce": CORE + ("mesh/solid/",),
    "mesh": CORE + ("removal/field/", "mesh/solid/", "mesh/cells/", "mesh/surface/", "mesh/simplify/", "mesh/tiles/",
        "mesh/turned/", "removal/part/stock.h"),
    "compare/step": CORE,
    "compare/distance": CORE + ("mesh/solid/", "mesh/format/"),
    "compare/reach": CORE + ("compare/distance/",),
    "compare/blame": CORE + ("mesh/solid/", "compare/distance/"),
    "compare/report": CORE + ("mesh/solid/", "compare/distance/", "compare/blame/"),
    "compare": CORE + ("mesh/solid/", "compare/"),
    "cli/console": CORE,
    "cli/options": CORE + ("cli/console/",),
    "cli/report": CORE + ("cli/console/", "cli/options/"),
    "cli/commands": CORE + ("cli/console/", "cli/options/", "cli/report/"),
    "cli": CORE + ("cli/",),
    "run/files": CORE + ("removal/part/", "removal/vdb/", "mesh/solid/", "mesh/format/", "compare/distance/"),
    "run/tools": CORE + ("interp/comments/", "setup/", "removal/tool/", "mesh/draw/"),
    "run/cuts": CORE + ("interp/text/", "removal/tool/", "removal/part/", "removal/history/", "run/tools/"),
    "run/mesh": CORE + ("removal/field/", "removal/part/", "mesh/", "compare/distance/", "run/files/",
        "run/cuts/"),
    "run/findings": CORE + ("interp/text/", "removal/tool/", "removal/forms/", "removal/part/", "mesh/", "run/cuts/",
        "run/mesh/"),
    "": ("core/", "interp/", "setup/", "removal/", "mesh/", "compare/", "run/"),
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
    "tbb/": r"src/core/process/parallel\.cpp|tests/.*|bench/.*",
    "embree3/": r"src/mesh/draw/[^/]*\.cpp",
    "STEPControl_": r"src/compare/step/.*|tests/(compare|cli)/.*",
    "BRep": r"src/compare/step/.*|tests/(compare|cli)/.*",
    "png.h": r"src/mesh/draw/[^/]*\.cpp|tests/mesh/.*",
    "CLI/": r"src/cli/options/typed_options\.cpp",
    "toml++/": r"src/setup/([^/]*\.cpp|toml_text\.h)",
    "zlib.h": r"src/core/text/zip\.cpp|src/mesh/.*|tests/.*",
}
# Public header -> the public headers that it may include.
PUBLIC = {"geometry.h": set(), "diagnostics.h": set(), "tool.h": {"geometry.h"}, "tri_mesh.h": {"geometry.h"}, "events.h": set(),
          "types.h": {"geometry.h", "diagnostics.h", "tool.h", "tri_mesh.h", "events.h"},
          "files.h": set(), "memory.h": {"types.h"}, "options.h": {"types.h"}, "collisions.h": {"types.h"}, "solid_files.h": {"compare.h"},
          "play.h": {"types.h"}, "job.h": {"files.h", "types.h", "options.h", "cycle_time.h", "history.h"},
          "result.h": {"types.h", "collisions.h", "cycle_time.h", "history.h", "play.h"},
          "mrsim.h": {"files.h", "types.h", "options.h", "collisions.h", "cycle_time.h", "history.h", "job.h", "play.h", "result.h"}, "job_file.h": {"types.h"},
          "compare.h": {"types.h", "options.h"}, "report_html.h": {"compare.h", "types.h", "cycle_time.h", "play.h"},
          "cycle_time.h": {"types.h"}, "history.h": {"types.h", "cycle_time.h"}, "rest.h": {"types.h", "options.h"}}


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


def check(path, breaches, used):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        included = INCLUDE.findall(file.read())
    allowed = own_headers_allowed(path)
    if path.startswith("src/") and allowed is None:
        breaches.append(f"{path}: its folder is missing in ROOMS of scripts/check_includes.py")
        return
    for header in included:
        used.setdefault(room_of(path), set()).update(p for p in allowed or () if header.startswith(p))
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


def check_used(breaches, used):
    for room, allowed in ROOMS.items():
        for prefix in set(allowed) - set(CORE) - used.get(room, set()):
            breaches.append(f'{room}: no include uses "{prefix}" in ROOMS of scripts/check_includes.py')


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
    used = {}
    count = 0
    for path in files("src", "tests", "bench", "include"):
        count += 1
        check(path, breaches, used)
    check_used(breaches, used)
    check_order(breaches)
    check_public(breaches)
    for breach in breaches:
        print(breach)
    print(f"{count} files, {len(breaches)} breaches of the include rule")
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main())
