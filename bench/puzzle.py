#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Makes the outline of a puzzle piece: convex and concave lobes of radius 5 on a lattice of 10, arcs as chords.

    bench/puzzle.py [LOBES [SEED]] > puzzle.json     the scene of the piece against itself turned by 180 degrees

The piece is a tree of LOBES discs (56 unless said) around every other lattice point. In each cell of the lattice the
outline is two quarters of circles, around the corners that are joined or around those that are not. Each quarter is ten
chords, with five decimals. So pieces of the convolution nearly coincide all over.
"""
import json
import math
import random
import sys

CHORDS = 10  # a quarter
STEP, RADIUS = 10, 5


def tree(count, seed):
    """Lattice points of even parity, and the cells (lower left corners) in which two of them are joined."""
    rng = random.Random(seed)
    points, joined = [(0, 0)], set()
    while len(points) < count:
        x, y = rng.choice(points)
        dx, dy = rng.choice([-1, 1]), rng.choice([-1, 1])
        to = (x + dx, y + dy)
        if to in points or max(abs(to[0]), abs(to[1])) > math.sqrt(count) / 1.2:
            continue
        points.append(to)
        joined.add((min(x, to[0]), min(y, to[1])))
    return points, joined


def quarters(points, joined):
    """Quarters of circles, counter-clockwise around the piece: (first end, last end, places in between)."""
    out = {}
    for x, y in points:
        for k, (cx, cy) in enumerate([(x, y), (x - 1, y), (x - 1, y - 1), (x, y - 1)]):
            if (cx, cy) not in joined:
                arc = [turned(x, y, k * CHORDS + i) for i in range(CHORDS + 1)]
                out[arc[0]] = arc
    for cx, cy in joined:
        for x, y in [(cx, cy), (cx + 1, cy), (cx + 1, cy + 1), (cx, cy + 1)]:
            if (x + y) % 2 == 0:
                continue
            k = {(0, 0): 0, (1, 0): 1, (1, 1): 2, (0, 1): 3}[x - cx, y - cy]
            arc = [turned(x, y, k * CHORDS + i) for i in range(CHORDS, -1, -1)]
            out[arc[0]] = arc
    return out


def turned(x, y, chord):
    angle = math.pi / 2 * chord / CHORDS
    return (round(STEP * x + RADIUS * math.cos(angle), 5) + 0.0, round(STEP * y + RADIUS * math.sin(angle), 5) + 0.0)


def outline(count=56, seed=1):
    arcs = quarters(*tree(count, seed))
    start = at = min(arcs)
    ring = []
    while True:
        ring += arcs[at][:-1]
        at = arcs[at][-1]
        if at == start:
            return ring


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 56
    ring = outline(count, int(sys.argv[2]) if len(sys.argv) > 2 else 1)
    scene = {
        "findspace": 1,
        "unit": "mm",
        "shapes": {"A": {"polygon": ring}, "B": {"polygon": [[-x, -y] for x, y in ring]}},
        "moving": "B",
        "where": "gamma1(B, A) >= 0",
    }
    json.dump(scene, sys.stdout)
    print()


if __name__ == "__main__":
    main()
