# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""What hostile input may cost."""

import itertools
import json
import math
import unittest
import zipfile

from safety_test import GIGABYTE, SANITIZED, SQUARE, TETRAHEDRON, SafetyTest


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

    def shells(self, name, count):
        """Octahedra one inside the other."""
        rim = ((1, 0), (0, 1), (-1, 0), (0, -1))
        lines = []
        for k in range(count):
            r = 10 + k / 100
            lines += ["v 0 0 %.2f" % r, "v 0 0 %.2f" % -r] + ["v %.2f %.2f 0" % (r * x, r * y) for x, y in rim]
            for a in range(4):
                p, q = 6 * k + 3 + a, 6 * k + 3 + (a + 1) % 4
                lines += ["f %d %d %d" % (6 * k + 1, p, q), "f %d %d %d" % (6 * k + 2, q, p)]
        self.lines(name, lines)

    def test_shells_in_each_other(self):
        self.shells("a.obj", 400)
        scene = self.of_file("a.obj")
        self.expect(3, "lies in another of the same sense", "describe", scene, "--work-limit", "1M")
        self.expect(4, "so many shells in each other costs more", "describe", scene, "--work-limit", "50K")

    def test_needles_that_pass_each_other(self):
        """No plane parts many of them from many others."""
        lines = []
        for k in range(150):
            turn, tilt = 2.4 * k, 0.3 + 2.5 * (k * 0.618 % 1)
            along = (math.cos(turn) * math.sin(tilt), math.sin(turn) * math.sin(tilt), math.cos(tilt))
            off = [math.sin(5.1 * k + 2 * axis) for axis in range(3)]
            for end, wide in ((-9, (0, 0, 0)), (9, (1, 0, 0)), (9, (0, 1, 0)), (9, (0, 0, 1))):
                lines.append("v %.6f %.6f %.6f" % tuple(o + end * a + w / 1e5 for o, a, w in zip(off, along, wide)))
            lines += ["f " + " ".join(str(4 * k + c) for c in f) for f in ((1, 3, 2), (1, 2, 4), (1, 4, 3), (2, 3, 4))]
        self.lines("a.obj", lines)
        few = ("describe", self.of_file("a.obj"), "--resolution", "2", "--work-limit")
        self.expect(0, "", *few, "4M")
        self.expect(4, "so many faces near each other costs more", *few, "20K")

    def test_cone_that_leans(self):
        """Planes part its faces: few pairs of them are looked at."""
        n, lean = 4000, 0.3
        c, s = math.cos(lean), math.sin(lean)
        points = [(0, 0, 50), (0, 0, 0)] + [(10 * math.cos(2 * math.pi * k / n), 10 * math.sin(2 * math.pi * k / n), 0)
                                            for k in range(n)]
        turned = ((c * x + s * z, y, c * z - s * x) for x, y, z in points)
        leaning = ("v %.6f %.6f %.6f" % (x, c * y + s * z, c * z - s * y) for x, y, z in turned)
        faces = ("f %d %d %d" % corners for k in range(n)
                 for corners in ((1, 3 + k, 3 + (k + 1) % n), (2, 3 + (k + 1) % n, 3 + k)))
        self.lines("a.obj", itertools.chain(leaning, faces))
        self.expect(0, "", "describe", self.of_file("a.obj"), "--resolution", "4", "--work-limit", "100K")

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
