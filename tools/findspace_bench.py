#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Findspace over many obstacles, as a table: all of them, those alone that can bound the result, and Clipper's union of all sums.

usage: findspace_bench.py FINDSPACE [RIVAL] [--counts 9,1000,10000] [--runs N]

RIVAL is build/bench/bench/findspace_rival. Times are the least processor time of N runs (3), reading included, one thread, in seconds: the machine may be
shared. The scenes are those of findspace_scenes.py, each obstacle by its own name with its own clearance, and as one collection."""
import argparse
import json
import resource
import subprocess
import sys

from findspace_scenes import scene


def processor_time(command, text, runs):
    best = None
    for _ in range(runs):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(command, input=text, capture_output=True, text=True, check=False)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        best = spent if best is None else min(best, spent)
    return best


def main(argv):
    parser = argparse.ArgumentParser(usage=__doc__.split("\n\n")[1].removeprefix("usage: "))
    parser.add_argument("findspace")
    parser.add_argument("rival", nargs="?")
    parser.add_argument("--counts", default="9,1000,10000")
    parser.add_argument("--runs", type=int, default=3)
    options = parser.parse_args(argv)
    ours = [options.findspace, "map", "--json", "--threads", "1", "-"]
    print("| obstacles | as | all | those near | all : near | Clipper | Clipper : ours |\n|---|---|---|---|---|---|---|")
    for count in map(int, options.counts.split(",")):
        for as_list in (False, True):
            texts = [json.dumps(scene(count, as_list, near)) for near in (False, True)]
            everything, near = (processor_time(ours, text, options.runs) for text in texts)
            rival = processor_time([options.rival], texts[0], 1) if options.rival else None
            print(f"| {count} | {'collection' if as_list else 'names'} | {everything:.2f} | {near:.2f} | {everything / near:.1f} | "
                  + (f"{rival:.2f} | {rival / everything:.1f} |" if rival is not None else "– | – |"), flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
