#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Large scenes asked at one position: `check` among 100,000 obstacles where the position is not feasible, so that the
nearest feasible one is sought, and `measure` of a mesh of about 1,000,000 triangles.

usage: bench/large_questions.py build/release/findspace [FOLDER for the scenes]

Prints a table: seconds by the clock, seconds of processor time, megabytes. `describe` of the obstacles stands beside
the check, as it reads and unites the same shapes and asks nothing."""

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
    return 5 * side, 5 * side


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


def measured(command):
    before = time.perf_counter()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, _, usage = os.wait4(process.pid, 0)
    return time.perf_counter() - before, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def main():
    program = sys.argv[1]
    folder = sys.argv[2] if len(sys.argv) > 2 else tempfile.mkdtemp()
    scene, mesh, ball = (os.path.join(folder, name) for name in ("obstacles.json", "ball.stl", "ball.json"))
    x, y = obstacles(scene, 100_000)
    faces = bumpy_ball(mesh, 500)
    with open(ball, "w", encoding="utf-8") as out:
        json.dump({"findspace": 1, "unit": "mm", "moving": "B", "where": "gap(B, M) >= 1",
                   "shapes": {"M": {"file": "ball.stl", "unit": "mm"},
                              "B": {"box": {"min": [-2, -2, -2], "max": [2, 2, 2]}}}}, out)
    rows = [("describe, 100,000 obstacles", ["describe", scene, "all"]),
            ("check, not feasible, 100,000 obstacles", ["check", scene, "--at", f"{x},{y}"]),
            (f"measure, {faces:,} triangles", ["measure", ball, "--at", "60,10,5"]),
            (f"measure --only gap, {faces:,} triangles", ["measure", ball, "--at", "60,10,5", "--only", "gap"])]
    print("| question | s | processor s | MB |\n|---|---|---|---|")
    for name, arguments in rows:
        clock, processor, size = measured([program, *arguments])
        print(f"| {name} | {clock:.1f} | {processor:.1f} | {size:.0f} |", flush=True)


if __name__ == "__main__":
    main()
