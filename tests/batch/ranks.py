#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""findspace-mpi: the same bytes from 1 to 4 ranks, batches over ranks, and what the plain program says under mpirun.

usage: ranks.py PROGRAM PROGRAM_MPI MPIRUN
"""
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
PLAIN, RANKED, MPIRUN = (os.path.abspath(path) for path in sys.argv[1:4])
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                   OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_hwloc_base_binding_policy="none")
ROUND = {  # grown edges and corners: places on lines that are no fractions
    "findspace": 1, "shapes": {"tetra": {"polytope": [[0, 0, 0], [5, 1, 0], [1, 4, 1], [1, 1, 4]]},
                               "ball": {"ball": {"center": [0, 0, 0], "radius": 0.25}}},
    "moving": "ball", "where": "0.125 <= gap(ball, tetra) <= 1"}


def alone(folder, *arguments):
    return subprocess.run([PLAIN, *arguments], cwd=folder, capture_output=True, text=True)


def ranks(count, folder, *arguments, program=RANKED):
    return subprocess.run([MPIRUN, "-n", str(count), program, *arguments], cwd=folder, capture_output=True, text=True,
                          env=ENVIRONMENT)


class Ranks(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = Path(self.folder.name)

    def compare(self, scene, *options):
        outputs = ["-o", "one.json", "-o", "one.stl"]
        first = alone(self.path, "map", scene, *options, *outputs)
        self.assertEqual(first.returncode, 0, first.stderr)
        for count in (1, 2, 3, 4):
            run = ranks(count, self.path, "map", scene, *options, "-o", "n.json", "-o", "n.stl")
            self.assertEqual((run.returncode, run.stdout), (0, first.stdout), run.stderr)
            for ending in ("json", "stl"):
                self.assertEqual((self.path / f"n.{ending}").read_bytes(), (self.path / f"one.{ending}").read_bytes())

    def test_the_same_bytes(self):
        self.compare(str(EXAMPLES / "rooms.json"), "--resolution", "64", "--axes")

    def test_the_same_bytes_of_round_shapes(self):
        (self.path / "round.json").write_text(json.dumps(ROUND))
        self.compare("round.json", "--resolution", "40", "--axes")

    def test_other_questions_are_answered_once(self):
        peg = str(EXAMPLES / "peg.json")
        for arguments in (["check", peg, "--at", "50,30"], ["map", peg], ["measure", peg]):
            self.assertEqual(ranks(3, self.path, *arguments).stdout, alone(self.path, *arguments).stdout)

    def test_errors_are_said_once(self):
        run = ranks(3, self.path, "map", "none.json", "--resolution", "64")
        self.assertEqual(run.returncode, 3)
        self.assertEqual(run.stderr.count("no such file"), 1)

    def test_the_plain_program_under_mpirun(self):
        run = ranks(2, self.path, "map", str(EXAMPLES / "peg.json"), program=PLAIN)
        self.assertEqual(run.returncode, 2)
        self.assertIn("findspace-mpi", run.stderr)
        self.assertEqual(run.stdout, "")

    def questions(self, count):
        rng = random.Random(1)
        lines = [json.dumps({"id": k, "verb": "check", "path": str(EXAMPLES / "peg.json"),
                             "options": {"at": [rng.randint(0, 100), rng.randint(0, 60)]}}) for k in range(count)]
        (self.path / "jobs.jsonl").write_text("\n".join(lines) + "\n")
        alone(self.path, "batch", "jobs.jsonl", "-o", "alone.jsonl")
        return self.results("alone.jsonl")

    def results(self, name):
        lines = [json.loads(line) for line in (self.path / name).read_text().splitlines()]
        return [{k: v for k, v in line.items() if k != "seconds"} for line in lines]

    def test_a_batch_over_ranks(self):
        expected = self.questions(60)
        for count in (1, 2, 3):
            run = ranks(count, self.path, "batch", "jobs.jsonl", "-o", f"r{count}.jsonl")
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertEqual(self.results(f"r{count}.jsonl"), expected)

    def test_a_rank_that_is_killed(self):
        expected = self.questions(200)
        process = subprocess.Popen([MPIRUN, "-n", "2", RANKED, "batch", "jobs.jsonl", "-o", "r.jsonl"], cwd=self.path,
                                   env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while not (self.path / "r.jsonl.parts").exists() and process.poll() is None:
            time.sleep(0.005)
        found = subprocess.run(["ps", "-o", "pid=", "--ppid", str(process.pid)], capture_output=True, text=True)
        for pid in found.stdout.split()[:1]:
            os.kill(int(pid), signal.SIGKILL)
        process.wait()
        if not (self.path / "r.jsonl").exists():
            self.assertEqual(ranks(2, self.path, "batch", "jobs.jsonl", "-o", "r.jsonl").returncode, 0)
        self.assertEqual(self.results("r.jsonl"), expected)


if __name__ == "__main__":
    unittest.main(argv=["ranks.py", *sys.argv[4:]])
