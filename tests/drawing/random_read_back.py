#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Random regions, written in every format of the plane and read back.

The regions are answers of `map`: with arcs of nearly a full circle and of next to nothing, arcs that touch at places off the
grid, slots without width in any direction, single points, curves alone, holes, open boundaries. As exact cells (JSON) the
very same cells come back. In SVG, DXF (R12 and 2000), WKT and GeoJSON every point of what is read is within FAR grid steps
of what was written, and the other way round: the Hausdorff distance, of closures. What a format cannot hold must be said:
GeoJSON arcs, SVG single points, all three of SVG, DXF and WKT open edges. Outlines that rounding makes cross are mended as
notes say, by no more than MENDED times the greatest length that they state.

usage: random_read_back.py FINDSPACE [--count 40] [--seed 1] [--kind NAME] [--keep DIR]
"""
import argparse
import collections
import json
import math
import random
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

FAR = 3  # grid steps: what docs/results.md promises
MENDED = 1.5  # two cusps at one point are off by half the sum of their lengths, each up to sqrt(2) times the one stated
FORMATS = {"a.svg": [], "r12.dxf": [], "r2000.dxf": ["--dxf", "2000"], "a.wkt": [], "a.geojson": []}
TRIPLES = [(3, 4, 5), (5, 12, 13), (8, 15, 17), (20, 21, 29), (119, 120, 169)]


def disc(x, y, r):
    return {"disc": {"center": [x, y], "radius": r}}


def box(x, y, w, h):
    return {"box": {"min": [x, y], "max": [x + w, y + h]}}


def direction(rng):
    """Sides of a right-angled triangle in any order and sense, and its long side."""
    a, b, c = rng.choice(TRIPLES)
    if rng.random() < 0.5:
        a, b = b, a
    return rng.choice([a, -a]), rng.choice([b, -b]), c


def some(rng, low, high, digits=1):
    return round(rng.uniform(low, high), digits)


def simple(rng, x=0.0, y=0.0):
    """A shape about a place."""
    kind = rng.randrange(6)
    w, h = some(rng, 1.2, 6), some(rng, 1.2, 6)
    at = lambda corners: [[round(x + a, 6), round(y + b, 6)] for a, b in corners]
    if kind == 0:
        return disc(x, y, some(rng, 0.2, 4, rng.choice([0, 1, 3]) or 1))
    if kind == 1:
        return box(x, y, w, h)
    if kind == 2:
        return {"polygon": at([(0, 0), (w, some(rng, -1, 0)), (some(rng, 0, 2), h)])}
    if kind == 3:
        return {"polygon": at([(0, 0), (w + 2, 0), (w + 2, h + 2), (0, h + 2)]), "holes": [at([(1, 1), (w, 1), (w + 1, h + 1)])]}
    if kind == 4:
        return {"path": f"M{x} {y}h{w}a{h} {h} 0 {rng.randrange(2)} 1 0 {h}h{-w}z"}
    return {"polyline": at([(0, 0), (w, h), (w, some(rng, -3, 0))])}


def level(rng):
    return some(rng, 0, 3, rng.choice([0, 1, 2]))


def obstacles(rng):
    """A few shapes to keep off and to stay near."""
    shapes = {"B": rng.choice([disc(0, 0, some(rng, 0.2, 2)), box(0, 0, some(rng, 0.5, 2), 1), simple(rng)])}
    where = []
    for k in range(rng.randint(2, 4)):
        name = f"A{k}"
        shapes[name] = simple(rng, some(rng, -8, 8), some(rng, -8, 8))
        where.append(f"gap(B, {name}) {rng.choice(['>=', '>'])} {level(rng)}")
    shapes["R"] = rng.choice([disc(0, 0, 12), box(-10, -9, 21, 18)])
    where.append(f"inside(B, R, {level(rng)})")
    return shapes, " and ".join(where)


def bands(rng):
    """Holes, and open boundaries."""
    shapes = {"B": rng.choice([disc(0, 0, 1), box(0, 0, 1, 2), {"points": [[0, 0]]}]), "A": simple(rng), "C": simple(rng, 3, 2)}
    low = some(rng, 0, 2)
    return shapes, f"{low} {rng.choice(['<', '<='])} gap(B, A) {rng.choice(['<', '<='])} {low + some(rng, 0.1, 3)} and not gap(B, C) {rng.choice(['<', '<='])} 0.7"


def touching(rng):
    """Circles that touch, mostly off the grid, from outside and from inside, each a union with further ones."""
    a, b, c = direction(rng)
    f = rng.choice([1, 0.5, 0.25, 3])
    r = some(rng, 0.1, 0.9, rng.choice([1, 3])) * c * f
    r = round(r, 6)
    far = round(c * f, 6)
    inner = rng.random() < 0.4
    s = round(far + r if inner else far - r, 6)
    shapes = {"B": {"points": [[0, 0]]}, "A": disc(0, 0, r), "C": disc(a * f, b * f, s), "D": disc(*[round(v * f / 2, 6) for v in (b, -a)], round(far * rng.uniform(0.1, 0.6), 3))}
    if inner:
        return shapes, rng.choice(["gap(B, C) <= 0 and not gap(B, A) < 0", "gap(B, C) <= 0 and gap(B, A) > 0", "gap(B, C) < 0 and gap(B, A) >= 0 and not gap(B, D) < 0"])
    return shapes, rng.choice(["gap(B, A) <= 0 or gap(B, C) <= 0", "gap(B, A) <= 0 or gap(B, C) < 0 or gap(B, D) <= 0", "gap(B, D) <= 0 and gap(B, A) >= 0 and gap(B, C) >= 0",
                               "(gap(B, A) <= 0 or gap(B, C) <= 0) and not gap(B, D) < 0"])


def tangents(rng):
    """A circle and a slanted line that touch."""
    a, b, c = direction(rng)
    f, k = rng.choice([1, 0.5]), rng.randint(1, 3)
    r = round(c * f * k, 6)
    line = [[round(b * f * k - a * 2, 6), round(-a * f * k - b * 2, 6)], [round(b * f * k + a * 3, 6), round(-a * f * k + b * 3, 6)]]
    shapes = {"B": {"points": [[0, 0]]}, "A": disc(0, 0, r), "L": {"polyline": line}, "D": disc(0, 0, round(2.5 * r, 6))}
    return shapes, rng.choice([f"gap(B, A) <= 0 or gap(B, L) <= {round(r / 4, 6)}", "gap(B, A) <= 0 or gap(B, L) <= 0",
                               f"gap(B, D) <= 0 and gap(B, A) >= 1 and gap(B, L) >= {rng.choice([1, 0])}"])


def slots(rng):
    """A disc in corridors as wide as it is, and somewhat wider rooms."""
    a, b, c = rng.choice([(3, 4, 5), (-4, 3, 5), (7, -24, 25), (1, 0, 1), (0, -1, 1)])
    r, n = some(rng, 0.1, 1), rng.randint(1, 3)
    along = lambda p, q: [round((a * p - b * q) / c, 6), round((b * p + a * q) / c, 6)]
    half = r
    ring = [along(0, -half), along(10, -half), along(10, -3 * half), along(14, -3 * half), along(14, 2 * half), along(10, 2 * half), along(10, half), along(0, half)]
    shapes = {"B": disc(0, 0, r), "A": {"polygon": ring[: 8]}, "W": box(-30, -30, 60, 60)}
    for k in range(n):
        shapes[f"H{k}"] = disc(*along(some(rng, 1, 9), 0), round(r * rng.uniform(0.1, 0.5), 3))
    rest = "".join(f" and clear(B, H{k}, {level(rng) / 4})" for k in range(n)) if rng.random() < 0.5 else ""
    return shapes, f"inside(B, A){rest}"


def lines(rng):
    """Curves alone, open and closed, where a distance is just that."""
    shapes = {"B": rng.choice([disc(0, 0, some(rng, 0.2, 2)), {"points": [[0, 0]]}, box(0, 0, 1, 1)]), "A": simple(rng), "C": simple(rng, 4, 3), "R": box(-7, -6, 9, 11)}
    return shapes, rng.choice([f"gap(B, A) = {level(rng)}", f"gap(B, A) = {level(rng) + 0.5} and gap(B, C) >= {level(rng)}",
                               f"gap(B, A) = {level(rng) + 1} and inside(B, R)", f"gap(B, A) = 1 or gap(B, C) <= {level(rng)}"])


def points(rng):
    """Where circles just touch, beside other parts."""
    a, b, c = direction(rng)
    r = some(rng, 0.1, 0.9) * c
    shapes = {"B": {"points": [[0, 0]]}, "A": disc(0, 0, round(r, 6)), "C": disc(a, b, round(c - r, 6)), "D": simple(rng, 3, -4)}
    return shapes, rng.choice(["gap(B, A) <= 0 and gap(B, C) <= 0", "(gap(B, A) <= 0 and gap(B, C) <= 0) or gap(B, D) <= 1", "(gap(B, A) = 0 and gap(B, C) = 0) or gap(B, D) = 0.3"])


def nearly_full(rng):
    """Circles with a small bite, and small pieces that are left of one."""
    r = some(rng, 0.5, 30, 2)
    angle = rng.uniform(0, 6.2832)
    at = [round(r * rng.uniform(0.98, 1.02) * f, 4) for f in (math.cos(angle), math.sin(angle))]
    bite = rng.choice([disc(*at, round(10 ** rng.uniform(-4, -1) * r, 6)), box(*at, 0.01 * r, round(0.005 * r, 6)), {"polyline": [at, [0.0, 0.0]]}])
    shapes = {"B": {"points": [[0, 0]]}, "A": disc(0, 0, r), "C": bite}
    cut = round(10 ** rng.uniform(-5, -2) * r, 6)
    return shapes, rng.choice(["gap(B, A) <= 0 and not gap(B, C) <= 0", f"gap(B, A) <= 0 and gap(B, C) >= {cut}", f"gap(B, A) <= 0 and gap(B, C) <= {cut}",
                               f"gap(B, A) <= {cut} or gap(B, C) <= {cut}"])


def near_extremes(rng):
    """Arcs that begin or end next to where they run along an axis."""
    r = some(rng, 0.5, 20, 1)
    by = rng.choice([1e-6, 2e-6, 5e-6, 1e-5, 1e-3, 0.1])
    turn = rng.randrange(4)
    cut = {"box": {"min": [-99, round(by, 6)], "max": [99, 99]}} if turn < 2 else {"box": {"min": [round(-by, 6), -99], "max": [99, 99]}}
    more = {"box": {"min": [-99, -99], "max": [round(r - 10 ** rng.uniform(-5, 0), 6), 99]}}
    shapes = {"B": {"points": [[0, 0]]}, "A": disc(0, 0, r), "C": cut, "D": more}
    return shapes, rng.choice(["gap(B, A) <= 0 and gap(B, C) <= 0", "gap(B, A) <= 0 and not gap(B, C) < 0", "gap(B, A) <= 0 and gap(B, D) <= 0", "gap(B, A) <= 0 and not gap(B, D) < 0",
                               "gap(B, A) <= 0 and gap(B, C) <= 0 and gap(B, D) <= 0"])


def straight(rng):
    """Without arcs: GeoJSON holds them."""
    polygon = lambda x, y: {"polygon": [[x, y], [round(x + some(rng, 2, 6), 6), round(y + some(rng, -2, 1), 6)], [round(x + some(rng, 0, 3), 6), round(y + some(rng, 2, 5), 6)]]}
    shapes = {"B": rng.choice([box(0, 0, some(rng, 0.3, 2), 1), {"points": [[0, 0]]}, polygon(0.0, 0.0)]), "R": box(-9, -8, 18, 17)}
    if rng.random() < 0.3:  # and slots
        shapes["B"] = box(0, 0, 1, 1)
        shapes["A"], shapes["C"] = box(-4, -4, 5, 4), box(some(rng, -4, 2), 1, 6, 3)
        return shapes, "inside(B, R) and clear(B, A) and clear(B, C)"
    names = [f"A{k}" for k in range(rng.randint(1, 4))]
    shapes |= {name: polygon(some(rng, -8, 6), some(rng, -8, 6)) for name in names}
    return shapes, "inside(B, R) and " + " and ".join(rng.choice([f"clear(B, {n})", f"gap(B, {n}) > 0"]) for n in names)


KINDS = [obstacles, bands, touching, tangents, slots, lines, points, nearly_full, near_extremes, straight]


class Folder:
    """Where the program is asked."""

    def __init__(self, program, path):
        self.program, self.path = program, Path(path)

    def ask(self, *words):
        return subprocess.run([self.program, *map(str, words)], cwd=self.path, capture_output=True, text=True, check=False, timeout=300)

    def text(self, name):
        return (self.path / name).read_text(encoding="utf-8")

    def put(self, name, value):
        (self.path / name).write_text(json.dumps(value), encoding="utf-8")

    def hausdorff(self, cells, names, grid):
        """Of the cells to each of the files, in grid steps, or what went wrong; and what reading said that it left out."""
        shapes = {"a": {"file": cells}}
        shapes |= {f"b{k}": {"file": name, "open_lines": True} for k, name in enumerate(names)}
        self.put("both.json", {"findspace": 1, "grid": grid, "moving": "a", "where": " and ".join(f"clear(a, b{k})" for k in range(len(names))), "shapes": shapes})
        done = self.ask("measure", "both.json", "--only", "hausdorff", "--json")
        if done.returncode == 0:
            found = json.loads(done.stdout)["distances"]
            return [(found[f"hausdorff(a, b{k})"] / grid, left_out(done.stderr, name) / grid) for k, name in enumerate(names)]
        return [(done.stderr.strip(), 0)] if len(names) == 1 else [self.hausdorff(cells, [name], grid)[0] for name in names]


def left_out(notes, name):
    """How long the longest crossing was that reading a file mended, as its notes say."""
    found = re.findall(rf"note: {re.escape(name)}:.*outlines cross .*the longest (\S+) at", notes)
    return max(map(float, found), default=0)


def without_points(cells):
    """Exact cells without single points; nothing where nothing is left."""
    rest = json.loads(json.dumps(cells))
    used = {e[k] for e in rest["exact"]["edges"] for k in ("from", "to")}
    kept = [k for k, v in enumerate(rest["exact"]["vertices"]) if k in used]
    number = {v: k for k, v in enumerate(kept)}
    rest["exact"]["vertices"] = [rest["exact"]["vertices"][k] for k in kept]
    for e in rest["exact"]["edges"]:
        e["from"], e["to"] = number[e["from"]], number[e["to"]]
    return rest if kept else None


class Round:
    """One region through all formats."""

    def __init__(self, folder, shapes, where, grid, count):
        self.folder, self.grid, self.count = folder, grid, count
        folder.put("scene.json", {"findspace": 1, "grid": grid, "moving": "B", "where": where, "shapes": shapes})

    def faults(self):
        done = self.folder.ask("map", "scene.json", "--exact", "-o", "cells.json", "-q")
        if done.returncode == 1:
            self.count["empty"] += 1
            return
        if done.returncode:
            yield f"map: {done.stderr}"
            return
        cells = json.loads(self.folder.text("cells.json"))
        self.count["regions"] += 1
        yield from self.exact_faults()
        yield from self.drawing_faults(cells)

    def convert(self, name, *options):
        self.folder.put("one.json", {"findspace": 1, "grid": self.grid, "shapes": {"a": {"file": "cells.json"}}})
        done = self.folder.ask("convert", "one.json", "a", "-o", name, *options)
        return done.returncode, done.stderr

    def exact_faults(self):
        """The cells that are read are written the same."""
        self.convert("first.json")
        self.folder.put("again.json", {"findspace": 1, "grid": self.grid, "shapes": {"a": {"file": "first.json"}}})
        done = self.folder.ask("convert", "again.json", "a", "-o", "second.json", "-q")
        self.count["a.json"] += 1
        if done.returncode or self.folder.text("first.json") != self.folder.text("second.json"):
            yield f"JSON: {done.stderr or 'other cells'}"

    def drawing_faults(self, cells):
        written = []
        for name, options in FORMATS.items():
            status, said = self.convert(name, *options)
            if status:
                self.count[f"{name} refused"] += 1
                if not (name == "a.geojson" and "GeoJSON knows no arcs" in said):
                    yield f"{name}: {said}"
                continue
            if "have no inside" in said:
                self.count[f"{name}: no inside"] += 1
                continue
            if "where isolated points are" in said:
                plain = without_points(cells)
                if plain is not None:
                    self.folder.put("plain.json", plain)
                    yield from self.compared([name], "plain.json")
                continue
            written.append(name)
        yield from self.compared(written, "cells.json")

    def compared(self, names, cells):
        for name, (off, stated) in zip(names, self.folder.hausdorff(cells, names, self.grid) if names else []):
            self.count[name] += 1
            if isinstance(off, str) or off is None or off > max(FAR, MENDED * stated + 1):
                yield f"{name}: off by {off} grid steps"
            elif off > FAR:
                self.count[f"{name}: left out with a note"] += 1
            else:
                self.count["farthest"] = max(self.count["farthest"], off)


def main(argv):
    parser = argparse.ArgumentParser(usage=__doc__.rsplit("usage: ", 1)[1])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kind")
    parser.add_argument("--keep")
    arguments = parser.parse_args(argv[1:])
    count, wrong = collections.Counter(), 0
    kinds = [k for k in KINDS if arguments.kind in (None, k.__name__)]
    with tempfile.TemporaryDirectory() as name:
        folder = Folder(str(Path(arguments.program).resolve()), name)
        k = 0
        while count["regions"] < arguments.count:
            k += 1
            rng = random.Random(f"{arguments.seed} {k}")
            kind = kinds[k % len(kinds)]
            faults = list(Round(folder, *kind(rng), rng.choice([1e-6, 1e-6, 1e-6, 1e-3]), count).faults())
            for fault in faults:
                print(f"{kind.__name__} {k}: {fault}", flush=True)
            wrong += bool(faults)
            if faults and arguments.keep:
                shutil.copytree(name, Path(arguments.keep) / f"{kind.__name__}-{k}", dirs_exist_ok=True)
    print(", ".join(f"{n} {k}" for k, n in count.items()) + f"; {wrong} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
