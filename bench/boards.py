#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Processor time of questions about boards: reading, the first region of a part, and the check of all parts.

    bench/boards.py PROGRAM [BOARD...]

Without boards one of 250 parts is made: rows of parts of 2 to 64 pads, half of them turned, with tracks between. The
least of five runs counts (user time of the process).
"""

import os
import random
import re
import resource
import subprocess
import sys
import tempfile

RUNS = 5


def part(name, x, y, turn, pads, rng):
    rows = (pads + 1) // 2
    height, width = rows * 0.65 + 0.6, rng.choice([2.2, 4, 6])
    items = [f'(fp_rect (start {-width / 2} {-height / 2}) (end {width / 2} {height / 2}) (layer "F.CrtYd") (width 0.05))']
    for k in range(pads):
        side = -1 if k < rows else 1
        px, py = side * (width / 2 - 0.4), (k % rows) * 0.65 - (rows - 1) * 0.325
        items.append(f'(pad "{k + 1}" smd roundrect (at {px:.3f} {py:.3f} {turn}) (size 0.6 0.4) (layers "F.Cu") '
                     '(roundrect_rratio 0.25))')
    return (f'(footprint "P" (layer "F.Cu") (at {x} {y} {turn}) (attr smd)\n (fp_text reference "{name}" (at 0 0) '
            '(layer "F.SilkS"))\n ' + "\n ".join(items) + ")\n")


def made_board(count=250, seed=1):
    rng = random.Random(seed)
    columns = 25
    out = '(kicad_pcb (version 20211014) (generator bench)\n(layers (0 "F.Cu" signal) (31 "B.Cu" signal))\n(net 0 "")\n'
    for k in range(count):
        x, y = 10 + (k % columns) * 9, 10 + (k // columns) * 16
        out += part(f"U{k + 1}", x, y, rng.choice([0, 90, 180, 270]), rng.choice([2, 2, 2, 8, 16, 24]), rng)
    for k in range(1000):
        x, y = rng.uniform(5, 230), rng.uniform(5, 165)
        out += f'(segment (start {x:.3f} {y:.3f}) (end {x + 5:.3f} {y:.3f}) (width 0.2) (layer "F.Cu") (net 0))\n'
    return out + '(gr_rect (start 0 0) (end 245 175) (layer "Edge.Cuts") (width 0.1)))\n'


def user_seconds(*command):
    best = None
    for _ in range(RUNS):
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode not in (0, 1):
            raise SystemExit(done.stderr)
        used = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        best = used if best is None else min(best, used)
    return best


def main():
    program, boards = sys.argv[1], sys.argv[2:]
    with tempfile.TemporaryDirectory() as folder:
        if not boards:
            boards = [os.path.join(folder, "made.kicad_pcb")]
            with open(boards[0], "w", encoding="utf-8") as file:
                file.write(made_board())
        print("| board | parts | pads | region of one part, s | check of all parts, s |")
        print("|---|---|---|---|---|")
        for path in boards:
            with open(path, encoding="utf-8") as file:
                text = file.read()
            parts = len(re.findall(r"\((?:footprint|module) ", text))
            names = re.findall(r'(?:reference|"Reference") "?([A-Z]+[0-9]+)"?', text)
            name = sorted(n for n in names if n[0] in "RCU")[0]
            region = user_seconds(program, "map", path, "--move", name, "--where",
                                  f"inside({name}, board, 0.5mm) and clear({name}, others, 0.25mm)")
            check = user_seconds(program, "check", path)
            pads = len(re.findall(r"\(pad ", text))
            print(f"| {os.path.basename(path)} | {parts} | {pads} | {region:.3f} | {check:.3f} |")


if __name__ == "__main__":
    main()
