#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Compares `findspace place`, sequential, with exhaustive search on a lattice, on random placements of 2 to 5 shapes.

usage: place_in_order.py EXECUTABLE [--count 100] [--seed 1]

Polyominoes and closed relations as in place_lattice.py: the positions of a body, the others standing at integral places, are a union of closed cells of
the integer grid, so the lexicographic minimum of linear objectives is an integral position, the one that a search over the lattice finds. A body without
room is left out, and so are the conditions that speak of it. The objectives end with both coordinates, so that the minimum is one position.

Exit status 0 where nothing disagrees."""
import argparse
import json
import random
import subprocess
import sys

from place_lattice import RELATIONS, instance, moved, scene_of

OBJECTIVES = [(["y", "x"], lambda p: (p[1], p[0])), (["x", "y"], lambda p: (p[0], p[1])), (["-x", "-y"], lambda p: (-p[0], -p[1])),
              (["x + 2y", "y"], lambda p: (p[0] + 2 * p[1], p[1])), (["-2x - y", "x"], lambda p: (-2 * p[0] - p[1], p[0])),
              (["3x - 2y", "x", "y"], lambda p: (3 * p[0] - 2 * p[1], p[0], p[1]))]


def in_order(container, shapes, pairs, value):
    """The position of each body, None where it has no room."""
    span = [(x, y) for x in range(-4, 12) for y in range(-4, 12)]
    placed = {}
    for i, shape in enumerate(shapes):
        def fits(p):
            here = moved(shape, p)
            return here <= container and all(RELATIONS[text](here, moved(shapes[j], placed[j]))
                                             for k, j, text in pairs if k == i and placed[j] is not None)
        placed[i] = min(filter(fits, span), key=value, default=None)
    return [placed[i] for i in range(len(shapes))]


def main(argv):
    parser = argparse.ArgumentParser(usage=__doc__.split("\n\n")[1].removeprefix("usage: "))
    parser.add_argument("executable")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args(argv)
    bodies = without_room = wrong = 0
    for k in range(options.count):
        rng = random.Random(options.seed * 100003 + k)
        container, shapes, pairs = instance(rng, rng.randint(2, 5))
        objective, value = rng.choice(OBJECTIVES)
        expected = in_order(container, shapes, pairs, value)
        scene = scene_of(container, shapes, pairs)
        scene["place"].update(method="sequential", minimize=objective)
        done = subprocess.run([options.executable, "place", "-", "--json", "-q"], input=json.dumps(scene), capture_output=True, text=True, check=False)
        said = [p["at"] and tuple(p["at"]) for p in json.loads(done.stdout)["positions"]] if done.returncode in (0, 1) else done.stderr
        bodies += len(expected)
        without_room += expected.count(None)
        if said != expected:
            wrong += 1
            print(f"instance {k}: expected {expected}, got {said}\n{json.dumps(scene)}")
    print(f"{bodies} bodies, {without_room} without room, {wrong} of {options.count} placements disagree")
    return 1 if wrong or not 0 < without_room < bodies else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
