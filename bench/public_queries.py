# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Public interface: many positions, and shapes from arrays, beside Shapely (GEOS prepared) in one run; ratios.

All times are those of the processor, so they are those of one core, whatever else the machine does.

usage: PYTHONPATH=build/release/python /usr/bin/python3 bench/public_queries.py [--cpp build/bench/findspace_positions] [--positions N]

1. A formula of ten atoms over shapes of 100 vertices, asked at a million positions: findspace; with --cpp the same
   question from C++; where GEOS can say it (the same ten clearances as buffered unions), Shapely's prepared contains.
2. `contains` of a million positions in a region of 10,000 edges: findspace and Shapely's vectorised prepared contains.
3. 10,000 polygons of 20 corners: from arrays one by one and at once, from text, and from arrays through text.
"""
import argparse
import json
import subprocess
import time

import numpy as np
import shapely.vectorized
from shapely.geometry import Polygon

import findspace as fs


def least(task, times=3):
    spent = []
    for _ in range(times):
        begun = time.process_time()
        task()
        spent.append(time.process_time() - begun)
    return min(spent)


def star(x, y, size, corners, rng):
    angle = np.arange(corners) * 2 * np.pi / corners
    r = size * (0.7 + 0.3 * rng.random(corners))
    return np.round(np.column_stack([x + r * np.cos(angle), y + r * np.sin(angle)]), 4)


def row(name, value, unit, ratio=""):
    print(f"| {name} | {value:.3g} {unit} | {ratio} |", flush=True)


def queries(rng, positions, cpp):
    rings = {f"s{k}": star(20 * (k % 5) + 10, 20 * (k // 5) + 15, 7, 100, rng) for k in range(10)}
    peg = star(0, 0, 1.5, 100, rng)
    world = fs.World({"peg": fs.Shape.polygon(peg), **{k: fs.Shape.polygon(r) for k, r in rings.items()}}, "peg")
    where = fs.clear("peg", "s0", 0.25)
    for k in range(1, 10):
        where &= fs.clear("peg", f"s{k}", 0.25)
    query = world.query(where)
    begun = time.process_time()
    query.holds(positions[:1])
    row("ten atoms: making the query's region", 1e3 * (time.process_time() - begun), "ms")
    ours = least(lambda: query.holds(positions))
    row("ten atoms: findspace, Python", len(positions) / ours / 1e6, "M positions a second")
    blocked = (~query.region).to_shapely(1e-5)
    some = positions[:50000]
    theirs = least(lambda: shapely.vectorized.contains(blocked, some[:, 0], some[:, 1]), 1) * len(positions) / len(some)
    row("the same region in GEOS, prepared", len(positions) / theirs / 1e6, "M positions a second",
        f"{theirs / ours:.1f} times as long")
    if cpp:
        scene = {"peg": peg.tolist(), "shapes": {k: r.tolist() for k, r in rings.items()}, "where": query.text,
                 "positions": len(positions)}
        told = json.loads(subprocess.run([cpp], input=json.dumps(scene), text=True, capture_output=True, check=True).stdout)
        row("the same from C++", len(positions) / told["seconds"] / 1e6, "M positions a second",
            f"Python takes {ours / told['seconds']:.2f} times as long")
    values = world.query("gap(peg, s3)")
    some = positions[:1000]
    row("values of one gap", len(some) / least(lambda: values.values(some), 1) / 1e3, "k positions a second")


def containment(rng, positions):
    ring = star(50, 25, 24, 10000, rng)
    shape, polygon = fs.Shape.polygon(ring), Polygon(ring)
    region = shape.region
    region.contains(positions[:10])
    ours = least(lambda: region.contains(positions))
    some = positions[:100000]
    theirs = least(lambda: shapely.vectorized.contains(polygon, some[:, 0], some[:, 1]), 1) * len(positions) / len(some)
    same = (region.contains(some) == shapely.vectorized.contains(polygon, some[:, 0], some[:, 1])).mean()
    row("10,000 edges: findspace contains", len(positions) / ours / 1e6, "M positions a second")
    row("10,000 edges: GEOS prepared", len(positions) / theirs / 1e6, "M positions a second",
        f"{theirs / ours:.1f} times as long; {100 * same:.4f} % of the answers are the same")


def building(rng):
    rings = [star(0, 0, 5, 20, rng) for _ in range(10000)]
    texts = [json.dumps({"polygon": r.tolist()}) for r in rings]
    arrays = least(lambda: [fs.Shape.polygon(r) for r in rings], 2)
    at_once = least(lambda: fs.Shape.polygons(rings))
    one_array = np.array(rings)
    of_one = least(lambda: fs.Shape.polygons(one_array))
    text = least(lambda: [fs.Shape.json(t) for t in texts], 1)
    through = least(lambda: [fs.Shape.json(json.dumps({"polygon": r.tolist()})) for r in rings], 1)
    theirs = least(lambda: [Polygon(r) for r in rings], 2)
    row("10,000 polygons from arrays", arrays * 1e3, "ms")
    row("10,000 polygons from text", text * 1e3, "ms", f"{text / arrays:.1f} times as long")
    row("10,000 polygons through text: arrays printed, then read", through * 1e3, "ms",
        f"{through / arrays:.1f} times as long")
    row("10,000 polygons at once, of a list of arrays", at_once * 1e3, "ms",
        f"through text {through / at_once:.1f} times as long")
    row("10,000 polygons at once, of one array", of_one * 1e3, "ms", f"through text {through / of_one:.1f} times as long")
    row("10,000 polygons of Shapely, unchecked", theirs * 1e3, "ms", f"{theirs / arrays:.1f} times as long")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cpp")
    parser.add_argument("--positions", type=int, default=1_000_000)
    options = parser.parse_args()
    rng = np.random.default_rng(7)
    positions = rng.random((options.positions, 2)) * [100, 50]
    print("| job | result | ratio |\n|---|---|---|")
    queries(rng, positions, options.cpp)
    containment(rng, positions)
    building(rng)


if __name__ == "__main__":
    main()
