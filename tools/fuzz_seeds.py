#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Writes seeds for the fuzz targets: FOLDER/scene/*.json and FOLDER/formula/*.txt, from the cases and the examples.

usage: fuzz_seeds.py FOLDER"""
import json
import os
import sys

from run_cases import CASES, ROOT, cases


def write(folder, name, text):
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
        file.write(text)


def main(folder):
    for case in cases([CASES], None):
        text = case["scene_text"] if "scene_text" in case else json.dumps(case["scene"])
        if not case.get("scene_file", "").endswith(".kicad_pcb"):  # a board, whose target has its own seeds
            write(os.path.join(folder, "scene"), case["id"] + ".json", text)
        formula = case.get("scene", {}).get("where")
        if isinstance(formula, str):
            write(os.path.join(folder, "formula"), case["id"] + ".txt", formula)
    examples = os.path.join(ROOT, "examples")
    for name in sorted(n for n in os.listdir(examples) if n.endswith(".json")):
        with open(os.path.join(examples, name), encoding="utf-8") as file:
            write(os.path.join(folder, "scene"), name, file.read())


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
