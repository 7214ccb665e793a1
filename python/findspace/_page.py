# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Solids in notebooks: the page of `findspace view`, as one that stands alone, within a frame."""
import functools
import html
import json
import pathlib

from ._findspace import Error, Surface

_FOLDER = pathlib.Path(__file__).parent / "page"


@functools.lru_cache(maxsize=None)
def _text(name):
    return (_FOLDER / name).read_text(encoding="utf-8")


def _drawing(surface):
    """As docs/protocol.md has a drawing of space."""
    return {"vertices": surface.vertices.tolist(), "faces": surface.polygons, "sheets": [], "curves": [], "points": []}


def _shape(name, shape, moving=False):
    """Without a drawing where the boundary has other faces than flat ones."""
    out = {"name": name, "moving": moving, "used": True}
    try:
        out["drawing"] = _drawing(shape if isinstance(shape, Surface) else shape.surface)
    except Error as e:
        if e.code != "unsupported":
            raise
    return out


def _within(box, other):
    return all(other[0][k] <= box[0][k] and box[1][k] <= other[1][k] for k in range(3))


def _corners(box):
    """Of a flat box: one point, two ends, or four corners in order around it."""
    low, high = list(box[0]), list(box[1])
    wide = [k for k in range(3) if low[k] < high[k]]
    turns = {0: [()], 1: [(), (0,)], 2: [(), (0,), (0, 1), (1,)]}[len(wide)]
    return [[high[k] if k in [wide[t] for t in turn] else low[k] for k in range(3)] for turn in turns]


def _cut_off(boxes, shapes):
    """Boxes with their infinite ends at a window: twice as large as all that is drawn."""
    corners = [v for s in shapes for v in s.get("drawing", {"vertices": []})["vertices"]]
    corners += [end for box in boxes for end in box[:2]]
    known = [[v[k] for v in corners if abs(v[k]) != float("inf")] or [0] for k in range(3)]
    size = max(max(v) - min(v) for v in known) or 1
    low, high = [min(v) - size for v in known], [max(v) + size for v in known]
    return [([max(a, b) for a, b in zip(box[0], low)], [min(a, b) for a, b in zip(box[1], high)]) for box in boxes]


def _region(region, shapes):
    """Its surface, and the sheets, curves and points that are not part of it; and a position of it, or None."""
    out = _drawing(region.surface)
    boxes = _cut_off(region.boxes, shapes)
    solid = [b for b in boxes if all(b[0][k] < b[1][k] for k in range(3))]
    for box in boxes:
        if any(_within(box, s) for s in solid):
            continue
        corners = _corners(box)
        kind = {1: "points", 2: "curves", 4: "sheets"}[len(corners)]
        out[kind].extend(corners if kind == "points" else [corners])
    if boxes:
        largest = max(boxes, key=lambda b: [sorted(b[1][k] - b[0][k] for k in range(3))])
        return out, [(a + b) / 2 for a, b in zip(*largest)]
    corners = out["vertices"]
    return out, [sum(v[k] for v in corners) / len(corners) for k in range(3)] if corners else None


def _outside(corners, region):
    """A position of what a polytope leaves: beside it, farther and farther."""
    least, greatest = min(corners), max(corners)
    size = max(abs(v) for corner in corners for v in corner) or 1
    at = list(greatest)
    while at not in region:
        at[0] += size / 8 + (greatest[0] - least[0]) / 8
    return at


def page(summary, drawing=None, at=None):
    """One HTML file that needs nothing else."""
    data = {"summary": {"dimension": 3, "step": 0, "y": "up", "words": [], "free": "position", "place": False, **summary},
            "map": {"drawing": drawing}, "at": at or [0, 0, 0]}
    parts = {'<script id="data" type="application/json">null':
             '<script id="data" type="application/json">' + json.dumps(data).replace("<", "\\u003c"),
             '<script id="space-program" type="text/plain">': '<script id="space-program" type="text/plain">' + _text("space.js")}
    out = _text("page.html").replace(' nonce="__NONCE__"', "").replace("__TOKEN__", "").replace("__KIND__", "scene")
    for mark, with_what in parts.items():
        if out.count(mark) != 1:
            raise RuntimeError(f"{_FOLDER / 'page.html'} has no place for {mark}")
        out = out.replace(mark, with_what)
    return out


def _framed(text):
    return (f'<iframe srcdoc="{html.escape(text)}" sandbox="allow-scripts allow-downloads" '
            'style="width: 100%; height: 480px; border: 0"></iframe>')


def page_of_shape(self):
    """For notebooks; None for a shape of the plane, and where the boundary has other faces than flat ones."""
    if self.dimension == 2:
        return None
    shown = _shape("shape", self)
    return _framed(page({"where": "", "moving": [], "shapes": [shown]})) if "drawing" in shown else None


def page_of_surface(self):
    """For notebooks; None where it is empty."""
    return _framed(page({"where": "", "moving": [], "shapes": [_shape("surface", self)]})) if len(self.vertices) else None


def page_of_layout(self):
    """For notebooks: solids where they stand. None of a layout that does not know its problem."""
    return page_of_surface(self.surface(self.problem)) if hasattr(self, "problem") else None


def page_of_region(self):
    """For notebooks: the region among the shapes, and the moving one at a position of it. None where it is empty."""
    if self.empty:
        return None
    query = self.query
    moving = query.world.moving_together
    shapes = [_shape(name, shape, name in moving) for name, shape in query.world.shapes.items()]
    drawing, at = _region(self, shapes)
    if at is not None and at not in self:  # in the middle of what a polytope leaves
        at = _outside(drawing["vertices"], self)
    summary = {"where": query.text, "moving": moving, "shapes": shapes, "unit": query.world.unit}
    return _framed(page(summary, drawing, at)) if at is not None else None
