#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""The promises of docs/security.md, asked of the program: safety.py PROGRAM [TEST...].

What a scene may read, what is shown of files, what hostile files may cost, what limits and signals leave behind.
Each test makes its input. A run that does not end within a minute (ten under sanitizers) is killed and counts as
failed.
"""

import itertools
import json
import math
import os
import resource
import shutil
import signal
import stat
import subprocess
import sys
import time
import unittest
import zipfile

from safety_test import GIGABYTE, SANITIZED, SECONDS, SECRET, SQUARE, TETRAHEDRON, SafetyTest


def small_files():
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 16, 1 << 16))


class Reading(SafetyTest):
    """What a scene may read."""

    def test_pipe_is_not_waited_for(self):
        os.mkfifo(self.folder / "pipe.obj")
        self.expect(3, "not a regular file", "describe", self.of_file("pipe.obj"))

    def test_pipe_as_scene(self):
        os.mkfifo(self.folder / "pipe.json")
        self.expect(3, "not a regular file", "describe", "pipe.json")

    def test_device_behind_a_link(self):
        (self.folder / "zero.dxf").symlink_to("/dev/zero")
        self.expect(3, "not a regular file", "describe", self.of_file("zero.dxf"))

    def test_folder_as_mesh(self):
        (self.folder / "part.stl").mkdir()
        self.expect(3, "this is a folder", "describe", self.of_file("part.stl"))

    @unittest.skipUnless(os.path.exists("/proc/self/mem"), "no file that fails in reading")
    def test_read_error(self):
        for name in ("mem.obj", "mem.svg"):
            (self.folder / name).symlink_to("/proc/self/mem")
            self.expect(3, "cannot be read to its end", "describe", self.of_file(name))

    def test_standard_input_that_fails(self):
        folder = os.open(self.folder, os.O_RDONLY)
        self.addCleanup(os.close, folder)
        self.expect(3, "cannot be read to its end", "describe", "-", stdin=folder)

    def test_no_files(self):
        self.file("part.obj", TETRAHEDRON)
        scene = self.of_file("part.obj")
        self.expect(0, "", "describe", scene)
        self.expect(3, "switched off", "describe", scene, "--no-files")

    def test_root_holds_what_may_be_read(self):
        self.file("in/part.obj", TETRAHEDRON)
        self.file("out/part.obj", TETRAHEDRON)
        (self.folder / "in" / "link.obj").symlink_to("../out/part.obj")
        (self.folder / "out" / "back.obj").symlink_to("../in/part.obj")
        for name, status in (("in/part.obj", 0), ("out/back.obj", 0), ("out/part.obj", 3), ("in/../out/part.obj", 3),
                             ("in/link.obj", 3), (self.folder / "out/part.obj", 3)):
            self.expect(status, "outside the folder" if status else "", "describe", self.of_file(name), "--root", "in")

    def packing(self, name):
        return self.file("packing.json", {"name": "p", "strip_height": 10, "unit": "mm",
                                          "items": [{"id": "a", "demand": 2, "shape": {"file": name}}]})

    def test_files_of_a_packing_problem(self):
        drawing = '<svg xmlns="http://www.w3.org/2000/svg" width="9mm" height="9mm" viewBox="0 0 9 9"><path d="M0 0H4V3Z"/></svg>'
        self.file("in/part.svg", drawing)
        self.file("out/part.svg", drawing)
        few = ("--time-limit", "1")
        self.expect(0, "", "pack", self.packing("in/part.svg"), "--root", "in", *few)
        self.expect(3, "outside the folder", "pack", self.packing("out/part.svg"), "--root", "in", *few)
        self.expect(3, "switched off", "pack", self.packing("in/part.svg"), "--no-files", *few)
        self.expect(4, "--input-limit raises", "pack", self.packing("in/part.svg"), "--input-limit", "100", *few)

    def test_folder_whose_name_begins_like_the_root(self):
        self.file("in/x", "")
        self.file("in-secret/part.obj", TETRAHEDRON)
        self.expect(3, "outside the folder", "describe", self.of_file("in-secret/part.obj"), "--root", "in")

    def test_scene_from_a_pipe_reads_its_own_folder(self):
        self.file("part.obj", TETRAHEDRON)
        (self.folder / "below").mkdir()
        scene = '{"findspace": 1, "unit": "mm", "shapes": {"A": {"file": "%s"}}}'
        for name, status in (("part.obj", 0), ("below/../part.obj", 0), ("/etc/passwd.obj", 3)):
            with open(self.file("text", scene % name)) as text:
                self.expect(status, "outside the folder" if status else "", "describe", "-", stdin=text)

    def test_words_of_foreign_files_are_not_shown(self):
        for ending in ("obj", "off", "ply", "stl", "dxf", "wkt", "svg", "geojson", "json", "3mf"):
            for text in (f"{SECRET} 1 2\n", f"v {SECRET} 1 2\n", f"0\n{SECRET}\n", f'{{"{SECRET}": 1, "{SECRET}": 2}}',
                         f"<{SECRET}>"):
                self.file("foreign." + ending, text)
                result = self.run_program("describe", self.of_file("foreign." + ending))
                self.assertEqual(result.status, 3, (ending, text, result.err))
                self.assertNotIn(SECRET, result.out + result.err, ending)

    def test_bytes_of_zero_do_not_cut_a_message(self):
        self.file("part.obj", "v 0 0 0\nv 1\0 0 0\n")
        self.expect(3, "\\x00' is not a number", "describe", self.of_file("part.obj"))
        self.expect(3, "x.obj\\x00.wkt: a file name with a NUL byte", "describe", self.of_file("x.obj\0.wkt"))
        self.expect(3, ":1:17: this is not JSON: a NUL byte", "describe", self.file("a.json", '{"findspace": "1\0"}'))

    def test_kinds_that_are_read_are_listed(self):
        self.scene({"B": {"box": {"min": [0, 0, 0], "max": [1, 1, 1]}}, "A": {"file": "part.sldprt"}})
        self.expect(3, "3D shapes come from .stl", "describe", "scene.json", "A")

    def test_ending_of_a_result_is_looked_at_first(self):
        for verb in ("map", "check", "measure", "describe", "convert", "place", "explain", "pack"):
            self.expect(2, "the ending must be one of", verb, "nowhere.json", "-o", "a.doc")

    def test_faces_that_stand_twice(self):
        self.file("a.obj", TETRAHEDRON + "f 1 3 2\nf 1 2 4\n")
        result = self.expect(3, "2 faces stand twice", "describe", self.of_file("a.obj"))
        self.assertIn("3 faces, 2 of one sense and 1 of the other", result.err)

    def test_twisted_face(self):
        corners = "v 20 0 0\nv 30 1 1\nv 20 1 2\nv 30 0 3\nv 25 7 1\nv 22 -3 2\n"
        self.file("a.obj", TETRAHEDRON + corners + "f 5 6 7 8 9 10\n")
        self.expect(3, "a face of 6 corners is not flat and crosses itself: it begins (20, 0, 0)", "describe",
                    self.of_file("a.obj"))

    def test_membrane_within_a_solid(self):
        corners = "v 0 0 0\nv 10 0 0\nv 0 10 0\nv 0 0 10\nv 3 3 0.5\n"
        self.file("a.obj", corners + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\nf 1 2 5\nf 2 1 5\n")
        result = self.expect(3, "lies in another and encloses no volume", "describe", self.of_file("a.obj"))
        self.assertNotIn("reversed", result.err)

    def test_place_in_a_scene_that_nobody_wrote(self):
        other = "v 0.1 0.1 -1\nv 0.3 0.1 -1\nv 0.1 0.3 -1\nv 0.2 0.2 0.2\nf 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\n"
        self.file("a.obj", TETRAHEDRON + other)
        self.expect(3, "shape 'a' (a.obj): the mesh crosses itself", "describe", "a.obj")

    def test_count_that_is_too_large(self):
        self.file("a.ply", "ply\nformat ascii 1.0\nelement vertex 18446744073709551615\nend_header\n")
        self.expect(3, "'18446744073709551615' is too large", "describe", self.of_file("a.ply"))

    def test_what_a_file_is_instead(self):
        for name, content, says in (("a.svg", b"\x1f\x8b\x08rest", "gzip has compressed it"), ("a.dxf", b"AC1032rest", "DWG drawing"),
                                    ("a.svg", b"%PDF-1.7 rest", "PDF file"), ("a.obj", b"<html>rest", "a page of the web"),
                                    ("a.off", b"", "it is empty"), ("a.stl", bytes(80) + b"\x05\0\0\0" + bytes(60), "cut off")):
            self.file(name, content)
            result = self.expect(3, says, "describe", self.of_file(name))
            self.assertNotIn("rest", result.err)
        self.file("a.svg", '<svg xmlns="http://www.w3.org/2000/svg"><text>hi</text></svg>')
        self.expect(3, "there is no shape in it; 1 <text> left out; an editor turns text into paths", "describe", "a.svg")

    def test_unknown_type_of_geojson(self):
        self.file("part.geojson", {"type": "Poligon", "coordinates": []})
        self.expect(3, "'Poligon' is not a type of GeoJSON", "describe", self.of_file("part.geojson"))
        self.file("part.geojson", {"type": "Topology", "features": []})
        self.expect(3, "'Topology' is not a type of GeoJSON", "describe", self.of_file("part.geojson"))

    def test_result_does_not_replace_its_input(self):
        scene = self.scene({"A": {"box": {"min": [0, 0], "max": [1, 1]}}})
        (self.folder / "link.json").symlink_to("scene.json")
        text = scene.read_text()
        self.expect(2, "the input itself", "describe", scene, "A", "-o", "link.json")
        self.assertEqual(scene.read_text(), text)

    def test_help_that_cannot_be_written(self):
        for arguments in (("help",), ("help", "formula"), ("map", "--help"), ("--version",)):
            with open("/dev/full", "w") as full:
                child = subprocess.run([self.program, *arguments], stdout=full, stderr=subprocess.PIPE, text=True)
            self.assertEqual(child.returncode, 3, arguments)
            self.assertIn("cannot be written", child.stderr)

    def test_scenes_of_a_batch_lie_within_its_root(self):
        box = {"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0], "max": [1, 1]}}}}
        self.file("in/a.json", box)
        self.file("out/a.json", box)
        (self.folder / "in" / "link.json").symlink_to("../out/a.json")
        names = ("in/a.json", "out/a.json", "in/link.json", "in/../out/a.json")
        self.file("questions", "".join(json.dumps({"verb": "describe", "path": n, "shapes": ["A"]}) + "\n" for n in names))
        result = self.run_program("batch", "questions", "--root", "in", "-o", "answers.jsonl")
        text = (self.folder / "answers.jsonl").read_text()
        answers = {a["line"]: a["exit"] for a in map(json.loads, text.splitlines()) if "exit" in a}
        self.assertEqual(answers, {1: 0, 2: 3, 3: 3, 4: 3}, text + result.err)
        self.assertEqual(text.count("outside the folder"), 3)

    def batch(self, questions, *options):
        """The answers, by line."""
        self.file("questions", "".join(json.dumps(q) + "\n" for q in questions))
        self.run_program("batch", "questions", *options, "-o", "answers.jsonl")
        lines = map(json.loads, (self.folder / "answers.jsonl").read_text().splitlines())
        return {a["line"]: a for a in lines if "line" in a}

    def test_all_files_of_a_batch_lie_within_its_root(self):
        strip = {"name": "s", "strip_height": 2, "items": [{"id": "a", "demand": 1, "shape": {
            "type": "simple_polygon", "data": [[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]}}]}
        layout = {"findspace": 1, "layout": {"instance": "s", "container": {"strip": 2}, "length": "1", "items": [
            {"part": "a", "copy": 1, "sheet": 0, "angle": 0, "mirrored": False, "at": ["0", "0"]}]}}
        drawing = '<svg xmlns="http://www.w3.org/2000/svg" width="9mm" height="9mm" viewBox="0 0 9 9"><path d="M0 0H4V3Z"/></svg>'
        for folder in ("in", "out"):
            self.file(folder + "/strip.json", strip)
            self.file(folder + "/layout.json", layout)
            self.file(folder + "/part.svg", drawing)
        box = {"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0], "max": [1, 1]}}}}
        questions = [q for folder in ("in", "out") for q in (
            {"verb": "verify", "path": "in/layout.json", "shapes": [folder + "/strip.json"]},
            {"verb": "pack", "path": "in/strip.json", "options": {"work": 1, "start": folder + "/layout.json"}},
            {"verb": "pack", "path": "in/part.svg", "shapes": ["x2", folder + "/part.svg", "x1"],
             "options": {"work": 1, "height": 10}},
            {"verb": "describe", "scene": box, "shapes": ["A"], "options": {"output": folder + "/made.json"}})]
        answers = self.batch(questions, "--root", "in")
        self.assertEqual([answers[k + 1]["exit"] for k in range(8)], [0] * 4 + [3] * 4, answers)
        for k in range(5, 9):
            self.assertIn("outside the folder", answers[k]["error"])
        self.assertFalse((self.folder / "out" / "made.json").exists())

    def test_questions_of_a_batch_narrow_its_limits(self):
        many = {"findspace": 1, "shapes": {"A": {"union": [
            {"box": {"min": [2 * k, 0], "max": [2 * k + 1, 1]}} for k in range(100)]}}}
        ask = lambda **options: {"verb": "describe", "scene": many, "shapes": ["A"], "options": options}
        exits = lambda *options: [a["exit"] for _, a in sorted(self.batch(questions, *options).items())]
        questions = [ask(), ask(**{"work-limit": 100}), ask(**{"input-limit": 100})]
        self.assertEqual(exits(), [0, 4, 4])
        questions = [ask(), ask(**{"work-limit": "1G"})]
        self.assertEqual(exits("--work-limit", "100"), [4, 4])


class Costs(SafetyTest):
    """What hostile input may cost: an answer or a refusal, in little time and memory."""

    def refused(self, *arguments):
        result = self.expect(4, "-limit raises", *arguments)
        self.assertLess(result.kilobytes << 10, 2 * GIGABYTE)

    def test_chain_of_rotations(self):
        self.file("a.svg", '<svg xmlns="http://www.w3.org/2000/svg"><path transform="%s" d="M0 0H9V5Z"/></svg>' %
                  ("rotate(1) " * 20000))
        self.refused("describe", "a.svg")

    def test_rotations_of_nested_groups(self):
        group = '<g transform="%s">' % ("rotate(1) " * 100)
        self.file("a.svg", '<svg xmlns="http://www.w3.org/2000/svg">%s<path d="M0 0H9V5Z"/>%s</svg>' %
                  (group * 150, "</g>" * 150))
        self.refused("describe", "a.svg")

    def test_elements_without_properties(self):
        self.file("a.ply", "ply\nformat ascii 1.0\nelement junk 20000000000\nelement vertex 4\nproperty float x\n"
                  "property float y\nproperty float z\nelement face 4\nproperty list uchar int vertex_indices\n"
                  "end_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")
        result = self.expect(0, "", "describe", self.of_file("a.ply"))
        self.assertIn("0.166667", result.out)

    def test_face_of_equal_corners(self):
        self.file("a.obj", TETRAHEDRON + "f" + " 1" * 1000000 + "\n")
        self.expect(0, "1 face without area", "describe", self.of_file("a.obj"))

    def test_face_of_spurs(self):
        there = list(range(1, 200001))
        there += there[-2:0:-1]
        lines = "".join("v %d 0 0\n" % i for i in range(200000))
        self.file("a.obj", lines + "f " + " ".join(map(str, there)) + "\n")
        self.expect(3, "encloses no volume", "describe", self.of_file("a.obj"))

    def test_prism_of_many_sides(self):
        n = 6000
        ring = [(100000 * math.cos(2 * math.pi * k / n), 100000 * math.sin(2 * math.pi * k / n)) for k in range(n)]
        lines = ["v %.3f %.3f %d" % (x, y, z) for z in (0, 9) for x, y in ring]
        lines.append("f " + " ".join(str(k) for k in range(n, 0, -1)))
        lines.append("f " + " ".join(str(k) for k in range(n + 1, 2 * n + 1)))
        lines += ["f %d %d %d %d" % (k + 1, (k + 1) % n + 1, n + (k + 1) % n + 1, n + k + 1) for k in range(n)]
        self.file("a.obj", "\n".join(lines) + "\n")
        self.expect(0, "", "describe", self.of_file("a.obj"))

    def test_faces_of_many_rounded_corners(self):
        n = 200000
        around = (2 * math.pi * k / n for k in range(n))
        vertices = ("v %.6f %.6f 5" % (math.cos(a), math.sin(a)) for a in around)
        faces = ("f" + "".join(" %d" % (k + 5) for k in corners) for corners in (range(n), range(n - 1, -1, -1)))
        self.lines("a.obj", itertools.chain([TETRAHEDRON.rstrip()], vertices, faces))
        self.expect(0, "", "describe", self.of_file("a.obj"))

    def test_cones_of_many_faces(self):
        n = 20000
        for height in (50, 5):
            around = (2 * math.pi * k / n for k in range(n))
            rim = ("v %.6f %.6f 0" % (10 * math.cos(a), 10 * math.sin(a)) for a in around)
            faces = ("f %d %d %d" % corners for k in range(n)
                     for corners in ((1, 3 + k, 3 + (k + 1) % n), (2, 3 + (k + 1) % n, 3 + k)))
            self.lines("a.obj", itertools.chain(["v 0 0 %d" % height, "v 0 0 0"], rim, faces))
            self.expect(0, "", "describe", self.of_file("a.obj"))

    def test_many_names(self):
        self.scene({"A": {"polygon": SQUARE}, "B": {"polygon": SQUARE}}, moving="B",
                   where="gap(B, " + "+".join(["A"] * 50000) + ") >= 0")
        self.refused("map", "scene.json")

    def test_sums_of_sums(self):
        shapes = {"S0": {"polygon": [[0, 0], [5, 0], [5, 1], [1, 1], [1, 4], [0, 4]]}}
        for i in range(24):
            shapes["S%d" % (i + 1)] = {"minkowski_sum": ["S%d" % i] * 2}
        self.scene(shapes)
        self.refused("describe", "scene.json", "S24")

    def test_sums_of_points(self):
        shapes = {"S0": {"points": [[0, 0], [1, 0]]}}
        for i in range(30):
            shapes["S%d" % (i + 1)] = {"minkowski_sum": ["S%d" % i, {"points": [[0, 0], [2 << i, 0]]}]}
        self.scene(shapes)
        self.refused("describe", "scene.json", "S30")

    def test_sums_of_sums_in_space(self):
        shapes = {"S0": {"polytope": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]}}
        for i in range(10):
            below = "S%d" % i
            shapes["S%d" % (i + 1)] = {"minkowski_sum": [below, {"rotate": 10 + i, "axis": [1, 2, i], "of": below}]}
        self.scene(shapes)
        self.refused("describe", "scene.json", "S10")

    def test_rotated_sums_of_rotated_sums(self):
        shapes = {"S0": {"polytope": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]}}
        for i in range(24):
            below = "S%d" % i
            shapes["S%d" % (i + 1)] = {"minkowski_sum": [below, {"rotate": 10 + i, "axis": [1, 2, i], "of": below}]}
        self.scene(shapes)
        self.refused("describe", "scene.json", "S1")

    def test_rotated_sums_of_one_sum(self):
        shapes = {"S0": {"polytope": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]}}
        for i in range(15):
            shapes["S%d" % (i + 1)] = {"minkowski_sum": ["S%d" % i, "S%d" % i]}
        self.scene({**shapes, "R": {"rotate": 10, "axis": [1, 2, 3], "of": "S15"}})
        self.expect(0, "98304 rotated points", "describe", "scene.json", "S1")

    def test_sums_of_what_has_arcs(self):
        shape = {"polygon": [[0, 0], [5, 0], [5, 1]]}
        for _ in range(60):
            shape = {"minkowski_sum": [{"boundary": shape}, {"disc": {"center": [0, 0], "radius": 0.05}}]}
        self.scene({"S": shape})
        self.refused("describe", "scene.json")

    def test_conditions_in_a_list(self):
        self.scene({"A": {"polygon": SQUARE}, "B": {"polygon": SQUARE}}, moving="B",
                   where=["gap(B, A) >= %d / 1000" % i for i in range(50000)])
        self.refused("map", "scene.json")

    def test_unions_of_unions(self):
        shapes = {"S0": {"polygon": [[0, 0], [5, 0], [5, 1], [1, 1], [1, 4], [0, 4]]}}
        for i in range(24):
            below = "S%d" % i
            shapes["S%d" % (i + 1)] = {"union": [below, {"translate": [6 << i, 0], "of": below}]}
        self.scene(shapes)
        self.refused("describe", "scene.json", "S24")

    def test_unions_of_unions_in_space(self):
        shapes = {"S0": {"box": {"min": [0, 0, 0], "max": [1, 1, 1]}}}
        for i in range(24):
            below = "S%d" % i
            shapes["S%d" % (i + 1)] = {"union": [below, {"translate": [6 << i, 0, 0], "of": below}]}
        self.scene(shapes)
        self.refused("describe", "scene.json", "S24")

    @unittest.skipIf(SANITIZED, "measures memory")
    def test_many_values(self):
        with open(self.folder / "scene.json", "w") as text:  # in pieces: what this process holds counts as the program's
            text.write('{"findspace": 1, "shapes": {"A": {"points": [')
            for _ in range(7000):
                text.write("[1,2]," * 1000)
            text.write("[1,2]]}}}")
        result = self.expect(4, "so many values costs more", "map", "scene.json")
        self.assertLess(result.kilobytes, 200 << 10)

    def test_offsets_of_boundaries(self):
        shape = {"polygon": [[0, 0], [5, 0], [5, 1], [1, 1], [1, 4], [0, 4]]}
        for _ in range(60):
            shape = {"offset": 0.1, "of": {"boundary": shape}}
        self.scene({"S": shape})
        self.refused("describe", "scene.json")

    def test_offsets_of_boundaries_of_a_triangle(self):
        shape = {"polygon": [[0, 0], [3, 0], [1, 2]]}
        for _ in range(60):
            shape = {"offset": 0.1, "of": {"boundary": shape}}
        self.scene({"S": shape})
        self.refused("describe", "scene.json")

    def test_offsets_of_boundaries_by_different_amounts(self):
        for base in ([[0, 0], [3, 1], [1, 2]], [[0, 0], [4, 0], [4, 4], [0, 4]]):
            shape = {"polygon": base}
            for k in range(1, 7):
                shape = {"offset": 0.1 + k / 1000, "of": {"boundary": shape}}
            self.scene({"S": shape})
            self.refused("describe", "scene.json")

    def test_many_alternatives(self):
        shapes = {"A%d" % k: {"box": {"min": [3 * k, 0], "max": [3 * k + 1, 1]}} for k in range(500)}
        self.scene({"B": {"disc": {"center": [0, 0], "radius": 1}}, **shapes}, moving="B",
                   where=" or ".join("gap(B, others) >= %d" % (20 + k) for k in range(500)))
        result = self.expect(1, "", "check", "scene.json", "--at", "9,9", "--json")
        self.assertEqual(json.loads(result.out)["nearest_feasible"]["distance"], 13)

    def test_a_face_that_stands_200000_times(self):
        self.file("rep.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n" + "f 1 2 3\nf 1 3 2\n" * 100_000
                  + "f 1 2 4\nf 2 3 4\nf 3 1 4\nf 1 3 2\n")
        self.expect(3, "199999 faces stand twice", "describe", self.of_file("rep.obj"))

    def model(self, name, mesh, more, built, transforms=("1 0 0 0 1 0 0 0 1 0 0 0",)):
        """`mesh` comes in pieces, so that this process stays small: a child begins with its size."""
        items = "".join('<item objectid="%d" transform="%s"/>' % (built, t) for t in transforms)
        with zipfile.ZipFile(self.folder / name, "w", zipfile.ZIP_DEFLATED) as package:
            with package.open("3D/3dmodel.model", "w", force_zip64=True) as text:
                text.write(b'<model unit="millimeter"><resources><object id="1"><mesh>')
                for piece in mesh:
                    text.write(piece.encode())
                text.write(('</mesh></object>%s</resources><build>%s</build></model>' % (more, items)).encode())

    def test_package_that_unpacks_to_much(self):
        self.model("a.3mf", (" " * 1_000_000 for _ in range(900)), "", 1)
        result = self.expect(4, "--input-limit raises", "describe", self.of_file("a.3mf"))
        self.assertLess(result.kilobytes, 200_000)

    def test_model_of_many_vertices(self):
        vertices, triangles = self.TETRAHEDRON_OF_MODEL
        self.model("a.3mf", [vertices, *['<vertex x="0" y="0" z="0"/>' * 10_000] * 300, triangles], "", 1)
        result = self.expect(0, "", "describe", self.of_file("a.3mf"))
        self.assertLess(result.kilobytes, 250_000)  # a vertex takes 24 bytes, and its text 6

    TETRAHEDRON_OF_MODEL = (
        '<vertices>' + "".join('<vertex x="%d" y="%d" z="%d"/>' % p for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))),
        '</vertices><triangles>' + "".join('<triangle v1="%d" v2="%d" v3="%d"/>' % f for f in
                                           ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))) + '</triangles>')

    def test_many_items(self):
        places = (("1 0 0 0 1 0 0 0 1 %d %d %d" % (2 * x, 2 * y, 2 * z)) for x in range(30) for y in range(30)
                  for z in range(30))
        self.model("a.3mf", self.TETRAHEDRON_OF_MODEL, "", 1, list(places))
        self.expect(0, "", "describe", self.of_file("a.3mf"))

    def test_one_mesh_placed_often(self):
        n = 1000  # a roof over a strip of n squares
        vertices = "".join('<vertex x="%d" y="%d" z="%d"/>' % (i, y, z) for i in range(n) for y, z in ((0, 0), (1, 0)))
        triangles = "".join('<triangle v1="%d" v2="%d" v3="%d"/>' % (i, i + 1, i + 2) for i in range(2 * n - 2))
        parts = "".join('<component objectid="1" transform="1 0 0 0 1 0 0 0 1 0 0 %d"/>' % i for i in range(5000))
        self.model("a.3mf", ["<vertices>%s</vertices><triangles>%s</triangles>" % (vertices, triangles)],
                   '<object id="2"><components>%s</components></object>' % parts, 2)
        self.refused("describe", self.of_file("a.3mf"))

    def test_long_json(self):
        with open(self.folder / "a.json", "w") as text:
            text.write('{"findspace": 1, "shapes": {"A": {"points": [')
            for _ in range(200):
                text.write("[1,2]," * 100_000)
            text.write("[1,2]]}}}")
        self.refused("describe", "a.json")

    def test_input_is_counted_over_all_files(self):
        self.file("part.obj", TETRAHEDRON + "# " + "x" * 60_000 + "\n")
        self.scene({"A": {"file": "part.obj"}, "B": {"file": "part.obj"}})
        self.expect(0, "", "describe", "scene.json", "A", "--input-limit", "200K")
        self.expect(4, "--input-limit raises", "describe", "scene.json", "A", "--input-limit", "100K")

    def test_mesh_whose_vertices_are_off(self):
        n, lines = 120, ["solid s"]
        for i in range(n):
            for j in range(n):
                for corners in (((0, 0), (1, 0), (1, 1)), ((0, 0), (1, 1), (0, 1))):
                    lines.append("facet normal 0 0 0\nouter loop")
                    for k, (a, b) in enumerate(corners):
                        off = ((7 * i + 13 * j + 5 * k) % 3 - 1) * 2e-5
                        lines.append("vertex %.5f %.5f %.5f" % (i + a + off, j + b - off, ((i + a) * (j + b) % 7) + off))
                    lines.append("endloop\nendfacet")
        self.file("a.stl", "\n".join(lines + ["endsolid"]))
        self.expect(3, "not closed", "describe", self.of_file("a.stl"))


class Limits(SafetyTest):
    """Limits, signals, and what stands on the disk afterwards."""

    @staticmethod
    def star(n):
        turns = [2 * math.pi * i / n for i in range(n)]
        return [[round((50 + 9 * (i % 3)) * f(t), 4) for f in (math.cos, math.sin)] for i, t in enumerate(turns)]

    def long_scene(self):
        """A map that takes many seconds and much memory."""
        return self.scene({"A": {"polygon": self.star(3000)}, "B": {"polygon": self.star(3003)}}, moving="B",
                          where="gap(B, A) >= 0 and gap(B, A) <= 3")

    def test_time_limit(self):
        self.expect(4, "the time limit is reached, which --time-limit raises; nothing was written", "map", self.long_scene(), "--time-limit", "0.5",
                    "-o", "a.svg")
        self.assertEqual(self.leftovers(), ["scene.json"])

    def test_time_limit_is_kept(self):
        """No timing: the bound is wide, for machines that do much else."""
        scene, begin = self.long_scene(), time.monotonic()
        self.expect(4, "--time-limit raises", "map", scene, "--time-limit", "2")
        self.assertLess(time.monotonic() - begin, 20)

    def test_time_limit_of_what_waits_for_its_reader(self):
        read, write = os.pipe()
        self.addCleanup(os.close, read)
        self.scene({"A": {"points": [[i, i] for i in range(20000)]}})
        child = subprocess.Popen([self.program, "convert", "scene.json", "--json", "--time-limit", "2"], cwd=self.folder,
                                 stdout=write, stderr=subprocess.PIPE)
        os.close(write)
        err = child.communicate(timeout=SECONDS)[1].decode()
        self.assertEqual(child.returncode, 4, err)
        self.assertIn("what was printed is not whole", err)

    @unittest.skipIf(SANITIZED, "limits memory")
    def test_memory_limit(self):
        result = self.expect(4, "the memory limit", "map", self.long_scene(), "--memory-limit", "60M")
        self.assertLess(result.kilobytes, 66 << 10)
        self.assertIn("--memory-limit raises", result.err)
        self.expect(4, "nothing was written", "map", "scene.json", "--memory-limit", "60M", "-o", "a.svg")
        self.assertEqual(self.leftovers(), ["scene.json"])

    def many_shapes(self):
        """Shapes that are built by several threads."""
        shapes = {"S%d" % i: {"polygon": self.star(100 + i)} for i in range(50)}
        return self.scene(shapes, moving="S0", where="gap(S0, S1 + S2 + S3) >= 0")

    @unittest.skipIf(SANITIZED, "limits memory")
    def test_any_memory_limit(self):
        scene = self.many_shapes()
        statuses = set()
        for megabytes in (1, 5, 12, 16, 20, 24, 28, 32, 36, 40, 50, 70, 100, 400):
            result = self.run_program("map", scene, "--threads", "4", "--memory-limit", "%dM" % megabytes)
            self.assertIn(result.status, (0, 4), (megabytes, result.err))
            statuses.add(result.status)
        self.assertEqual(statuses, {0, 4})

    @unittest.skipIf(SANITIZED, "limits memory")
    def test_memory_limit_while_reading(self):
        with open(self.folder / "a.svg", "w") as text:
            text.write('<svg xmlns="http://www.w3.org/2000/svg">')
            for _ in range(200):
                text.write('<path d="M0 0H9V5Z"/>' * 10_000)
            text.write("</svg>")
        result = self.expect(4, "the memory limit", "describe", "a.svg", "--memory-limit", "100M")
        self.assertLess(result.kilobytes, 110 << 10)

    def test_work_limit_is_raised(self):
        scene = self.scene({"A": {"polygon": SQUARE}, "B": {"polygon": SQUARE}}, moving="B",
                           where="gap(B, A+A+A+A) >= 0")
        self.expect(4, "--work-limit raises", "map", scene, "--work-limit", "20000")
        self.expect(0, "", "map", scene, "--work-limit", "40K")

    def test_work_limit_of_searches_is_raised(self):
        tetrahedron = {"offset": 1, "of": {"polytope": [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]]}}
        bowl = {"difference": [{"ball": {"center": [0, 0, 0], "radius": 5}},
                               {"ball": {"center": [0, 0, 2], "radius": 3}}]}
        scene = self.scene({"A": tetrahedron, "B": bowl}, moving="B", where="hausdorff(B,A) <= 5", grid=0.001)
        ask = ("map", scene, "--resolution", "3", "--axis", "x", "--work-limit")
        self.expect(3, "--work-limit raises", *ask, "4K")
        self.expect(0, "", *ask, "20M")

    def test_sizes_that_mean_nothing(self):
        scene = self.scene({"A": {"polygon": SQUARE}})
        for size in ("0", "-1", "1.5G", "12X", "99999999999T", ""):
            self.expect(2, "--memory-limit", "describe", scene, "--memory-limit=" + size)

    def test_placement_ends_in_time(self):
        part = {"polygon": [[0, 0], [7, 1], [9, 5], [4, 3], [1, 9]]}
        scene = self.scene({"A": {"box": {"min": [0, 0], "max": [60, 60]}}, "P": part},
                           place={"shapes": ["P"], "count": {"P": 30}, "each": "inside(self, A)",
                                  "pairs": "gap(self, other) >= 0.1", "minimize": ["x"]})
        result = self.run_program("place", scene, "--time-limit", "2", "--json")
        self.assertIn(result.status, (0, 1, 4), result.err)

    def ended_by(self, number):
        """While it waits for the reader of one output, the other stands under its temporary name."""
        self.scene({"A": {"polygon": SQUARE}})
        os.mkfifo(self.folder / "pipe.svg")
        child = subprocess.Popen([self.program, "convert", "scene.json", "-o", "a.json", "-o", "pipe.svg"],
                                 cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        end = time.monotonic() + SECONDS
        while not any(name.startswith("a.json.") for name in self.leftovers()):
            self.assertIsNone(child.poll(), "it ended too early")
            self.assertLess(time.monotonic(), end)
        child.send_signal(number)
        err = child.communicate(timeout=SECONDS)[1].decode()
        self.assertEqual(child.returncode, 128 + number)
        self.assertIn("nothing was written", err)
        self.assertEqual(self.leftovers(), ["pipe.svg", "scene.json"])

    def test_interrupt_while_writing(self):
        self.ended_by(signal.SIGINT)

    def test_termination_while_writing(self):
        self.ended_by(signal.SIGTERM)

    def test_hangup_while_writing(self):
        self.ended_by(signal.SIGHUP)

    def test_ignored_signals_stay_ignored(self):
        scene = self.long_scene()
        child = subprocess.Popen([self.program, "map", scene, "--time-limit", "2"], stdout=subprocess.DEVNULL,
                                 stderr=subprocess.DEVNULL,
                                 preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        time.sleep(0.5)
        child.send_signal(signal.SIGHUP)
        self.assertEqual(child.wait(timeout=SECONDS), 4)

    def test_mode_is_kept(self):
        scene = self.scene({"A": {"polygon": SQUARE}})
        out = self.file("a.svg", "old")
        out.chmod(0o600)
        self.expect(0, "", "convert", scene, "-o", "a.svg")
        self.assertEqual(stat.S_IMODE(out.stat().st_mode), 0o600)
        self.assertNotEqual(out.read_text(), "old")

    def test_read_only_file_is_not_replaced(self):
        scene = self.scene({"A": {"polygon": SQUARE}})
        out = self.file("a.svg", "old")
        out.chmod(0o444)
        self.expect(3, "Permission denied", "convert", scene, "-o", "a.svg")
        self.assertEqual(out.read_text(), "old")
        self.assertEqual(self.leftovers(), ["a.svg", "scene.json"])

    def test_folder_of_spooled_results(self):
        scene = self.scene({"A": {"box": {"min": [0, 0, 0], "max": [9, 9, 9]}}})
        nowhere = str(self.folder / "nowhere")
        self.expect(3, nowhere, "describe", scene, "--resolution", "64", "--json", env={"TMPDIR": nowhere})
        spool = self.folder / "spool"
        spool.mkdir()
        result = self.expect(0, "", "describe", scene, "--resolution", "64", "--json", env={"TMPDIR": str(spool)})
        self.assertTrue(json.loads(result.out))
        self.assertEqual(list(spool.iterdir()), [])

    def test_spool_without_room(self):
        """A file may grow to 64 KB only, as on a full disk."""
        scene = self.scene({"A": {"ball": {"center": [0, 0, 0], "radius": 9}}})
        result = self.expect(3, str(self.folder), "describe", scene, "--resolution", "256", "--json",
                             env={"TMPDIR": str(self.folder)}, preexec_fn=small_files)
        self.assertEqual(result.out, "")
        self.assertEqual(self.leftovers(), ["scene.json"])

    @unittest.skipUnless(os.geteuid() == 0 and shutil.which("setpriv"), "threads are limited for other users only")
    @unittest.skipIf(SANITIZED, "limits threads")
    def test_threads_that_cannot_be_started(self):
        self.folder.chmod(0o755)
        self.many_shapes().chmod(0o644)
        program = shutil.copy(self.program, self.folder / "findspace")
        os.chmod(program, 0o755)
        result = self.run_program("--reuid=61234", "--clear-groups", program, "map", "scene.json", "--threads", "4",
                                  program="setpriv",
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NPROC, (1, 1)))
        self.assertEqual(result.status, 4, result.err)
        self.assertIn("a thread cannot be started", result.err)


if __name__ == "__main__":
    SafetyTest.program = os.path.abspath(sys.argv.pop(1))
    unittest.main()
