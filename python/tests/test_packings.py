# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Packings that are asked many questions: searches from a layout on, verdicts, files, several searches together."""
import json
import os
import pathlib
import pickle
import signal
import threading
import time

import numpy as np
import pytest

import findspace as fs

ROOT = pathlib.Path(__file__).parents[2]
ELL = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 4), (0, 4)]


def strip(count=12):
    return fs.PackProblem([fs.PackPart("ell", ELL, count=count, angles=[0, 90, 180, 270])], height=11, name="ells")


def again(value):
    return pickle.loads(pickle.dumps(value))


def test_a_packing_says_what_it_was_given():
    zone = fs.PackZone([(0, 0), (4, 0), (4, 4), (0, 4)], keeps_out=["disc"])
    sheet = fs.PackSheet("plate", [(0, 0), (9, 0), (9, 9), (0, 9)], count=2, cost="2.5", zones=[zone])
    disc = fs.PackPart("disc", fs.Shape.disc((0, 0), 1), count=2, value=7)
    ell = fs.PackPart("ell", ELL, angles=[0, "22.5"], mirrored=True, tilt=3)
    problem = fs.PackProblem([disc, ell], sheets=[sheet], gap="0.25", edge=0.5, name="plates", gaps=[("disc", "ell", 1)],
                             conditions=[("disc", "disc", "gap(self, other) <= 8")], where="reach(self, other) <= 30",
                             groups=[fs.PackGroup(["disc"], within=9)],
                             fixed=[fs.FixedPart("ell", (5, "1.5"), angle=90, sheet="plate", number=1)])
    for told in (problem, again(problem), fs.Packing(problem).problem, again(fs.Packing(problem)).problem):
        assert (told.name, told.gap, told.edge, told.height, told.box) == ("plates", "0.25", "0.5", "0", False)
        assert told.gaps == [("disc", "ell", "1")] and told.conditions == [("disc", "disc", "gap(self, other) <= 8")]
        assert told.where == "reach(self, other) <= 30" and told.groups[0].within == "9"
        one, two = told.parts
        assert one.value == "7" and one.shape.region == fs.Shape.disc((0, 0), 1).region and one.rings == []
        assert (two.angles, two.mirrored, two.tilt, two.value) == (["0", "22.5"], True, "3", None)
        assert two.rings == [[(str(x), str(y)) for x, y in ELL]]
        plate = told.sheets[0]
        assert (plate.count, plate.cost, plate.zones[0].keeps_out) == (2, "2.5", ["disc"])
        assert plate.zones[0].rings[0][2] == ("4", "4")
        fixed = told.fixed[0]
        assert (fixed.at, fixed.angle, fixed.mirrored, fixed.sheet, fixed.number) == (("5", "1.5"), "90", False, "plate", 1)
    assert fs.Packing(problem).copies == 3
    assert fs.PackSheet.rectangle("A4", 297, 210).rings == [[("0", "0"), ("297", "0"), ("297", "210"), ("0", "210")]]


def test_a_search_goes_on_from_a_layout():
    packing = fs.Packing(strip())
    told, states = [], []
    first = packing.search(work=1, seed=3, threads=1, better=lambda layout, state: told.append((layout, state)))
    assert told[-1][0].length == first.length and told[-1][1].length == pytest.approx(float(first.length))
    assert all(packing.verdict(layout) and layout.problem.name == "ells" for layout, _ in told)
    on = packing.search(work=1, seed=4, threads=1, start=first, progress=states.append)
    assert float(packing.lower_bound) <= float(on.length) <= float(first.length) and packing.verdict(on).feasible
    assert states and [s.seconds for s in states] == sorted(s.seconds for s in states)
    state = again(states[-1])
    assert state.density == states[-1].density and "PackProgress" in repr(state) and state.overlap >= 0
    assert state.processor >= 0 and state.since_better >= 0
    packing.check_start(on)
    with pytest.raises(fs.Error, match="other parts than the problem"):
        fs.Packing(strip(11)).search(work=1, start=on)
    with pytest.raises(fs.Error, match="other parts"):
        fs.Packing(strip(11)).check_start(on)


def test_the_same_search_brings_the_same_layout():
    packing = fs.Packing(strip())
    one, two = (packing.search(fs.Options(work=1, seed=9, threads=1)) for _ in range(2))
    three = fs.pack(strip(), work=1, seed=9, threads=1)
    places = lambda layout: [(item.at, item.angle) for item in layout.items]
    assert places(one) == places(two) == places(three) == places(again(one))


def test_verdicts_say_what_is_wrong():
    packing = fs.Packing(strip(2))
    layout = packing.search(work=1)
    good = packing.verdict(layout)
    assert good and good.faults == [] and good.used == layout.length and repr(good) == "<PackVerdict feasible>"
    layout.items[0].at = layout.items[1].at
    bad = again(packing.verdict(layout))
    assert not bad and not bad.feasible
    fault = next(f for f in bad.faults if f.kind == "overlap")
    assert fault.of == ["ell#1", "ell#2"] and fault.depth > 0 and len(fault.near) == 2 and fault.text in str(fault)
    assert layout.faults() == layout.faults(packing) == [f.text for f in bad.faults]
    layout.items[0].at = (-5, 0)
    assert {f.kind for f in packing.verdict(layout).faults} == {"outside"}


def test_texts_of_layouts():
    packing = fs.Packing(strip())
    layout = packing.search(work=1)
    read = packing.layout(layout.json())
    assert [i.at for i in read.items] == [i.at for i in layout.items] and read.problem.name == "ells"
    assert layout.json() == layout.json(packing) == layout.json(strip()) and json.loads(layout.json())
    assert layout._repr_svg_() == layout.svg(packing) and layout.svg().startswith("<svg")
    assert "AC1009" in layout.dxf() and "AC1015" in layout.dxf(version="2000") and layout.dxf(packing) == layout.dxf()
    assert packing.outline(0).startswith("M")
    for item in layout.items:
        x, y = (item.matrix @ [[p[0] for p in ELL], [p[1] for p in ELL], [1] * len(ELL)])[:2]
        assert x.min() >= -1e-9 and y.min() >= -1e-9 and y.max() <= 11 + 1e-9 and x.max() <= float(layout.length) + 1e-9
        assert np.linalg.det(item.matrix) == pytest.approx(1)
    with pytest.raises(ValueError, match="R12"):
        layout.dxf(version="R14")
    with pytest.raises(fs.Error) as caught:
        packing.layout('{"solution": ', name="mine.json")
    assert caught.value.code == "syntax" and caught.value.place.startswith("mine.json:1:")
    with pytest.raises(fs.Error, match="there is no part 1"):
        packing.outline(1)
    forgetful = again(layout)
    del forgetful.problem
    with pytest.raises(TypeError, match="does not know its problem"):
        forgetful.json()
    assert forgetful.json(packing) == layout.json() and forgetful._repr_svg_() is None


def test_items_are_put_elsewhere_by_hand():
    packing = fs.Packing(strip(3))
    layout = packing.search(work=1)
    assert packing.moved(layout, 0, [float(c) for c in layout.items[0].at]).length == layout.length
    moved = packing.moved(layout, 0, (20, 8))
    assert packing.verdict(moved) and moved.problem.name == "ells" and len(moved.items) == 3
    assert [i.at for i in moved.items] != [i.at for i in layout.items]
    with pytest.raises(fs.Error, match="items 0 to 2"):
        packing.moved(layout, 3, (0, 0))


def test_nesting_files(tmp_path):
    text = (ROOT / "examples" / "packing" / "rounded.json").read_text()
    packing = fs.Packing.json(text, name="rounded.json", gap="0.5", height=70)
    assert packing.copies == 26 and (packing.problem.gap, packing.problem.height) == ("0.5", "70")
    assert again(packing).copies == 26
    with pytest.raises(fs.Error) as caught:
        fs.Packing.json('{"items": 5}', name="mine.json")
    assert caught.value.place.startswith("mine.json")
    (tmp_path / "part.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0H4V2H0Z"/></svg>')
    stated = json.dumps({"name": "one", "strip_height": 9, "items": [
        {"id": 0, "demand": 3, "allowed_orientations": [0], "shape": {"file": "part.svg"}}]})
    assert fs.Packing.json(stated, folder=str(tmp_path)).copies == 3
    with pytest.raises(fs.Error) as caught:
        fs.Packing.json(stated, folder=str(tmp_path), reading=fs.ReadOptions(files=False))
    assert caught.value.code == "unsupported"


SPARROW = """<svg xmlns="http://www.w3.org/2000/svg"><g id="container_0"><path d="M0,0 L6,0 L6,4 L0,4 z"/></g>
<g id="items"><defs><g id="item_0"><path d="M0,0 L3,0 L3,1 L0,1 z"/></g><g id="item_1"><path d="M0,0 L1,0 L0,1 z"/></g></defs>
<use href="#item_0" transform="translate(0 0), rotate(0)"/><use href="#item_0" transform="translate(1 1), rotate(90)"/>
<use href="#item_1" transform="translate(4 1), rotate(0)"/></g></svg>"""


def test_a_drawing_of_sparrow_is_read_with_its_layout():
    packing, layout = fs.Packing.sparrow(SPARROW)
    assert packing.copies == 3 and packing.verdict(layout) and layout.length == "6"
    assert [(i.part, i.copy, i.at, i.angle) for i in layout.items] == [
        ("0", 1, ("0", "0"), "0"), ("0", 2, ("1", "1"), "90"), ("1", 1, ("4", "1"), "0")]
    assert packing.problem.parts[0].angles == ["0", "90"] and packing.problem.height == "4"
    assert json.loads(layout.json()) == json.loads(layout.json(again(packing)))
    with pytest.raises(fs.Error, match="not a layout of sparrow"):
        fs.Packing.sparrow("<svg></svg>")


def test_solids():
    bar = fs.PackSolid("bar", fs.Shape.box((0, 0, 0), (4, 1, 1)), count=6, orientations="upright", value=2)
    problem = fs.SolidPackProblem([bar], floor=(5, 4), gap="0.25", name="bars", gaps=[("bar", "bar", "0.5")])
    packing = fs.SolidPacking(problem)
    assert packing.problem.floor == ("5", "4") and packing.problem.gaps == [("bar", "bar", "0.5")]
    assert packing.problem.parts[0].value == "2" and packing.copies == 6 and again(packing).copies == 6
    told = []
    layout = packing.search(work=1, better=lambda found, state: told.append(state))
    assert packing.verdict(layout) and told[-1].length == pytest.approx(float(layout.height))
    assert float(packing.lower_bound) <= float(layout.lower_bound) <= float(layout.height)
    assert packing.search(work=0.1, start=layout).height <= layout.height
    assert packing.layout(layout.json()).json(packing) == packing.layout(layout.json(problem)).json()
    assert layout.text(ending=".obj") == layout.text(packing, ".obj") and layout.surface().vertices.shape == (48, 3)
    assert packing.outline(0).vertices.shape == (8, 3)
    moved = packing.moved(layout, 0, (0, 0, 20))
    assert moved.items[0].at == ("0", "0", "20") and packing.verdict(moved) and moved.problem.name == "bars"
    layout.items[0].at = layout.items[1].at
    layout.items[0].orientation = layout.items[1].orientation
    fault = packing.verdict(layout).faults[0]
    assert fault.kind == "overlap" and len(fault.near) == 3 and layout.faults()[0] == fault.text
    with pytest.raises(fs.Error, match="to start with is not feasible"):
        packing.search(work=1, start=layout)
    text = (ROOT / "examples" / "packing" / "crate.json").read_text()
    assert fs.SolidPacking.is_stated_in(text) and not fs.SolidPacking.is_stated_in("{}")
    assert fs.SolidPacking.json(text, folder=str(ROOT / "examples" / "packing")).copies > 1
    container = fs.PackContainer("van", (9, 9, 9), count=3, cost="1.5")
    assert (container.count, container.cost) == (3, "1.5")


class Team:
    """Searches of several threads that agree, as processes do under MPI."""

    def __init__(self, size):
        self.barrier, self.said = threading.Barrier(size, timeout=60), [None] * size

    class Member:
        def __init__(self, team, number):
            self.team, self.own = team, number

        def number(self):
            return self.own

        def _shared(self, what):
            self.team.said[self.own] = what
            self.team.barrier.wait()
            out = list(self.team.said)
            self.team.barrier.wait()
            return out

        def any(self, own):
            return any(self._shared(own))

        def best_of(self, cost, own):
            assert isinstance(own, bytes)
            return min(enumerate(self._shared((cost, own))), key=lambda said: (said[1][0], said[0]))[1][1]


def test_searches_that_take_part_in_one():
    team, found = Team(2), [None, None]
    packing = fs.Packing(strip())

    def search(k):
        found[k] = packing.search(work=0.5, threads=1, peers=Team.Member(team, k))

    threads = [threading.Thread(target=search, args=(k,)) for k in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found[0] is not None and [i.at for i in found[0].items] == [i.at for i in found[1].items]
    assert packing.verdict(found[0])
    with pytest.raises(TypeError, match="best_of"):
        packing.search(work=1, peers=object())


def test_searches_end_when_asked():
    packing = fs.Packing(strip(40))

    def enough(*_):
        raise RuntimeError("enough")

    begun = time.monotonic()
    for words in ({"better": enough}, {"progress": enough}):
        with pytest.raises(RuntimeError, match="enough"):
            packing.search(seconds=60, **words)
    timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        packing.search(seconds=60)
    token = fs.Cancel()
    timer = threading.Timer(0.5, token.request)
    timer.start()
    assert packing.search(seconds=60, cancel=token).met == "cancelled"
    assert time.monotonic() - begun < 40
    with pytest.raises(TypeError):
        packing.search(work=1, start=5)
    with pytest.raises(TypeError):
        packing.search(work=1, words=5)


def test_reading_is_limited():
    scene = '{"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0], "max": [9, 9]}}}}'
    with pytest.raises(fs.Error) as caught:
        fs.Scene.json(scene, reading=fs.ReadOptions(input_limit=20))
    assert caught.value.code == "limit"
    rules = again(fs.DrawingRules(curves="inside", tolerance="0.1", open_lines=True, mend=0, parts="outlines", repair=1,
                                  close_holes="2.5"))
    assert (rules.curves, rules.tolerance, rules.join, rules.mend) == ("inside", "0.1", None, "0")
    assert (rules.open_lines, rules.parts, rules.repair, rules.close_holes) == (True, "outlines", "1", "2.5")
    with pytest.raises(ValueError, match="near"):
        fs.DrawingRules(curves="along")
    read = fs.Scene.json(scene, reading=fs.ReadOptions(root="/tmp", files=False, work_limit=10**6, drawings=rules))
    kept = again(read).reading
    assert (kept.root, kept.files, kept.work_limit, kept.drawings.curves) == ("/tmp", False, 10**6, "inside")
    assert kept.input_limit == fs.ReadOptions().input_limit and again(read).text == scene and read.folder == "."


def test_solids_stand_round_what_is_fixed():
    cube = fs.PackSolid("cube", fs.Shape.box((0, 0, 0), (1, 1, 1)), count=3, orientations="upright")
    post = fs.FixedSolid("cube", (1, "0", 0))
    problem = fs.SolidPackProblem([cube], floor=(3, 1), fixed=[post])
    for told in (problem, again(problem), fs.SolidPacking(problem).problem, again(fs.SolidPacking(problem)).problem):
        fixed = told.fixed[0]
        assert (fixed.part, fixed.at, fixed.container, fixed.number) == ("cube", ("1", "0", "0"), "", 1)
        assert fixed.orientation.rows == fs.Orientation([[1, 0, 0], [0, 1, 0], [0, 0, 1]]).rows
    layout = fs.pack(problem, work=2)
    assert layout.height == "1" and sorted(item.at for item in layout.items) == [(x, "0", "0") for x in "012"]
    next(item for item in layout.items if item.at[0] == "1").at = ("1", "0", "5")
    assert "a fixed cube does not stand at (1, 0, 0)" in layout.faults(problem)
    turned = fs.FixedSolid("cube", (1, 1, 0), fs.Orientation.about("z", 180), container="crate", number=2)
    crates = [fs.PackContainer("crate", (2, 2, 1), count=2)]
    with pytest.raises(fs.Error, match="without a gap"):
        fs.SolidPacking(fs.SolidPackProblem([cube], containers=crates, fixed=[turned]))
    with pytest.raises(fs.Error, match="only a floor"):
        fs.SolidPacking(fs.SolidPackProblem([cube], floor=(3, 1), fixed=[turned]))
    with pytest.raises(fs.Error, match="overlap"):
        fs.SolidPacking(fs.SolidPackProblem([cube], floor=(3, 1), fixed=[post, post]))


def test_containers_of_any_shape():
    cube = fs.PackSolid("cube", fs.Shape.box((0, 0, 0), (1, 1, 1)), count=4)
    ramp = fs.PackContainer("ramp", shape=fs.Shape.polytope([[5, 0, 0], [8, 0, 0], [5, 0, 3], [5, 1, 0], [8, 1, 0], [5, 1, 3]]))
    problem = fs.SolidPackProblem([cube], containers=[ramp])
    layout = fs.pack(problem, work=2)
    assert sorted(item.at for item in layout.items) == [("0", "0", "0"), ("0", "0", "1"), ("1", "0", "0")]
    assert [(out.part, out.copies) for out in layout.left_out] == [("cube", 1)]
    layout.items[0].at = ("1", "0", "1")
    assert layout.faults(problem)[0].startswith("cube#1 is outside by 0.707")
    for told in (problem, pickle.loads(pickle.dumps(problem)), fs.SolidPacking(problem).problem):
        assert told.containers[0].shape is not None and told.containers[0].size == ("0", "0", "0")
    text = json.dumps({"containers": [{"id": "ramp", "shape": {"polytope": [[5, 0, 0], [8, 0, 0], [5, 0, 3], [5, 1, 0], [8, 1, 0], [5, 1, 3]]}}],
                       "item-types": [{"id": "cube", "demand": 4, "shape": {"box": {"min": [0, 0, 0], "max": [1, 1, 1]}}}]})
    inside = fs.SolidPacking(problem).inside(0).vertices
    assert inside.shape == (6, 3) and inside.min() == 0 and inside.max(axis=0).tolist() == [3, 1, 3]
    with pytest.raises(fs.Error, match="there is no container 1"):
        fs.SolidPacking(problem).inside(1)
    read = fs.SolidPackProblem.json(text)
    assert read.containers[0].shape is not None and len(fs.pack(read, work=2).items) == 3
    with pytest.raises(fs.Error, match="container 'c': it has either sizes or a shape"):
        fs.SolidPacking(fs.SolidPackProblem([cube], containers=[fs.PackContainer("c", (1, 1, 1), shape=cube.shape)]))
    with pytest.raises(fs.Error, match="container 'c': a container is bounded"):
        fs.SolidPacking(fs.SolidPackProblem([cube], containers=[fs.PackContainer("c", shape=~fs.Shape.ball((0, 0, 0), 3))]))
    with pytest.raises(fs.Error, match="sizes above 0"):
        fs.SolidPacking(fs.SolidPackProblem([cube], containers=[fs.PackContainer("c")]))
