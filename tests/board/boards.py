#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Boards through the program: one board in the formats of KiCad 5 to 9, malformed boards, and copies with moved parts.

    boards.py PROGRAM

The board is written here in all five formats. Each has to give the same positions, so what differs between formats is
read right. Malformed boards end with status 3 and say place and reason, and no file is written.
"""

import json
import os
import random
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop(1)

# Two parts of 4 x 2 mm at (10, 10), turned by 90 degrees, and at (20, 10); a disc on the back; one keep-out; one track.
FORMATS = {
    5: dict(version=20171130, part="module R (layer {layer})", mark="(tedit 5E0) (tstamp 5E1)", quote="",
            reference='(fp_text reference {name} (at 0 -2{turn}) (layer F.SilkS) (effects (font (size 1 1))))',
            stroke="(width 0.05)", layers='(0 F.Cu signal) (31 B.Cu signal) (44 Edge.Cuts user)'),
    6: dict(version=20211014, part='footprint "R" (layer "{layer}")', mark="(tedit 5E0) (tstamp 0a-1)", quote='"',
            reference='(fp_text reference "{name}" (at 0 -2{turn}) (layer "F.SilkS") (tstamp 0a-2))',
            stroke="(width 0.05) (tstamp 0a-3)",
            layers='(0 "F.Cu" signal) (31 "B.Cu" signal) (44 "Edge.Cuts" user)'),
    7: dict(version=20221018, part='footprint "R" (layer "{layer}")', mark="(tstamp 0a-1)", quote='"',
            reference='(fp_text reference "{name}" (at 0 -2{turn}) (layer "F.SilkS") (tstamp 0a-2))',
            stroke="(stroke (width 0.05) (type solid)) (tstamp 0a-3)",
            layers='(0 "F.Cu" signal) (31 "B.Cu" signal) (44 "Edge.Cuts" user)'),
    8: dict(version=20240108, part='footprint "R" (layer "{layer}")', mark='(uuid "0a-1")', quote='"',
            reference='(property "Reference" "{name}" (at 0 -2{turn}) (layer "F.SilkS") (uuid "0a-2"))',
            stroke='(stroke (width 0.05) (type solid)) (uuid "0a-3")',
            layers='(0 "F.Cu" signal) (31 "B.Cu" signal) (44 "Edge.Cuts" user)'),
    9: dict(version=20241229, part='footprint "R" (layer "{layer}")', mark='(uuid "0a-1") (embedded_fonts no)', quote='"',
            reference='(property "Reference" "{name}" (at 0 -2{turn}) (layer "F.SilkS") (uuid "0a-2"))',
            stroke='(stroke (width 0.05) (type solid)) (uuid "0a-3")',
            layers='(0 "F.Cu" signal) (2 "B.Cu" signal) (25 "Edge.Cuts" user)'),
}


def quoted(text, form):
    return f'{form["quote"]}{text}{form["quote"]}'


def part(form, name, at, items, layer="F.Cu"):
    turn = " " + at.split()[2] if len(at.split()) > 2 else ""
    head = form["part"].format(layer=layer)
    return (f'  ({head} {form["mark"]} (at {at}) (attr smd)\n    '
            f'{form["reference"].format(name=name, turn=turn)}\n    {items}\n  )\n')


def lines(form, kind, layer, points):
    out = []
    for a, b in zip(points, points[1:] + points[:1]):
        out.append(f'({kind}_line (start {a[0]} {a[1]}) (end {b[0]} {b[1]}) (layer {quoted(layer, form)}) {form["stroke"]})')
    return "\n    ".join(out)


def arc(form, kind, layer):
    """From (38, 0) to (40, 2) about (38, 2)."""
    if form["version"] < 20210000:
        ends = "(start 38 2) (end 38 0) (angle 90)"
    else:
        ends = "(start 38 0) (mid 39.414214 0.585786) (end 40 2)"
    return f'({kind}_arc {ends} (layer {quoted(layer, form)}) {form["stroke"]})'


def board(number):
    form = FORMATS[number]
    box = lines(form, "fp", "F.CrtYd", [(-2, -1), (2, -1), (2, 1), (-2, 1)])
    pads = (f'(pad {quoted("1", form)} smd rect (at -1 0 90) (size 1 1.5) (layers {quoted("F.Cu", form)}))\n    '
            f'(pad {quoted("2", form)} smd rect (at 1 0 90) (size 1 1.5) (layers {quoted("F.Cu", form)}))')
    plain = pads.replace(" 90)", ")")
    disc = f'(fp_circle (center 0 0) (end 1 0) (layer {quoted("B.CrtYd", form)}) {form["stroke"]})'
    edge = quoted("Edge.Cuts", form)
    sides = [((0, 0), (38, 0)), ((40, 2), (40, 20)), ((40, 20), (0, 20)), ((0, 20), (0, 0))]
    outline = "\n".join(f'  (gr_line (start {a[0]} {a[1]}) (end {b[0]} {b[1]}) (layer {edge}) {form["stroke"]})'
                        for a, b in sides)
    if number == 5:
        zone = ('(zone (net 0) (net_name "") (layer F.Cu) (tstamp 0) (hatch edge 0.5)\n    '
                '(polygon (pts (xy 1 15) (xy 6 15) (xy 6 19) (xy 1 19))))')
    else:
        zone = ('(zone (net 0) (net_name "") (layers "F.Cu") (name "antenna") (hatch edge 0.5)\n    '
                '(keepout (tracks allowed) (vias allowed) (pads allowed) (copperpour allowed) (footprints not_allowed))\n'
                '    (polygon (pts (xy 1 15) (xy 6 15) (xy 6 19) (xy 1 19))))')
    return (f'(kicad_pcb (version {form["version"]}) (generator pcbnew)\n  (layers {form["layers"]})\n'
            f'  (net 0 "") (net 1 {quoted("GND", form)})\n'
            + part(form, "R1", "10 10 90", box + "\n    " + pads) + part(form, "R2", "20 10", box + "\n    " + plain)
            + part(form, "R3", "20 10", disc, "B.Cu") + outline + "\n  " + arc(form, "gr", "Edge.Cuts") + "\n"
            + f'  (segment (start 5 5) (end 15 5) (width 0.5) (layer {quoted("F.Cu", form)}) (net 1))\n  {zone}\n)\n')


class Folder(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, text, name="b.kicad_pcb"):
        with open(self.path(name), "w", encoding="utf-8") as out:
            out.write(text)
        return self.path(name)

    def run_program(self, *arguments):
        return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=60)


class Formats(Folder):
    def region(self, number):
        done = self.run_program("map", self.write(board(number)), "--move", "R1", "--where",
                                "inside(R1, board) and clear(R1, R2) and within(R1.2, R2.1, 9mm)", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_all_formats_give_the_same_positions(self):
        wanted = self.region(6)
        self.assertGreater(wanted["area"], 50)
        for number in FORMATS:
            self.assertEqual(self.region(number)["cells"], wanted["cells"], f"KiCad {number}")

    def test_a_rule_area_counts_from_kicad_6_on(self):
        for number in (6, 7, 8, 9):
            done = self.run_program("check", self.write(board(number)), "--move", "R1", "--where", "clear(R1, others)",
                                    "--at", "3,17", "--json")
            self.assertFalse(json.loads(done.stdout)["true"], f"KiCad {number}")
            self.assertIn("antenna", done.stdout)


def boxes(*places):
    """A board of KiCad 8 with parts R1, R2, ... of 4 x 2 mm at these places, "x y" or "x y angle"."""
    form = FORMATS[8]
    box = lines(form, "fp", "F.CrtYd", [(-2, -1), (2, -1), (2, 1), (-2, 1)])
    edge = lines(form, "gr", "Edge.Cuts", [(0, 0), (40, 0), (40, 20), (0, 20)])
    parts = "".join(part(form, f"R{k + 1}", at, box) for k, at in enumerate(places))
    return f'(kicad_pcb (version 20240108) (generator pcbnew)\n  (layers {form["layers"]})\n{parts}  {edge}\n)\n'


class WholeBoards(Folder):
    def check(self, text, *arguments):
        done = self.run_program("check", self.write(text), *arguments, "--json")
        self.assertIn(done.returncode, (0, 1), done.stderr)
        result = json.loads(done.stdout)
        self.assertEqual(result["holds"], done.returncode == 0)
        return {(b["part"], a["text"]): a["value"] for b in result["broken"] for a in b["check"]["atoms"] if not a["true"]}

    def test_every_pair_is_named_with_its_own_depth(self):
        # R2 overlaps both neighbours by 0.5; to leave their union it would have to go farther.
        text = boxes("10 10", "13.5 10", "17 10", "30 10")
        self.assertEqual(self.check(text), {("R1", "clear(self, R2)"): -0.5, ("R2", "clear(self, R1)"): -0.5,
                                            ("R2", "clear(self, R3)"): -0.5, ("R3", "clear(self, R2)"): -0.5})

    def test_touching_is_no_overlap(self):
        self.assertEqual(self.check(boxes("10 10", "14 10", "18 10")), {})
        self.assertEqual(set(self.check(boxes("10 10", "13.999999 10"))),
                         {("R1", "clear(self, R2)"), ("R2", "clear(self, R1)")})

    def test_at_an_angle_the_grid_breaks_no_rule(self):
        # The neighbour stands 2 mm away across, at 45 degrees: its place and corners are rounded to the grid.
        touching = boxes("10 10 45", "11.414214 11.414213 45")
        self.assertEqual(self.check(touching), {})
        self.assertIn("-0.000002mm", self.run_program("check", self.write(touching)).stdout)
        self.assertEqual(len(self.check(boxes("10 10 45", "11.414204 11.414203 45"))), 2)

    def test_rules_of_many_kinds(self):
        text = boxes("10 10", "14.3 10", "30 10")
        near = {("R1", "gap(self, R2) >= 0.5"), ("R2", "gap(self, R1) >= 0.5")}
        self.assertEqual(set(self.check(text, "--where", "gap(self, others) >= 0.5mm")), near)
        self.assertEqual(set(self.check(text, "--where", "between(front, front) >= 0.5mm")),
                         {("R1", "between(self, R2) >= 0.5"), ("R2", "between(self, R1) >= 0.5")})
        self.assertEqual(set(self.check(text, "--where", "gap(self, all except R3) >= 0.5mm and clear(self, others)")),
                         near)
        # A rule that names a part asks nothing of that part.
        self.assertEqual(set(self.check(text, "--where", "within(self, R1, 1mm)")), {("R3", "within(self, R1, 1)")})
        self.assertEqual(set(self.check(text, "--where", "clear(self, R1, 1mm)")), {("R2", "clear(self, R1, 1)")})
        # Somebody has to be near: R3 has nobody.
        alone = self.check(text, "--where", "gap(self, others) <= 5mm")
        self.assertEqual({p for p, _ in alone}, {"R3"})
        # Distances compared: R1 and R2 are as near to the list as it is.
        self.assertEqual(self.check(text, "--where", "gap(self, front) <= gap(self, others)"), {})


    def test_holes_of_a_part_are_its_own(self):
        hole = '(pad "1" thru_hole circle (at 0 0) (size 1 1) (drill 0.6) (layers "*.Cu" "*.Mask"))'
        drilled = lambda *at: boxes(*at).replace("(attr smd)", f"(attr through_hole) {hole}")
        self.assertEqual(self.check(drilled("10 10", "30 10"), "--where", "clear(self, holes)"), {})
        near = self.check(drilled("10 10", "12.2 10"), "--where", "clear(self, holes)")
        self.assertEqual(near, {("R1", 'clear(self, "hole at 12.2 10")'): -0.1, ("R2", 'clear(self, "hole at 10 10")'): -0.1})
        # It takes them along, so they are in its way nowhere.
        done = self.run_program("check", self.write(drilled("10 10", "30 10")), "--move", "R1", "--where",
                                "clear(R1, holes)", "--at", "11,10")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_near_and_far(self):
        text = board(8)
        for word, same in (("near(R1.2, R2.1, 9mm)", "gap(R1.2, R2.1) <= 9mm"), ("far(R1, R2, 3mm)", "gap(R1, R2) >= 3mm")):
            areas = []
            for where in (word, same):
                done = self.run_program("map", self.write(text), "--move", "R1", "--where", f"inside(R1, board) and {where}",
                                        "--json")
                self.assertEqual(done.returncode, 0, done.stderr)
                areas.append(json.loads(done.stdout)["area"])
            self.assertGreater(areas[0], 1)
            self.assertEqual(areas[0], areas[1])

    def test_all_are_the_parts(self):
        done = self.run_program("map", self.write(boxes("10 10", "20 10", "30 10")), "--move", "R1", "--where",
                                "inside(R1, board) and clear(R1, all except R3)", "--json")
        wanted = self.run_program("map", self.write(boxes("10 10", "20 10", "30 10")), "--move", "R1", "--where",
                                  "inside(R1, board) and clear(R1, R2)", "--json")
        self.assertEqual(json.loads(done.stdout)["area"], json.loads(wanted.stdout)["area"])


def grouped(number, group, locked=""):
    """The board in a format of KiCad 6 to 9 whose footprints have the ids r1, r2, r3, with these groups."""
    text, form = board(number), FORMATS[number]
    new = number >= 8
    for k in range(3):
        text = text.replace('"0a-1"' if new else "0a-1)", f'"r{k + 1}"' if new else f"r{k + 1})", 1)
    out = ""
    for name, members in group.items():
        quoted_ids = " ".join(f'"{m}"' if new else m for m in members)
        mark = f'(uuid "g{name}")' if new else f"(id g{name})"
        out += f'  (group "{name}" {locked} {mark} (members {quoted_ids}))\n'
    return text[:text.rindex(")")] + out + ")\n"


class Words(Folder):
    """keepout, fixed and group, of formulas, of the command line and of the board's file."""

    def answer(self, verb, text, *arguments, status=0):
        done = self.run_program(verb, self.write(text), *arguments, "--json")
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return json.loads(done.stdout)

    def area(self, text, *arguments):
        return self.answer("map", text, *arguments)["area"]

    def test_keepout_of_parts_and_pads(self):
        for thing in ("R1", "R1.2"):
            for area in ("keepouts", "antenna", "R2", "R2.1"):
                areas = [self.area(board(8), "--move", "R1", "--where", f"inside(R1, board) and {rule}")
                         for rule in (f"keepout({thing}, {area}, 2mm)", f"gap({thing}, {area}) >= 2mm", "true")]
                self.assertEqual(areas[0], areas[1], (thing, area))
                self.assertLess(areas[0], areas[2] - 1, (thing, area))
        plain = [self.area(board(8), "--move", "R1", "--where", f"inside(R1, board) and {rule}")
                 for rule in ("keepout(R1, antenna)", "clear(R1, keepouts)")]
        self.assertEqual(plain[0], plain[1])

    def test_group_of_two(self):
        near = [self.area(board(8), "--move", "R1", "--where", f"inside(R1, board) and {rule}")
                for rule in ("group(R1, R2, 9mm)", "diameter(R1, R2) <= 9mm")]
        self.assertEqual(near[0], near[1])
        self.assertGreater(near[0], 1)
        # Side by side two parts of 4 x 2 mm are the root of 32 across.
        text = boxes("10 10", "10 14", "30 10")
        for limit, status in ((5.6568, 1), (5.6569, 0)):
            done = self.run_program("check", self.write(text), "--move", "R1", "--where", f"group(R1, R2, {limit}mm)",
                                    "--at", "10,12")
            self.assertEqual(done.returncode, status, done.stdout + done.stderr)

    def test_groups_of_the_file(self):
        where = "inside(R1, board) and clear(R1, power) and clear(R1, others)"
        wanted = None
        for number in (6, 7, 8, 9):
            text = grouped(number, {"power": ["r2", "no-footprint"]})
            area = self.area(text, "--move", "R1", "--where", where)
            alike = self.area(text, "--move", "R1", "--where", where.replace("power", "R2"))
            self.assertEqual(area, alike)
            wanted = wanted or area
            self.assertEqual(area, wanted, f"KiCad {number}")

    def test_groups_in_groups_and_their_names(self):
        text = grouped(8, {"all of it": ["ginner", "gR2"], "inner": ["r1", "gall of it"], "R2": ["r2"], "empty": []})
        both = self.answer("map", text, "--move", "all of it", "--where", "inside('all of it', board)")
        wanted = self.answer("map", text, "--move", "R1,R2", "--where", "inside(R1+R2, board)")
        self.assertEqual(both["cells"], wanted["cells"])
        self.assertEqual(both["bbox"], [[1, 2], [28, 18]])  # the position is that of R1, which is first in the file
        # A group named as a part, or as a word, is called 'group NAME'.
        self.answer("check", text, "--where", "clear(R1, 'group R2')", "--fixed", "group R2", "--move", "R1", "--at", "5,10")
        copper = grouped(8, {"F.Cu": ["r2"]})
        self.answer("check", copper, "--where", "clear(R1, 'F.Cu group')", "--move", "R1", "--at", "5,10")
        done = self.run_program("map", self.write(text), "--move", "empty", "--where", "true")
        self.assertEqual(done.returncode, 3)
        self.assertIn("there is no part or group 'empty'", done.stderr)

    def test_a_group_of_the_command_line_moves_as_one(self):
        text = boxes("10 10", "16 10", "30 10")
        where = "inside(pair, board) and clear(pair, others, 1mm)"
        moved = self.answer("map", text, "--group", "pair=R1,R2", "--move", "pair", "--where", where)
        wanted = self.answer("map", text, "--move", "R1,R2", "--where", where.replace("pair", "R1+R2"))
        self.assertEqual(moved["cells"], wanted["cells"])
        # One of them alone: the group is the rest of it.
        alone = self.area(text, "--group", "pair=R1,R2", "--move", "R1", "--where", "inside(R1, board) and clear(R1, pair)")
        self.assertEqual(alone, self.area(text, "--move", "R1", "--where", "inside(R1, board) and clear(R1, R2)"))

    def test_a_group_is_placed_as_one(self):
        text = boxes("10 10", "13 14 90", "30 10")
        for turn, places in (("0", ("2 3", "5 7 90")), ("90", ("1.6 8", None))):
            done = self.run_program("place", self.write(text), "--group", "pair=R1,R2", "--move", "pair", "--free", turn,
                                    "--minimize", "x", "-o", self.path("placed.kicad_pcb"))
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            with open(self.path("placed.kicad_pcb"), encoding="utf-8") as file:
                after = file.read()
            old = [("10", "10", "0"), ("13", "14", "90")]
            new = [re.search(rf'\(at ([-\d.]+) ([-\d.]+) ?([-\d.]*)\) \(attr smd\)\s+\(property "Reference" "R{k}"', after).groups()
                   for k in (1, 2)]
            dx, dy = (float(new[1][c]) - float(new[0][c]) for c in (0, 1))
            self.assertEqual((round(dx, 6), round(dy, 6)), {"0": (3, 4), "90": (4, -3)}[turn])
            for was, now in zip(old, new):
                self.assertEqual((float(now[2] or 0) - float(was[2])) % 360, float(turn))
            rest = re.sub(r"\(at [^()]*\)", "", after)
            self.assertEqual(rest, re.sub(r"\(at [^()]*\)", "", text))
            self.assertEqual(after.count("(at 30 10)"), 1)
            self.assertEqual(self.run_program("check", self.path("placed.kicad_pcb")).returncode, 0)

    def test_explained_over_angles(self):
        form = FORMATS[8]
        box = lines(form, "fp", "F.CrtYd", [(0, 0), (4, 0), (4, 2), (0, 2)])  # its corner is its origin
        edge = lines(form, "gr", "Edge.Cuts", [(0, 0), (6, 0), (6, 8), (0, 8)])
        text = (f'(kicad_pcb (version 20240108) (generator pcbnew)\n  (layers {form["layers"]})\n'
                f'{part(form, "R1", "1 1", box)}  {edge}\n)\n')
        found = self.answer("explain", text, "--move", "R1", "--free", "0,90", "--where", "inside(R1, board)")
        (slack,) = found["slack"]
        # Upright its middle, which is (2, 1) from its corner as drawn and (1, -2) as seen from there, is that of the board.
        self.assertEqual((slack["to"], slack["at"], slack["angle"]), (2, [2, 6], 90))
        none = self.answer("explain", text, "--move", "R1", "--free", "0,90", "--where", "inside(R1, board, 3)", status=1)
        self.assertEqual(none["conflict"], ["inside(R1, board, 3)"])

    def test_all_verbs_count_angles_as_they_are_seen(self):
        form = FORMATS[8]
        corner = lines(form, "fp", "F.CrtYd", [(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (0, 3)])
        edge = lines(form, "gr", "Edge.Cuts", [(0, 0), (20, 0), (20, 20), (0, 20)])
        text = (f'(kicad_pcb (version 20240108) (generator pcbnew)\n  (layers {form["layers"]})\n'
                f'{part(form, "R1", "5 5", corner)}{part(form, "R2", "12 12", corner)}  {edge}\n)\n')
        of = ["--move", "R1", "--where", "inside(R1, board)"]
        (_, quarter) = self.answer("map", text, *of, "--free", "0,90")["poses"]
        self.assertEqual(quarter["region"]["bbox"], [[0, 4], [17, 20]])  # seen from its anchor it is 3 wide and 4 high
        for at, holds in (("1,10", True), ("10,2", False)):
            for verb in ("check", "explain"):
                found = self.answer(verb, text, *of, "--angle", "90", "--at", at, status=0 if holds else 1)
                self.assertEqual((found if verb == "check" else found["check"])["true"], holds)
        measured = self.answer("measure", text, "--move", "R1", "--where", "clear(R1, R2)", "--angle", "90", "--at", "14,11.5")
        self.assertEqual((measured["angle"], measured["distances"]["gap(R1, R2)"]), (90, 0.5))

    def test_fixed(self):
        text = boxes("10 10", "16 10", "30 10")
        for verb in (["map"], ["check", "--at", "10,10"], ["place"]):
            done = self.run_program(verb[0], self.write(text), "--move", "R1", "--fixed", "R3,R1", *verb[1:])
            self.assertEqual(done.returncode, 3, done.stdout)
            self.assertIn("the part 'R1' is fixed, and it is to move", done.stderr)
        near = self.area(text, "--move", "R1", "--fixed", "R2,R3", "--where", "inside(R1, board) and far(R1, fixed, 2mm)")
        self.assertEqual(near, self.area(text, "--move", "R1", "--where", "inside(R1, board) and far(R1, R2+R3, 2mm)"))
        broken = self.answer("check", text, "--fixed", "R2", "--where", "clear(self, fixed, 4mm)", status=1)
        self.assertEqual([b["part"] for b in broken["broken"]], ["R1"])
        done = self.run_program("check", self.write(text), "--fixed", "R9")
        self.assertEqual(done.returncode, 3)
        self.assertIn("there is no part or group 'R9'", done.stderr)

    def test_locked_parts_are_fixed(self):
        for number, form in FORMATS.items():
            head = form["part"].format(layer="F.Cu")
            text = board(number)
            yes = text.replace(head, head.replace(" (layer", " locked (layer") if number < 8 else head + " (locked yes)", 1)
            no = text.replace(head, head + (" (locked no)" if number >= 8 else ""), 1)
            for given, status in ((yes, 3), (no, 0)):
                out = self.path(f"out{number}-{status}.kicad_pcb")
                done = self.run_program("place", self.write(given), "--move", "R1", "-o", out)
                self.assertEqual(done.returncode, status, f"KiCad {number}: {done.stderr}")
                self.assertEqual(os.path.exists(out), status == 0)
            where = ["--move", "R2", "--where", "far(R2, fixed, 20mm)", "--at", "20,10"]
            self.answer("check", yes, *where, status=1)
            self.answer("check", no, *where)
            self.assertIn("locked", self.run_program("map", self.write(yes), "--move", "R1", "--where", "clear(R1, R2)").stderr)
        for number in (7, 8, 9):
            text = grouped(number, {"locked": ["r1"]}, "locked" if number == 7 else "(locked yes)")
            done = self.run_program("place", self.write(text), "--move", "R1")
            self.assertEqual(done.returncode, 3, f"KiCad {number}")
            text = grouped(number, {"locked": ["r1"]})
            self.assertEqual(self.run_program("place", self.write(text), "--move", "R1").returncode, 0, f"KiCad {number}")

    def test_groups_said_wrong(self):
        for group, says in (("pair", "NAME=PART"), ("=R1", "NAME=PART"), ("a=R1,,R2", "NAME=PART"), ("R2=R1", "name of its own"),
                            ("smd=R1", "name of its own"), ("a=R7", "no part or group 'R7'")):
            done = self.run_program("check", self.write(board(8)), "--group", group)
            self.assertIn(done.returncode, (2, 3))
            self.assertIn(says, done.stderr)

    def test_a_part_does_not_mind_its_own_keep_out(self):
        zone = ('(zone (net 0) (net_name "") (layers "F.Cu") (name "mine") (hatch edge 0.5) (keepout (tracks allowed) (vias allowed)'
                ' (pads allowed) (copperpour allowed) (footprints not_allowed)) (polygon (pts (xy 8 9) (xy 13 9) (xy 13 11) (xy 8 11))))')
        text = boxes("10 10", "20 10").replace("(attr smd)", f"(attr smd) {zone}", 1)
        self.assertTrue(self.answer("check", text)["holds"])
        done = self.run_program("check", self.write(text), "--move", "R1", "--where", "clear(R1, keepouts) and clear(R1, others)",
                                "--at", "11,10")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        broken = self.answer("check", text.replace("(at 20 10)", "(at 14 10)"), status=1)["broken"]
        self.assertEqual([b["part"] for b in broken], ["R2"])
        self.assertIn("clear(self, mine)", [a["text"] for a in broken[0]["check"]["atoms"]])

    def test_keep_outs_move_with_their_part(self):
        zone = ('(zone (net 0) (net_name "") (layers "F.Cu") (name "mine") (hatch edge 0.5) (keepout (tracks allowed) (vias allowed)'
                ' (pads allowed) (copperpour allowed) (footprints not_allowed)) (polygon (pts (xy 8 9) (xy 13 9) (xy 13 11)'
                ' (arc (start 12 11) (mid 10 11.5) (end 8 11)))))')
        text = boxes("10 10", "20 10").replace("(attr smd)", f"(attr smd) {zone}", 1)
        for turn, moved in (("0", "(xy 0 0) (xy 5 0) (xy 5 2) (arc (start 4 2) (mid 2 2.5) (end 0 2))"),
                            ("90", "(xy 0 5) (xy 0 0) (xy 2 0) (arc (start 2 1) (mid 2.5 3) (end 2 5))")):
            done = self.run_program("place", self.write(text), "--move", "R1", "--free", turn, "--minimize", "x", "--where",
                                    "inside(R1, board)", "-o", self.path("placed.kicad_pcb"))
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            with open(self.path("placed.kicad_pcb"), encoding="utf-8") as file:
                after = file.read()
            at = re.search(r"\(at ([-\d.]+) ([-\d.]+)", after)
            x, y = (round((float(at.group(1)) - (2 if turn == "0" else 1)) * 1e6), round((float(at.group(2)) - (1 if turn == "0" else 3)) * 1e6))
            points = re.search(r"\(pts (.*)\)\)\)", after).group(1)
            numbers = [round(float(n) * 1e6) for n in re.findall(r"[-\d.]+", points)]
            wanted = [round(float(n) * 1e6) + (y if k % 2 else x) for k, n in enumerate(re.findall(r"[\d.]+", moved))]
            self.assertEqual(numbers, wanted, turn)

    def test_a_lone_part_has_no_others(self):
        # R3 is alone on the back: `all except R1` is empty there, not the board.
        done = self.run_program("check", self.write(board(8)), "--move", "R3", "--where", "clear(R3, all except R1)", "--at", "20,10")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_a_zone_that_crosses_itself_is_left_out(self):
        text = board(8).replace("(zone ", '(zone (net 1) (net_name "GND") (layer "F.Cu") (hatch edge 0.5) (polygon (pts (xy 2 2)'
                                ' (xy 9 2) (xy 2 5) (xy 9 5))))\n  (zone ', 1)
        done = self.run_program("check", self.write(text))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stderr, r"b\.kicad_pcb:\d+:\d+: a zone of net 'GND' is left out: its outline touches or crosses itself")


class Pictures(Folder):
    def test_the_names_of_parts_stand_in_them(self):
        text = boxes("4 4", "10 4", "16 4", "22 4", "28 4", "4 10", "10 10", "16 10", "22 10", "28 10")
        done = self.run_program("check", self.write(text), "-o", self.path("b.svg"))
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("b.svg"), encoding="utf-8") as file:
            svg = file.read()
        ticks = {int(n): float(x) for x, n in re.findall(r'class="tick" text-anchor="middle" x="([\d.]+)"[^>]*>(\d+)<', svg)}
        scale = (ticks[30] - ticks[10]) / 20
        for k in range(10):
            x = float(re.search(rf'class="label" x="([\d.]+)"[^>]*>R{k + 1}<', svg).group(1))
            self.assertLess(abs((x - ticks[10]) / scale + 10 - (4 + 6 * (k % 5))), 2, f"R{k + 1}")

    def test_copper_is_coloured_by_its_side(self):
        text = board(8).replace('(layers "F.Cu"))', '(layers "F.Cu" "F.Mask"))', 1)
        done = self.run_program("map", self.write(text), "--move", "R3", "--where", "inside(R3, board)", "-o",
                                self.path("m.svg"))
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("m.svg"), encoding="utf-8") as file:
            svg = file.read()
        self.assertEqual(len(re.findall(r'<path class="copper-front"', svg)), 1)  # one path: overlaps are not seen
        self.assertNotIn('<path class="copper-back"', svg)


class Courtyards(Folder):
    def test_ends_that_lie_apart_are_joined_as_kicad_does(self):
        # The left line ends at -1.99, the lower one at -2; followed from the first line the lower end is met first.
        form = FORMATS[8]
        corners = [((2, 1), (2, -1)), ((2, 1), (-2, 1)), ((-1.99, -1), (-2, 1)), ((-2, -1), (2, -1)), ((-2, -1), (2, -1))]
        loose = "\n".join(f'(fp_line (start {a[0]} {a[1]}) (end {b[0]} {b[1]}) (layer "F.CrtYd") {form["stroke"]})'
                          for a, b in corners)
        edge = lines(form, "gr", "Edge.Cuts", [(0, 0), (40, 0), (40, 20), (0, 20)])
        text = (f'(kicad_pcb (version 20240108) (generator pcbnew)\n  (layers {form["layers"]})\n'
                + part(form, "R1", "10 10", loose) + f"  {edge}\n)\n")
        done = self.run_program("map", self.write(text), "--move", "R1", "--where", "inside(R1, board)", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads(done.stdout)["bbox"], [[2, 1], [38, 19]])
        self.assertIn("ends up to 0.02 mm apart were joined", done.stderr)


class Copies(Folder):
    def test_only_the_moved_part_differs(self):
        for number in FORMATS:
            before = board(number)
            done = self.run_program("place", self.write(before), "--move", "R1", "--minimize", "x", "-o",
                                    self.path("placed.kicad_pcb"))
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(self.path("placed.kicad_pcb"), encoding="utf-8") as file:
                after = file.read()
            self.assertNotEqual(before, after)
            head = before.index("(at 10 10 90)")
            self.assertEqual(after[:head], before[:head], f"KiCad {number}")
            new = re.match(r"\(at ([-0-9.]+) ([-0-9.]+) 90\)", after[head:])
            self.assertIsNotNone(new, after[head:head + 40])
            self.assertEqual(after[head + new.end():], before[head + len("(at 10 10 90)"):], f"KiCad {number}")
            self.assertEqual(float(new.group(1)), 1)  # its half width from the left edge

    def test_a_sum_of_distances_says_what_is_best(self):
        done = self.run_program("place", self.write(board(8)), "--move", "R1", "--minimize",
                                "distance(R1.1, R2.1) + 2 * distance(R1.2, R2.2)", "-o", self.path("placed.kicad_pcb"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(os.path.exists(self.path("placed.kicad_pcb")))


class Placements(Folder):
    def placed(self, *arguments):
        done = self.run_program("place", self.write(boxes("10 10", "20 10", "30 10")), *arguments, "--json")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return [p["at"] for p in json.loads(done.stdout)["positions"]]

    def test_conditions_of_each_part_and_of_parts_by_name(self):
        # Leftmost: R1 stands at the edge with 0.5 mm to spare, R2 right above or below it with 1 mm between.
        where = "inside(self, board, 0.5mm) and clear(self, others, 0.25mm) and far(R1, R2, 1mm) and near(self, R1, 1mm)"
        first, second = self.placed("--move", "R1,R2", "--where", where, "--minimize", "x")
        self.assertEqual((first[0], second[0]), (2.5, 2.5))
        self.assertAlmostEqual(abs(first[1] - second[1]), 3, places=6)

    def test_rules_by_class(self):
        first, second = self.placed("--move", "R1,R2", "--where", "between(smd, smd) >= 2mm", "--minimize", "x")
        self.assertEqual((first[0], second[0]), (2, 2))
        self.assertAlmostEqual(abs(first[1] - second[1]), 4, places=6)
        # As one body they have no distance to keep, and R3 is 2 mm away.
        pair, = self.placed("--group", "pair=R1,R2", "--move", "pair", "--where", "between(smd, smd) >= 2mm", "--minimize", "-x")
        self.assertEqual(pair[0], 28)

    def test_a_condition_counts_as_soon_as_its_parts_stand(self):
        # Without it R1 would go to the left edge, and R2 could not be near both.
        first, second = self.placed("--move", "R1,R2", "--where", "near(R1, R3, 1mm) and near(R2, R1, 1mm)", "--minimize", "x")
        self.assertEqual(first[0], 25)
        self.assertGreater(first[0], second[0])


class Malformed(Folder):
    """(what is wrong, the board, what the message says)."""

    def refused(self, text, reason, place=None):
        for verb in (["check"], ["map", "--move", "R1", "--where", "clear(R1, others)"], ["place", "--move", "R1"]):
            out = self.path("out.kicad_pcb" if verb[0] == "place" else "out.json")
            done = self.run_program(verb[0], self.write(text), *verb[1:], "-o", out)
            self.assertEqual(done.returncode, 3, f"{verb[0]}: {done.stdout}{done.stderr}")
            self.assertRegex(done.stderr, reason)
            self.assertRegex(done.stderr, place or r"b\.kicad_pcb:\d+:\d+")
            self.assertFalse(os.path.exists(out), "a file was written")

    def test_cut_off(self):
        text = board(8)
        rng = random.Random(1)
        for end in [1, len(text) - 2] + [rng.randrange(2, len(text) - 3) for _ in range(10)]:
            self.refused(text[:end], "not closed|does not end|in parentheses|[Ee]nd")

    def test_wrong_nesting(self):
        text = board(8)
        self.refused(text + ")", "nothing may stand after")
        self.refused(text.replace("(attr smd)\n", "(attr smd))\n", 1), "nothing may stand after|without")
        self.refused(text.replace("(layers ", "(layers (", 1), "not closed")
        self.refused("(" * 5000, "nested more than 200 deep")

    def test_outlines(self):
        text = board(8)
        outline = "the outline on Edge.Cuts"
        self.refused(text.replace("Edge.Cuts", "Dwgs.User"), "has no outline", outline)
        without = "\n".join(line for line in text.split("\n") if "(end 40 20)" not in line)
        self.refused(without, r"open at \(40, ", outline)
        two = text[:text.rindex(")")] + '(gr_circle (center 80 5) (end 85 5) (layer "Edge.Cuts")))'
        self.refused(two, "2 separate pieces", outline)

    def test_a_footprint_twice(self):
        self.refused(board(8).replace('"R2"', '"R1"'), "a second footprint 'R1'; the first is at .*:4:3")

    def test_numbers(self):
        self.refused(board(8).replace("(at 20 10)", "(at 20 ten)", 1), "number|decimal|digit")
        self.refused(board(8).replace("(version 20240108)", "(version 4)"), "KiCad 4 or older")


if __name__ == "__main__":
    unittest.main()
