#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""DXF files that findspace writes, read by ezdxf: no error is found in them, and areas, layers and units are the same.

usage: dxf_elsewhere.py FINDSPACE
"""
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import ezdxf
from ezdxf.lldxf.encoding import decode_dxf_unicode

SCENE = {
    "findspace": 1, "unit": "mm", "moving": "lid", "where": "inside(lid, plate)",
    "shapes": {
        "plate": {"difference": [{"box": {"min": [0, 0], "max": [80, 50]}}, {"disc": {"center": [20, 20], "radius": 7}}]},
        "lid": {"offset": 2, "of": {"polygon": [[0, 0], [20, 0], [20, 10], [8, 10]]}},
        "moon": {"difference": [{"disc": {"center": [0, 0], "radius": 10}}, {"disc": {"center": [6, 0], "radius": 10}}]},
        "dünn 漢": {"box": {"min": [0, 0], "max": [5, 4]}},
        "left, side": {"box": {"min": [0, 0], "max": [3, 4]}},
    },
}


def area_of(entity):
    """Of a closed polyline with bulges, or a circle."""
    if entity.dxftype() == "CIRCLE":
        return math.pi * entity.dxf.radius ** 2
    if entity.dxftype() == "LWPOLYLINE":
        corners = [(x, y, b) for x, y, b in entity.get_points("xyb")]
    else:
        corners = [(v.dxf.location.x, v.dxf.location.y, v.dxf.bulge) for v in entity.vertices]
    area = 0.0
    for (x, y, bulge), (u, v, _) in zip(corners, corners[1:] + corners[:1]):
        area += (x * v - u * y) / 2
        angle, chord = 4 * math.atan(bulge), math.hypot(u - x, v - y)
        if bulge:
            radius = chord / (2 * math.sin(angle / 2))
            area += radius * radius * (angle - math.sin(angle)) / 2 if bulge > 0 else -radius * radius * (-angle + math.sin(angle)) / 2
    return area


def run(*arguments):
    done = subprocess.run(arguments, capture_output=True, text=True, check=False)
    assert done.returncode == 0, (arguments, done.stderr)
    return done.stdout


def main(argv):
    if len(argv) != 2:
        print(__doc__.rsplit("\n\n", 1)[1])
        return 2
    files = 0
    with tempfile.TemporaryDirectory() as folder:
        scene, out = Path(folder) / "scene.json", Path(folder) / "out.dxf"
        scene.write_text(json.dumps(SCENE), encoding="utf-8")
        for shape in SCENE["shapes"]:
            area = json.loads(run(argv[1], "describe", scene, shape, "--json"))["area"]
            for version, name in (("r12", "AC1009"), ("2000", "AC1015")):
                run(argv[1], "convert", scene, shape, "--dxf", version, "-o", out)
                drawing = ezdxf.readfile(out)
                assert drawing.dxfversion == name, drawing.dxfversion
                # ezdxf keeps escapes in the names of layers as they are, and then does not like their backslash.
                errors = [e.message for e in drawing.audit().errors if "\\U+" not in e.message]
                assert not errors, errors
                assert drawing.header["$INSUNITS"] == 4
                drawn = list(drawing.modelspace())
                rings = sorted(abs(area_of(e)) for e in drawn)
                found = rings[-1] - sum(rings[:-1])
                assert abs(found - area) < 1e-9 * area, (shape, version, found, area)
                layers = {decode_dxf_unicode(e.dxf.layer) for e in drawn}
                expected = "".join(c if (c.isalnum() and (c.isascii() or version == "2000")) or version == "2000" and c == " " else "_"
                                   for c in shape)
                assert layers == {expected}, (layers, expected)
                assert expected in [decode_dxf_unicode(layer.dxf.name) for layer in drawing.layers]
                files += 1
    print(f"{files} drawings are the same in ezdxf")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
