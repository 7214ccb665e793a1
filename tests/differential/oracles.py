#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Truths of the program against definitions evaluated on points, where no other test of another construction looks.

usage: oracles.py PROGRAM [--count N] [--seed N]

* `turns`: inf and sup over motions that turn, of convex polygons. The oracle steps through the time; what lies between
  its steps is bounded by the speed of the points.
* `instants`: the reach of a slot and a disc that another one is cut out of, at instants of such motions. There rotated
  arcs have rounded ends, so circles that should be one nearly coincide.
* `mixed`: maps of formulas that mix plain distances with `along`, with `rotating` or with a motion, on a line. The
  moving shape is a disc, so each atom has a closed form.
* `lines`: `protrusion` and `hausdorff` above 0 on lines in space, of boxes, tetrahedra and pairs of boxes. The oracle
  takes distances of points to convex sets; of pairs of boxes it takes a lattice of points, and the lattice's spacing as
  a bound.

A sample nearer to a level than the oracle's own bound decides nothing; it is counted apart. Exit status 0 where nothing
disagrees and where at least half of the samples decided."""
import argparse
import json
import math
import random
import subprocess
import sys

from oracle_shapes import Box, Pair, Tetrahedron, apart, hull, lattice, polygon, sub, to_convex

ROUNDING = 1e-6  # of the oracle's doubles, many times over


class Tally:
    def __init__(self):
        self.decided = self.open = 0
        self.wrong = []

    def compare(self, truth, said, what):
        """`truth`: None where the oracle cannot tell."""
        if truth is None:
            self.open += 1
            return
        self.decided += 1
        if truth != said:
            self.wrong.append(what)


def ask(program, verb, scene, *options):
    done = subprocess.run([program, verb, "-", "--json", *options], input=json.dumps(scene), capture_output=True, text=True)
    if done.returncode == 3 and "within the limit of the search" in done.stderr:
        return None  # a refusal that says why
    if done.returncode not in (0, 1, 4):
        sys.exit(f"{verb} ends with {done.returncode}: {done.stderr}\n{json.dumps(scene)}")
    return json.loads(done.stdout)


def at_most(value, level, bound):
    return None if abs(value - level) <= bound else value < level


# Plane


PLANAR = {
    "distance": apart,
    "reach": lambda b, a: max(math.dist(p, q) for p in b for q in a),
    "hausdorff": lambda b, a: max(max(to_convex(p, a) for p in b), max(to_convex(p, b) for p in a)),
}


class Way:
    """A path of two or three points with angles, over the time from 0 to 2."""

    def __init__(self, rng, turns):
        n = rng.randint(2, 3)
        self.path = [(rng.randint(-9, 9), rng.randint(-9, 9)) for _ in range(n)]
        self.angles = [rng.randint(-120, 120) if turns else 0 for _ in range(n)]

    def json(self):
        return {"path": self.path, "angles": self.angles}

    def placed(self, points, t):
        leg = 2 / (len(self.path) - 1)
        k = min(int(t / leg), len(self.path) - 2)
        part = (t - k * leg) / leg
        angle = math.radians(self.angles[k] + part * (self.angles[k + 1] - self.angles[k]))
        x, y = (self.path[k][i] + part * (self.path[k + 1][i] - self.path[k][i]) for i in (0, 1))
        c, s = math.cos(angle), math.sin(angle)
        return [(x + c * p[0] - s * p[1], y + s * p[0] + c * p[1]) for p in points]

    def speed(self, points):
        leg = 2 / (len(self.path) - 1)
        far = max(math.hypot(*p) for p in points)
        return max(
            (math.dist(self.path[k], self.path[k + 1]) + math.radians(abs(self.angles[k + 1] - self.angles[k])) * far) / leg
            for k in range(len(self.path) - 1)
        )


def turns(program, rng, tally):
    a, b = polygon(rng, rng.randint(-4, 4), rng.randint(-4, 4), 5), polygon(rng, 0, 0, 4)
    of_a, of_b = Way(rng, rng.random() < 0.5), Way(rng, True)
    at = (rng.randint(-9, 9), rng.randint(-9, 9))
    steps = 400
    bound = (of_a.speed(a) + of_b.speed(b)) / steps + ROUNDING  # half a step each way, twice the speed for hausdorff
    stages = []
    for k in range(steps + 1):
        t = 2 * k / steps
        stages.append(([(x + at[0], y + at[1]) for x, y in of_b.placed(b, t)], of_a.placed(a, t)))
    for word, distance in PLANAR.items():
        values = [distance(*stage) for stage in stages]
        for extreme, value in (("inf", min(values)), ("sup", max(values))):
            away = rng.uniform(0.3, 2)
            level = round(value - away if value > away and rng.random() < 0.5 else value + away, 2)
            scene = {
                "findspace": 1,
                "shapes": {"A": {"polygon": a}, "B": {"polygon": b}},
                "moving": "B",
                "motion": {"time": [0, 2], "A": of_a.json(), "B": of_b.json()},
                "where": f"{extreme} {word}(B, A) <= {level}",
            }
            said = ask(program, "check", scene, "--at", f"{at[0]},{at[1]}")
            what = f"oracle {value} +- {bound}, at {at}: {json.dumps(scene)}"
            tally.compare(at_most(value, level, bound), said["true"], what)
            atom = said["atoms"][0]
            low, high = atom.get("lower", atom["value"]), atom.get("upper", atom["value"])
            tally.compare(low - bound <= value <= high + bound, True, f"{low} to {high}, {what}")


def bitten(rng):
    """A disc without another one, points all along what is left of its rim, and how far they are apart."""
    (x, y), r, r1 = (rng.randint(-3, 3), rng.randint(-3, 3)), rng.choice([2, 2.75, 3]), rng.choice([1, 1.9])
    angle, n = rng.uniform(0, 2 * math.pi), 3000
    hole = (round(x + r * math.cos(angle), 2), round(y + r * math.sin(angle), 2))
    rim = [(x + r * math.cos(2 * math.pi * k / n), y + r * math.sin(2 * math.pi * k / n)) for k in range(n)]
    disc = lambda c, radius: {"disc": {"center": c, "radius": radius}}
    kept = [p for p in rim if math.dist(p, hole) >= r1]
    return {"closure": {"difference": [disc((x, y), r), disc(hole, r1)]}}, kept, 2 * math.pi * r / n


def instants(program, rng, tally):
    a, rim, near = bitten(rng)
    ends, r = [(0, 0), (rng.randint(-2, 2), rng.randint(1, 2))], rng.choice([0.5, 1, 1.7])
    ways = Way(rng, True), Way(rng, True)
    scene = {
        "findspace": 1,
        "shapes": {"A": a, "B": {"offset": r, "of": {"polyline": ends}}},
        "moving": "B",
        "motion": {"time": [0, 2], **{name: way.json() for name, way in zip("AB", ways)}},
        "where": "true",
    }
    for _ in range(20):
        t = rng.randrange(2**21) / 2**20  # so that it is said exactly
        placed = ways[0].placed(rim, t)
        value = max(math.dist(p, q) for q in ways[1].placed(ends, t) for p in placed) + r
        found = ask(program, "measure", scene, "--at", "0,0", "--time", repr(t), "--only", "reach")["distances"]["reach(B, A)"]
        tally.compare(value - ROUNDING <= found <= value + near, True, f"reach {value}, said {found} at {t}: {json.dumps(scene)}")


class Atom:
    """word REL level of the disc B (radius r) and one fixed shape; `value` at a centre, infinite where never met."""

    def __init__(self, rng, kind, name, r):
        self.kind, self.name, self.r = kind, name, r
        self.level = 0 if kind == "rotating" and rng.random() < 0.5 else rng.randint(0, 3)
        if kind == "rotating":
            self.level *= 10
        self.relation = rng.choice(["<=", ">="])
        x, y = rng.randint(-10, 10), rng.randint(-10, 10)
        self.direction = rng.choice([(1, 0), (0, 1), (3, 4), (1, 1)])
        if kind in ("along", "rotating"):
            self.center, self.radius = (x, y), rng.randint(1, 4)
            self.shape = {"disc": {"center": [x, y], "radius": self.radius}}
        else:
            points = polygon(rng, x, y, 5)
            self.shape = {"polygon": points}
            self.way = (rng.randint(-8, 8), rng.randint(-8, 8)) if kind == "motion" else (0, 0)
            self.swept = hull(points + [(p[0] + self.way[0], p[1] + self.way[1]) for p in points])

    def text(self):
        extra = {"along": f", along=({self.direction[0]}, {self.direction[1]})", "rotating": ", rotating=(0, 0)"}.get(self.kind, "")
        return f"{'inf ' if self.kind == 'motion' else ''}gap(B, {self.name}{extra}) {self.relation} {self.level}"

    def value(self, p):
        if self.kind == "along":
            return self.along(p)
        if self.kind == "rotating":
            return self.rotating(p)
        return to_convex(p, self.swept) - self.r  # right where it is above 0

    def along(self, p):
        size = math.hypot(*self.direction)
        u = (self.direction[0] / size, self.direction[1] / size)
        d = (self.center[0] - p[0], self.center[1] - p[1])
        s, off = d[0] * u[0] + d[1] * u[1], d[0] * u[1] - d[1] * u[0]
        square = (self.r + self.radius) ** 2 - off**2
        if abs(square) < ROUNDING * (self.r + self.radius + abs(off)) ** 2:
            return None  # they graze each other, which counts
        if square < 0:
            return math.inf
        near, far = s - math.sqrt(square), s + math.sqrt(square)
        return -min(-near, far) if near < 0 < far else min(abs(near), abs(far))

    def rotating(self, p):
        """The angle about the origin by which B meets the disc, in degrees; negative where it does."""
        rho, alpha = math.hypot(*p), math.hypot(*self.center)
        if rho == 0 or alpha == 0:
            return None
        cosine = (rho**2 + alpha**2 - (self.r + self.radius) ** 2) / (2 * rho * alpha)
        if abs(abs(cosine) - 1) < ROUNDING:
            return None
        if cosine > 1:
            return math.inf
        if cosine < -1:
            return -math.inf
        between = math.acos(max(-1, min(1, (p[0] * self.center[0] + p[1] * self.center[1]) / (rho * alpha))))
        return math.degrees(between - math.acos(cosine))

    def holds(self, p):
        value = self.value(p)
        if value is None or abs(value - self.level) < 10 * ROUNDING:
            return None
        return value < self.level if self.relation == "<=" else value > self.level


def joined(word, truths):
    """Of three values."""
    sure = word == "or"
    if sure in truths:
        return sure
    return None if None in truths else not sure


def inside(intervals, t):
    """None at an end."""
    for i in intervals:
        low = -math.inf if i["from"] is None else i["from"]
        high = math.inf if i["to"] is None else i["to"]
        if abs(t - low) < 10 * ROUNDING or abs(t - high) < 10 * ROUNDING:
            return None
        if low < t < high:
            return True
    return False


def mixed(program, rng, tally):
    r = rng.randint(1, 2)
    kinds = rng.choice([["along", "plain", "plain"], ["rotating", "plain", "along"], ["motion", "plain", "plain"], ["motion", "plain", "motion"]])
    atoms = [Atom(rng, kind, f"A{k}", r) for k, kind in enumerate(kinds)]
    words = [rng.choice(["and", "or"]) for _ in range(2)]
    texts = [a.text() for a in atoms]
    through, direction = (rng.randint(-9, 9), rng.randint(-9, 9)), rng.choice([(1, 0), (0, 1), (2, 1), (-3, 5)])
    scene = {
        "findspace": 1,
        "shapes": {"B": {"disc": {"center": [0, 0], "radius": r}}, **{a.name: a.shape for a in atoms}},
        "moving": "B",
        "where": f"({texts[0]} {words[0]} {texts[1]}) {words[1]} {texts[2]}",
        "free": {"line": {"through": through, "direction": direction}},
    }
    moving = {a.name: {"path": [[0, 0], a.way]} for a in atoms if a.kind == "motion"}
    if moving:
        scene["motion"] = {"time": [0, 1], **moving}
    said = ask(program, "map", scene)
    size = math.hypot(*direction)
    for _ in range(60):
        t = rng.uniform(-25, 25)
        p = (through[0] + t * direction[0] / size, through[1] + t * direction[1] / size)
        truths = [a.holds(p) for a in atoms]
        truth = joined(words[1], [joined(words[0], truths[:2]), truths[2]])
        what = f"{truths} at t = {t}, {p}: {json.dumps(scene)}"
        sure = inside(said["intervals"], t)
        possible = inside(said["outer"]["intervals"], t) if "outer" in said else sure
        if sure is None or possible is None or sure == possible:
            tally.compare(truth if sure is not None and possible is not None else None, sure, what)
        # Between the certain and the possible positions nothing is claimed.


# Space


def farthest(b, a, at, back=False):
    """The greatest distance of a point of B + at to A (`back`: of A to B + at), and how much it may be too small."""
    of, to, move = (a, b, (0, 0, 0)) if back else (b, a, at)
    shift = sub(move, at) if back else at
    points = lambda some: [tuple(x + y for x, y in zip(p, shift)) for p in some]
    if not isinstance(to, Pair):
        corners = [c for part in getattr(of, "boxes", [of]) for c in part.corners()]
        return max(to.distance(p) for p in points(corners)), 0.0
    some, near = lattice(of, 6)
    return max(to.distance(p) for p in points(some + of.corners())), near


def value_at(b, a, word, at):
    """The value, and how much it may be too small."""
    value, near = farthest(b, a, at)
    if word == "hausdorff":
        other, close = farthest(b, a, at, back=True)
        return max(value, other), max(near, close)
    return value, near


def least_about(b, a, word):
    """A value that some position has, so that a level above it leaves room."""
    corners = [c for part in getattr(a, "boxes", [a]) for c in part.corners()]
    of_b = b.corners()
    middle = [sum(c[k] for c in corners) / len(corners) - sum(c[k] for c in of_b) / len(of_b) for k in range(3)]
    return value_at(b, a, word, middle)[0]


def lines(program, rng, tally):
    b = Box(rng, True) if rng.random() < 0.6 else Tetrahedron(rng)
    a = rng.choice([Box, Tetrahedron, Pair if isinstance(b, Box) else Box])(rng)
    word = rng.choice(["protrusion", "hausdorff"])
    level = round(0.5 + rng.random() * 2 + least_about(b, a, word), 2)
    scene = {
        "findspace": 1,
        "shapes": {"A": a.json(), "B": b.json()},
        "moving": "B",
        "where": f"{word}(B, A) <= {level}",
    }
    said = ask(program, "map", scene, "--resolution", "5")
    if said is None:
        tally.open += 1
        return
    axis = "xyz".index(said["rays"]["axis"])
    for u, v, intervals in said["rays"]["lines"]:
        ends = [e for i in intervals for e in i[:2] if e is not None]
        places = [e + d for e in ends for d in (-0.01, 0.01)] + [rng.uniform(-8, 8) for _ in range(4)]
        for w in places:
            at = [0, 0, 0]
            at[axis], at[(axis + 1) % 3], at[(axis + 2) % 3] = w, u, v
            value, near = value_at(b, a, word, at)
            # The true value lies between value and value + near.
            truth = False if value > level + ROUNDING else True if value + near < level - ROUNDING else None
            inner = any((i[0] is None or i[0] < w) and (i[1] is None or w < i[1]) for i in intervals)
            tally.compare(truth, inner, f"{value} + {near} at {at}: {json.dumps(scene)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=8, help="scenes of each kind")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=["turns", "instants", "mixed", "lines"])
    options = parser.parse_args()
    failed = False
    for test in (turns, instants, mixed, lines):
        if options.only not in (None, test.__name__):
            continue
        rng, tally = random.Random(options.seed), Tally()
        for _ in range(options.count):
            test(options.program, rng, tally)
        print(f"{test.__name__}: {tally.decided} decided, {tally.open} open, {len(tally.wrong)} wrong")
        for what in tally.wrong[:5]:
            print("  wrong:", what)
        failed = failed or bool(tally.wrong) or tally.decided < tally.open
    sys.exit(failed)


if __name__ == "__main__":
    main()
