#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Counts the instructions of two builds of the program on the same questions, as a Markdown table.

usage: house_instructions.py OLD NEW   two programs; needs valgrind (callgrind)

A count does not depend on what else the machine does. Each question runs once in each program, on one thread."""
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
QUESTIONS = [
    ("map", "peg"), ("map", "carts"), ("map", "door-leaf"), ("map", "rooms"), ("place", "nesting"),
    ("check", "peg", "--at", "50,30"), ("measure", "peg", "--at", "10,10"), ("measure", "peg", "--at", "10,10", "--all"),
    ("explain", "peg"),
]


def instructions(program, question):
    """How many instructions the question takes; None where the program refuses it."""
    verb, scene, *rest = question
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "callgrind")
        done = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", program, verb,
                               os.path.join(ROOT, "examples", scene + ".json"), *rest, "--threads", "1", "-q"],
                              capture_output=True, text=True, check=False)
        if done.returncode not in (0, 1):
            return None
        return int(re.search(r"^(?:summary|totals): (\d+)", open(out, encoding="utf-8").read(), re.M).group(1))


def main(argv):
    if len(argv) != 2:
        print(__doc__.split("\n\n")[1])
        return 2
    print("| question | before, millions | after, millions | after : before |\n|---|---|---|---|")
    for question in QUESTIONS:
        old, new = (instructions(program, question) for program in argv)
        verb, scene, *rest = question
        text = " ".join([verb, f"examples/{scene}.json", *rest])
        ratio = f"{new / old:.3f}" if old and new else "–"
        print(f"| `{text}` | " + " | ".join(f"{n / 1e6:.1f}" if n else "refused" for n in (old, new)) + f" | {ratio} |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
