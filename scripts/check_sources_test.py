#!/usr/bin/env python3
"""Tests of what check_sources.py takes for a source in which an include can be missing."""

import os
import tempfile
import unittest

from check_sources import Includes

FILES = {
    "src/point.h": "#include <cmath>\n#include <list>\nstruct Point { double x; };\n",
    "src/line.h": "struct Line { Point a, b; };\n",
    "src/line.cpp": '#include "line.h"\n#include "point.h"\n',
    "src/user.cpp": '#include "line.h"\nusing Path = std::list<int>;\n',
    "src/root.cpp": '#include "line.h"\ndouble root() { return std::sqrt(2); }\n',
    "src/plain.h": "struct Plain { int n; };\n",
    "src/plain.cpp": '#include "plain.h"\n#include <vector>\n#include <cmath>\n',
}


class CanMiss(unittest.TestCase):
    def missing(self, header, lost, **changed):
        """What is found in FILES, some of them with other text, which stands there after the change."""
        with tempfile.TemporaryDirectory() as root:
            os.mkdir(os.path.join(root, "src"))
            os.mkdir(os.path.join(root, "include"))
            for path, text in FILES.items():
                with open(os.path.join(root, path), "w", encoding="utf-8") as file:
                    file.write(changed.get(os.path.basename(path).replace(".", "_"), text))
            return Includes(root).can_miss(header, lost)

    def test_the_header_itself_uses_what_it_has_lost(self):
        # line.cpp includes point.h, too, but behind line.h.
        self.assertLessEqual({"src/line.cpp", "src/user.cpp", "src/root.cpp"}, self.missing("src/line.h", '#include "point.h"'))

    def test_a_standard_header_came_with_what_is_lost(self):
        line = "struct Line { int n; };\n"
        found = self.missing("src/line.h", '#include "point.h"', line_h=line)
        self.assertIn("src/user.cpp", found)
        self.assertIn("src/root.cpp", found)

    def test_a_name_that_comes_from_elsewhere_is_not_missed(self):
        self.assertEqual(set(), self.missing("src/plain.h", "#include <vector>\n#include <cmath>"))

    def test_a_type_is_gone(self):
        self.assertIn("src/line.cpp", self.missing("src/point.h", "struct Old {};", line_cpp='#include "point.h"\nOld old;\n'))


if __name__ == "__main__":
    unittest.main()
