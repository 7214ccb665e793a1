#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Bottom-left placement of a nesting instance on its strip by `findspace place`: the order of the parts chosen from several.

usage: nest.py EXECUTABLE INSTANCE [--orders area,width,...] [--seconds S] [--scene FILE] [--svg FILE] [--json]
       nest.py --check INSTANCE PLACEMENT.json

Every part stands with the middle of its box as pole; all copies are placed, one after another, each at the least x, then the least y of
its exact region over all allowed angles, on the grid. Orders are by falling area, length, height, perimeter, diagonal, or area of the box; then, for
--seconds, random exchanges in the best order so far are kept where they make the strip shorter. The result is checked: every part, every copy, an allowed angle, inside the strip, and no two with a common
inner point, in rational arithmetic that knows nothing of the program."""
import argparse
import json
import os
import random
import subprocess
import sys
import time
from decimal import Decimal
from fractions import Fraction

NESTING = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "tests", "data", "nesting")


# --- the instance ----------------------------------------------------------------------------------------------------

class Part:
    def __init__(self, item):
        data = item["shape"]["data"]
        ring = [tuple(p) for p in (data["outer"] if isinstance(data, dict) else data)]
        ring = ring[:-1] if ring[0] == ring[-1] else ring
        xs, ys = zip(*ring)
        cx, cy = round((min(xs) + max(xs)) / 2, 3), round((min(ys) + max(ys)) / 2, 3)
        self.name, self.demand = f"part{item['id']}", int(item["demand"])
        self.ring = [(x - cx, y - cy) for x, y in ring]
        self.angles = [int(a) for a in item.get("allowed_orientations") or [0]]

    def key(self, order):
        xs, ys = zip(*self.ring)
        width, height = max(xs) - min(xs), max(ys) - min(ys)
        return {"area": area(self.ring), "width": width, "height": height, "box": width * height,
                "perimeter": sum(((a - c) ** 2 + (b - d) ** 2).sqrt() for (a, b), (c, d) in zip(self.ring, self.ring[1:] + self.ring[:1])),
                "diagonal": width * width + height * height}[order]


def area(ring):
    return abs(sum(a * d - b * c for (a, b), (c, d) in zip(ring, ring[1:] + ring[:1]))) / 2


def read(instance):
    with open(os.path.join(NESTING, instance + ".json"), encoding="utf-8") as file:
        data = json.load(file, parse_float=Decimal, parse_int=Decimal)
    return [Part(item) for item in data["items"]], data["strip_height"]


def turned(ring, degrees):
    for _ in range(degrees // 90 % 4):
        ring = [(-y, x) for x, y in ring]
    return ring


# --- the program -----------------------------------------------------------------------------------------------------

def number(value):
    text = format(value.normalize(), "f")
    return 0 if text in ("-0", "0") else (int(text) if "." not in text else float(text))


def scene(parts, height, bound):
    shapes = {"strip": {"box": {"min": [0, 0], "max": [number(bound), number(height)]}}}
    for p in parts:
        shapes[p.name] = {"polygon": [[number(x), number(y)] for x, y in p.ring]}
    angles = parts[0].angles if all(p.angles == parts[0].angles for p in parts) else {p.name: p.angles for p in parts}
    return {"findspace": 1, "shapes": shapes,
            "place": {"shapes": [p.name for p in parts], "count": {p.name: p.demand for p in parts}, "angles": angles,
                      "each": "inside(self, strip)", "pairs": "clear(self, other)", "minimize": ["x", "y", "grid"]}}


def scene_text(made, about):
    """A scene as a file for people: one shape a line, long rings broken."""
    lines = ["// " + line for line in about] + ["{", '  "findspace": 1,', '  "shapes": {']
    shapes = [f"    {json.dumps(name)}: {json.dumps(shape)}" for name, shape in made["shapes"].items()]
    lines += [text + ("," if k + 1 < len(shapes) else "") for k, text in enumerate(shapes)] + ["  },", '  "place": {']
    keys = [f"    {json.dumps(key)}: {json.dumps(value)}" for key, value in made["place"].items()]
    lines += [text + ("," if k + 1 < len(keys) else "") for k, text in enumerate(keys)] + ["  }", "}"]
    return "\n".join(lines) + "\n"


def bound_of(parts, height):
    """A strip that is long enough for what bottom-left placement does."""
    total = sum(area(p.ring) * p.demand for p in parts)
    longest = max(max(x for x, _ in p.ring) - min(x for x, _ in p.ring) for p in parts)
    return (total / height * 2 + 2 * longest).to_integral_value() + 1


def place(exe, parts, height, *arguments):
    text = json.dumps(scene(parts, height, bound_of(parts, height)))
    done = subprocess.run([exe, "place", "-", "--json", "-q", *arguments], input=text, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"status {done.returncode}: {done.stderr}")
    return json.loads(done.stdout, parse_float=Decimal, parse_int=Decimal)["positions"]


def length(parts, positions):
    rings = {p.name: p.ring for p in parts}
    return max(p["at"][0] + max(x for x, _ in turned(rings[p["shape"]], int(p.get("angle", 0)))) for p in positions)


def search(exe, parts, height, orders, seconds):
    """The best order, its positions and length, and a line about each order."""
    tried, best = [], None
    for order in orders:
        sequence = sorted(parts, key=lambda p: p.key(order), reverse=True)
        start = time.time()
        positions = place(exe, sequence, height)
        tried.append((order, length(parts, positions), time.time() - start))
        if best is None or tried[-1][1] < best[2]:
            best = (sequence, positions, tried[-1][1])
    rng, end = random.Random(1), time.time() + seconds
    while time.time() < end:
        sequence = list(best[0])
        i, j = rng.sample(range(len(sequence)), 2) if len(sequence) > 1 else (0, 0)
        sequence.insert(j, sequence.pop(i))
        positions = place(exe, sequence, height)
        if length(parts, positions) < best[2]:
            best = (sequence, positions, length(parts, positions))
            tried.append(("exchange", best[2], 0.0))
    return best, tried


# --- the check -------------------------------------------------------------------------------------------------------

def cross(o, a, b):
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])


def inside(ring, p):
    """1 inside, 0 on the boundary, -1 outside."""
    odd = False
    for a, b in zip(ring, ring[1:] + ring[:1]):
        side = cross(a, b, p)
        if side == 0 and min(a[0], b[0]) <= p[0] <= max(a[0], b[0]) and min(a[1], b[1]) <= p[1] <= max(a[1], b[1]):
            return 0
        if (a[1] > p[1]) != (b[1] > p[1]) and (side > 0) == (b[1] > a[1]):
            odd = not odd
    return 1 if odd else -1


def pieces(ring, other):
    """The parts of every edge of `ring` between all its meetings with `other`."""
    for a, b in zip(ring, ring[1:] + ring[:1]):
        ts = {Fraction(0), Fraction(1)}
        d = (b[0] - a[0], b[1] - a[1])
        for c, e in zip(other, other[1:] + other[:1]):
            if max(c[0], e[0]) < min(a[0], b[0]) or min(c[0], e[0]) > max(a[0], b[0]) or max(c[1], e[1]) < min(a[1], b[1]) or min(c[1], e[1]) > max(a[1], b[1]):
                continue
            f = (e[0] - c[0], e[1] - c[1])
            det = d[0] * f[1] - d[1] * f[0]
            if det:
                t = Fraction((c[0] - a[0]) * f[1] - (c[1] - a[1]) * f[0], det)
                if 0 < t < 1:
                    ts.add(t)
            elif cross(a, b, c) == 0:
                for q in (c, e):
                    t = Fraction((q[0] - a[0]) * d[0] + (q[1] - a[1]) * d[1], d[0] * d[0] + d[1] * d[1])
                    if 0 < t < 1:
                        ts.add(t)
        ts = sorted(ts)
        for s, t in zip(ts, ts[1:]):
            m = (s + t) / 2
            yield (a[0] + m * d[0], a[1] + m * d[1]), d


def overlap(r, s):
    """Whether two counter-clockwise polygons have a common inner point."""
    if min(x for x, _ in r) >= max(x for x, _ in s) or min(x for x, _ in s) >= max(x for x, _ in r):
        return False
    if min(y for _, y in r) >= max(y for _, y in s) or min(y for _, y in s) >= max(y for _, y in r):
        return False
    shared = []
    for one, two in ((r, s), (s, r)):
        for middle, direction in pieces(one, two):
            where = inside(two, middle)
            if where > 0:
                return True
            if where == 0:
                shared.append((one is r, middle, direction))
    # No boundary of one runs inside the other: they are apart, or the same along a common edge run in the same direction.
    for of_r, middle, direction in shared:
        for a, b in zip(*((s, s[1:] + s[:1]) if of_r else (r, r[1:] + r[:1]))):
            if cross(a, b, middle) == 0 and min(a[0], b[0]) <= middle[0] <= max(a[0], b[0]) and min(a[1], b[1]) <= middle[1] <= max(a[1], b[1]):
                if (b[0] - a[0]) * direction[0] + (b[1] - a[1]) * direction[1] > 0:
                    return True
    return False


def check(parts, height, positions):
    """Faults of a placement, in exact arithmetic."""
    by_name = {p.name: p for p in parts}
    count, placed = {}, []
    for p in positions:
        part = by_name[p["shape"]]
        count[part.name] = count.get(part.name, 0) + 1
        angle = int(p.get("angle", 0))
        if angle not in part.angles:
            yield f"{part.name}: angle {angle}"
        ring = turned(part.ring, angle)
        if sum(a * d - b * c for (a, b), (c, d) in zip(ring, ring[1:] + ring[:1])) < 0:
            ring = ring[::-1]
        at = [Fraction(c) for c in p["at"]]
        ring = [(Fraction(x) + at[0], Fraction(y) + at[1]) for x, y in ring]
        if min(x for x, _ in ring) < 0 or min(y for _, y in ring) < 0 or max(y for _, y in ring) > Fraction(height):
            yield f"{part.name} leaves the strip"
        placed.append((part.name, ring))
    for p in parts:
        if count.get(p.name, 0) != p.demand:
            yield f"{p.name}: {count.get(p.name, 0)} of {p.demand}"
    for i, (a, r) in enumerate(placed):
        for b, s in placed[:i]:
            if overlap(r, s):
                yield f"{a} and {b} overlap"


def main(argv):
    parser = argparse.ArgumentParser(usage=__doc__.split("\n\n")[1].removeprefix("usage: "))
    parser.add_argument("places", nargs="+")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--orders", default="area,width,height,perimeter,diagonal,box")
    parser.add_argument("--seconds", type=float, default=0)
    parser.add_argument("--scene")
    parser.add_argument("--svg")
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args(argv)
    if options.check:
        parts, height = read(options.places[0])
        with open(options.places[1], encoding="utf-8") as file:
            positions = json.load(file, parse_float=Decimal, parse_int=Decimal)["positions"]
        faults = list(check(parts, height, positions))
        print("\n".join(faults) or f"valid, length {length(parts, positions)}")
        return 1 if faults else 0
    exe, instance = options.places
    parts, height = read(instance)
    (sequence, positions, best), tried = search(exe, parts, height, options.orders.split(","), options.seconds)
    faults = list(check(parts, height, positions))
    density = sum(area(p.ring) * p.demand for p in parts) / (best * height)
    for order, size, seconds in tried:
        print(f"{instance:10} {order:10} length {float(size):12.3f}  {seconds:6.1f} s", file=sys.stderr)
    print(f"{instance}: length {best}, density {float(density) * 100:.2f} %, {'valid' if not faults else faults}")
    made = scene(sequence, height, best.to_integral_value() + 1)
    if options.scene:
        with open(options.scene, "w", encoding="utf-8") as file:
            file.write(scene_text(made, [f"All {sum(p.demand for p in parts)} parts of the nesting instance '{instance}' bottom-left on a strip, in an order that tools/nest.py found.",
                                         "(tests/data/README.md says whose data and which licence.)"]))
    if options.svg:
        subprocess.run([exe, "place", "-", "-q", "-o", options.svg], input=json.dumps(made), text=True, check=True)
    if options.json:
        print(json.dumps({"positions": positions}, default=number))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
