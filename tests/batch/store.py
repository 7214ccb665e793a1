#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""The store of results: the same answers with and without it, two processes at once, kills, flipped bits, limits.

usage: store.py PROGRAM [--kills N] [--flips N]
"""
import argparse
import json
import os
import random
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))
import ranks  # noqa: E402: the makers of scenes

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
PROGRAM, KILLS, FLIPS = None, 8, 12


def asked(folder, *arguments):
    return subprocess.run([PROGRAM, *arguments], cwd=folder, capture_output=True, text=True)


class Store(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name)
        rng = random.Random(5)
        for k in range(4):
            (self.path / f"plane{k}.json").write_text(json.dumps(ranks.plane_scene(rng, 3 + k)))
        (self.path / "solids.json").write_text(json.dumps(ranks.space_scene(rng, 60)))
        self.questions = [["map", f"plane{k}.json", "--json"] for k in range(4)]
        self.questions += [["measure", f"plane{k}.json", "--at", "50,60", "--json"] for k in range(4)]
        self.questions += [["describe", "plane3.json", "holes", "--json"], ["phi", "solids.json", "a", "b", "--at", "3,4,40", "--json"]]
        self.alone = [asked(self.path, *q).stdout for q in self.questions]
        self.assertTrue(all(self.alone))

    def file(self):
        found = list((self.path / "kept").glob("*.sqlite"))
        self.assertEqual(len(found), 1)
        return found[0]

    def entries(self):
        """How many entries there are, and how many were ever made."""
        data = sqlite3.connect(self.file())
        try:
            return data.execute("SELECT count(*) FROM entry").fetchone()[0], data.execute("SELECT seq FROM sqlite_sequence").fetchone()[0]
        finally:
            data.close()

    def check_all(self):
        for question, expected in zip(self.questions, self.alone):
            run = asked(self.path, *question, "--store", "kept")
            self.assertEqual((run.stdout, run.stderr), (expected, ""), question)

    def write_jobs(self, name="jobs.jsonl", times=1):
        lines = []
        for question in self.questions * times:
            job = {"verb": question[0], "path": question[1], "shapes": [], "options": {}}
            rest = question[2:]
            while rest:
                word = rest.pop(0)
                if word == "--at":
                    job["options"]["at"] = [float(x) for x in rest.pop(0).split(",")]
                elif word != "--json":
                    job["shapes"].append(word)
            lines.append(json.dumps(job))
        (self.path / name).write_text("\n".join(lines) + "\n")

    def results(self, name):
        return [json.loads(line)["result"] for line in (self.path / name).read_text().splitlines()]

    def test_the_same_bytes(self):
        self.check_all()
        first = self.entries()
        self.assertGreater(first[0], 8)
        self.check_all()
        self.assertEqual(self.entries(), first)

    def test_kinds_that_are_kept(self):
        self.check_all()
        asked(self.path, "pack", str(EXAMPLES / "packing" / "hide.json"), "--work", "0.01", "--store", "kept")
        data = sqlite3.connect(self.file())
        kinds = {bytes(row[0])[8:8 + int.from_bytes(bytes(row[0])[:8], "little")].decode() for row in data.execute("SELECT content FROM entry")}
        data.close()
        self.assertEqual(kinds, {"sum", "shape", "contact surface", "no-fit polygon"})

    def test_layouts_do_not_depend_on_it(self):
        def layout(*more):
            run = asked(self.path, "pack", str(EXAMPLES / "packing" / "hide.json"), "--work", "3", "--threads", "1", "--json", "-q", *more)
            self.assertEqual(run.returncode, 0, run.stderr)
            return json.loads(run.stdout)["layout"]
        expected = layout()
        for _ in range(2):
            kept = layout("--store", "kept")
            for each in (expected, kept):
                each.pop("seconds", None)
            self.assertEqual(kept, expected)

    def test_what_several_questions_share_is_made_once(self):
        self.write_jobs(times=6)
        for _ in range(2):
            run = asked(self.path, "batch", "jobs.jsonl", "-o", "r.jsonl", "--workers", "3", "--store", "kept")
            self.assertEqual(run.returncode, 0, run.stderr)
            there, made = self.entries()
            self.assertEqual(there, made)
            self.assertEqual(self.results("r.jsonl"), [json.loads(text) for text in self.alone] * 6)

    def test_a_batch_keeps_what_it_shares_until_its_end(self):
        self.write_jobs()
        run = asked(self.path, "batch", "jobs.jsonl", "-o", "r.jsonl")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(sorted(p.name for p in self.path.iterdir() if p.name.startswith("r.")), ["r.jsonl"])

    def test_two_processes_at_once(self):
        self.write_jobs()
        running = [subprocess.Popen([PROGRAM, "batch", "jobs.jsonl", "-o", f"r{k}.jsonl", "--workers", "2", "--store", "kept"], cwd=self.path,
                                    stdout=subprocess.DEVNULL) for k in range(2)]
        self.assertEqual([process.wait() for process in running], [0, 0])
        for k in range(2):
            self.assertEqual(self.results(f"r{k}.jsonl"), [json.loads(text) for text in self.alone])
        there, made = self.entries()
        self.assertEqual(there, made)

    def test_killed_while_writing(self):
        rng = random.Random(6)
        self.write_jobs(times=2)
        for round_ in range(KILLS):
            running = subprocess.Popen([PROGRAM, "batch", "jobs.jsonl", "-o", f"k{round_}.jsonl", "--workers", "2", "--store", "kept"], cwd=self.path,
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
            time.sleep(rng.uniform(0.01, 0.2))
            os.killpg(running.pid, signal.SIGKILL)
            running.wait()
            if round_ % 3 == 2:
                for file in (self.path / "kept").glob("*"):
                    file.unlink()
        self.check_all()
        data = sqlite3.connect(self.file())
        self.assertEqual(data.execute("PRAGMA integrity_check").fetchone()[0], "ok")
        data.close()

    def test_flipped_bits(self):
        self.check_all()
        whole = self.file().read_bytes()
        rng = random.Random(7)
        for flip in range(FLIPS):
            for file in (self.path / "kept").glob("*"):
                file.unlink()
            spoiled = bytearray(whole)
            # One bit; every third time a bit in each of many places.
            for _ in range(1 if flip % 3 else 300):
                place = rng.randrange(0 if flip % 2 else 100, len(spoiled))
                spoiled[place] ^= 1 << rng.randrange(8)
            name = self.path / "kept" / f"{os.uname().nodename}.sqlite"
            name.write_bytes(spoiled)
            self.check_all()
            self.check_all()

    def test_a_spoiled_entry_is_made_again(self):
        self.check_all()
        there, _ = self.entries()
        data = sqlite3.connect(self.file())
        data.execute("UPDATE entry SET result = zeroblob(length(result)) WHERE id = 1")
        data.execute("UPDATE entry SET content = zeroblob(length(content)) WHERE id = 2")
        data.commit()
        data.close()
        self.check_all()
        now, made = self.entries()
        self.assertEqual((now, made), (there, there + 2))

    def test_what_is_no_store(self):
        (self.path / "file").write_text("")
        run = asked(self.path, *self.questions[0], "--store", "file")
        self.assertEqual(run.returncode, 3)
        self.assertIn("the store", run.stderr)
        (self.path / "kept").mkdir()
        (self.path / "kept" / f"{os.uname().nodename}.sqlite").write_bytes(b"this is a text\n" * 1000)
        self.check_all()
        self.assertGreater(self.entries()[0], 8)
        self.assertEqual(asked(self.path, *self.questions[0], "--store", "kept", "--store-limit", "x").returncode, 2)

    def test_the_limit(self):
        limit = 512 * 1024
        rng = random.Random(8)
        for k in range(12):
            (self.path / "other.json").write_text(json.dumps(ranks.plane_scene(rng, 6)))
            self.assertEqual(asked(self.path, "map", "other.json", "--json", "--store", "kept", "--store-limit", str(limit)).stdout,
                             asked(self.path, "map", "other.json", "--json").stdout)
            self.assertLessEqual(self.file().stat().st_size, limit)
        there, made = self.entries()
        self.assertGreater(made, there)  # the oldest are gone
        self.assertGreater(there, 2)

    def test_a_question_has_no_store_of_its_own(self):
        (self.path / "own.jsonl").write_text(json.dumps({"verb": "map", "path": "plane0.json", "options": {"store": "x"}}) + "\n")
        asked(self.path, "batch", "own.jsonl", "-o", "r.jsonl")
        self.assertEqual(json.loads((self.path / "r.jsonl").read_text())["status"], "usage")
        self.assertFalse((self.path / "x").exists())


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--kills", type=int, default=KILLS)
    parser.add_argument("--flips", type=int, default=FLIPS)
    arguments, rest = parser.parse_known_args()
    PROGRAM, KILLS, FLIPS = os.path.abspath(arguments.program), arguments.kills, arguments.flips
    unittest.main(argv=["store.py", *rest])
