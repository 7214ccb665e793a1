#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Compares `findspace place`, simultaneous, with exhaustive search on a lattice, on random placements of 3 to 5 shapes.

usage: place_lattice.py EXECUTABLE [--count 60] [--seed 1] [--shapes 3,4,5] [--limit SECONDS]

Shapes and containers are polyominoes at integer places, every relation is closed (gamma1 >= 0, <= 0, = 0, inside, covers), so the set of
relative positions that a pair allows is a union of closed cells of the integer grid. All placements together are then a union of
polyhedra whose inequalities are x_i - x_j <= c with whole c (and the same for y): a totally unimodular system. Each such polyhedron
that is not empty has an integral vertex, also after one body is fixed at an integral position. So a placement exists exactly if one
exists on the lattice, and an integral position belongs to the region of a body exactly if the search on the lattice reaches it. Both are compared.
So is the complete placement: each body in turn at the least of one to three objectives among the positions that the earlier ones leave, ties
by y, then x. Regions of positions are unions of boxes with whole corners, where linear forms and distances to whole points are least at whole points.

Exit status 0 where nothing disagrees. What the program leaves undecided at its limit is counted apart."""
import argparse
import json
import random
import subprocess
import sys


# --- polyominoes -----------------------------------------------------------------------------------------------------

def polyomino(rng, size):
    """Cells of a connected polyomino without holes, from (0, 0)."""
    cells = {(0, 0)}
    while len(cells) < size:
        x, y = rng.choice(sorted(cells))
        dx, dy = rng.choice([(1, 0), (-1, 0), (0, 1), (0, -1)])
        cells.add((x + dx, y + dy))
    return cells if simple(cells) else polyomino(rng, size)


def outline(cells):
    """The boundary cycle, counter-clockwise, or None where it is not one simple ring."""
    sides = {}
    for x, y in cells:
        for a, b, beside in (((x, y), (x + 1, y), (x, y - 1)), ((x + 1, y), (x + 1, y + 1), (x + 1, y)),
                             ((x + 1, y + 1), (x, y + 1), (x, y + 1)), ((x, y + 1), (x, y), (x - 1, y))):
            if beside not in cells:
                if a in sides:
                    return None
                sides[a] = b
    start = min(sides)
    ring, at = [start], sides.pop(start)
    while at != start:
        ring.append(at)
        at = sides.pop(at)
    return None if sides else ring


def simple(cells):
    return outline(cells) is not None


# --- one instance ----------------------------------------------------------------------------------------------------

RELATIONS = {"gamma1({0}, {1}) >= 0": lambda a, b: not a & b,
             "gamma1({0}, {1}) <= 0": lambda a, b: bool(grown(a) & b),
             "touches({0}, {1})": lambda a, b: not a & b and bool(grown(a) & b),
             "inside({0}, {1})": lambda a, b: a <= b,
             "covers({0}, {1})": lambda a, b: a >= b}


OBJECTIVES = {"x": lambda p: p[0], "-x": lambda p: -p[0], "y": lambda p: p[1], "-y": lambda p: -p[1], "x + y": lambda p: p[0] + p[1],
              "2x - y": lambda p: 2 * p[0] - p[1], "x - 3y": lambda p: p[0] - 3 * p[1],
              "distance to [1, 1]": lambda p: (p[0] - 1) ** 2 + (p[1] - 1) ** 2,
              "-distance to [2, 0]": lambda p: -(p[0] - 2) ** 2 - p[1] ** 2}


def grown(cells):
    return {(x + dx, y + dy) for x, y in cells for dx in (-1, 0, 1) for dy in (-1, 0, 1)}


def moved(cells, by):
    return frozenset((x + by[0], y + by[1]) for x, y in cells)


def instance(rng, bodies):
    width, height = rng.choice([(3, 2), (4, 2), (3, 3), (5, 1), (6, 1), (4, 3)])
    container = {(x, y) for x in range(width) for y in range(height)}
    if rng.random() < 0.4:
        for corner in rng.sample([(0, 0), (width - 1, 0), (0, height - 1), (width - 1, height - 1)], 1):
            if len(container) > 3 and simple(container - {corner}):
                container -= {corner}
    shapes = [polyomino(rng, rng.choice([1, 1, 1, 2, 2, 3])) for _ in range(bodies)]
    pairs = []
    for i in range(bodies):
        for j in range(i):
            if rng.random() < 0.75:
                text = rng.choice(["gamma1({0}, {1}) >= 0"] * 5 + list(RELATIONS)[1:])
                pairs.append((i, j, text))
    return container, shapes, pairs


def scene_of(container, shapes, pairs, goals=()):
    drawn = {"A0": {"polygon": outline(container)}}
    names = [f"B{i}" for i in range(len(shapes))]
    drawn.update({n: {"polygon": outline(s)} for n, s in zip(names, shapes)})
    return {"findspace": 1, "shapes": drawn,
            "place": {"shapes": names, "each": "inside(self, A0)", "method": "simultaneous", "minimize": list(goals),
                      "constraints": [t.format(names[i], names[j]) for i, j, t in pairs] or ["true"]}}


def lattice(container, shapes, pairs, goals):
    """For each body the positions that occur in a complete placement, the positions tried, and the best placement, body after body."""
    xs, ys = zip(*container)
    span = [(x, y) for x in range(min(xs) - 4, max(xs) + 5) for y in range(min(ys) - 4, max(ys) + 5)]
    rooms = [[p for p in span if moved(s, p) <= container] for s in shapes]
    between = {(i, j): {} for i, j, _ in pairs}
    for i, j, text in pairs:
        for p in rooms[i]:
            for q in rooms[j]:
                between[i, j][p, q] = RELATIONS[text](moved(shapes[i], p), moved(shapes[j], q))
    reached = [set() for _ in shapes]

    def stands(i, p, chosen):
        return all(between[a, b].get((p, chosen[b]) if a == i else (chosen[a], p), False)
                   for a, b in between if (a == i and b in chosen) or (b == i and a in chosen))

    def complete(chosen):
        """Some way to place the others, or None."""
        i = next((k for k in range(len(shapes)) if k not in chosen), None)
        if i is None:
            return dict(chosen)
        for p in rooms[i]:
            if stands(i, p, chosen):
                found = complete({**chosen, i: p})
                if found:
                    return found
        return None

    for i, room in enumerate(rooms):
        for p in room:
            if p in reached[i]:
                continue
            found = complete({i: p})
            for k, q in (found or {}).items():
                reached[k].add(q)
    best = {}
    for i, room in enumerate(rooms if reached[0] else []):
        left = [p for p in room if stands(i, p, best) and complete({**best, i: p})]
        best[i] = min(left, key=lambda p: ([OBJECTIVES[g](p) for g in goals], p[1], p[0]))
    return reached, rooms, best


# --- what the program says -------------------------------------------------------------------------------------------

def contains(region, p):
    cells = region["cells"]
    at = [v["at"] for v in cells["vertices"]]
    for v in cells["vertices"]:
        if v["at"] == list(p):
            return v["in"]
    for e in cells["edges"]:
        (x0, y0), (x1, y1) = at[e["from"]], at[e["to"]]
        if (x1 - x0) * (p[1] - y0) == (y1 - y0) * (p[0] - x0) and min(x0, x1) <= p[0] <= max(x0, x1) and min(y0, y1) <= p[1] <= max(y0, y1):
            return e["in"]

    def rings(face):
        return ([face["outer"]] if "outer" in face else []) + face["holes"]

    for face in cells["faces"]:
        crossings = 0
        for ring in rings(face):
            for k in ring:
                (x0, y0), (x1, y1) = at[cells["edges"][k]["from"]], at[cells["edges"][k]["to"]]
                if (y0 > p[1]) != (y1 > p[1]) and x0 + (p[1] - y0) * (x1 - x0) / (y1 - y0) > p[0]:
                    crossings += 1
        if crossings % 2 == ("outer" in face):
            return face["in"]
    return False


def disagreement(exe, scene, reached, rooms, best, limit):
    done = subprocess.run([exe, "place", "-", "--json", "-q", "--time-limit", str(limit)], input=json.dumps(scene), capture_output=True,
                          text=True, timeout=60 + 10 * limit)
    if done.returncode not in (0, 1, 4) or not done.stdout.strip():
        return f"status {done.returncode}: {done.stderr.strip()}"
    result = json.loads(done.stdout)
    if not result["proven"]:
        return "undecided"
    if (done.returncode == 0) != bool(reached[0]):
        return f"status {done.returncode}, on the lattice {'some' if reached[0] else 'none'}"
    for i, room in enumerate(rooms):
        region = result["regions"][f"B{i}"]
        wrong = [p for p in room if contains(region, p) != (p in reached[i])]
        if wrong:
            return f"B{i} at {wrong[:3]}: the program says {contains(region, wrong[0])}"
        if best and result["positions"][i]["at"] != list(best[i]):
            return f"B{i} is placed at {result['positions'][i]['at']}, best is {best[i]}"
    return None


def main(argv):
    parser = argparse.ArgumentParser(usage=__doc__.split("\n\n")[1].removeprefix("usage: "))
    parser.add_argument("executable")
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--shapes", default="3,4,5")
    parser.add_argument("--limit", type=float, default=20)
    options = parser.parse_args(argv)
    sizes = [int(n) for n in options.shapes.split(",")]
    counts = {"agree, possible": 0, "agree, impossible": 0, "undecided": 0, "disagree": 0}
    for k in range(options.count):
        rng = random.Random(options.seed * 100003 + k)
        drawn = instance(rng, sizes[k % len(sizes)])
        goals = rng.sample(sorted(OBJECTIVES), rng.randint(1, 3))
        reached, rooms, best = lattice(*drawn, goals)
        scene = scene_of(*drawn, goals)
        said = disagreement(options.executable, scene, reached, rooms, best, options.limit)
        if said in (None, "undecided"):
            counts[said or ("agree, possible" if reached[0] else "agree, impossible")] += 1
            continue
        counts["disagree"] += 1
        print(f"instance {k}: {said}\n{json.dumps(scene)}")
    print(", ".join(f"{name}: {n}" for name, n in counts.items()))
    return 1 if counts["disagree"] else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
