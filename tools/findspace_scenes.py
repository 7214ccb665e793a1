#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Scenes with a container and many obstacles of 50 vertices, of which only those near the container matter; to standard output.

usage: findspace_scenes.py COUNT [--list] [--near]

The moving shape is a star of 24 vertices, the obstacles stand in a square grid. Each has its own name and clearance, or with --list they
are one collection. With --near only those are written that the moving shape can touch from a position in the container."""
import argparse
import json
import math
import random
import sys

CONTAINER, SPACING, SIZE = 300, 100, 22


def scene(count, as_list, near):
    rng = random.Random(1)
    side = math.isqrt(count - 1) + 1
    star = [[round(12 * math.cos(k * math.pi / 12) * (1 if k % 2 else 0.8), 3), round(12 * math.sin(k * math.pi / 12) * (1 if k % 2 else 0.8), 3)]
            for k in range(24)]
    shapes = {"container": {"box": {"min": [0, 0], "max": [CONTAINER, CONTAINER]}}, "chip": {"polygon": star}}
    obstacles = []
    for i in range(count):
        x, y = (i % side) * SPACING + 50 + rng.uniform(-20, 20), (i // side) * SPACING + 50 + rng.uniform(-20, 20)
        ring = [[round(x + (20 + 1.2 * rng.random()) * math.cos(math.pi * k / 25), 4), round(y + (20 + 1.2 * rng.random()) * math.sin(math.pi * k / 25), 4)]
                for k in range(50)]
        if not near or max(x, y) - SIZE - 3 <= CONTAINER:
            obstacles.append((i, {"polygon": ring}))
    where = "inside(chip, container)"
    if as_list:
        shapes["obstacles"] = [o for _, o in obstacles]
        where += " and clear(chip, obstacles, 1)"
    else:
        for i, o in obstacles:
            shapes[f"obstacle{i}"] = o
            where += f" and clear(chip, obstacle{i}, {1 + i % 3})"
    return {"findspace": 1, "shapes": shapes, "moving": "chip", "where": where}


def main(argv):
    parser = argparse.ArgumentParser(usage=__doc__.split("\n\n")[1].removeprefix("usage: "))
    parser.add_argument("count", type=int)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--near", action="store_true")
    options = parser.parse_args(argv)
    json.dump(scene(options.count, options.list, options.near), sys.stdout)


if __name__ == "__main__":
    main(sys.argv[1:])
