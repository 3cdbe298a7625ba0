#!/usr/bin/env python3
"""Checks who includes whom: the stages of the pipeline know only what lies before them.

The rule (ARCHITECTURE.md): core -> public types; interp, setup, removal -> core; mesh -> core and the
stock's public face; compare -> core, mesh; the pipeline (src/*.cpp) -> all; cli -> public headers and
core. Third-party headers stay in the few files that need them. Exit 1 and one line a breach.
"""

import os
import re
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)

# Folder of src -> prefixes of our own headers that its files may include.
STAGES = {
    "core": ("core/",),
    "interp": ("core/", "interp/"),
    "setup": ("core/", "setup/"),
    "removal": ("core/", "removal/"),
    "mesh": ("core/", "mesh/", "removal/stock.h", "removal/sweep.h", "removal/field.h", "removal/lattice.h"),
    "compare": ("core/", "compare/", "mesh/"),
    "cli": ("core/", "cli/"),
    "": ("core/", "interp/", "setup/", "removal/", "mesh/", "compare/", "cuts.h", "outputs.h", "part_mesh.h", "collision_findings.h",
         "voxel_module.h"),
}
# Exceptions to the rule above.
PRIVATE = {}

# Functions of the facade that a stage defines itself.
FACADE_PARTS = {"src/interp/motion_text.h", "src/interp/path_picture.h"}

# Third-party header prefix -> files that may include it (regular expressions on the path).
THIRD_PARTY = {
    "openvdb/": r"src/removal/vdb/.*|tests/(removal|mesh|reference)/.*|bench/mesh_bench\.cpp",
    "CGAL/": r"src/(removal|mesh|compare)/[^/]*\.cpp|tests/.*|bench/compare_bench\.cpp",
    "OpenMesh/": r"src/mesh/[^/]*\.cpp|tests/.*",
    "tbb/": r"src/core/parallel\.cpp|tests/.*|bench/.*",
    "oneapi/": r"src/core/parallel\.cpp|tests/.*|bench/.*",
    "embree3/": r"src/(mesh|compare)/[^/]*\.cpp",
    "STEPControl_": r"src/compare/step/module\.cpp|tests/(compare|cli)/.*",
    "BRep": r"src/compare/step/module\.cpp|tests/(compare|cli)/.*",
    "png.h": r"src/mesh/[^/]*\.cpp|tests/mesh/.*",
    "CLI/": r"src/cli/[^/]*\.cpp",
    "toml++/": r"src/setup/[^/]*\.cpp",
}
PUBLIC = {"types.h": set(), "options.h": {"types.h"}, "collisions.h": {"types.h"},
          "mrsim.h": {"types.h", "options.h", "collisions.h"},
          "compare.h": {"types.h", "options.h"}}


def files(*folders):
    for folder in folders:
        for place, _, names in os.walk(os.path.join(ROOT, folder)):
            for name in sorted(names):
                if name.endswith((".h", ".cpp", ".inl")):
                    yield os.path.relpath(os.path.join(place, name), ROOT)


def own_headers_allowed(path):
    parts = path.split(os.sep)
    if parts[0] == "src":
        return STAGES.get(parts[1] if len(parts) > 2 else "", ())
    if parts[0] == "tests" and parts[1] in STAGES:
        return STAGES[parts[1]] + ("support/", parts[1] + "/", "removal/stock_grid.h", "removal/part_field.h")
    return None  # benches, fuzz targets and helpers of tests may see all


def check(path, breaches):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        included = INCLUDE.findall(file.read())
    allowed = own_headers_allowed(path)
    for header in included:
        for prefix, where in THIRD_PARTY.items():
            if header.startswith(prefix) and not re.fullmatch(where, path):
                breaches.append(f"{path}: <{header}> is not allowed here")
        if header.startswith("mrsim/"):
            if path in FACADE_PARTS:
                continue
            if header == "mrsim/mrsim.h" and re.match(r"src/(core|interp|setup|removal|mesh|compare)/", path):
                breaches.append(f"{path}: a stage must not include the facade")
            continue
        stage = header.split("/")[0]
        ours = stage in STAGES or os.path.exists(os.path.join(ROOT, "src", header))
        if not ours or allowed is None:
            continue
        if not header.startswith(allowed) and header not in PRIVATE.get(path, ()):
            if os.path.exists(os.path.join(ROOT, os.path.dirname(path), header)):
                continue  # a header beside the file, such as a test's helper
            breaches.append(f'{path}: "{header}" is not allowed here')


def check_public(breaches):
    for name, others in PUBLIC.items():
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
    check_public(breaches)
    for breach in breaches:
        print(breach)
    print(f"{count} files, {len(breaches)} breaches of the include rule")
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main())
