# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""The picture of the streets: what it shows, that nothing overlaps, and when it is out of date."""
import itertools
import os
import re
import subprocess
import sys
import unittest

from small_tree import SPDX, TreeTest, said

import draw_streets


class DrawStreets(TreeTest):
    def setUp(self):
        super().setUp()
        os.makedirs(os.path.join(self.root, "docs", "pictures"))
        self.source("exact/number/real.h")
        self.source("plane/base/bitmap.h", "exact/number/real.h")
        self.source("plane/sum/minkowski.h", "plane/base/bitmap.h")
        self.source("plane/query/locate.h", "plane/base/bitmap.h")
        self.source("plane/offset/level.h", "plane/sum/minkowski.h", "plane/base/bitmap.h")

    def draw(self):
        self.assertEqual(said(draw_streets, "--root", self.root)[0], 0)
        return self.read("docs/pictures/streets.svg")

    def boxes(self, svg):
        """{street: (left, top, right, bottom)}"""
        found = re.findall(r'<rect x="(\d+)" y="(\d+)" width="(\d+)" height="(\d+)" rx[^\n]*\n<text[^>]*>(\w+)<', svg)
        return {name: (int(x), int(y), int(x) + int(w), int(y) + int(h)) for x, y, w, h, name in found}

    def test_arrows_go_down_and_those_that_follow_are_left_out(self):
        svg = self.draw()
        paths = re.findall(r'<path d="M(\d+) (\d+)[^"]*L(\d+) (\d+)" marker-end', svg)
        boxes = self.boxes(svg)

        def street(x, y):
            return next(name for name, (l, t, r, b) in boxes.items() if l <= int(x) <= r and t - 1 <= int(y) <= b)

        self.assertEqual(sorted((street(*p[:2]), street(*p[2:])) for p in paths), [("offset", "sum"), ("query", "base"), ("sum", "base")])
        self.assertTrue(all(int(p[1]) < int(p[3]) for p in paths))
        self.assertIn("includes: exact\u00a01", svg)

    def test_boxes_do_not_overlap_and_keep_off_the_labels(self):
        for k in range(9):  # more than the usual width takes
            self.source(f"plane/a_street_of_long_name_{k}/x.h", "plane/base/bitmap.h")
        svg = self.draw()
        boxes = self.boxes(svg).values()
        self.assertEqual(len(boxes), 14)
        for (l, t, r, b), (l2, t2, r2, b2) in itertools.combinations(boxes, 2):
            self.assertTrue(r < l2 or r2 < l or b < t2 or b2 < t)
        self.assertGreaterEqual(min(box[0] for box in boxes), draw_streets.LABEL)
        self.assertLessEqual(max(box[2] for box in boxes), int(re.search(r'width="(\d+)"', svg).group(1)))

    def test_an_arrow_over_two_rows_passes_beside_the_boxes(self):
        self.source("plane/build/build.h", "plane/offset/level.h", "plane/query/locate.h")
        svg = self.draw()
        long = [re.findall(r"(\d+) (\d+)", d) for d in re.findall(r'<path d="(M[^"]*)" marker-end', svg) if d.count("L") > 1]
        self.assertEqual(len(long), 1)
        for (x, y), (x2, y2) in zip(long[0][1:-1:2], long[0][2:-1:2]):  # its upright pieces
            self.assertEqual(x, x2)
            for l, t, r, b in self.boxes(svg).values():
                self.assertTrue(int(x) < l or int(x) > r or b < int(y) or t > int(y2))

    def test_check(self):
        status, message = said(draw_streets, "--root", self.root, "--check")
        self.assertEqual(status, 1)
        self.assertIn("run: python3 tools/draw_streets.py", message)
        self.draw()
        self.assertEqual(said(draw_streets, "--root", self.root, "--check")[0], 0)
        self.write("src/plane/sum/note.txt", "not code\n")
        self.write("src/plane/sum/minkowski.h", SPDX + '#include "plane/base/bitmap.h"\n// A line more.\n')
        self.assertEqual(said(draw_streets, "--root", self.root, "--check")[0], 0)
        before = self.read("docs/pictures/streets.svg")
        self.source("plane/sum/more.cpp", "plane/query/locate.h")
        status, message = said(draw_streets, "--root", self.root, "--check")
        self.assertEqual((status, self.read("docs/pictures/streets.svg")), (1, before))
        self.assertIn("run: python3 tools/draw_streets.py", message)

    def test_same_bytes(self):
        drawn = self.draw()
        for seed in ("1", "2"):
            environment = {**os.environ, "PYTHONHASHSEED": seed}
            subprocess.run([sys.executable, draw_streets.__file__, "--root", self.root], check=True, env=environment)
            self.assertEqual(self.read("docs/pictures/streets.svg"), drawn)

    def test_circle(self):
        self.source("plane/base/back.cpp", "plane/sum/minkowski.h")
        with self.assertRaisesRegex(SystemExit, "streets of plane include each other in a circle: base, offset, query, sum"):
            draw_streets.picture(self.root)


if __name__ == "__main__":
    unittest.main()
