# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""The Python module as a user has it."""
import ast
import doctest
import importlib.util
import json
import os
import pathlib
import pickle
import random
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import findspace as fs


@pytest.fixture
def world():
    hole = np.array([[40, 25], [60, 25], [60, 35], [40, 35]])
    plate = fs.Shape.polygon(np.array([[25, 12], [75, 12], [75, 48], [25, 48]]), holes=[hole])
    return fs.World({"plate": plate, "peg": fs.Shape.box((-6, -4), (6, 4)), "table": fs.Shape.box((0, 0), (100, 60))},
                    moving="peg")


def test_the_lines_of_the_manual_run(world):
    region = world.solve("inside(peg, table) and clear(peg, plate)")
    assert region == world.solve(fs.inside("peg", "table") & fs.clear("peg", "plate"))
    query = world.query("clear(peg, plate, 0.5)")
    ok = query.holds(np.random.rand(100_000, 2) * 100)
    assert ok.dtype == bool and ok.shape == (100_000,)
    assert len(region.components[0].rings[0].vertices) >= 4


def test_sums_of_distances_against_numpy():
    """B is a point, so the distances to a box and a disc are two lines of numpy."""
    world = fs.World({"A": fs.Shape.box((-5, 0), (-1, 2)), "C": fs.Shape.disc((4, -1), 1.5),
                      "P": fs.Shape.points([(-3, 0)]), "Q": fs.Shape.points([(3, 0)]),
                      "W": fs.Shape.box((-12, -12), (12, 12)), "B": fs.Shape.points([(0, 0)])}, moving="B")
    at = np.random.default_rng(3).uniform(-11.9, 11.9, (2000, 2))
    beyond = np.abs(at - (-3, 1)) - (2, 1)
    to_a = np.linalg.norm(np.maximum(beyond, 0), axis=1) + np.minimum(beyond.max(axis=1), 0)
    to_c = np.linalg.norm(at - (4, -1), axis=1) - 1.5
    inner, outer = world.solve_bounds("gap(B, A) + 2 * gap(B, C) <= 14 and inside(B, W)")
    excess = to_a + 2 * to_c - 14
    assert not inner.contains(at)[excess > 1e-7].any() and outer.contains(at)[excess < -1e-7].all()
    assert (inner.contains(at) == outer.contains(at))[np.abs(excess) > 0.5].all() and inner.contains(at).any()
    to_p, to_q = (np.linalg.norm(at - (x, 0), axis=1) for x in (-3, 3))
    for formula, excess in (("gap(B, P) <= gap(B, Q)", to_p - to_q), ("2 * gap(B, P) <= gap(B, Q)", 2 * to_p - to_q)):
        found = world.solve(f"{formula} and inside(B, W)").contains(at)
        clear = np.abs(excess) > 1e-7
        assert (found == (excess <= 0))[clear].all() and found.any()
    with pytest.raises(fs.Error):
        world.solve("gap(B, A) + 2 * gap(B, C) <= 14 and inside(B, W)")


def test_many_positions_agree_with_single_ones(world):
    formula = fs.inside("peg", "table", 1) & ~(fs.gap("peg", "plate") < 0.5) & (fs.reach("peg", "plate") <= 70)
    query = world.query(formula)
    rng = np.random.default_rng(5)
    at = np.concatenate([rng.random((400, 2)) * [100, 60], np.round(rng.random((400, 2)) * [100, 60])])
    assert query.holds(at).tolist() == [world.holds(formula, p) for p in at.tolist()]
    assert query.region.contains(at).tolist() == query.holds(at).tolist()


def test_the_peg_that_fits_once(world):
    # 12 x 8 in a hole of 20 x 10; then in one of 12 x 8.
    assert world.solve("inside(peg, plate)").empty is False
    hole = fs.Shape.box((0, 0), (100, 60)) - fs.Shape.interior(fs.Shape.box((44, 26), (56, 34)))
    tight = fs.World({"plate": hole, "peg": fs.Shape.box((-6, -4), (6, 4))}, "peg")
    region = tight.solve("clear(peg, plate)") & fs.Shape.box((30, 20), (70, 40)).region
    assert region.area == 0 and region.components[0].dimension == 0
    assert region.components[0].points.tolist() == [[50, 30]]
    assert (50, 30) in region and (50, "30.000001") not in region


def test_shapes_from_arrays_are_exact():
    ring = np.array([[0.1, 0.2], [0.3, 0.2], [0.3, 0.7]])
    assert fs.Shape.polygon(ring).rounded_points == 0
    assert fs.Shape.polygon(ring.astype(np.float32)).rounded_points > 0
    assert fs.Shape.polygon(ring[:, ::-1].copy()[:, ::-1]).region == fs.Shape.polygon(ring).region
    with pytest.raises(ValueError, match=r"shape \(n, 2\)"):
        fs.Shape.polygon(np.zeros((4, 3)))


def test_errors_have_a_place():
    with pytest.raises(fs.Error) as caught:
        fs.Shape.polygon([[0, 0], [1, np.nan], [1, 1]])
    assert caught.value.place == "ring, vertex 1" and caught.value.code == "bad value"
    with pytest.raises(fs.Error, match="did you mean"):
        fs.Distance("gapp", "a", "b")
    with pytest.raises(TypeError, match="&"):
        bool(fs.clear("a", "b") and fs.clear("a", "b"))


def test_words_of_boards():
    world = fs.World({"A": fs.Shape.box((-4, -3), (4, 3)), "B": fs.Shape.box((-1, -1), (1, 1))}, moving="B")
    holds = lambda formula: world.holds(formula, (0, 5))
    assert holds(fs.near("B", "A", 1) & fs.far("B", "A", 1) & fs.keepout("B", "A") & fs.keepout("B", "A", 1))
    assert not holds(fs.near("B", "A", "0.9")) and not holds(fs.far("B", "A", "1.1")) and not holds(fs.keepout("B", "A", "1.1"))
    assert holds(fs.group("B", "A", "10.2957")) and not holds(fs.group("B", "A", "10.2956"))


def test_everything_pickles(world):
    region = world.solve("gap(peg, plate) <= 3 and not overlaps(peg, plate)")
    assert pickle.loads(pickle.dumps(region)) == region
    disc = fs.Shape.disc((0.5, 0), 2) - fs.Shape.disc((0, 0), 1)
    assert pickle.loads(pickle.dumps(disc)).region == disc.region
    formula = fs.gap("a", "b") >= "2 mm"
    assert pickle.loads(pickle.dumps(formula)).text == formula.text
    again = pickle.loads(pickle.dumps(world))
    assert again.solve("clear(peg, plate)") == world.solve("clear(peg, plate)")
    at = np.random.rand(1000, 2) * 100
    query = world.query("clear(peg, plate, 0.5)")
    assert (pickle.loads(pickle.dumps(query)).holds(at) == query.holds(at)).all()


def test_shapely_both_ways():
    shapely = pytest.importorskip("shapely.geometry")
    polygon = shapely.Polygon([(0, 0), (9, 0), (9, 5), (0, 5)], [[(1, 1), (1, 4), (4, 4), (4, 1)]])
    shape = fs.shape(polygon)
    assert shape.region.area == polygon.area
    assert shape.region.to_shapely().equals(polygon)
    assert fs.shape(shape.region).region == shape.region
    disc = fs.Shape.disc((0, 0), 1).region.to_shapely(1e-6)
    assert abs(disc.area - np.pi) < 1e-5
    with pytest.raises(ValueError, match="Circle"):
        fs.shape({"type": "Circle", "coordinates": []})


def test_flattening_stays_on_its_side():
    ring = (fs.Shape.disc((0, 0), 2) - fs.Shape.disc((0, 0), 1)).region
    for side, sign in (("inside", -1), ("outside", 1)):
        outer, inner = ring.flattened(1e-3, side)
        assert sign * (fs.Shape.polygon(outer, [inner]).region.area - ring.area) > 0
    outer, _ = ring.flattened(1e-3, "on_arcs")
    assert np.allclose(np.hypot(*outer.T), 2, rtol=0, atol=1e-9)
    with pytest.raises(ValueError, match="on_arcs"):
        ring.flattened(1e-3, "left")


def test_pictures(world, tmp_path):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    region = world.solve("inside(peg, table) and clear(peg, plate)")
    figure, ax = plt.subplots()
    assert region.plot(ax) is ax
    assert ax.get_xlim()[1] > 90
    figure.savefig(tmp_path / "region.png")
    assert region._repr_svg_().startswith("<")
    assert world.solve("clear(peg, plate)")._repr_svg_() is None
    with pytest.raises(ValueError, match="unbounded"):
        world.solve("clear(peg, plate)").plot(ax)


def test_solids():
    box = fs.Shape.box((0, 0, 0), (1, 2, 3))
    assert box.dimension == 3
    vertices = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
    assert fs.Shape.mesh(vertices, faces).dimension == 3
    with pytest.raises(fs.Error):
        fs.Shape.mesh(vertices, faces[:3])
    assert fs.Shape.mesh(vertices, faces.tolist()).dimension == 3
    with pytest.raises(TypeError, match="whole numbers"):
        fs.Shape.mesh(vertices, faces + 0.5)
    with pytest.raises(ValueError, match="too large"):
        fs.Shape.mesh(vertices, faces + 2**32)


def test_height_field():
    heights = np.array([[1, 1, 1], [1, 2, np.nan], [1, 1, 1]])
    with pytest.raises(fs.Error, match="row 1, column 2"):
        fs.Shape.height_field(heights, (5, 5), 0)
    ground = fs.Shape.height_field(heights, (5, 5), 0, at=(-5, -5), missing=float("nan"))
    assert len(ground.surface.vertices) == 12
    world = fs.World({"ground": ground, "ball": fs.Shape.ball((0, 0, 5), 1)}, "ball")
    assert world.distance("gap(ball, ground)", (0, 0, 0)).value == 2
    assert fs.Shape.json(ground.exact_json).surface.vertices.shape == (12, 3)
    with pytest.raises(ValueError, match="shape"):
        fs.Shape.height_field([1, 2, 3], (1, 1), 0)
    with pytest.raises(fs.Error, match="2 columns and 2 rows"):
        fs.Shape.height_field([[1], [1]], (1, 1), 0)


def test_contours():
    half = [(-1, 0), {"to": (1, 0), "center": (0, 0), "ccw": False}]
    assert fs.Shape.contour(half).region.area == pytest.approx(np.pi / 2)
    with pytest.raises(ValueError, match='"bulge" or "center", not both'):
        fs.Shape.contour([(-1, 0), {"to": (1, 0), "bulge": 1, "center": (0, 0)}])
    with pytest.raises(ValueError, match='no "centre"'):
        fs.Shape.contour([(-1, 0), {"to": (1, 0), "bulge": 1, "centre": (0, 0)}])
    with pytest.raises(ValueError, match='no "ccw"'):
        fs.Shape.contour([(-1, 0), {"to": (1, 0), "bulge": 1, "ccw": True}])


def test_an_atom_of_what_fits_nowhere_has_the_value_of_its_distance(world):
    cover, delta = world.check("cover(peg, table) >= 1 or delta1(peg, table) <= 1", (0, 0)).atoms
    assert cover.distance.value == world.distance("cover(peg, table)", (0, 0)).value == -np.inf
    assert delta.distance.value is None


def test_values_of_many_positions(world):
    at = np.random.default_rng(2).random((500, 2)) * 100
    query = world.query("gap(peg, plate)")
    assert query.values(at).tolist() == [world.distance("gap(peg, plate)", p).value for p in at.tolist()]
    assert world.query(fs.margin("peg", "table")).values([[50, 30]]).tolist() == [26]
    with pytest.raises(fs.Error, match="distance"):
        query.holds(at)
    value = world.distance(fs.gap("peg", "plate"), (90, 60))
    assert value.exact and value.lower <= value.value <= value.upper and value.closed_form == "sqrt(145)"
    assert "of plate" in value.witness and float(value) == value.value


def test_worlds_change(world):
    before = world.query("clear(peg, plate)")
    world.move("plate", (0, 30))
    assert not before.holds([[50, 13]])[0] and world.query("clear(peg, plate)").holds([[50, 13]])[0]
    world.set("disc", fs.Shape.disc((10, 10), 5))
    assert world.distance("gap(peg, disc)", (30, 10)).value == 9
    world.remove("disc")
    assert sorted(world.shapes) == ["peg", "plate", "table"]


def test_what_a_world_gives_away_is_a_copy(world):
    for name, shape in world.shapes.items():
        world.set(name, shape.translated((1, 0)))
    assert world.shape("peg").bounds == (-5, -4, 7, 4) and world.shape("table").bounds == (1, 0, 101, 60)
    query = world.query("clear(peg, plate)")
    query.world.move("plate", (30, 0))
    assert query.world.shape("plate").bounds == (26, 12, 76, 48) and not query.holds([[30, 30]])[0]
    world.options.seconds = 5
    assert world.options.seconds == 0


def test_a_world_changes_while_it_is_asked(world):
    def change():
        for x in (1, -1) * 200:
            world.move("plate", (x, 0))
    changes = threading.Thread(target=change)
    changes.start()
    while changes.is_alive():
        assert not world.solve("inside(peg, table) and clear(peg, plate)").empty
    changes.join()
    assert world.shape("plate").bounds == (25, 12, 75, 48)


def test_limits_and_progress(world):
    with pytest.raises(fs.Stopped) as caught:
        world.limited(seconds=1e-9).solve("clear(peg, plate)")
    assert caught.value.limit == "time" and isinstance(caught.value, fs.Error)
    seen = []
    world.limited(threads=1, progress=seen.append).query("gap(peg, plate)").values(np.zeros((1000, 2)))
    assert seen == sorted(seen) and seen[-1] == 1
    def fail(part):
        raise KeyError(part)
    with pytest.raises(KeyError):
        world.limited(progress=fail).query("gap(peg, plate)").values(np.zeros((1000, 2)))


def test_a_token_ends_questions(world):
    token = fs.Cancel()
    limited = world.limited(cancel=token)
    timer = threading.Timer(0.2, token.request)
    timer.start()
    begun = time.monotonic()
    with pytest.raises(fs.Stopped) as caught:
        limited.query("gap(peg, plate)").values(np.random.default_rng(2).random((2_000_000, 2)) * 100)
    assert caught.value.limit == "cancelled" and time.monotonic() - begun < 5 and token.requested
    with pytest.raises(fs.Stopped):
        fs.place(world.shapes, ["peg"], cancel=token)
    square = fs.PackPart("square", [(0, 0), (1, 0), (1, 1), (0, 1)], count=9)
    assert fs.pack(fs.PackProblem([square], height=4), seconds=60, cancel=token).met == "cancelled"
    token.reset()
    assert limited.holds("clear(peg, plate)", (90, 50))


def test_work_of_searches_is_raised():
    bowl = fs.Shape.ball((0, 0, 0), 5) - fs.Shape.ball((0, 0, 2), 3)
    world = fs.World({"A": bowl, "B": fs.Shape.box((0, 0, 0), (2, 2, 2))}, "B")
    few = world.limited(work_limit=1000)
    assert (few.options.work_limit, pickle.loads(pickle.dumps(few.options)).work_limit) == (1000, 1000)
    widths = [v.upper - v.lower for v in (w.distance("protrusion(A, B)", (1, 1, 1)) for w in (few, few.limited(threads=1), world))]
    assert widths[0] > 0.1 and widths[1] > 0.1 and widths[2] < 1e-6


def test_options(world):
    options = fs.Options(threads=1, seconds=5, progress=print, seed=7)
    again = pickle.loads(pickle.dumps(options))
    assert (again.threads, again.seconds, again.seed, again.progress) == (1, 5, 7, print)
    assert world.limited(options).options.seconds == 5 and world.options.seconds == 0
    token, options.cancel = options.cancel, fs.Cancel()
    token.request()
    assert not options.cancel.requested
    with pytest.raises(TypeError):
        world.limited(options, seconds=3)
    with pytest.raises(TypeError):
        world.limited(hours=3)
    ring = (fs.Shape.disc((0, 0), 2) - fs.Shape.disc((0, 0), 1)).region
    assert (ring.sample(50, options) == ring.sample(50, seed=7)).all()
    assert (ring.sample(50) != ring.sample(50, seed=7)).any() and ring.contains(ring.sample(50)).all()


def test_scenes_answer():
    scene = fs.Scene.json("""{"findspace": 1, "shapes": {"room": {"box": {"min": [0, 0, 0], "max": [9, 9, 2]}},
        "plank": {"box": {"min": [0, 0, 0], "max": [1, 1, 8]}}}, "moving": "plank", "where": "inside(plank, room)",
        "free": "pose", "angles": [{"axis": "y", "degrees": 90}]}""")
    assert (scene.dimension, scene.names, scene.moving, scene.unit, scene.name) == (3, ["room", "plank"], ["plank"], "", "scene")
    assert scene.free.kind == "pose" and scene.free.about == ["0", "0", "0"]
    answer = scene.rotated(scene.free.rotations[0]).check((1, 0, 1))
    assert answer and answer.found == "yes" and answer.check.holds and answer.nearest is None and "<svg" in answer.file(".svg")[0]
    other = scene.rotated(scene.free.rotations[0]).asking(where="gap(plank, room) > 3")
    again = pickle.loads(pickle.dumps(other))
    assert not other.check((1, 0, 1)) and not again.check((1, 0, 1)) and again.where.text == other.where.text
    assert again.check((1, 0, 20)).text() == other.check((1, 0, 20)).text()
    distances = again.measure((1, 0, 1), words=["gap"]).measured
    assert [d.text for d in distances] == ["gap(plank, room)"] and distances[0].value.value == -1
    with pytest.raises(fs.Stopped):
        cancel = fs.Cancel()
        cancel.request()
        scene.limited(cancel=cancel).check((1, 0, 1))
    with pytest.raises(fs.Error, match="did you mean 'gap'"):
        scene.measure(words=["gpa"])


def test_scenes_and_explanations():
    folder = pathlib.Path(__file__).resolve().parents[2] / "examples"
    scene = fs.Scene.file(str(folder / "peg.json"))
    assert scene.world.moving == "peg" and scene.notes == [] and scene.minimize == ""
    region = scene.world.solve(scene.where)
    assert (50, 30) in region and region.components[-1].dimension == 0
    again = pickle.loads(pickle.dumps(scene))
    assert again.world.solve(again.where) == region
    with pytest.raises(fs.Error, match="peg.json|no.json"):
        fs.Scene.file("no.json")
    found = scene.world.explain("inside(peg, table) and gap(peg, plate) >= 20", (50, 30))
    assert not found.feasible and len(found.conflict) == 2 and found.change == ["gap(peg, plate) >= 20"]
    assert found.relax[0].kind == "to" and found.relax[0].lower <= found.relax[0].to <= found.relax[0].upper
    assert "in the way" in str(found) and json.loads(found.json)["feasible"] is False and not found.here.holds
    same = pickle.loads(pickle.dumps(found))
    solid = fs.World({"a": fs.Shape.ball((0, 0, 0), 1), "b": fs.Shape.ball((0, 0, 0), 2)}, "a")
    clash = solid.explain("inside(a, b) and gap(a, b) >= 1", (5, 0, 0))
    assert not clash.feasible and len(clash.conflict) == 2 and len(clash.together.at) == 3 and clash.relax[0].refused == ""
    assert same.text == found.text and same.relax[0].at == found.relax[0].at and same.together.upper == found.together.upper


def test_sign_maps(world):
    signs = world.sign_map(fs.gap("peg", "plate"), "0.5")
    at = np.random.default_rng(3).random((2000, 2)) * 100
    found = signs.signs(at)
    assert found.dtype == np.int8 and set(found) == {-1, 1}
    assert ((found >= 0) == world.query("gap(peg, plate) >= 0.5").holds(at)).all()
    assert signs.where(zero=True, positive=True) == world.solve("gap(peg, plate) >= 0.5")
    assert signs.where(zero=True).contains([[81.5, 30]])[0] and signs.sign(("81.5", 30)) == 0
    again = pickle.loads(pickle.dumps(signs))
    assert (again.signs(at) == found).all() and (again.distance, again.level) == (signs.distance, "0.5")
    with pytest.raises(fs.Error):
        world.sign_map("x", 2)


def test_ctrl_c_ends_a_question(world):
    at = np.random.default_rng(2).random((2_000_000, 2)) * 100
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    begun = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        world.query("gap(peg, plate)").values(at)
    assert time.monotonic() - begun < 5
    assert world.query("gap(peg, plate)").values(at[:5]).shape == (5,)


def test_worlds_of_space():
    world = fs.World({"room": fs.Shape.box((0, 0, 0), (10, 10, 10)), "ball": fs.Shape.ball((5, 5, 5), 1),
                      "crate": fs.Shape.box((-1, -1, -1), (1, 1, 1))}, moving="crate")
    at = np.array([[5, 5, 9], [5, 5, 8.5], [1, 1, 1]])
    query = world.query("inside(crate, room) and clear(crate, ball, 2)")
    assert query.holds(at).tolist() == [True, False, True]
    assert (pickle.loads(pickle.dumps(query)).holds(at) == query.holds(at)).all()
    assert world.query("gap(crate, ball)").values(at)[:2].tolist() == [2, 1.5]
    check = world.check("clear(crate, ball, 2)", (5, 5, 8))
    assert not check and check.atoms[0].lacks == 1
    intervals, exact = world.on_line("inside(crate, room) and disjoint(crate, ball)", (5, 5, 0), (0, 0, 1))
    assert exact and str(intervals) == "[[1.0, 3.0), (7.0, 9.0]]"
    assert world.query("inside(crate, room)").nearest((0, 5, 12))[0] == (1, 5, 9)
    assert world.query("inside(crate, room, 6)").nearest((0, 5, 12)) is None
    with pytest.raises(fs.Error, match="do not decide"):
        world.query("clear(crate, room, 1) or gap(crate, room) = 0.5").nearest((0, 5, 5))
    with pytest.raises(ValueError, match=r"\(n, 3\)"):
        query.holds(np.zeros((3, 2)))


def test_regions_of_space():
    world = fs.World({"room": fs.Shape.box((0, 0, 0), (10, 10, 10)), "crate": fs.Shape.box((-1, -1, -1), (1, 1, 1))},
                     moving="crate")
    region = world.solve("inside(crate, room, 1)")
    assert region.volume == 216 and region.bounds == ([2, 2, 2], [8, 8, 8])
    assert region.vertices.shape == (8, 3) and sorted(map(len, region.faces)) == [4] * 6
    assert region.contains(np.array([[2, 2, 2], [1.9, 2, 2]])).tolist() == [True, False]
    assert region.boxes == [([2, 2, 2], [8, 8, 8], [True] * 3, [True] * 3)]


def test_solids_pickle():
    solid = fs.Shape.box((0, 0, 0), (4, 4, 4)) - fs.Shape.ball((2, 2, 2), 1.5)
    world = fs.World({"a": solid, "b": fs.Shape.box((0, 0, 0), (1, 1, 1))}, moving="b")
    again = pickle.loads(pickle.dumps(world))
    at = np.random.default_rng(1).random((50, 3)) * 8 - 2
    assert (again.query("overlaps(a, b)").holds(at) == world.query("overlaps(a, b)").holds(at)).all()


def test_rotation():
    world = fs.World({"A": fs.Shape.points([[0, 4]]), "B": fs.Shape.polyline([[0, 0], [5, 0]])}, moving="B")
    angles = world.angles("gap(B, A) <= 0", (0, 0))
    assert [(i.start, i.end) for i in angles] == [(90, 90)]
    assert world.check_rotated("touches(B, A)", (0, 0), 90)


def test_phi_has_the_gradient_of_its_values():
    phi = fs.Phi(fs.Shape.polygon([[0, 0], [4, 0], [1, 3]]), fs.Shape.box((0, 0), (1, 2)))
    at = np.random.default_rng(4).random((200, 2)) * 16 - 6
    values, gradients = phi.evaluate(at)
    h = 1e-6
    for k in range(2):
        step = np.zeros(2)
        step[k] = h
        slope = (phi.evaluate(at + step)[0] - phi.evaluate(at - step)[0]) / (2 * h)
        assert np.mean(np.abs(slope - gradients[:, k]) < 1e-3) > 0.98
    assert [float(phi(p)) for p in at[:9].tolist()] == values[:9].tolist()


def test_phi_of_arcs_that_bound_no_disc_goes_by_curves():
    half = fs.Shape.subtract([fs.Shape.disc((0, 0), 2), fs.Shape.box((-3, -3), (3, 0))])
    phi = fs.Phi(half, fs.Shape.box((0, 0), (1, 1)))
    assert phi.form == "curves" and fs.Phi(phi.b, phi.b).form == "parts"
    assert (phi((-0.5, 3)).value, phi((-0.5, 0)).value, phi((-0.5, 2)).state) == (1, -1, "contact")


def test_stubs_are_those_of_the_module():
    folder = pathlib.Path(__file__).parents[1]
    spec = importlib.util.spec_from_file_location("make_stubs", folder / "make_stubs.py")
    made = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(made)
    text = made.stub(fs._findspace)
    assert text == (folder / "findspace" / "_findspace.pyi").read_text(), "write it anew: python/make_stubs.py"
    ast.parse(text)


def test_every_public_name_is_described():
    bare = []
    for name in fs.__all__:
        value = getattr(fs, name)
        members = [(name, value)] + ([(f"{name}.{k}", v) for k, v in vars(value).items() if not k.startswith("_")]
                                     if isinstance(value, type) else [])
        for place, member in members:
            text = getattr(member, "__doc__", None) or ""
            told = [line for line in text.splitlines() if line.strip() and "->" not in line and "Overloaded" not in line]
            if not told:
                bare.append(place)
    assert bare == []


@pytest.mark.parametrize("module", [fs, fs._findspace, fs._shapely])
def test_examples_in_docstrings(module):
    names = {name: getattr(module, name) for name in dir(module)}
    runner, finder = doctest.DocTestRunner(), doctest.DocTestFinder(exclude_empty=True)
    for test in finder.find(module, module.__name__, globs={**names, "fs": fs}):
        runner.run(test)
    assert runner.summarize(verbose=False).failed == 0


def test_limits_that_are_no_limits(world):
    for words in ({"seconds": -1}, {"seconds": float("nan")}, {"work": -1}, {"work": float("nan")}):
        with pytest.raises(fs.Error, match="from 0 on"):
            world.limited(**words).solve("true")
        with pytest.raises(fs.Error, match="from 0 on"):
            fs.pack(fs.PackProblem([fs.PackPart("a", [(0, 0), (1, 0), (0, 1)])], height=3), **words)
    with pytest.raises(TypeError, match="progress"):
        fs.Options(progress=5)
    with pytest.raises(fs.Error):
        fs.Scene.file("")


def test_mistakes_name_what_is_meant():
    scene = fs.Scene.json("""{"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0], "max": [9, 9]}},
        "B": {"disc": {"center": [0, 0], "radius": 1}}}, "moving": "B", "where": "gap(B, A) >= 1"}""")
    with pytest.raises(fs.Error, match="apply: inside is none of interior, closure"):
        scene.map(apply="inside")
    with pytest.raises(fs.Error, match="1 shape at least, not 0"):
        fs.Shape.intersect([])


def test_more_threads_than_cores_are_quiet():
    asked = "import findspace as fs; print(fs.Shape.box((0, 0), (9, 9)).region.sample(9, threads=64).shape)"
    done = subprocess.run([sys.executable, "-c", asked], capture_output=True, text=True)
    assert done.stdout == "(9, 2)\n" and done.stderr == ""
