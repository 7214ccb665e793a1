#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""The verb `batch`: results for good and bad questions, and runs that are killed and begun again.

usage: batch.py PROGRAM [--kills N] [--questions N]
"""
import argparse
import json
import os
import random
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
PROGRAM = None
KILLS, QUESTIONS = 6, 120
# Shadow memory needs more address space than a limit leaves: nothing can be said of such limits under sanitizers.
SANITIZED = bool(os.environ.get("FINDSPACE_SANITIZE"))


def batch(folder, *options, jobs="jobs.jsonl", results="results.jsonl"):
    return subprocess.run([PROGRAM, "batch", jobs, "-o", results, *options], cwd=folder, capture_output=True, text=True)


def write(folder, questions, name="jobs.jsonl"):
    lines = [q if isinstance(q, str) else json.dumps(q) for q in questions]
    (Path(folder) / name).write_text("\n".join(lines) + "\n")


def read(path):
    return [json.loads(line) for line in Path(path).read_text().splitlines()]


def without_time(results):
    return [{k: v for k, v in r.items() if k != "seconds"} for r in results]


def questions(count, seed):
    rng = random.Random(seed)
    scenes = [str(EXAMPLES / name) for name in ("peg.json", "first.json")]
    out = []
    for k in range(count):
        verb = rng.choice(["check", "measure", "map"])
        options = {} if verb == "map" else {"at": [round(rng.uniform(0, 100), 3), round(rng.uniform(0, 60), 3)]}
        out.append({"id": f"q{k}", "verb": verb, "path": rng.choice(scenes), "options": options})
    return out


class Batch(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = Path(self.folder.name)

    def ask(self, questions, *options):
        write(self.path, questions)
        run = batch(self.path, *options)
        return run, read(self.path / "results.jsonl")

    def test_results_are_those_of_the_verbs(self):
        peg = str(EXAMPLES / "peg.json")
        run, results = self.ask([{"id": 1, "verb": "map", "path": peg},
                                 {"id": "two", "verb": "check", "path": peg, "options": {"at": [10, 10]}}])
        self.assertEqual(run.returncode, 0, run.stderr)
        alone = subprocess.run([PROGRAM, "map", peg, "--json"], capture_output=True, text=True)
        self.assertEqual(results[0]["result"], json.loads(alone.stdout))
        self.assertEqual([r["id"] for r in results], [1, "two"])
        self.assertEqual([r["line"] for r in results], [1, 2])
        self.assertEqual([r["status"] for r in results], ["done", "done"])

    def test_a_scene_in_the_line(self):
        box = {"box": {"min": [0, 0], "max": [1, 1]}}
        scene = {"findspace": 1, "$schema": "}\"{", "shapes": {"plate": box, "peg": box}, "moving": "peg",
                 "where": "clear(peg, plate) and not clear(peg, plate)"}
        run, results = self.ask([{"verb": "map", "scene": scene}])
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual((results[0]["status"], results[0]["exit"]), ("empty", 1))

    def test_each_bad_question_says_what_is_wrong_and_the_others_are_answered(self):
        peg = str(EXAMPLES / "peg.json")
        (self.path / "full.svg").symlink_to("/dev/full")
        (self.path / "secret.json").write_text("{}")
        rows = [
            ("not json", "usage", "not JSON"),
            ("[1]", "usage", "an object"),
            ({"path": peg}, "usage", '"verb" is missing'),
            ({"verb": "mpa", "path": peg}, "usage", "did you mean 'map'"),
            ({"verb": "batch", "path": peg}, "usage", "no verb 'batch'"),
            ({"verb": "map"}, "usage", 'either "scene" or "path"'),
            ({"verb": "map", "path": peg, "option": {}}, "usage", "options"),
            ({"verb": "map", "path": peg, "options": {"tat": 1}}, "usage", "map has no option --tat"),
            ({"verb": "check", "path": peg, "options": {"at": {}}}, "usage", "option"),
            ({"verb": "map", "path": "no.json"}, "bad input", "no such file"),
            ({"verb": "map", "path": "secret.json"}, "bad input", "secret.json"),
            ({"verb": "map", "path": peg, "options": {"output": str(self.path / "full.svg")}}, "bad input", "full.svg"),
            ({"verb": "map", "path": str(EXAMPLES / "rooms.json"),
              "options": {"resolution": 8192, "axes": True, "time-limit": 0.1}}, "limit", "time limit"),
        ]
        if not SANITIZED:
            rows.append(({"verb": "map", "path": str(EXAMPLES / "rooms.json"),
                          "options": {"resolution": 8192, "axes": True, "memory-limit": "250M"}}, "limit", "memory limit"))
        good = {"verb": "check", "path": peg, "options": {"at": [50, 30]}}
        run, results = self.ask([q for row in rows for q in (row[0], good)])
        self.assertEqual(run.returncode, 3)
        for (question, status, why), result in zip(rows, results[::2]):
            self.assertEqual(result["status"], status, result)
            self.assertIn(why, result["error"], question)
        self.assertEqual({r["status"] for r in results[1::2]}, {"done"})

    @unittest.skipIf(SANITIZED, "limits memory")
    def test_what_ends_a_question_ends_no_other(self):
        """A disk that is full, a scene that cannot be read, a question of 10 GB, one that hangs."""
        rooms, peg = str(EXAMPLES / "rooms.json"), str(EXAMPLES / "peg.json")
        (self.path / "full.json").symlink_to("/dev/full")
        (self.path / "folder.json").mkdir()
        large = {"verb": "map", "path": rooms, "options": {"resolution": 16384, "axes": True, "output": "large.stl"}}
        alone = subprocess.run([PROGRAM, "map", rooms, "--resolution", "16384", "--axes", "-o", "large.stl", "--memory-limit", "10G"],
                               cwd=self.path, capture_output=True, text=True)
        self.assertEqual(alone.returncode, 4, "it asks for more than 10 GB")
        rows = [
            ({"verb": "map", "path": peg, "options": {"output": "full.json"}}, "bad input", "full.json"),
            ({"verb": "map", "path": "folder.json"}, "bad input", "folder"),
            (large, "limit", "memory limit"),
            ({"verb": "map", "path": rooms, "options": {"resolution": 3000, "axes": True, "time-limit": 4}}, "limit", "did not react"),
        ]
        good = {"verb": "check", "path": peg, "options": {"at": [50, 30]}}
        write(self.path, [q for row in rows for q in (row[0], good)])
        running = subprocess.Popen([PROGRAM, "batch", "jobs.jsonl", "-o", "results.jsonl", "--workers", "2", "--memory-limit", "2G"],
                                   cwd=self.path, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.addCleanup(running.kill)
        self.stop_one_that_works(running)
        self.assertEqual((running.communicate()[1], running.returncode), ("", 3))
        results = read(self.path / "results.jsonl")
        for (question, status, why), result in zip(rows, results[::2]):
            self.assertEqual(result["status"], status, result)
            self.assertIn(why, result["error"], question)
        self.assertEqual({r["status"] for r in results[1::2]}, {"done"})

    def stop_one_that_works(self, running):
        """A worker that is stopped reacts to nothing, its own timer included."""
        def workers():
            return subprocess.run(["ps", "-o", "pid=", "--ppid", str(running.pid)], capture_output=True, text=True).stdout
        end = time.monotonic() + 20
        while running.poll() is None and time.monotonic() < end:
            for line in workers().splitlines():
                pid = int(line.split()[0])
                try:
                    used = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
                except OSError:
                    continue
                if int(used[11]) + int(used[12]) > 15:  # hundredths of a second: it is the long one
                    os.kill(pid, signal.SIGSTOP)
                    return
            time.sleep(0.01)

    @unittest.skipUnless(os.geteuid() == 0 and subprocess.run(["unshare", "-m", "true"], capture_output=True).returncode == 0,
                         "needs to mount a small disk")
    def test_a_full_disk_and_a_larger_one(self):
        write(self.path, questions(QUESTIONS, 8))
        self.assertEqual(batch(self.path, results="whole.jsonl").returncode, 0)
        script = f"""mkdir disk && mount -t tmpfs -o size=48k tmpfs disk &&
            '{PROGRAM}' batch jobs.jsonl -o disk/results.jsonl -q; echo status $?;
            mount -o remount,size=64m disk && '{PROGRAM}' batch jobs.jsonl -o disk/results.jsonl -q; echo status $?; cp disk/*.jsonl ."""
        run = subprocess.run(["unshare", "-m", "sh", "-c", script], cwd=self.path, capture_output=True, text=True)
        self.assertEqual([line for line in run.stdout.splitlines() if line.startswith("status")], ["status 3", "status 0"], run)
        self.assertIn("No space left", run.stderr)
        self.assertEqual(without_time(read(self.path / "results.jsonl")), without_time(read(self.path / "whole.jsonl")))

    def test_what_is_no_batch(self):
        write(self.path, [{"id": 1, "verb": "map", "path": "a"}, {"id": 1, "verb": "map", "path": "b"}])
        self.assertIn("lines 1 and 2 have the same id 1", batch(self.path).stderr)
        (self.path / "jobs.jsonl").write_text("\n\n")
        run = batch(self.path)
        self.assertEqual(run.returncode, 3)
        self.assertIn("no question", run.stderr)
        self.assertEqual(batch(self.path, jobs="none.jsonl").returncode, 3)
        self.assertEqual(batch(self.path, results="r.txt").returncode, 2)

    def test_the_folder_of_other_questions_is_refused(self):
        write(self.path, questions(40, 1))
        running = subprocess.Popen([PROGRAM, "batch", "jobs.jsonl", "-o", "results.jsonl"], cwd=self.path,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        parts = self.path / "results.jsonl.parts"
        while running.poll() is None and not list(parts.glob("of-*")):
            time.sleep(0.002)
        running.kill()
        running.wait()
        if not list(parts.glob("of-*")):
            self.skipTest("it had ended")
        write(self.path, questions(41, 2))
        run = batch(self.path)
        self.assertEqual(run.returncode, 3)
        self.assertIn("other questions", run.stderr)

    def test_killed_at_any_time_and_begun_again(self):
        write(self.path, questions(QUESTIONS, 3))
        self.assertEqual(batch(self.path, results="whole.jsonl").returncode, 0)
        whole = without_time(read(self.path / "whole.jsonl"))
        rng = random.Random(4)
        for round_ in range(KILLS):
            name = f"r{round_}.jsonl"
            for _ in range(3):
                running = [subprocess.Popen([PROGRAM, "batch", "jobs.jsonl", "-o", name, "--workers", "2"], cwd=self.path,
                                            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
                           for _ in range(2)]
                time.sleep(rng.uniform(0.01, 0.15))
                for process in running:
                    if rng.random() < 0.5:
                        process.kill()  # its workers end with it
                    else:
                        os.killpg(process.pid, signal.SIGKILL)
                    process.wait()
            if not (self.path / name).exists() or (self.path / f"{name}.parts").exists():
                self.assertEqual(batch(self.path, results=name).returncode, 0)
            self.assertEqual(without_time(read(self.path / name)), whole)
            self.assertFalse((self.path / f"{name}.parts").exists())

    def test_two_processes_share_the_questions(self):
        write(self.path, questions(QUESTIONS, 5))
        two = [subprocess.Popen([PROGRAM, "batch", "jobs.jsonl", "-o", "results.jsonl", "--workers", "1", "--as-they-come"],
                                cwd=self.path, stdout=subprocess.PIPE, text=True) for _ in range(2)]
        lines = [line for process in two for line in process.communicate()[0].splitlines() if line.startswith("{")]
        self.assertEqual([process.returncode for process in two], [0, 0])
        answered = [json.loads(line)["line"] for line in lines]
        self.assertEqual(sorted(answered), sorted(r["line"] for r in read(self.path / "results.jsonl")))
        self.assertEqual(len(answered), QUESTIONS)

    def test_a_killed_worker_costs_no_question(self):
        write(self.path, questions(QUESTIONS, 6))
        # A question that is killed twice is ended. Of six workers the five oldest are killed; killed questions are with new ones.
        running = subprocess.Popen([PROGRAM, "batch", "jobs.jsonl", "-o", "results.jsonl", "--as-they-come", "--workers", "6"],
                                   cwd=self.path, stdout=subprocess.PIPE, text=True)
        for _ in range(5):
            for _ in range(12):  # answers between two kills
                running.stdout.readline()
            children = subprocess.run(["ps", "-o", "pid=", "--ppid", str(running.pid)], capture_output=True, text=True)
            for pid in children.stdout.split()[:1]:
                try:
                    os.kill(int(pid), signal.SIGKILL)
                except ProcessLookupError:
                    pass
        running.communicate()
        self.assertEqual(running.returncode, 0)
        self.assertEqual(len(read(self.path / "results.jsonl")), QUESTIONS)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--kills", type=int, default=KILLS)
    parser.add_argument("--questions", type=int, default=QUESTIONS)
    arguments, rest = parser.parse_known_args()
    PROGRAM, KILLS, QUESTIONS = os.path.abspath(arguments.program), arguments.kills, arguments.questions
    unittest.main(argv=["batch.py", *rest])
