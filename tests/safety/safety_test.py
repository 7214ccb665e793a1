# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""What the tests of safety.py share: files in a folder of their own, and runs of the program that are timed and counted."""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import time
import unittest

# Under sanitizers nothing can be said of such limits: shadow memory needs more address space, LeakSanitizer a thread.
SANITIZED = bool(os.environ.get("FINDSPACE_SANITIZE"))
SECONDS = 600 if SANITIZED else 60  # no timing: what takes longer hangs
GIGABYTE = 1 << 30
SQUARE = [[0, 0], [4, 0], [4, 3], [0, 3]]
TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
SECRET = "hunter2secret"


class Result:
    def __init__(self, status, out, err, kilobytes):
        self.status, self.out, self.err, self.kilobytes = status, out, err, kilobytes


class SafetyTest(unittest.TestCase):
    program = ""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="findspace-safety-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def file(self, name, content):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if isinstance(content, bytes):
            path.write_bytes(content)
        else:
            path.write_text(content if isinstance(content, str) else json.dumps(content))
        return path

    def lines(self, name, lines):
        """A file that is never whole in memory: what a child takes counts from what the tests take."""
        with open(self.folder / name, "w", encoding="utf-8") as file:
            file.writelines(line + "\n" for line in lines)

    def scene(self, shapes, **more):
        return self.file("scene.json", {"findspace": 1, "unit": "mm", "shapes": shapes, **more})

    def of_file(self, name):
        return self.scene({"A": {"file": str(name)}})

    def run_program(self, *arguments, program=None, **options):
        out, err = tempfile.TemporaryFile(), tempfile.TemporaryFile()
        child = subprocess.Popen([program or self.program, *map(str, arguments)], stdout=out, stderr=err, cwd=self.folder,
                                 **{"stdin": subprocess.DEVNULL, **options})
        end = time.monotonic() + SECONDS
        while True:
            pid, status, usage = os.wait4(child.pid, os.WNOHANG)
            if pid:
                break
            if time.monotonic() > end:
                child.kill()
                os.wait4(child.pid, 0)
                self.fail(f"{arguments} does not end")
            time.sleep(0.01)
        child.returncode = os.waitstatus_to_exitcode(status)
        texts = []
        for stream in (out, err):
            stream.seek(0)
            texts.append(stream.read().decode(errors="replace"))
            stream.close()
        return Result(child.returncode, *texts, usage.ru_maxrss)

    def expect(self, status, says, *arguments, **options):
        result = self.run_program(*arguments, **options)
        self.assertEqual(result.status, status, result.err[:500])
        self.assertIn(says, result.err)
        return result

    def leftovers(self):
        return sorted(p.name for p in self.folder.iterdir())
