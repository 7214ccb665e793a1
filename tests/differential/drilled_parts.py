#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Distances of drilled, rounded and shrunk parts in space against branch and bound over cells of points.

usage: drilled_parts.py PROGRAM [--count N] [--seed N|day] [--kind KIND] [--words W,W] [--limit SECONDS]

Parts are boxes, tetrahedra and prisms with capsules, balls and boxes cut out, intersections and unions of such, and what
is left of them when they are shrunk. Their numbers are random decimals; some cuts lie flush with a face on purpose. The
oracle (`drilled_shapes.py`) knows their points alone. It brackets each distance by cells of points:

* `values`: a value at a position, and its truth at a level; each has to meet the bracket. Where a depth has no bracket,
  the place that is said to be nearest must be one, and none of some other places may be nearer.
* `lines`: places of a map on a line, some of them beside the ends that it gives.
* `least`: the value that `-> min` finds is that of its place, and no place near that has less.

Refusals and limits are counted. Exit status 0 where nothing disagrees and most is decided, 77 without numpy."""
import argparse
import json
import math
import os
import random
import subprocess
import sys
import tempfile

try:
    import numpy as np

    from drilled_shapes import Block, Flat, Joined, Outside, Prism, Round, Shrunk, least, lengths, moved
except ImportError:
    sys.exit(77)

TOLERANCE = 0.004  # of the oracle
ROUNDING = 1e-5  # of coordinates on the grid and of doubles, many times over
WORDS = ("gap", "margin", "reach", "protrusion", "covering", "hausdorff", "eta2")


def number(rng, low, high):
    return round(rng.uniform(low, high), rng.choice((1, 2, 4, 6)))


def point(rng, low, high):
    return [number(rng, low[i], high[i]) for i in range(3)]


# Solids


def ball(center, radius):
    return Round(Flat([center]), radius, {"ball": {"center": list(center), "radius": radius}})


def capsule(first, second, radius):
    ends = [{"ball": {"center": list(c), "radius": radius}} for c in (first, second)]
    return Round(Flat([first, second]), radius, {"hull": ends})


def block(low, high):
    return Round(Block(low, high), 0, {"box": {"min": list(low), "max": list(high)}})


def tetrahedron(corners):
    return Round(Flat(corners), 0, {"polytope": [list(c) for c in corners]})


def rounded(solid, radius):
    return Round(solid.core, radius, {"offset": radius, "of": solid.json()})


def some_tetrahedron(rng, size):
    while True:
        c = [point(rng, (-size,) * 3, (size,) * 3) for _ in range(4)]
        if abs(np.linalg.det(np.array(c[1:]) - c[0])) > 0.4 * size**3:
            return tetrahedron(c)


def small(rng):
    """A part that moves, convex."""
    size = number(rng, 0.2, 0.9)
    kind = rng.randrange(7)
    if kind == 0:
        return ball(point(rng, (-0.3,) * 3, (0.3,) * 3), size)
    if kind == 1:
        return capsule(point(rng, (-size,) * 3, (0,) * 3), point(rng, (0,) * 3, (size,) * 3), number(rng, 0.1, 0.5))
    if kind in (2, 3):
        return some_tetrahedron(rng, size + 0.2) if kind == 2 else rounded(some_tetrahedron(rng, size), number(rng, 0.05, 0.4))
    if kind == 4:
        return rounded(block(point(rng, (-size,) * 3, (-0.1,) * 3), point(rng, (0.1,) * 3, (size,) * 3)), number(rng, 0.05, 0.4))
    return block(point(rng, (-size,) * 3, (-0.1,) * 3), point(rng, (0.1,) * 3, (size,) * 3))


def stock(rng):
    """What is drilled: a box, perhaps rounded, or a tetrahedron."""
    kind = rng.randrange(6)
    if kind == 0:
        return some_tetrahedron(rng, 3)
    box = block(point(rng, (-2.5,) * 3, (-0.8,) * 3), point(rng, (0.8,) * 3, (2.5,) * 3))
    return rounded(box, number(rng, 0.1, 0.7)) if kind == 1 else box


def drill(rng, of):
    """A capsule that runs through, or ends in the part, along an axis or not; a ball; a notch."""
    low, high = of.box()
    radius = number(rng, 0.15, 1.1)
    kind = rng.randrange(8)
    middle = point(rng, low, high)
    if kind < 4:
        axis, first = rng.randrange(3), list(middle)
        if rng.random() < 0.2:  # flush with a wall
            other = (axis + 1) % 3
            first[other] = round(float(low[other]) + radius, 6)
        second = list(first)
        first[axis] = round(float(low[axis]) - radius - number(rng, 0.1, 1), 6)
        if kind < 2:
            second[axis] = round(float(high[axis]) + radius + number(rng, 0.1, 1), 6)
        return capsule(first, second, radius)
    if kind == 4:
        return capsule(point(rng, low - 1, high + 1), point(rng, low - 1, high + 1), radius)
    if kind < 7:
        return ball(middle, radius + 0.2)
    return block([round(c - number(rng, 0.2, 2), 6) for c in middle], [round(c + number(rng, 0.2, 2), 6) for c in middle])


def drilled(rng):
    of = stock(rng)
    return Joined("difference", [of, *(drill(rng, of) for _ in range(rng.choice((1, 1, 2, 3))))], rng.random() < 0.3)


def prism(rng):
    x, y, w, v = (number(rng, 1, 2) for _ in range(4))
    low, high = -number(rng, 0.4, 1.5), number(rng, 0.4, 1.5)
    out = Prism([[[-x, -y], [w, -y], [w, 0.1], [0.2, 0.1], [0.2, v], [-x, v]]], low, high)
    parts = [block((-x, -y, low), (w, v, high)), block((0.2, 0.1, low - 3), (w + 3, v + 3, high + 3))]
    if rng.random() < 0.5:
        hole = [[-0.8, -0.7], [-0.8, -0.3], [-0.35, -0.3], [-0.3, -0.75]]
        out.rings.append(np.array(hole))
        parts.append(Round(Flat([(*c, z) for c in hole for z in (low - 3, high + 3)]), 0, None))
    out.of_boxes = Joined("difference", parts)  # the same
    return out


def fixed(rng):
    kind = rng.randrange(10)
    if kind < 4:
        return drilled(rng)
    if kind == 4:
        p = prism(rng)
        return Joined("difference", [p, drill(rng, p)])
    if kind == 5:
        sharp = [s for s in (stock(rng), some_tetrahedron(rng, 2.5)) if not s.radius]
        return Joined("union", [rounded(s, number(rng, 0.1, 0.5)) for s in sharp])
    if kind == 6:
        return Joined("union", [drilled(rng), stock(rng)])
    if kind == 7:
        middle, radius = point(rng, (-1,) * 3, (1,) * 3), number(rng, 0.7, 2.2)
        cube = block([round(c - 1, 6) for c in middle], [round(c + 1, 6) for c in middle])
        return Joined("intersection", [stock(rng), rng.choice((ball(middle, radius), rounded(cube, radius)))])
    return Left(drilled(rng), rng)


class Left(Shrunk):
    """What is left of a drilled part, shrunk by a ball or by a box."""

    def __init__(self, of, rng):
        self.source = of
        if rng.random() < 0.5:
            r = number(rng, 0.05, 0.4)
            self.text = {"offset": -r, "of": of.json()}
            super().__init__(of, ball((0, 0, 0), r))
        else:
            by = block(point(rng, (-0.4,) * 3, (-0.05,) * 3), point(rng, (0.05,) * 3, (0.4,) * 3))
            self.text = {"minkowski_difference": [of.json(), by.json()]}
            super().__init__(of, Round(Block(-by.core.high, -by.core.low), 0, None))

    def json(self):
        return self.text


# Values


def at(solid, p):
    return Round(moved(solid.core, np.array(p)), solid.radius, None)


def convex(solid):
    return isinstance(solid, Round) or isinstance(solid, Joined) and solid.word == "intersection"


def fits(b, a):
    """Where b, not moved, lies in a, as a solid of positions; None where that is not one of convex sets and cuts."""
    if isinstance(a, Left):
        return Shrunk(a.source, b.plus(a.by))
    if isinstance(a, Prism):
        return Shrunk(a.of_boxes, b)
    if isinstance(a, Joined) and a.word == "difference" and isinstance(a.solids[0], Prism):
        of = a.solids[0].of_boxes
        return Shrunk(Joined("difference", of.solids + a.solids[1:]), b)
    if not (convex(a) or isinstance(a, Joined) and a.word == "difference" and convex(a.solids[0])):
        return None
    return Shrunk(a, b)


def overlaps(b, a):
    if isinstance(a, Joined) and a.word == "union" and all(isinstance(s, Round) for s in a.solids):
        return Joined("union", [s.plus_reflected(b) for s in a.solids])
    return a if len(b.core.corners) == 1 and b.radius == 0 else None


def negative(bounds):
    return -bounds[1], -bounds[0]


class Oracle:
    def __init__(self, b, a, p):
        self.b, self.a, self.p = b, a, np.array(p, float)
        self.there = at(b, p)

    def least(self, solid, value):
        return least(solid, value, TOLERANCE)

    def outside(self):
        return Outside(self.a, *self.around())

    def around(self):
        low, high = self.a.box()
        low_b, high_b = self.there.box()
        return np.minimum(low, low_b) - 0.5, np.maximum(high, high_b) + 0.5

    def from_position(self, points):
        return lengths(points - self.p)

    def gap(self):
        low, high, _ = self.least(self.a, self.there.field)
        if low > 0 or high >= 0:
            return max(low, 0) if high < 0 or low > 0 else -np.inf, high
        where = overlaps(self.b, self.a)
        if where is None:
            return -np.inf, high
        size = np.max(np.abs(where.box())) + np.abs(self.p).max()
        low, high, _ = self.least(Outside(where, self.p - size, self.p + size), self.from_position)
        return -high, -low

    def margin(self):
        low, high, _ = self.least(self.outside(), self.there.field)
        if low > 0:
            return low, high
        where = fits(self.b, self.a)
        if high >= -ROUNDING or where is None:
            return -np.inf, max(high, 0) if high >= 0 else 0.0
        low, high, _ = self.least(where, self.from_position)
        return -high, -low

    def reach(self):
        return negative(self.least(self.a, lambda x: -self.there.farthest(x)))

    def eta2(self):
        where = fits(self.b, self.a)
        if where is None:
            return 0, np.inf
        low, high, place = self.least(where, lambda q: -self.from_position(q))
        return (-np.inf if place is None else -high), -low

    def covering(self):
        """How far A extends beyond B."""
        return negative(self.least(self.a, lambda x: -self.there.field(x)))

    def protrusion(self):
        low, high, _ = self.least(self.outside(), self.there.field)
        if low > 0:
            return -high, -low
        # The distance of points of b to a, from below by fields and from above by points of a.
        lower, upper, _ = self.least(self.there, lambda x: -self.a.field(x))
        return -upper, np.inf

    def hausdorff(self):
        some, others = self.protrusion(), self.covering()
        return max(some[0], others[0]), max(some[1], others[1])

    def confirm(self, word, value, nearest, rng):
        """Of a value below 0 that is not bracketed: whether the place given is one, and whether none of some is nearer."""
        away = lambda solid, q: least(solid, at(self.b, q).field, 1e-4)
        solid = (lambda q: self.a) if word == "gap" else lambda q: Oracle(self.b, self.a, q).outside()
        if nearest is not None:
            if abs(np.linalg.norm(np.array(nearest) - self.p) + value) > ROUNDING:
                return "nearest is not so far"
            if away(solid(nearest), nearest)[1] < -ROUNDING:
                return "nearest does not belong"
        for _ in range(30):
            way = rng.normal(size=3)
            q = self.p + way / np.linalg.norm(way) * -value * rng.uniform(0.6, 0.999)
            if away(solid(q), q)[0] > ROUNDING:
                return f"{list(q)} is nearer"
        return None


NAMES = {"protrusion": "protrusion(B, A)", "covering": "protrusion(A, B)"}


def questions(rng):
    a, b = fixed(rng), small(rng)
    low, high = a.box()
    if (high - low < 0.2).any():
        return
    for _ in range(2):
        p = point(rng, low - rng.choice((0, 1)), high + rng.choice((0, 1)))
        oracle = Oracle(b, a, p)
        moving = rng.choice("BBA")
        for word in WORDS:
            scene = {"findspace": 1, "shapes": {"A": a.json(), "B": b.json()}, "moving": moving}
            scene["where"] = NAMES.get(word, f"{word}(B, A)") + f" <= {number(rng, -0.5, 2)}"
            where = p if moving == "B" else [-c for c in p]
            yield oracle, word, {"verb": "check", "scene": scene, "options": {"at": where}}


def line_question(rng):
    a, b = fixed(rng), small(rng)
    low, high = a.box()
    if (high - low < 0.2).any():
        return
    for word, relation in rng.sample([(w, r) for w in ("gap", "margin", "reach", "covering") for r in ("<=", ">=")], 2):
        level = number(rng, -0.3, 0.8) if word in ("gap", "margin") else number(rng, 1, 4)
        through, way = point(rng, low, high), [rng.randint(-3, 3) for _ in range(3)]
        if rng.random() < 0.4:
            way = rng.choice(([1, 0, 0], [0, 1, 0], [0, 0, 1]))
        if way == [0, 0, 0]:
            continue
        scene = {"findspace": 1, "shapes": {"A": a.json(), "B": b.json()}, "moving": "B"}
        scene["where"] = NAMES.get(word, f"{word}(B, A)") + f" {relation} {level}"
        scene["free"] = {"line": {"through": through, "direction": way}}
        yield (a, b, word, relation, level, through, way), "line " + word, {"verb": "map", "scene": scene, "options": {}}


def compare_line(asked, _, line, answer):
    a, b, word, relation, level, through, way = asked
    rng = random.Random(line["id"])
    intervals = answer["result"]["intervals"]
    unit = np.array(way) / np.linalg.norm(way)
    ends = [e for i in intervals for e in (i["from"], i["to"]) if e is not None and abs(e) < 20]
    decided = 0
    for t in [rng.uniform(-4, 4) for _ in range(4)] + [e + d for e in ends[:4] for d in (-0.02, 0.02)]:
        said = any((i["from"] is None or i["from"] < t) and (i["to"] is None or t < i["to"]) for i in intervals)
        low, high = getattr(Oracle(b, a, np.array(through) + t * unit), word)()
        truth = None if low <= level + ROUNDING and high >= level - ROUNDING else (high < level) == (relation == "<=")
        if truth is None:
            continue
        decided += 1
        if truth != said:
            return "WRONG", f"at t = {t} ({list(np.array(through) + t * unit)}) {low} to {high}, said {said}"
    return ("right" if decided > 3 else "open"), ""


def least_question(rng):
    a, b = fixed(rng), small(rng)
    low, high = a.box()
    if (high - low < 0.2).any():
        return
    word = rng.choice(("eta1", "reach"))
    scene = {"findspace": 1, "shapes": {"A": a.json(), "B": b.json()}, "moving": "B"}
    scene["where"] = f"{word}(B, A) -> min"
    yield (a, b, word), "least " + word, {"verb": "map", "scene": scene, "options": {"resolution": 2}}


def compare_least(asked, _, line, answer):
    a, b, word = asked
    rng = random.Random(line["id"])
    result = answer["result"]
    value, place = result.get("minimum"), result.get("at")
    if value is None or place is None:
        return "no value", json.dumps(result)[:300]
    lower = result.get("lower", result.get("bound", value))
    lower = -math.inf if lower in (None, "-inf") else lower
    name, sign = {"eta1": ("margin", -1), "reach": ("reach", 1)}[word]
    bounds = lambda q: sorted(sign * v for v in getattr(Oracle(b, a, q), name)())
    low, high = bounds(place)
    if value < low - 1e-4 or value > high + 1e-4:
        return "WRONG", f"value {value} at {place}: {low} to {high}"
    for _ in range(25):
        size = rng.choice((1.0, 0.3, 0.1, 0.02))
        q = [c + rng.gauss(0, size) for c in place]
        low, high = bounds(q)
        if high < lower - 1e-4:
            return "WRONG", f"value {value}, lower {lower}; at {q}: {low} to {high}"
    return "right", ""


def enclosed(atom):
    value = atom.get("value")
    if value in (None, "-inf"):
        return None
    lower, upper = atom.get("lower", value), atom.get("upper", value)
    return float(lower), float("inf" if upper is None else upper)


def compare_value(oracle, word, line, answer):
    low, high = getattr(oracle, word)()
    atom = answer["result"]["atoms"][0]
    said = enclosed(atom)
    level = float(line["scene"]["where"].split("<=")[1])
    truth = answer["result"]["true"]
    what = f"oracle {low} to {high}, said {said} {truth} level {level}"
    if truth and low > level + ROUNDING or not truth and high < level - ROUNDING:
        return "WRONG truth", what
    refused = {k: v for k, v in answer["result"].get("not_computed", {}).items() if k != "nearest_feasible"}
    if refused:
        return "refused", str(refused)
    if said is None:
        return ("none" if low in (-np.inf, 0) else "WRONG none"), what
    if said[1] < low - ROUNDING or said[0] > high + ROUNDING:
        return "WRONG", what
    if high - low < 0.05:
        return "right", what
    if word in ("gap", "margin") and said[1] < -ROUNDING:
        nearest = atom.get("witness", {}).get("nearest")
        if nearest is not None and line["scene"]["moving"] == "A":
            nearest = [-c for c in nearest]
        wrong = oracle.confirm(word, (said[0] + said[1]) / 2, nearest, np.random.default_rng(line["id"]))
        return (f"WRONG: {wrong}" if wrong else "confirmed"), what
    return "open", what


KINDS = {
    "values": (questions, compare_value),
    "lines": (line_question, compare_line),
    "least": (least_question, compare_least),
}


def answers_of(program, lines):
    with tempfile.TemporaryDirectory() as folder:
        asked, answered = os.path.join(folder, "questions.jsonl"), os.path.join(folder, "answers.jsonl")
        with open(asked, "w") as f:
            f.writelines(json.dumps(line) + "\n" for line in lines)
        subprocess.run([program, "batch", asked, "-o", answered, "-q"], check=False, stdout=subprocess.DEVNULL)
        with open(answered) as f:
            return [json.loads(line) for line in f]


def seed_of(text):
    if text != "day":
        return int(text)
    turn = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../tools/turn")
    return int(subprocess.run([turn, "1000"], capture_output=True, check=True).stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=8, help="pairs of parts")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--kind", default="values", choices=KINDS)
    parser.add_argument("--words", help="only these distances")
    parser.add_argument("--limit", type=float, default=20, help="seconds a question")
    parser.add_argument("--show", action="store_true", help="prints refusals and limits, too")
    options = parser.parse_args()
    rng = random.Random(seed_of(options.seed))
    make, compare = KINDS[options.kind]
    asked = []
    for _ in range(options.count):
        for about, word, line in make(rng):
            if options.words is None or word in options.words.split(","):
                line["options"] = {**line["options"], "time-limit": options.limit, "threads": 1}
                asked.append((about, word, {"id": len(asked), **line}))
    counts, wrong = {}, 0
    for (about, word, line), answer in zip(asked, answers_of(options.program, [line for _, _, line in asked])):
        if answer["exit"] in (0, 1):
            kind, note = compare(about, word, line, answer)
        else:
            kind = {3: "refused", 4: "limit"}.get(answer["exit"], "WRONG status")
            note = answer.get("error", "")
        key = (word, kind.split(":")[0])
        counts[key] = counts.get(key, 0) + 1
        wrong += kind.startswith("WRONG")
        if kind.startswith("WRONG") or (options.show and kind in ("refused", "limit")):
            print(f'{kind} {word} in {answer["seconds"]:.1f} s {note}\n  {json.dumps(line)}', flush=True)
    for key in sorted(counts):
        print(*key, counts[key])
    decided = sum(n for (_, kind), n in counts.items() if kind in ("right", "confirmed", "none"))
    sys.exit(wrong > 0 or 2 * decided < len(asked))


if __name__ == "__main__":
    main()
