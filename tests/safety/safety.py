#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""The promises of docs/security.md, asked of the program: safety.py PROGRAM [TEST...].

What a scene may read and what is shown of files (reading.py), what hostile files may cost (costs.py), what limits and
signals leave behind (limits.py). Each test makes its input. A run that does not end within a minute (ten under
sanitizers) is killed and counts as failed.
"""

import os
import sys
import unittest

from costs import Costs
from limits import Limits
from reading import Reading
from safety_test import SafetyTest

__all__ = ["Costs", "Limits", "Reading"]

if __name__ == "__main__":
    SafetyTest.program = os.path.abspath(sys.argv.pop(1))
    unittest.main()
