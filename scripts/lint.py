#!/usr/bin/env python3
"""clang-tidy's short list (.clang-tidy) on the sources of src: lint.py [SOURCE...]

Up to 40 sources of a stage are joined into one, so that the headers are read once: all of src takes as long as a tenth of it one by one.
So a name that two sources of a stage define, each for itself, is an error here: it means two things, or one thing has two homes. Left
out, unless they are named: sources that are little but headers of OpenVDB, CGAL, OpenMesh or Eigen. A minute and a half on two cores.
"""

import concurrent.futures
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.realpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
TOOL = shutil.which("clang-tidy-14") or "clang-tidy"
HEAVY = re.compile(r"#include <(openvdb|CGAL|OpenMesh|Eigen|BRep|STEP)")
MOST = 40  # sources of a join


def flags_of_sources(folder):
    """Source, from the root -> its compiler flags, as text, by a build that joins none."""
    subprocess.run(["cmake", "--preset", "sources", "-B", folder], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    found = {}
    with open(os.path.join(folder, "compile_commands.json"), encoding="utf-8") as file:
        for entry in json.load(file):
            words = shlex.split(entry["command"])
            found[os.path.relpath(entry["file"], ROOT)] = shlex.join(words[1:words.index("-o")])
    return found


def is_light(source):
    with open(os.path.join(ROOT, source), encoding="utf-8") as file:
        return not HEAVY.search(file.read())


def joins(sources, flags):
    """Lists of at most MOST sources of one stage that have the same flags."""
    groups = {}
    for source in sorted(sources):
        stage = source.split("/")[1] if source.count("/") > 1 else ""
        groups.setdefault((stage, flags[source]), []).append(source)
    for (_, words), group in groups.items():
        count = -(-len(group) // MOST)
        for k in range(count):
            yield group[k * len(group) // count:(k + 1) * len(group) // count], shlex.split(words)


def lint(sources, words, folder):
    """The findings in these sources, joined, as clang-tidy prints them."""
    with tempfile.NamedTemporaryFile("w", suffix=".cpp", dir=folder, delete=False, encoding="utf-8") as file:
        file.writelines(f'#include "{ROOT}/{source}"\n' for source in sources)
    result = subprocess.run([TOOL, file.name, "--quiet", f"--config-file={ROOT}/.clang-tidy", "--", *words],
                            cwd=folder, capture_output=True, text=True, check=False)
    if result.returncode != 0 and not result.stdout:
        raise RuntimeError(result.stderr)
    return result.stdout


def main():
    wanted = [os.path.relpath(path, ROOT) for path in sys.argv[1:]]
    with tempfile.TemporaryDirectory() as folder:
        flags = flags_of_sources(folder)
        unknown = [source for source in wanted if source not in flags]
        if unknown:
            sys.exit(f"no source of the build: {unknown[0]}")
        sources = wanted or [s for s in flags if s.startswith("src/") and "/step/" not in s and is_light(s)]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            found = list(pool.map(lambda join: lint(*join, folder), joins(sources, flags)))
    print("".join(found))
    count = sum(len(re.findall(r": (?:error|warning): ", text)) for text in found)
    print(f"{len(sources)} sources, {count} findings")
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
