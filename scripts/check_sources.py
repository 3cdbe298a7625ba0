#!/usr/bin/env python3
"""Compiles each source of src by itself, for its syntax alone: check_sources.py [--since COMMIT] [SOURCE...]

Builds that join sources (MRSIM_UNITY) hide a missing include behind the include of a neighbour. Sources that the build folder (BUILD=folder,
default build) compiles by themselves are left out, unless they are named. --since: only those in which it can be missing since then, which
have changed or include, directly or not, a header that has lost a line; all where git does not know COMMIT.
Two seconds of a core for each.
"""

import concurrent.futures
import json
import os
import re
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


def differences(*words):
    """What git prints of the differences; None where it does not know the commit."""
    result = subprocess.run(["git", "diff", *words], cwd=ROOT, capture_output=True, text=True, check=False)
    return result.stdout if result.returncode == 0 else None


def includers(headers):
    """Files of src and include that include one of these, directly or not."""
    direct = {}
    for folder, _, names in (step for top in ("src", "include") for step in os.walk(os.path.join(ROOT, top))):
        for name in names:
            path = os.path.relpath(os.path.join(folder, name), ROOT)
            with open(os.path.join(ROOT, path), encoding="utf-8") as file:
                for included in re.findall(r'^#include ["<]([^">]+)[">]', file.read(), re.M):
                    direct.setdefault(included, set()).add(path)
    found, todo = set(), list(headers)
    while todo:
        header = re.sub("^(src|include)/", "", todo.pop())
        fresh = direct.get(header, set()) - found
        found |= fresh
        todo += fresh
    return found


def doubtful_since(commit):
    """Sources in which an include can be missing since then; None = any."""
    changed = differences("--name-only", commit, "--", "src")
    if changed is None:
        return None
    lost = [file for file in differences("--name-only", commit, "--", "*.h", "*.inl").split()
            if re.search("^-([^-]|$)", differences("-U0", commit, "--", file), re.M)]
    return set(changed.split()) | includers(lost)


def main():
    words = sys.argv[1:]
    since = words[1] if words[:1] == ["--since"] else None
    wanted = {os.path.relpath(path, ROOT) for path in (words[2:] if since else words)}
    done = set() if wanted else compiled_alone()
    doubtful = doubtful_since(since) if since else None
    with tempfile.TemporaryDirectory() as folder:
        found = {source: (words, where) for source, words, where in commands(folder)
                 if source.startswith("src/") and source not in done and (not wanted or source in wanted)
                 and (doubtful is None or source in doubtful)}
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
    return 1 if faults or not (found or since) else 0


if __name__ == "__main__":
    sys.exit(main())
