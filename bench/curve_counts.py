#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""How many arcs curves become, against the theory of single arcs and of biarcs: a table for bench/results.

usage: curve_counts.py FINDSPACE

Each curve is read by `findspace describe` at three tolerances on a grid of 1e-9 mm. The length that counts is the
integral of the third root of |dk/ds| over the curve, k the curvature. The best single arcs between points of the curve
need length / (125 tolerance)^(1/3) of them, biarcs with common tangents twice length / (324 tolerance)^(1/3) (Meek and
Walton, 1995). The time is that of the whole command."""
import json
import math
import re
import subprocess
import sys
import time

CURVES = {
    "ellipse 40 x 20 mm": {"ellipse": {"center": [0, 0], "radii": [40, 20]}},
    "ellipse 40 x 2 mm": {"ellipse": {"center": [0, 0], "radii": [40, 2]}},
    "cubic Bezier, an S": {"bezier": [[0, 0], [30, 80], [90, -40], [100, 10]]},
    "cubic Bezier with a loop": {"bezier": [[0, 0], [200, 100], [-100, 100], [100, 0]]},
    "cubic Bezier with a cusp": {"bezier": [[0, 0], [100, 100], [0, 100], [100, 0]]},
    "quadratic Bezier": {"bezier": [[0, 0], [50, 90], [100, 0]]},
}
STEPS = 400000


def points(curve):
    """The curve as a function of [0, 1]."""
    if "ellipse" in curve:
        a, b = curve["ellipse"]["radii"]
        return lambda t: (a * math.cos(2 * math.pi * t), b * math.sin(2 * math.pi * t))
    control = curve["bezier"]

    def at(t):
        c = list(control)
        while len(c) > 1:
            c = [((1 - t) * p[0] + t * q[0], (1 - t) * p[1] + t * q[1]) for p, q in zip(c, c[1:])]
        return c[0]
    return at


def third_root_length(at):
    """Integral of |dk/ds|^(1/3) ds, by turning angles of a fine polygon."""
    sites = [at(i / STEPS) for i in range(0, STEPS + 1, 40)]
    legs = [(q[0] - p[0], q[1] - p[1]) for p, q in zip(sites, sites[1:])]
    lengths = [math.hypot(*d) for d in legs]
    total, before = 0.0, None
    for (d, e, l, m) in zip(legs, legs[1:], lengths, lengths[1:]):
        step = (l + m) / 2
        curvature = math.atan2(d[0] * e[1] - d[1] * e[0], d[0] * e[0] + d[1] * e[1]) / step
        if before is not None:
            total += abs(curvature - before) ** (1 / 3) * step ** (2 / 3)
        before = curvature
    return total


def count(program, curve, tolerance, side):
    scene = {"findspace": 1, "unit": "mm", "grid": 1e-9, "shapes": {"a": curve}}
    begin = time.monotonic()
    run = subprocess.run([program, "describe", "-", "--curves", side, "--tolerance", f"{tolerance}mm"],
                         input=json.dumps(scene), capture_output=True, text=True, check=False)
    found = re.search(r"became (\d+) arc", run.stderr)
    return int(found.group(1)), time.monotonic() - begin


def main(program):
    print("| curve | tolerance | arcs | theory | biarcs, theory | outside | seconds |")
    print("|---|---|---|---|---|---|---|")
    for name, curve in CURVES.items():
        length = third_root_length(points(curve))
        for tolerance in (1e-3, 1e-4, 1e-6):
            arcs, seconds = count(program, curve, f"{tolerance:.7f}", "near")
            closed = "ellipse" in curve
            outside = str(count(program, curve, f"{tolerance:.7f}", "outside")[0]) if closed else "–"
            print(f"| {name} | {tolerance:g} mm | {arcs} | {length / (125 * tolerance) ** (1 / 3):.1f} | "
                  f"{2 * length / (324 * tolerance) ** (1 / 3):.1f} | {outside} | {seconds:.2f} |")


if __name__ == "__main__":
    main(sys.argv[1])
