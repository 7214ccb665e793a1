#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Asks two programs the same random questions in space and compares what they say: of a change of the searches, the program before and the one after.

usage: same_answers.py OLD NEW [--count 100] [--seed 1] [--limit 30]

A scene has two shapes of the classes below. Both programs give all distances at a position (`measure --all`), the truth of an atom there (`check`), the atom
on a few lines (`map`), and now and then its least value. Counted are the questions, and of these:

  same       the very same text
  enclosed   another number: what the two programs say encloses the value has a place in common
  gained     a value where there was none
  lost       no value where there was one
  widened    a value that was exact and is now enclosed
  differ     anything else: a value that cannot be the same

The seconds of both programs are those of the processor, in all. Exit status 1 where anything was lost or differs."""
import argparse
import collections
import json
import math
import os
import random
import subprocess
import sys
import time

ATOMS = ["gap(B, A)", "margin(B, A)", "protrusion(B, A)", "protrusion(A, B)", "hausdorff(B, A)", "reach(B, A)", "cover(B, A)", "eta2(B, A)", "delta2(B, A)"]
LEVELS = [-0.5, -0.25, 0, 0, 0.25, 0.5, 1, 3]
NEAR = 1e-11  # relative, of two numbers that are written as exact


def box(low, size):
    return {"box": {"min": list(low), "max": [a + b for a, b in zip(low, size)]}}


def ball(center, radius):
    return {"ball": {"center": list(center), "radius": radius}}


def torus(rng, around, across):
    """Of triangles about z, with six decimals."""
    far, thick = rng.choice([1.5, 2, 3]), rng.choice([0.5, 0.75, 1])
    corners, faces = [], []
    for i in range(around):
        for j in range(across):
            u, v = math.tau * i / around, math.tau * j / across
            r = far + thick * math.cos(v)
            corners.append([round(c, 6) for c in (r * math.cos(u), r * math.sin(u), thick * math.sin(v))])
            p, q = i * across + j, (i + 1) % around * across + j
            s, t = (i + 1) % around * across + (j + 1) % across, i * across + (j + 1) % across
            faces += [[p, q, s], [p, s, t]]
    return {"mesh": {"vertices": corners, "faces": faces}}


def bumpy(rng, rows):
    """A sphere with bumps."""
    size, bump, waves = rng.choice([1, 2, 3]), rng.choice([0, 0.1, 0.25]), rng.randint(2, 4)
    ring = 2 * rows
    at = lambda u, v: [round(c * size * (1 + bump * math.sin(waves * u) * math.sin(v) ** 2), 6)
                       for c in (math.sin(v) * math.cos(u), math.sin(v) * math.sin(u), math.cos(v))]
    corners = [at(0, 0), at(0, math.pi)] + [at(math.tau * j / ring, math.pi * i / rows) for i in range(1, rows) for j in range(ring)]
    index = lambda i, j: 2 + (i - 1) * ring + j % ring
    faces = []
    for j in range(ring):
        faces += [[0, index(1, j), index(1, j + 1)], [1, index(rows - 1, j + 1), index(rows - 1, j)]]
        for i in range(1, rows - 1):
            faces += [[index(i, j), index(i + 1, j), index(i + 1, j + 1)], [index(i, j), index(i + 1, j + 1), index(i, j + 1)]]
    return {"mesh": {"vertices": corners, "faces": faces}}


class Shapes:
    """One function a class of shapes."""

    def __init__(self, rng):
        self.rng = rng

    def point(self, most=4):
        return [self.rng.randint(-2 * most, 2 * most) / 2 for _ in range(3)]

    def size(self):
        return [self.rng.choice([0.5, 1, 2, 3, 4]) for _ in range(3)]

    def block(self):
        return box(self.point(2), self.size())

    def blocks(self):
        return {"union": [self.block() for _ in range(self.rng.randint(2, 3))]}

    def polytope(self):
        return {"polytope": [self.point(2) for _ in range(self.rng.randint(5, 8))]}

    def polytopes(self):
        return {"union": [self.polytope(), self.rng.choice([self.polytope, self.block])()]}

    def round(self):
        return ball(self.point(1), self.rng.choice([0.5, 1, 1.5, 2]))

    def rounds(self):
        return {"union": [self.round() for _ in range(self.rng.randint(2, 3))]}

    def capsule(self):
        r = self.rng.choice([0.5, 1])
        return {"hull": [ball(self.point(1), r), ball(self.point(2), r)]}

    def rounded(self):
        return {"offset": self.rng.choice([0.25, 0.5, 1]), "of": self.rng.choice([self.block, self.polytope, self.prism])()}

    def mixed(self):
        return {"union": [self.rng.choice([self.rounded, self.capsule])(), self.rng.choice([self.block, self.round, self.capsule])()]}

    def prism(self):
        w, h = self.rng.randint(3, 5), self.rng.randint(3, 5)
        corners = self.rng.choice([[(0, 0), (w, 0), (w, 1), (1, 1), (1, h), (0, h)], [(0, 0), (w, 1), (w - 1, h)],
                                   [(0, 0), (w, 0), (w, h), (w - 1, h), (w - 1, 1), (1, 1), (1, h), (0, h)]])
        return {"prism": {"polygon": [list(p) for p in corners], "z": [-1, self.rng.choice([0, 1])]}}

    def hollow(self):
        w, h = self.rng.randint(3, 5), self.rng.randint(3, 5)
        return {"prism": {"polygon": [[0, 0], [w, 0], [w, h], [0, h]], "holes": [[[1, 1], [w - 1, 1], [w - 1, h - 1], [1, h - 1]]], "z": [-1, 1]}}

    def bowl(self):
        return {"difference": [self.rng.choice([self.block, self.round, self.prism])(), {"interior": self.round()}]}

    def lens(self):
        return {"intersection": [ball([0, 0, 0], 2), self.rng.choice([ball([1, 0, 0], 2), box([-1, -1, -1], [4, 4, 4])])]}

    def ring(self):
        return torus(self.rng, *self.rng.choice([(8, 5), (10, 6), (12, 6)]))

    def ring_large(self):
        return torus(self.rng, 20, 12)

    def bumps(self):
        return bumpy(self.rng, self.rng.choice([6, 8, 10]))

    def outside(self):
        return {"complement": self.rng.choice([self.block, self.polytope, self.round, self.blocks, self.prism])()}

    CLASSES = ["block", "blocks", "polytope", "polytopes", "round", "rounds", "capsule", "rounded", "mixed", "prism", "hollow", "bowl", "lens", "ring",
               "ring_large", "bumps", "outside"]

    def any(self, among=None):
        name = self.rng.choice(among or self.CLASSES)
        return name, getattr(self, name)()


class Program:
    def __init__(self, path, limit):
        self.path, self.limit, self.seconds = path, limit, 0.0

    def ask(self, scene, *arguments):
        """Status and text; None: it took too long."""
        before = os.times()
        try:
            done = subprocess.run([self.path, arguments[0], "-", *arguments[1:], "--json", "-q", "--threads", "1"], input=json.dumps(scene), capture_output=True,
                                  text=True, timeout=self.limit, check=False)
        except subprocess.TimeoutExpired:
            return None, None
        finally:
            after = os.times()
            self.seconds += after.children_user + after.children_system - before.children_user - before.children_system
        if done.returncode > 1:
            return done.returncode, done.stderr.strip().splitlines()[-1:]
        return done.returncode, json.loads(done.stdout)


def numbers(x):
    """All numbers of a JSON value, in order, and all else."""
    if isinstance(x, bool) or x is None or isinstance(x, str):
        return [], [x]
    if isinstance(x, (int, float)):
        return [x], []
    found, rest = [], []
    for y in (x.values() if isinstance(x, dict) else x):
        n, r = numbers(y)
        found += n
        rest += r
    return found, rest


class Count:
    def __init__(self):
        self.all, self.told = collections.Counter(), 0

    def say(self, kind, *what):
        self.all[kind] += 1
        self.all["questions"] += 1
        if kind in ("differ", "lost", "widened") and self.told < 40:
            self.told += 1
            print(kind, *what, flush=True)

    def values(self, where, old, new):
        """Of `measure`: each distance a question."""
        for name, v in old["distances"].items():
            w = new["distances"].get(name)
            exact = [not any(name in x.get(end, {}) for end in ("lower", "upper")) for x in (old, new)]
            if v == w and (v is None or exact[0] == exact[1]):
                self.say("same")
            elif v is None or w is None:
                self.say("gained" if v is None else "lost", where, name, v, w)
            else:
                size = 1 + abs(v) if isinstance(v, float) or isinstance(v, int) else 1
                ends = []
                for x, value in ((old, v), (new, w)):
                    ends.append((x.get("lower", {}).get(name, value), x.get("upper", {}).get(name, value)))
                (a, b), (c, d) = ends
                if isinstance(v, str) or isinstance(w, str) or not (a <= d + NEAR * size and c <= b + NEAR * size):
                    self.say("differ", where, name, v, w)
                else:
                    self.say("widened" if exact[0] and not exact[1] and d - c > NEAR * size else "enclosed", where, name, v, w)

    def answers(self, where, what, old, new, near):
        """Of `check` and `map`."""
        if old == new:
            return self.say("same")
        (status, x), (other, y) = old, new
        if status is None or other is None:
            return self.say("same" if status == other else "gained" if status is None else "lost", where, what, "took too long")
        if status > 1 or other > 1:
            return self.say("same" if status > 1 and other > 1 else "gained" if status > 1 else "lost", where, what, x if status > 1 else "", y if other > 1 else "")
        (m, r), (n, s) = numbers(x), numbers(y)
        if status != other or r != s or len(m) != len(n) or any(abs(a - b) > near * (1 + abs(a)) for a, b in zip(m, n)):
            return self.say("differ", where, what, str(x)[:300], str(y)[:300])
        return self.say("enclosed")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("--count", type=int, default=100, help="scenes")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--limit", type=float, default=30, help="seconds a question")
    parser.add_argument("--only", default="", help="classes of shapes, with commas between")
    options = parser.parse_args()
    old, new, count, begun = Program(options.old, options.limit), Program(options.new, options.limit), Count(), time.time()
    slow = []
    for k in range(options.count):
        seed = options.seed * 100000 + k
        rng = random.Random(seed)
        shapes, only = Shapes(rng), options.only.split(",") if options.only else None
        (a, fixed), (b, moving) = shapes.any(only), shapes.any()
        scene = {"findspace": 1, "shapes": {"A": fixed, "B": moving}, "moving": "B"}
        where = f"scene {seed} ({a}, {b})"
        p = ",".join(f"{c:g}" for c in (shapes.point(2) if rng.random() < 0.6 else [round(rng.uniform(-4, 4), 3) for _ in range(3)]))
        atom = f"{rng.choice(ATOMS)} {rng.choice(['<=', '>=', '<', '='])} {rng.choice(LEVELS)}"
        before = old.seconds, new.seconds
        x, y = (program.ask(scene, "measure", "--all", "--at", p) for program in (old, new))
        if x[0] == 0 and y[0] == 0:
            count.values(where, x[1], y[1])
        else:
            count.answers(where, "measure", x, y, 0)
        with_atom = {**scene, "where": atom}
        count.answers(where, f"check {atom} at {p}", old.ask(with_atom, "check", "--at", p), new.ask(with_atom, "check", "--at", p), 1e-6)
        if rng.random() < 0.5:
            count.answers(where, f"map {atom}", old.ask(with_atom, "map", "--resolution", "5"), new.ask(with_atom, "map", "--resolution", "5"), 1e-6)
        if rng.random() < 0.2:
            least = {**scene, "where": atom.split(" ")[0] + atom.split(" ")[1] + " -> min"}
            count.answers(where, "least", old.ask(least, "map"), new.ask(least, "map"), 1e-6)
        slow.append((new.seconds - before[1] - (old.seconds - before[0]), where))
    slow.sort()
    print(dict(sorted(count.all.items())))
    print(f"processor time: {old.seconds:.1f} s, {new.seconds:.1f} s; {time.time() - begun:.0f} s by the clock")
    print("slower:", ", ".join(f"{where} by {by:.2f} s" for by, where in slow[-3:]), "; faster:", ", ".join(f"{where} by {-by:.2f} s" for by, where in slow[:3]))
    return 1 if count.all["differ"] or count.all["lost"] else 0


if __name__ == "__main__":
    sys.exit(main())
