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
