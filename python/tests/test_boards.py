# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Boards of KiCad, the words of formulas, and what regions say of themselves, in Python."""
import json
import pathlib
import pickle

import pytest

import findspace as fs

ROOT = pathlib.Path(__file__).parents[2]
SMALL = ROOT / "tests" / "data" / "boards" / "small.kicad_pcb"


def again(value):
    return pickle.loads(pickle.dumps(value))


def test_a_board_is_checked():
    board = fs.Board.file(str(SMALL))
    assert board.parts == ["R1", "R2", "H1", "R3"] and any("courtyard" in note for note in board.notes)
    assert repr(board) == "<Board of 4 parts>" and again(board).parts == board.parts
    good = board.check()
    assert good and good.holds and good.broken == [] and good.parts == 4 and "inside(self, board)" in good.rules
    bad = board.check("clear(self, others, 6.5mm)")
    assert not bad and [(b.part, b.at) for b in bad.broken] == [("R2", [20, 10]), ("H1", [30, 10])]
    assert repr(bad) == "<BoardVerdict 2 of 4 parts break the rules>" and bad.rules == "clear(self, others, 6.5mm)"
    first = bad.broken[0]
    atom, = first.check.atoms
    assert not first.check.holds and atom.text == "clear(self, H1, 6.5)" and atom.distance.value == 6 and atom.lacks == 0.5
    assert json.loads(bad.json())["holds"] is False and "R2" in bad.text() and bad.svg.startswith("<svg")
    assert bad._repr_svg_() == bad.svg and str(bad) == bad.text() and bad.text(explain=True) != bad.text()
    same = again(bad)
    assert [b.part for b in same.broken] == [b.part for b in bad.broken] and same.json() == bad.json()
    assert again(first).at == first.at


def test_parts_of_a_board_move():
    board = fs.Board.text(SMALL.read_text(), groups={"ends": ["R1", "H1"]}, fixed=["R3"])
    world = board.world("R2")
    assert world.moving == "R2" and world.unit == "mm"
    region = world.solve("inside(R2, board) and clear(R2, others)")
    assert (20, 10) in region and (10, 10) not in region
    there = again(world)
    assert there.solve("inside(R2, board) and clear(R2, others)") == region == again(region)
    for formula in ("between(smd, smd) >= 1mm", "clear(R2, all except R1)", "clear(R2, fixed, 50mm)", "clear(R2, ends, 6mm)"):
        assert [there.holds(formula, p) for p in ((20, 10), (10, 10))] == [world.holds(formula, p) for p in ((20, 10), (10, 10))]
    assert there.groups == world.groups and world.groups["ends"] == ["R1", "H1"]
    assert not world.holds("clear(R2, ends, 6.5mm)", (20, 10)) and world.holds("clear(R2, ends, 6mm)", (20, 10))
    assert board.world(["ends"]).moving_together == ["R1", "R1.1", "R1.2", "H1", "H1.1", "ends"]
    again_of = again(board)
    assert again_of.source == SMALL.read_text() and again_of.world("R2").solve("clear(R2, ends)") == world.solve("clear(R2, ends)")
    with pytest.raises(fs.Error, match="R3"):
        board.world("R3")
    with pytest.raises(fs.Error, match="nothing moves"):
        board.world([])


def test_boards_are_scenes():
    board = fs.Board.text(SMALL.read_text(), groups={"ends": ["R1", "H1"]})
    scene = board.scene("R2", "inside(R2, board) and clear(R2, others)")
    assert scene.moving[0] == "R2" and scene.board.source == board.source and scene.groups["ends"] == ["R1", "H1"]
    assert fs.Scene.json('{"findspace": 1, "shapes": {}}').board is None
    found = scene.map()
    assert found.region[0] == board.world("R2").solve(scene.where)
    same = again(found)
    assert same.region[0] == found.region[0] and again(scene).board.parts == board.parts
    closer = scene.asking(where="clear(R2, ends, 6.5mm)")
    assert [again(closer).check((20, 10)).found, again(scene).check((20, 10)).found] == ["no", "yes"]
    turned = again(board.scene("R2", angles=[0, "45"]))
    assert turned.free.kind == "pose" and turned.free.angles == ["0", "45"]
    placed = board.scene(["R1", "R2"], place=True).place()
    assert placed.found == "yes" and "kicad_pcb" in placed.file(".kicad_pcb")[0]


def test_angles_count_as_they_are_seen():
    corner = "(xy 0 0) (xy 4 0) (xy 4 1) (xy 1 1) (xy 1 3) (xy 0 3)"
    board = fs.Board.text('(kicad_pcb (version 20211014) (layers (0 "F.Cu" signal))\n'
                          '(gr_rect (start 0 0) (end 20 20) (layer "Edge.Cuts"))\n'
                          '(footprint "F" (layer "F.Cu") (at 5 5) (fp_text reference "U1" (at 0 0))\n'
                          f'(fp_poly (pts {corner}) (layer "F.CrtYd"))))\n')
    scene = board.scene("U1", "inside(U1, board)")
    assert scene.y_down and not scene.clockwise
    assert fs.Scene.json('{"findspace": 1, "y": "down", "shapes": {}}').clockwise
    quarter = board.scene("U1", "inside(U1, board)", angles=[0, 90]).map().poses.slices[1]
    assert quarter.degrees == 90 and quarter.region.bounds == (0, 4, 17, 20)
    for at, found in (((1, 10), "yes"), ((10, 2), "no")):
        answers = [scene.check(at, 90), scene.rotated(90).check(at), again(scene.rotated(90)).check(at)]
        assert [a.found for a in answers] == [found] * 3
        assert scene.explain(at, 90).explanation.here.holds == (found == "yes")
        angles = scene.asking(free="angle").map(at).intervals
        assert any((90 - i.start) % 360 <= i.end - i.start for i in angles) == (found == "yes")


def test_boards_say_what_is_wrong(tmp_path):
    with pytest.raises(fs.Error) as caught:
        fs.Board.file(str(tmp_path / "none.kicad_pcb"))
    assert caught.value.code == "file"
    with pytest.raises(fs.Error) as caught:
        fs.Board.text("(kicad_pcb\n(net 0", name="mine")
    assert caught.value.code == "syntax" and caught.value.place.startswith("mine:")
    with pytest.raises(fs.Error, match="R9"):
        fs.Board.text(SMALL.read_text(), groups={"ends": ["R9"]})
    with pytest.raises(fs.Error) as caught:
        fs.Board.file(str(SMALL), input_limit=10)
    assert caught.value.code == "limit"
    with pytest.raises(fs.Error) as caught:
        fs.Board.file(str(SMALL)).check("clear(self, otters)", place="house rules")
    assert caught.value.place.startswith("house rules:1:") and "others" in str(caught.value)


def test_words_of_formulas():
    words = {w.word: w for w in fs.distance_words()}
    assert words["gap"].distance == words["gamma1"].distance == "gamma1" and words["gap"].symbol == "γ₁"
    assert words["gap"].directional and not words["gap"].negated and {w.distance for w in words.values()} <= set(words)
    predicates = {w.word: w for w in fs.predicate_words()}
    assert (predicates["clear"].relation, predicates["clear"].level, predicates["clear"].negated) == (">=", "optional", False)
    assert predicates["within"].level == "required" and predicates["overlaps"].level == "none"
    assert again(predicates["clear"]).word == "clear" and again(words["gap"]).symbol == "γ₁"
    assert {"mm", "mil", "um"} <= set(fs.unit_words())
    assert fs.nearest_word("claer", list(predicates)) == "clear" and fs.nearest_word("zzzzzz", list(predicates)) == ""


def test_regions_say_what_they_are(tmp_path):
    ring = fs.Shape.disc((0, 0), 2).region - fs.Shape.disc((0, 0), 1).region.interior()
    assert "area" in ring.text("ring") and "ring" in ring.text("ring")
    assert fs.Scene.json(ring.scene_json()).shapes["region"].region == ring
    text, lost = ring.interior().drawn(".svg", "ring")
    assert "<path" in text and lost
    for ending, begins in ((".dxf", "0\n"), (".wkt", "")):
        text, lost = fs.Shape.box((0, 0), (2, 1)).region.drawn(ending)
        assert text.lstrip().startswith(begins) and lost == ""
    assert "AC1015" in ring.drawn(".dxf", version="2000")[0]
    assert "A title" in ring.complement().picture("A title", "below it")
    for wrong in (lambda: ring.drawn(".png"), lambda: ring.drawn(".geojson"), lambda: ring.complement().drawn(".svg")):
        with pytest.raises(fs.Error) as caught:
            wrong()
        assert caught.value.code == "unsupported"


def test_exact_coordinates_of_regions():
    lens = fs.Shape.disc((-1, 0), 2).region & fs.Shape.disc((1, 0), 2).region
    ring = lens.components[0].rings[0]
    assert sorted(ring.exact_vertices) == [("0", "-sqrt(3)"), ("0", "sqrt(3)")] and ring.belong == [True, True]
    assert lens.interior().components[0].rings[0].belong == [False, False]
    assert all(edge.left_belongs and not edge.right_belongs for edge in ring.edges)
    assert again(ring.edges[0]).left_belongs and lens.components[0].bounds == pytest.approx((-1, -3**.5, 1, 3**.5))
    hole = (fs.Shape.box((0, 0), (9, 9)) - fs.Shape.box((3, 3), (6, 6))).region.components[0]
    assert all(edge.left_belongs and not edge.right_belongs for part in hole.rings for edge in part.edges)
    spot = fs.Shape.points([("0.5", "1.25")]).region.components[0]
    assert spot.exact_points == [("0.5", "1.25")] or spot.exact_points == [("1/2", "5/4")]
    assert lens.complement().components[0].bounds is None


def test_units_pickle():
    world = fs.World({"A": fs.Shape.box((0, 0), (9, 9)), "B": fs.Shape.disc((0, 0), 1)}, "B", unit="mm")
    region = world.solve("inside(B, A)")
    same = again(region)
    assert same == region and same.text() == region.text() and "mm" in same.text() and "unit" in same.json
    scene = fs.Scene.json('{"findspace": 1, "unit": "cm", "shapes": {"A": {"box": {"min": [0, 0], "max": [9, 9]}}, '
                          '"B": {"disc": {"center": [0, 0], "radius": 1}}}, "moving": "B", "where": "inside(B, A)"}')
    there = again(scene.world)
    assert there.unit == "cm" and there.solve(scene.where) == scene.world.solve(scene.where)
    assert again(scene.shapes["A"]).region == scene.shapes["A"].region


def test_groups_of_shapes():
    box = fs.Shape.box((-1, -1), (1, 1))
    plain = fs.World({"A": box.translated((5, 0)), "B": box.translated((9, 0)), "C": box}, moving="C")
    world = plain.grouped({"both": ["A", "B"], "none": [], "movers": ["C"], "smd": ["A", "C"]}, all=["A", "C"])
    for asked in (world, again(world)):
        assert asked.distance("gap(C, both)", (14, 0)).value == 3 and asked.distance("gap(C, smd)", (14, 0)).value == 7
        assert asked.holds("clear(C, none, 99) and clear(C, movers, 99)", (0, 0))
        assert asked.holds("clear(C, others, 4)", (12, 0)) and not asked.holds("clear(C, both, 4)", (12, 0))
        assert not asked.holds("between(smd, smd) >= 3.5", (0, 0)) and asked.holds("between(smd, smd) >= 3", (0, 0))
        assert asked.solve("clear(C, both)") == plain.solve("clear(C, A) and clear(C, B)")
        assert asked.groups == {"both": ["A", "B"], "none": [], "movers": ["C"], "smd": ["A", "C"]}
    assert world.grouped({"more": ["B"]}).groups.keys() == {"both", "none", "movers", "smd", "more"} and plain.groups == {}
    with pytest.raises(fs.Error, match="unknown shape 'D'|'D'"):
        plain.grouped({"both": ["A", "D"]})
    with pytest.raises(fs.Error):
        plain.solve("clear(C, both)")


def test_what_problems_were_made_of():
    world = fs.World({"cart": fs.Shape.disc((0, 0), 1), "post": fs.Shape.disc((0, 0), 1)}, "cart")
    assert world.motion is None and world.time is None
    moving = again(world.in_motion({"post": [(0, (-5, 0)), (1, (5, "0.5"))]}))
    assert moving.motion == ("0", "1", {"post": [("0", ("-5", "0"), "0"), ("1", ("5", "0.5"), "0")]})
    assert moving.at_time("0.5").time == "0.5"
    assert fs.Body("A", angles=[0, "22.5"], count=2).angles == ["0", "22.5"]
    box = fs.World({"A": fs.Shape.box((0, 0, 0), (9, 9, 9)), "B": fs.Shape.box((0, 0, 0), (1, 1, 1))}, "B")
    assert box.solve("inside(B, A)").form == "boxes"
    turned = fs.Shape.box((0, 0), (3, 1)).rotated(30)
    assert turned.rotated_points[0] == 3 and 0 < turned.rotated_points[1] < 1e-5
    assert fs.Shape.json(turned.exact_json).region == turned.region


def test_phi_is_written():
    phi = fs.Phi(fs.Shape.polygon([[0, 0], [6, 0], [6, 1], [1, 1], [1, 5], [0, 5]]), fs.Shape.box((0, 0), (1, 1)))
    assert phi.parts_of_a >= 2 and phi.parts_of_b == 1 and phi.rounded_of_a == (0, 0.0) == phi.rounded_of_b
    told = json.loads(phi.text(".json", (7, 0), least=1, a="ell", b="box"))
    assert told["at"]["adjusted"][0]["distance"] == 1 and len(told["parts"]) >= 2 and b"of ell and box" in phi.text(".txt", a="ell", b="box")
    for wrong, code in ((lambda: phi.text(".png"), "unsupported"), (lambda: phi.text(".json", (1, 2, 3)), "bad value"),
                        (lambda: phi.text(".json", (1, 2), least=-1), "bad value")):
        with pytest.raises(fs.Error) as caught:
            wrong()
        assert caught.value.code == code
