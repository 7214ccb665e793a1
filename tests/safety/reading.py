# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""What a scene may read, and what is shown of files."""

import json
import os
import subprocess
import unittest

from safety_test import SECRET, TETRAHEDRON, SafetyTest


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
