# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Packing problems that are stated, searched and asked about once: strips, sheets, conditions, solids."""
import os
import pickle
import random
import signal
import threading
import time
from fractions import Fraction

import numpy as np
import pytest

import findspace as fs


def test_pack_with_a_tilt():
    def bar(**tilt):
        return fs.PackPart("bar", [(0, 0), (12, 0), (12, 4), (0, 4)], angles=[10], **tilt)
    tilted = fs.PackProblem([pickle.loads(pickle.dumps(bar(tilt=10)))], height=20)
    layout = fs.pack(tilted, work=1)
    assert layout.length == "12" and layout.faults(tilted) == []
    assert layout.faults(fs.PackProblem([bar(tilt=9)], height=20)) != []
    with pytest.raises(fs.Error, match="a tilt is from 0 to 180 degrees"):
        fs.pack(fs.PackProblem([bar(tilt=-1)], height=20), work=1)


def test_parts_of_arrays_are_parts_of_lists():
    outline, hole = [[0, 0], [8, 0], [8, 6.5], [0, 6]], [[1, 1], [3, 1], [1, 3]]
    listed = fs.PackPart("plate", outline, holes=[hole], angles=[0, 90])
    part = fs.PackPart("plate", np.array(outline), holes=np.array([hole]), angles=np.array([0, 90]))
    assert (part.rings, part.angles) == (listed.rings, listed.angles)
    layout = fs.pack(fs.PackProblem([part], height=9), work=0.2)
    assert layout.items[0].part == "plate"


def test_sheets_are_drawn_and_parts_moved_on_them():
    zone = fs.PackZone([(0, 0), (1, 0), (1, 4), (0, 4)], keeps_out=["tile"])
    plate = fs.PackSheet("plate", [(0, 0), (9, 0), (9, 4), (0, 4)], zones=[zone])
    packing = fs.Packing(fs.PackProblem([fs.PackPart("tile", [(0, 0), (3, 0), (3, 3), (0, 3)], count=2)], sheets=[plate]))
    assert packing.sheet_outline(0).startswith("M") and packing.sheet_zones(0).count("L") == 3
    with pytest.raises(fs.Error, match="no sheet 1"):
        packing.sheet_outline(1)
    layout = packing.search(work=0.2)
    moved = packing.moved(layout, 0, np.array([4, 1]))
    assert packing.verdict(moved) and moved.sheets == ["plate"]


def test_pack_on_sheets_and_into_a_strip():
    domino = fs.PackPart("domino", [(0, 0), (1, 0), (1, 2), (0, 2)], count=8, angles=[0, 90])
    layout = fs.pack(fs.PackProblem([domino], height=4), work=5)
    assert layout.length == "4" and layout.density == 1
    sheets = fs.PackProblem([domino], sheets=[fs.PackSheet("plate", [(0, 0), (2, 0), (2, 4), (0, 4)], count=3)])
    layout = fs.pack(sheets, work=5)
    assert layout.sheets == ["plate", "plate"] and layout.faults(sheets) == []
    layout.items[0].at = ("1/3", 1)
    assert any("overlap" in fault or "outside" in fault for fault in layout.faults(sheets))
    assert '"sheets"' in layout.json(sheets) and "<svg" in layout.svg(sheets)
    with pytest.raises(fs.Error):
        fs.pack(fs.PackProblem([domino], height="0.5"), work=1)
    assert fs.pack(fs.PackProblem([], height=4), work=1) is None


def test_pack_with_conditions_fixed_parts_and_zones():
    square, block = [(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 0), (4, 0), (4, 4), (0, 4)]
    parts = [fs.PackPart("a", square), fs.PackPart("b", square), fs.PackPart("block", block, angles=[0, "90"])]
    near = ("a", "b", fs.gap("self", "other") <= 0.5)
    problem = fs.PackProblem(parts, height=4, conditions=[near])
    layout = fs.pack(problem, work=2)
    assert layout.length == "5" and layout.faults(problem) == []
    wide = fs.PackProblem(parts, height=4, conditions=[("a", "b", "gap(self, other) >= 3.5")])
    assert "condition" in layout.faults(wide)[0]
    with pytest.raises(fs.Error, match="nobody"):
        fs.pack(fs.PackProblem(parts, height=4, conditions=[("a", "nobody", near[2])]), work=1)
    fixed = fs.PackProblem(parts, height=4, fixed=[fs.FixedPart("a", (6, 1), angle=45)])
    layout = fs.pack(fixed, work=2)
    assert [i.at for i in layout.items if i.part == "a"] == [("6", "1")] and layout.faults(fixed) == []
    zone = fs.PackZone([(5, 0), (9, 0), (9, 4), (5, 4)], holds=["block"])
    plate = fs.PackSheet("plate", [(0, 0), (9, 0), (9, 4), (0, 4)], zones=[zone])
    held = fs.PackProblem(parts, sheets=[plate], conditions=[near], gaps=[("a", "block", 1)])
    layout = fs.pack(held, work=2)
    assert [i.at for i in layout.items if i.part == "block"] == [("5", "0")] and layout.faults(held) == []
    same, there = pickle.loads(pickle.dumps((held, layout)))
    assert there.json(same) == layout.json(held) and there.svg(same) == layout.svg(held)
    places = lambda layout: [(i.part, i.copy, i.sheet, i.at, i.angle) for i in layout.items]
    assert places(fs.pack(same, work=2)) == places(layout)
    again = pickle.loads(pickle.dumps(fixed))
    assert places(fs.pack(again, work=2)) == places(fs.pack(fixed, work=2))


def test_pack_with_a_formula_for_all_pairs_and_groups():
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    parts = [fs.PackPart("a", square, count=2), fs.PackPart("b", square), fs.PackPart("block", [(0, 0), (2, 0), (2, 1)])]
    plate = fs.PackSheet("plate", [(0, 0), (2, 0), (2, 1), (0, 1)], count=3)
    problem = fs.PackProblem(parts, sheets=[plate], groups=[fs.PackGroup(["a"])])
    layout = fs.pack(problem, work=2)
    assert layout.faults(problem) == [] and len({item.sheet for item in layout.items if item.part == "a"}) == 1
    near = fs.PackProblem(parts, height=2, where="gap(self, other) <= 0", groups=[fs.PackGroup(["a", "b"], within=0)])
    layout = fs.pack(near, work=2)
    assert layout.faults(near) == []
    layout.items[0].at = (9, 0)
    same, there = pickle.loads(pickle.dumps((near, layout)))
    assert there.faults(same) == layout.faults(near) and any("condition" in fault for fault in there.faults(same))
    with pytest.raises(fs.Error, match="within"):
        fs.pack(fs.PackProblem(parts, height=2, groups=[fs.PackGroup(["a"])]), work=1)


def test_pack_shapes_with_arcs():
    disc = fs.PackPart("disc", fs.Shape.disc((0, 0), 2), count=6)
    problem = fs.PackProblem([disc], height=8)
    layout = fs.pack(problem, work=2)
    assert layout.length == "12" and layout.faults(problem) == [] and layout.remnant is None
    assert "A2 2 0 0 1" in layout.svg(problem)
    same, there = pickle.loads(pickle.dumps((problem, layout)))
    assert there.json(same) == layout.json(problem) and there.faults(same) == []
    plates = fs.PackProblem([disc], sheets=[fs.PackSheet("plate", [(0, 0), (16, 0), (16, 8), (0, 8)], count=2)])
    layout = fs.pack(plates, work=2)
    assert layout.faults(plates) == [] and layout.remnant.size == ("4", "8") and layout.remnant.at == ("12", "0")
    assert pickle.loads(pickle.dumps(layout)).remnant.sheet == 0
    with pytest.raises(fs.Error, match="area"):
        fs.pack(fs.PackProblem([fs.PackPart("line", fs.Shape.polyline([(0, 0), (1, 1)]))], height=8), work=1)


def test_discs_in_a_round_sheet_against_the_distances_of_their_centres():
    chance = random.Random(7)
    for seed in range(12):
        outer, inner, zone = chance.randint(8, 12), Fraction(chance.randint(5, 20), 10), Fraction(chance.randint(10, 30), 10)
        radii, edge = [Fraction(chance.randint(5, 25), 10) for _ in range(3)], chance.choice([0, Fraction(1, 4)])
        middle = (outer, outer)
        sheet = fs.Shape.subtract([fs.Shape.disc(middle, outer), fs.Shape.disc(middle, str(float(inner)))])
        kept = fs.PackZone(fs.Shape.disc((outer, outer + 4), str(float(zone))), keeps_out=["0"])
        held = fs.PackZone(fs.Shape.disc((outer, outer), outer - 1), holds=["1"])
        blank = fs.PackSheet("blank", sheet, count=2, zones=[kept, held])
        parts = [fs.PackPart(str(k), fs.Shape.disc((0, 0), str(float(r))), count=2) for k, r in enumerate(radii)]
        problem = pickle.loads(pickle.dumps(fs.PackProblem(parts, sheets=[blank], edge=str(float(edge)))))
        layout = fs.pack(problem, work=1, seed=seed)
        assert layout.faults(problem) == []
        for item in layout.items:
            x, y, k = Fraction(item.at[0]), Fraction(item.at[1]), int(item.part)
            square = (x - outer) ** 2 + (y - outer) ** 2
            assert (radii[k] + inner + edge) ** 2 <= square <= (outer - radii[k] - edge) ** 2
            if k == 0:
                assert (x - outer) ** 2 + (y - outer - 4) ** 2 >= (radii[k] + zone) ** 2
            if k == 1:
                assert square <= (outer - 1 - radii[k]) ** 2


def test_packed_discs_against_the_distances_of_their_centres():
    chance = random.Random(5)
    for seed in range(20):
        radii = [Fraction(chance.randint(5, 30), 10) for _ in range(3)]
        gap, edge, height = chance.choice([0, Fraction(1, 8)]), chance.choice([0, Fraction(1, 4)]), chance.randint(7, 14)
        parts = [fs.PackPart(str(k), fs.Shape.disc((0, 0), str(float(r))), count=2) for k, r in enumerate(radii)]
        problem = fs.PackProblem(parts, height=height, gap=str(float(gap)), edge=str(float(edge)))
        layout = fs.pack(problem, work=0.1, seed=seed, threads=1)
        items = [(Fraction(i.at[0]), Fraction(i.at[1]), radii[int(i.part)]) for i in layout.items]
        assert len(items) == 6
        for k, (x, y, r) in enumerate(items):
            assert min(x - r, y - r, height - y - r, Fraction(layout.length) - x - r) >= edge
            assert all((x - u) ** 2 + (y - v) ** 2 >= (r + s + gap) ** 2 for u, v, s in items[:k])


def test_packing_solids():
    brick = fs.PackSolid("brick", fs.Shape.box((0, 0, 0), (2, 1, 1)), count=8, orientations="right-angles")
    problem = fs.SolidPackProblem([brick], floor=(4, 2))
    told = []
    layout = fs.pack(problem, work=20, better=lambda better: told.append(better.height))
    assert layout.height == layout.lower_bound == told[-1] == "2" and layout.density == 1 and layout.met is None
    assert layout.faults(problem) == [] and layout.surface(problem).vertices.shape == (64, 3)
    for item in layout.items:
        corner = item.matrix @ [2, 1, 1, 1]
        assert (corner >= -1e-12).all() and (corner[:3] <= [4, 2, 2]).all() and abs(np.linalg.det(item.matrix) - 1) < 1e-12
    assert layout.text(problem, ".obj").count(b"\ng brick#") == 8 and "<svg" in layout.svg(problem)
    assert layout.problem is problem and layout._repr_svg_() == layout.svg(problem) and "<iframe" in layout._repr_html_()
    same, there = pickle.loads(pickle.dumps((problem, layout)))
    assert there.problem is same and there.json(same) == layout.json(problem)
    layout.items[0].at = layout.items[1].at
    layout.items[0].orientation = layout.items[1].orientation
    assert layout.faults(problem)
    stood = layout.items[0].orientation
    rows = stood.rows
    layout.items[0].orientation = next(o for o in fs.Orientation.right_angles() if o.rows != rows)
    assert stood.rows == rows != layout.items[0].orientation.rows


def test_solids_in_containers_under_conditions():
    parts = [fs.PackSolid("plug", fs.Shape.ball((0, 0, 0), "0.5"), count=2), fs.PackSolid("bar", fs.Shape.box((0, 0, 0), (5, 1, 1)))]
    far = ("plug", "plug", fs.gap("self", "other") >= 5)
    problem = fs.SolidPackProblem(parts, containers=[fs.PackContainer("tray", (9, 1, 1), count=2)], conditions=[far])
    layout = fs.pack(problem, work=1)
    assert layout.containers == ["tray"] and layout.faults(problem) == [] and layout.left_out == []
    again = pickle.loads(pickle.dumps(problem))
    assert again.containers[0].size == ("9", "1", "1") and layout.faults(again) == []
    parts.append(fs.PackSolid("beam", fs.Shape.box((0, 0, 0), (10, 1, 1)), value=3))
    left = fs.pack(fs.SolidPackProblem(parts, containers=problem.containers), work=1).left_out
    assert [(l.part, l.copies) for l in left] == [("beam", 1)]
    with pytest.raises(fs.Error, match="nobody"):
        fs.pack(fs.SolidPackProblem(parts, containers=problem.containers, groups=[fs.PackGroup(["nobody"])]), work=1)
    with pytest.raises(fs.Error, match="dimension|space"):
        fs.pack(fs.SolidPackProblem([fs.PackSolid("flat", fs.Shape.box((0, 0), (1, 1)))], floor=(2, 2)), work=1)
    with pytest.raises(ValueError, match="right-angles"):
        fs.PackSolid("bar", fs.Shape.box((0, 0, 0), (5, 1, 1)), orientations="any")
    stated = fs.SolidPackProblem.json('{"container": {"size-x": 4, "size-y": 2}, "item-types": [{"id": "rod", "demand": 2, '
                                      '"shape": {"box": {"min": [0, 0, 0], "max": [1.5, 1, 1]}}}]}')
    assert fs.pack(stated, work=1).height == "1"


def test_packing_tells_and_ends():
    ell = fs.PackPart("ell", [(0, 0), (3, 0), (3, 1), (1, 1), (1, 4), (0, 4)], count=30, angles=[0, 90, 180, 270])
    problem = fs.PackProblem([ell], height=11)
    told = []
    best = fs.pack(problem, work=2, better=lambda layout: told.append(float(layout.length)))
    assert told and told == sorted(told, reverse=True) and told[-1] == float(best.length)

    def enough(layout):
        raise RuntimeError("enough")

    begun = time.monotonic()
    with pytest.raises(RuntimeError, match="enough"):
        fs.pack(problem, seconds=60, better=enough)
    timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        fs.pack(problem, seconds=60)
    assert time.monotonic() - begun < 30


def test_packings_refuse_slips():
    square, cube = [(0, 0), (1, 0), (1, 1), (0, 1)], fs.Shape.box((0, 0, 0), (1, 1, 1))
    part, plate = fs.PackPart("a", square, count=2), fs.PackSheet("plate", square, count=2)

    def refused(words, **problem):
        with pytest.raises(fs.Error, match=words):
            fs.pack(fs.PackProblem(**problem), work=1)

    refused("two parts are called 'a'", parts=[part, part], height=3)
    refused("two sheets are called 'plate'", parts=[part], sheets=[plate, plate])
    refused("a#1 and a#2 overlap", parts=[part], height=3, fixed=[fs.FixedPart("a", (0, 0))] * 2)
    refused("there are no sheets", parts=[part], height=3, fixed=[fs.FixedPart("a", (0, 0), sheet="plate")])
    refused("plate number 3", parts=[part], sheets=[plate], fixed=[fs.FixedPart("a", (0, 0), sheet="plate", number=3)])
    refused("part 'b': 1/3 is not a decimal", parts=[part, fs.PackPart("b", [("1/3", 0), (1, 0), (1, 1)])], height=3)
    for wrong in (lambda: fs.PackPart("a", square, angles="90"), lambda: fs.FixedPart("a", "12"),
                  lambda: fs.PackSolid("a", cube, orientations=5), lambda: fs.PackSolid("a", cube, orientations=["upright"])):
        with pytest.raises(TypeError, match="angles|point|orientations"):
            wrong()
    with pytest.raises(ValueError, match="size"):
        fs.PackContainer("c", (1, 2))


def test_better_layouts_remember_their_problem():
    flat = fs.PackProblem([fs.PackPart("a", [(0, 0), (1, 0), (1, 1), (0, 1)], count=3)], height=2)
    solid = fs.SolidPackProblem([fs.PackSolid("a", fs.Shape.box((0, 0, 0), (1, 1, 1)), count=3)], floor=(2, 2))
    for problem in (flat, solid):
        told = []
        fs.pack(problem, work=1, better=told.append)
        assert all(layout.problem is problem and layout.faults(problem) == [] for layout in told) and told
        assert told[0]._repr_svg_().startswith("<svg")
