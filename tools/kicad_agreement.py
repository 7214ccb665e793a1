#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Asks KiCad's own rule check and findspace the same question: may this part stand here?

    tools/kicad_agreement.py PROGRAM BOARD... [--positions 1000] [--seed 1] [--keep FOLDER]

Positions are drawn near the boundary of the region that findspace gives, from a millionth of a millimetre to a tenth
off it. Each is given to `findspace check` and to KiCad's DRC, whose courtyard check counts. Also every board is saved
by KiCad in its own format first, and the copy that `findspace place` writes is opened by KiCad again and compared:
nothing but the moved parts may differ. Needs Debian's kicad (its Python module pcbnew); no test needs it.
"""

import argparse
import json
import math
import os
import random
import subprocess
import sys
import tempfile

import pcbnew

NANOMETRES = 1_000_000
EPSILON = 0.0005  # millimetres of overlap that KiCad's DRC forgives (DRCEpsilon of its advanced settings)
ARCS = 0.02  # millimetres that KiCad's polygons may be off where a courtyard is round (its error for outlines)


def run(program, *arguments):
    """The JSON that the program prints, whatever its exit status says about feasibility."""
    done = subprocess.run([program, *arguments, "--json"], capture_output=True, text=True)
    if done.returncode not in (0, 1):
        raise SystemExit(f"{' '.join(arguments)}: {done.stderr}")
    return json.loads(done.stdout)


def only_courtyards(path, folder):
    """The board as this KiCad writes it, without parts that draw no courtyard and without copper."""
    board = pcbnew.LoadBoard(path)
    footprints = list(board.GetFootprints())
    for item in list(board.GetTracks()) + list(board.Zones()):
        board.Delete(item)
    for footprint in footprints:
        footprint.BuildCourtyardCaches()
        closed = [footprint.GetCourtyard(layer).OutlineCount() for layer in (pcbnew.F_CrtYd, pcbnew.B_CrtYd)]
        if not any(closed):
            board.Delete(footprint)
    out = os.path.join(folder, os.path.basename(path))
    pcbnew.SaveBoard(out, board)
    return out


def boundary(program, path, part):
    """Straight pieces and arcs of the boundary of the region, as functions of a parameter in 0..1 with their length."""
    region = run(program, "map", path, "--move", part, "--where", f"clear({part}, others)")
    at = [v["at"] for v in region["cells"]["vertices"]]
    pieces = []
    for edge in region["cells"]["edges"]:
        p, q = at[edge["from"]], at[edge["to"]]
        pieces.append((math.dist(p, q), p, q, edge.get("arc")))
    return pieces


def near_boundary(pieces, rng):
    """A grid position near the boundary."""
    _, p, q, arc = rng.choices(pieces, [piece[0] + 0.01 for piece in pieces])[0]
    t = rng.choice([0, 1, rng.random(), rng.random(), rng.random(), rng.random()])
    x, y = p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])
    if arc:
        cx, cy = arc["center"]
        away = math.dist((x, y), (cx, cy)) or 1
        x, y = cx + (x - cx) / away * arc["radius"], cy + (y - cy) / away * arc["radius"]
    off, angle = 10 ** rng.uniform(-6, -1), rng.uniform(0, 2 * math.pi)
    return round((x + off * math.cos(angle)) * NANOMETRES), round((y + off * math.sin(angle)) * NANOMETRES)


def kicad_allows(board, footprint, position, report):
    """Whether KiCad's DRC finds no courtyard of this part overlapping another."""
    footprint.SetPosition(pcbnew.wxPoint(*position))
    pcbnew.WriteDRCReport(board, report, pcbnew.EDA_UNITS_MILLIMETRES, False)
    with open(report, encoding="utf-8") as lines:
        blocks = lines.read().split("\n[")
    name = footprint.GetReference()
    words = [b.split() for b in blocks if b.startswith("courtyards_overlap]")]
    return not any(name in block for block in words)


def decimal(nanometres):
    sign, size = ("-" if nanometres < 0 else ""), abs(nanometres)
    return f"{sign}{size // NANOMETRES}.{size % NANOMETRES:06d}"


def compare(program, path, count, rng, folder):
    """Positions asked, allowed by both, and those on which the two differ."""
    board = pcbnew.LoadBoard(path)
    parts = [f for f in board.GetFootprints() if f.GetReference().rstrip("*")]
    report = os.path.join(folder, "drc.txt")
    allowed, differ, pieces = 0, [], {}
    for _ in range(count):
        footprint = rng.choice(parts)
        name, home = footprint.GetReference(), footprint.GetPosition()
        if name not in pieces:
            pieces[name] = boundary(program, path, name)
        if not pieces[name]:
            continue
        position = near_boundary(pieces[name], rng)
        answer = run(program, "check", path, "--move", name, "--where", f"clear({name}, others)", "--at",
                     ",".join(decimal(c) for c in position))
        ours, theirs = answer["true"], kicad_allows(board, footprint, position, report)
        footprint.SetPosition(home)
        allowed += ours and theirs
        if ours != theirs:
            witness = json.dumps(answer["atoms"][0].get("witness", {}))
            differ.append((name, position, ours, answer["atoms"][0].get("value"), '"arc"' in witness))
    return allowed, differ


def copy_opens(program, path, folder):
    """A part is placed anew; KiCad opens the copy, and only the moved part stands elsewhere."""
    before = pcbnew.LoadBoard(path)
    part = sorted(f.GetReference() for f in before.GetFootprints() if not f.IsLocked())[0]
    copy = os.path.join(folder, "placed.kicad_pcb")
    done = subprocess.run([program, "place", path, "--move", part, "-o", copy], capture_output=True, text=True)
    if done.returncode != 0:
        return f"{part} fits nowhere: {done.stderr.strip()}"
    after = pcbnew.LoadBoard(copy)

    def places(board):
        return {f.GetReference(): (f.GetPosition().x, f.GetPosition().y, f.GetOrientation())
                for f in board.GetFootprints()}

    old, new = places(before), places(after)
    moved = [name for name in old if old[name] != new[name]]
    return f"{part} placed, KiCad opens the copy, moved there: {', '.join(moved) or 'nothing'}"


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("program")
    arguments.add_argument("boards", nargs="+")
    arguments.add_argument("--positions", type=int, default=1000)
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--keep", help="where the boards that KiCad wrote stay")
    asked = arguments.parse_args()
    rng = random.Random(asked.seed)
    print(f"KiCad {pcbnew.Version()}")
    worst = 0
    with tempfile.TemporaryDirectory() as temporary:
        folder = asked.keep or temporary
        for path in asked.boards:
            stripped = only_courtyards(path, folder)
            count = asked.positions // len(asked.boards)
            allowed, differ = compare(asked.program, stripped, count, rng, folder)
            forgiven = [d for d in differ if abs(d[3]) <= EPSILON]
            rounded = [d for d in differ if EPSILON < abs(d[3]) <= EPSILON + ARCS and d[4]]
            beyond = [d for d in differ if d not in forgiven and d not in rounded]
            print(f"{os.path.basename(path)}: {count} positions, {allowed} allowed by both, {len(differ)} differ: "
                  f"{len(forgiven)} by at most {EPSILON} mm (KiCad's tolerance), {len(rounded)} more at arcs by at most "
                  f"{ARCS} mm (its polygons), {len(beyond)} by more")
            for name, position, ours, gap, _ in beyond:
                print(f"  {name} at {','.join(decimal(c) for c in position)}: "
                      f"{'allowed' if ours else 'refused'} by findspace, gap {gap}")
            print("  " + copy_opens(asked.program, stripped, folder))
            worst = max(worst, len(beyond))
    return worst > 0


if __name__ == "__main__":
    sys.exit(main())
