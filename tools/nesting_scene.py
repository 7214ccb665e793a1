#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Makes a scene of parts of a nesting instance (tests/data/nesting) and writes it to standard output.

usage: nesting_scene.py INSTANCE --part ID --sheet WIDTHxHEIGHT [--standing ID@X,Y[@TURN]]... [--turn DEGREES]
                        [--margin M] [--clearance C] [--unit mm] [--as ID=NAME]...
       nesting_scene.py INSTANCE --part ID --negative [--turn DEGREES] [--clearance C] [--unit mm]

The first form asks where the part can go on a sheet with other parts standing on it: each with its own pole (the origin of
the instance's coordinates) at X,Y, turned by TURN degrees, a multiple of 90. The moving part's pole is the middle of its box.
The second form cuts the part out of a sheet (grown by the clearance) and asks where it fits: in one place, exactly.
All numbers are taken over as decimals, none is rounded."""
import argparse
import json
import os
import sys
import textwrap
from decimal import Decimal

NESTING = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "tests", "data", "nesting")


def ring_of(instance, part):
    """The outer ring of a part, without the repeated first point, as decimals."""
    with open(os.path.join(NESTING, instance + ".json"), encoding="utf-8") as file:
        items = json.load(file, parse_float=Decimal, parse_int=Decimal)["items"]
    data = next(item["shape"]["data"] for item in items if item["id"] == part)
    ring = [tuple(p) for p in (data["outer"] if isinstance(data, dict) else data)]
    return ring[:-1] if ring[0] == ring[-1] else ring


def turned(ring, degrees):
    for _ in range(degrees // 90 % 4):
        ring = [(-y, x) for x, y in ring]
    return ring


def moved(ring, x, y):
    return [(a + x, b + y) for a, b in ring]


def box(ring):
    xs, ys = zip(*ring)
    return min(xs), min(ys), max(xs), max(ys)


def centred(ring):
    """The ring with its pole in the middle of its box, to three decimals."""
    x0, y0, x1, y1 = box(ring)
    return moved(ring, -round((x0 + x1) / 2, 3), -round((y0 + y1) / 2, 3))


def number(value):
    text = format(value.normalize(), "f")
    return "0" if text in ("-0", "0") else text


def polygon(ring, indent="      "):
    """{"polygon": [...]}, its points in lines of at most 110 characters."""
    lines, line = [], ""
    for x, y in ring:
        point = f"[{number(x)},{number(y)}]"
        if len(indent) + len(line) + len(point) + 2 > 110:
            lines.append(line + ",")
            line = ""
        line += (", " if line else "") + point
    lines.append(line)
    return '{"polygon": [\n' + "\n".join(indent + text for text in lines) + "]}"


def write(out, about, unit, shapes, moving, where):
    lines = ["// " + line for line in about]
    lines += ["{", '  "findspace": 1,', f'  "unit": "{unit}",', '  "shapes": {']
    lines += [",\n".join(f'    "{name}": {text}' for name, text in shapes)]
    lines += ["  },", f'  "moving": "{moving}",', f'  "where": "{where}"', "}"]
    out.write("\n".join(lines) + "\n")


def standing(text):
    """ID@X,Y[@TURN] as (id, x, y, turn)."""
    part, place, *turn = text.split("@")
    x, y = place.split(",")
    return int(part), Decimal(x), Decimal(y), int(turn[0]) if turn else 0


def sheet_scene(options, about, names):
    part = centred(turned(ring_of(options.instance, options.part), options.turn))
    name = names.get(options.part, "part")
    width, height = options.sheet.split("x")
    shapes = [("sheet", f'{{"box": {{"min": [0, 0], "max": [{width}, {height}]}}}}'), (name, polygon(part))]
    places = []
    for other, x, y, turn in options.standing:
        shape = names.get(other, f"part{other}")
        if all(shape != known for known, _ in shapes):
            shapes.append((shape, polygon(ring_of(options.instance, other))))
        of = f'{{"rotate": {turn}, "of": "{shape}"}}' if turn else f'"{shape}"'
        places.append(f'      {{"translate": [{number(x)}, {number(y)}], "of": {of}}}')
    where = f"inside({name}, sheet, {options.margin}{options.unit})"
    if places:
        shapes.append(("standing", "[\n" + ",\n".join(places) + "]"))
        where += f" and clear({name}, standing, {options.clearance}{options.unit})"
    write(sys.stdout, about, options.unit, shapes, name, where)


def negative_scene(options, about):
    part = centred(turned(ring_of(options.instance, options.part), options.turn))
    x0, y0, x1, y1 = box(part)
    edge = max(x1 - x0, y1 - y0) / 4 + Decimal(options.clearance)
    low, high = ([number(c.to_integral_value()) for c in corner] for corner in ((x0 - edge, y0 - edge), (x1 + edge, y1 + edge)))
    cut = '"part"' if options.clearance == "0" else f'{{"offset": {options.clearance}, "of": "part"}}'
    sheet = f'{{"box": {{"min": [{", ".join(low)}], "max": [{", ".join(high)}]}}}}'
    shapes = [("part", polygon(part)), ("sheet", sheet), ("rest", f'{{"closure": {{"difference": ["sheet", {cut}]}}}}')]
    where = f"clear(part, rest, {options.clearance}{options.unit}) and inside(part, sheet)"
    write(sys.stdout, about, options.unit, shapes, "part", where)


def main(argv):
    parser = argparse.ArgumentParser(usage=__doc__.split("\n\n")[1].removeprefix("usage: "))
    parser.add_argument("instance")
    parser.add_argument("--part", type=int, required=True)
    parser.add_argument("--turn", type=int, default=0)
    parser.add_argument("--sheet", default="")
    parser.add_argument("--standing", type=standing, action="append", default=[])
    parser.add_argument("--margin", default="0")
    parser.add_argument("--clearance", default="0")
    parser.add_argument("--unit", default="mm")
    parser.add_argument("--negative", action="store_true")
    parser.add_argument("--as", dest="names", action="append", default=[])
    options = parser.parse_args(argv)
    if options.negative == bool(options.sheet):
        parser.error("give either --sheet or --negative")
    names = {int(k): v for k, v in (pair.split("=") for pair in options.names)}
    made = textwrap.wrap(f"Made by: tools/nesting_scene.py {' '.join(argv)}", 110, break_on_hyphens=False)
    about = [*made, f"Parts of the nesting instance '{options.instance}' (tests/data/README.md says whose data and which licence)."]
    if options.negative:
        negative_scene(options, about)
    else:
        sheet_scene(options, about, names)


if __name__ == "__main__":
    main(sys.argv[1:])
