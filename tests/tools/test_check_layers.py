# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Layers, streets and their circles, as tools/check_layers.py sees them."""
import unittest

from small_tree import SPDX, TreeTest, said

import check_layers

SMALL = "a small constant outside src/exact; margins stand in exact/margins"


class CheckLayers(TreeTest):
    def setUp(self):
        super().setUp()
        self.source("exact/number/real.h")
        self.source("plane/base/bitmap.h", "exact/number/real.h")
        self.source("plane/sum/minkowski.h", "plane/base/bitmap.h")
        self.source("plane/offset/level.h", "plane/sum/minkowski.h", "plane/base/bitmap.h")
        self.readme("exact", "number")
        self.readme("plane", "base", "sum", "offset")
        for layer in check_layers.LAYERS[2:]:
            self.readme(layer)

    def faults(self):
        status, text = said(check_layers, self.root)
        lines = text.splitlines()
        self.assertEqual(status, 1 if len(lines) > 1 else 0, text)
        return lines[:-1]

    def test_good_tree(self):
        self.assertEqual(self.faults(), [])

    def test_order_of_streets(self):
        order, circle = check_layers.order_of_streets(check_layers.street_graph(self.root), "plane")
        self.assertEqual((order, circle), (["base", "sum", "offset"], {}))

    def test_circle_of_two(self):
        self.source("plane/sum/back.cpp", "plane/offset/level.h")
        faults = self.faults()
        self.assertIn("src/plane/sum/back.cpp:3: street plane/sum stands in a circle with plane/offset", faults)
        self.assertIn("src/plane/offset/level.h:3: street plane/offset stands in a circle with plane/sum", faults)

    def test_circle_of_three_is_found_and_who_uses_it_is_no_part_of_the_order(self):
        self.source("plane/base/far.cpp", "plane/offset/level.h")
        order, circle = check_layers.order_of_streets(check_layers.street_graph(self.root), "plane")
        self.assertEqual((order, sorted(circle)), ([], ["base", "offset", "sum"]))
        self.assertEqual(sum("stands in a circle" in fault for fault in self.faults()), 4)

    def test_include_from_a_higher_layer(self):
        self.source("exact/number/wrong.cpp", "plane/base/bitmap.h")
        self.assertEqual(self.faults(), ['src/exact/number/wrong.cpp:3: exact includes "plane/base/bitmap.h" from a higher layer'])

    def test_file_outside_of_a_street(self):
        self.source("plane/lonely.cpp")
        self.assertIn("src/plane/lonely.cpp:1: is in no street src/<layer>/<street>/ or apps/<street>/", self.faults())

    def test_the_program_is_a_client_of_the_public_headers(self):
        self.readme("apps", "common", "verbs")
        self.source("apps/common/session.h", "findspace/scene.h")
        self.source("apps/verbs/explain_command.cpp", "common/session.h", "findspace/world.h", "plane/sum/minkowski.h")
        self.assertEqual(self.faults(), ['apps/verbs/explain_command.cpp:5: a client of the public headers includes '
                                         '"plane/sum/minkowski.h"'])

    def test_the_program_stands_above_all_layers(self):
        self.readme("apps", "common", "verbs")
        self.source("apps/common/session.h", "findspace/world.h")
        self.source("apps/verbs/map.cpp", "common/session.h")
        self.source("apps/findspace.cpp", "verbs/map.h")
        self.assertEqual(self.faults(), [])
        self.source("apps/common/back.cpp", "verbs/map.h")
        self.source("apps/lonely.cpp")
        faults = self.faults()
        self.assertIn("apps/common/back.cpp:3: street apps/common stands in a circle with apps/verbs", faults)
        self.assertIn("apps/lonely.cpp:1: is in no street src/<layer>/<street>/ or apps/<street>/", faults)

    def test_readme_in_another_order(self):
        self.readme("plane", "sum", "base", "offset")
        self.assertEqual(self.faults(), ["src/plane/README.md:1: sum includes base, which the README names later"])

    def test_street_of_too_many_files(self):
        for k in range(check_layers.MOST_FILES):
            self.source(f"plane/base/more_{k}.h")
        self.assertEqual(self.faults(), ["src/plane/base:1: has 41 files; a street has at most 40"])

    def test_comments_and_strings_hold_no_constants(self):
        self.write("src/plane/base/words.cpp", SPDX + '// 1e-9\nconst char* k = "1e-9";\nconst double e = 1e-9;\n')
        self.assertEqual(self.faults(), [f"src/plane/base/words.cpp:5: {SMALL}"])

    def test_a_power_of_two_is_a_small_constant_but_for_one_that_is_no_margin(self):
        code = "const double e = 0x1p-40;\nconst double most = 0x1p40;  // no sign: a limit\nconst double f = 0x1.8P-3;\n"
        code += "const Real g = Real::ratio(1, 1000000);\nconst double h = 1.0 / (1 << 20);\n"
        self.write("src/plane/base/powers.cpp", SPDX + code)
        self.write("src/exact/number/margins.h", SPDX + "const double e = 0x1p-40;\n")
        self.assertEqual(self.faults(), [f"src/plane/base/powers.cpp:{line}: {SMALL}" for line in (3, 5, 6, 7)])


if __name__ == "__main__":
    unittest.main()
