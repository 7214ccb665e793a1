# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "..", "tools"))
import targets_of_tests

FILE = """# CMake generated Testfile
add_test([=[unit_plane]=] "{0}/unit_plane")
set_tests_properties([=[unit_plane]=] PROPERTIES LABELS "unit")
add_test([=[law_plane_0]=] "{0}/law_plane")
add_test([=[mpi_ranks]=] "/usr/bin/python3" "/src/ranks.py" "{0}/findspace" "{0}/findspace-mpi" "/usr/bin/mpirun")
add_test(house_layers "/usr/bin/python3" "/src/tools/check_layers.py")
"""


class Targets(unittest.TestCase):
    def test_are_what_the_chosen_tests_run(self):
        with tempfile.TemporaryDirectory() as build:
            os.mkdir(os.path.join(build, "tests"))
            with open(os.path.join(build, "tests", "CTestTestfile.cmake"), "w", encoding="utf-8") as file:
                file.write(FILE.format(build))
            of = lambda *names: targets_of_tests.targets(build, set(names))
            self.assertEqual(of("unit_plane"), {"unit_plane"})
            self.assertEqual(of("law_plane_0", "mpi_ranks"), {"law_plane", "findspace", "findspace-mpi"})
            self.assertEqual(of("house_layers"), set())
            self.assertEqual(of("unit_plan"), set())


if __name__ == "__main__":
    unittest.main()
