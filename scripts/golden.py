#!/usr/bin/env python3
"""Makes tests/golden/*/expected.txt anew from the interpreter as built.

Usage: scripts/golden.py [build folder]. Read the diff before committing it: a change needs a sentence in the commit that
says why it is right.
"""
import os
import pathlib
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parent.parent
build = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else root / "build").resolve()
for program in sorted((root / "data").iterdir()):
    if program.suffix.upper() not in (".MPF", ".NC", ".CNC"):
        continue
    case = root / "tests" / "golden" / program.stem / "case.txt"
    if case.exists():
        continue
    case.parent.mkdir(parents=True, exist_ok=True)
    text = f"# made by scripts/golden.py\nprogram={program.name}\n"
    if not program.name.startswith("PRIMER"):
        text += "diameter=10\n"
    if program.name.startswith("FANUC_POCKET"):
        text += "D3=5\n"
    case.write_text(text)
environment = dict(os.environ, MRSIM_GOLDEN_UPDATE="1")
test = build / "tests" / "interp_test"
sys.exit(subprocess.call([test, "--gtest_filter=*Golden*", "--gtest_brief=1"], env=environment))
