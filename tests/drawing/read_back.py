#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""The shapes of all examples, written in every format and read back.

In the plane the Hausdorff distance of what was written to what is read is 0 for exact cells, and two steps of the grid
at most in drawings, which round each point once. In space the volume and the box are the same, but for the single
precision of GLB and binary STL. What a format refuses must be one of the reasons that the documentation gives.

usage: read_back.py FINDSPACE [--part K/N]
  --part K/N  every Nth shape, beginning with the Kth; K may be `day` (tools/part_of_day.py)
"""
import argparse
import itertools
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
from part_of_day import part_of  # noqa: E402

STEP = 1e-6  # of the usual grid
FLAT = {"a.json": [], "a.svg": [], "a.dxf": [], "b.dxf": ["--dxf", "2000"], "a.wkt": [], "a.geojson": []}
SOLID = {"a.json": 1e-9, "a.obj": 1e-9, "a.off": 1e-9, "a.ply": 1e-9, "a.stl": 1e-6, "a.3mf": 1e-9, "a.glb": 1e-6, "a.step": 1e-9}
# Why a format does not hold a shape (docs/commands.md, docs/results.md).
REASONS = re.compile("GeoJSON knows no arcs|one surface of flat faces bounds|flat faces|unbounded|lost")


class Folder:
    """Where the program is asked."""

    def __init__(self, program, path):
        self.program, self.path = program, Path(path)

    def ask(self, *words):
        return subprocess.run([self.program, *map(str, words)], cwd=self.path, capture_output=True, text=True, check=False, timeout=300)

    def shapes(self, scene):
        """The names that the program gives."""
        said = self.ask("describe", scene, "no such shape", "-q").stderr
        return re.findall(r"'([^']*)'", said.split("the shapes are", 1)[1]) if "the shapes are" in said else []

    def write(self, scene, shape, name, *options):
        """Nothing, or why it is not written."""
        done = self.ask("convert", scene, shape, "-o", name, *options)
        return done.stderr if done.returncode or ": lost" in done.stderr or "is lost" in done.stderr else ""

    def hausdorff(self, name, unit):
        """Of the exact cells to what is read, or what went wrong."""
        scene = {"findspace": 1, "moving": "a", "where": "clear(a, b)",
                 "shapes": {"a": {"file": "cells.json"}, "b": {"file": name, "open_lines": True}}} | ({"unit": unit} if unit else {})
        (self.path / "both.json").write_text(json.dumps(scene), encoding="utf-8")
        done = self.ask("measure", "both.json", "--only", "hausdorff", "--json", "-q")
        return done.stderr if done.returncode else json.loads(done.stdout)["distances"]["hausdorff(a, b)"]

    def unit(self, scene, shape):
        said = json.loads(self.ask("describe", scene, shape, "--json", "-q", "--resolution", 4).stdout or "{}")
        return {"unit": said["unit"]} if said.get("unit") else {}

    def size_of_file(self, name, unit):
        scene = {"findspace": 1, "moving": "a", "shapes": {"a": {"file": name}}} | unit
        (self.path / "one.json").write_text(json.dumps(scene), encoding="utf-8")
        return self.size("one.json", "a")

    def described(self, *words):
        """What a set of the plane is, but for its unit and what depends on how it is stored; or what went wrong."""
        done = self.ask("describe", *words, "--json", "-q")
        if done.returncode:
            return done.stderr
        found = json.loads(done.stdout)
        parts = [{k: v for k, v in part.items() if k != "sample"} for part in found["components"]]
        return {k: v for k, v in found.items() if k not in ("unit", "cells", "components")}, parts

    def size(self, *words):
        """Volume and box, or what went wrong."""
        done = self.ask("describe", *words, "--json", "-q")
        if done.returncode:
            return done.stderr
        found = json.loads(done.stdout)
        return [found["volume"], *(x for corner in found["bbox"] or [] for x in corner)]


def compare(folder, scene, shape, count):
    """What is wrong with one shape, in words."""
    flat = not folder.write(scene, shape, "cells.json") and '"exact"' in (folder.path / "cells.json").read_text(encoding="utf-8")
    unit = json.loads((folder.path / "cells.json").read_text(encoding="utf-8")).get("unit") if flat else None
    known = None if flat else folder.size(scene, shape)
    for name, extra in FLAT.items() if flat else SOLID.items():
        if not flat and isinstance(known, str):
            return
        refusal = folder.write(scene, shape, name, *(extra if flat else []))
        if refusal:
            count["refused"] += 1
            if not REASONS.search(refusal):
                yield f"{name}: {refusal}"
            continue
        count[name] = count.get(name, 0) + 1
        if flat:
            off = folder.hausdorff(name, unit)
            if isinstance(off, str) or off is None or off > (0 if name == "a.json" else 2 * STEP):
                yield f"{name}: the Hausdorff distance is {off}"
            if name == "a.json" and (said := folder.described(name)) != (known := folder.described(scene, shape)):
                yield f"{name} in the place of a scene is {said} instead of {known}"
        else:
            found = folder.size(name, shape) if name == "a.json" else folder.size_of_file(name, folder.unit(scene, shape) or {"unit": "m" if name == "a.glb" else "mm"})
            if isinstance(found, str) and "libfindspace_cad.so is not there" in found:
                continue  # built without it
            if isinstance(found, str) or any(abs(a - b) > extra * max(map(abs, known)) for a, b in zip(found, known)):
                yield f"{name}: {found} instead of {known}"


def shapes_of_examples(folder):
    """Each scene with each of its shapes."""
    for scene in sorted((ROOT / "examples").glob("*.json")):
        for shape in folder.shapes(scene):
            yield scene, shape


def main(argv):
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--part", type=part_of, default=(1, 1))
    options = parser.parse_args(argv)
    first, step = options.part
    wrong, count = 0, {"refused": 0}
    with tempfile.TemporaryDirectory() as name:
        folder = Folder(str(Path(options.program).resolve()), name)
        for scene, shape in itertools.islice(shapes_of_examples(folder), first - 1, None, step):
            for fault in compare(folder, scene, shape, count):
                wrong += 1
                print(f"{scene.name}, {shape}: {fault}")
    print(", ".join(f"{n} {k}" for k, n in count.items()) + f"; {wrong} wrong")
    return 1 if wrong or count.get("a.dxf", 0) < 20 / step or count.get("a.step", 0) < 5 / step else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
