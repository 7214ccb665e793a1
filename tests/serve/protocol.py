#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""`findspace serve --stdio` as programs meet it, and the description of its requests.

usage: protocol.py PROGRAM

docs/protocol.json is what `rpc.discover` says; `protocol.py PROGRAM --write` writes it anew."""
import json
import math
import os
import subprocess
import sys
import tempfile
import time
import unittest

import jsonschema

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PEG = os.path.join(ROOT, "examples", "peg.json")
DESCRIPTION = os.path.join(ROOT, "docs", "protocol.json")
PROGRAM = ""


def serve(lines, *arguments):
    """The answers to requests, given as objects or as text, and the exit status."""
    text = "".join((line if isinstance(line, str) else json.dumps(line)) + "\n" for line in lines)
    done = subprocess.run([PROGRAM, "serve", "--stdio", *arguments], input=text, capture_output=True, text=True)
    return [json.loads(line) for line in done.stdout.splitlines()], done.returncode


def ask(method, scene=PEG, **parameters):
    """The result of one request; of an error, the error."""
    answers, status = serve([{"jsonrpc": "2.0", "id": 1, "method": method, "params": parameters}], scene)
    assert status == 0 and len(answers) == 1, (answers, status)
    return answers[0].get("result", answers[0].get("error"))


def verb(*arguments):
    return json.loads(subprocess.run([PROGRAM, *arguments, "--json"], capture_output=True, text=True).stdout)


def description():
    return ask("rpc.discover")


class Answers(unittest.TestCase):
    def test_description_is_the_documented_one(self):
        with open(DESCRIPTION, encoding="utf-8") as file:
            self.assertEqual(json.load(file), description())

    def test_parameters_are_schemas_that_requests_meet(self):
        of = {m["name"]: m["params"] for m in description()["methods"]}
        for schema in of.values():
            jsonschema.Draft202012Validator.check_schema(schema)
        jsonschema.validate({"at": [1, "2.5"], "snap": 1}, of["check"])
        for wrong in ({}, {"at": [1]}, {"at": [1, 2], "att": 1}, {"at": [1, 2], "nearest": 1}, {"at": [1, 2], "snap": "1"}):
            with self.assertRaises(jsonschema.ValidationError):
                jsonschema.validate(wrong, of["check"])
            self.assertEqual(ask("check", **wrong)["code"], -32602, wrong)

    def test_answers_are_those_of_the_verbs(self):
        at = "10.5,12"
        position = [10.5, "12"]
        self.assertEqual(ask("map"), verb("map", PEG))
        self.assertEqual(ask("measure", at=position), verb("measure", PEG, "--at", at))
        self.assertEqual(ask("check", at=position), verb("check", PEG, "--at", at))
        self.assertEqual(ask("check", at=[1, 1], nearest=True), verb("check", PEG, "--at", "1,1"))
        self.assertEqual(ask("explain"), verb("explain", PEG))
        self.assertEqual(ask("explain", at=[1, 1]), verb("explain", PEG, "--at", "1,1"))
        near = verb("check", PEG, "--at", "1,1")["nearest_feasible"]
        self.assertEqual(ask("nearest", at=[1, 1])["nearest_feasible"], near)

    def test_numbers_are_exact(self):
        # The peg fits the hole at 50, 30 only: no double is nearer to 0.1 than its decimal.
        for at, holds in (([50, 30], True), (["50.00000000000000000001", 30], False), (["5e1", "30.0"], True)):
            self.assertEqual(ask("check", at=at)["true"], holds)

    def test_snap_is_about_the_exact_place(self):
        answer = ask("check", at=[50.3, 30.2], snap=1)
        self.assertEqual((answer["at"], answer["true"]), ([50, 30], True))
        answer = ask("check", at=[50.3, 30.2], snap=0.1)
        self.assertEqual((answer["at"], answer["true"]), ([50.3, 30.2], False))

    def test_snap_prefers_corners_then_edges(self):
        # The region around the plate: from inside it, too, the part goes to a corner or an edge that is near.
        for at, snap, to in (([6.2, 4.3], 0.5, [6.05, 4.15]), ([6.2, 30], 0.5, [6.05, 30]), ([10, 30], 0.5, [10, 30])):
            answer = ask("check", at=at, snap=snap)
            self.assertEqual((answer["at"], answer["true"]), (to, True))

    def test_angles_and_instants(self):
        turn, carts, leaf = (os.path.join(ROOT, "examples", name) for name in ("turn.json", "carts.json", "door-leaf.json"))
        stack = {p["angle"]: p["region"]["area"] for p in verb("map", turn)["poses"]}
        for angle in (0, 30, 90):
            self.assertEqual(ask("map", scene=turn, angle=angle)["area"], stack[angle])
        for at in ("20,20", "40,30"):
            asked = ask("check", scene=turn, at=[float(c) for c in at.split(",")], angle="30")
            given = verb("check", turn, "--at", at, "--angle", "30")
            self.assertEqual([(a["text"], a["value"], a["true"]) for a in asked["atoms"]],
                             [(a["text"], a["value"], a["true"]) for a in given["atoms"]])
        self.assertEqual(ask("angles", scene=leaf, at=[0, 0]), verb("map", leaf))
        # All angles together, as the verb: there is one at which the leaf stands, though not as it is drawn.
        for at in ([0, 0], [1, 0.5]):
            self.assertEqual(ask("explain", scene=leaf, at=at), verb("explain", leaf, "--at", ",".join(map(str, at))))
        self.assertEqual(ask("explain", scene=leaf), verb("explain", leaf))
        self.assertEqual(ask("explain", scene=leaf, at=[0, 0], angle=30), verb("explain", leaf, "--at", "0,0", "--angle", "30"))
        self.assertEqual(ask("check", scene=carts, at=[5, 2], time=3)["atoms"],
                         verb("check", carts, "--at", "5,2", "--time", "3")["atoms"])
        self.assertEqual(ask("check", scene=carts, at=[5, 2])["true"], verb("check", carts, "--at", "5,2")["true"])
        self.assertEqual(ask("check", scene=carts, at=[5, 2], time=12)["code"], -32000)
        self.assertEqual(ask("check", scene=PEG, at=[5, 2], time=1)["code"], -32000)

    def test_angles_on_a_board_count_as_the_verbs_count_them(self):
        corner = "(xy 0 0) (xy 4 0) (xy 4 1) (xy 1 1) (xy 1 3) (xy 0 3)"
        text = ('(kicad_pcb (version 20211014) (layers (0 "F.Cu" signal))\n(gr_rect (start 0 0) (end 20 20) (layer "Edge.Cuts"))\n'
                '(footprint "F" (layer "F.Cu") (at 5 5) (fp_text reference "U1" (at 0 0))\n'
                f'(fp_poly (pts {corner}) (layer "F.CrtYd"))))\n')
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "b.kicad_pcb")
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            of = ["--move", "U1", "--where", "inside(U1, board)"]
            requests = [("scene", {}), ("map", {"angle": 90}), ("check", {"at": [1, 10], "angle": 90}), ("angles", {"at": [1, 10]}),
                        ("check", {"at": [10, 2], "angle": 90}), ("explain", {"at": [10, 2], "angle": 90})]
            answers, _ = serve([{"id": k, "method": m, "params": p} for k, (m, p) in enumerate(requests)], path, *of)
            scene, region, good, angles, bad, why = (a["result"] for a in answers)
            self.assertEqual((scene["y"], scene["clockwise"]), ("down", False))
            # Seen from its anchor the part goes 3 to the right and 4 upwards then.
            self.assertEqual(region["bbox"], [[0, 4], [17, 20]])
            self.assertEqual((good["true"], bad["true"], why["check"]["true"]), (True, False, False))
            among = [any((angle - i["from"]) % 360 <= i["to"] - i["from"] for i in angles["intervals"]) for angle in (90, 270)]
            self.assertEqual(among, [True, False], angles)
            self.assertEqual(region["area"], verb("map", path, *of, "--free", "0,90")["poses"][1]["region"]["area"])
        self.assertEqual(ask("scene")["clockwise"], False)

    def test_operations_on_the_region(self):
        for operation in ("interior", "closure", "boundary", "regularize", "complement"):
            self.assertEqual(ask("map", apply=operation), verb("map", PEG, "--apply", operation))
        self.assertEqual(ask("map", apply="inside")["code"], -32602)

    def test_features_are_measured(self):
        answer = ask("between", **{"from": [25, 12], "to": [44, 30], "at": [10, 30]})
        self.assertEqual((answer["from"], answer["distance"]), ({"shape": "plate", "vertex": [25, 12]}, math.hypot(18.95, 13.85)))
        self.assertEqual(answer["to"], {"shape": "plate", "edge": [[43.95, 25.85], [43.95, 34.15]]})
        moving = ask("between", **{"from": [16.05, 30], "to": [25, 30], "at": [10, 30]})
        self.assertEqual((moving["from"]["shape"], moving["to"]["shape"], moving["distance"]), ("peg", "plate", 8.95))
        turn = os.path.join(ROOT, "examples", "turn.json")
        arcs = ask("between", scene=turn, **{"from": [24, 15], "to": [56, 15]})
        self.assertEqual((arcs["from"]["arc"], arcs["distance"], arcs["points"]),
                         ({"center": [20, 15], "radius": 4}, 32, [[24, 15], [56, 15]]))

    def test_space(self):
        rooms = os.path.join(ROOT, "examples", "rooms.json")
        self.assertEqual(ask("map", scene=rooms), verb("map", rooms))
        self.assertEqual(ask("check", scene=rooms, at=[20, 1, 0], nearest=True), verb("check", rooms, "--at", "20,1,0"))
        self.assertEqual(ask("check", scene=rooms, at=[12.1, 0, 0], snap=0.2)["at"], [12, 0, 0])
        drawing = ask("map", scene=rooms, drawing=True)["drawing"]
        self.assertEqual((drawing["points"], len(drawing["curves"]), len(drawing["sheets"]) > 0), ([[12, 0, 0]], 1, True))
        self.assertTrue(all(len(face) == 4 for face in drawing["faces"]))
        self.assertEqual(ask("check", scene=rooms, at=[1, 2])["code"], -32000)
        self.assertEqual(ask("explain", scene=rooms), verb("explain", rooms))
        self.assertEqual(ask("explain", scene=rooms, at=[4, 1, 0]), verb("explain", rooms, "--at", "4,1,0"))
        self.assertEqual(ask("instants", scene=rooms, at=[1, 2, 3])["data"]["kind"], "unsupported")
        ball = {"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0, 0], "max": [4, 4, 4]}}, "B": {"ball": {"center": [0, 0, 0], "radius": 1}}},
                "moving": "B", "where": "clear(B, A) and reach(B, A) <= 12"}
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "ball.json")
            with open(path, "w", encoding="utf-8") as file:
                json.dump(ball, file)
            lines = ask("map", scene=path, drawing=True, resolution=16)
            self.assertFalse(lines["empty"])
            self.assertTrue(len(lines["drawing"]["faces"]) > 100)

    def test_a_placement_near_what_stands(self):
        scene = os.path.join(ROOT, "examples", "components.json")
        free = ask("place", scene=scene)["positions"]
        stands = {p["shape"]: p for p in free}
        near = [{"shape": p["shape"], "at": p["at"], **({"angle": p["angle"]} if "angle" in p else {})} for p in free]
        self.assertEqual(ask("place", scene=scene, near=near)["positions"], free)
        # Moved into the memory's place: the processor has it, the memory goes aside, and all conditions hold.
        moved = [{"shape": "processor", "at": stands["memory"]["at"]}] + [n for n in near if n["shape"] != "processor"]
        answer = ask("place", scene=scene, near=moved)
        self.assertEqual([p["shape"] for p in answer["positions"]], ["processor", "memory", "regulator", "connector"])
        at = {p["shape"]: p["at"] for p in answer["positions"]}
        self.assertLess(math.dist(at["processor"], stands["memory"]["at"]), 4)
        self.assertNotEqual(at["memory"], stands["memory"]["at"])
        self.assertTrue(max(abs(a - b) for a, b in zip(at["memory"], at["processor"])) >= 10.8)
        for wrong in ([{"shape": "board", "at": [1, 2]}], [{"shape": "memory", "at": [1, 2, 3]}], [{"shape": "memory", "at": [1, 2], "angle": 45}]):
            self.assertEqual(ask("place", scene=scene, near=wrong)["code"], -32000)
        crates = os.path.join(ROOT, "examples", "crates.json")
        found = ask("place", scene=crates, near=[{"shape": "piano", "at": [0, 0, 20]}])["positions"]
        self.assertEqual(found[0], {"shape": "piano", "at": [0, 0, 20]})

    def placed_near(self, place, near):
        unit, room = {"box": {"min": [0, 0], "max": [1, 1]}}, {"box": {"min": [0, 0], "max": [20, 20]}}
        bar = {"box": {"min": [0, 0], "max": [4, 1]}}
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "copies.json")
            with open(path, "w", encoding="utf-8") as file:
                json.dump({"findspace": 1, "shapes": {"unit": unit, "bar": bar, "room": room}, "place": place}, file)
            return [(p["copy"], p["at"], p.get("angle", 0)) for p in ask("place", scene=path, near=near)["positions"]]

    def test_copies_near_what_stands(self):
        # One copy stands at its second angle: the others look at their own ones.
        bars = {"shapes": ["bar"], "count": 3, "angles": [0, 90], "each": "inside(self, room)",
                "pairs": "clear(self, other)", "minimize": ["-x", "y"]}
        self.assertEqual(self.placed_near(bars, [{"shape": "bar", "copy": 1, "at": [8, 0], "angle": 90}]),
                         [(1, [8, 0], 90), (2, [20, 0], 90), (3, [20, 4], 90)])
        # The first copy comes before the second, and the third after it, whichever stands first.
        units = {"shapes": ["unit"], "count": 3, "each": "inside(self, room)",
                 "pairs": "clear(self, other) and not (0 < gap(self, other, toward=(1, 0)) < 2)",
                 "minimize": ["y", "distance to [6, 0]"]}
        self.assertEqual(self.placed_near(units, [{"shape": "unit", "copy": 2, "at": [4, 0]}]),
                         [(2, [4, 0], 0), (1, [5, 0], 0), (3, [6, 0], 0)])

    def test_a_placement_that_is_stopped_is_no_proof(self):
        # Two rings of three: the positions of the second are found again for every shape of the first that is placed.
        shapes, clear = {}, []
        for ring in "AD":
            shapes[ring + "1"] = {"polygon": [[0, 0], [2, 0], [1, 2]]}
            shapes[ring + "2"] = {"box": {"min": [0, 0], "max": [2, 1]}}
            shapes[ring + "3"] = {"box": {"min": [0, 0], "max": [1, 2]}}
            clear += [f"clear({ring}{i}, {ring}{j})" for i, j in ((1, 2), (1, 3), (2, 3))]
        place = {"shapes": list(shapes), "method": "simultaneous", "each": "inside(self, C)", "constraints": clear,
                 "minimize": ["x"]}
        shapes["C"] = {"box": {"min": [0, 0], "max": [4, 4]}}
        scene = json.dumps({"findspace": 1, "shapes": shapes, "place": place})

        def status(*limit):
            return subprocess.run([PROGRAM, "place", "-", "--json", "--threads", "1", *limit], input=scene,
                                  capture_output=True, text=True).returncode
        began = time.monotonic()
        self.assertEqual(status(), 0)
        whole = time.monotonic() - began
        for part in range(10, 18):
            self.assertIn(status("--time-limit", f"{whole * part / 20:.4f}"), (0, 4))

    def test_copies_and_texts(self):
        answers, status = serve([
            {"id": 1, "method": "copy", "params": {"as": "mine"}},
            {"id": 2, "method": "set", "params": {"scene": "mine", "where": "gap(peg, plate) >= \"quoted\""}},
            {"id": 3, "method": "set", "params": {"scene": "mine", "where": "gap(peg, plate) >= 3", "moving": ["peg"]}},
            {"id": 4, "method": "scene"},
            {"id": 5, "method": "source", "params": {"scene": "mine"}},
        ], PEG)
        self.assertEqual((status, "error" in answers[1]), (0, True))
        self.assertEqual(answers[3]["result"]["where"], "inside(peg, table) and clear(peg, plate)")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "again.json")
            with open(path, "w", encoding="utf-8") as file:
                file.write(answers[4]["result"]["text"])
            again = ask("scene", scene=path)
        self.assertEqual((again["where"], again["moving"]), ("gap(peg, plate) >= 3", ["peg"]))

    def test_placements(self):
        components = os.path.join(ROOT, "examples", "components.json")
        self.assertEqual(ask("place", scene=components), verb("place", components))
        self.assertEqual(ask("place")["code"], -32000)

    def test_packings_go_on_beside_requests(self):
        problem = os.path.join(ROOT, "tests", "data", "nesting", "fu.json")
        server = subprocess.Popen([PROGRAM, "serve", "--stdio", problem], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

        def answer(method, **parameters):
            server.stdin.write(json.dumps({"id": 1, "method": method, "params": parameters}) + "\n")
            server.stdin.flush()
            return json.loads(server.stdout.readline())["result"]

        parts = answer("pack", threads=1, seed=3)
        self.assertEqual((parts["items"], len(parts["parts"])), (12, 12))
        state = answer("packing")
        while "layout" not in state:
            state = answer("packing")
        self.assertTrue(state["running"])
        self.assertTrue(state["layout"]["proven"])
        stopped = answer("stop")
        self.assertFalse(stopped["running"])
        self.assertLessEqual(float(stopped["layout"]["length"]), float(state["layout"]["length"]))
        repaired = answer("repair", item=0, at=[8, 3])
        self.assertTrue(repaired["layout"]["proven"])
        self.assertEqual(repaired["number"], stopped["number"] + 1)
        self.assertNotIn("layout", answer("packing", since=repaired["number"]))
        server.stdin.close()
        self.assertEqual(server.wait(), 0)
        server.stdout.close()

    def test_packings_on_sheets_and_in_boxes(self):
        square = {"shape": {"type": "simple_polygon", "data": [[0, 0], [3, 0], [3, 3], [0, 3]]}}
        items = [{"id": "tile", "demand": 2, **square}]
        sheets = {"name": "kit", "sheets": [{"id": "plate", "width": 9, "height": 4, "count": 2}], "items": items}
        at = [{"part": "tile", "copy": 1, "sheet": 0, "angle": 0, "at": ["0", "0"]}, {"part": "tile", "copy": 2, "sheet": 1, "angle": 0, "at": ["0", "0"]}]
        layout = {"layout": {"container": {"sheets": ["plate", "plate"]}, "length": "3", "items": at}}
        box = {"name": "kit", "box": True, "items": items}
        nothing = {"layout": {"container": {"sheets": []}, "length": "0", "items": [], "left_out": [{"part": "tile", "copies": 2, "why": ""}]}}
        requests = [
            {"id": 1, "method": "pack", "params": {"text": json.dumps(sheets), "drawing": True, "search": False, "start": json.dumps(layout)}},
            {"id": 2, "method": "verify", "params": {"item": 1, "at": [1, 1], "sheet": 0}},
            {"id": 3, "method": "verify", "params": {"item": 1, "at": [4, 1], "sheet": 0}},
            {"id": 4, "method": "repair", "params": {"item": 1, "at": [4, 1], "sheet": 0}},
            {"id": 5, "method": "repair", "params": {"item": 1, "at": [0, 0], "sheet": 5}},
            {"id": 6, "method": "pack", "params": {"text": json.dumps(box), "search": False, "scene": "box"}},
            {"id": 7, "method": "pack", "params": {"start": json.dumps(nothing), "search": False}},
            {"id": 8, "method": "verify"},
            {"id": 9, "method": "repair", "params": {"item": 0, "at": [0, 0]}},
        ]
        lines = "".join(json.dumps({"jsonrpc": "2.0", **r}) + "\n" for r in requests)
        run = subprocess.run([PROGRAM, "serve", "--stdio"], input=lines, capture_output=True, text=True, timeout=120)
        loaded, overlaps, free, made, missing, boxed, _, judged, none = [json.loads(line) for line in run.stdout.splitlines()]
        self.assertEqual([(s["name"], s["count"], s["zones"]) for s in loaded["result"]["sheets"]], [("plate", 2, "")])
        self.assertTrue(loaded["result"]["sheets"][0]["drawing"].startswith("M0,"))
        self.assertFalse(overlaps["result"]["verdict"]["feasible"])
        self.assertTrue(free["result"]["verdict"]["feasible"])
        self.assertEqual(made["result"]["layout"]["container"], {"sheets": ["plate"]})
        self.assertEqual([i["at"] for i in made["result"]["layout"]["items"]], [["0", "0"], ["4", "1"]])
        self.assertIn("no sheet 5", missing["error"]["message"])
        self.assertIs(boxed["result"]["box"], True)
        self.assertEqual((judged["result"]["verdict"]["feasible"], judged["result"]["verdict"]["items"]), (True, 0))
        self.assertEqual(none["error"]["message"], "the layout has no items")

    def test_packings_of_solids(self):
        def block(x, y, z):
            return {"box": {"min": [0, 0, 0], "max": [x, y, z]}}

        problem = {"name": "two", "container": {"size-x": 2, "size-y": 2},
                   "item-types": [{"id": "low", "demand": 1, "shape": block(2, 2, 1)}, {"id": "cube", "demand": 1, "shape": block(1, 1, 1)}]}
        layout = {"findspace": 1, "layout": {
            "instance": "two", "height": "3", "items": [{"part": "low", "copy": 1, "at": ["0", "0", "0"]},
                                                        {"part": "cube", "copy": 1, "at": ["0", "0", "2"]}], "left_out": []}}
        overlapping = json.dumps(layout).replace('"2"]', '"0.5"]')
        answers, status = serve([
            {"id": 1, "method": "pack", "params": {"text": json.dumps(problem), "drawing": True, "search": False}},
            {"id": 2, "method": "pack", "params": {"start": json.dumps(layout), "search": False}},
            {"id": 3, "method": "packing"},
            {"id": 4, "method": "verify"},
            {"id": 5, "method": "verify", "params": {"item": 1, "at": [0, 0, 0.75]}},
            {"id": 6, "method": "verify", "params": {"item": 1, "at": [1, 0, "99.5"]}},
            {"id": 7, "method": "repair", "params": {"item": 1, "at": [1, 0, "1.5"]}},
            {"id": 8, "method": "repair", "params": {"item": 1, "at": [1, 0]}},
            {"id": 9, "method": "verify", "params": {"item": 1}},
            {"id": 10, "method": "pack", "params": {"start": overlapping, "search": False}},
        ])
        self.assertEqual(status, 0)
        results = [a.get("result") for a in answers]
        self.assertEqual((results[0]["dimension"], results[0]["floor"], len(results[0]["parts"][1]["drawing"]["faces"])), (3, [2, 2], 6))
        self.assertEqual((results[2]["running"], results[2]["height"], results[2]["number"]), (False, 3, 1))
        self.assertTrue(results[3]["verdict"]["feasible"])
        fault = results[4]["verdict"]["faults"][0]
        self.assertEqual((results[4]["verdict"]["feasible"], fault["kind"], fault["of"]), (False, "overlap", ["low#1", "cube#1"]))
        self.assertTrue(results[5]["verdict"]["feasible"])
        self.assertEqual((results[6]["layout"]["height"], results[6]["layout"]["items"][1]["at"]), ("2.5", ["1", "0", "1.5"]))
        self.assertEqual([answers[k]["error"]["code"] for k in (7, 8, 9)], [-32000, -32602, -32000])

    def test_solids_go_into_another_container(self):
        def cube(side):
            return {"box": {"min": [0, 0, 0], "max": [side, side, side]}}

        problem = {"name": "two", "containers": [{"id": "crate", "count": 2, "size-x": 2, "size-y": 2, "size-z": 4}],
                   "item-types": [{"id": "small", "demand": 1, "shape": cube(1)}, {"id": "large", "demand": 1, "shape": cube(2)}]}
        layout = {"layout": {"container": {"containers": ["crate", "crate"]}, "height": "2", "items": [
            {"part": "small", "copy": 1, "container": 0, "at": ["0", "0", "3"]},
            {"part": "large", "copy": 1, "container": 1, "at": ["0", "0", "0"]}]}}
        answers, status = serve([
            {"id": 1, "method": "pack", "params": {"text": json.dumps(problem), "search": False, "start": json.dumps(layout)}},
            {"id": 2, "method": "verify", "params": {"item": 0, "at": [0, 0, 3], "container": 1}},
            {"id": 3, "method": "verify", "params": {"item": 0, "at": [0, 0, "3.5"], "container": 1}},
            {"id": 4, "method": "repair", "params": {"item": 0, "at": [0, 0, 3], "container": 1}},
        ])
        self.assertEqual(status, 0)
        free, through_the_lid, made = [a["result"] for a in answers[1:]]
        self.assertTrue(free["verdict"]["feasible"])
        self.assertEqual(through_the_lid["verdict"]["faults"][0]["kind"], "outside")
        self.assertEqual((made["layout"]["height"], made["layout"]["items"][0]["at"]), ("4", ["0", "0", "3"]))

    def test_a_layout_alone_says_what_it_needs(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "layout.json")
            with open(path, "w", encoding="utf-8") as file:
                file.write('{"findspace": 1, "layout": {"items": []}}')
            done = subprocess.run([PROGRAM, "view", path, "--no-open"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("findspace view PROBLEM --start LAYOUT", done.stderr)

    def test_scenes_stay_loaded(self):
        answers, status = serve([
            {"id": 1, "method": "load", "params": {"scene": "a", "path": "peg.json"}},
            {"id": 2, "method": "set", "params": {"scene": "a", "where": "gap(peg, plate) >= 100"}},
            {"id": 3, "method": "check", "params": {"scene": "a", "at": [10, 12]}},
            {"id": 4, "method": "check", "params": {"at": [10, 12]}},
            {"id": 5, "method": "set", "params": {"scene": "a", "where": "gap(peg, plte) >= 1"}},
            {"id": 6, "method": "check", "params": {"scene": "a", "at": [200, 12]}},
            {"id": 7, "method": "set", "params": {"scene": "a", "moving": ["plate"], "where": "inside(plate, table)"}},
            {"id": 8, "method": "unload", "params": {"scene": "a"}},
            {"id": 9, "method": "map", "params": {"scene": "a"}},
        ], PEG)
        self.assertEqual((status, [a["id"] for a in answers]), (0, list(range(1, 10))))
        self.assertEqual([answers[k]["result"]["true"] for k in (2, 3, 5)], [False, True, True])
        error = answers[4]["error"]
        self.assertEqual((error["code"], error["data"]["line"], error["data"]["column"]), (-32000, 1, 10))
        self.assertEqual(answers[6]["result"]["moving"], ["plate"])
        self.assertEqual(answers[8]["error"]["code"], -32602)

    def test_a_mistake_changes_nothing(self):
        answers, _ = serve([
            {"id": 1, "method": "load", "params": {"path": "peg.json"}},
            {"id": 2, "method": "set", "params": {"moving": ["plate"], "where": "inside(plate, tabel)"}},
            {"id": 3, "method": "scene"},
            {"id": 4, "method": "set", "params": {"moving": ["plate"], "where": "inside(plate, table)"}},
        ], PEG)
        self.assertIn("error", answers[1])
        self.assertEqual(answers[2]["result"]["moving"], ["peg"])
        self.assertEqual(answers[3]["result"]["moving"], ["plate"])

    def test_a_limit_is_named(self):
        many = {"findspace": 1, "shapes": {"a": {"points": [[k, 0] for k in range(10000)]}}}
        answers, _ = serve([{"id": 1, "method": "load", "params": {"text": json.dumps(many)}}], PEG, "--work-limit", "10000")
        self.assertEqual((answers[0]["error"]["code"], answers[0]["error"]["data"]["kind"]), (-32001, "limit"), answers)

    def test_batches_notifications_and_mistakes(self):
        answers, status = serve([
            '[{"id": "a", "method": "ping"}, {"method": "ping"}, {"id": 2, "method": "nothing"}]',
            '{"method": "ping"}', "", "nonsense", "[]", "7", '{"id": 3}',
        ])
        self.assertEqual(status, 0)
        self.assertEqual([a["id"] for a in answers[0]], ["a", 2])
        self.assertEqual(answers[0][1]["error"]["code"], -32601)
        self.assertEqual([a["error"]["code"] for a in answers[1:]], [-32700, -32600, -32600, -32600])

    def test_mistakes_name_what_is_meant(self):
        (none,), _ = serve([{"id": 1, "method": "check", "params": {"at": [1, 2]}}])
        self.assertEqual(none["error"]["message"], "no scene 'scene' is loaded; 'load' comes first")
        answers, _ = serve([
            {"id": 3, "method": "chek"},
            {"id": 4, "method": "frobnicate"},
            {"id": 5, "method": "scene", "params": {"scene": "other"}},
            {"id": 6, "method": "check", "params": {"at": ["a", 2]}},
            {"id": 7, "method": "check", "params": {"at": [1, 2], "angle": "90deg"}},
            {"id": 8, "method": "map", "params": {"resolution": 0}},
            {"id": 9, "method": "map", "params": {"resolution": 5000}},
            {"id": 10, "method": "place", "params": {"seconds": -1}},
        ], PEG)
        said = [a["error"]["message"] for a in answers]
        self.assertEqual(said[0], "there is no method 'chek'; did you mean 'check'?")
        self.assertIn("the methods are load, scene, copy", said[1])
        self.assertEqual(said[2], "no scene 'other' is loaded; loaded: 'scene'")
        self.assertEqual(said[3], "\"at\": \"a\" is not a decimal number")
        self.assertEqual(said[4], "\"angle\": \"90deg\" is not a decimal number")
        self.assertEqual(said[5:7], ["\"resolution\" is a whole number from 1 to 1024"] * 2)
        self.assertEqual(said[7], "\"seconds\" is a number from 0 on")

    def test_files_lie_below_the_folder(self):
        for path in ("../README.md", "/etc/passwd", "../examples/../README.md"):
            self.assertEqual(ask("load", scene=PEG, path=path)["data"]["kind"], "file", path)
        with tempfile.TemporaryDirectory() as folder:
            os.symlink("/etc/hostname", os.path.join(folder, "link.json"))
            with open(os.path.join(folder, "scene.json"), "w", encoding="utf-8") as file, open(PEG, encoding="utf-8") as peg:
                file.write(peg.read())
            scene = os.path.join(folder, "scene.json")
            self.assertEqual(ask("load", scene=scene, path="link.json")["data"]["kind"], "file")
        with tempfile.TemporaryDirectory() as folder:
            os.mkdir(os.path.join(folder, "served"))
            with open(os.path.join(folder, "shape.wkt"), "w", encoding="utf-8") as file:
                file.write("POLYGON ((0 0, 1 0, 0 1, 0 0))")
            scene = os.path.join(folder, "served", "scene.json")
            with open(scene, "w", encoding="utf-8") as file:
                json.dump({"findspace": 1, "shapes": {"A": {"file": "../shape.wkt"}}, "moving": "A"}, file)
            self.assertEqual(serve([], scene), ([], 3))
            self.assertEqual(serve([], scene, "--root", folder), ([], 0))
            self.assertEqual(serve([], scene, "--root", folder, "--no-files")[1], 2)
            asked = {"jsonrpc": "2.0", "id": 1, "method": "load", "params": {"path": "served/scene.json"}}
            self.assertIn("result", serve([asked], "--root", folder)[0][0])
            self.assertIn("error", serve([asked | {"params": {"path": "scene.json"}}], "--root",
                                         os.path.dirname(scene))[0][0])
        text = json.dumps({"findspace": 1, "shapes": {"A": {"file": "peg.json"}}, "moving": "A"})
        self.assertIn("error", ask_raw("load", text=text))

    def test_limits(self):
        answers, status = serve(['{"id": 1, "method": "ping", "params": "' + "x" * (64 << 20) + '"}', {"id": 2, "method": "ping"}])
        self.assertEqual((answers[0]["error"]["code"], answers[1]["result"], status), (-32001, {}, 0))
        # Two stars of 2000 corners: their sum takes far longer than the limit.
        star = [[round(math.cos(math.pi * k / 2000) * r), round(math.sin(math.pi * k / 2000) * r)]
                for k in range(4000) for r in ((900000, 400000)[k % 2],)]
        shapes = {"A": {"polygon": star}, "B": {"polygon": star}}
        with tempfile.TemporaryDirectory() as folder:
            scene = os.path.join(folder, "stars.json")
            with open(scene, "w", encoding="utf-8") as file:
                json.dump({"findspace": 1, "shapes": shapes, "moving": "B", "where": "gap(B, A) >= 1"}, file)
            answers, status = serve([{"id": 1, "method": "map"}], "--time-limit", "0.1", scene)
        self.assertEqual((answers[0]["id"], answers[0]["error"]["code"], status), (1, -32001, 4))

    def test_model_context_protocol(self):
        answers, status = serve([
            {"jsonrpc": "2.0", "id": 0, "method": "initialize", "params": {"protocolVersion": "2025-06-18"}},
            {"jsonrpc": "2.0", "method": "notifications/initialized"},
            {"jsonrpc": "2.0", "id": 1, "method": "tools/list"},
            {"jsonrpc": "2.0", "id": 2, "method": "tools/call", "params": {"name": "check", "arguments": {"at": [10, 12]}}},
            {"jsonrpc": "2.0", "id": 3, "method": "tools/call", "params": {"name": "set", "arguments": {"where": "gap("}}},
            {"jsonrpc": "2.0", "id": 4, "method": "tools/call", "params": {"name": "nothing"}},
        ], PEG)
        self.assertEqual((status, len(answers)), (0, 5))
        self.assertEqual(answers[0]["result"]["serverInfo"]["name"], "findspace")
        tools = {t["name"]: t["inputSchema"] for t in answers[1]["result"]["tools"]}
        self.assertEqual(tools, {m["name"]: m["params"] for m in description()["methods"]})
        called = answers[2]["result"]
        self.assertEqual(json.loads(called["content"][0]["text"]), called["structuredContent"])
        self.assertEqual((called["isError"], called["structuredContent"]["true"]), (False, True))
        self.assertTrue(answers[3]["result"]["isError"])
        self.assertEqual(answers[4]["error"]["code"], -32601)


def ask_raw(method, **parameters):
    return serve([{"id": 1, "method": method, "params": parameters}], PEG)[0][0]


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    if sys.argv[1:] == ["--write"]:
        with open(DESCRIPTION, "w", encoding="utf-8") as out:
            out.write(json.dumps(description(), indent=1) + "\n")
    else:
        unittest.main()
