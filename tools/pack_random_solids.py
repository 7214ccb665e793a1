#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Packs small random instances of solids and checks every layout in rational arithmetic that knows nothing of the program.

usage: pack_random_solids.py EXECUTABLE [--count N] [--seed S] [--kills N]

Parts are hulls of random points, boxes, prisms over an L and unions of two boxes. Every fourth instance has boxes, balls, a
gap and an edge, another fourth may turn, by right angles or by rational matrices. Every third has containers of given sizes,
in two thirds of these one is a hull of random points, a prism over an L, a union of two boxes, a ball, what two balls have in common or a ball less a box, and in every fifth some copies stand already.
Checked: every copy of every part or that it is left out, an allowed rotation, no more containers than there are, inside the
walls, on the inner side of every face of a hull, clear of what an L, a union or a ball lacks, and within balls, the height as stated and not below the lower bound, no two interiors meeting, gaps as wide as asked for, and that what
is fixed stands there. Two convex parts are told apart by all axes that can separate them.
Then one part of each layout is moved at random, and `findspace verify` must agree with the same check.

With --kills N searches are killed after random times: each leaves a whole feasible layout in its file, or no file."""
import argparse
import itertools
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from fractions import Fraction


def minus(p, q):
    return tuple(a - b for a, b in zip(p, q))


def cross(p, q):
    return (p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])


def dot(p, q):
    return sum(a * b for a, b in zip(p, q))


def sides(points):
    return [minus(q, p) for p, q in itertools.combinations(points, 2)]


def axes(first, second):
    """All directions in which two hulls can be separated, and more."""
    d, e = sides(first), sides(second)
    found = set()
    for u, v in itertools.chain(itertools.combinations(d, 2), itertools.combinations(e, 2), itertools.product(d, e)):
        n = cross(u, v)
        if any(n):
            found.add(n)
    return found


class Kinds:
    """The axes of two kinds of convex parts, found once."""

    def __init__(self):
        self.known = {}

    def interiors_meet(self, first, second, by):
        key = (tuple(first), tuple(second))
        if key not in self.known:
            self.known[key] = [(n, min(dot(n, p) for p in first), max(dot(n, p) for p in first),
                                min(dot(n, p) for p in second), max(dot(n, p) for p in second))
                               for n in axes(first, second)]
        for n, low, high, other_low, other_high in self.known[key]:
            shift = dot(n, by)
            if other_high + shift <= low or high <= other_low + shift:
                return False
        return True


def is_rotation(rows):
    """Exactly: perpendicular rows of length 1, determinant 1."""
    return all(dot(p, q) == (p is q) for p in rows for q in rows) and dot(cross(rows[0], rows[1]), rows[2]) == 1


class Ball(list):
    """A convex part that is a ball: a list of its centre."""

    def __init__(self, center, radius):
        super().__init__([center])
        self.radius = radius


def radius_of(piece):
    return getattr(piece, "radius", 0)


def third(*entries):
    return [[f"{e}/3" for e in entries[3 * r:3 * r + 3]] for r in range(3)]


ORIENTATIONS = [[[1, 0, 0], [0, 1, 0], [0, 0, 1]], [["3/5", "-4/5", 0], ["4/5", "3/5", 0], [0, 0, 1]],
                [[0, 0, 1], ["3/5", "4/5", 0], ["-4/5", "3/5", 0]], third(1, -2, 2, 2, -1, -2, 2, 2, 1)]


def as_rows(matrix):
    return [[Fraction(str(e)) for e in row] for row in matrix]


def box_points(low, high):
    return [tuple(p) for p in itertools.product(*zip(low, high))]


def box_shape(low, high):
    return {"box": {"min": list(low), "max": list(high)}}


def random_part(rng, boxes_only):
    """(shape of a scene, its convex parts as lists of points)"""
    kind = rng.randrange(3) - 1 if boxes_only else rng.randrange(4)
    size = [rng.randint(1, 5) for _ in range(3)]
    if kind < 0:
        center, radius = tuple(size), Fraction(rng.randint(1, 5), 2)
        return {"ball": {"center": size, "radius": float(radius)}}, [Ball(center, radius)]
    if kind == 0:
        return box_shape((0, 0, 0), size), [box_points((0, 0, 0), size)]
    if kind == 1:
        a = ((0, 0, 0), (size[0] + 1, 1, size[2]))
        b = ((0, 0, 0), (1, size[1] + 1, rng.randint(1, 4)))
        return {"union": [box_shape(*a), box_shape(*b)]}, [box_points(*a), box_points(*b)]
    if kind == 2:
        w, d, h = size[0] + 1, size[1] + 1, size[2]
        outline = [[0, 0], [w, 0], [w, 1], [1, 1], [1, d], [0, d]]
        return ({"prism": {"polygon": outline, "z": [0, h]}},
                [box_points((0, 0, 0), (w, 1, h)), box_points((0, 0, 0), (1, d, h))])
    while True:
        points = [tuple(rng.randint(-3, 3) for _ in range(3)) for _ in range(rng.randint(4, 7))]
        if any(dot(cross(minus(q, p), minus(r, p)), minus(s, p)) for p, q, r, s in itertools.combinations(points, 4)):
            return {"polytope": [list(p) for p in points]}, [points]


def planes_of(points):
    """(n, d) with n . p <= d for all points, of each three of them that lie on a face of their hull."""
    found = set()
    for p, q, r in itertools.combinations(points, 3):
        n = cross(minus(q, p), minus(r, p))
        for normal in (n, minus((0, 0, 0), n)):
            if any(n) and all(dot(normal, s) <= dot(normal, p) for s in points):
                found.add((normal, dot(normal, p)))
    return found


class Inside:
    """Of a container that is no box, at the origin."""

    def __init__(self, rng, sizes, kind):
        self.planes, self.lacks, self.balls = [], [], []
        self.sizes = sizes
        low = tuple(rng.randint(-4, 4) for _ in range(3))
        if kind == 1:
            self.unite(rng, low)
        elif kind > 1:
            self.round(rng, low, kind)
        else:
            self.hull_or_ell(rng, low)

    def hull_or_ell(self, rng, low):
        sizes = self.sizes
        if rng.randrange(3) == 0:
            w, d, h = sizes
            x, y = rng.randint(1, w), rng.randint(1, d)
            ring = [[0, 0], [w, 0], [w, y], [x, y], [x, d], [0, d]]
            if x < w and y < d:
                self.lacks = [box_points((x, y, 0), (w, d, h))]
                self.shape = {"prism": {"polygon": [[a + low[0], b + low[1]] for a, b in ring], "z": [low[2], low[2] + h]}}
                return
        # Each side of the box is touched: some of its corners, and others.
        points = [tuple(rng.choice([0, s]) for s in sizes) for _ in range(6)] + [tuple(rng.randint(0, s) for s in sizes) for _ in range(4)]
        points += [(0, 0, 0), tuple(sizes), (sizes[0], 0, 0)]
        self.planes = planes_of(points)
        self.shape = {"polytope": [[a + b for a, b in zip(p, low)] for p in dict.fromkeys(points)]}

    def unite(self, rng, low):
        """One box across the front, and one that goes on behind it."""
        w, d, h = self.sizes
        y = rng.randint(1, d - 1)
        x, to_x = sorted(rng.sample(range(w + 1), 2))
        z, to_z = sorted(rng.sample(range(h + 1), 2))
        behind = [((0, y, 0), (x, d, h)), ((to_x, y, 0), (w, d, h)), ((x, y, 0), (to_x, d, z)), ((x, y, to_z), (to_x, d, h))]
        self.lacks = [box_points(*b) for b in behind if all(a < c for a, c in zip(*b))]
        boxes = [((0, 0, 0), (w, y, h)), ((x, rng.randint(0, y), z), (to_x, d, to_z))]
        self.shape = {"union": [box_shape(*([a + b for a, b in zip(p, low)] for p in box)) for box in boxes]}

    def round(self, rng, low, kind):
        """A ball; what it has in common with another one; or what it has without a box from a corner of its own box."""
        side = max(self.sizes) + 2
        radius, shift = Fraction(side, 2), 2 if kind == 3 else 0
        self.sizes = [side - shift, side, side]
        self.balls = [((x, radius, radius), radius) for x in dict.fromkeys((radius, radius - shift))]
        shapes = [{"ball": {"center": [float(a + b) for a, b in zip(c, low)], "radius": float(r)}} for c, r in self.balls]
        if kind == 3:
            self.shape = {"intersection": shapes}
        elif kind == 4:
            high = tuple(rng.randint(1, side // 2) for _ in range(3))
            self.lacks = [box_points((0, 0, 0), high)]
            self.shape = {"difference": [*shapes, box_shape(low, tuple(a + b for a, b in zip(high, low)))]}
        else:
            self.shape = shapes[0]

    def is_outside_balls(self, instance, points, at):
        for center, radius in self.balls:
            room = radius - radius_of(points) - instance.edge
            ways = [tuple(a + b - c for a, b, c in zip(p, at, center)) for p in points]
            if room < 0 or any(dot(way, way) > room * room for way in ways):
                return True
        return False

    def is_outside(self, instance, pieces, at):
        for points in pieces:
            if self.is_outside_balls(instance, points, at):
                return True
            r = radius_of(points) + instance.edge
            for p, (n, d) in itertools.product(points, self.planes):
                room = d - dot(n, p) - dot(n, at)
                if room < 0 or room * room < r * r * dot(n, n):
                    return True
            for lacking in self.lacks:
                if r:
                    if instance.is_nearer(points, at, lacking, (0, 0, 0), instance.edge):
                        return True
                elif instance.kinds.interiors_meet(points, lacking, minus((0, 0, 0), at)):
                    return True
        return False


class Instance:
    def __init__(self, number, rng):
        self.boxes_only = number % 4 == 3
        self.gap = Fraction(rng.choice([0, 1, 3]), 2) if self.boxes_only else Fraction(0)
        self.edge = Fraction(rng.choice([0, 1]), 4) if self.boxes_only else Fraction(0)
        self.parts = [random_part(rng, self.boxes_only) for _ in range(rng.randint(1, 5))]
        self.demand = [rng.randint(1, 3) for _ in self.parts]
        widest = max(max(p[k] + radius_of(piece) for piece in pieces for p in piece) -
                     min(p[k] - radius_of(piece) for piece in pieces for p in piece)
                     for k in range(3) for _, pieces in self.parts)
        self.turns = number % 4 == 1
        self.orientations = rng.choice(["right-angles", ORIENTATIONS])
        # Nothing is too wide where all stand as given.
        self.floor = [int(widest) + 2 + rng.randint(0, 6) for _ in range(2)]
        self.containers = []
        if number % 3 == 0:
            for name in ("c", "d")[:rng.randint(1, 2)]:
                sides = [max(1, int(widest) + rng.randint(-1, 5)) for _ in range(3)]
                self.containers.append({"id": name, "count": rng.randint(1, 3), "size-x": sides[0], "size-y": sides[1], "size-z": sides[2]})
        self.insides = {}
        if number % 9 in (0, 3):
            first = self.containers[0]
            first_sides = [int(s) + 3 for s in self.sides_of(first)]
            inside = self.insides[first["id"]] = Inside(random.Random(number), first_sides, number // 9 % 5)
            self.containers[0] = {"id": first["id"], "count": first["count"], "shape": inside.shape}
        self.kinds = Kinds()
        self.fixed = self.standing(random.Random(number)) if number % 5 == 4 else []

    def standing(self, rng):
        """(part, pieces, place, container 0) of copies that stand free, in the first container or on the floor."""
        sides = self.sides_of(self.containers[0]) if self.containers else [Fraction(f) for f in (*self.floor, 12)]
        inside = self.insides.get(self.containers[0]["id"]) if self.containers else None
        placed = []
        for part, (_, pieces) in enumerate(self.parts):
            lows = [min(p[k] - radius_of(piece) for piece in pieces for p in piece) for k in range(3)]
            for _ in range(5):
                at = tuple(self.edge - lows[k] + Fraction(rng.randint(0, 3 * int(sides[k])), 3) for k in range(3))
                trial = [*placed, (part, pieces, at, 0)]
                if not self.is_outside(pieces, at, sides, inside) and not self.fault_of_pairs(trial):
                    placed = trial
                    break
        return placed

    def sides_of(self, container):
        if "shape" in container:
            return [Fraction(s) for s in self.insides[container["id"]].sizes]
        return [Fraction(container[f"size-{axis}"]) for axis in "xyz"]

    def problem(self):
        more = {"allowed_orientations": self.orientations} if self.turns else {}
        if self.containers:
            more["containers"] = self.containers
        else:
            more["container"] = {"size-x": self.floor[0], "size-y": self.floor[1]}
        if self.fixed:
            where = {"container": self.containers[0]["id"]} if self.containers else {}
            more["fixed"] = [{"part": f"part{part}", "at": [str(c) for c in at], **where} for part, _, at, _ in self.fixed]
        return {"name": "random", **more,
                "item-types": [{"id": f"part{i}", "demand": n, "shape": shape}
                               for i, ((shape, _), n) in enumerate(zip(self.parts, self.demand))]}

    def options(self):
        return ["--gap", str(float(self.gap)), "--edge", str(float(self.edge))]

    def fault(self, layout):
        """What is wrong with a layout, or None."""
        placed = []
        for item in layout["items"]:
            part, rotation = int(item["part"][4:]), item.get("rotation")
            pieces = self.parts[part][1]
            if rotation:
                rotation = as_rows(rotation)
                allowed = self.orientations == "right-angles" and all(e.denominator == 1 for row in rotation for e in row)
                allowed = allowed or rotation in [as_rows(m) for m in ORIENTATIONS if self.orientations is ORIENTATIONS]
                if not self.turns or not is_rotation(rotation) or not allowed:
                    return f"part{part} stands in an orientation that is not allowed"
                pieces = [[tuple(dot(row, p) for row in rotation) for p in piece] for piece in pieces]
            placed.append((part, pieces, tuple(Fraction(c) for c in item["at"]), item.get("container", 0)))
        left = {int(out["part"][4:]): out["copies"] for out in layout["left_out"]}
        if left and not self.containers:
            return "something is left out"
        for i, n in enumerate(self.demand):
            if sum(1 for part, _, _, _ in placed if part == i) + left.get(i, 0) != n:
                return f"{n} copies of part{i} are wanted"
        return (self.fault_of_walls(layout, placed) or self.fault_of_pairs(placed) or self.fault_of_fixed(layout, placed) or
                self.fault_of_height(layout, placed))

    def fault_of_fixed(self, layout, placed):
        first = layout["container"]["containers"].index(self.containers[0]["id"]) if self.containers and self.fixed else 0
        for part, pieces, at, _ in self.fixed:
            if (part, pieces, at, first) not in placed:
                return f"a fixed part{part} does not stand at {at}"
        return None

    def rooms(self, layout):
        """Of the containers in use, or of the one below the height; None where too many of a kind are used."""
        height = Fraction(layout["height"])
        if not self.containers:
            return [[Fraction(self.floor[0]), Fraction(self.floor[1]), height]]
        names = layout["container"]["containers"]
        if any(names.count(c["id"]) > c["count"] for c in self.containers):
            return None
        known = {c["id"]: self.sides_of(c) for c in self.containers}
        rooms = [list(known[name]) for name in names]
        if rooms:
            rooms[-1][2] = min(rooms[-1][2], height)
        return rooms

    def fault_of_walls(self, layout, placed):
        rooms = self.rooms(layout)
        if rooms is None:
            return "there are too many containers of a kind"
        names = layout["container"]["containers"] if self.containers else [None]
        for part, pieces, at, room in placed:
            if self.is_outside(pieces, at, rooms[room], self.insides.get(names[room])):
                return f"part{part} is outside"
        return None

    def is_outside(self, pieces, at, sides, inside=None):
        for points in pieces:
            r = radius_of(points)
            for p, k in itertools.product(points, range(3)):
                c = p[k] + at[k]
                if c - r < self.edge or c + r + self.edge > sides[k]:
                    return True
        return inside is not None and inside.is_outside(self, pieces, at)

    def fault_of_height(self, layout, placed):
        last = len(self.rooms(layout)) - 1
        tops = [p[2] + at[2] + radius_of(points) + self.edge
                for _, pieces, at, room in placed if room == last for points in pieces for p in points]
        top, height = max(tops, default=Fraction(0)), Fraction(layout["height"])
        return f"the height is {top}, not {height}" if top != height else None

    def fault_of_pairs(self, placed):
        for (i, first, at, here), (j, second, to, there) in itertools.combinations(placed, 2):
            if here != there:
                continue
            for a, b in itertools.product(first, second):
                if radius_of(a) or radius_of(b):
                    if self.is_nearer(a, at, b, to, 0):
                        return f"part{i} and part{j} overlap"
                elif self.kinds.interiors_meet(a, b, minus(to, at)):
                    return f"part{i} and part{j} overlap"
                if self.gap and self.is_nearer(a, at, b, to, self.gap):
                    return f"part{i} and part{j} are too near each other"
        return None

    @staticmethod
    def is_nearer(a, at, b, to, gap):
        """Of two boxes or balls."""
        square = Fraction(0)
        for k in range(3):
            low, high = min(p[k] for p in a) + at[k], max(p[k] for p in a) + at[k]
            other_low, other_high = min(p[k] for p in b) + to[k], max(p[k] for p in b) + to[k]
            apart = max(other_low - high, low - other_high, 0)
            square += apart * apart
        least = gap + radius_of(a) + radius_of(b)
        return square < least * least


def moved(layout, rng):
    """The layout with one item moved; the height as its items have it."""
    other = json.loads(json.dumps(layout))
    item = rng.choice(other["items"])
    k = rng.randrange(3)
    item["at"][k] = str(Fraction(item["at"][k]) + Fraction(rng.choice([-1, 1]), rng.choice([1, 2, 10, 10**9])))
    return other


def check(executable, number, rng, folder):
    instance = Instance(number, rng)
    problem, out = os.path.join(folder, "problem.json"), os.path.join(folder, "layout.json")
    with open(problem, "w", encoding="utf-8") as file:
        json.dump(instance.problem(), file)
    options = instance.options()
    done = subprocess.run([executable, "pack", problem, "--work", "0.5", "--quiet", "--seed", str(number + 1), "-o", out,
                           *options], capture_output=True, text=True, check=False)
    if done.returncode != 0 and not (done.returncode == 1 and instance.containers):
        return f"status {done.returncode}: {done.stderr}"
    with open(out, encoding="utf-8") as file:
        whole = json.load(file)
    layout = whole["layout"]
    fault = instance.fault(layout)
    if fault:
        return fault
    if (done.returncode == 1) != (not layout["items"]):
        return f"status {done.returncode} with {len(layout['items'])} items"
    used = len(layout["container"]["containers"]) if instance.containers else Fraction(layout["height"])
    all_there = layout["items"] and not layout["left_out"]
    if not layout["proven"] or used < Fraction(layout["lower_bound"]) and all_there:
        return "not proven, or below the lower bound"
    if not layout["items"]:
        return None
    whole["layout"] = moved(layout, rng)
    with open(out, "w", encoding="utf-8") as file:
        json.dump(whole, file)
    verdict = subprocess.run([executable, "verify", out, problem, "--quiet", *options], capture_output=True, text=True, check=False)
    fault = instance.fault(whole["layout"])
    is_free = fault is None or fault.startswith("the height is")
    if (verdict.returncode == 0) != is_free:
        return f"verify says {verdict.stdout.strip()} where the check finds {fault}"
    return None


def check_kill(executable, rng, folder):
    instance = Instance(4 * rng.randrange(1000), rng)
    instance.demand = [n + 4 for n in instance.demand]
    problem, out = os.path.join(folder, "problem.json"), os.path.join(folder, "layout.json")
    with open(problem, "w", encoding="utf-8") as file:
        json.dump(instance.problem(), file)
    if os.path.exists(out):
        os.remove(out)
    with subprocess.Popen([executable, "pack", problem, "--time-limit", "60", "-o", out], stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL) as search:
        time.sleep(rng.uniform(0, 0.5))
        search.send_signal(rng.choice([signal.SIGKILL, signal.SIGINT]))
        search.wait()
    if not os.path.exists(out):
        return None
    with open(out, encoding="utf-8") as file:
        return instance.fault(json.load(file)["layout"])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("executable")
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kills", type=int, default=0)
    arguments = parser.parse_args()
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        for number in range(arguments.count):
            fault = check(arguments.executable, number, random.Random(arguments.seed * 100003 + number), folder)
            if fault:
                wrong += 1
                print(f"instance {number} of seed {arguments.seed}: {fault}")
        rng = random.Random(arguments.seed)
        for number in range(arguments.kills):
            fault = check_kill(arguments.executable, rng, folder)
            if fault:
                wrong += 1
                print(f"kill {number} of seed {arguments.seed}: {fault}")
    print(f"{arguments.count} instances, {arguments.kills} kills, {wrong} wrong")
    sys.exit(wrong != 0)


if __name__ == "__main__":
    main()
