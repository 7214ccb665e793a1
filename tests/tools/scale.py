#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""tools/simulate_ranks.py on cases whose answer is known, and on the unit times that docs/scale.md speaks of.

usage: scale.py
"""
import argparse
import json
import random
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import simulate_ranks as sim  # noqa: E402

UNIT = {"rows": 256, "row_samples": [0.01], "take_seconds": 0.0, "read_seconds": 0.0, "row_bytes": 0, "scene_bytes": 0, "start_seconds": 0.0,
        "end_seconds": 0.0}
NETWORK = sim.Network(0.0, 1e30)


def map_time(ranks, rows=256, speeds=None, **more):
    return sim.map_seconds({**UNIT, **more}, ranks, rows, speeds or [1.0] * ranks, NETWORK, random.Random(1))


def batch_time(ranks, jobs, costs, failures=0, **more):
    unit = {"job_seconds": costs, "start_seconds": 0.0, "job_overhead": 0.0, "end_seconds_a_job": 0.0, **more}
    return sim.batch_seconds(unit, ranks, jobs, [1.0] * ranks, failures, random.Random(1))


class Scale(unittest.TestCase):
    def test_one_rank_takes_the_sum(self):
        self.assertAlmostEqual(map_time(1), 2.56)
        self.assertAlmostEqual(map_time(1, take_seconds=0.01), 5.12)
        self.assertAlmostEqual(batch_time(1, 6, [1.0, 2.0])[0], 9.0)

    def test_ranks_without_costs_of_their_own_share_evenly(self):
        for ranks in (2, 4, 8, 64):
            even = 2.56 / ranks
            self.assertGreaterEqual(map_time(ranks), even - 1e-9)
            self.assertLessEqual(map_time(ranks), 1.25 * even)  # blocks of one row: four a rank at 64
            self.assertAlmostEqual(batch_time(ranks, 128, [1.0])[0], 128 / ranks)

    def test_what_rank_0_does_alone_is_a_bound(self):
        for ranks in (1, 2, 16, 256):
            self.assertGreaterEqual(map_time(ranks, take_seconds=0.002), 256 * 0.002)

    def test_a_straggler_holds_up_one_block_and_not_the_map(self):
        slow = map_time(8, speeds=[1.0] * 7 + [0.1])
        self.assertGreater(slow, map_time(8))
        self.assertLess(slow, 2.56 / 7 + 3 * 0.1 + 0.05)

    def test_the_longest_question_is_a_bound(self):
        self.assertGreaterEqual(batch_time(64, 64, [0.1] * 63 + [5.0])[0], 5.0)

    def test_failures_cost_time_and_no_question(self):
        whole, again = batch_time(8, 4000, [1.0], failures=100)
        self.assertGreater(again, 10)
        self.assertGreater(whole, 4000 / 8)
        self.assertLess(whole, 2.5 * 4000 / 8)

    def test_the_measured_units(self):
        files = sorted((ROOT / "bench" / "results").glob("ranks-*.json"))
        self.assertTrue(files)
        units = json.loads(files[-1].read_text())
        options = argparse.Namespace(ranks=[1, 2, 64, 1024], stragglers=(0.0, 1.0), failures=0, latency=20e-6, bandwidth=1e9, map="level", rows=8192,
                                     jobs=200000, price=0.04, seed=1)
        rows = {row["ranks"]: row for row in sim.table(units, options)}
        for kind in ("map", "batch"):
            self.assertGreaterEqual(rows[64][f"{kind}_efficiency"], 0.85)
        for kind in ("map", "batch"):
            times = [rows[n][f"{kind}_seconds"] for n in (1, 2, 64, 1024)]
            self.assertEqual(times, sorted(times, reverse=True), "more ranks never take longer here")


if __name__ == "__main__":
    unittest.main()
