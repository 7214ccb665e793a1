#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Compares distances along a direction, instants of a motion and extremes over time with their definitions, on random polyominoes.

usage: line_lattice.py EXECUTABLE [--count 100] [--seed 1]

For polyominoes A and B the positions where B overlaps A are the union of open squares of side 2, one for each pair of cells; those where they meet, of the
closed squares; those where B leaves A (or its inside), of the open (closed) squares of the cells that A lacks. So along a line, or a straight leg of a
motion, everything changes at the crossings with the sides of these squares: rational numbers, at and between which a few comparisons give the truth. From
this the values of distances.md 7.1 and the intervals of 7.3, with the marks of their ends.

Exit status 0 where nothing disagrees."""
import argparse
import json
import math
import random
import subprocess
import sys
from fractions import Fraction

from place_lattice import outline, polyomino

FRAME = range(-16, 24)  # more than what a shape reaches from where it can lie in another


class Pair:
    """B at a position q against A: signs of gamma1 and eta1."""

    def __init__(self, moving, fixed):
        self.meet = {(a[0] - b[0], a[1] - b[1]) for a in fixed for b in moving}
        lacking = [(x, y) for x in FRAME for y in FRAME if (x, y) not in fixed]
        self.leave = {(c[0] - b[0], c[1] - b[1]) for c in lacking for b in moving}

    @staticmethod
    def least(squares, q):
        """-1 inside one of the squares, 0 on one, +1 off all of them."""
        best = 1
        for x in range(math.ceil(q[0]) - 1, math.floor(q[0]) + 2):
            for y in range(math.ceil(q[1]) - 1, math.floor(q[1]) + 2):
                if (x, y) in squares:
                    if max(abs(q[0] - x), abs(q[1] - y)) < 1:
                        return -1
                    best = 0
        return best

    def gamma1(self, q):
        return self.least(self.meet, q)

    def eta1(self, q):
        return 1 if max(abs(q[0]), abs(q[1])) > 8 else -self.least(self.leave, q)

    def stops(self, p, u):
        """All t at which p + t u crosses a side of a square."""
        out = set()
        for k in (0, 1):
            if u[k]:
                out |= {(side - p[k]) / u[k] for side in range(-12, 16)}
        return out


def at(p, u, t):
    return (p[0] + t * u[0], p[1] + t * u[1])


def along(pair, sign, p, u, both_ways, farthest):
    """In units of u; None for +infinity."""
    stops = sorted({t for t in pair.stops(p, u) if both_ways or t >= 0} | {Fraction(0)})
    low = [stops[0] - 1] if both_ways else []
    ends = low + stops + [stops[-1] + 1]
    # Every stop, and every open piece between neighbours with the least and greatest |t| on its closure.
    places = [(sign(at(p, u, t)), abs(t), abs(t)) for t in stops]
    for a, b in zip(ends, ends[1:]):
        places.append((sign(at(p, u, (a + b) / 2)), min(abs(a), abs(b)), max(abs(a), abs(b))))
    here = sign(p)
    if farthest:
        return max((far for s, _, far in places if s <= 0), default=None)
    if here == 0:
        return Fraction(0)
    if here > 0:
        return min((near for s, near, _ in places if s <= 0), default=None)
    return -min(near for s, near, _ in places if s >= 0)


def check_directions(exe, rng, shapes, pair):
    p = tuple(Fraction(rng.randint(-8, 14), 2) for _ in range(2))
    wanted = {}
    for name, sign, farthest in (("gamma1", pair.gamma1, False), ("gamma2", pair.gamma1, True), ("eta1", pair.eta1, False), ("eta2", pair.eta1, True)):
        for mode in ("along", "toward"):
            u = rng.choice([(1, 0), (0, 1), (-1, 0), (1, 1), (2, -1), (-3, 4), (1, 3)])
            value = along(pair, sign, p, u, mode == "along", farthest)
            wanted[f"{name}(B, A, {mode}=({u[0]}, {u[1]}))"] = None if value is None else float(value) * math.hypot(*u)
    scene = {"findspace": 1, "shapes": shapes, "moving": "B", "where": " or ".join(f"{d} <= 0" for d in wanted)}
    done = subprocess.run([exe, "measure", "-", f"--at={float(p[0])},{float(p[1])}", "--json", "-q"], input=json.dumps(scene), capture_output=True, text=True,
                          check=False)
    if done.returncode != 0:
        return done.stderr, scene, 0
    said = json.loads(done.stdout)["distances"]
    for name, value in wanted.items():
        got = said.get(name, "missing")
        if (got is None) != (value is None) or (value is not None and (not isinstance(got, (int, float)) or abs(got - value) > 1e-9)):
            return f"{name} at {float(p[0])},{float(p[1])}: expected {value}, got {got}", scene, 0
    return None, scene, len(wanted)


RELATIONS = {"<": lambda s: s < 0, "<=": lambda s: s <= 0, "=": lambda s: s == 0, "!=": lambda s: s != 0, ">=": lambda s: s >= 0, ">": lambda s: s > 0}


def intervals(holds, stops):
    """Maximal intervals [from, to, from_in, to_in] of a set that changes at the stops only."""
    marks = []  # of each stop and of the piece after it
    for k, t in enumerate(stops):
        marks.append((t, t, holds(t)))
        if k + 1 < len(stops):
            marks.append((t, stops[k + 1], holds((t + stops[k + 1]) / 2)))
    out, run = [], []
    for mark in marks + [(None, None, False)]:
        if mark[2]:
            run.append(mark)
        elif run:
            out.append([float(run[0][0]), float(run[-1][1]), run[0][0] == run[0][1], run[-1][0] == run[-1][1]])
            run = []
    return out


def check_time(exe, rng, shapes, pair):
    legs = rng.randint(1, 3)
    path = [(rng.randint(-5, 6), rng.randint(-5, 6)) for _ in range(legs + 1)]
    drift = (rng.randint(-3, 3), rng.randint(-3, 3)) if rng.random() < 0.4 else (0, 0)
    p = tuple(Fraction(rng.randint(-2, 4), 2) for _ in range(2))
    relative = [tuple(p[k] + path[i][k] - Fraction(i * drift[k], legs) for k in (0, 1)) for i in range(legs + 1)]

    def position(t):
        i = min(int(t * legs), legs - 1)
        s = t * legs - i
        return tuple(relative[i][k] + s * (relative[i + 1][k] - relative[i][k]) for k in (0, 1))

    stops = {Fraction(i, legs) for i in range(legs + 1)}
    for i in range(legs):
        u = tuple(relative[i + 1][k] - relative[i][k] for k in (0, 1))
        stops |= {(i + s) / legs for s in pair.stops(relative[i], u) if 0 <= s <= 1}
    stops = sorted(stops)
    name = rng.choice(["gamma1", "gamma1", "eta1"])
    sign, relation = getattr(pair, name), rng.choice(list(RELATIONS))
    expected = intervals(lambda t: RELATIONS[relation](sign(position(t))), stops)
    motion = {"time": [0, 1], "B": {"path": path}}
    if drift != (0, 0):
        motion["A"] = {"path": [[0, 0], drift]}
    scene = {"findspace": 1, "shapes": shapes, "moving": "B", "where": f"{name}(B, A) {relation} 0", "motion": motion, "free": "time"}
    place = f"--at={float(p[0])},{float(p[1])}"
    done = subprocess.run([exe, "map", "-", place, "--json", "-q"], input=json.dumps(scene), capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        return done.stderr, scene, 0
    said = [[i["from"], i["to"], i["from_in"], i["to_in"]] for i in json.loads(done.stdout)["intervals"]]
    if len(said) != len(expected) or any(abs(a[0] - b[0]) + abs(a[1] - b[1]) > 1e-9 or a[2:] != b[2:] for a, b in zip(said, expected)):
        return f"{place}: expected {expected}, got {said}", scene, 0
    # The extremes over all of the time.
    signs = [sign(position(t)) for t in stops] + [sign(position((a + b) / 2)) for a, b in zip(stops, stops[1:])]
    prefix = rng.choice(["inf", "sup"])
    truth = RELATIONS[relation](min(signs) if prefix == "inf" else max(signs))
    scene = {**scene, "where": f"{prefix} {scene['where']}"}
    del scene["free"]
    done = subprocess.run([exe, "check", "-", place, "--json", "-q"], input=json.dumps(scene), capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        return done.stderr, scene, 0
    if json.loads(done.stdout)["true"] != truth:
        return f"{place}: expected {truth}", scene, 0
    return None, scene, len(expected)


def main(argv):
    parser = argparse.ArgumentParser(usage=__doc__.split("\n\n")[1].removeprefix("usage: "))
    parser.add_argument("executable")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args(argv)
    values = spans = wrong = 0
    for k in range(options.count):
        rng = random.Random(options.seed * 100003 + k)
        small, large = polyomino(rng, rng.randint(1, 3)), polyomino(rng, rng.randint(3, 9))
        shapes = {"A": {"polygon": outline(large)}, "B": {"polygon": outline(small)}}
        pair = Pair(small, large)
        for check in (check_directions, check_time):
            said, scene, count = check(options.executable, rng, shapes, pair)
            if check is check_directions:
                values += count
            else:
                spans += count
            if said:
                wrong += 1
                print(f"instance {k}: {said}\n{json.dumps(scene)}")
    print(f"{values} distances along a direction, {spans} intervals of time, {wrong} disagreements")
    return 1 if wrong or not values or not spans else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
