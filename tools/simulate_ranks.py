#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Predicts how long many ranks take, from unit times that bench/ranks.py measured: a map in blocks of rows, and a batch.

usage: simulate_ranks.py UNITS.json [--ranks N,N,...] [--stragglers SHARE:FACTOR] [--failures HOURS] [--latency S] [--bandwidth B]
                         [--map NAME] [--rows N]
                         [--jobs N] [--price P] [--seed N] [--json]
       simulate_ranks.py UNITS.json --service QUESTIONS_AN_HOUR [--found SHARE:FACTOR] [--arrivals N]

A map is played as apps/mpi/mpi_team.cpp has it, message by message: rank 0 makes blocks, hands rows on in order and answers the others,
which have two blocks in hand each. A batch is played as apps/batch has it: each rank takes the next open question. `--stragglers 0.02:3`
makes a rank in fifty three times slower. `--failures 1000` ends each rank once in 1,000 hours in the mean: of a batch its question is
taken by another rank and the rank comes back; a map begins again. Efficiency is the time of one rank alone over ranks times time."""
import argparse
import heapq
import json
import math
import random
import sys
from dataclasses import dataclass, field

# As in apps/mpi/mpi_team.cpp.
IN_HAND, MOST_ROWS, BLOCKS_A_RANK, AHEAD_ROWS, AHEAD_A_RANK = 2, 8, 32, 512, 8
RESTART_SECONDS = 30  # until a failed rank is there again, or a map begins anew
RANKS = [1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096]


@dataclass
class Network:
    latency: float = 20e-6
    bandwidth: float = 1e9  # bytes a second

    def arrival(self, at, size=0):
        return at + self.latency + size / self.bandwidth


def for_rows(unit, rows):
    """The units of the map on rows² lines: a row has more lines."""
    longer = rows / unit["rows"]
    return {**unit, **{key: unit[key] * longer for key in ("take_seconds", "read_seconds", "row_bytes")}, "row_samples": [c * longer for c in unit["row_samples"]]}


def row_costs(unit, rows, rng):
    """Seconds of each row: measured samples, in the order of the lines."""
    samples = unit["row_samples"]
    shift = rng.randrange(len(samples))
    return [samples[(shift + j * len(samples) // rows) % len(samples)] for j in range(rows)]


@dataclass
class Leader:
    """Rank 0 of a map, with what is on its way."""
    unit: dict
    costs: list  # of blocks
    sizes: list  # rows of blocks
    speeds: list
    network: Network
    now: float = 0.0
    next: int = 0
    taken: int = 0
    made: set = field(default_factory=set)
    waiting: list = field(default_factory=list)  # ranks that asked, once for each time
    messages: list = field(default_factory=list)  # (arrival, number, rank, block or None: it asks)
    free: list = field(default_factory=list)  # when each rank has nothing more in hand
    sent: int = 0

    def post(self, arrival, rank, block):
        self.sent += 1
        heapq.heappush(self.messages, (arrival, self.sent, rank, block))

    def is_ahead(self):
        return self.next - self.taken < max(AHEAD_ROWS // self.sizes[0], AHEAD_A_RANK * len(self.speeds))

    def give(self):
        while self.waiting and self.next < len(self.costs) and self.is_ahead():
            rank, block = self.waiting.pop(), self.next
            self.next += 1
            begun = max(self.free[rank], self.network.arrival(self.now))
            done = begun + self.costs[block] / self.speeds[rank]
            self.free[rank] = done
            self.post(self.network.arrival(done, self.sizes[block] * self.unit["row_bytes"]), rank, block)
            self.post(self.network.arrival(done), rank, None)

    def hear(self, wait):
        if wait and self.messages:
            self.now = max(self.now, self.messages[0][0])
        while self.messages and self.messages[0][0] <= self.now:
            _, _, rank, block = heapq.heappop(self.messages)
            if block is None:
                self.waiting.append(rank)
            else:
                self.now += self.sizes[block] * self.unit["read_seconds"]
                self.made.add(block)
            self.give()

    def run(self):
        for rank in range(1, len(self.speeds)):
            for _ in range(IN_HAND):
                self.post(self.network.arrival(0), rank, None)
        while self.taken < len(self.costs):
            self.give()
            self.hear(False)
            if self.taken in self.made:
                self.now += self.sizes[self.taken] * self.unit["take_seconds"]
                self.taken += 1
            elif self.next < len(self.costs) and self.is_ahead():
                block = self.next
                self.next += 1
                self.now += self.costs[block] / self.speeds[0]
                self.made.add(block)
            else:
                self.hear(True)
        return self.now


def map_seconds(unit, ranks, rows, speeds, network, rng):
    costs = row_costs(unit, rows, rng)
    each = max(1, min(MOST_ROWS, rows // (ranks * BLOCKS_A_RANK)))
    blocks = [costs[j:j + each] for j in range(0, rows, each)]
    leader = Leader(unit, [sum(b) for b in blocks], [len(b) for b in blocks], speeds, network, free=[0.0] * ranks)
    start = unit["start_seconds"] + (network.arrival(0, unit["scene_bytes"]) if ranks > 1 else 0)
    return start + leader.run() + unit["end_seconds"]


def batch_seconds(unit, ranks, jobs, speeds, failures, rng):
    """The end of the last question, and how many were begun again."""
    samples = unit["job_seconds"]
    todo = [samples[k % len(samples)] for k in range(jobs)]
    todo.reverse()
    ready = [(unit["start_seconds"], rank) for rank in range(ranks)]
    heapq.heapify(ready)
    ends, again = 0.0, 0
    fails = [rng.expovariate(1 / failures) if failures else float("inf") for _ in range(ranks)]
    while todo:
        now, rank = heapq.heappop(ready)
        cost = todo.pop()
        done = now + (cost + unit["job_overhead"]) / speeds[rank]
        if fails[rank] < done:  # the lock goes with the process, and the next that looks takes the question
            todo.append(cost)
            again += 1
            back = fails[rank] + RESTART_SECONDS
            fails[rank] = back + rng.expovariate(1 / failures)
            heapq.heappush(ready, (back, rank))
            continue
        ends = max(ends, done)
        heapq.heappush(ready, (done, rank))
    return ends + jobs * unit["end_seconds_a_job"], again


def speeds_of(ranks, stragglers, rng):
    share, factor = stragglers
    return [1 / factor if rank > 0 and rng.random() < share else 1.0 for rank in range(ranks)]


def with_failures(seconds, ranks, hours, rng):
    """The time of a map that begins anew when a rank fails, which MPI does not survive."""
    if not hours:
        return seconds
    total = 0.0
    for _ in range(1000):
        failure = rng.expovariate(ranks / (hours * 3600))
        if failure >= seconds:
            return total + seconds
        total += failure + RESTART_SECONDS
    return float("inf")


def predicted(units, ranks, options):
    rng = random.Random(options.seed)
    network = Network(options.latency, options.bandwidth)
    speeds = speeds_of(ranks, options.stragglers, rng)
    rows = options.rows or units[options.map]["rows"]
    of_map = with_failures(map_seconds(for_rows(units[options.map], rows), ranks, rows, speeds, network, random.Random(options.seed)), ranks, options.failures, rng)
    jobs = options.jobs or len(units["batch"]["job_seconds"])
    of_batch, again = batch_seconds(units["batch"], ranks, jobs, speeds, options.failures * 3600, rng)
    return {"ranks": ranks, "map_seconds": of_map, "batch_seconds": of_batch, "begun_again": again}


def table(units, options):
    rows = []
    alone = predicted(units, 1, argparse.Namespace(**{**vars(options), "stragglers": (0, 1), "failures": 0}))
    for ranks in options.ranks:
        row = predicted(units, ranks, options)
        for kind in ("map", "batch"):
            row[f"{kind}_efficiency"] = alone[f"{kind}_seconds"] / (ranks * row[f"{kind}_seconds"])
            row[f"{kind}_price"] = options.price * ranks * row[f"{kind}_seconds"] / 3600
            measured = units[options.map if kind == "map" else kind].get("measured", {}).get(str(ranks))
            if measured:
                row[f"{kind}_measured"] = measured
        rows.append(row)
    return rows


def shown(rows):
    lines = ["| ranks | map, s | efficiency | price | batch, s | efficiency | price | begun again | measured map, batch |", "|---|---|---|---|---|---|---|---|---|"]
    for r in rows:
        measured = ", ".join(f"{r[key]:.1f}" for key in ("map_measured", "batch_measured") if key in r) or "–"
        lines.append(f"| {r['ranks']} | {r['map_seconds']:.2f} | {r['map_efficiency']:.3f} | {r['map_price']:.4f} | {r['batch_seconds']:.2f} | "
                     f"{r['batch_efficiency']:.3f} | {r['batch_price']:.4f} | {r['begun_again']} | {measured} |")
    return "\n".join(lines)


def service(units, options):
    """A service that gets questions at random times: each waits for the first rank that is free."""
    rng = random.Random(options.seed)
    samples, share, factor = units["batch"]["job_seconds"], *options.found
    cost = [s + units["batch"]["job_overhead"] for s in samples]
    mean = sum(cost) / len(cost) * (1 - share + share / factor)
    rate = options.service / 3600
    rows = []
    for load in (0.5, 0.7, 0.8, 0.9, 0.95):
        ranks = max(1, math.ceil(rate * mean / load))
        speeds = speeds_of(ranks, options.stragglers, rng)
        free = [(0.0, rank) for rank in range(ranks)]
        heapq.heapify(free)
        fails = [rng.expovariate(1 / (options.failures * 3600)) if options.failures else float("inf") for _ in range(ranks)]
        now, waits, busy = 0.0, [], 0.0
        for _ in range(options.arrivals):
            now += rng.expovariate(rate)
            need = rng.choice(cost) / (factor if rng.random() < share else 1)
            begun_at = now
            while True:
                ready, rank = heapq.heappop(free)
                begun = max(begun_at, ready)
                done = begun + need / speeds[rank]
                if fails[rank] >= done:
                    break
                begun_at = max(begun_at, fails[rank])  # another rank begins it again
                back = max(fails[rank], ready) + RESTART_SECONDS
                fails[rank] = back + rng.expovariate(1 / (options.failures * 3600))
                heapq.heappush(free, (back, rank))
            busy += done - begun
            waits.append(done - now)
            heapq.heappush(free, (done, rank))
        waits.sort()
        rows.append({"ranks": ranks, "load": busy / (ranks * now), "mean": sum(waits) / len(waits), "price_of_a_million": options.price * ranks * 1e6 / options.service,
                     **{f"p{q}": waits[min(len(waits) - 1, int(len(waits) * q / 100))] for q in (50, 99, 99.9)}})
    return rows


def shown_service(rows):
    lines = ["| ranks | load | mean, s | half within, s | 99 % within, s | 99.9 % within, s | price of a million |", "|---|---|---|---|---|---|---|"]
    for r in rows:
        lines.append(f"| {r['ranks']} | {r['load']:.2f} | {r['mean']:.3f} | {r['p50']:.3f} | {r['p99']:.2f} | {r['p99.9']:.2f} | {r['price_of_a_million']:.2f} |")
    return "\n".join(lines)


def pair(text):
    share, _, factor = text.partition(":")
    share, factor = float(share), float(factor)
    if not 0 <= share <= 1 or factor < 1:
        raise ValueError
    return share, factor


def main(argv):
    parser = argparse.ArgumentParser(usage="simulate_ranks.py UNITS.json [OPTION...]; --help says more", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("units")
    parser.add_argument("--ranks", type=lambda text: [int(n) for n in text.split(",")], default=RANKS)
    parser.add_argument("--stragglers", type=pair, default=(0.0, 1.0), metavar="SHARE:FACTOR")
    parser.add_argument("--failures", type=float, default=0, metavar="HOURS", help="mean time between failures of one rank; 0: none")
    parser.add_argument("--latency", type=float, default=20e-6, metavar="S")
    parser.add_argument("--bandwidth", type=float, default=1e9, metavar="BYTES")
    parser.add_argument("--map", default="map", choices=["map", "level"], help="the measured map: of a ball that meets a mesh, or of a clearance")
    parser.add_argument("--rows", type=int, default=0, help="rows of the map (default: as measured)")
    parser.add_argument("--jobs", type=int, default=0, help="questions of the batch (default: as measured)")
    parser.add_argument("--price", type=float, default=0.04, help="of a rank and hour")
    parser.add_argument("--service", type=float, default=0, metavar="N", help="instead: a service that gets N questions an hour")
    parser.add_argument("--arrivals", type=int, default=100000, help="questions of the service that are played")
    parser.add_argument("--found", type=pair, default=(0.0, 1.0), metavar="SHARE:FACTOR", help="questions whose sums the store has, and how much faster they are")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args(argv)
    if not options.ranks or min(options.ranks) < 1:
        parser.error("--ranks wants numbers from 1 on")
    with open(options.units, encoding="utf-8") as file:
        units = json.load(file)
    if options.service:
        rows = service(units, options)
        print(json.dumps(rows, indent=1) if options.json else shown_service(rows))
        return
    rows = table(units, options)
    print(json.dumps(rows, indent=1) if options.json else shown(rows))


if __name__ == "__main__":
    main(sys.argv[1:])
