#!/usr/bin/env python3
"""clang-tidy's short list (.clang-tidy) on the sources of src: lint.py [--since COMMIT] [SOURCE...]

Up to 40 sources of a stage are joined into one, so that the headers are read once: all of src takes as long as a tenth of it one by one.
So a name that two sources of a stage define, each for itself, is an error here: it means two things, or one thing has two homes. Left
out, unless they are named: sources that are little but headers of OpenVDB, CGAL, OpenMesh or Eigen. A minute and a half on two cores.
--since: only those that have changed since then, or include a header that has; all where git does not know COMMIT, or the list has changed.
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

from check_sources import Includes, differences

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


def changed_since(commit):
    """Sources of src that have changed since then, and those that include a changed header; None = any."""
    changed = differences("--name-only", commit, "--", "src", "include", ".clang-tidy")
    if changed is None or ".clang-tidy" in changed:
        return None
    files, includes = set(changed.split()), Includes()
    todo = [name for name in files if not name.endswith(".cpp")]
    while todo:
        users = includes.users.get(re.sub("^(src|include)/", "", todo.pop()), set()) - files
        files |= users
        todo += [name for name in users if name.startswith("include/")]  # public headers stand for those that they include
    return files


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
    words = sys.argv[1:]
    changed = None
    if words[:1] == ["--since"]:
        changed = changed_since(words[1])
        words = words[2:]
    wanted = [os.path.relpath(path, ROOT) for path in words]
    with tempfile.TemporaryDirectory() as folder:
        flags = flags_of_sources(folder)
        unknown = [source for source in wanted if source not in flags]
        if unknown:
            sys.exit(f"no source of the build: {unknown[0]}")
        sources = wanted or [s for s in flags if s.startswith("src/") and "/step/" not in s and is_light(s)]
        if changed is not None:
            sources = [source for source in sources if source in changed]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            found = list(pool.map(lambda join: lint(*join, folder), joins(sources, flags)))
    print("".join(found))
    count = sum(len(re.findall(r": (?:error|warning): ", text)) for text in found)
    print(f"{len(sources)} sources, {count} findings")
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
