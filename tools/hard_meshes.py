#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Reads meshes that are hard to read: unwelded, slit, holed, doubled, turned, touching or crossing themselves.

Each is read as it is, and with what it needs of --repair and --close-holes. A closed surface has the volume that is
known by construction, up to what the repair may move; any other is refused with the place.

usage: hard_meshes.py FINDSPACE
"""
import itertools
import json
import math
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

OFF = 2e-5


def cube(x=0.0, y=0.0, z=0.0, size=10.0):
    """The 12 triangles of a cube, each of three points."""
    at = lambda k: (x + size * (k & 1), y + size * (k >> 1 & 1), z + size * (k >> 2 & 1))
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return [tuple(at(k) for k in t) for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]


def sphere(rings, radius=10.0):
    """A ball's surface of rings by sectors."""
    sectors = 2 * rings
    at = lambda i, j: (radius * math.sin(math.pi * i / rings) * math.cos(2 * math.pi * (j % sectors) / sectors),
                       radius * math.sin(math.pi * i / rings) * math.sin(2 * math.pi * (j % sectors) / sectors),
                       radius * math.cos(math.pi * i / rings))
    rounded = lambda i, j: tuple(round(v, 6) + 0.0 for v in (at(i, j) if 0 < i < rings else (0, 0, radius if i == 0 else -radius)))
    out = []
    for i, j in itertools.product(range(rings), range(sectors)):
        a, b, c, d = rounded(i, j), rounded(i + 1, j), rounded(i + 1, j + 1), rounded(i, j + 1)
        if i < rings - 1:
            out.append((a, b, c))
        if i > 0:
            out.append((a, c, d))
    return out


def volume(triangles):
    return sum(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
               for a, b, c in triangles) / 6


def shaken(triangles, seed=1):
    """Each corner of each triangle off by up to OFF, as scanners and rounded STL files have them."""
    rng = random.Random(seed)
    return [tuple(tuple(round(v + rng.uniform(-OFF, OFF) / 2, 7) for v in p) for p in t) for t in triangles]


def split_top(off):
    """A cube whose top is four triangles about its middle, while its front meets the edge between two corners at three points."""
    faces = [t for t in cube() if not all(p[1] == 0 for p in t)]
    chain = [(0, 0, 10), (2.5, off, 10), (5, -off, 10), (7.5, off, 10), (10, 0, 10)]
    below = (5, 0, 0)
    front = [(p, below, q) for p, q in zip(chain, chain[1:])]
    return faces + front + [((0, 0, 0), below, (0, 0, 10)), (below, (10, 0, 0), (10, 0, 10))]


def hard():
    """Name, triangles, options, the volume or None for a refusal, what is said with the options, and without them."""
    ball, small = sphere(100), sphere(12)
    mended = ["--repair", "0.0001"]
    holes = ["--close-holes", "20"]
    missing = small[:200] + small[201:]
    ring = [t for t in small if 10 not in (t[0][2], t[1][2], t[2][2])]
    rim = sorted({p for t in ring for p in t if p[2] == max(q[2] for u in ring for q in u)}, key=lambda p: math.atan2(p[1], p[0]))
    cap = [((0, 0, rim[0][2]), p, q) for p, q in zip(rim, rim[1:] + rim[:1])]
    yield "a soup", cube(), [], 1000, "", None
    yield "a soup off by 2e-5", shaken(cube()), mended, 1000, "joined", "not closed"
    yield "a ball of 39,600 triangles off by 2e-5", shaken(ball), mended, volume(ball), "joined", "not closed"
    yield "three vertices on an edge", split_top(0), [], 1000, "split", None
    yield "three vertices beside an edge", split_top(OFF), mended, 1000, "slits were closed", "not closed"
    yield "a face twice", cube() + cube()[3:4], mended, 1000, "stood twice", "stands twice"
    yield "all faces twice", cube() + cube(), mended, 1000, "12 faces", "12 faces stand twice"
    yield "a triangle missing", cube()[1:], holes, 1000, "1 hole was closed", "not closed"
    yield "a triangle of a ball missing", missing, holes, volume(small), "1 hole was closed", "not closed"
    yield "the cap of a ball missing", ring, holes, volume(ring + cap), "1 hole was closed", "not closed"
    yield "two holes, off by 2e-5", shaken(cube()[1:-1]), mended + holes, 1000, "2 holes were closed", "not closed"
    yield "a hole too large", cube()[2:], ["--close-holes", "10"], None, r"not closed.*\(0, 0, 0\)", "not closed"
    yield "turned at random", [t if k % 3 else t[::-1] for k, t in enumerate(cube())], [], 1000, "reversed", None
    yield "inside out", [t[::-1] for t in cube()], [], 1000, "reversed", None
    yield "slivers", cube() + [((0, 0, 0), (5, 0, 0), (10, 0, 0))], [], 1000, "without area", None
    yield "two cubes that touch along an edge", cube() + cube(10, 10), [], 2000, "", None
    yield "two cubes that touch at a corner", cube() + cube(10, 10, 10), [], 2000, "", None
    yield "two cubes that cross", cube() + cube(5, 5, 5), [], None, r"crosses itself.*\(", None
    yield "a flap within", cube() + [((1, 1, 1), (9, 1, 1), (1, 9, 9))], mended, None, r"not closed.*\(1, 1, 1\)", "not closed"


def stl(triangles):
    lines = ["solid hard"]
    for t in triangles:
        lines += ["facet normal 0 0 0", "outer loop"] + [f"vertex {x!r} {y!r} {z!r}" for x, y, z in t] + ["endloop", "endfacet"]
    return "\n".join(lines + ["endsolid hard", ""])


def described(program, path, options):
    """The exit status, the volume and what was said."""
    scene = {"findspace": 1, "unit": "mm", "grid": 1e-7, "moving": "box", "where": "clear(box, part)",
             "shapes": {"part": {"file": path.name}, "box": {"box": {"min": [0, 0, 0], "max": [1, 1, 1]}}}}
    place = path.with_suffix(".json")
    place.write_text(json.dumps(scene), encoding="utf-8")
    done = subprocess.run([program, "describe", place, "part", "--json", *options], capture_output=True, text=True,
                          check=False, timeout=300)
    return done.returncode, json.loads(done.stdout)["volume"] if done.stdout else None, done.stderr


def faults(program, path, options, size, words):
    """What is wrong with the answer, as words; nothing where it is right."""
    status, found, said = described(program, path, options)
    if not re.search(words, said):
        return f"does not say '{words}': {said}"
    if size is None:
        return "" if (status, found) == (3, None) else f"status {status} and volume {found} instead of a refusal"
    # Half a thousandth: volumes by lines are no closer, and a repair moves corners by a hundred-thousandth of the size.
    if status != 0 or abs(found - size) > size / 2000:
        return f"status {status} and volume {found} instead of {size}: {said}"
    return ""


def main(argv):
    if len(argv) != 2:
        print(__doc__.rsplit("\n\n", 1)[1])
        return 2
    wrong = 0
    meshes = list(hard())
    with tempfile.TemporaryDirectory() as folder:
        for k, (name, triangles, options, size, words, before) in enumerate(meshes):
            path = Path(folder) / f"hard{k}.stl"
            path.write_text(stl(triangles), encoding="utf-8")
            found = [faults(argv[1], path, [], None, before)] if before else []
            found.append(faults(argv[1], path, options, size, words))
            for fault in filter(None, found):
                wrong += 1
                print(f"{name}: {fault}")
    print(f"{len(meshes)} hard meshes, {wrong} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
