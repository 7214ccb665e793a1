#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Compares answers for random shapes with answers for the same shapes reflected, turned by right angles, enlarged, shifted and with exchanged roles.

usage: symmetries.py EXECUTABLE [--count 100] [--seed 1]

Such a map f multiplies every distance by its factor k and moves every set of positions with it, so `measure` at a place and `map` of a comparison, or of
`-> min`, must say the same: values times k, areas times k squared, all else unchanged. Exchanging the roles of the two shapes takes p to -p and every
distance to its dual. Shapes are polygons with holes, discs, outlines with arcs (half discs, stadiums, bites, lenses) and unions, differences and offsets
of these, in halves of a unit, so that touching, equal circles, cusps and slots are frequent.

Exit status 0 where nothing disagrees."""
import argparse
import json
import math
import random
import subprocess
import sys

DISTANCES = ["gamma1(B, A)", "gamma2(B, A)", "eta1(B, A)", "eta2(B, A)", "delta1(B, A)", "delta2(B, A)", "mu(B, A)", "mu(A, B)", "hausdorff(B, A)", "d1(B, A)",
             "h(B, A)", "h(A, B)", "dstar(A, B)", "dstar(B, A)", "diameter(B, A)", "penetration(B, A)"]
EXCHANGED = {name: name for name in ["gamma1", "gamma2", "hausdorff", "d1", "d2", "diameter", "penetration"]}
EXCHANGED |= {"eta1": "delta1", "eta2": "delta2", "delta1": "eta1", "delta2": "eta2"}
POWER = {"area": 2, "dangling_length": 1, "crack_length": 1, "minimum": 1}
ALIKE = ["empty", "whole", "open", "closed", "regular", "holes", "attained", *POWER]
NEAR = 1e-7  # relative, of numbers written by two computations


def outline(rng):
    """(corner, arc to the next) ...; an arc is (radius, counter-clockwise)."""
    x, y, w = rng.randint(-3, 1), rng.randint(-3, 1), 2 * rng.randint(1, 3)
    return rng.choice([
        [((x, y), None), ((x + w, y), (w / 2, True))],
        [((x, y), None), ((x + 3, y), (w / 2, True)), ((x + 3, y + w), None), ((x, y + w), (w / 2, True))],
        [((x, y), None), ((x + w, y), (w, True)), ((x, y + w), None)],
        [((x, y), None), ((x + w + 2, y), None), ((x + w + 2, y + w), None), ((x + w + 1, y + w), (w / 2, False)), ((x + 1, y + w), None), ((x, y + w), None)],
        [((x - 3, y), (5, True)), ((x + 3, y), (5, True))]])


def simple(rng):
    x, y = rng.randint(-3, 1), rng.randint(-3, 1)
    at = lambda corners: [(x + a, y + b) for a, b in corners]
    kind = rng.randrange(6)
    if kind == 0:
        return ("disc", (x, y), rng.choice([0.5, 1, 1.5, 2, 3, 5]))
    if kind == 1:
        w, h = rng.randint(1, 4), rng.randint(1, 4)
        return ("polygon", at([(0, 0), (w, 0), (w, h), (0, h)]), [])
    if kind == 2:
        return ("polygon", at([(0, 0), (rng.randint(1, 5), rng.randint(-1, 2)), (rng.randint(-2, 2), rng.randint(3, 5))]), [])
    if kind == 3:
        w, h = rng.randint(4, 7), rng.randint(4, 7)
        a, b = rng.randint(1, w - 2), rng.randint(1, h - 2)
        c, d = rng.randint(a + 1, w - 1), rng.randint(b + 1, h - 1)
        return ("polygon", at([(0, 0), (w, 0), (w, h), (0, h)]), [at([(a, b), (c, b), (c, d), (a, d)])])
    if kind == 4:
        return ("polygon", at(rng.choice([[(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (0, 3)], [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]])), [])
    return ("path", outline(rng))


def shape(rng, depth=0):
    kind = rng.random()
    if depth > 1 or kind < 0.6:
        return simple(rng)
    if kind < 0.8:
        return ("union", shape(rng, depth + 1), shape(rng, depth + 1))
    if kind < 0.9:
        return ("difference", shape(rng, depth + 1), simple(rng))
    return ("offset", rng.choice([1, 0.5, -0.5]), simple(rng))


class Symmetry:
    """Reflection, quarter turns and a factor; `shifted` adds a vector."""

    def __init__(self, rng):
        self.reflects, self.turns, self.factor, self.by = rng.random() < 0.5, rng.randrange(4), rng.choice([1, 1, 2, 0.5, 3]), (0, 0)

    def shifted(self, by):
        other = object.__new__(Symmetry)
        other.__dict__ = {**self.__dict__, "by": by}
        return other

    def point(self, p):
        x, y = (-p[0] if self.reflects else p[0]), p[1]
        for _ in range(self.turns):
            x, y = -y, x
        return (x * self.factor + self.by[0], y * self.factor + self.by[1])

    def shape(self, s):
        if s[0] == "polygon":
            return ("polygon", [self.point(p) for p in s[1]], [[self.point(p) for p in hole] for hole in s[2]])
        if s[0] == "disc":
            return ("disc", self.point(s[1]), s[2] * self.factor)
        if s[0] == "path":
            return ("path", [(self.point(p), arc and (arc[0] * self.factor, arc[1] != self.reflects)) for p, arc in s[1]])
        if s[0] == "offset":
            return ("offset", s[1] * self.factor, self.shape(s[2]))
        return (s[0], self.shape(s[1]), self.shape(s[2]))


def as_json(s):
    if s[0] == "polygon":
        return {"polygon": s[1], "holes": s[2]}
    if s[0] == "disc":
        return {"disc": {"center": s[1], "radius": s[2]}}
    if s[0] == "path":
        ways = [f"L{q[0]} {q[1]}" if arc is None else f"A{arc[0]} {arc[0]} 0 0 {int(arc[1])} {q[0]} {q[1]}" for (_, arc), (q, _) in zip(s[1], s[1][1:] + s[1][:1])]
        return {"path": f"M{s[1][0][0][0]} {s[1][0][0][1]} {' '.join(ways)} Z"}
    if s[0] == "offset":
        return {"offset": s[1], "of": as_json(s[2])}
    if s[0] == "difference":
        return {"closure": {"difference": [as_json(s[1]), {"interior": as_json(s[2])}]}}
    return {"union": [as_json(s[1]), as_json(s[2])]}


def ask(executable, shapes, moving, *arguments, **keys):
    """Status and answer."""
    scene = {"findspace": 1, "shapes": {name: as_json(s) for name, s in shapes.items()}, "moving": moving, **keys}
    done = subprocess.run([executable, arguments[0], "-", *arguments[1:], "--json", "-q"], input=json.dumps(scene), capture_output=True, text=True, check=False, timeout=100)
    return done.returncode, json.loads(done.stdout) if done.stdout.strip() else None


def same(v, w, factor):
    if any(isinstance(n, bool) or not isinstance(n, (int, float)) for n in (v, w)):
        return v == w
    return math.isclose(v * factor, w, rel_tol=NEAR, abs_tol=NEAR)


def exchanged(name):
    """The name of the same distance once A and B have changed roles, or None."""
    kind = name.split("(")[0]
    return f"{EXCHANGED[kind]}(A, B)" if kind in EXCHANGED else None


def summary(answer):
    return {name: answer.get(name) for name in ALIKE} | {"isolated": len(answer["isolated"]), "components": sorted(c["dimension"] for c in answer["components"])}


def measured(executable, rng, shapes, f, by):
    """How many values were compared, and what `measure` says otherwise of the image."""
    p = (rng.randint(-8, 8) / 2, rng.randint(-8, 8) / 2)
    x, y = f.point(p)
    q = (x + by["A"][0] - by["B"][0], y + by["A"][1] - by["B"][1])
    images = {name: f.shifted(by[name]).shape(s) for name, s in shapes.items()}
    exchange = rng.random() < 0.3
    moving, at = ("A", (-q[0], -q[1])) if exchange else ("B", q)
    status, first = ask(executable, shapes, "B", "measure", "--at", f"{p[0]},{p[1]}")
    other, second = ask(executable, images, moving, "measure", "--at", f"{at[0]},{at[1]}")
    if status != 0 or other != 0:  # 3: one of the shapes is empty
        return 0, [] if status == other == 3 else [f"measure ends with {status} and {other}"]
    pairs = [(name, exchanged(name) if exchange else name) for name in first["distances"]]
    pairs = [(name, image) for name, image in pairs if image]
    return len(pairs), [f"{name} = {first['distances'][name]}, {image} = {second['distances'].get(image)} at {p} and {at}" for name, image in pairs
                        if not same(first["distances"][name], second["distances"].get(image), f.factor)]


def mapped(executable, rng, shapes, f, by):
    """What `map` says otherwise of the image."""
    distance, relation, level = rng.choice(DISTANCES), rng.choice(["<", "<=", "=", "!=", ">=", ">"]), rng.choice([0, 0, 0, 1, -1, 0.5, -0.5, 2, 3, 4, 1.5])
    least = rng.random() < 0.15
    where = lambda k: f"{distance} -> min" if least else f"{distance} {relation} {level * k}"
    images = {name: f.shifted(by[name]).shape(s) for name, s in shapes.items()}
    status, first = ask(executable, shapes, "B", "map", where=where(1))
    other, second = ask(executable, images, "B", "map", where=where(f.factor))
    if status != other or status not in (0, 1):
        return [] if status == other == 3 else [f"map of {where(1)} ends with {status} and {other}"]
    v, w = summary(first), summary(second)
    return [f"{where(1)}: {name} {v[name]} and {w[name]}" for name in v if not same(v[name], w[name], f.factor ** POWER.get(name, 0))]


def main(argv):
    parser = argparse.ArgumentParser(usage=__doc__.split("\n\n")[1].removeprefix("usage: "))
    parser.add_argument("executable")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args(argv)
    wrong = compared = 0
    for k in range(options.count):
        rng = random.Random(options.seed * 100003 + k)
        shapes = {"A": shape(rng), "B": shape(rng)}
        f, by = Symmetry(rng), {name: (rng.randint(-5, 5), rng.randint(-5, 5)) for name in "AB"}
        values, said = measured(options.executable, rng, shapes, f, by)
        compared += values
        said += mapped(options.executable, rng, shapes, f, by)
        wrong += bool(said)
        for line in said:
            print(f"scene {k}, factor {f.factor}: {line}\n{json.dumps({name: as_json(s) for name, s in shapes.items()})}")
    print(f"{compared} values and {options.count} maps compared, {wrong} of {options.count} scenes disagree")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
