#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Densities of `findspace pack` on the classic nesting instances, as a table in Markdown.

usage: packing.py EXECUTABLE [--data FOLDER] [--work N] [--seed S] [INSTANCE...]     density after processor seconds
       packing.py EXECUTABLE [--data FOLDER] --records [INSTANCE...]                 published layouts, compacted
       packing.py EXECUTABLE [--data FOLDER] --runs FILE [--seeds N] [--seconds S] [INSTANCE...]   many seeds, by the clock

FOLDER holds nesting/*.json and records/*.svg (default: ../shared/data/2d beside the repository). Heights are the true
ones, without the 1e-4 that some files add. Processor seconds are those of the program, so other work on the machine
changes a row little. Runs by the clock have two threads and need a quiet machine: FILE keeps each as a line of JSON, and
what stands there is not run again, so a table may take several days. A record is verified as it is, then shortened by
linear programs from there; both are exact."""
import argparse
import json
import os
import re
import subprocess
import sys
import tempfile

from kept_runs import add_runs, kept_runs

HERE = os.path.dirname(os.path.abspath(__file__))
TRUE_HEIGHTS = {"fu": "38", "jakobs1": "40", "jakobs2": "70", "blaz1": "15", "shapes0": "40", "shapes1": "40"}
CLASSICS = ["albano", "blaz1", "dagli", "fu", "jakobs1", "jakobs2", "mao", "marques", "shapes0", "shapes1", "shirts", "swim",
            "trousers"]
GARDEYN = ["gardeyn0", "gardeyn1", "gardeyn9"]
SECONDS = (10, 30, 60, 120)
NOTE = re.compile(r"processor +([\d.]+) s +length ([\d.]+) +density ([\d.]+) %")


def run(*arguments):
    done = subprocess.run(arguments, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        sys.exit(done.stderr)
    return done


def curve(arguments, name):
    """(processor seconds, density) of every better layout."""
    height = ["--height", TRUE_HEIGHTS[name]] if name in TRUE_HEIGHTS else []
    done = run(arguments.executable, "pack", os.path.join(arguments.data, "nesting", name + ".json"), *height, "--threads",
               "1", "--seed", str(arguments.seed), "--work", str(arguments.work))
    return [(float(s), float(density)) for s, _, density in NOTE.findall(done.stderr)]


def density_table(arguments):
    print("| instance |" + "".join(f" {s} s |" for s in SECONDS) + " last | at |\n|---|" + "---|" * (len(SECONDS) + 2))
    for name in arguments.instances or CLASSICS:
        points = curve(arguments, name)
        last, density = points[-1]
        best = [max((d for s, d in points if s <= limit), default=0) for limit in SECONDS]
        cells = [f"{d:.2f}" if limit <= last or d == density else "" for limit, d in zip(SECONDS, best)]
        print(f"| {name} | " + " | ".join(cells) + f" | {density:.2f} | {last:.1f} s |", flush=True)


def one_run(arguments, name, seed):
    height = ["--height", TRUE_HEIGHTS[name]] if name in TRUE_HEIGHTS else []
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "layout.json")
        done = run(arguments.executable, "pack", os.path.join(arguments.data, "nesting", name + ".json"), *height, "--threads",
                   "2", "--seed", str(seed), "--time-limit", str(arguments.seconds), "-o", out)
        with open(out, encoding="utf-8") as file:
            layout = json.load(file)["layout"]
    curve_seen = [(float(s), float(density)) for s, _, density in NOTE.findall(done.stderr)]
    return {"density": 100 * layout["density"], "length": layout["length"], "curve": curve_seen}


def seed_table(arguments):
    names = arguments.instances or CLASSICS + GARDEYN
    add_runs(arguments.runs, arguments.seconds, names, arguments.seeds, lambda name, seed: one_run(arguments, name, seed))
    runs = kept_runs(arguments.runs, arguments.seconds)
    print("| instance | runs | mean | least | best | shortest |\n|---|---|---|---|---|---|")
    for name in names:
        lines = [line for line in runs if line["instance"] == name]
        if not lines:
            continue
        densities = [line["density"] for line in lines]
        best = max(lines, key=lambda line: line["density"])
        print(f"| {name} | {len(lines)} | {sum(densities) / len(densities):.2f} | {min(densities):.2f} | "
              f"{best['density']:.2f} | {float(best['length']):.6f} |")


def record_table(arguments):
    print("| record | feasible | length | compacted | density % |\n|---|---|---|---|---|")
    for name in arguments.instances or CLASSICS + GARDEYN:
        record = os.path.join(arguments.data, "records", name + ".svg")
        verdict = json.loads(run(arguments.executable, "verify", record, "--json").stdout)["verdict"]
        with tempfile.TemporaryDirectory() as folder:
            out = os.path.join(folder, "layout.json")
            run(arguments.executable, "pack", os.path.join(arguments.data, "nesting", name + ".json"), "--start", record,
                "--threads", "1", "--work", "1", "-q", "-o", out)
            with open(out, encoding="utf-8") as file:
                layout = json.load(file)["layout"]
        print(f"| {name} | {'yes' if verdict['feasible'] else 'no'} | {verdict['length']} | {float(layout['length']):.6f} | "
              f"{100 * verdict['density']:.4f} → {100 * layout['density']:.4f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("executable")
    parser.add_argument("instances", nargs="*")
    parser.add_argument("--data", default=os.path.join(HERE, "..", "..", "shared", "data", "2d"))
    parser.add_argument("--work", type=int, default=15000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--records", action="store_true")
    parser.add_argument("--runs", default="")
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--seconds", type=float, default=120)
    arguments = parser.parse_intermixed_args()
    (record_table if arguments.records else seed_table if arguments.runs else density_table)(arguments)


if __name__ == "__main__":
    main()
