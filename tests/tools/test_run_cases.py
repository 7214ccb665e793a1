# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""The runner of cases: what a case expects is all compared, beside an exit status as well."""

import json
import os
import stat
import subprocess
import sys
import tempfile
import unittest

RUNNER = os.path.join(os.path.dirname(__file__), "..", "..", "tools", "run_cases.py")
SAYS_ONE = "#!/bin/sh\necho '{\"distances\": {\"gap(B, A)\": 1}, \"true\": true}'\n"


class RunCases(unittest.TestCase):
    def passes(self, expect):
        with tempfile.TemporaryDirectory() as folder:
            program, case = os.path.join(folder, "program"), os.path.join(folder, "one.case.json")
            with open(program, "w", encoding="utf-8") as file:
                file.write(SAYS_ONE)
            os.chmod(program, os.stat(program).st_mode | stat.S_IXUSR)
            with open(case, "w", encoding="utf-8") as file:
                json.dump({"id": "one", "run": ["check"], "scene": {}, "expect": expect}, file)
            found = subprocess.run([sys.executable, RUNNER, program, case], capture_output=True, check=False)
            return found.returncode == 0

    def test_what_is_expected_beside_an_exit_status(self):
        self.assertTrue(self.passes({"exit": 0, "distances": {"gap(B, A)": 1}, "true": True}))
        self.assertFalse(self.passes({"exit": 0, "distances": {"gap(B, A)": 2}}))
        self.assertFalse(self.passes({"exit": 0, "true": False}))
        self.assertFalse(self.passes({"exit": 1, "true": True}))

    def test_a_status_without_result(self):
        self.assertTrue(self.passes({"exit": 0}))


if __name__ == "__main__":
    unittest.main()
