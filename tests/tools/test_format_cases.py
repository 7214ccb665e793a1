# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""The layout of cases changes no token of them."""
import json
import random
import unittest

from small_tree import TreeTest, said

import format_cases


def random_value(rng, depth):
    kind = rng.randrange(7 if depth else 4)
    if kind == 0:
        return rng.choice(["true", "false", "null"])
    if kind == 1:
        return rng.choice(["0", "-0.0", "1e-09", "0.10", "1E+5", "123456789012345678901234567890", "2.50"])
    if kind in (2, 3):
        return json.dumps(rng.choice(["", "a, b", "[1, 2]", 'say "{no}"', "\\", "é → ü", "tab\t", "x" * 150]), ensure_ascii=kind == 2)
    inner = [random_value(rng, depth - 1) for _ in range(rng.randrange(6))]
    if kind in (4, 5):
        return "[" + rng.choice([",", " ,\n "]).join(inner) + "]"
    return "{" + ",".join(f'{rng.choice(["", " "])}"k{rng.randrange(3)}" : {value}' for value in inner) + "}"


class FormatCases(TreeTest):
    def test_random_json_keeps_tokens_and_contents(self):
        rng = random.Random(1)
        for _ in range(500):
            text = random_value(rng, 5)
            laid_out = format_cases.formatted(text)
            self.assertEqual(format_cases.tokens(laid_out), format_cases.tokens(text))
            self.assertEqual(format_cases.contents(laid_out), format_cases.contents(text))
            self.assertEqual(format_cases.formatted(laid_out), laid_out)

    def test_spelling_of_numbers(self):
        text = '{"a": [1e-09,0.10,\n-0.0, 12345678901234567890]}'
        self.assertIn("[1e-09, 0.10, -0.0, 12345678901234567890]", format_cases.formatted(text))

    def test_ring_a_line(self):
        text = ('{"shapes":{"A":{"polygon":[[0,0],[4,0],[4,4]],"holes":[[[1,1],[2,1],[2,2]],[[3,1],[3.5,1],[3.5,2]]]},'
                '"B":{"disc":{"radius":1}}}}')
        self.assertEqual(format_cases.formatted(text), """{
 "shapes": {
  "A": {
   "polygon": [[0, 0], [4, 0], [4, 4]],
   "holes": [
    [[1, 1], [2, 1], [2, 2]],
    [[3, 1], [3.5, 1], [3.5, 2]]
   ]
  },
  "B": {"disc": {"radius": 1}}
 }
}
""")

    def test_long_ring_fills_lines(self):
        ring = [[k, k * k] for k in range(100)]
        lines = format_cases.formatted(json.dumps({"polygon": ring})).splitlines()
        self.assertEqual([len(line) <= format_cases.COLUMNS for line in lines], [True] * len(lines))
        self.assertLess(len(lines), 15)
        self.assertTrue(all(line.startswith("  [") for line in lines[2:-2]))

    def test_what_is_no_json_is_refused_and_left_alone(self):
        for text in ('{"a": 1,}', "[1 2]", '{"a" 1}', "[1]]", "[1, 2", "", "[01]"):
            path = self.write("broken.case.json", text)
            status, message = said(format_cases, path)
            self.assertEqual((status, self.read("broken.case.json")), (2, text), message)

    def test_check_rewrites_nothing_and_names_the_command(self):
        text = '{"id": "a",\n"scene": {}}'
        path = self.write("a.case.json", text)
        status, message = said(format_cases, "--check", self.root)
        self.assertEqual((status, self.read("a.case.json")), (1, text))
        self.assertIn("python3 tools/format_cases.py", message)
        self.assertEqual(said(format_cases, path)[0], 0)
        self.assertEqual(self.read("a.case.json"), '{\n "id": "a",\n "scene": {}\n}\n')
        self.assertEqual(said(format_cases, "--check", self.root)[0], 0)


if __name__ == "__main__":
    unittest.main()
