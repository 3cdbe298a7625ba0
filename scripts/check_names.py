#!/usr/bin/env python3
"""No two sources that are compiled together have an anonymous name in common, and no two classes or constants of the library one name; tests of threads say so.

Builds with MRSIM_UNITY join sources in groups, in which two equal names are one definition too many. Which sources share a
group changes with each new file, so an ordinary build does not show it. Configures such a build in a temporary folder (some
seconds) and reads its groups, compiles nothing. The preset tsan finds its tests by their names: those of the stages that run something on
several numbers of threads must have one that it finds. Exit 1 and one line a breach.
"""

import collections
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent

TYPE = re.compile(r"^(?:template <.*> *)?(?:class|struct|enum(?: class)?|union) (\w+)(?: final)?[^;]*\{")
ALIAS = re.compile(r"^using (\w+) = (.*)")
VALUE = re.compile(r"^(?:inline |static |thread_local |constexpr |constinit |const )+[\w:<>,&* ]*?(\w+)(?:\[\w*\])* *(?:=|\{|;)")
MORE = re.compile(r", *(k[A-Z]\w*) *(?:=|\{)")
FUNCTION = re.compile(r"^[\w:<>,&*~\[\] ]+?[ &*](\w+)\((.*)$")
TEST_BODY = re.compile(r"^TEST(?:_[FP])?\((\w+), (\w+)\) \{(.*?)^\}", re.M | re.S)
THREADS = re.compile(r"\bfor \([\w: ]*\bthreads : ")
TEST = re.compile(r"^(?:TEST|TEST_P|TEST_F)\((\w+, \w+)\)")


def without_comments(text):
    text = re.sub(r'R"(\w*)\((.*?)\)\1"', lambda m: '""' + "\n" * m.group(0).count("\n"), text, flags=re.S)
    return re.sub(r"//[^\n]*", "", text)


def parameters(lines, at, rest):
    """The lists of types that a function can be called with, none where no body follows."""
    text = rest
    while text.count("(") >= text.count(")"):
        at += 1
        if at == len(lines):
            return []
        text += " " + lines[at].strip()
    depth, end = 1, 0
    for end, char in enumerate(text):
        depth += {"(": 1, ")": -1}.get(char, 0)
        if depth == 0:
            break
    tail = text[end + 1 :] + " ".join(lines[at + 1 : at + 3])
    if "{" not in tail.split(";")[0]:
        return []
    out, needed, depth, part = [], 0, 0, ""
    for char in text[:end] + ",":
        depth += {"<": 1, "(": 1, ">": -1, ")": -1}.get(char, 0)
        if char == "," and depth == 0:
            needed += "=" not in part
            part = re.sub(r"=.*", "", part).strip()
            if part:
                out.append(re.sub(r"[\s]*\b\w+(\[\w*\])?$", r"\1", part) if " " in part else part)
            part = ""
        else:
            part += char
    return [", ".join(out[:n]) for n in range(min(needed, len(out)), len(out) + 1)]


def names(path):
    """What a source defines in anonymous namespaces: (name, what it stands for, line). Two aliases of one type may meet."""
    lines = without_comments(path.read_text()).split("\n")
    inside = False
    before = path.read_text().split("\n")
    for number, line in enumerate(lines):
        if before[number].startswith("namespace {"):
            inside = True
        elif before[number].startswith("}  // namespace") and not before[number][15:].strip():
            inside = False
        elif match := TEST.match(line):
            yield "test " + match.group(1), path, number + 1
        elif inside and line and not line[0].isspace():
            if match := TYPE.match(line):
                yield match.group(1), path, number + 1
            elif match := ALIAS.match(line):
                yield match.group(1), match.group(2), number + 1
            elif match := VALUE.match(line):
                for name in [match.group(1), *MORE.findall(line[match.end() :])]:
                    yield name, path, number + 1
            elif match := FUNCTION.match(line):
                for types in parameters(lines, number, match.group(2)):
                    yield f"{match.group(1)}({types})", path, number + 1


def groups(build):
    """The sources of each group of a configured build."""
    for joined in sorted(pathlib.Path(build).glob("**/Unity/unity_*.cxx")):
        paths = [pathlib.Path(p) for p in re.findall(r'#include "([^"]+)"', joined.read_text())]
        yield [p for p in paths if p.is_relative_to(ROOT)]


def check(build):
    faults = count = 0
    for sources in groups(build):
        seen = collections.defaultdict(list)
        for path in sources:
            for name, meaning, line in names(path):
                seen[name].append((meaning, f"{path.relative_to(ROOT)}:{line}"))
                count += 1
        for name, found in sorted(seen.items()):
            if len({meaning for meaning, place in found}) > 1:
                faults += 1
                first, *others = [place for meaning, place in found]
                print(f"{first}: {name} is also in {', '.join(others)}")
    print(f"{count} names, {faults} of them twice in a group")
    return count == 0 or faults > 0


def check_classes():
    """Two classes or constants of one name in one namespace: the linker would take one's inline functions, and vectors of it, or its
    value for the other's."""
    seen = collections.defaultdict(list)
    for path in sorted([*ROOT.glob("src/**/*.h"), *ROOT.glob("src/**/*.cpp"), *ROOT.glob("include/**/*.h")]):
        spaces, text = [], path.read_text()
        for number, (line, whole) in enumerate(zip(without_comments(text).split("\n"), text.split("\n")), 1):
            line = re.sub(r"\b(?:MRSIM_API|alignas\(\w+\)) ", "", line)
            if match := re.match(r"namespace ?([\w:]*) ?\{", line):
                spaces.append(match.group(1))
            elif whole.startswith("}  // namespace") and spaces:
                spaces.pop()
            elif (match := TYPE.match(line)) and "" not in spaces and line[match.end(1) : match.end(1) + 2] != "::":
                seen["::".join([*spaces, match.group(1)])].append(f"{path.relative_to(ROOT)}:{number}")
            elif line.startswith("inline ") and (match := VALUE.match(line)) and "" not in spaces:
                seen["::".join([*spaces, match.group(1)])].append(f"{path.relative_to(ROOT)}:{number}")
    faults = 0
    for name, places in sorted(seen.items()):
        if len(places) > 1:
            faults += 1
            print(f"{places[0]}: {name} is also in {', '.join(places[1:])}")
    print(f"{len(seen)} classes and constants, {faults} names of several")
    return not seen or faults > 0


def check_threads():
    """The tests that ThreadSanitizer is for, and those of them that the filter of its preset would leave out."""
    presets = json.loads((ROOT / "CMakePresets.json").read_text())["testPresets"]
    found = next(re.compile(preset["filter"]["include"]["name"]) for preset in presets if preset["name"] == "tsan")
    count = faults = 0
    for stage in ("core", "removal", "mesh", "compare"):
        for path in sorted((ROOT / "tests" / stage).glob("*_test.cpp")):
            for suite, test, body in TEST_BODY.findall(path.read_text()):
                if THREADS.search(body):
                    count += 1
                    if not found.search(f"{suite}.{test}"):
                        faults += 1
                        print(f"{path.relative_to(ROOT)}: {suite}.{test} is not found by the preset tsan ({found.pattern})")
    print(f"{count} tests run on several numbers of threads, {faults} are not found by the preset tsan")
    return count == 0 or faults > 0


def main():
    twice = check_classes()
    twice = check_threads() or twice
    with tempfile.TemporaryDirectory() as build:
        subprocess.run(["cmake", "--preset", "ci", "-B", build], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
        return check(build) or twice


if __name__ == "__main__":
    sys.exit(main())
