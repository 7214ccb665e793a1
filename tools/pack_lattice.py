#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Packs a few parts made of unit squares into a strip, and compares the length with that of an exhaustive search.

usage: pack_lattice.py EXECUTABLE [--count N] [--seed S]

Parts of unit squares have a shortest layout on the lattice: pushed to the left and down, each stops at whole numbers.
So trying all places on the lattice, and all angles, finds the least length there is. The layout of the program is
proved by itself; here its length must be neither below the least one nor above it."""
import argparse
import json
import os
import random
import subprocess
import sys
import tempfile
from fractions import Fraction


def box(x0, y0, x1, y1):
    return {(x, y) for x in range(x0, x1) for y in range(y0, y1)}


def random_part(rng):
    """Unit squares and the outline about them."""
    kind = rng.randrange(3)
    w, h = rng.randint(1, 3), rng.randint(1, 3)
    if kind == 0:
        return box(0, 0, w, h), [(0, 0), (w, 0), (w, h), (0, h)]
    if kind == 1:  # an angle
        return box(0, 0, w + 1, 1) | box(0, 0, 1, h + 1), [(0, 0), (w + 1, 0), (w + 1, 1), (1, 1), (1, h + 1), (0, h + 1)]
    return box(0, 0, 3, 1) | box(0, 0, 1, h + 1) | box(2, 0, 3, h + 1), \
        [(0, 0), (3, 0), (3, h + 1), (2, h + 1), (2, 1), (1, 1), (1, h + 1), (0, h + 1)]  # a fork


def turned(cells, quarters):
    for _ in range(quarters):
        cells = {(-y - 1, x) for x, y in cells}
    low_x, low_y = min(x for x, _ in cells), min(y for _, y in cells)
    return frozenset((x - low_x, y - low_y) for x, y in cells)


def places(cells, angles, length, height):
    """Bit sets of the squares that the part covers, for all places and angles."""
    found = set()
    for form in {turned(cells, angle // 90) for angle in angles}:
        w, h = 1 + max(x for x, _ in form), 1 + max(y for _, y in form)
        for x in range(length - w + 1):
            for y in range(height - h + 1):
                found.add(sum(1 << ((a + x) * height + b + y) for a, b in form))
    return sorted(found)


def fits(parts, length, height):
    options = sorted((places(cells, angles, length, height) for cells, angles in parts), key=len)

    def place(k, covered):
        return k == len(options) or any(place(k + 1, covered | bits) for bits in options[k] if not covered & bits)
    return place(0, 0)


def least_length(parts, height):
    length = -(-sum(len(cells) for cells, _ in parts) // height)
    while not fits(parts, length, height):
        length += 1
    return length


def check(program, seed, folder):
    rng = random.Random(seed)
    height = rng.randint(4, 6)
    items, parts = [], []
    for k in range(rng.randint(3, 5)):
        cells, outline = random_part(rng)
        angles = rng.choice([[0], [0, 180], [0, 90, 180, 270]])
        parts.append((cells, angles))
        items.append({"id": f"p{k}", "demand": 1, "allowed_orientations": angles,
                      "shape": {"type": "simple_polygon", "data": outline}})
    path = os.path.join(folder, "problem.json")
    with open(path, "w", encoding="utf-8") as file:
        json.dump({"name": "lattice", "strip_height": height, "items": items}, file)
    done = subprocess.run([program, "pack", path, "--json", "-q", "--threads", "1", "--work", "25"], capture_output=True,
                          text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"pack_lattice: instance {seed}: {done.stderr}")
    length, least = Fraction(json.loads(done.stdout)["layout"]["length"]), least_length(parts, height)
    if length != least:
        sys.exit(f"pack_lattice: instance {seed}: length {length}, but the least one is {least}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("executable")
    parser.add_argument("--count", type=int, default=10)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for k in range(arguments.count):
            check(arguments.executable, arguments.seed * 1000 + k, folder)
    print(f"{arguments.count} lengths are the least ones")


if __name__ == "__main__":
    main()
