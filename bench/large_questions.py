#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Large scenes asked at one position: `check` among 100,000 obstacles and about an outline of 1,000,000 vertices where
the position is not feasible, so that the nearest feasible one is sought; `measure` where the moving part touches one of
the obstacles from inside; a map within a container at that outline; and `measure` of a mesh of about 1,000,000
triangles, as a file and in the scene.

usage: bench/large_questions.py build/release/findspace [FOLDER for the scenes]

Prints a table: seconds by the clock, seconds of processor time, megabytes. `describe` of the obstacles stands beside
the check, as it reads and unites the same shapes and asks nothing."""

import concurrent.futures
import json
import math
import os
import random
import struct
import subprocess
import sys
import tempfile
import time


def obstacles(path, count):
    random.seed(1)
    side = math.isqrt(count) + 1
    boxes = []
    for i in range(count):
        x, y = i % side * 10, i // side * 10
        boxes.append({"box": {"min": [x + random.randint(0, 2), y + random.randint(0, 2)],
                              "max": [x + random.randint(6, 9), y + random.randint(6, 9)]}})
    scene = {"findspace": 1, "shapes": {"all": {"union": boxes}, "B": {"box": {"min": [-1, -1], "max": [1, 1]}}},
             "moving": "B", "where": "gap(B, all) >= 2"}
    with open(path, "w", encoding="utf-8") as out:
        json.dump(scene, out)
    x, y = boxes[0]["box"]["min"]
    return (5 * side, 5 * side), (x + 1, y + 2)


def bumpy_ball(path, rows):
    """A ball of radius 50 with bumps, as a binary STL."""
    columns = 2 * rows

    def point(i, j):
        a, b = math.pi * i / rows, 2 * math.pi * (j % columns) / columns
        r = 50 * (1 + 0.1 * math.sin(5 * a) * math.sin(7 * b) * math.sin(a))
        return r * math.sin(a) * math.cos(b), r * math.sin(a) * math.sin(b), r * math.cos(a)

    top, bottom = (0, 0, 50.0), (0, 0, -50.0)
    grid = [[point(i, j) for j in range(columns + 1)] for i in range(rows + 1)]
    faces = []
    for j in range(columns):
        faces.append((top, grid[1][j], grid[1][j + 1]))
        faces.append((bottom, grid[rows - 1][j + 1], grid[rows - 1][j]))
        for i in range(1, rows - 1):
            faces.append((grid[i][j], grid[i + 1][j], grid[i + 1][j + 1]))
            faces.append((grid[i][j], grid[i + 1][j + 1], grid[i][j + 1]))
    with open(path, "wb") as out:
        out.write(b"\0" * 80 + struct.pack("<I", len(faces)))
        for a, b, c in faces:
            out.write(struct.pack("<12fH", 0, 0, 0, *a, *b, *c, 0))
    return len(faces)


def outline(path, count, container=None):
    """Waves around a circle, with small teeth, and a box that moves."""
    ring = []
    for k in range(count):
        a = 2 * math.pi * k / count
        r = 1000 + 100 * math.sin(50 * a) + 0.01 * (2 * k % 13)
        ring.append([round(r * math.cos(a), 6), round(r * math.sin(a), 6)])
    shapes = {"A": {"polygon": ring}, "B": {"polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]]}}
    where = "gap(B, A) >= 1"
    if container:
        shapes["C"] = {"box": container}
        where = "inside(B, C) and " + where
    with open(path, "w", encoding="utf-8") as out:
        json.dump({"findspace": 1, "grid": 1e-6, "shapes": shapes, "moving": "B", "where": where}, out)


def torus(path, around, across):
    """Of twice so many triangles, in the scene itself."""
    vertices, faces = [], []
    for i in range(around):
        for j in range(across):
            a, b = 2 * math.pi * i / around, 2 * math.pi * j / across
            r = 10 + 4 * math.cos(b)
            vertices.append([round(c, 4) for c in (r * math.cos(a), r * math.sin(a), 4 * math.sin(b))])
            k, l = (i + 1) % around, (j + 1) % across
            faces.append([i * across + j, k * across + j, k * across + l])
            faces.append([i * across + j, k * across + l, i * across + l])
    scene = {"findspace": 1, "moving": "B", "where": "gap(B, A) >= 0",
             "shapes": {"A": {"mesh": {"vertices": vertices, "faces": faces}},
                        "B": {"box": {"min": [0, 0, 0], "max": [1, 1, 1]}}}}
    with open(path, "w", encoding="utf-8") as out:
        json.dump(scene, out)
    return len(faces)


def measured(command):
    before = time.perf_counter()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, _, usage = os.wait4(process.pid, 0)
    return time.perf_counter() - before, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def main():
    program = sys.argv[1]
    folder = sys.argv[2] if len(sys.argv) > 2 else tempfile.mkdtemp()
    scene, mesh, ball, ring, corner, ringed = (
        os.path.join(folder, name)
        for name in ("obstacles.json", "ball.stl", "ball.json", "outline.json", "corner.json", "torus.json"))
    # In another process: what this one takes counts for those that it starts.
    with concurrent.futures.ProcessPoolExecutor(1) as maker:
        (x, y), (inner_x, inner_y) = maker.submit(obstacles, scene, 100_000).result()
        faces = maker.submit(bumpy_ball, mesh, 500).result()
        maker.submit(outline, ring, 1_000_000).result()
        maker.submit(outline, corner, 1_000_000, {"min": [862, -37], "max": [938, 37]}).result()
        triangles = maker.submit(torus, ringed, 1000, 500).result()
    with open(ball, "w", encoding="utf-8") as out:
        json.dump({"findspace": 1, "unit": "mm", "moving": "B", "where": "gap(B, M) >= 1",
                   "shapes": {"M": {"file": "ball.stl", "unit": "mm"},
                              "B": {"box": {"min": [-2, -2, -2], "max": [2, 2, 2]}}}}, out)
    rows = [("describe, 100,000 obstacles", ["describe", scene, "all"]),
            ("check, not feasible, 100,000 obstacles", ["check", scene, "--at", f"{x},{y}"]),
            ("measure, touching, 100,000 obstacles", ["measure", scene, "--at", f"{inner_x},{inner_y}"]),
            ("check, not feasible, an outline of 1,000,000 vertices", ["check", ring, "--at", "900,0"]),
            ("map in a container, an outline of 1,000,000 vertices", ["map", corner]),
            ("measure, an outline of 1,000,000 vertices", ["measure", ring, "--at", "900,0"]),
            (f"measure, {triangles:,} triangles in the scene", ["measure", ringed, "--at", "30,10,5"]),
            (f"measure, {faces:,} triangles", ["measure", ball, "--at", "60,10,5"]),
            (f"measure --only gap, {faces:,} triangles", ["measure", ball, "--at", "60,10,5", "--only", "gap"])]
    print("| question | s | processor s | MB |\n|---|---|---|---|")
    for name, arguments in rows:
        clock, processor, size = measured([program, *arguments])
        print(f"| {name} | {clock:.1f} | {processor:.1f} | {size:.0f} |", flush=True)


if __name__ == "__main__":
    main()
