#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Asks KiCad's own rule check and findspace the same question: may this part stand here?

    tools/kicad_agreement.py PROGRAM BOARD... [--positions 1000] [--seed 1] [--round] [--keep FOLDER]

Every board is saved by KiCad in its own format first, with the courtyards and nothing else. Then three questions:

* Which pairs of parts overlap? KiCad's DRC and `findspace check` of the whole board have to name the same.
* May a part stand there? Positions are drawn near the boundary of the region that findspace gives, from a millionth of
  a millimetre to a tenth off it. Each is given to `findspace check` and to KiCad's DRC.
* Is the copy right that `findspace place` writes? KiCad opens it, and nothing but the moved parts may differ.

KiCad takes polygons for round courtyards: here those polygons are drawn in their stead, so that both programs are asked
of the same shapes. With --round they stay as they are. Needs Debian's kicad (its Python module pcbnew); no test needs it.
"""

import argparse
import json
import math
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile

import pcbnew

NANOMETRES = 1_000_000
REMOVED = []  # what was taken from a board: pcbnew fails once Python forgets it
EPSILON = 0.000003  # millimetres: KiCad's DRC takes a nanometre off each courtyard, and puts it on its grid again
ARCS = 0.04  # millimetres: where a courtyard is round KiCad's polygon of it may be 0.02 off, of two round ones both are


def run(program, *arguments):
    """The JSON that the program prints, whatever its exit status says about feasibility."""
    done = subprocess.run([program, *arguments, "--json"], capture_output=True, text=True)
    if done.returncode not in (0, 1):
        raise SystemExit(f"{' '.join(arguments)}: {done.stderr}")
    return json.loads(done.stdout)


def rings_of(polygons):
    """The corners of all outlines and holes."""
    return [[(corner.x, corner.y) for corner in (polygons.CVertex(n, k, hole)
                                                 for n in range(polygons.VertexCount(k, hole)))]
            for k in range(polygons.OutlineCount()) for hole in range(-1, polygons.HoleCount(k))]


def draw_rings(footprint, layer, rings):
    """The courtyard on a layer as KiCad's own polygons of it."""
    for item in [i for i in footprint.GraphicalItems() if i.GetLayer() == layer]:
        footprint.Remove(item)
        REMOVED.append(item)
    for ring in rings:
        for start, end in zip(ring, ring[1:] + ring[:1]):
            line = pcbnew.FP_SHAPE(footprint, pcbnew.SHAPE_T_SEGMENT)
            line.SetLayer(layer)
            line.SetWidth(50000)
            line.SetStart(pcbnew.wxPoint(*start))
            line.SetEnd(pcbnew.wxPoint(*end))
            line.SetLocalCoord()
            footprint.Add(line)


def is_round(footprint, layer):
    straight = (pcbnew.SHAPE_T_SEGMENT, pcbnew.SHAPE_T_RECT, pcbnew.SHAPE_T_POLY)
    return any(i.GetShape() not in straight for i in footprint.GraphicalItems()
               if i.GetLayer() == layer and isinstance(i, pcbnew.FP_SHAPE))


def only_courtyards(path, folder, keep_round):
    """The board as this KiCad writes it, without parts that draw no courtyard and without copper."""
    out = os.path.join(folder, os.path.basename(path))
    shutil.copy(path, out)  # alone: a project beside it may say that overlaps are to be ignored
    os.chmod(out, 0o644)
    board = pcbnew.LoadBoard(out)
    rings = {}
    for footprint in board.GetFootprints():
        footprint.BuildCourtyardCaches()
        for layer in (pcbnew.F_CrtYd, pcbnew.B_CrtYd):
            rings[footprint.GetReference(), layer] = rings_of(footprint.GetCourtyard(layer))
    for footprint in list(board.GetFootprints()):
        drawn = {layer: rings[footprint.GetReference(), layer] for layer in (pcbnew.F_CrtYd, pcbnew.B_CrtYd)}
        for layer, corners in drawn.items():
            if corners and not keep_round and is_round(footprint, layer):
                draw_rings(footprint, layer, corners)
        if not any(drawn.values()):
            board.Remove(footprint)
            REMOVED.append(footprint)
    for item in list(board.GetTracks()) + list(board.Zones()):
        board.Remove(item)
        REMOVED.append(item)
    pcbnew.SaveBoard(out, board)
    return out


def overlaps(board, report):
    """The pairs of parts whose courtyards overlap, as KiCad's DRC says."""
    pcbnew.WriteDRCReport(board, report, pcbnew.EDA_UNITS_MILLIMETRES, False)
    with open(report, encoding="utf-8") as lines:
        blocks = lines.read().split("\n[")
    names = [re.findall(r"Footprint (\S+)", b) for b in blocks if b.startswith("courtyards_overlap]")]
    return {tuple(sorted(pair)) for pair in names}


def compare_pairs(program, path, report):
    """Pairs that both find, and those that only one does, with the gap where findspace has one."""
    theirs = overlaps(pcbnew.LoadBoard(path), report)
    ours = {}
    for broken in run(program, "check", path, "--where", "clear(self, others)")["broken"]:
        for atom in broken["check"]["atoms"]:
            other = atom["text"][len("clear(self, "):-1].strip("'\"")
            ours[tuple(sorted((broken["part"], other)))] = atom["value"]
    only_ours = {pair: gap for pair, gap in ours.items() if pair not in theirs}
    return len(theirs & ours.keys()), only_ours, theirs - ours.keys()


def boundary(program, path, part):
    """Straight pieces and arcs of the boundary of the region, as functions of a parameter in 0..1 with their length."""
    region = run(program, "map", path, "--move", part, "--where", f"clear('{part}', others)")
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
    return not any(footprint.GetReference() in pair for pair in overlaps(board, report))


def decimal(nanometres):
    sign, size = ("-" if nanometres < 0 else ""), abs(nanometres)
    return f"{sign}{size // NANOMETRES}.{size % NANOMETRES:06d}"


def compare(program, path, count, rng, folder):
    """How many positions both allow, how many were asked, and those on which the two differ."""
    board = pcbnew.LoadBoard(path)
    parts = [f for f in board.GetFootprints() if f.GetReference().rstrip("*")]
    report = os.path.join(folder, "drc.txt")
    allowed, asked, differ, pieces = 0, 0, [], {}
    while asked < count and parts:
        footprint = rng.choice(parts)
        name, home = footprint.GetReference(), footprint.GetPosition()
        if name not in pieces:
            pieces[name] = boundary(program, path, name)
        if not pieces[name]:
            parts.remove(footprint)  # it may stand nowhere or everywhere
            continue
        asked += 1
        position = near_boundary(pieces[name], rng)
        answer = run(program, "check", path, "--move", name, "--where", f"clear('{name}', others)", "--at",
                     ",".join(decimal(c) for c in position))
        ours, theirs = answer["true"], kicad_allows(board, footprint, position, report)
        footprint.SetPosition(home)
        allowed += ours and theirs
        if ours != theirs:
            witness = json.dumps(answer["atoms"][0].get("witness", {}))
            differ.append((name, position, ours, answer["atoms"][0].get("value"), '"arc"' in witness))
    return allowed, asked, differ


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


def report_of(asked, path, rng, folder):
    """Prints what the two say of a board; the number of contradictions beyond what KiCad forgives."""
    stripped = only_courtyards(path, folder, asked.round)
    both, ours, theirs = compare_pairs(asked.program, stripped, os.path.join(folder, "drc.txt"))
    pairs = {pair: gap for pair, gap in ours.items() if gap < -EPSILON}
    print(f"{os.path.basename(path)}: {both} pairs overlap, {len(ours) - len(pairs)} more by at most {EPSILON:f} mm; "
          f"only findspace: {pairs or 'none'}, only KiCad: {theirs or 'none'}")
    allowed, asked_of, differ = compare(asked.program, stripped, asked.positions // len(asked.boards), rng, folder)
    forgiven = [d for d in differ if abs(d[3]) <= EPSILON]
    rounded = [d for d in differ if asked.round and EPSILON < abs(d[3]) <= EPSILON + ARCS and d[4]]
    beyond = [d for d in differ if d not in forgiven and d not in rounded]
    print(f"  {asked_of} positions, {allowed} allowed by both, {len(differ)} differ: {len(forgiven)} by at most "
          f"{EPSILON:f} mm, {len(rounded)} more at arcs by at most {ARCS} mm (its polygons), {len(beyond)} by more")
    for name, position, ours_allows, gap, _ in beyond:
        print(f"    {name} at {','.join(decimal(c) for c in position)}: "
              f"{'allowed' if ours_allows else 'refused'} by findspace, gap {gap}")
    print("  " + copy_opens(asked.program, stripped, folder), flush=True)
    return len(beyond) + len(pairs) + len(theirs)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("program")
    arguments.add_argument("boards", nargs="+")
    arguments.add_argument("--positions", type=int, default=1000)
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--round", action="store_true", help="leave round courtyards as they are")
    arguments.add_argument("--keep", help="where the boards that KiCad wrote stay")
    asked = arguments.parse_args()
    rng = random.Random(asked.seed)
    print(f"KiCad {pcbnew.Version()}")
    worst = 0
    with tempfile.TemporaryDirectory() as temporary:
        folder = asked.keep or temporary
        for path in asked.boards:
            worst += report_of(asked, path, rng, folder)
    return worst > 0


if __name__ == "__main__":
    sys.exit(main())
