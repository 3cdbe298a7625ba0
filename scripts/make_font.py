#!/usr/bin/env python3
"""Makes src/interp/path/stroke_font_data.cpp from a Hershey font in its .jhf form.

    python3 scripts/make_font.py FUTURAL.JHF        (Debian: hershey-fonts-data, /usr/share/hershey-fonts/futural.jhf)

A record is a number of 5 characters, a count of 3, and pairs of characters: the left and right edge, then points; a character
less 'R' is a coordinate, " R" lifts the pen. Long records go on in the next line. The records are ASCII 32 to 126 in order.
The table keeps the pairs as they are.
"""

import os
import sys

TARGET = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "src/interp/path/stroke_font_data.cpp")
HEAD = """\
// Made by scripts/make_font.py from the font "{name}": not for reading, nor for diffs.
//
// The Hershey Fonts were originally created by Dr. A. V. Hershey while working at the U. S. National Bureau of Standards.
// The format of the Font data in this distribution was originally created by James Hurt, Cognition, Inc., 900 Technology
// Park Drive, Billerica, MA 01821 (mit-eddie!ci-dandelion!hurt).
//
// They may be used by anyone for any purpose, provided that this acknowledgement goes with the font data, and be converted
// into any format but that of the U. S. NTIS.
// clang-format off
#include "interp/path/stroke_font.h"

namespace mrsim {{

const std::string_view kStrokeFont[kStrokeFontSize] = {{
"""


def records(text):
    """The pairs of each record."""
    out, want = [], 0
    for line in text.splitlines():
        if want <= 0:
            want = 2 * int(line[5:8])
            out.append("")
            line = line[8:]
        out[-1] += line
        want -= len(line)
    return out


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding="ascii") as file:
        glyphs = records(file.read())[:95]
    if len(glyphs) != 95 or any(len(glyph) % 2 for glyph in glyphs):
        sys.exit("not a font of 95 glyphs")
    with open(TARGET, "w", encoding="ascii", newline="\n") as file:
        file.write(HEAD.format(name=os.path.splitext(os.path.basename(sys.argv[1]))[0]))
        for glyph in glyphs:
            file.write('    "%s",\n' % glyph.replace("\\", "\\\\").replace('"', '\\"'))
        file.write("};\n\n}  // namespace mrsim\n")


main()
