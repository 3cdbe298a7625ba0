#!/usr/bin/env python3
"""Checks what documents and comments say of the repository: files that they name exist, and docs/rooms.md tells every room.

Checked are links and names of sources in backquotes, and in comments of src and include the names of sources, of members (Name::member)
and of functions (name()): code must have them, outside of comments. Lines of prose have at most 120 characters; the rule of a table
(|---|) stands alone in its line, or the table was wrapped as prose. docs/rooms.md has each room of scripts/check_includes.py,
ARCHITECTURE.md a walk of at most 12 files. It is a page: at most 100 lines. Exit 1 and one line a fault.
"""

import glob
import os
import re
import sys

from check_includes import ROOMS

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
SOURCE = re.compile(r"`([A-Za-z0-9_./-]+\.(?:h|cpp|inl|py|sh))`")
COMMENT = re.compile(r"//.*")
NAMED = re.compile(r"(?<![<\w./-])((?:[a-z_0-9]+/)*[a-z][a-z_0-9]*\.(?:h|cpp|inl))\b")
WORD = re.compile(r"\w+")
CALLED = re.compile(r"(\w+)\s*\(")
MEMBER = re.compile(r"\b([A-Z]\w+)::(~?\w+)")
FUNCTION = re.compile(r"(?<![\w.:>-])([a-z]\w+)\(\)")
LINK = re.compile(r"\]\(([^)#:]+)(?:#[^)]*)?\)")
TABLE_RULE = re.compile(r"\|\s*:?-{3,}:?\s*\|")
TABLE_RULES = re.compile(r"\|(\s*:?-+:?\s*\|)+")
WHERE = ("", "src", "include", "include/mrsim", "tests", "bench", "scripts")


def sources():
    found = set()
    for folder in ("src", "include", "tests", "bench", "scripts", "cmake"):
        for place, _, names in os.walk(os.path.join(ROOT, folder)):
            found.update(os.path.relpath(os.path.join(place, name), ROOT) for name in names)
    return found


def is_known(name, known):
    if "/" in name:
        return any(os.path.normpath(os.path.join(at, name)) in known for at in WHERE)
    return any(os.path.basename(path) == name for path in known)


def check_names(path, text, known):
    for name in SOURCE.findall(text):
        if not is_known(name, known):
            yield f"{path}: there is no {name}"
    for target in LINK.findall(text):
        if not os.path.exists(os.path.join(ROOT, os.path.dirname(path), target)):
            yield f"{path}: the link to {target} leads nowhere"


def check_comments(path, text, known):
    for comment in COMMENT.findall(text):
        for name in NAMED.findall(comment):
            if not is_known(name, known):
                yield f"{path}: a comment names {name}, which does not exist"


def code_names(paths):
    """Words of each source without its comments, and the names that are called, declared or defined in any of them."""
    words, called = [], set()
    for path in paths:
        code = COMMENT.sub("", read(path))
        words.append(set(WORD.findall(code)))
        called.update(CALLED.findall(code))
    return words, called


def check_code_names(path, text, words, called):
    for comment in COMMENT.findall(text):
        for name, member in MEMBER.findall(comment):
            if not any(name in known and member.lstrip("~") in known for known in words):
                yield f"{path}: a comment names {name}::{member}, which no source has"
        for name in FUNCTION.findall(comment):
            if name not in called:
                yield f"{path}: a comment names {name}(), which no source has"


def check_lines(path, text):
    """Lines of prose; those of tables and of programs are as long as they are."""
    fenced = False
    for number, line in enumerate(text.splitlines(), 1):
        fenced ^= line.lstrip().startswith("```")
        if len(line) > 120 and not fenced and not line.lstrip().startswith("|") and not line.startswith(("    ", "[")):
            yield f"{path}:{number}: {len(line)} characters, at most 120 are wanted"
        if TABLE_RULE.search(line) and not fenced and not TABLE_RULES.fullmatch(line.strip()):
            yield f"{path}:{number}: the rule of a table does not stand alone, so there is no table"


def check_rooms(text):
    for room in ROOMS:
        if "/" in room and f"`{room}`" not in text:
            yield f"docs/rooms.md: the room {room} is missing"


def check_architecture(text):
    for room in ROOMS:
        if room and "/" not in room and f"`src/{room}`" not in text:
            yield f"ARCHITECTURE.md: the stage {room} is missing"
    lines = text.count("\n")
    if lines > 100:
        yield f"ARCHITECTURE.md: {lines} lines, at most 100 are wanted"
    steps = len(re.findall(r"^\d+\. `src/", text, re.M))
    if not 0 < steps <= 12:
        yield f"ARCHITECTURE.md: the walk names {steps} files, 1 to 12 are wanted"


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def main():
    known = sources()
    paths = ["ARCHITECTURE.md", "CONTRIBUTING.md", "README.md"]
    paths += [os.path.relpath(path, ROOT) for path in sorted(glob.glob(os.path.join(ROOT, "docs", "*.md")))]
    faults = [fault for path in paths for fault in check_names(path, read(path), known)]
    faults += [fault for path in paths + ["CHANGELOG.md"] for fault in check_lines(path, read(path))]
    code = [path for path in sorted(known) if path.startswith(("src/", "include/")) and path.endswith((".h", ".cpp", ".inl"))]
    words, called = code_names(code)
    for path in code:
        faults += check_comments(path, read(path), known)
        faults += check_code_names(path, read(path), words, called)
    faults += [*check_architecture(read("ARCHITECTURE.md")), *check_rooms(read("docs/rooms.md"))]
    for fault in faults:
        print(fault)
    print(f"{len(paths)} documents, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
