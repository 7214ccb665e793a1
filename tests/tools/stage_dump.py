# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""FINDSPACE_DUMP: files of the stages in the plane and in space, read back; the same for any number of threads.

stage_dump.py PROGRAM
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

PROGRAM = ""
STEPS = 1e6  # in a unit, where a scene does not say otherwise
PLANE = {
    "findspace": 1,
    "shapes": {
        "table": {"box": {"min": [0, 0], "max": [100, 60]}},
        "plate": {"polygon": [[25, 12], [75, 12], [75, 48], [50, 30], [25, 48]]},
        "disc": {"disc": {"center": [0, 0], "radius": 3}},
    },
    "moving": "disc",
    "where": "inside(disc, table) and gap(disc, plate) >= 2",
}
SPACE = {
    "findspace": 1,
    "shapes": {
        "bar": {"box": {"min": [0, 0, 0], "max": [9, 2, 2]}},
        "wedge": {"polytope": [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]]},
        "both": {"union": ["wedge", {"translate": [4, 0, 0], "of": "wedge"}]},
        "ball": {"ball": {"center": [0, 0, 0], "radius": 1}},
        "pair": {"union": ["ball", {"translate": [3, 0, 0], "of": "ball"}]},
    },
}


def obj(path):
    """The corners and the faces of an OBJ file."""
    corners, faces = [], []
    for line in path.read_text().splitlines():
        word, *rest = line.split()
        if word == "v":
            corners.append([float(c) for c in rest])
        elif word in "flp":
            faces.append([int(v) for v in rest])
    return corners, faces


class StageDump(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)
        self.addCleanup(self.folder.cleanup)

    def run_program(self, scene, *arguments, dump=None):
        environment = {k: v for k, v in os.environ.items() if k != "FINDSPACE_DUMP"}
        if dump is not None:
            environment["FINDSPACE_DUMP"] = str(dump)
        (self.root / "scene.json").write_text(json.dumps(scene))
        command = [PROGRAM, arguments[0], str(self.root / "scene.json"), *arguments[1:], "--json"]
        return subprocess.run(command, env=environment, capture_output=True, text=True, check=False)

    def stages(self, scene, *arguments):
        """The files by name, after a look that neither threads nor the dump change anything."""
        plain = self.run_program(scene, *arguments)
        self.assertIn(plain.returncode, (0, 1), plain.stderr)
        found = []
        for threads in ("1", "2"):
            folder = self.root / f"stages{threads}"
            folder.mkdir()
            result = self.run_program(scene, *arguments, "--threads", threads, dump=folder)
            self.assertEqual((result.returncode, result.stdout), (plain.returncode, plain.stdout))
            files = {path.name: path for path in sorted(folder.iterdir())}
            self.assertIn(f"FINDSPACE_DUMP: {len(files)} file", result.stderr)
            found.append(files)
        self.assertEqual(*({name: path.read_bytes() for name, path in files.items()} for files in found))
        numbers = [int(name[:3]) for name in found[0]]
        self.assertEqual(numbers, list(range(1, len(numbers) + 1)))
        return found[0]

    def names(self, files):
        return {name[4:] for name in files}

    def test_plane(self):
        files = self.stages(PLANE, "map")
        self.assertEqual(
            self.names(files), {"convolution.svg", "sum.svg", "signs.svg", "overlay.svg", "region.svg"}
        )
        for path in files.values():
            root = xml.etree.ElementTree.parse(path).getroot()
            self.assertTrue(root.tag.endswith("svg"))
            self.assertGreater(len([e for e in root.iter() if e.tag.endswith("path")]), 2, path.name)
        titles = [path.read_text().split("<title>")[1].split("</title>")[0] for path in files.values()]
        self.assertIn("sign of gamma1(disc, plate) minus 2", titles)

    def test_search_in_the_plane(self):
        scene = {**PLANE, "where": "protrusion(disc, plate) <= 3"}
        self.assertIn("search.svg", self.names(self.stages(scene, "check", "--at", "50,30")))

    def test_boxes(self):
        scene = {**SPACE, "moving": "bar", "where": "gap(bar, block) >= 0"}
        scene["shapes"] = {**SPACE["shapes"], "block": {"box": {"min": [0, 0, 0], "max": [5, 5, 5]}}}
        files = self.stages(scene, "map")
        self.assertEqual(self.names(files), {"parts.obj", "signs.obj", "cells.obj"})
        corners, faces = obj(files[sorted(files)[-1]])
        # The C-obstacle is the only bounded part of the region's complement.
        self.assertEqual([min(c) for c in zip(*corners)], [-9 * STEPS, -2 * STEPS, -2 * STEPS])
        self.assertEqual([max(c) for c in zip(*corners)], [5 * STEPS] * 3)
        self.assertTrue(all(1 <= v <= len(corners) for face in faces for v in face))

    def test_parts_and_search(self):
        scene = {**SPACE, "moving": "pair", "where": "gap(pair, both) >= -9"}
        files = self.stages(scene, "check", "--at", "1,1,1")
        self.assertIn("parts.obj", self.names(files))
        self.assertIn("search.obj", self.names(files))
        for path in files.values():
            corners, faces = obj(path)
            self.assertTrue(faces, path.name)
            self.assertTrue(all(1 <= v <= len(corners) for face in faces for v in face), path.name)

    def test_convolution(self):
        scene = {**SPACE, "moving": "wedge", "where": "gap(wedge, both) >= 0"}
        files = self.stages(scene, "map", "--resolution", "8")
        self.assertIn("convolution.obj", self.names(files))

    def test_no_folder(self):
        result = self.run_program(PLANE, "map", dump=self.root / "none")
        self.assertEqual(result.returncode, 3)
        self.assertIn("FINDSPACE_DUMP", result.stderr)
        self.assertIn("there is no folder", result.stderr)
        self.assertEqual(result.stdout, "")
        file = self.root / "file"
        file.write_text("")
        self.assertIn("there is no folder", self.run_program(PLANE, "map", dump=file).stderr)

    def test_empty_is_unset(self):
        result = self.run_program(PLANE, "map", dump="")
        self.assertEqual(result.returncode, 0)
        self.assertNotIn("FINDSPACE_DUMP", result.stderr)


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
