#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Drawings that ezdxf, matplotlib and shapely write, ten parts each, against areas that those parts were made with.

DXF of seven versions, ASCII and binary, entities as such and in blocks that are scaled, turned and mirrored; SVG, WKT and
GeoJSON. The area of each part is within the tolerance times its perimeter of the closed form; `inside` it is not
larger, and `outside` not smaller.

usage: other_writers.py FINDSPACE
"""
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import ezdxf.addons
import shapely.geometry as geometry

TOLERANCE = 0.001  # mm; the usual one
PITCH = 100
WRITTEN = 1e-5  # how far printed places may be off


def hexagon(radius):
    return [(radius * math.cos(k * math.pi / 3), radius * math.sin(k * math.pi / 3)) for k in range(6)]


STAR = [((20 if k % 2 == 0 else 8) * math.cos(k * math.pi / 5), (20 if k % 2 == 0 else 8) * math.sin(k * math.pi / 5)) for k in range(10)]
BOW = [(0, 0), (0, 40), (40, 40), (40, 0)]  # control points of a cubic that its chord closes: area 0.6 of the square


def polygon_area(points):
    return abs(sum(x * v - u * y for (x, y), (u, v) in zip(points, points[1:] + points[:1]))) / 2


# Area and perimeter, at most, of each part.
PARTS = [("square", 1600, 160), ("hexagon", polygon_area(hexagon(20)), 120), ("disc", math.pi * 400, 126),
         ("plate", 40 * 30 - math.pi * 25 - math.pi * 16, 200), ("slot", 30 * 20 + math.pi * 100, 123),
         ("ellipse", math.pi * 20 * 8, 95), ("bow", 0.6 * 1600, 130), ("star", polygon_area(STAR), 160),
         ("lines and arcs", 30 * 20 - 4 * 25 + math.pi * 25, 100), ("frame", 40 * 40 - 30 * 30, 280)]


def draw_dxf(space, name, at):
    """One part as entities on the layer of its name."""
    layer = {"layer": name}
    put = lambda points: [(x + at, y) for x, y in points]
    if name in ("square", "frame"):
        space.add_lwpolyline(put([(0, 0), (40, 0), (40, 40), (0, 40)]), close=True, dxfattribs=layer)
    if name == "frame":
        space.add_lwpolyline(put([(5, 5), (5, 35), (35, 35), (35, 5)]), close=True, dxfattribs=layer)
    if name in ("hexagon", "star"):
        points = put(hexagon(20) if name == "hexagon" else STAR)
        for p, q in zip(points, points[1:] + points[:1]):
            space.add_line(p, q, dxfattribs=layer)
    if name == "disc":
        space.add_circle((at, 0), 20, dxfattribs=layer)
    if name == "plate":
        space.add_lwpolyline(put([(0, 0), (40, 0), (40, 30), (0, 30)]), close=True, dxfattribs=layer)
        space.add_circle((at + 10, 10), 5, dxfattribs=layer)
        space.add_circle((at + 30, 20), 4, dxfattribs=layer)
    if name == "slot":
        space.add_lwpolyline([(at, 0, 0), (at + 30, 0, 1), (at + 30, 20, 0), (at, 20, 1)], format="xyb", close=True, dxfattribs=layer)
    if name == "ellipse":
        space.add_ellipse((at, 0), major_axis=(12, 16), ratio=0.4, dxfattribs=layer)
    if name == "bow":
        space.add_open_spline([(x + at, y, 0) for x, y in BOW], degree=3, dxfattribs=layer)
        space.add_line((at, 0), (at + 40, 0), dxfattribs=layer)
    if name == "lines and arcs":
        for p, q in (((5, 0), (25, 0)), ((30, 5), (30, 15)), ((25, 20), (5, 20)), ((0, 15), (0, 5))):
            space.add_line(*put([p, q]), dxfattribs=layer)
        for center, start in (((25, 5), 270), ((25, 15), 0), ((5, 15), 90), ((5, 5), 180)):
            space.add_arc(*put([center]), 5, start, start + 90, dxfattribs=layer)


def write_dxf(path, version, binary, blocks):
    drawing = ezdxf.new(version)
    drawing.header["$INSUNITS"] = 4
    space = drawing.modelspace()
    for k, (name, _, _) in enumerate(PARTS):
        if not blocks:
            draw_dxf(space, name, PITCH * k)
            continue
        draw_dxf(drawing.blocks.new(f"block{k}"), name, 0)
        space.add_blockref(f"block{k}", (PITCH * k, 7), dxfattribs={"layer": name, "xscale": -2 if k % 2 else 2, "yscale": 2, "rotation": 30 * k})
    drawing.saveas(path, fmt="bin" if binary else "asc")


class Simple:
    """The other writer of ezdxf, of version R12, by the same names."""

    def __init__(self, writer):
        self.writer = writer

    def add_lwpolyline(self, points, format="xy", close=True, dxfattribs=None):
        self.writer.add_polyline_2d(points, format=format, closed=close, **dxfattribs)

    def add_line(self, p, q, dxfattribs):
        self.writer.add_line(p, q, **dxfattribs)

    def add_circle(self, center, radius, dxfattribs):
        self.writer.add_circle(center, radius, **dxfattribs)

    def add_arc(self, center, radius, start, end, dxfattribs):
        self.writer.add_arc(center, radius, start, end, **dxfattribs)


def write_r12(path):
    """R12 knows neither ellipses nor splines."""
    with ezdxf.addons.r12writer(path) as writer:
        for k, (name, _, _) in enumerate(PARTS):
            if name not in ("ellipse", "bow"):
                draw_dxf(Simple(writer), name, PITCH * k)


def outlines(name):
    """Of the parts without curves: the outline and its holes."""
    return {"square": ([(0, 0), (40, 0), (40, 40), (0, 40)], []), "hexagon": (hexagon(20), []), "star": (STAR, []),
            "frame": ([(0, 0), (40, 0), (40, 40), (0, 40)], [[(5, 5), (5, 35), (35, 35), (35, 5)]])}.get(name)


def straight_parts():
    return [(k, name, area, length) for k, (name, area, length) in enumerate(PARTS) if outlines(name)]


def write_geojson(path):
    features = []
    for k, name, _, _ in straight_parts():
        outer, holes = outlines(name)
        move = lambda ring: [(x + PITCH * k, y) for x, y in ring]
        shape = geometry.Polygon(move(outer), [move(hole) for hole in holes])
        features.append({"type": "Feature", "id": name, "properties": {}, "geometry": geometry.mapping(shape)})
    path.write_text(json.dumps({"type": "FeatureCollection", "features": features}), encoding="utf-8")


def write_wkt(path):
    path.write_text("\n".join(geometry.Polygon(*outlines(name)).wkt for _, name, _, _ in straight_parts()), encoding="utf-8")


def write_svg(path):
    """By matplotlib, whose circles and ellipses are Bezier curves, 1 mm a unit."""
    import matplotlib
    matplotlib.use("svg")
    from matplotlib import patches, pyplot
    from matplotlib.path import Path as Curve
    width, height = PITCH * len(PARTS), 100
    figure = pyplot.figure(figsize=(width / 25.4, height / 25.4))
    axes = figure.add_axes([0, 0, 1, 1])
    axes.set_xlim(-50, width - 50)
    axes.set_ylim(-50, height - 50)
    axes.axis("off")
    for k, (name, _, _) in enumerate(PARTS):
        at = PITCH * k
        loop = outlines(name)
        rings = [loop[0], *loop[1]] if loop else []
        codes = lambda ring: [Curve.MOVETO] + [Curve.LINETO] * (len(ring) - 1) + [Curve.CLOSEPOLY]
        if name == "disc":
            patch = patches.Circle((at, 0), 20)
        elif name == "ellipse":
            patch = patches.Ellipse((at, 0), 40, 16, angle=30)
        elif name == "bow":
            patch = patches.PathPatch(Curve([(x + at, y) for x, y in BOW + BOW[:1]], [Curve.MOVETO] + [Curve.CURVE4] * 3 + [Curve.CLOSEPOLY]))
        elif rings:
            patch = patches.PathPatch(Curve([(x + at, y) for ring in rings for x, y in ring + ring[:1]], sum(map(codes, rings), [])))
        else:
            continue
        patch.set(fill=False, gid=name, clip_on=False)
        axes.add_patch(patch)
    figure.savefig(path, format="svg")
    pyplot.close(figure)
    return [(name, area, length) for name, area, length in PARTS if outlines(name) or name in ("disc", "ellipse", "bow")]


def drawings(folder):
    """Path, how a part is chosen, what scale its area has, and the parts."""
    by_layer = lambda k, name: {"layer": name}
    for version in ("R2000", "R2004", "R2007", "R2010", "R2013", "R2018"):
        for binary in (False, True):
            for blocks in (False, True):
                if binary and version not in ("R2000", "R2010", "R2018"):
                    continue
                path = folder / f"{version}{'-binary' if binary else ''}{'-blocks' if blocks else ''}.dxf"
                write_dxf(path, version, binary, blocks)
                yield path, by_layer, 4 if blocks else 1, PARTS
    write_r12(folder / "R12.dxf")
    yield folder / "R12.dxf", by_layer, 1, [part for part in PARTS if part[0] not in ("ellipse", "bow")]
    write_geojson(folder / "shapely.geojson")
    yield folder / "shapely.geojson", lambda k, name: {"id": name}, 1, [p[1:] for p in straight_parts()]
    write_wkt(folder / "shapely.wkt")
    yield folder / "shapely.wkt", lambda k, name: {"index": k}, 1, [p[1:] for p in straight_parts()]
    drawn = write_svg(folder / "matplotlib.svg")
    yield folder / "matplotlib.svg", lambda k, name: {"id": name}, 1, drawn


def area(program, path, choice, side):
    scene = {"findspace": 1, "unit": "mm", "moving": "part", "curves": side, "shapes": {"part": {"file": path.name} | choice}}
    place = path.with_suffix(".scene.json")
    place.write_text(json.dumps(scene), encoding="utf-8")
    done = subprocess.run([program, "describe", place, "part", "--json"], capture_output=True, text=True, check=False, timeout=60)
    return json.loads(done.stdout)["area"] if done.returncode == 0 else done.stderr


def faults(program, path, choice, wanted, length):
    """What is wrong with one part, in words."""
    found = {side: area(program, path, choice, side) for side in ("inside", "near", "outside")}
    for side, value in found.items():
        if isinstance(value, str):
            return [f"{side}: {value}"]
    slack = (TOLERANCE + WRITTEN) * length
    wrong = [f"{side}: {value} instead of {wanted}" for side, value in found.items() if abs(value - wanted) > slack]
    if found["inside"] > wanted + WRITTEN * length or found["outside"] < wanted - WRITTEN * length:
        wrong.append(f"on the wrong side of {wanted}: {found}")
    return wrong


def main(argv):
    if len(argv) != 2:
        print(__doc__.rsplit("\n\n", 1)[1])
        return 2
    count, parts, wrong = 0, 0, 0
    with tempfile.TemporaryDirectory() as name:
        for path, choice, scale, drawn in drawings(Path(name)):
            count += 1
            for k, (part, wanted, length) in enumerate(drawn):
                parts += 1
                # Round outlines of matplotlib are cubics that are off by some 2e-4 of the radius.
                slack = 30 if path.suffix == ".svg" and part in ("disc", "ellipse") else 1
                for fault in faults(argv[1], path, choice(k, part), scale * wanted, slack * math.sqrt(scale) * length):
                    wrong += 1
                    print(f"{path.name}, {part}: {fault}")
    print(f"{parts} parts of {count} drawings, {wrong} wrong")
    return 1 if wrong or parts < 200 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
