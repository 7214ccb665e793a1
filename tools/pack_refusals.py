# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Wrong and empty problems of nesting, for pack_random.py: what `findspace pack` says of each."""

SQUARE = {"type": "simple_polygon", "data": [[0, 0], [2, 0], [2, 2], [0, 2]]}
PLATE = {"id": "plate", "width": 4, "height": 4}


def item(**changes):
    return {"id": "a", "demand": 1, "shape": SQUARE, **changes}


def on_plate(**changes):
    return {"items": [item()], "sheets": [{**PLATE, **changes}]}


CROSSED = {"type": "simple_polygon", "data": [[0, 0], [2, 2], [2, 0], [0, 2]]}
AWAY = {"type": "simple_polygon", "data": [[1, 0], [4, 0], [4, 4], [1, 4]]}
REFUSALS = [  # problem, exit status, words of the message or the answer
    ({"items": [], "strip_height": 4}, 0, "no parts to pack"),
    ({"items": [item(demand=0)], "strip_height": 4}, 0, "no parts to pack"),
    ({"items": [item()], "sheets": [{"id": "small", "width": 1, "height": 9}]}, 1, "no part fits a sheet"),
    ({"containers": [{"id": "small", "size-x": 1, "size-y": 9, "size-z": 9}], "where": "gap(self, other) >= 1",
      "item-types": [{"id": "a", "demand": 1, "shape": {"box": {"min": [0, 0, 0], "max": [2, 2, 2]}}}]}, 1, "no part fits a container"),
    ({"container": {"size-x": 4, "size-y": 4}, "item-types": [{"id": "a", "demand": 1, "shape": {"disc": {"center": [0, 0], "radius": 1}}}]},
     3, "this is a shape of the plane: item 'a' needs one of space"),
    ({"items": [item()]}, 3, "'strip_height' is missing"),
    ({"findspace": 1, "shapes": {}}, 3, "this is a scene"),
    ({"strip_height": 4}, 3, "'items' is missing"),
    ({"items": [item()], "strip_height": 1}, 3,
     "part 'a' is higher than the strip: 2 at its lowest allowed angle, and the strip has 1 between its edges"),
    ({"items": [item()], "strip_height": 1.9999999}, 3,
     "part 'a' is higher than the strip: 2 at its lowest allowed angle, and the strip has 1.9999999 between its edges"),
    ({"items": [item()], "strip_height": 0}, 3, "no height"),
    ({"items": [item()], "strip_height": 4, "sheets": [PLATE]}, 3, "a problem has one of 'strip_height', 'sheets' and 'box'"),
    ({"items": [item()], "strip_height": 4, "box": True}, 3, "a problem has one of 'strip_height', 'sheets' and 'box'"),
    (on_plate(count=0), 3, "every sheet has a count of 0"),
    ({"items": [item(demand=-1)], "strip_height": 4}, 3, "whole number"),
    ({"items": [item(demand=1.5)], "strip_height": 4}, 3, "whole number"),
    ({"items": [item(value=-1)], "strip_height": 4}, 3, "a value below 0"),
    ({"items": [item(value="1/0")], "strip_height": 4}, 3, ":1:"),  # the place of what is no number
    ({"items": [item(value="x")], "strip_height": 4}, 3, ":1:"),
    ({"items": [item(mirrored=1)], "strip_height": 4}, 3, "true or false"),
    ({"items": [item(mirored=True)], "strip_height": 4}, 3, "unknown key 'mirored', did you mean 'mirrored'?"),
    ({"items": [item()], "strip_hight": 4}, 3, "unknown key 'strip_hight', did you mean 'strip_height'?"),
    (on_plate(zones=[{"shape": SQUARE, "only": [], "keep_out": []}, {"shape": SQUARE, "keep_out": ["a"]}]), 3,
     "unknown key 'keep_out'"),
    ({"items": [item(shape={"type": "polygon", "data": {"outer": SQUARE["data"], "iner": []}})], "strip_height": 4}, 0, "length 2"),
    ({"items": [item(shape={"type": "polygon", "data": {"outer": SQUARE["data"], "iner": [SQUARE["data"]]}})], "strip_height": 4},
     3, "unknown key 'iner', did you mean 'inner'?"),
    (on_plate(shape={**SQUARE, "date": 1}), 3, "unknown key 'date'"),
    ({"items": [item(tilt=-1)], "strip_height": 4}, 3, "a tilt is from 0 to 180 degrees"),
    ({"items": [item(tilt=181)], "strip_height": 4}, 3, "a tilt is from 0 to 180 degrees"),
    ({"items": [item(tilts=1)], "strip_height": 4}, 3, "unknown key 'tilts', did you mean 'tilt'?"),
    ({"items": [item(allowed_orientations=90)], "strip_height": 4}, 3, "list"),
    ({"items": [item(allowed_orientations=None)], "strip_height": 4}, 0, "length 2"),
    ({"items": [item(shape={**SQUARE, "data": [["1/3", 0], [2, 0], [2, 2]]})], "strip_height": 4}, 3, "part 'a': 1/3 is not a decimal"),
    ({"items": [item(shape=CROSSED)], "strip_height": 4}, 3,
     "an outline meets itself: its edges from (0, 0) and from (2, 0)"),
    ({"items": [item(shape={"type": "circle", "data": []})], "strip_height": 4}, 3, "\"type\" is simple_polygon or polygon"),
    (on_plate(width=-4), 3, "above 0"),
    (on_plate(shape=AWAY), 3, "begins at (0, 0)"),
    (on_plate(shape={"disc": {"center": [3, 2], "radius": 2}}), 3, "begins at (0, 0)"),
    (on_plate(shape={"ball": {"center": [3, 2, 0], "radius": 2}}), 3, "sheet 'plate' needs one of the plane"),
    (on_plate(shape={"complement": {"disc": {"center": [0, 0], "radius": 2}}}), 3, "it is unbounded"),
    (on_plate(zones=[{"shape": {"disc": {"center": [3, 2], "radius": 2}}, "only": []}]), 3, "beyond its sheet"),
    (on_plate(zones=[{"shape": SQUARE}]), 3, "one of 'keeps_out', 'only' and 'holds'"),
    (on_plate(zones=[{"shape": SQUARE, "only": ["b"]}]), 3, "no part 'b'"),
    (on_plate(zones=[{"shape": {"type": "simple_polygon", "data": [[0, 0], [9, 0], [0, 9]]}, "only": []}]), 3, "beyond its sheet"),
    ({"items": [item()], "sheets": [{**PLATE, "cost": 1}, {**PLATE, "id": "other"}]}, 3, "some sheets have a cost"),
    ({"items": [item()], "strip_height": 4, "gaps": [{"between": ["a"], "gap": 1}]}, 3, "between two parts"),
    ({"items": [item()], "strip_height": 4, "gaps": [{"between": ["a", "a"], "gap": -1}]}, 3, "a gap below 0"),
    ({"items": [item()], "strip_height": 4, "where": "gap(self, a) < 1"}, 3, "'where'"),
    ({"items": [item()], "strip_height": 4, "where": 1}, 3, "a formula is meant"),
    ({"items": [item()], "strip_height": 4, "pairs": [{"between": ["a"], "where": "true"}]}, 3, "between two parts"),
    ({"items": [item()], "strip_height": 4, "pairs": [{"between": ["a", "b"], "where": "true"}]}, 3, "no part 'b'"),
    ({"items": [item(demand=2)], "strip_height": 4, "where": "gap(self, other) < -1"}, 4, "no layout was found"),
    ({"items": [item()], "strip_height": 4, "groups": [{"parts": ["a"]}]}, 3, "a group needs 'within' here"),
    ({"items": [item()], "strip_height": 4, "groups": [{"parts": ["a"], "within": -1}]}, 3, "below 0"),
    ({"items": [item()], "strip_height": 4, "fixed": [{"part": "a", "at": [0, 3]}]}, 3, "outside"),
    ({"items": [item(demand=0)], "strip_height": 4, "fixed": [{"part": "a", "at": [0, 0]}]}, 3, "more copies"),
    ({"items": [item(demand=2)], "strip_height": 4, "fixed": [{"part": "a", "at": [0, 0]}, {"part": "a", "at": [1, 1]}]}, 3,
     "a#1 and a#2 overlap"),
    ({"items": [item()], "strip_height": 4, "fixed": [{"part": "a", "at": [0, 0], "sheet": "plate"}]}, 3, "there are no sheets"),
    ({**on_plate(), "fixed": [{"part": "a", "at": [0, 0], "sheet": "plate", "number": 2}]}, 3, "number 2"),
    ({**on_plate(shape={"disc": {"center": [2, 2], "radius": 2}}), "fixed": [{"part": "a", "at": [0, 0], "sheet": "plate"}]}, 3,
     "a#1 is outside the sheet or its edge"),
    ({"items": [item()], "box": True, "fixed": [{"part": "a", "at": [0, 0]}]}, 3, "strip or on sheets"),
]
