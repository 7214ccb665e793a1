# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Placements, motions, poses, lines of space, surfaces, and their pickles."""
import html
import json
import pickle
import re

import numpy as np
import pytest

import findspace as fs


def again(value):
    return pickle.loads(pickle.dumps(value))


@pytest.fixture
def passing():
    world = fs.World({"cart": fs.Shape.disc((0, 0), 1), "post": fs.Shape.disc((0, 0), 1)}, moving="cart")
    return world.in_motion({"post": [(0, (-5, 0)), (1, (5, 0))]})


def test_place_one_after_another():
    shapes = {"sheet": fs.Shape.box((0, 0), (30, 20)), "bar": fs.Shape.box((0, 0), (2, 25))}
    found = fs.place(shapes, [fs.Body("bar", angles=[0, 90], count=2)], each="inside(self, sheet)",
                     pairs=fs.clear("self", "other", 1), minimize=["y", "x"], unit="mm")
    assert found.complete and found.unproven == ""
    assert [(p.at, p.degrees, p.copy) for p in found.placed] == [([25, 0], 90, 1), ([25, 3], 90, 2)]
    assert found.placed[0].exact_at == ["25", "0"]
    index, degrees, region = found.positions[1]
    assert (index, degrees, region.area) == (0, 90, 5 * 18)
    assert json.loads(found.json)["unit"] == "mm"
    assert "<svg" in found._repr_svg_()


PLACING = """{"findspace": 1, "shapes": {"sheet": {"box": {"min": [0, 0], "max": [30, 20]}},
    "bar": {"box": {"min": [0, 0], "max": [2, 25]}}}, "place": {"shapes": ["bar"], "angles": {"bar": [0, 90]},
    "count": {"bar": 2}, "each": "inside(self, sheet)", "pairs": "clear(self, other, 1)", "minimize": ["y", "x"]}}"""


def test_scenes_place():
    scene = fs.Scene.json(PLACING)
    answer = scene.place()
    assert scene.places and answer.found == "yes" and answer.endings == [".json", ".dxf", ".svg"]
    assert [(p.at, p.degrees) for p in answer.placement.placed] == [([25, 0], 90), ([25, 3], 90)]
    assert answer.placement.json == answer.json() and "<svg" in answer._repr_svg_()
    assert answer.placement.positions[1][2].area == 5 * 18
    shapes = {name: scene.shapes[name] for name in scene.names}
    again_by_hand = fs.place(shapes, [fs.Body("bar", angles=[0, 90], count=2)], each="inside(self, sheet)",
                             pairs=fs.clear("self", "other", 1), minimize=["y", "x"])
    assert again_by_hand.json == answer.json()
    near = scene.place(near=[("bar", ("26.5", 9), None, 2)]).placement.placed[0]  # it comes first
    assert (near.at, near.degrees, near.copy) == ([26.5, 9], 90, 2)
    with pytest.raises(fs.Error, match="near: 'bar 2' is not placed at 45 degrees"):
        scene.place(near=[("bar", (0, 0), 45, 2)])
    with pytest.raises(ValueError, match="near"):
        scene.place(near=[("bar",)])
    with pytest.raises(TypeError, match="near"):
        scene.place(near=["bar"])
    assert fs.Scene.json(PLACING.replace("30, 20", "20, 20")).place().found == "no"
    assert scene.limited(seconds=1e-9).place().found == "undecided"


def test_place_says_what_is_wrong():
    shapes = {"sheet": fs.Shape.box((0, 0), (30, 20)), "A": fs.Shape.box((0, 0), (40, 1))}
    found = fs.place(shapes, ["A"], each="inside(self, sheet)")
    assert not found.complete and found.placed[0].at is None
    with pytest.raises(fs.Error) as caught:
        fs.place(shapes, ["A"], each="inside(self, shet)")
    assert caught.value.place.startswith("each") and "did you mean" in caught.value.message
    with pytest.raises(fs.Error, match="body 'B'"):
        fs.place(shapes, ["B"])


def test_motion(passing):
    assert passing.distance("inf gap(cart, post)", (0, 3)).value == 1
    instants = passing.instants("gap(cart, post) <= 1", (0, 3))
    assert instants.exact and [(i.start, i.end) for i in instants.certain] == [(0.5, 0.5)]
    assert passing.at_time("0.9").distance("gap(cart, post)", (4, 3)).value == 1
    with pytest.raises(fs.Error, match="post"):
        passing.in_motion({"post": [(2, (0, 0))]})
    with pytest.raises(ValueError, match="way point"):
        passing.in_motion({"post": [(0,)]})
    thirds = fs.Scene.json(json.dumps({
        "findspace": 1, "shapes": {name: {"disc": {"center": [0, 0], "radius": 1}} for name in ("cart", "post")}, "moving": "cart",
        "motion": {"time": [0, 1], "post": {"path": [[0, 0], [1, 0], [2, 0], [3, 0]]}}}))
    for world in (thirds.world, pickle.loads(pickle.dumps(thirds.world))):
        assert world.at_time("1/3").distance("gap(cart, post)", (4, 0)).value == 1


def test_poses():
    world = fs.World({"room": fs.Shape.box((0, 0), (5, 3)), "bar": fs.Shape.box((-2, -1), (2, 1))}, moving="bar")
    poses = world.poses("inside(bar, room)", [0, 5])
    assert [s.region.area for s in poses.slices][0] == 1
    sector = poses.sectors[0]
    assert (sector.start, sector.end) == (0, 5) and (sector.inner - poses.slices[1].region).empty
    inner, outer = world.solve_bounds("inside(bar, room)")
    assert inner == outer == poses.slices[0].region


def test_lines_of_space():
    world = fs.World({"room": fs.Shape.box((0, 0, 0), (10, 10, 10)), "ball": fs.Shape.ball((0, 0, 0), 1),
                      "other": fs.Shape.ball((5, 5, 5), 2)}, moving="ball")
    where = "inside(ball, room) and clear(ball, other)"
    lines = world.on_lines(where, 16)
    assert lines.exact and not lines.unbounded
    through, intervals = lines.lines[0]
    assert [(i.start, i.end) for i in intervals] == [(1, 9)] and through[2] == 0
    lower, upper = world.volume(where, 48)
    assert lower <= 512 - 36 * np.pi <= upper < 2 * lower
    surface = world.surface(where, 24)
    a, b, c = (surface.vertices[surface.faces[:, k]] for k in range(3))
    assert abs(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6 - (512 - 36 * np.pi)) < 12
    with pytest.raises(ValueError, match="axis"):
        world.on_lines(where, 16, "w")


def test_scenes_map_a_line_of_space():
    text = """{"findspace": 1, "shapes": {"room": {"box": {"min": [0, 0, 0], "max": [9, 9, 9]}},
        "crate": {"box": {"min": [0, 0, 0], "max": [2, 2, 2]}}}, "moving": "crate", "where": "inside(crate, room)"%s}"""
    scene = fs.Scene.json(text % ', "free": {"line": {"through": [1, 4, 4], "direction": [1, 0, 0]}}, "maximize": "x"')
    answer = again(scene.map())
    assert answer.found == "yes" and answer.best.value == 7 and answer.best.at.empty
    assert [(i.start, i.end) for i in answer.intervals] == [(6, 6)] and len(answer.possible) == 1
    assert [(i.start, i.end) for i in scene.asking(maximize="").map().intervals] == [(-1, 6)]


def test_pickled_scenes_and_answers_keep_their_limits():
    text = """{"findspace": 1, "shapes": {"a": {"box": {"min": [0, 0], "max": [1, 1]}}}, "moving": "a", "where": "true"}"""
    scene = again(fs.Scene.json(text).limited(seconds=50, threads=1, progress=lambda part: None))
    assert (scene.options.seconds, scene.options.threads) == (50, 1)
    assert again(scene.map()).found == "yes"
    kept = fs.Scene.json(text).map().__reduce_ex__(2)[2]
    assert kept[0].options.seconds == 0 and scene.map().__reduce_ex__(2)[2][0].options.seconds == 50


def test_scenes_map_positions_in_space():
    text = """{"findspace": 1, "shapes": {"room": {"box": {"min": [0, 0, 0], "max": [9, 9, 9]}},
        "crate": {"box": {"min": [0, 0, 0], "max": [2, 2, 2]}}}, "moving": "crate", "where": "inside(crate, room)"%s}"""
    scene = fs.Scene.json(text % "")
    answer = again(scene.map())
    region = again(answer.space_region)
    assert answer.found == "yes" and answer.region is None and answer.best is None
    assert region.volume == 343 and (7, 7, 7) in region and (7.1, 7, 7) not in region
    assert answer.json() == region.json and answer.file(".stl")[0].startswith("solid")
    opened = again(again(scene.map(apply="interior", surface=True)).space_region)
    assert opened.open and (7, 7, 7) not in opened and opened.question == {"apply": "interior", "minimize": "", "maximize": ""}
    assert list(opened.contains([[7, 7, 7], [6.5, 6, 6]])) == [False, True]
    best = scene.asking(maximize="x").map()
    top = again(best.space_region)
    assert best.best.value == 7 and top.volume == 0 and (7, 1, 1) in top and (6, 1, 1) not in top
    assert top.boxes == scene.world.solve_space("inside(crate, room)", maximize="x").boxes
    assert not answer.sampled and answer.on_lines is None
    lines = again(scene.map(lines=8, axis="x", side="inner"))
    assert lines.sampled and lines.space_region is None and lines.endings == [".json"]
    assert 0 < lines.on_lines.volume < 343 and len(lines.on_lines.lines) == 16
    assert scene.map(apart=1, axis="xyz").found == "yes"
    for wrong in ({"axis": "x"}, {"lines": 8, "axis": "w"}, {"lines": 8, "side": "left"}):
        with pytest.raises(ValueError):
            scene.map(**wrong)
    with pytest.raises(fs.Error, match="apply"):
        scene.map(apply="inner")
    with pytest.raises(fs.Error, match="objective"):
        scene.world.solve_space("inside(crate, room)", minimize="x", maximize="y")
    with pytest.raises(fs.Error, match="neither"):
        scene.world.solve_space("inside(crate, room)", minimize="gap(crate, room)")


def data_of(framed):
    """What the page in a frame is given to show."""
    text = html.unescape(re.fullmatch('<iframe srcdoc="(.*?)" sandbox=.*></iframe>', framed, re.S)[1])
    assert "__NONCE__" not in text and len(re.search('type="text/plain">(.*?)</script>', text, re.S)[1]) > 100_000
    return json.loads(re.search('<script id="data" type="application/json">(.*?)</script>', text, re.S)[1])


def test_solids_in_notebooks():
    shapes = {"room": fs.Shape.box((0, 0, 0), (9, 2, 9)), "crate": fs.Shape.box((0, 0, 0), (2, 2, 2)),
              "ball": fs.Shape.ball((0, 0, 0), 1)}
    world = fs.World(shapes, "crate", unit="mm")
    data = data_of(world.solve("inside(crate, room)")._repr_html_())
    assert data["map"]["drawing"]["sheets"] == [[[0, 0, 0], [7, 0, 0], [7, 0, 7], [0, 0, 7]]]
    assert data["at"] == [3.5, 0, 3.5] and data["summary"]["moving"] == ["crate"] and data["summary"]["unit"] == "mm"
    assert ["drawing" in s for s in data["summary"]["shapes"]] == [False, True, True]
    assert world.solve("inside(crate, room) and clear(crate, room)")._repr_html_() is None
    beside = world.solve("clear(crate, room, 1)")
    assert tuple(data_of(beside._repr_html_())["at"]) in beside
    half = data_of(world.solve("clear(crate, room)")._repr_html_())
    assert max(map(abs, half["at"])) < 100
    box = data_of(shapes["room"]._repr_html_())
    assert len(box["summary"]["shapes"][0]["drawing"]["vertices"]) == 8 and box["summary"]["moving"] == []
    assert data_of(shapes["room"].surface._repr_html_())["summary"]["shapes"][0]["name"] == "surface"
    assert shapes["ball"]._repr_html_() is None and fs.Shape.box((0, 0), (1, 1))._repr_html_() is None


def test_surfaces_both_ways():
    box = fs.Shape.box((0, 0, 0), (1, 2, 3))
    surface = box.surface
    assert surface.vertices.shape == (8, 3) and surface.faces.shape == (12, 3) and len(surface.polygons) == 6
    world = fs.World({"a": fs.shape(surface), "b": box}, moving="a")
    assert world.holds("inside(a, b)", (0, 0, 0)) and world.holds("covers(a, b)", (0, 0, 0))
    assert surface.text(".obj").startswith(b"#") or b"v 0 0 0" in surface.text(".obj")
    with pytest.raises(fs.Error):
        surface.text(".doc")
    assert ".glb" in fs.Surface.endings() and surface.lost == ""
    assert b"a box" in surface.text(".svg", name="a box")
    scene = fs.Scene.json(surface.scene_json("a box", "mm"))
    same = scene.shapes["a box"].surface
    assert scene.unit == "mm" and sorted(same.vertices.tolist()) == sorted(surface.vertices.tolist())
    assert same.faces.shape == (12, 3)
    with_sheet = (box | (fs.Shape.box((5, 0, 0), (6, 2, 3)) & fs.Shape.box((6, 0, 0), (7, 2, 3)))).surface
    assert "sheets" in again(with_sheet).lost and len(with_sheet.polygons) == 6
    with pytest.raises(fs.Error):
        fs.Shape.ball((0, 0, 0), 1).surface
    assert "<svg" in box._repr_svg_() and "<svg" in fs.Shape.ball((0, 0, 0), 1)._repr_svg_()


def test_geojson_keeps_its_side():
    ring = (fs.Shape.disc((0, 0), 2) - fs.Shape.disc((0, 0), 1)).region
    areas = {}
    for side in ("inside", "on_arcs", "outside"):
        made = json.loads(ring.geojson(1e-3, side))
        assert made["type"] == "Polygon" and len(made["coordinates"]) == 2
        areas[side] = fs.shape(made).region.area
    assert areas["inside"] < ring.area < areas["outside"] and areas["inside"] < areas["on_arcs"] < areas["outside"]
    mixed = fs.Shape.unite([fs.Shape.box((0, 0), (1, 1)), fs.Shape.points([[5, 5]]),
                            fs.Shape.polyline([[2, 0], [3, 0]])]).region
    kinds = [g["type"] for g in json.loads(mixed.geojson(1e-3))["geometries"]]
    assert sorted(kinds) == ["LineString", "Point", "Polygon"]
    assert fs.shape(mixed).region == mixed
    with pytest.raises(ValueError, match="side"):
        ring.geojson(1e-3, "left")


def test_collections_and_shapes_that_move_together():
    board = fs.Shape.collection({"U1": fs.Shape.box((0, 0), (1, 1)), "U2": fs.Shape.box((5, 0), (6, 1))})
    world = fs.World({"board": board, "chip": fs.Shape.box((0, 0), (1, 1)), "key": fs.Shape.box((0, 2), (1, 3))},
                     moving=["chip", "key"])
    value = world.distance("gap(chip, board)", (3, 0))
    assert value.value == 1 and value.features[1].part == "U2" and "part U2" in value.witness
    assert world.moving_together == ["chip", "key"]
    assert world.distance("gap(key, board)", (0, 1)).value == 2
    world.set("board", fs.Shape.box((0, 0), (1, 1)))
    assert world.distance("gap(chip, board)", (3, 0)).features[1].part == ""


def test_every_value_pickles(passing):
    same = again(passing.at_time("0.5"))
    assert same.distance("gap(cart, post)", (3, 0)).value == 1
    assert again(passing).distance("inf gap(cart, post)", (0, 3)).value == 1
    value = passing.distance("inf gap(cart, post)", (0, 3))
    assert (again(value).value, again(value).witness) == (value.value, value.witness)
    world = fs.World({"A": fs.Shape.disc((0, 0), 2), "B": fs.Shape.box((0, 0), (1, 1))}, moving="B")
    check = world.check("gap(B, A) >= 1 and reach(B, A) <= 9", (2, 1))
    assert [a.text for a in again(check).atoms] == [a.text for a in check.atoms] and bool(again(check)) == bool(check)
    best = world.minimize("x", "inside(B, A)")
    assert again(best).at == best.at and again(best).value == best.value
    part = world.solve("gap(B, A) <= 1").components[0]
    assert again(part).area == part.area
    assert (again(part.rings[0]).vertices == part.rings[0].vertices).all()
    assert again(part.rings[0].edges[0]).radius == part.rings[0].edges[0].radius
    phi = fs.Phi(fs.Shape.box((0, 0), (4, 2)), fs.Shape.disc((0, 0), 1))
    assert again(phi)((7, 1)).value == 2 and again(phi((5, 1))).state == "contact"
    rooms = fs.World({"room": fs.Shape.box((0, 0, 0), (9, 9, 9)), "crate": fs.Shape.box((0, 0, 0), (2, 2, 2))}, "crate")
    region = rooms.solve("inside(crate, room)")
    assert again(region).boxes == region.boxes and again(region.surface).polygons == region.surface.polygons
    assert "<svg" in region._repr_svg_()
    lines = rooms.on_lines("inside(crate, room)", 8)
    assert [t for t, _ in again(lines).lines] == [t for t, _ in lines.lines] and again(lines).bounds == lines.bounds
    poses = world.poses("inside(B, A)", 2)
    assert [s.region for s in again(poses).slices] == [s.region for s in poses.slices]
    assert again(passing.instants("gap(cart, post) <= 1", (0, 3))).certain[0].start == 0.5
    assert again(fs.Body("A", [0, "0.1"], 2)).count == 2


def test_placements_pickle():
    shapes = {"sheet": fs.Shape.box((0, 0), (30, 20)), "A": fs.Shape.disc((0, 0), 2), "B": fs.Shape.disc((0, 0), 3)}
    found = fs.place(shapes, ["A", "B"], each="inside(self, sheet)", pairs="gap(self, other) >= 0", minimize=["y", "x"])
    same = again(found)
    assert [(p.body, p.at, p.exact_at, p.degrees) for p in same.placed] == [
        (p.body, p.at, p.exact_at, p.degrees) for p in found.placed]
    assert any("sqrt" in c for p in same.placed for c in p.exact_at)
    assert same.positions == found.positions and same.json == found.json and same.svg == found.svg
    assert same.complete and same.unproven == "" and again(same).json == found.json
    box = fs.Shape.box((0, 0, 0), (2, 2, 2))
    found = fs.place({"room": fs.Shape.box((0, 0, 0), (9, 2, 9)), "A": box}, ["A"], each="inside(self, room)",
                     minimize=["x", "y", "z"])
    assert again(found).placed[0].at == found.placed[0].at and again(found).json == found.json


def test_every_class_pickles():
    assert str(again(fs.gap("A", "B").along((1, "0.1")))) == str(fs.gap("A", "B").along((1, "0.1")))
    classes = [value for name in fs.__all__ if isinstance(value := getattr(fs, name), type)]
    assert len(classes) > 30
    inner = [value for of in classes for value in vars(of).values() if isinstance(value, type)]
    for of in classes + inner:
        assert issubclass(of, Exception) or "__setstate__" in vars(of), of


def test_answers_pickle():
    scene = fs.Scene.json("""{"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0], "max": [9, 9]}},
        "B": {"disc": {"center": [0, 0], "radius": 1}}}, "moving": "B", "where": "inside(B, A)"}""")
    for answer in (scene.check((0, 5)), scene.check(np.array([3, 5])), scene.measure((1, "0.5"), words=["gap"]),
                   scene.map(apply="boundary"), scene.explain(), scene.explain((0, 0), degrees=90),
                   fs.Scene.json(PLACING).place(near=[("bar", (27, 9), None, 2)])):
        same = again(answer)
        assert (same.found, same.text(), same.json(), same.notes) == (
            answer.found, answer.text(), answer.json(), answer.notes)


def test_rotations_pickle():
    assert again(again(fs.Rotation("1,2,3:30"))).matrix == fs.Rotation("1,2,3:30").matrix
    scene = fs.Scene.json("""{"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0, 0], "max": [3, 5, 2]}},
        "B": {"box": {"min": [0, 0, 0], "max": [4, 2, 1]}}}, "moving": "B", "where": "inside(B, A)",
        "free": {"pose": {"angles": [0, {"axis": [1, 1, 1], "degrees": 120}, 30]}}}""")
    free = again(scene.free)
    assert free.kind == "pose" and [r.text for r in free.rotations] == [r.text for r in scene.free.rotations]
    for r in free.rotations:
        assert again(again(r)).matrix == r.matrix
        assert again(scene.rotated(again(r))).explain().text() == scene.rotated(r).explain().text()


def test_many_polygons_at_once():
    rings = np.array([[[0, 0], [k + 1, 0], [k + 0.1, k + 0.25]] for k in range(200)])
    made = fs.Shape.polygons(rings)
    assert [s.region.area for s in made] == [fs.Shape.polygon(r).region.area for r in rings]
    assert [s.region for s in fs.Shape.polygons(list(rings[:3]))] == [s.region for s in made[:3]]
    assert fs.Shape.polygons([]) == [] and len(fs.Shape.polygons(np.zeros((0, 4, 2)))) == 0
    with pytest.raises(fs.Error) as caught:
        fs.Shape.polygons([rings[0], [[0, 0], [4, 4], [4, 0], [0, 4]]])
    assert caught.value.place.startswith("polygon 1")
    with pytest.raises(ValueError, match="shape"):
        fs.Shape.polygons(np.zeros((2, 4, 3)))


def test_errors_pickle():
    with pytest.raises(fs.Error) as caught:
        fs.Shape.polygon([[0, 0], [4, 4], [4, 0], [0, 4]])
    error = again(caught.value)
    assert type(error) is type(caught.value) and str(error) == str(caught.value)
    assert (error.code, error.message, error.place, error.geometry) == (
        caught.value.code, caught.value.message, caught.value.place, caught.value.geometry)


def test_adjusted_phi_has_the_gradient_of_its_values():
    bent = fs.Shape.polygon([[0, 0], [6, 0], [6, 1], [1, 1], [1, 5], [0, 5]])
    tower = fs.Shape.unite([fs.Shape.box((0, 0, 0), (3, 1, 1)), fs.Shape.box((0, 0, 0), (1, 1, 4))])
    rng = np.random.default_rng(5)
    for a, b in ((bent, fs.Shape.polygon([[0, 0], [2, 0], [0, 1]])), (bent, fs.Shape.disc((0, 0), 1)),
                 (tower, fs.Shape.box((0, 0, 0), (1, 1, 1))), (tower, fs.Shape.ball((0, 0, 0), 1))):
        phi = fs.Phi(a, b).at_least("0.75")
        at = rng.random((150, a.dimension)) * 14 - 4
        values, gradients = phi.evaluate(at)
        for k in range(a.dimension):
            step = np.zeros(a.dimension)
            step[k] = 1e-6
            slope = (phi.evaluate(at + step)[0] - phi.evaluate(at - step)[0]) / 2e-6
            assert np.mean(np.abs(slope - gradients[:, k]) < 1e-4) > 0.97
        assert [float(phi(p)) for p in at[:9].tolist()] == values[:9].tolist()


def test_adjusted_phi():
    phi = fs.Phi(fs.Shape.box((0, 0), (4, 2)), fs.Shape.box((0, 0), (1, 1)))
    least, greatest = phi.at_least(5), phi.at_most("4.5")
    assert (least((7, 6)).value, least((7, 6)).sign, least((7, 6)).gradient) == (0, 0, [0.6, 0.8])
    assert least((7, "6.0000001")).sign == 1
    assert float(greatest((7, 6))) == -0.5 and greatest((0, 0)).sign == 1
    values, gradients = greatest.evaluate([[7, 6], [2, 7]])
    assert values.tolist() == [-0.5, -0.5] and gradients.tolist() == [[-0.6, -0.8], [0, -1]]
    same = again(greatest)
    assert (same.limit, same.distance, same((7, 6)).value) == ("greatest", "4.5", -0.5)
    assert again(least((7, 6))).gradient == [0.6, 0.8] and again(phi((7, 6))).normalised_gradient == [0.6, 0.8]
    with pytest.raises(fs.Error):
        phi.at_least(-1)


def test_limits_of_input_have_a_code():
    with pytest.raises(fs.Error) as caught:
        fs.Shape.json(json.dumps({"union": [{"disc": {"center": [0, 0], "radius": "-1"}}]}))
    assert caught.value.code in ("bad value", "syntax")


def test_shapes_are_described():
    scene = fs.Scene.json('{"findspace": 1, "unit": "mm", "shapes": {"box": {"box": {"min": [0, 0, 0], "max": [9, 2, 2]}}, '
                          '"ball": {"ball": {"center": [0, 0, 0], "radius": 2}}}}')
    box = scene.describe("box")
    assert box.found == "yes" and "volume  36 mm³" in box.text() and ".obj" in box.endings
    assert pickle.loads(pickle.dumps(box)).json() == box.json()
    lines = scene.describe("ball", lines=4, axis="x")
    assert lines.sampled and len(lines.on_lines.lines) == 12 and scene.describe("ball", surface=True).sampled
    flat = fs.Scene.json('{"findspace": 1, "shapes": {"a": {"disc": {"center": [0, 0], "radius": 2}}}}')
    assert flat.describe("a").region[0] == flat.shape("a").region
    flat.require((3, 4))
    with pytest.raises(fs.Error):
        flat.require((3, 4, 5))


def test_results_are_kept(tmp_path):
    def solved():
        return fs.World({"A": fs.Shape.box((0, 0), (9, 9)), "B": fs.Shape.disc((0, 0), 1)}, "B").solve("inside(B, A)")
    store = pickle.loads(pickle.dumps(fs.ResultStore(str(tmp_path / "kept"), limit=1 << 20)))
    assert store.limit == 1 << 20 and "kept" in repr(store)
    alone = solved()
    with store:
        assert solved() == alone
    assert any(path.suffix == ".sqlite" for path in (tmp_path / "kept").iterdir())
    other = fs.ResultStore(str(tmp_path / "other"))
    for one in (store, other):
        one.__enter__()
    for one in (store, other):
        one.__exit__(None, None, None)
        with pytest.raises(RuntimeError, match="not open"):
            one.__exit__(None, None, None)


PLATE = ('{"findspace": 1, "shapes": {"plate": {"polygon": [[2, 2], [12, 2], [12, 10], [2, 10]], "holes": [[[5, 4], [7, 4], [7, 6], [5, 6]]]},'
         '"table": {"box": {"min": [0, 0], "max": [20, 12]}}, "peg": {"box": {"min": [-1, -1], "max": [1, 1]}}},'
         '"moving": "peg", "where": "inside(peg, table) and clear(peg, plate)"}')


def test_prepared_scenes_answer_as_before():
    plain = fs.Scene.json(PLATE)
    scene = plain.prepared()
    assert (plain.is_prepared, scene.is_prepared) == (False, True)
    plain.options.seconds = 5
    assert plain.options.seconds == 0
    for at in ((6, 5), (6.25, 5), (40, 0.125)):
        assert scene.check(at).json() == plain.check(at).json()
        assert scene.nearest(at).json() == plain.nearest(at).json()
    assert scene.map().region[0] == plain.map().region[0]
    assert scene.check((6.3, 5.2), snap=1).at == (6, 5)
    assert scene.check((6.3, 5.2), nearest=False).nearest is None
    again = pickle.loads(pickle.dumps(scene.rotated(90).asking(moving=["peg"])))
    assert again.is_prepared and again.check((6, 5)).found == "yes"
    assert pickle.loads(pickle.dumps(scene.check((6.3, 5.2), snap=1))).at == (6, 5)


def test_scenes_are_edited_and_range_over_something_else():
    scene = fs.Scene.json(PLATE)
    assert (scene.asks, scene.used, scene.grid, scene.y_down, scene.board) == (True, ["peg", "plate", "table"], "0.000001", False, None)
    assert not scene.clockwise
    other = scene.asking("clear(peg, plate)", moving=["peg"])
    assert fs.Scene.json(other.edited_text()).where.text == "clear(peg, plate)"
    angles = scene.asking(free="angle").map((6, 5)).intervals
    assert [(a.start, a.end) for a in angles] == [(0, 0), (90, 90), (180, 180), (270, 270)]
    with pytest.raises(ValueError):
        scene.asking(free="anything")
    value = scene.between((2, 2), (5, 5), at=(16, 8)).measured[0].value
    assert (value.value, [f.kind for f in value.features]) == (13**0.5, ["vertex", "edge"])


def test_regions_and_solids_show_themselves():
    region = fs.Scene.json(PLATE).map().region[0]
    assert (region.snapped((6.3, 5.2), 1), region.snapped((6.3, 5.2), "0.1"), region.some()) == ([6, 5], None, [6, 5])
    paths = region.paths(region.extent)
    assert paths["points"] == [[6, -5]] and paths["closed"] and not paths["open"]
    slot = fs.World({"room": fs.Shape.box((0, 0, 0), (9, 4, 3)), "crate": fs.Shape.box((0, 0, 0), (2, 4, 1))}, "crate").solve("inside(crate, room)")
    sheets, curves, points = slot.thin((0, 0, 0), (9, 9, 9))
    assert (len(sheets), len(sheets[0]), curves, points) == (1, 4, [], [])
    ball = fs.Shape.ball((0, 0, 0), 2)
    assert (len(ball.drawn_surface(0).faces), len(ball.drawn_surface(16).faces) > 20) == (0, True)
