# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""One call of each kind, for valgrind: what the module does to memory that the interpreter owns, and to its own.

usage: PYTHONMALLOC=malloc PYTHONPATH=build/release/python valgrind --error-exitcode=9 /usr/bin/python3 python/tests/memory_walk.py
"""
import gc
import pickle

import numpy as np

import findspace as fs


def plane():
    plate = fs.Shape.polygon(np.array([[25, 12], [75, 12], [75, 48], [25, 48]]),
                             holes=[[[40, 25], [60, 25], [60, 35], [40, 35]]])
    world = fs.World({"plate": plate, "peg": fs.Shape.box((-6, -4), (6, 4)), "table": fs.Shape.box((0, 0), (100, 60))},
                     moving="peg")
    region = world.solve("inside(peg, table) and clear(peg, plate)")
    assert pickle.loads(pickle.dumps(region)) == region and region.components[0].rings[0].edges
    assert region.svg and region.geojson(0.1)
    world.query("clear(peg, plate, 0.5)").holds(np.random.rand(500, 2) * 100)
    world.query("gap(peg, plate)").values(np.random.rand(20, 2) * 100)
    world.poses("clear(peg, plate)", [0, 10])
    for name, shape in world.shapes.items():
        world.set(name, shape.translated((1, 0)))
    return world


def mistakes(world):
    for wrong in (lambda: fs.Shape.polygon([[0, 0], [4, 4], [4, 0], [0, 4]]), lambda: world.solve("gap(peg, x) > 1"),
                  lambda: fs.Shape.json("{")):
        try:
            wrong()
        except fs.Error as error:
            assert error.message
        else:
            raise AssertionError("no error")
    try:
        world.limited(progress=lambda part: 1 / 0).query("gap(peg, plate)").values(np.zeros((200, 2)))
    except ZeroDivisionError:
        pass


def plans():
    shapes = {"sheet": fs.Shape.box((0, 0), (30, 20)), "a": fs.Shape.box((0, 0), (8, 3)), "b": fs.Shape.disc((0, 0), 2)}
    found = fs.place(shapes, [fs.Body("a", [0, 90], 2), "b"], each="inside(self, sheet)", pairs="clear(self, other)",
                     minimize=["y", "x"])
    assert found.complete and found.svg and found.json and found.positions
    world = fs.World({"cart": fs.Shape.disc((0, 0), 1), "post": fs.Shape.disc((0, 0), 1)}, "cart")
    world = pickle.loads(pickle.dumps(world.in_motion({"post": [(0, (-5, 0)), (1, (5, 0))]})))
    assert world.instants("gap(cart, post) <= 1", (0, 3)).exact
    world.solve("inf gap(cart, post) >= 0")


def space():
    world = fs.World({"room": fs.Shape.box((0, 0, 0), (9, 9, 9)), "ball": fs.Shape.ball((0, 0, 0), 1)}, "ball")
    world.on_lines("inside(ball, room)", 6)
    world.volume("inside(ball, room)", 6)
    assert len(world.surface("inside(ball, room)", 6).faces)
    fs.shape(fs.Shape.box((0, 0, 0), (1, 2, 3)).surface)
    fs.Phi(fs.Shape.box((0, 0), (4, 2)), fs.Shape.disc((0, 0), 1)).evaluate(np.random.rand(30, 2) * 9)


def searches():
    options = pickle.loads(pickle.dumps(fs.Options(threads=1, seed=3, progress=print, cancel=fs.Cancel())))
    assert options.progress is print and len(fs.Shape.disc((0, 0), 2).region.sample(20, seed=options.seed)) == 20
    scene = fs.Scene.json('{"findspace": 1, "shapes": {"a": {"box": {"min": [0, 0], "max": [9, 9]}}, "b": {"disc": '
                          '{"center": [0, 0], "radius": 1}}}, "moving": "b", "where": "margin(b, a) >= 5"}')
    found = pickle.loads(pickle.dumps(scene.world.explain(scene.where, (3, 3))))
    assert not found.feasible and found.relax and found.text
    turned = pickle.loads(pickle.dumps(scene.world.explain_poses("margin(b, a) >= 5", [0, 45])))
    assert turned.relax[0].angle == 0 and turned.together.angle is not None
    signs = scene.world.sign_map("margin(b, a)", 1)
    assert signs.signs([[4, 4]])[0] == 1 and signs.where(positive=True).area
    brick = fs.PackSolid("brick", fs.Shape.box((0, 0, 0), (2, 1, 1)), count=2, orientations="upright")
    for problem in (fs.SolidPackProblem([brick], floor=(2, 2)),
                    fs.PackProblem([fs.PackPart("disc", fs.Shape.disc((0, 0), 1), count=2)], height=2)):
        told = []
        layout = pickle.loads(pickle.dumps(fs.pack(problem, work=0.01, threads=1, better=told.append)))
        assert told and layout.faults(problem) == [] and layout._repr_svg_()


if __name__ == "__main__":
    mistakes(plane())
    plans()
    space()
    searches()
    gc.collect()
