# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""The questions that claims.py asks: for each of the support table a function of the class of shapes that gives the
arguments and the scenes. IN_PLANE and IN_SPACE hold them by group and question."""


# --- shapes ----------------------------------------------------------------------------------------------------------

def octahedron(r):
    return {"polytope": [[r, 0, 0], [-r, 0, 0], [0, r, 0], [0, -r, 0], [0, 0, r], [0, 0, -r]]}


def cube(r):
    return {"box": {"min": [-r] * 3, "max": [r] * 3}}


def ball(x, y, z, r):
    return {"ball": {"center": [x, y, z], "radius": r}}


BOARD = {"polygon": [[-5, -4], [5, -5], [4, 5], [0, 1], [-5, 4]]}
CHIP = {"polygon": [[0, 0], [1, 0], [0.9, 1.1], [0, 1]]}
PLANE = {"polygons": BOARD, "arcs": {"offset": 1, "of": BOARD},
         "chains and points": [{"polyline": [[-5, -4], [5, -5], [4, 5], [0, 1]]}, {"points": [[2, 2]]}],
         "complements": {"complement": BOARD}}
STEPS = {"union": [{"box": {"min": [-5, -5, -5], "max": [5, 5, 0]}}, {"box": {"min": [-5, -5, 0], "max": [0, 5, 5]}}]}
SPACE = {"boxes": (STEPS, cube(1)), "convex": (octahedron(8), octahedron(1)),
         "round convex": ({"offset": 2, "of": octahedron(5)}, ball(0, 0, 0, 1)),
         "flat faces": ({"prism": {"polygon": [[-6, -6], [6, -5], [5, 0], [0, 1], [-1, 6], [-6, 5]], "z": [-4, 4]}},
                        octahedron(1)),
         "height field": ({"height_field": {"heights": [[4, 3, 5, 4], [3, 4, 2, 4], [5, 4, None, 3], [5, 4, 3, 3]], "at": [-6, -6],
                                            "step": [4, 4], "floor": -4}}, octahedron(1)),
         "round": ({"union": [ball(-3, 0, 0, 4), {"offset": 1, "of": octahedron(4)}]}, octahedron(1)),
         "cut": ({"difference": [cube(6), {"interior": ball(6, 6, 6, 5)}]}, octahedron(1)),
         "complements": ({"complement": octahedron(8)}, octahedron(1))}
# Other shapes of a class, which answer all that it does.
ALSO = {"flat faces": ["height field"]}
# Positions of the small shape: apart from the other, overlapping it, inside it, not inside it.
FAR, NEAR = "20,20", "1,-3"
PLANE_AT = {"apart": {"complements": NEAR, None: FAR},
            "overlapping": {"chains and points": "4,0", "complements": "4,-3", None: NEAR}}
SPACE_AT = {"apart": {"complements": "0.3,0.2,0.1", "cut": "9,8,6.5", None: "9,8,7"},
            "overlapping": {"boxes": "-2,-2,-2", "complements": "6.6,0.2,0.1", "flat faces": "-3,-3,0", "height field": "-3,-3,0", "cut": "-2,-2,-2",
                            None: "0.3,0.2,0.1"},
            "inside": {"boxes": "-2,-2,-2", "complements": "20,19,18", "flat faces": "-3,-3,0", "height field": "-3,-3,0", "cut": "-2,-2,-2", "round": "-3,0.2,0.1",
                       None: "0.3,0.2,0.1"},
            "outside": {"complements": "0.3,0.2,0.1", None: "9,8,7"}}


def at(places, kind, shapes):
    return places[kind].get(shapes, places[kind][None])


def scene(shapes, **more):
    a, b = (PLANE[shapes], CHIP) if shapes in PLANE and "space" not in more else SPACE[shapes]
    more.pop("space", None)
    return {"findspace": 1, "shapes": {"A": a, "B": b}, "moving": "B", "where": "true", **more}


# --- questions: each gives (arguments, scene) for a class of shapes ------------------------------------------------------

def check2(kind, *formulas):
    return lambda shapes: [(["check", "-", "--at", at(PLANE_AT, kind, shapes)], scene(shapes, where=f)) for f in formulas]


def map2(*formulas, **more):
    return lambda shapes: [(["map", "-"], scene(shapes, where=f, **more)) for f in formulas]


def check3(kind, *formulas):
    return lambda shapes: [(["check", "-", "--at", at(SPACE_AT, kind, shapes)], scene(shapes, where=f, space=1))
                           for f in formulas]


def orientation3(formula):
    return lambda shapes: [(["check", "-", "--at", at(SPACE_AT, "apart", shapes), "--orientation", turn],
                            scene(shapes, where=formula, space=1)) for turn in ("1,1,1:120", "1,2,3,4", "x:30")]


def map3(*formulas, lines=0, **more):
    extra = ["--resolution", str(lines)] if lines else []
    return lambda shapes: [(["map", "-", *extra], scene(shapes, where=f, space=1, **more)) for f in formulas]


ROOM = {"box": {"min": [-9, -9], "max": [9, 9]}}
# Two shapes a class on both sides of the room: as near as to one as to the other is what lies on a line.
SIDES = {"polygons": [{"box": {"min": [s * 12 - 1, -40], "max": [s * 12 + 1, 40]}} for s in (-1, 1)],
         "arcs": [{"disc": {"center": [s * 9, 0], "radius": 3}} for s in (-1, 1)],
         "chains and points": [{"points": [[s * 9, 1]]} for s in (-1, 1)],
         "complements": [{"complement": {"box": {"min": [-30 - s * 70, -100], "max": [30 - s * 70, 100]}}} for s in (-1, 1)]}
SMALL = {"arcs": {"disc": {"center": [0, 0], "radius": 1}}, "chains and points": {"points": [[0, 0]]}}


def sums2(verb, *formulas, at=None, **more):
    """A and another shape of two corners, C, in a room R."""
    other = {"polygon": [[8, 6], [10, 6], [9, 9], [8, 8]]}
    place = ["--at", at] if at else []

    def ask(shapes):
        fixed = {"A": PLANE[shapes], "B": CHIP, "C": other, "R": ROOM}
        return [([verb, "-", *place], {"findspace": 1, "shapes": fixed, "moving": "B", "where": f, **more}) for f in formulas]
    return ask


def bisectors2(*formulas):
    def ask(shapes):
        a, c = SIDES[shapes]
        fixed = {"A": a, "C": c, "B": SMALL.get(shapes, CHIP), "R": ROOM}
        return [(["map", "-"], {"findspace": 1, "shapes": fixed, "moving": "B", "where": f}) for f in formulas]
    return ask


def place2(names, method, pairs="clear(self, other)"):
    def ask(shapes):
        room = {"box": {"min": [-12, -12], "max": [12, 12]}}
        place = {"shapes": names, "each": "clear(self, A) and inside(self, R)", "pairs": pairs, "method": method}
        return [(["place", "-"], {"findspace": 1, "shapes": {"A": PLANE[shapes], "R": room, **{n: CHIP for n in names}},
                                  "place": place})]
    return ask


def place3(method):
    def ask(shapes):
        a, b = SPACE[shapes]
        place = {"shapes": ["B", "C"], "each": "clear(self, A) and inside(self, R)", "pairs": "clear(self, other)",
                 "minimize": ["z", "y", "x"], "method": method}
        if method == "simultaneous":
            del place["minimize"]
        return [(["place", "-", *(["--resolution", "8"] if method == "sequential" else [])],
                 {"findspace": 1, "shapes": {"A": a, "B": b, "C": b, "R": cube(12)}, "place": place})]
    return ask


def both(*asks):
    return lambda shapes: [one for ask in asks for one in ask(shapes)]


SHIFT = {"time": [0, 1], "B": {"path": [[0, 0], [2, 1]]}}
SPIN = {"time": [0, 1], "B": {"path": [[0, 0], [2, 1]], "angles": [0, 20]}}
DOOR = {"time": [0, 1], "B": {"path": [[0, 0], [0, 0]], "angles": [0, 60]}}
LINE2 = {"line": {"through": [0, 0], "direction": [1, 2]}}
LINE3 = {"line": {"through": [0, 0, 0], "direction": [1, 2, 3]}}

IN_PLANE = {
    "Values and truth at a position": {
        "gap, distance, apart": check2("apart", "gap(B, A) > 0", "distance(B, A) > 0"),
        "gap, depth, overlapping": check2("overlapping", "gap(B, A) < 0", "depth(B, A) > 0"),
        "margin, cover": check2("apart", "margin(B, A) <= 1", "delta1(B, A) <= 1"),
        "reach, eta2, delta2": check2("apart", "reach(B, A) >= 1", "eta2(B, A) >= 1", "delta2(B, A) >= 1"),
        "protrusion, hausdorff, h": check2("apart", "mu(B, A) <= 1", "mu(A, B) <= 1", "hausdorff(B, A) <= 1", "h(B, A) <= 1"),
        "truth of a formula": check2("overlapping", "gap(B, A) >= 0.5 and not inside(B, A) or mu(B, A) <= 3"),
        "nearest feasible position": check2("overlapping", "gap(B, A) >= 0.5"),
    },
    "Regions": {
        "whole region, every distance and level": map2("gap(B, A) >= 0.5", "gap(B, A) = -0.25", "margin(B, A) >= 0.125",
                                                       "mu(B, A) <= 1", "reach(B, A) <= 9"),
        "positions on a line": map2("gap(B, A) >= 0.5", free=LINE2),
        "along a direction, every level": map2("gap(B, A, along=(1, 2)) >= 1", "gap(B, A, toward=(1, 0)) >= 0"),
    },
    "Sums of distances, and distances compared": {
        "truth at a position": sums2("check", "gap(B, A) <= gap(B, C)", "gap(B, A) + 2 * gap(B, C) <= 25", at="6,5"),
        "region, where both sides are equal on lines and circles": bisectors2(
            "gap(B, A) <= gap(B, C) and inside(B, R)", "distance(B, A) < distance(B, C) and inside(B, R)"),
        "region, other curves": sums2("map", "gap(B, A) + 2 * gap(B, C) <= 25 and inside(B, R)"),
        "least value": sums2("map", "inside(B, R) and clear(B, C)", minimize="gap(B, A) + 2 * gap(B, C)"),
    },
    "Least values (-> min, minimize, maximize)": {
        "reach, eta2, delta2": map2("reach(B, A) -> min", "eta2(B, A) -> min"),
        "other distances": map2("gamma1(B, A) -> min", "mu(B, A) -> min"),
        "along a direction": map2("gamma1(B, A, along=(1, 2)) -> min"),
        "coordinates, distance to": both(map2("clear(B, A)", minimize="distance to [1, 2]"),
                                         map2("touches(B, A)", minimize="y")),
    },
    "Rotation": {
        'angles at which a formula holds ("free": "angle")': map2("clear(B, A)", free="angle", about=[0, 1]),
        "least values over angles": map2("gamma1(B, A) -> min", free="angle", about=[0, 1]),
        "rotating: check, angles about the same point": check2("apart", "gap(B, A, rotating=(1, 1)) >= 10"),
        "rotating: elsewhere, level 0": map2("gap(B, A, rotating=(1, 1)) >= 0"),
        "rotating: elsewhere, other levels": map2("gap(B, A, rotating=(1, 1)) >= 10"),
        "poses: each angle, rotated vertices on the grid": map2("clear(B, A)", free="pose", angles=2),
        "poses: between two angles": map2("clear(B, A)", free="pose", angles=2),
    },
    "Motion": {
        "translation: region, truth, instants": both(map2("inf gap(B, A) >= 1", motion=SHIFT),
                                                     map2("gap(B, A) >= 1", motion=SHIFT, free="time")),
        "translation: values over time, -> min": map2("inf gamma1(B, A) -> min", motion=SHIFT),
        "rotation in time: region, instants": both(map2("inf gap(B, A) >= 1", motion=SPIN),
                                                   map2("gap(B, A) >= 1", motion=SPIN, free="time")),
        "rotation in time: values, truth": lambda s: [(["check", "-", "--at", at(PLANE_AT, "apart", s)],
                                                       scene(s, where="inf gap(B, A) >= 1", motion=SPIN))],
        "door leaf: instants, truth": map2("gap(B, A) >= 0.5", motion=DOOR, free="time"),
    },
    "Placement": {
        "one after another": place2(["B", "C"], "sequential"),
        "all at once: two shapes, or pairs that form no ring": place2(["B", "C"], "simultaneous"),
        "all at once: pairs that form a ring": place2(["B", "C", "D"], "simultaneous"),
    },
}


def along_lines(shapes):
    """Into a round shape the margin along a direction is enclosed; the gap is exact."""
    formulas = ["gap(B, A, along=(0, 0, 1)) >= 1"] + ["eta1(B, A, along=(0, 0, 1)) <= 1"] * (shapes == "round")
    return map3(*formulas, lines=3)(shapes)


def exact_map(shapes):
    """Of a cut shape a formula whose lines are quick."""
    return map3("margin(B, A) >= 0" if shapes == "cut" else "gap(B, A) >= 0")(shapes)


def with_capsule(formula):
    """A capsule in the round shape: with an octahedron the search ends at its limit."""
    def ask_lines(shapes):
        asked = map3(formula, lines=3)(shapes)
        if shapes == "round":
            asked[0][1]["shapes"]["B"] = {"hull": [ball(-1, 0, 0, 0.5), ball(1, 0.5, 0, 0.5)]}
        return asked
    return ask_lines


def least3(formula):
    """Of a cut shape on few lines."""
    return lambda shapes: map3(formula, lines=3 * (shapes == "cut"))(shapes)


def least_fit(formula):
    """As the round pair a ball and a solid of flat faces: unions of round parts take minutes."""
    def ask_least(shapes):
        asked = least3(formula)(shapes)
        if shapes == "round":
            asked[0][1]["shapes"] = {"A": STEPS, "B": ball(0, 0, 0, 1)}
        return asked
    return ask_least


def values_along(shapes):
    formulas = ["gap(B, A, along=(1, 0, 0)) >= 1"] + ["reach(B, A, along=(1, 1, 0)) >= 1"]
    formulas += ["margin(B, A, along=(1, 0, 0)) >= 1"] * (shapes == "round")
    return check3("apart", *formulas)(shapes)


def other_lines(shapes):
    other = "reach(B, A, along=(1, 1, 0)) <= 9" if shapes == "cut" else "gap(B, A, along=(1, 1, 0)) <= -0.5"
    return map3("gap(B, A, along=(1, 1, 0)) >= 1", other, lines=3)(shapes)


def nearest3(shapes):
    """Where the feasible positions are one convex polytope, and elsewhere."""
    convex = shapes in ("convex", "round convex")
    where = "gap(B, A) <= -0.5" if convex else "touches(B, A)" if shapes == "boxes" else "gap(B, A) >= 0.5"
    return check3("outside" if convex else "overlapping", where)(shapes)

IN_SPACE = {
    "Values at a position": {
        "gap, distance, apart": check3("apart", "gap(B, A) > 0.25", "distance(B, A) > 0.25"),
        "gap, depth, overlapping": check3("overlapping", "gap(B, A) < -0.125", "depth(B, A) > 0.125"),
        "margin, cover from 0 up": check3("inside", "margin(B, A) > 0.125"),
        "margin, cover below 0": check3("outside", "margin(B, A) < -0.125"),
        "reach": check3("apart", "reach(B, A) >= 1"),
        "eta2, delta2": check3("inside", "eta2(B, A) >= 0.125"),
        "protrusion, hausdorff, h": check3("inside", "mu(B, A) <= 1"),
        "diameter": check3("apart", "diameter(B, A) <= 100"),
        "along a direction, every distance": values_along,
    },
    "Truth at a position": {
        "where the value is exact": check3("apart", "reach(B, A) >= 1 and not reach(B, A) < 1"),
        "where it is enclosed": lambda shapes: check3("outside", ("gap" if shapes == "cut" else "mu") + "(B, A) <= 1")(shapes),
        "nearest feasible position": nearest3,
    },
    "Exact maps": {
        "formulas of commands": exact_map,
    },
    "Maps on lines": {
        "gap at levels from 0 up": map3("gap(B, A) >= 0.5", lines=3),
        "gap below 0": map3("gap(B, A) >= -0.5", lines=3),
        "margin, cover from 0 up": with_capsule("margin(B, A) >= 0.5"),
        "margin, cover below 0": map3("margin(B, A) >= -0.5", lines=3),
        "eta2, delta2": map3("eta2(B, A) <= 9", lines=3),
        "reach": map3("reach(B, A) <= 20", lines=3),
        "protrusion up to 0": with_capsule("mu(B, A) <= -0.5"),
        "protrusion above 0, h": map3("mu(B, A) <= 0.5", lines=3),
        "hausdorff": map3("hausdorff(B, A) <= 12", lines=3),
        "along a direction, lines that way": along_lines,
        "along a direction, other lines": other_lines,
        'a line of any direction ("free": {"line": ..})': map3("gap(B, A) >= 0.5", free=LINE3),
    },
    "Least values (-> min)": {
        "distance, depth, dstar": least3("distance(B, A) -> min"),
        "reach, eta2, delta2": least3("reach(B, A) -> min"),
        "gap, eta1, delta1": least_fit("gamma1(B, A) -> min"),
        "protrusion, where B fits": least_fit("mu(B, A) -> min"),
        "hausdorff": least3("hausdorff(B, A) -> min"),
        "gap, eta1, delta1 along a direction": map3("gamma1(B, A, along=(1, 0, 0)) -> min", "eta1(B, A, along=(1, 0, 0)) -> min"),
    },
    "Rotation, motion, placement": {
        "orientations: check at one": orientation3("reach(B, A) >= 1"),
        "rotating, free over angles or time; motion": both(
            map3("clear(B, A)", motion={"time": [0, 1], "B": {"path": [[0, 0, 0], [2, 1, 0]]}}),
            map3("clear(B, A)", free="angle"),
            map3("gap(B, A, rotating=(0, 0)) >= 0")),
        "placement one after another": place3("sequential"),
        "placement all at once": place3("simultaneous"),
    },
}
