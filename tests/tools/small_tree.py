# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""For the tests of tools: the tools to import, and small source trees for them to look at."""
import contextlib
import io
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tools"))
SPDX = "// SPDX-License-Identifier: Apache-2.0\n// SPDX-FileCopyrightText: findspace contributors\n"


class TreeTest(unittest.TestCase):
    """A test with a folder of its own, self.root."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = folder.name

    def write(self, path, text):
        whole = os.path.join(self.root, path)
        os.makedirs(os.path.dirname(whole), exist_ok=True)
        with open(whole, "w", encoding="utf-8") as file:
            file.write(text)
        return whole

    def read(self, path):
        with open(os.path.join(self.root, path), encoding="utf-8") as file:
            return file.read()

    def source(self, path, *included):
        """A source file of src/, or of apps/, that includes these."""
        return self.write(path if path.startswith("apps/") else os.path.join("src", path), SPDX + "".join(f'#include "{name}"\n' for name in included))

    def readme(self, layer, *streets):
        folder = "apps" if layer == "apps" else f"src/{layer}"
        self.write(f"{folder}/README.md", f"# {layer}\n" + "".join(f"* `{street}/`: it.\n" for street in streets))


def said(tool, *arguments):
    """(exit status, all that a tool's main says)"""
    out = io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
        status = tool.main(list(arguments))
    return status, out.getvalue()
