#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Height fields against fractions, and against the same solids as meshes that are built here.

usage: height_fields.py PROGRAM [--count N] [--seed N|day]

A field is taken as it is defined, as columns under triangles. Of a ball the gap and the margin are compared, by the
nearest point of all columns or of their frontier, and the way out of the ground; of a box the gap where it is apart, and whether it lies inside, by the
least height above its base. Heights may be missing. Each question goes to the field as a key of the scene, as an ASCII
grid and as a mesh. Exit status 0 where nothing disagrees."""
import argparse
import json
import math
import os
import random
import subprocess
import sys
import tempfile
import time
from fractions import Fraction
from itertools import product

NEAR = 1e-9


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def along(a, b, t):
    return tuple(x + t * (y - x) for x, y in zip(a, b))


# --- squared distances -------------------------------------------------------------------------------------------------

def to_segment2(p, a, b):
    d = sub(b, a)
    t = max(Fraction(0), min(Fraction(1), Fraction(dot(sub(p, a), d)) / dot(d, d)))
    q = sub(along(a, b, t), p)
    return dot(q, q)


def to_triangle2(p, triangle):
    a, b, c = triangle
    n = cross(sub(b, a), sub(c, a))
    if all(dot(cross(sub(v, u), sub(p, u)), n) >= 0 for u, v in ((a, b), (b, c), (c, a))):
        return Fraction(dot(sub(p, a), n)) ** 2 / dot(n, n)
    return min(to_segment2(p, a, b), to_segment2(p, b, c), to_segment2(p, c, a))


def of_segments2(a, b, c, d):
    u, v, w = sub(b, a), sub(d, c), sub(a, c)
    n = dot(u, u) * dot(v, v) - dot(u, v) ** 2
    if n:
        s = Fraction(dot(u, v) * dot(v, w) - dot(v, v) * dot(u, w)) / n
        t = Fraction(dot(u, u) * dot(v, w) - dot(u, v) * dot(u, w)) / n
        if 0 <= s <= 1 and 0 <= t <= 1:
            q = sub(along(a, b, s), along(c, d, t))
            return dot(q, q)
    return min(to_segment2(a, c, d), to_segment2(b, c, d), to_segment2(c, a, b), to_segment2(d, a, b))


def crosses(a, b, triangle):
    """Whether a segment meets a triangle that it does not lie in the plane of."""
    p, q, r = triangle
    n = cross(sub(q, p), sub(r, p))
    s, t = dot(sub(a, p), n), dot(sub(b, p), n)
    if s == t or s * t > 0:
        return False
    at = along(a, b, Fraction(s) / (s - t))
    return all(dot(cross(sub(v, u), sub(at, u)), n) >= 0 for u, v in ((p, q), (q, r), (r, p)))


class Box:
    def __init__(self, low, high):
        self.low, self.high = low, high
        self.corners = list(product(*zip(low, high)))
        self.edges = [(p, q) for p in self.corners for q in self.corners if p < q and sum(x != y for x, y in zip(p, q)) == 1]

    def to_triangle2(self, triangle):
        if any(self.holds(p) for p in triangle):
            return 0
        sides = [(triangle[k - 1], triangle[k]) for k in range(3)]
        if any(crosses(*e, triangle) for e in self.edges) or any(self.cut_by(*s) for s in sides):
            return 0
        from_corners = min(to_triangle2(p, triangle) for p in self.corners)
        from_points = min(self.to_point2(p) for p in triangle)
        return min(from_corners, from_points, min(of_segments2(*e, *s) for e in self.edges for s in sides))

    def holds(self, p):
        return all(a <= x <= b for a, x, b in zip(self.low, p, self.high))

    def to_point2(self, p):
        return sum(max(a - x, 0, x - b) ** 2 for a, x, b in zip(self.low, p, self.high))

    def cut_by(self, p, q):
        """Whether a segment meets it: the stretch of it within all slabs."""
        begin, end = Fraction(0), Fraction(1)
        for a, b, x, y in zip(self.low, self.high, p, q):
            if x == y:
                if not a <= x <= b:
                    return False
                continue
            s, t = sorted((Fraction(a - x) / (y - x), Fraction(b - x) / (y - x)))
            begin, end = max(begin, s), min(end, t)
        return begin <= end


# --- fields ------------------------------------------------------------------------------------------------------------

class Field:
    def __init__(self, rng):
        self.columns, self.rows = rng.randint(2, 5), rng.randint(2, 5)
        part = rng.choice([1, 1, 2, 4, 5])  # of the numbers
        self.step = [Fraction(rng.randint(1, 3 * part), part) for _ in range(2)]
        self.at = [Fraction(rng.randint(-5 * part, 5 * part), part) for _ in range(2)]
        self.floor = Fraction(rng.randint(-3, 0))
        missing = rng.choice([0, 0, 0.1, 0.3])
        self.heights = {}
        for node in product(range(self.columns), range(self.rows)):
            if rng.random() >= missing:
                self.heights[node] = self.floor + Fraction(rng.randint(1, 4 * part), part)
        self.squares = {(i, j) for i in range(self.columns - 1) for j in range(self.rows - 1)
                        if {(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)} <= set(self.heights)}

    def place(self, node, z=None):
        return tuple(a + k * s for a, k, s in zip(self.at, node, self.step)) + (self.heights[node] if z is None else z,)

    def triangles(self):
        """Corners of the triangles of heights, counter-clockwise from above."""
        for i, j in sorted(self.squares):
            yield (i, j), (i + 1, j), (i + 1, j + 1)
            yield (i, j), (i + 1, j + 1), (i, j + 1)

    def columns_faces(self):
        """The faces of all columns, walls between two of them as well."""
        for t in self.triangles():
            yield from self.caps(t)
            for k in range(3):
                yield from self.wall(t[k - 1], t[k])

    def frontier(self):
        for t in self.triangles():
            yield from self.caps(t)
        sides = {}
        for i, j in self.squares:
            ring = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
            for k in range(4):
                side = frozenset((ring[k - 1], ring[k]))
                sides.setdefault(side, []).append((ring[k - 1], ring[k]))
        for uses in sides.values():
            if len(uses) == 1:
                yield from self.wall(*uses[0])

    def caps(self, t):
        yield [self.place(n) for n in t]
        yield [self.place(n, self.floor) for n in reversed(t)]

    def wall(self, a, b):
        yield [self.place(a, self.floor), self.place(b, self.floor), self.place(b)]
        yield [self.place(a, self.floor), self.place(b), self.place(a)]

    def height_at(self, x, y):
        """Of the lowest height of a closed triangle above the place; nothing outside all."""
        found = []
        for t in self.triangles():
            (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (self.place(n) for n in t)
            area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
            b = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area
            c = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area
            if b >= 0 and c >= 0 and b + c <= 1:
                found.append(az + b * (bz - az) + c * (cz - az))
        return min(found, default=None)

    def holds(self, p):
        top = self.height_at(p[0], p[1])
        return top is not None and self.floor <= p[2] <= top

    def holds_box(self, box):
        """By the least height over its base: at its corners, at places of the field, and where lines of it pass."""
        (x0, y0, z0), (x1, y1, z1) = box.low, box.high
        if z0 < self.floor:
            return False
        lines_x = [self.at[0] + k * self.step[0] for k in range(self.columns)]
        lines_y = [self.at[1] + k * self.step[1] for k in range(self.rows)]
        for i, j in product(range(-1, self.columns), range(-1, self.rows)):
            left = lines_x[i] if i >= 0 else lines_x[0] - 1000
            right = lines_x[i + 1] if i + 1 < self.columns else lines_x[-1] + 1000
            low = lines_y[j] if j >= 0 else lines_y[0] - 1000
            high = lines_y[j + 1] if j + 1 < self.rows else lines_y[-1] + 1000
            meets = max(left, x0) < min(right, x1) and max(low, y0) < min(high, y1)
            if meets and (i, j) not in self.squares:
                return False
        xs = {x0, x1} | {x for x in lines_x if x0 < x < x1}
        ys = {y0, y1} | {y for y in lines_y if y0 < y < y1}
        places = set(product(xs, ys))
        slope = self.step[1] / self.step[0]
        for i, j in self.squares:  # where diagonals pass the sides of the base
            for x in (x0, x1):
                places.add((x, lines_y[j] + slope * (x - lines_x[i])))
            for y in (y0, y1):
                places.add((lines_x[i] + (y - lines_y[j]) / slope, y))
        tops = [self.height_at(x, y) for x, y in places if x0 <= x <= x1 and y0 <= y <= y1]
        return all(top is not None and top >= z1 for top in tops)

    # --- as the program reads it
    def text(self):
        rows = [[number(self.heights.get((i, j))) for i in range(self.columns)] for j in range(self.rows)]
        field = {"heights": rows, "step": [number(s) for s in self.step], "at": [number(a) for a in self.at],
                 "floor": number(self.floor)}
        return {"height_field": field}

    def grid(self, corner):
        """As an ASCII grid; by the corner of its first cell, or the middle."""
        at = [a - s / 2 if corner else a for a, s in zip(self.at, self.step)]
        word = "corner" if corner else "center"
        head = [f"ncols {self.columns}", f"NROWS {self.rows}", f"xll{word} {number(at[0])}", f"yll{word} {number(at[1])}"]
        head += [f"cellsize {number(self.step[0])}"] if self.step[0] == self.step[1] else \
                [f"dx {number(self.step[0])}", f"dy {number(self.step[1])}"]
        rows = [" ".join(str(number(self.heights.get((i, j), Fraction(-9999)))) for i in range(self.columns))
                for j in reversed(range(self.rows))]
        return "\n".join(head + rows) + "\n"

    def mesh(self):
        vertices, faces = [], []
        for triangle in self.frontier():
            faces.append([])
            for p in triangle:
                place = [number(x) for x in p]
                if place not in vertices:
                    vertices.append(place)
                faces[-1].append(vertices.index(place))
        return {"mesh": {"vertices": vertices, "faces": faces}}


def number(x):
    return None if x is None else int(x) if x == int(x) else float(x)


# --- questions ---------------------------------------------------------------------------------------------------------

def ask(program, verb, ground, part, where, folder=None):
    scene = {"findspace": 1, "shapes": {"A": ground, "B": part}, "moving": "B", "where": where}
    done = subprocess.run([program, verb, "-", "--at", "0,0,0", "--json", "-q"], input=json.dumps(scene),
                          capture_output=True, text=True, cwd=folder)
    if done.returncode not in (0, 1):
        sys.exit(f"{verb} ends with {done.returncode}: {done.stderr}\n{json.dumps(scene)}")
    return json.loads(done.stdout)


def near(a, b):
    if not isinstance(a, (int, float)) or not isinstance(b, (int, float)):
        return a == b  # undefined, or "-inf"
    return abs(a - b) <= NEAR * max(1, abs(a), abs(b))


class Trial:
    def __init__(self, program, rng):
        self.program, self.rng, self.faults = program, rng, []
        self.field = Field(rng)

    def say(self, what, part, expected, found):
        self.faults.append(f"{what}: {found}, not {expected}\n  {json.dumps(self.field.text())}\n  {json.dumps(part)}")

    def middle(self):
        """A place about the field, often on one of its heights or in the middle of a square."""
        f, rng = self.field, self.rng
        node = rng.choice(sorted(f.heights))
        x, y, z = f.place(node)
        kind = rng.randrange(4)
        if kind == 0:
            return x, y, z + rng.randint(-2, 4)
        if kind == 1:
            return x + f.step[0] / 2, y + f.step[1] / 2, z + Fraction(rng.randint(-8, 16), 4)
        return x + Fraction(rng.randint(-8, 8), 2), y + Fraction(rng.randint(-8, 8), 2), z + Fraction(rng.randint(-12, 24), 4)

    def ball(self):
        center, radius = self.middle(), self.rng.choice([Fraction(1, 4), Fraction(1, 2), Fraction(1), Fraction(3)])
        part = {"ball": {"center": [number(x) for x in center], "radius": number(radius)}}
        inside = self.field.holds(center)
        faces = self.field.frontier() if inside else self.field.columns_faces()
        away = math.sqrt(min(to_triangle2(center, t) for t in faces))
        found = self.same_for_all(part)
        gap = found["gap(B, A)"]
        if not inside and away > radius and not near(away - float(radius), gap):
            self.say("gap of a ball", part, away - float(radius), gap)
        if inside and gap > -float(radius) - away + NEAR:  # more where it is led out through an inner corner
            self.say("gap of a ball", part, f"up to {-float(radius) - away}", gap)
        if gap < 0:
            self.free(part, center, radius, gap)
        if inside and not near(away - float(radius), found["margin(B, A)"]) and away >= radius:
            self.say("margin of a ball", part, away - float(radius), found["margin(B, A)"])

    def free(self, part, center, radius, gap):
        """Whether the place to which the shortest move leads is free."""
        witness = ask(self.program, "measure", self.field.text(), part, "true")["witnesses"].get("gap(B, A)")
        if witness is None:
            return  # of a few values that a search encloses
        by = witness["by"]
        to = tuple(c + Fraction(x) for c, x in zip(center, by))
        away = 0 if self.field.holds(to) else math.sqrt(min(to_triangle2(to, t) for t in self.field.columns_faces()))
        if away < float(radius) - NEAR or not near(math.sqrt(dot(by, by)), -gap):
            self.say("the way out of a ball", part, f"{gap}, {away} away", by)

    def box(self):
        x, y, z = self.middle()
        w, d, h = (Fraction(self.rng.choice([1, 1, 2, 3, 5]), self.rng.choice([1, 2, 4])) for _ in range(3))
        box = Box((x, y, z), (x + w, y + d, z + h))
        part = {"box": {"min": [number(v) for v in box.low], "max": [number(v) for v in box.high]}}
        found = self.same_for_all(part)
        apart = 0 if self.field.holds(box.low) else min(box.to_triangle2(t) for t in self.field.columns_faces())
        if apart > 0 and not near(math.sqrt(apart), found["gap(B, A)"]):
            self.say("gap of a box", part, math.sqrt(apart), found["gap(B, A)"])
        if apart == 0 and found["gap(B, A)"] > 0:
            self.say("gap of a box", part, "0 or less", found["gap(B, A)"])
        inside = ask(self.program, "check", self.field.text(), part, "inside(B, A)")["true"]
        if inside != self.field.holds_box(box):
            self.say("a box is inside", part, self.field.holds_box(box), inside)

    def same_for_all(self, part):
        """The distances; those to the ASCII grid and the mesh must be the same."""
        found = self.measured(self.field.text(), part)
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "ground.ASC"), "w", encoding="utf-8") as file:
                file.write(self.field.grid(self.rng.random() < 0.5))
            grid = self.measured({"file": "ground.ASC", "floor": number(self.field.floor)}, part, folder)
        if grid != found:
            self.say("as an ASCII grid", part, found, grid)
        for name, v in self.measured(self.field.mesh(), part).items():
            if not near(v, found[name]):
                self.say(f"{name} of the mesh", part, found[name], v)
        return found

    def measured(self, ground, part, folder=None):
        return ask(self.program, "measure", ground, part, "true", folder)["distances"]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", default="1")
    options = parser.parse_args()
    options.program = os.path.abspath(options.program)
    seed = time.strftime("%Y-%m-%d") if options.seed == "day" else options.seed
    rng, faults, done = random.Random(seed), [], 0
    while done < options.count:
        trial = Trial(options.program, rng)
        if not trial.field.squares:
            continue
        trial.ball()
        trial.box()
        faults += trial.faults
        done += 1
    print("\n".join(faults))
    print(f"{done} fields, {len(faults)} faults (seed {seed})")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
