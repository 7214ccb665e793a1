#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""The schema of scenes (docs/scene.schema.json) against the program that reads them.

usage: scene_schema.py EXECUTABLE

* Every scene of examples/ and tests/cases that the program reads is valid.
* Every scene there that the program does not read is not valid, or it is refused for a reason that a schema cannot
  know (REASONS).
* Every object of a scene has the same keys in the schema as in the program, which names them all when it finds a
  strange one; and every list of keys in src/io is one of these.

A scene counts as read when `describe` gets as far as asking for a shape that no scene has."""
import glob
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor

import jsonschema

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
EXECUTABLE = ""
STRANGE = "no such shape, I hope"

# Why the program may refuse a scene that is valid: how its message goes on after the place in the scene.
FILE = r"(<svg> \()?\S+\.(svg|dxf|wkt|geojson|json|stl|obj|off|ply|3mf|asc|xyz)\b"
REASONS = {
    "curves and solids that are none": r"\"min\" of a box|the ring (has no|touches)|hole \d+ (is|touches)|near .* curves "
                                       r"meet|the mesh is not closed|in the mesh|a shell of the mesh|a face of \d+ "
                                       r"corners is not flat|"
                                       r"the floor must lie|a row of \d+ heights|no square of the height field|columns \d+ and",
    "an orientation that is none, or in the plane": r"the matrix mirrors|rows? \d|a quaternion of a rotation|"
                                                    r"an orientation is for 3D",
    "a mistake in the text of a path": r"path, character",
    "a name that no shape has, or that stands twice": r"unknown shape '|'.*' (is not among the placed|is made from itself|"
                                                      r"stands here twice|is a shape as well)",
    "a number beyond the limits": r"this is not JSON: the number is beyond|(\S+|an arc's radius) is more than "
                                  r"2\^40 grid steps|"
                                  r"a vertex is more than 2\^42 grid steps",
    "a text that is no length": r"'.*' is not a length, such as",
    "a tolerance that the grid does not hold": r"a tolerance of \S+( \S+)? is too small; at least",
    "more work than is allowed": r".* costs more than the work limit",
    "a file that cannot be read": FILE,
}


def without_comments(text):
    """Blanks for comments, as the program reads them; texts stay."""
    kept = re.compile(r'"(?:[^"\\]|\\.)*"|//[^\n]*|/\*.*?\*/', re.S)
    return kept.sub(lambda m: m.group(0) if m.group(0)[0] == '"' else " ", text)


def parsed(text):
    """The scene, or None where it is no JSON."""

    def refuse(word):
        raise ValueError(word)

    def once(pairs):
        keys = dict(pairs)
        if len(keys) != len(pairs):
            raise ValueError("a key stands twice")
        return keys

    try:
        return json.loads(without_comments(text), parse_constant=refuse, object_pairs_hook=once)
    except ValueError:
        return None


def answer(text, folder):
    """The program's message about a scene; "" where it reads it."""
    run = subprocess.run([EXECUTABLE, "describe", "-", STRANGE, "-q"], input=text.encode(), capture_output=True,
                         cwd=folder, check=False)
    message = run.stderr.decode()
    return "" if f"unknown shape '{STRANGE}'" in message else message or f"exit status {run.returncode}"


def scenes():
    """(name, text, files beside it) of all examples and cases."""
    for path in sorted(glob.glob(os.path.join(ROOT, "examples", "*.json"))):
        with open(path, encoding="utf-8") as file:
            yield os.path.basename(path), file.read(), {}
    for path in sorted(glob.glob(os.path.join(ROOT, "tests", "cases", "**", "*.case.json"), recursive=True)):
        with open(path, encoding="utf-8") as file:
            case = json.load(file)
        if "scene_text" in case:
            yield case["id"], case["scene_text"], case.get("files", {})
        elif "scene" in case:
            yield case["id"], json.dumps(case["scene"]), case.get("files", {})


def look(scene):
    name, text, files = scene
    with tempfile.TemporaryDirectory() as folder:
        for file, content in files.items():
            with open(os.path.join(folder, file), "w", encoding="utf-8") as out:
                out.write(content)
        return name, text, answer(text, folder if files else os.path.join(ROOT, "examples"))


def looked():
    """What look() says of every scene. Most are questions of one batch: a process for each takes ten times as long."""
    every = list(scenes())
    alone = [(number, scene) for number, scene in enumerate(every) if "\n" in scene[1] or '"file"' in scene[1] or scene[2]]
    numbers = {number for number, _ in alone}
    said = {}
    with tempfile.TemporaryDirectory() as folder:
        questions, results = (os.path.join(folder, name) for name in ("questions.jsonl", "results.jsonl"))
        with open(questions, "w", encoding="utf-8") as out:
            for number, (_, text, _) in enumerate(every):
                if number not in numbers:
                    out.write(f'{{"id": {number}, "verb": "describe", "shapes": ["{STRANGE}"], "scene": {text}}}\n')
        subprocess.run([EXECUTABLE, "batch", questions, "-o", results, "-q"], cwd=os.path.join(ROOT, "examples"), check=False)
        with open(results, encoding="utf-8") as file:
            for line in map(json.loads, file):
                if line["status"] != "usage":  # else the scene is no JSON, or its line is too long
                    said[line["id"]] = "" if f"unknown shape '{STRANGE}'" in line["error"] else line["error"]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        rest = list(pool.map(look, (scene for number, scene in enumerate(every) if number not in said)))
    return [(every[number][0], every[number][1], message) for number, message in said.items()] + rest


# A scene with a strange key in each object, as (where the schema states the object, the scene).
TRIANGLE = [[0, 0], [1, 0], [0, 1]]
CORNERS = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
CELLS = {"step": 1, "outside": False, "supporting_curves": [], "vertices": [], "edges": []}


def shape(value):
    return {"findspace": 1, "shapes": {"A": value}}


def asking(**more):
    return {"findspace": 1, "shapes": {"A": {"points": [[0, 0]]}}, "moving": "A", **more}


def strange_objects():
    q = {"qqqqqq": 1}
    shapes = {
        "polygon": {"polygon": TRIANGLE}, "disc": {"disc": {"center": [0, 0], "radius": 1}},
        "box": {"box": {"min": [0, 0], "max": [1, 1]}}, "points": {"points": [[0, 0]]},
        "polyline": {"polyline": TRIANGLE}, "path": {"path": "M0 0"}, "cells": {"cells": CELLS},
        "file": {"file": "x.svg"}, "translate": {"translate": [0, 0], "of": {"points": [[0, 0]]}},
        "rotate": {"rotate": 1, "of": {"points": [[0, 0]]}}, "offset": {"offset": 1, "of": {"points": [[0, 0]]}},
        "polytope": {"polytope": CORNERS}, "ball": {"ball": {"center": [0, 0, 0], "radius": 1}},
        "ellipse": {"ellipse": {"center": [0, 0], "radii": [2, 1]}}, "spline": {"spline": {"points": TRIANGLE, "degree": 2}},
        "bezier": {"bezier": TRIANGLE}, "outline": {"outline": TRIANGLE},
        "simplify": {"simplify": 1, "of": {"polygon": TRIANGLE}},
        "prism": {"prism": {"polygon": TRIANGLE, "z": [0, 1]}}, "mesh": {"mesh": {"vertices": CORNERS, "faces": []}},
        "height_field": {"height_field": {"heights": [[1, 1], [1, 1]], "step": [1, 1], "floor": 0}},
    }
    for one in ("complement", "interior", "closure", "boundary", "regularize", "mirror", "point_reflection", "hull"):
        shapes[one] = {one: {"points": [[0, 0]]}}
    for several in ("union", "intersection", "difference", "minkowski_sum", "minkowski_difference"):
        shapes[several] = {several: [{"points": [[0, 0]]}] * 2}
    for key, value in shapes.items():
        yield [key], shape({**value, **q})
    for key in ("disc", "box", "ball", "prism", "mesh", "height_field", "ellipse", "spline"):
        yield [key, "properties", key], shape({key: {**shapes[key][key], **q}})
    yield ["step"], shape({"outline": [*TRIANGLE, q]})
    yield ["exactCells"], shape({"cells": {**CELLS, **q}})
    supporting_curves = [{"line": [0, 1, 0]}, {"line": [1, 0, 0]}]
    cells = ["exactCells", "properties"]
    yield cells + ["supporting_curves", "items"], shape({"cells": {**CELLS, "supporting_curves": [q]}})
    yield cells + ["vertices", "items"], shape({"cells": {**CELLS, "vertices": [q]}})
    vertices = [{"at": [0, 0], "in": True}, {"at": [1, 0], "in": True}]
    yield cells + ["edges", "items"], shape({"cells": {**CELLS, "supporting_curves": supporting_curves, "vertices": vertices, "edges": [q]}})
    yield ["orientation"], shape({"rotate": {"quaternion": [1, 0, 0, 0], **q}, "of": shapes["ball"]})
    for word in ("position", "line", "angle", "time", "pose"):
        definition = "free" + word.capitalize()
        yield [definition], asking(free={word: {}, **q})
        yield [definition, "properties", word], asking(free={word: q})
    yield ["movement"], asking(motion={"time": [0, 1], "A": q})
    yield ["place"], asking(place={"shapes": "A", **q})
    yield [], asking(**q)


class SceneSchema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with open(os.path.join(ROOT, "docs", "scene.schema.json"), encoding="utf-8") as file:
            cls.schema = json.load(file)
        jsonschema.Draft7Validator.check_schema(cls.schema)
        cls.validator = jsonschema.Draft7Validator(cls.schema)
        cls.looked = looked()

    def keys(self, place):
        """The keys of the object that the schema states there."""
        at = self.schema
        for step in (["definitions"] if place else []) + place:
            at = at[step]
        self.assertIs(at["additionalProperties"], False, place)
        return set(at.get("properties", {}))

    def test_every_scene_that_is_read_is_valid(self):
        read = [(name, text) for name, text, message in self.looked if not message]
        self.assertGreater(len(read), 750)
        for name, text in read:
            with self.subTest(name):
                error = next(iter(self.validator.iter_errors(parsed(text))), None)
                self.assertIsNone(error, error and error.message)

    def test_every_scene_that_is_not_valid_is_refused_and_others_for_a_reason(self):
        used = set()
        refused = [(name, text, message) for name, text, message in self.looked if message]
        self.assertGreater(len(refused), 40)
        for name, text, message in refused:
            scene = parsed(text)
            if scene is None or not self.validator.is_valid(scene):
                continue
            with self.subTest(name):
                why = re.sub(r"^(findspace: )?(.*?(standard input|scene):\d+:\d+\)?: )+", "", message)
                found = [reason for reason, words in REASONS.items() if re.match(words, why)]
                self.assertEqual(len(found), 1, f"the schema accepts it, the program says: {why}")
                used.update(found)
        self.assertEqual(used, set(REASONS))

    def test_the_schema_refuses_what_has_no_structure(self):
        names = {name for name, text, message in self.looked
                 if message and parsed(text) is not None and not self.validator.is_valid(parsed(text))}
        for name in ("place-without-shapes", "place-count-zero", "refuse-unknown-key", "refuse-unknown-shape-key",
                     "refuse-shapes-missing", "refuse-version-missing", "refuse-radius-missing", "refuse-unit-unknown",
                     "refuse-coordinate-is-text", "refuse-grid-zero", "refuse-scene-is-a-list"):
            self.assertIn(name, names)

    def test_objects_have_the_keys_that_the_program_knows(self):
        for place, scene in strange_objects():
            with self.subTest("/".join(place)):
                message = answer(json.dumps(scene), ROOT)
                known = re.search(r"unknown key 'qqqqqq'; known here: (.*)", message)
                self.assertIsNotNone(known, message)
                self.assertEqual(set(re.findall(r"[$\w]+", known.group(1))), self.keys(place))
                self.assertFalse(self.validator.is_valid(scene))

    def test_kinds_of_shapes_are_those_of_the_program(self):
        message = answer(json.dumps(shape({"qqqqqq": 1})), ROOT)
        kinds = re.search(r"the kinds are (.*)", message).group(1)
        stated = [s["$ref"].split("/")[-1] for s in self.schema["definitions"]["shape"]["anyOf"] if "$ref" in s]
        self.assertEqual(set(re.findall(r"\w+", kinds)), set(stated) - {"shapes"})

    def test_help_names_all_keys_and_kinds(self):
        page = subprocess.run([EXECUTABLE, "help", "scene"], capture_output=True, text=True, check=True).stdout
        kinds = {s["$ref"].split("/")[-1] for s in self.schema["definitions"]["shape"]["anyOf"] if "$ref" in s}
        for word in set(self.schema["properties"]) | kinds - {"shapes"}:
            self.assertRegex(page, rf"(?m)(^  |, | as ){re.escape(word)}\b")

    def test_every_list_of_keys_in_the_source_is_asked_for(self):
        asked = {frozenset(self.keys(place)) for place, _ in strange_objects()}
        lists = []
        for path in glob.glob(os.path.join(ROOT, "src", "io", "scene", "*.cpp")) + \
                glob.glob(os.path.join(ROOT, "src", "io", "text", "read_cells.cpp")):
            with open(path, encoding="utf-8") as file:
                lists += re.findall(r"kKeys\{([^}]*)\}", file.read())
        self.assertGreater(len(lists), 10)
        for keys in lists:
            self.assertIn(frozenset(re.findall(r'"([^"]+)"', keys)), asked)

    def test_the_address_of_the_schema_is_accepted(self):
        scene = {"$schema": "scene.schema.json", **shape({"points": [[0, 0]]})}
        self.assertEqual(answer(json.dumps(scene), ROOT), "")
        self.assertTrue(self.validator.is_valid(scene))
        scene["$schema"] = 7
        self.assertIn("$schema", answer(json.dumps(scene), ROOT))
        self.assertFalse(self.validator.is_valid(scene))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit("usage: scene_schema.py EXECUTABLE")
    EXECUTABLE = os.path.abspath(sys.argv.pop(1))
    unittest.main()
