#!/usr/bin/env python3
"""Compiles each source of src by itself, for its syntax alone: check_sources.py [SOURCE...]

Builds that join sources (MRSIM_UNITY) hide a missing include behind the include of a neighbour. Sources that the build folder (BUILD=folder,
default build) compiles by themselves are left out, unless they are named.
Two minutes on two cores.
"""

import concurrent.futures
import json
import os
import shlex
import subprocess
import sys
import tempfile

ROOT = os.path.realpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))


def commands(folder):
    """(source, its command without an output) of each source of the library and the program."""
    subprocess.run(["cmake", "--preset", "sources", "-B", folder], cwd=ROOT, check=True,
                   stdout=subprocess.DEVNULL)
    with open(os.path.join(folder, "compile_commands.json"), encoding="utf-8") as file:
        for entry in json.load(file):
            words = shlex.split(entry["command"])
            out = words.index("-o")
            del words[out:out + 2]
            words = [w for w in words if w not in ("-c", "-O2", "-O3")]
            yield os.path.relpath(entry["file"], ROOT), words + ["-fsyntax-only"], entry["directory"]


def compiled_alone():
    """Sources that the build folder does not join."""
    path = os.path.join(ROOT, os.environ.get("BUILD", "build"), "compile_commands.json")
    if not os.path.exists(path):
        return set()
    with open(path, encoding="utf-8") as file:
        return {os.path.relpath(entry["file"], ROOT) for entry in json.load(file)}


def main():
    wanted = {os.path.relpath(path, ROOT) for path in sys.argv[1:]}
    done = set() if wanted else compiled_alone()
    with tempfile.TemporaryDirectory() as folder:
        found = {source: (words, where) for source, words, where in commands(folder)
                 if source.startswith("src/") and source not in done and (not wanted or source in wanted)}
        def compiled(source):
            words, where = found[source]
            return source, subprocess.run(words, cwd=where, capture_output=True, text=True, check=False)
        faults = 0
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            for source, result in pool.map(compiled, sorted(found)):
                if result.returncode != 0:
                    faults += 1
                    print(f"{source} does not compile by itself\n{result.stderr}")
    print(f"{len(found)} sources, {faults} faults")
    return 1 if faults or not found else 0


if __name__ == "__main__":
    sys.exit(main())
