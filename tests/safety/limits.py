# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""What limits and signals end, and leave behind."""

import json
import math
import os
import resource
import shutil
import signal
import stat
import subprocess
import time
import unittest

from safety_test import SANITIZED, SECONDS, SQUARE, SafetyTest


def small_files():
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 16, 1 << 16))


class Limits(SafetyTest):
    """Limits, signals, and what stands on the disk afterwards."""

    @staticmethod
    def star(n):
        turns = [2 * math.pi * i / n for i in range(n)]
        return [[round((50 + 9 * (i % 3)) * f(t), 4) for f in (math.cos, math.sin)] for i, t in enumerate(turns)]

    def long_scene(self):
        """A map that takes many seconds and much memory."""
        return self.scene({"A": {"polygon": self.star(3000)}, "B": {"polygon": self.star(3003)}}, moving="B",
                          where="gap(B, A) >= 0 and gap(B, A) <= 3")

    def test_time_limit(self):
        self.expect(4, "the time limit is reached, which --time-limit raises; nothing was written", "map", self.long_scene(), "--time-limit", "0.5",
                    "-o", "a.svg")
        self.assertEqual(self.leftovers(), ["scene.json"])

    def test_time_limit_is_kept(self):
        """No timing: the bound is wide, for machines that do much else."""
        scene, begin = self.long_scene(), time.monotonic()
        self.expect(4, "--time-limit raises", "map", scene, "--time-limit", "2")
        self.assertLess(time.monotonic() - begin, 20)

    def test_time_limit_of_what_waits_for_its_reader(self):
        read, write = os.pipe()
        self.addCleanup(os.close, read)
        self.scene({"A": {"points": [[i, i] for i in range(20000)]}})
        child = subprocess.Popen([self.program, "convert", "scene.json", "--json", "--time-limit", "2"], cwd=self.folder,
                                 stdout=write, stderr=subprocess.PIPE)
        os.close(write)
        err = child.communicate(timeout=SECONDS)[1].decode()
        self.assertEqual(child.returncode, 4, err)
        self.assertIn("what was printed is not whole", err)

    @unittest.skipIf(SANITIZED, "limits memory")
    def test_memory_limit(self):
        result = self.expect(4, "the memory limit", "map", self.long_scene(), "--memory-limit", "60M")
        self.assertLess(result.kilobytes, 66 << 10)
        self.assertIn("--memory-limit raises", result.err)
        self.expect(4, "nothing was written", "map", "scene.json", "--memory-limit", "60M", "-o", "a.svg")
        self.assertEqual(self.leftovers(), ["scene.json"])

    def many_shapes(self):
        """Shapes that are built by several threads."""
        shapes = {"S%d" % i: {"polygon": self.star(100 + i)} for i in range(50)}
        return self.scene(shapes, moving="S0", where="gap(S0, S1 + S2 + S3) >= 0")

    @unittest.skipIf(SANITIZED, "limits memory")
    def test_any_memory_limit(self):
        scene = self.many_shapes()
        statuses = set()
        for megabytes in (1, 5, 12, 16, 20, 24, 28, 32, 36, 40, 50, 70, 100, 400):
            result = self.run_program("map", scene, "--threads", "4", "--memory-limit", "%dM" % megabytes)
            self.assertIn(result.status, (0, 4), (megabytes, result.err))
            statuses.add(result.status)
        self.assertEqual(statuses, {0, 4})

    @unittest.skipIf(SANITIZED, "limits memory")
    def test_memory_limit_while_reading(self):
        with open(self.folder / "a.svg", "w") as text:
            text.write('<svg xmlns="http://www.w3.org/2000/svg">')
            for _ in range(200):
                text.write('<path d="M0 0H9V5Z"/>' * 10_000)
            text.write("</svg>")
        result = self.expect(4, "the memory limit", "describe", "a.svg", "--memory-limit", "100M")
        self.assertLess(result.kilobytes, 110 << 10)

    def test_work_limit_is_raised(self):
        scene = self.scene({"A": {"polygon": SQUARE}, "B": {"polygon": SQUARE}}, moving="B",
                           where="gap(B, A+A+A+A) >= 0")
        self.expect(4, "--work-limit raises", "map", scene, "--work-limit", "20000")
        self.expect(0, "", "map", scene, "--work-limit", "40K")

    def test_work_limit_of_searches_is_raised(self):
        tetrahedron = {"offset": 1, "of": {"polytope": [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]]}}
        bowl = {"difference": [{"ball": {"center": [0, 0, 0], "radius": 5}},
                               {"ball": {"center": [0, 0, 2], "radius": 3}}]}
        scene = self.scene({"A": tetrahedron, "B": bowl}, moving="B", where="hausdorff(B,A) <= 5", grid=0.001)
        ask = ("map", scene, "--resolution", "3", "--axis", "x", "--work-limit")
        self.expect(3, "--work-limit raises", *ask, "4K")
        self.expect(0, "", *ask, "20M")

    def test_sizes_that_mean_nothing(self):
        scene = self.scene({"A": {"polygon": SQUARE}})
        for size in ("0", "-1", "1.5G", "12X", "99999999999T", ""):
            self.expect(2, "--memory-limit", "describe", scene, "--memory-limit=" + size)

    def test_placement_ends_in_time(self):
        part = {"polygon": [[0, 0], [7, 1], [9, 5], [4, 3], [1, 9]]}
        scene = self.scene({"A": {"box": {"min": [0, 0], "max": [60, 60]}}, "P": part},
                           place={"shapes": ["P"], "count": {"P": 30}, "each": "inside(self, A)",
                                  "pairs": "gap(self, other) >= 0.1", "minimize": ["x"]})
        result = self.run_program("place", scene, "--time-limit", "2", "--json")
        self.assertIn(result.status, (0, 1, 4), result.err)

    def ended_by(self, number):
        """While it waits for the reader of one output, the other stands under its temporary name."""
        self.scene({"A": {"polygon": SQUARE}})
        os.mkfifo(self.folder / "pipe.svg")
        child = subprocess.Popen([self.program, "convert", "scene.json", "-o", "a.json", "-o", "pipe.svg"],
                                 cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        end = time.monotonic() + SECONDS
        while not any(name.startswith("a.json.") for name in self.leftovers()):
            self.assertIsNone(child.poll(), "it ended too early")
            self.assertLess(time.monotonic(), end)
        child.send_signal(number)
        err = child.communicate(timeout=SECONDS)[1].decode()
        self.assertEqual(child.returncode, 128 + number)
        self.assertIn("nothing was written", err)
        self.assertEqual(self.leftovers(), ["pipe.svg", "scene.json"])

    def test_interrupt_while_writing(self):
        self.ended_by(signal.SIGINT)

    def test_termination_while_writing(self):
        self.ended_by(signal.SIGTERM)

    def test_hangup_while_writing(self):
        self.ended_by(signal.SIGHUP)

    def test_ignored_signals_stay_ignored(self):
        scene = self.long_scene()
        child = subprocess.Popen([self.program, "map", scene, "--time-limit", "2"], stdout=subprocess.DEVNULL,
                                 stderr=subprocess.DEVNULL,
                                 preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        time.sleep(0.5)
        child.send_signal(signal.SIGHUP)
        self.assertEqual(child.wait(timeout=SECONDS), 4)

    def test_mode_is_kept(self):
        scene = self.scene({"A": {"polygon": SQUARE}})
        out = self.file("a.svg", "old")
        out.chmod(0o600)
        self.expect(0, "", "convert", scene, "-o", "a.svg")
        self.assertEqual(stat.S_IMODE(out.stat().st_mode), 0o600)
        self.assertNotEqual(out.read_text(), "old")

    def test_read_only_file_is_not_replaced(self):
        scene = self.scene({"A": {"polygon": SQUARE}})
        out = self.file("a.svg", "old")
        out.chmod(0o444)
        self.expect(3, "Permission denied", "convert", scene, "-o", "a.svg")
        self.assertEqual(out.read_text(), "old")
        self.assertEqual(self.leftovers(), ["a.svg", "scene.json"])

    def test_folder_of_spooled_results(self):
        scene = self.scene({"A": {"box": {"min": [0, 0, 0], "max": [9, 9, 9]}}})
        nowhere = str(self.folder / "nowhere")
        self.expect(3, nowhere, "describe", scene, "--resolution", "64", "--json", env={"TMPDIR": nowhere})
        spool = self.folder / "spool"
        spool.mkdir()
        result = self.expect(0, "", "describe", scene, "--resolution", "64", "--json", env={"TMPDIR": str(spool)})
        self.assertTrue(json.loads(result.out))
        self.assertEqual(list(spool.iterdir()), [])

    def test_spool_without_room(self):
        """A file may grow to 64 KB only, as on a full disk."""
        scene = self.scene({"A": {"ball": {"center": [0, 0, 0], "radius": 9}}})
        result = self.expect(3, str(self.folder), "describe", scene, "--resolution", "256", "--json",
                             env={"TMPDIR": str(self.folder)}, preexec_fn=small_files)
        self.assertEqual(result.out, "")
        self.assertEqual(self.leftovers(), ["scene.json"])

    @unittest.skipUnless(os.geteuid() == 0 and shutil.which("setpriv"), "threads are limited for other users only")
    @unittest.skipIf(SANITIZED, "limits threads")
    def test_threads_that_cannot_be_started(self):
        self.folder.chmod(0o755)
        self.many_shapes().chmod(0o644)
        program = shutil.copy(self.program, self.folder / "findspace")
        os.chmod(program, 0o755)
        result = self.run_program("--reuid=61234", "--clear-groups", program, "map", "scene.json", "--threads", "4",
                                  program="setpriv",
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NPROC, (1, 1)))
        self.assertEqual(result.status, 4, result.err)
        self.assertIn("a thread cannot be started", result.err)
