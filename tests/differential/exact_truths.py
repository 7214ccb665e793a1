#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Truths of mixed formulas in the plane against fractions, also where a distance is exactly its level.

usage: exact_truths.py PROGRAM [--count N] [--seed N|day]

Shapes are convex polygons, slots and discs, rounded (`exact_convex.py`). Atoms are of all distances, along directions,
of unions, and over motions; they are joined by and, or and not. Half of the positions are made to touch a level. At each
the truth of `check`, of its atoms and of the map on the line through the position are compared. Exit status 0 where
nothing disagrees."""
import argparse
import json
import random
import subprocess
import sys
import time
from fractions import Fraction

import exact_convex as exact
from exact_convex import Round, add, sub

RELATIONS = {
    "<": lambda s: s < 0,
    "<=": lambda s: s <= 0,
    "=": lambda s: s == 0,
    "!=": lambda s: s != 0,
    ">=": lambda s: s >= 0,
    ">": lambda s: s > 0,
}
WORDS = {
    "gap": exact.gap,
    "reach": exact.reach,
    "protrusion": exact.protrusion,
    "hausdorff": exact.hausdorff,
    "margin": exact.margin,
    "cover": exact.cover,
}
UNITS = [(Fraction(x, n), Fraction(y, n)) for a, b, n in ((1, 0, 1), (3, 4, 5)) for x, y in ((a, b), (-b, a), (-a, -b), (b, -a))]


def ask(program, verb, scene, *options):
    done = subprocess.run([program, verb, "-", "--json", *options], input=json.dumps(scene), capture_output=True, text=True)
    if done.returncode not in (0, 1):
        sys.exit(f"{verb} ends with {done.returncode}: {done.stderr}\n{json.dumps(scene)}")
    return json.loads(done.stdout)


def shape(rng, far, size):
    x, y = rng.randint(-far, far), rng.randint(-far, far)
    radius = rng.choice([0, 0, 1, 2, Fraction(1, 2)])
    kind = rng.choice(["disc", "slot", "box", "turned", "any"])
    if kind == "disc":
        return Round([(x, y)], rng.randint(1, 3))
    if kind == "slot":
        w, h = rng.choice([(3, 4), (4, -3), (2, 0), (0, 3), (1, 1)])
        return Round([(x, y), (x + w, y + h)], rng.choice([1, 2, Fraction(1, 2)]))
    if kind == "box":
        w, h = rng.randint(1, size), rng.randint(1, size)
        return Round([(x, y), (x + w, y), (x + w, y + h), (x, y + h)], radius)
    if kind == "turned":
        return Round([(x, y), (x + 4, y + 3), (x + 1, y + 7), (x - 3, y + 4)], radius)
    while True:
        out = Round([(x + rng.randint(-size, size), y + rng.randint(-size, size)) for _ in range(5)], radius)
        if len(out.core) > 2:
            return out


class Atom:
    def __init__(self, rng, b, shapes, motion):
        self.b, self.relation = b, rng.choice(list(RELATIONS))
        self.names = [rng.choice(list(shapes))]
        self.level = Fraction(rng.choice([0, 0, 1, 2, 3, Fraction(1, 2), 5, -1, -2]))
        self.word, self.prefix, self.argument = rng.choice([*WORDS, "gap", "gap"]), "", ""
        self.unit, self.way = rng.choice(UNITS), None
        path = motion.get(self.names[0])
        if path:
            self.way = [(-x, -y) for x, y in path]
            self.word = rng.choice(["gap", "reach", "protrusion", "hausdorff", "margin"])
            self.prefix = {"gap": rng.choice(["inf ", "sup "]), "margin": "inf "}.get(self.word, "sup ")
        elif self.word == "gap":
            self.argument = rng.choice(["", ", along", ", toward"])
            if not self.argument and rng.random() < 0.3:
                self.names = [n for n in shapes if n not in motion]
        self.others = [shapes[n] for n in self.names]
        if self.word in ("margin", "cover") or len(self.names) > 1:
            self.level = abs(self.level)
        if self.word in ("reach", "hausdorff"):
            self.level = abs(self.level) + rng.choice([0, 5, 8])
        if self.prefix == "inf " and self.word == "gap":
            self.level = max(self.level, -b.radius - self.others[0].radius)
        if self.argument:
            x, y = (int(5 * c) for c in self.unit)
            self.argument += f"=({x}, {y})"

    def text(self):
        return f"{self.prefix}{self.word}(B, {'+'.join(self.names)}{self.argument}) {self.relation} {float(self.level):g}"

    def sign(self, p):
        a, distance = self.others[0], WORDS[self.word]
        if self.way:
            if self.word == "gap" and self.prefix == "inf ":
                return exact.swept(self.b, a, p, self.level, self.way)
            return (exact.least if self.word == "margin" else exact.greatest)(distance, self.b, a, p, self.level, self.way)
        if self.argument:
            return exact.directed(self.b, a, p, self.level, self.unit, "along" in self.argument)
        return min(distance(self.b, other, p, self.level) for other in self.others)

    def holds(self, p):
        return RELATIONS[self.relation](self.sign(p))

    def touching(self, rng):
        """Positions at which the distance is exactly the level, of some that are likely."""
        out = []
        for _ in range(150):
            a = rng.choice(self.others)
            away = rng.choice([self.level + a.radius + self.b.radius, self.level - a.radius - self.b.radius,
                               self.level + a.radius - self.b.radius, self.level - a.radius + self.b.radius])  # fmt: skip
            u, k = rng.choice(UNITS), rng.choice([0, 0, self.level, -self.level])
            p = add(sub(rng.choice(a.core), rng.choice(self.b.core)), (away * u[0] + k * self.unit[0], away * u[1] + k * self.unit[1]))
            if self.way:
                p = sub(p, rng.choice(self.way))
            if self.sign(p) == 0:
                out.append(p)
        return out[:4]


def joined(rng, atoms):
    """The text of a formula of them, and its truth at a position."""
    if len(atoms) == 1:
        text, holds = atoms[0].text(), atoms[0].holds
    else:
        k = rng.randint(1, len(atoms) - 1)
        (first, holds1), (last, holds2) = joined(rng, atoms[:k]), joined(rng, atoms[k:])
        word, both = rng.choice([("and", all), ("or", any)])
        text, holds = f"({first} {word} {last})", lambda p: both((holds1(p), holds2(p)))
    if rng.random() < 0.2:
        return f"not ({text})", lambda p: not holds(p)
    return text, holds


def on_line(intervals, x):
    for i in intervals:
        low, high = i["from"], i["to"]
        if (low is None or low < x or (low == x and i["from_in"])) and (high is None or x < high or (high == x and i["to_in"])):
            return True
    return False


def compare(program, rng, counts):
    b = shape(rng, 2, 4)
    shapes = {f"A{k}": shape(rng, 6, 8) for k in range(rng.randint(2, 3))}
    motion = {}
    if rng.random() < 0.5:
        motion["A0"] = [(rng.randint(-6, 6), rng.randint(-6, 6)) for _ in range(rng.randint(2, 3))]
    atoms = [Atom(rng, b, shapes, motion) for _ in range(rng.randint(2, 4))]
    text, holds = joined(rng, atoms)
    scene = {"findspace": 1, "shapes": {"B": b.json(), **{n: a.json() for n, a in shapes.items()}}, "moving": "B", "where": text}
    if motion:
        scene["motion"] = {"time": [0, 1], **{n: {"path": path} for n, path in motion.items()}}
    touching = [p for a in atoms for p in a.touching(rng)]
    places = [(Fraction(rng.randint(-30, 30), 2), Fraction(rng.randint(-30, 30), 2)) for _ in range(4)]
    for p in places + rng.sample(touching, min(4, len(touching))):
        if any((c * 10**6).denominator != 1 for c in p):
            continue
        at = [float(c) for c in p]
        said = ask(program, "check", scene, f"--at={at[0]},{at[1]}")
        line = {**scene, "free": {"line": {"through": [0, at[1]], "direction": [1, 0]}}}
        truths = [holds(p), {a.text(): a.holds(p) for a in atoms}]
        here = {a["text"]: a["true"] for a in said["atoms"]}
        counts["truths"] += 2 + len(here)
        counts["at a level"] += any(a.sign(p) == 0 for a in atoms)
        same = truths[1] == here
        mapped = on_line(ask(program, "map", line)["intervals"], at[0])
        if not same or said["true"] != truths[0] or mapped != truths[0]:
            counts["wrong"] += 1
            print("  wrong:", at, truths, "check:", said["true"], here, "map:", mapped, json.dumps(scene))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=10, help="scenes")
    parser.add_argument("--seed", default="1")
    options = parser.parse_args()
    rng = random.Random(time.strftime("%Y-%m-%d") if options.seed == "day" else options.seed)
    counts = {"truths": 0, "at a level": 0, "wrong": 0}
    for _ in range(options.count):
        compare(options.program, rng, counts)
    print(", ".join(f"{n} {what}" for what, n in counts.items()))
    sys.exit(counts["wrong"] > 0 or counts["at a level"] == 0)


if __name__ == "__main__":
    main()
