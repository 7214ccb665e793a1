#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""findspace-mpi: the same bytes from 1 to 4 ranks, batches over ranks, and what the plain program says under mpirun.

usage: ranks.py PROGRAM PROGRAM_MPI MPIRUN [--kills N] [TEST...]
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
KILLS = int(sys.argv[5]) if sys.argv[4:5] == ["--kills"] else 4
TESTS = sys.argv[6:] if sys.argv[4:5] == ["--kills"] else sys.argv[4:]
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                   OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_hwloc_base_binding_policy="none")
HIDE = EXAMPLES / "packing" / "hide.json"
ROUND = {  # grown edges and corners: places on lines that are no fractions
    "findspace": 1, "shapes": {"tetra": {"polytope": [[0, 0, 0], [5, 1, 0], [1, 4, 1], [1, 1, 4]]},
                               "ball": {"ball": {"center": [0, 0, 0], "radius": 0.25}}},
    "moving": "ball", "where": "0.125 <= gap(ball, tetra) <= 1"}


def alone(folder, *arguments):
    return subprocess.run([PLAIN, *arguments], cwd=folder, capture_output=True, text=True)


def ranks(count, folder, *arguments, program=RANKED):
    return subprocess.run([MPIRUN, "-n", str(count), program, *arguments], cwd=folder, capture_output=True, text=True,
                          env=ENVIRONMENT, timeout=300)


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

    def test_the_same_bytes_from_threads(self):
        (self.path / "round.json").write_text(json.dumps(ROUND))
        for scene, options in ((str(EXAMPLES / "rooms.json"), ["--resolution", "96"]), ("round.json", ["--resolution", "40"])):
            expected = None
            for count in (1, 2, 3, 4):
                for threads in ("1", "2"):
                    run = ranks(count, self.path, "map", scene, *options, "--threads", threads, "-o", "n.json")
                    self.assertEqual(run.returncode, 0, run.stderr)
                    bytes_ = (run.stdout, (self.path / "n.json").read_bytes())
                    expected = expected or bytes_
                    self.assertEqual(bytes_, expected)
            self.assertEqual(alone(self.path, "map", scene, *options, "-o", "n.json").stdout, expected[0])
            self.assertEqual((self.path / "n.json").read_bytes(), expected[1])

    def test_the_same_bytes_at_orientations(self):
        scene = {"findspace": 1, "shapes": {"tetra": {"polytope": [[0, 0, 0], [5, 1, 0], [1, 4, 1], [1, 1, 4]]},
                                            "rod": {"box": {"min": [0, 0, 0], "max": [3, 0.5, 0.5]}}},
                 "moving": "rod", "free": {"pose": {"angles": [0, 90, 45]}}, "where": "0 <= gap(rod, tetra) <= 1"}
        (self.path / "pose.json").write_text(json.dumps(scene))
        for options in (["--resolution", "48"], ["--resolution", "24", "--axes"]):
            first = alone(self.path, "map", "pose.json", *options, "--json", "-o", "one.json")
            self.assertEqual(first.returncode, 0, first.stderr)
            for count in (2, 3):
                run = ranks(count, self.path, "map", "pose.json", *options, "--json", "-o", "n.json")
                self.assertEqual((run.returncode, run.stdout), (0, first.stdout), run.stderr)
                self.assertEqual((self.path / "n.json").read_bytes(), (self.path / "one.json").read_bytes())

    def test_inner_and_outer_and_least(self):
        (self.path / "round.json").write_text(json.dumps(ROUND))
        (self.path / "least.json").write_text(json.dumps(dict(ROUND, minimize="z")))
        for verb in (["map", "round.json", "--side", "inner"], ["map", "round.json", "--side", "outer"], ["map", "least.json"],
                     ["describe", "round.json", "tetra"], ["describe", "round.json", "tetra", "--side", "inner"]):
            command = [*verb, "--resolution", "40"]
            first = alone(self.path, *command, "-o", "one.json")
            self.assertIn(first.returncode, (0, 1), first.stderr)
            for count in (2, 3):
                run = ranks(count, self.path, *command, "-o", "n.json")
                self.assertEqual((run.returncode, run.stdout), (first.returncode, first.stdout), run.stderr)
                self.assertEqual((self.path / "n.json").read_bytes(), (self.path / "one.json").read_bytes(), command)

    def test_rank_0_alone_reads(self):
        """The others get what it reads: here they stand in folders of their own."""
        (self.path / "here").mkdir()
        (self.path / "there").mkdir()
        (self.path / "here" / "round.json").write_text(json.dumps(ROUND))
        self.assertEqual(alone(self.path / "here", "map", "round.json", "--resolution", "24", "-o", "one.json").returncode, 0)
        command = [RANKED, "map", "round.json", "--resolution", "24", "-o", "n.json"]
        run = subprocess.run([MPIRUN, "-n", "1", "-wdir", self.path / "here", *command, ":", "-n", "2", "-wdir", self.path / "there", *command],
                             capture_output=True, text=True, env=ENVIRONMENT)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual((self.path / "here" / "n.json").read_bytes(), (self.path / "here" / "one.json").read_bytes())
        self.assertEqual(list((self.path / "there").iterdir()), [])

    def test_standard_input(self):
        run = subprocess.run([MPIRUN, "-n", "2", RANKED, "map", "-", "--resolution", "24"], input=json.dumps(ROUND), cwd=self.path,
                             capture_output=True, text=True, env=ENVIRONMENT)
        self.assertEqual(run.returncode, 0, run.stderr)
        (self.path / "round.json").write_text(json.dumps(ROUND))
        self.assertEqual(run.stdout, alone(self.path, "map", "round.json", "--resolution", "24").stdout)

    def packed(self, count, *options):
        run = ranks(count, self.path, "pack", str(HIDE), "--threads", "1", *options, "-o", "layout.json")
        self.assertEqual(run.returncode, 0, run.stderr)
        verified = alone(self.path, "verify", "layout.json", str(HIDE))
        self.assertEqual(verified.returncode, 0, verified.stdout)
        layout = json.loads((self.path / "layout.json").read_text())["layout"]
        return {k: v for k, v in layout.items() if k not in ("seconds", "processor")}

    def test_islands_over_ranks(self):
        one, two = self.packed(1, "--work", "2"), self.packed(2, "--work", "2")
        self.assertEqual(two, self.packed(2, "--work", "2"))  # of the seed and the ranks only
        self.assertNotEqual(one, two)
        self.packed(3, "--time-limit", "2")

    def test_islands_of_solids(self):
        crate = str(EXAMPLES / "packing" / "crate.json")
        texts = []
        for _ in range(2):
            run = ranks(2, self.path, "pack", crate, "--work", "8", "-o", "solids.json", "-q")
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertEqual(alone(self.path, "verify", "solids.json", crate).returncode, 0)
            texts.append(json.loads((self.path / "solids.json").read_text())["layout"])
        for layout in texts:
            layout.pop("seconds", None)
        self.assertEqual(*texts)

    def test_a_killed_packing_leaves_its_best_layout(self):
        rng = random.Random(9)
        for round_ in range(KILLS):
            (self.path / "layout.json").unlink(missing_ok=True)
            process = subprocess.Popen([MPIRUN, "-n", "2", RANKED, "pack", str(HIDE), "--threads", "1", "--time-limit", "60", "-o", "layout.json"],
                                       cwd=self.path, env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            while not (self.path / "layout.json").exists():
                time.sleep(0.01)
            time.sleep(rng.uniform(0, 1))
            os.kill(rng.choice(self.ranks_of(process)), signal.SIGKILL)
            process.wait()
            self.assertEqual(alone(self.path, "verify", "layout.json", str(HIDE)).returncode, 0)

    def ranks_of(self, process):
        found = subprocess.run(["ps", "-o", "pid=", "--ppid", str(process.pid)], capture_output=True, text=True)
        return [int(pid) for pid in found.stdout.split()]

    def test_kills_at_any_time(self):
        """A rank, or mpirun and all; then the same command again."""
        expected = self.questions(120)
        rng = random.Random(10)
        for round_ in range(KILLS):
            name = f"k{round_}.jsonl"
            process = subprocess.Popen([MPIRUN, "-n", "2", RANKED, "batch", "jobs.jsonl", "-o", name], cwd=self.path, env=ENVIRONMENT,
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
            time.sleep(rng.uniform(0.2, 0.9))
            victims = self.ranks_of(process)
            if victims and rng.random() < 0.6:
                try:
                    os.kill(rng.choice(victims), signal.SIGKILL)
                except ProcessLookupError:
                    pass
            else:
                for pid in victims + [process.pid]:
                    try:
                        os.kill(pid, signal.SIGKILL)
                    except ProcessLookupError:
                        pass
            process.wait()
            if not (self.path / name).exists() or (self.path / f"{name}.parts").exists():
                run = ranks(2, self.path, "batch", "jobs.jsonl", "-o", name)
                self.assertEqual(run.returncode, 0, run.stderr)
            self.assertEqual(self.results(name), expected)
            self.assertFalse((self.path / f"{name}.parts").exists())

    def test_other_questions_are_answered_once(self):
        peg = str(EXAMPLES / "peg.json")
        for arguments in (["check", peg, "--at", "50,30"], ["map", peg], ["measure", peg]):
            self.assertEqual(ranks(3, self.path, *arguments).stdout, alone(self.path, *arguments).stdout)

    def test_errors_are_said_once(self):
        run = ranks(3, self.path, "map", "none.json", "--resolution", "64")
        self.assertEqual(run.returncode, 3)
        self.assertEqual(run.stderr.count("no such file"), 1)

    def test_an_error_of_one_rank_ends_all(self):
        (self.path / "round.json").write_text(json.dumps(ROUND))
        (self.path / "strip.json").write_text(HIDE.read_text())
        crate = str(EXAMPLES / "packing" / "crate.json")
        for status, says, command in (
                (2, "the ending must be one of", ["map", "round.json", "--resolution", "64", "-o", "r.txt"]),
                (2, "this is the input itself", ["map", "round.json", "--resolution", "64", "-o", "round.json"]),
                (2, "the ending must be one of", ["pack", "strip.json", "--work", "2", "-o", "x.stl"]),
                (3, "no/layout.json", ["pack", "strip.json", "--work", "2", "--threads", "1", "-o", "no/layout.json"]),
                (3, "no/layout.json", ["pack", crate, "--work", "8", "-q", "-o", "no/layout.json"]),
                (3, "no/map.json", ["map", "round.json", "--resolution", "24", "-o", "no/map.json"])):
            run = ranks(2, self.path, *command)
            self.assertEqual((run.returncode, run.stderr.count(says)), (status, 1), run.stderr)

    def test_a_batch_that_one_rank_cannot_begin(self):
        self.questions(4)
        for name in ("here", "there"):
            (self.path / name).mkdir()
        for first, second in (("here", "there"), ("there", "here")):
            (self.path / "here" / "results").mkdir(exist_ok=True)
            command = [RANKED, "batch", self.path / "jobs.jsonl", "-o", "results/r.jsonl"]
            run = subprocess.run([MPIRUN, "-n", "1", "-wdir", self.path / first, *command, ":", "-n", "1", "-wdir", self.path / second,
                                  *command], capture_output=True, text=True, env=ENVIRONMENT, timeout=300)
            self.assertEqual((run.returncode, run.stderr.count("results/r.jsonl.parts")), (3, 1), run.stderr)

    def test_a_store_that_one_rank_cannot_open(self):
        for name in ("here", "there"):
            (self.path / name).mkdir()
        (self.path / "there" / "store").write_text("no folder")
        command = [RANKED, "map", EXAMPLES / "peg.json", "--store", "store"]
        for first, second in (("here", "there"), ("there", "here")):
            run = subprocess.run([MPIRUN, "-n", "1", "-wdir", self.path / first, *command, ":", "-n", "1", "-wdir", self.path / second,
                                  *command], capture_output=True, text=True, env=ENVIRONMENT, timeout=300)
            self.assertNotEqual(run.returncode, 0)
            self.assertIn("store", run.stderr)

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
    unittest.main(argv=["ranks.py", *TESTS])
