#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""How long a mesh of thousands of triangles takes: every distance to a small octahedron at two positions, and maps.

    bench/mesh_questions.py build/release/findspace ../shared/data/3d/meshes/spot.obj [LINES] [--torus] > table.md

With --torus the other shape is one of 480 triangles, which is not convex.

Each question is a program of its own, reading included; LINES x LINES lines of a map (64). Prints Markdown.
"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile
import time

LIMIT = 120  # seconds a question
POSITIONS = ["2,2,2", "0,0.2,0"]
ATOMS = ["gamma1(B, A) <= 0.3", "gamma2(B, A) <= 1", "eta1(B, A) <= 0.1", "eta2(B, A) <= 1", "delta1(B, A) <= 0.1",
         "mu(B, A) <= 0.1", "mu(A, B) <= 0.1", "hausdorff(B, A) <= 1", "diameter(B, A) <= 5"]
MAPS = ["gamma1(B, A) <= 0", "gamma1(B, A) <= 0.05", "gamma1(B, A) <= -0.05", "eta1(B, A) <= 0", "eta1(B, A) <= -0.05",
        "eta1(B, A) <= 0.05", "mu(B, A) <= 0.05", "gamma2(B, A) <= 1.5", "eta2(B, A) <= 1", "hausdorff(B, A) <= 1"]
OCTAHEDRON = [[s * 0.1 if k == axis else 0 for k in range(3)] for axis in range(3) for s in (1, -1)]


def torus():
    """Around z, 20 by 12 corners to six decimals."""
    corners, faces = [], []
    for i in range(20):
        for j in range(12):
            u, v = math.tau * i / 20, math.tau * j / 12
            far = 0.25 + 0.08 * math.cos(v)
            corners.append([round(c, 6) for c in (0.3 + far * math.cos(u), 0.2 + far * math.sin(u),
                                                  0.08 * math.sin(v) - 0.1)])
            p, q = i * 12 + j, (i + 1) % 20 * 12 + j
            r, s = (i + 1) % 20 * 12 + (j + 1) % 12, i * 12 + (j + 1) % 12
            faces += [[p, q, r], [p, r, s]]
    return {"mesh": {"vertices": corners, "faces": faces}}


def seconds(command):
    """By the clock; status 1 is an answer as well."""
    begun = time.time()
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT, check=False)
    except subprocess.TimeoutExpired:
        return f"> {LIMIT}"
    if done.returncode > 1:
        raise SystemExit(f"{' '.join(command)}: {done.stderr}")
    return f"{time.time() - begun:.2f}"


def main():
    with_torus = "--torus" in sys.argv
    program, mesh, *rest = [a for a in sys.argv[1:] if a != "--torus"]
    mesh, lines = str(pathlib.Path(mesh).resolve()), rest[0] if rest else "64"
    other = torus() if with_torus else {"polytope": OCTAHEDRON}
    with tempfile.TemporaryDirectory() as folder:
        path = str(pathlib.Path(folder) / "scene.json")

        def asked(where, *command):
            scene = {"findspace": 1, "shapes": {"A": {"file": mesh}, "B": other}, "moving": "B"}
            if where:
                scene["where"] = where
            pathlib.Path(path).write_text(json.dumps(scene), encoding="utf-8")
            return seconds([program, command[0], path, *command[1:]])

        print(f"| at a position | {' | '.join(f'({p}), s' for p in POSITIONS)} |\n|---|{'---|' * len(POSITIONS)}")
        for atom in ATOMS:
            print(f"| `{atom}` | {' | '.join(asked(atom, 'check', '--at', p) for p in POSITIONS)} |", flush=True)
        print(f"| `measure`, all | {' | '.join(asked('', 'measure', '--at', p) for p in POSITIONS)} |")
        print(f"\n| on {lines} x {lines} lines | s |\n|---|---|")
        for where in MAPS:
            print(f"| `{where}` | {asked(where, 'map', '--resolution', lines)} |", flush=True)


if __name__ == "__main__":
    main()
