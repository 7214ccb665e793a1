#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Runs the recipes of docs/recipes.md as they stand, beside the files of examples/drawings.

A block of JSON after "`NAME.json`:" is a file of that name. Each line of a block of commands ends with status 0 and
writes what it names; no recipe has more than five. Pictures are XML and not empty. What the recipes find is compared
with what the drawings were made as.

usage: recipes.py FINDSPACE
"""
import json
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as tree
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FILE = re.compile(r"`([\w.]+\.json)`:\n\n```json\n(.*?)```", re.S)
COMMANDS = re.compile(r"```sh\n(.*?)```", re.S)
MOST = 5  # lines of a recipe

# What results must hold, by their file.
KNOWN = {
    "nest.json": lambda r: r["layout"]["proven"] and len(r["layout"]["items"]) == 12,
    "depth.out.json": lambda r: [i["to"] for i in r["intervals"]] == [25.9, None],
    "other.out.json": lambda r: abs(r["area"] - 11207) < 0.1 and r["holes"] == 6,
    "printed.json": lambda r: r["layout"]["proven"] and len(r["layout"]["items"]) == 12,
}


def outputs(words):
    return [words[k + 1] for k, word in enumerate(words) if word == "-o"]


def faults(program, folder, line):
    """What is wrong with one line, in words."""
    words = shlex.split(line, comments=True)
    if words[0] != "findspace":
        return [f"{line}: does not begin with findspace"]
    done = subprocess.run([program, *words[1:]], cwd=folder, capture_output=True, text=True, check=False, timeout=300)
    if done.returncode != (1 if words[1] == "explain" else 0):  # 1: there is no position, and it says why
        return [f"{line}: status {done.returncode}: {done.stderr}"]
    found = []
    for name in outputs(words):
        path = folder / name
        if not path.exists() or path.stat().st_size < 100:
            found.append(f"{line}: {name} is missing or empty")
        elif path.suffix == ".svg" and sum(1 for e in tree.parse(path).iter() if e.tag.endswith("path")) == 0:
            found.append(f"{line}: {name} draws nothing")
        elif name in KNOWN and not KNOWN[name](json.loads(path.read_text(encoding="utf-8"))):
            found.append(f"{line}: {name} holds something else")
    return found


def main(argv):
    if len(argv) != 2:
        print(__doc__.rsplit("\n\n", 1)[1])
        return 2
    program = str(Path(argv[1]).resolve())
    recipes = (ROOT / "docs" / "recipes.md").read_text(encoding="utf-8").split("\n## ")[1:]
    wrong, lines, pictures = [], 0, set()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for path in (ROOT / "examples" / "drawings").iterdir():
            shutil.copy(path, folder)
        for recipe in recipes:
            for file, text in FILE.findall(recipe):
                (folder / file).write_text(text, encoding="utf-8")
            commands = [line for block in COMMANDS.findall(recipe) for line in block.strip().splitlines()]
            if not 0 < len(commands) <= MOST:
                wrong.append(f"{recipe.splitlines()[0]}: {len(commands)} commands")
            for line in commands:
                wrong += faults(program, folder, line)
                pictures |= {o for o in outputs(shlex.split(line, comments=True)) if o.endswith(".svg")}
            lines += len(commands)
    print("\n".join(wrong + [f"{len(recipes)} recipes, {lines} commands, {len(pictures)} pictures, {len(wrong)} wrong"]))
    return 1 if wrong or len(pictures) < 5 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
