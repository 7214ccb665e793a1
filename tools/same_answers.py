#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Asks two programs the same random questions in space and compares what they say: of a change of the searches, the program before and the one after.

usage: same_answers.py OLD NEW [--count 100] [--seed 1] [--limit 10] [--fixed bowl,lens] [--moving block] [--tally FILE] [--fields-as-meshes]

A scene has two shapes of the classes below. Both programs are asked for

  values     all distances at two positions (`measure --all`), now and then of a rotated shape; a distance with two names counts once
  truth      a formula at a position (`check`), with the nearest feasible position
  along      distances along a direction, one way and both ways, at a position (`check`)
  lines      an atom on some lines (`map`), also along a direction, along the three axes, and on one line of any direction
  least      now and then a least value (`-> min`)
  shape      now and then the fixed shape itself on lines (`describe`)

Of the questions are counted:

  same       the very same answer
  enclosed   another number: what the two programs say encloses the value has a place in common
  gained     a value where there was none
  neither    no answer of both, refused or late
  lost       no value where there was one
  late       no value within the limit where there was one
  widened    a value that was exact and is now enclosed
  differ     anything else: a value that cannot be the same

They are told by column of the support table, with the processor seconds of both programs. `--tally FILE` adds the counts to those of earlier runs.
`--fields-as-meshes` gives height fields to the old program as the meshes they are, for programs that do not know them.
Exit status 1 where anything was lost or differs."""
import argparse
import collections
import json
import math
import os
import pathlib
import random
import resource
import subprocess
import sys
import time

NAMES = ["gap(B, A)", "margin(B, A)", "protrusion(B, A)", "protrusion(A, B)", "hausdorff(B, A)", "reach(B, A)", "cover(B, A)", "eta2(B, A)", "delta2(B, A)"]
AIMED = ["gap", "margin", "reach", "cover", "eta2", "delta2"]
DIRECTIONS = ["(1, 0, 0)", "(0, -1, 0)", "(0, 0, 1)", "(1, 1, 0)", "(1, 2, 3)", "(-2, 1, 2)", "(1, -1, -3)"]
LEVELS = [-0.5, -0.25, 0, 0, 0.25, 0.5, 1, 3]
# Of `measure --all`: what is not another name or a plain function of one of these.
VALUES = ["gamma1(B, A)", "gamma2(B, A)", "eta1(B, A)", "eta2(B, A)", "delta1(B, A)", "delta2(B, A)", "mu(B, A)", "mu(A, B)", "hausdorff(B, A)", "diameter(B, A)"]
NEAR = 1e-11  # relative, of two numbers that are written as exact
KINDS = ["questions", "same", "enclosed", "gained", "neither", "lost", "late", "widened", "differ"]


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


def ground_mesh(field):
    """The closed mesh of a height field without missing heights, as docs/scene.md defines it."""
    (x0, y0), (dx, dy), rows, floor = field["at"], field["step"], field["heights"], field["floor"]
    columns, corners, faces = len(rows[0]), [], []
    for j, row in enumerate(rows):
        for i, z in enumerate(row):
            corners += [[x0 + i * dx, y0 + j * dy, z], [x0 + i * dx, y0 + j * dy, floor]]
    top = lambda i, j: 2 * (j * columns + i)
    for j in range(len(rows) - 1):
        for i in range(columns - 1):
            a, b, c, d = top(i, j), top(i + 1, j), top(i + 1, j + 1), top(i, j + 1)
            faces += [[a, b, c], [a, c, d], [c + 1, b + 1, a + 1], [d + 1, c + 1, a + 1]]
    rim = [top(i, 0) for i in range(columns)] + [top(columns - 1, j) for j in range(1, len(rows))]
    rim += [top(i, len(rows) - 1) for i in reversed(range(columns - 1))] + [top(0, j) for j in reversed(range(1, len(rows) - 1))]
    for a, b in zip(rim, rim[1:] + rim[:1]):
        faces += [[a + 1, b + 1, b], [a + 1, b, a]]
    return {"mesh": {"vertices": corners, "faces": faces}}


def with_meshes(x):
    """A scene whose height fields are meshes."""
    if isinstance(x, dict):
        return ground_mesh(x["height_field"]) if "height_field" in x else {key: with_meshes(y) for key, y in x.items()}
    return [with_meshes(y) for y in x] if isinstance(x, list) else x


class Shapes:
    """One function a class of shapes."""

    def __init__(self, rng):
        self.rng = rng

    def some(self, *classes):
        return self.rng.choice(classes)()

    def point(self, most=4):
        return [self.rng.randint(-2 * most, 2 * most) / 2 for _ in range(3)]

    def size(self):
        return [self.rng.choice([0.5, 1, 2, 3, 4]) for _ in range(3)]

    # --- boxes
    def block(self):
        return box(self.point(2), self.size())

    def blocks(self):
        return {"union": [self.block() for _ in range(self.rng.randint(2, 3))]}

    def frame(self):
        outer, inner = self.size(), self.size()
        return {"difference": [box([0, 0, 0], [a + b for a, b in zip(outer, inner)]), {"interior": box([a / 2 for a in outer], inner)}]}

    def sheet(self):
        """What two blocks that touch have in common, alone or with a block."""
        low, size, axis = self.point(2), self.size(), self.rng.randrange(3)
        up = [part if k == axis else 0 for k, part in enumerate(size)]
        flat = {"intersection": [box(low, size), box([a + b for a, b in zip(low, up)], size)]}
        return self.rng.choice([flat, {"union": [flat, self.block()]}])

    # --- convex
    def polytope(self):
        return {"polytope": [self.point(2) for _ in range(self.rng.randint(5, 8))]}

    def hull(self):
        return {"hull": [self.some(self.block, self.polytope) for _ in range(2)]}

    def turned(self):
        return {"rotate": self.rng.choice([30, 45, 90]), "axis": self.rng.choice(["x", "z"]), "of": self.some(self.block, self.polytope)}

    # --- round convex
    def round(self):
        return ball(self.point(1), self.rng.choice([0.5, 1, 1.5, 2]))

    def capsule(self):
        r = self.rng.choice([0.5, 1])
        return {"hull": [ball(self.point(1), r), ball(self.point(2), r)]}

    def rounded(self):
        return {"offset": self.rng.choice([0.25, 0.5, 1]), "of": self.some(self.block, self.polytope)}

    # --- flat faces
    def polytopes(self):
        return {"union": [self.polytope(), self.some(self.polytope, self.block)]}

    def prism(self):
        w, h = self.rng.randint(3, 5), self.rng.randint(3, 5)
        corners = self.rng.choice([[(0, 0), (w, 0), (w, 1), (1, 1), (1, h), (0, h)], [(0, 0), (w, 1), (w - 1, h)],
                                   [(0, 0), (w, 0), (w, h), (w - 1, h), (w - 1, 1), (1, 1), (1, h), (0, h)]])
        return {"prism": {"polygon": [list(p) for p in corners], "z": [-1, self.rng.choice([0, 1])]}}

    def hollow(self):
        w, h = self.rng.randint(3, 5), self.rng.randint(3, 5)
        return {"prism": {"polygon": [[0, 0], [w, 0], [w, h], [0, h]], "holes": [[[1, 1], [w - 1, 1], [w - 1, h - 1], [1, h - 1]]], "z": [-1, 1]}}

    def ring(self):
        return torus(self.rng, *self.rng.choice([(8, 5), (10, 6), (12, 6)]))

    def ring_large(self):
        return torus(self.rng, 20, 12)

    def bumps(self):
        return bumpy(self.rng, self.rng.choice([6, 8, 10]))

    def ground(self):
        columns, rows = self.rng.randint(2, 5), self.rng.randint(2, 5)
        return {"height_field": {"at": [-3, -3], "step": [self.rng.choice([1, 1.5, 2]), self.rng.choice([1, 2])], "floor": -3,
                                 "heights": [[self.rng.randint(-4, 6) / 2 for _ in range(columns)] for _ in range(rows)]}}

    def summed(self):
        return {"minkowski_sum": [self.some(self.block, self.prism, self.polytopes), self.some(self.block, self.polytope)]}

    def shrunk(self):
        return self.rng.choice([{"minkowski_difference": [self.prism(), box([-0.125] * 3, [0.25] * 3)]}, {"offset": -0.25, "of": self.some(self.block, self.polytope)}])

    # --- round
    def rounds(self):
        return {"union": [self.round() for _ in range(self.rng.randint(2, 3))]}

    def mixed(self):
        return {"union": [self.some(self.rounded, self.capsule), self.some(self.block, self.round, self.capsule)]}

    def grown(self):
        return self.rng.choice([{"offset": 0.5, "of": self.some(self.prism, self.blocks)}, {"minkowski_sum": [self.some(self.prism, self.rounded), self.round()]}])

    # --- cut
    def bowl(self):
        return {"difference": [self.some(self.block, self.round, self.prism), {"interior": self.round()}]}

    def lens(self):
        return {"intersection": [ball([0, 0, 0], 2), self.rng.choice([ball([1, 0, 0], 2), box([-1, -1, -1], [4, 4, 4])])]}

    def shell(self):
        return {"difference": [ball([0, 0, 0], 3), {"interior": ball([self.rng.choice([0, 0.5]), 0, 0], self.rng.choice([1, 2]))}]}

    def shrunk_round(self):
        return {"offset": -0.25, "of": {"union": [box([-2, -2, -2], [4, 4, 2]), box([-2, -2, -1], [2, 4, 3])]}}

    # --- complements
    def outside(self):
        return {"complement": self.some(self.block, self.polytope, self.round, self.blocks, self.prism)}

    COLUMNS = {"boxes": ["block", "blocks", "frame", "sheet"], "convex": ["polytope", "hull", "turned"], "round convex": ["round", "capsule", "rounded"],
               "flat faces": ["polytopes", "prism", "hollow", "ring", "ring_large", "bumps", "ground", "summed", "shrunk"],
               "round": ["rounds", "mixed", "grown"], "cut": ["bowl", "lens", "shell", "shrunk_round"], "complements": ["outside"]}

    def any(self, among=None):
        name = self.rng.choice(among or [name for names in self.COLUMNS.values() for name in names])
        return name, getattr(self, name)()


def as_infinite(old, new):
    """The old rest of an answer, where a margin of what fits nowhere is the -inf of the new one."""
    return ["-inf" if x is None and y == "-inf" else x for x, y in zip(old, new)] if len(old) == len(new) else old


def column_of(*names):
    """Of the more general shape."""
    columns = list(Shapes.COLUMNS)
    return max((column for name in names for column in columns if name in Shapes.COLUMNS[column]), key=columns.index)


class Questions:
    """Of one scene: what is asked, as (group, keys of the scene, arguments)."""

    def __init__(self, rng, shapes):
        self.rng, self.shapes = rng, shapes

    def place(self):
        p = self.shapes.point(2) if self.rng.random() < 0.6 else [round(self.rng.uniform(-4, 4), 3) for _ in range(3)]
        return ",".join(f"{c:g}" for c in p)

    def compared(self, distance):
        return f"{distance} {self.rng.choice(['<=', '>=', '<', '>', '='])} {self.rng.choice(LEVELS)}"

    def atom(self):
        return self.compared(self.rng.choice(NAMES))

    def aimed(self):
        return self.compared(f"{self.rng.choice(AIMED)}(B, A, {self.rng.choice(['along', 'toward'])}={self.rng.choice(DIRECTIONS)})")

    def map(self):
        """An atom on lines of one axis or of all, or on one line."""
        where = self.aimed() if self.rng.random() < 0.3 else self.atom() if self.rng.random() < 0.8 else f"{self.atom()} or {self.atom()}"
        if self.rng.random() < 0.3:
            return "lines", {"where": where, "free": {"line": {"through": self.shapes.point(2), "direction": self.rng.choice([[0, 0, 1], [1, 2, 3], [-2, 1, 1]])}}}, ["map"]
        lines = self.rng.choice([["--axis", "x"], ["--axis", "z"], ["--axis", "z"], ["--axes"]])
        return "lines", {"where": where}, ["map", "--resolution", "3", *lines]

    def all(self):
        for _ in range(2):
            yield "values", {}, ["measure", "--all", "--at", self.place()]
        if self.rng.random() < 0.3:
            yield "values", {}, ["measure", "--all", "--at", self.place(), "--orientation", self.rng.choice(["1,2,3,4", "z:90", "1,1,0:45"])]
        yield "truth", {"where": self.atom()}, ["check", "--at", self.place()]
        yield "truth", {"where": f"{self.atom()} {self.rng.choice(['and', 'or'])} {self.atom()}"}, ["check", "--at", self.place()]
        for _ in range(4):
            yield "along", {"where": self.aimed()}, ["check", "--at", self.place()]
        for _ in range(3):
            yield self.map()
        if self.rng.random() < 0.15:
            distance = self.rng.choice(["gap(B, A)", "eta1(B, A)", "protrusion(B, A)", "reach(B, A)", "eta2(B, A)", "hausdorff(B, A)", "distance(B, A)"])
            yield "least", {"where": distance + " -> min"}, ["map"]
        if self.rng.random() < 0.3:
            yield "shape", {}, ["describe", "A", "--resolution", "4"]


class Program:
    def __init__(self, path, limit, fields_as_meshes=False):
        self.path, self.limit, self.fields_as_meshes, self.seconds = path, limit, fields_as_meshes, 0.0

    def ask(self, scene, verb, *arguments):
        """Status and answer; None: it took too long."""
        before = os.times()
        scene = with_meshes(scene) if self.fields_as_meshes else scene
        limited = lambda: resource.setrlimit(resource.RLIMIT_CPU, (self.limit, self.limit + 1))
        done = subprocess.run([self.path, verb, "-", *arguments, "--json", "-q", "--threads", "1"], input=json.dumps(scene), capture_output=True, text=True,
                              check=False, preexec_fn=limited)
        after = os.times()
        self.seconds = after.children_user + after.children_system - before.children_user - before.children_system
        if done.returncode < 0:
            return (None, None) if self.seconds >= self.limit - 0.5 else (70, [f"signal {-done.returncode}"])
        if done.returncode > 1:
            return done.returncode, done.stderr.strip().splitlines()[-1:]
        return done.returncode, json.loads(done.stdout)


def bounds(x, name):
    """What encloses a value; a margin that is undefined counts as -inf."""
    value = x.get(name)
    value = "-inf" if value is None and x.get("text", "").startswith(("margin", "cover")) else value
    return x.get("lower", value), x.get("upper", value)


def apart(old, new):
    """The length in which two sets of intervals differ."""
    number = lambda x, else_: min(max(x, -1e6), 1e6) if isinstance(x, (int, float)) else else_
    ends = [(number(end, side), sign, which) for which, line in enumerate((old, new)) for interval in line
            for end, side, sign in ((interval[0], -1e6, 1), (interval[1], 1e6, -1))]
    depth, before, length = [0, 0], 0.0, 0.0
    for at, sign, which in sorted(ends):
        length += at - before if (depth[0] > 0) != (depth[1] > 0) else 0
        depth[which] += sign
        before = at
    return length


class Reading:
    """What an answer says, without the places of its witnesses, of which there may be many."""

    def __init__(self, x):
        atoms = x.get("atoms", [])
        self.facts = [x.get("true"), x.get("empty"), x.get("whole"), x.get("boxes"), x.get("polytope")] + [a["true"] for a in atoms]
        self.ranges = [bounds(a, "value") for a in atoms] + [bounds(x, "minimum")]
        self.nearest = x.get("nearest_feasible")
        self.side = x.get("side") if "intervals" in x else x.get("rays", {}).get("on_lines")
        self.lines = [line[2] for line in x.get("rays", {}).get("lines", [])]
        if "intervals" in x:
            self.lines = [[[i["from"], i["to"], i["from_in"], i["to_in"]] for i in x["intervals"]]]

    def text(self):
        return self.facts, self.ranges, self.nearest and self.nearest["distance"], self.side, self.lines


def within(old, new):
    """Whether two enclosed values may be one: (common, wider)."""
    if any(not isinstance(x, (int, float)) for x in (*old, *new)):
        return old == new, False
    size = NEAR * (1 + abs(old[0]))
    return old[0] <= new[1] + size and new[0] <= old[1] + size, old[0] == old[1] and new[1] - new[0] > size


def verdict(x, y):
    """Of two readings."""
    if x.text() == y.text():
        return "same"
    pairs = [within(a, b) for a, b in zip(x.ranges, y.ranges)]
    near = x.nearest and y.nearest
    if (x.facts != y.facts or len(x.ranges) != len(y.ranges) or not all(common for common, _ in pairs) or len(x.lines) != len(y.lines)
            or any(apart(a, b) > 1e-6 for a, b in zip(x.lines, y.lines)) or near and abs(x.nearest["distance"] - y.nearest["distance"]) > 1e-9):
        return "differ"
    if bool(x.nearest) != bool(y.nearest):
        return "lost" if x.nearest else "gained"
    exact = lambda side: side in (None, "exact")
    if any(wider for _, wider in pairs) or exact(x.side) and not exact(y.side):
        return "widened"
    if exact(x.side) and any([i[2:] for i in a] != [i[2:] for i in b] for a, b in zip(x.lines, y.lines)):
        return "differ"
    return "enclosed"


class Count:
    """Counts and seconds by column of the support table, and by what is asked."""

    def __init__(self, file):
        self.file, self.rows, self.told = file and pathlib.Path(file), {}, 0
        if self.file and self.file.exists():
            self.rows = json.loads(self.file.read_text(encoding="utf-8"))

    def row(self, name):
        return self.rows.setdefault(name, {**{kind: 0 for kind in KINDS}, "old": 0.0, "new": 0.0})

    def begin(self, where, column, group):
        self.where, self.names = where, (column, group, "all")

    def spent(self, old, new):
        for name in self.names:
            self.row(name)["old"] += old
            self.row(name)["new"] += new

    def say(self, kind, *what):
        for name in self.names:
            self.row(name)[kind] += 1
            self.row(name)["questions"] += 1
        if kind in ("differ", "lost", "late", "widened") and self.told < 200:
            self.told += 1
            print(kind, self.where, *what, flush=True)

    def failed(self, old, new, what):
        """Whether one of both gave no answer."""
        (status, x), (other, y) = old, new
        if all(s is not None and s <= 1 for s in (status, other)):
            return False
        if status is None or status > 1:
            self.say("neither" if other is None or other > 1 else "gained", what)
        elif other is None:
            self.say("late", what)
        else:
            self.say("lost", what, y)
        return True

    def values(self, what, old, new):
        """Of `measure`: each distance a question."""
        for name in VALUES:
            if name in old["distances"] or name in new["distances"]:
                v, w = (x["distances"].get(name) for x in (old, new))
                ends = [(x.get("lower", {}).get(name, value), x.get("upper", {}).get(name, value)) for x, value in ((old, v), (new, w))]
                common, wider = within(*ends)
                kind = "same" if ends[0] == ends[1] else "gained" if v is None else "lost" if w is None else "differ" if not common else "widened" if wider else "enclosed"
                self.say(kind, what, name, *ends)

    def answers(self, what, old, new):
        """Of all other questions."""
        self.say(verdict(Reading(old), Reading(new)), what)

    def table(self):
        names = [*Shapes.COLUMNS, "values", "truth", "along", "lines", "least", "shape", "all"]
        print(f"\n| | {' | '.join(KINDS)} | seconds, old | new |\n|---|{'---|' * (len(KINDS) + 2)}")
        for name in names:
            if name in self.rows:
                row = self.rows[name]
                print(f"| {name} | {' | '.join(str(row[kind]) for kind in KINDS)} | {row['old']:.1f} | {row['new']:.1f} |")

    def keep(self):
        if self.file:
            self.file.write_text(json.dumps(self.rows), encoding="utf-8")


def compare(count, scene, question, old, new):
    group, keys, arguments = question
    x, y = (program.ask({**scene, **keys}, *arguments) for program in (old, new))
    count.spent(old.seconds, new.seconds)
    what = " ".join([*arguments, json.dumps(keys)])
    if not count.failed(x, y, what):
        (count.values if group == "values" else count.answers)(what, x[1], y[1])
    return new.seconds - old.seconds


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("--count", type=int, default=100, help="scenes")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--limit", type=int, default=10, help="processor seconds a question")
    classes = lambda text: text.split(",")
    parser.add_argument("--fixed", type=classes, help="classes of the fixed shape, with commas between")
    parser.add_argument("--moving", type=classes, help="those of the moving shape")
    parser.add_argument("--tally", help="a file of counts that these are added to")
    parser.add_argument("--fields-as-meshes", action="store_true", help="for an old program without height fields")
    options = parser.parse_args()
    old, new, count = Program(options.old, options.limit, options.fields_as_meshes), Program(options.new, options.limit), Count(options.tally)
    begun, changes = time.time(), []
    for k in range(options.count):
        seed = options.seed * 100000 + k
        rng = random.Random(seed)
        shapes = Shapes(rng)
        (a, fixed), (b, moving) = shapes.any(options.fixed), shapes.any(options.moving)
        scene = {"findspace": 1, "shapes": {"A": fixed, "B": moving}, "moving": "B"}
        for question in Questions(rng, shapes).all():
            where = f"scene {seed} ({a}, {b})"
            count.begin(where, column_of(a, b), question[0])
            changes.append((compare(count, scene, question, old, new), where, question[0]))
        count.keep()
    changes.sort()
    count.table()
    print(f"{time.time() - begun:.0f} s by the clock")
    for word, some in (("slower", changes[::-1][:5]), ("faster", changes[:5])):
        print(word + ":", ", ".join(f"{where} {group} by {abs(by):.2f} s" for by, where, group in some))
    return 1 if count.row("all")["differ"] or count.row("all")["lost"] else 0


if __name__ == "__main__":
    sys.exit(main())
