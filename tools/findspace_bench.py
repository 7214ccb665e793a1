#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Findspace over many obstacles, as a table: all of them, those alone that can bound the result, and Clipper's union of all sums.

usage: findspace_bench.py FINDSPACE [RIVAL] [--query QUERY] [--counts 9,1000,10000] [--runs N]

RIVAL is build/bench/findspace_rival; QUERY is build/bench/findspace_query and asks for a second table: a world made once, then queries. Times are the least processor time of N runs (3), reading included, one thread, in seconds: the machine may be
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
    parser.add_argument("--query")
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
    if options.query:
        queries(options)


def queries(options):
    """The parts of the time that findspace_query prints, in milliseconds: of all obstacles, and of those near."""
    print("\n| obstacles | as | making the world | first query | later queries | first query of those near | all : near |\n|---|---|---|---|---|---|---|")
    for count in map(int, options.counts.split(",")):
        for as_list in (False, True):
            made, near = (min((query(options.query, scene(count, as_list, near)) for _ in range(options.runs)), key=lambda t: t[1])
                          for near in (False, True))
            print(f"| {count} | {'collection' if as_list else 'names'} | {made[0]:.0f} | {made[1]:.1f} | {made[2]:.1f} | {near[1]:.1f} | {made[1] / near[1]:.1f} |",
                  flush=True)


def query(program, text):
    done = subprocess.run([program], input=json.dumps(text), capture_output=True, text=True, check=True)
    return [float(t) for t in done.stdout.split()]


if __name__ == "__main__":
    main(sys.argv[1:])
