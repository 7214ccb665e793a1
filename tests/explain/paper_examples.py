#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""`explain` on the paper's examples: a level that is tightened up to its slack leaves room, and a little further none.

usage: paper_examples.py PROGRAM

Every claim is asked of `map` through one pipe a scene."""
import glob
import json
import os
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
LEVEL = re.compile(r"^(.*?)\s*(<=|>=|<|>)\s*(-?[\d.]+)$")
BEYOND = 1e-4
ROUNDED = 1e-12


class Engine:
    def __init__(self, program, scene):
        self.pipe = subprocess.Popen([program, "serve", "--stdio", scene], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def ask(self, method, **parameters):
        self.pipe.stdin.write(json.dumps({"id": 1, "method": method, "params": parameters}) + "\n")
        self.pipe.stdin.flush()
        return json.loads(self.pipe.stdout.readline())["result"]

    def room(self, where):
        return not self.ask("map", where=where, brief=True)["empty"]

    def close(self):
        self.pipe.stdin.close()
        self.pipe.stdout.close()
        return self.pipe.wait()


def check(program, scene):
    """How many levels were looked at, and what is wrong."""
    engine = Engine(program, scene)
    where, answer, faults, looked = engine.ask("scene")["where"], engine.ask("explain"), [], 0
    if answer["feasible"] != engine.room(where):
        faults.append("feasible")
    for change in answer.get("slack", []):
        parts = LEVEL.match(change["text"])
        if not parts or not isinstance(change["to"], (int, float)) or change["text"] not in where:
            continue
        looked += 1
        distance, relation, _ = parts.groups()
        tighter = -1 if relation.startswith("<") else 1
        for by, wanted in ((-BEYOND, True), (BEYOND, False)):
            tried = where.replace(change["text"], f"{distance} {relation} {change['to'] + tighter * by:.9f}")
            if engine.room(tried) != wanted:
                faults.append(f"{change['text']}: to {change['to']}, but {tried} {'has no' if wanted else 'has'} room")
        # The position is printed as doubles, so it is feasible but for their rounding.
        if "at" in change and change.get("reached"):
            if engine.ask("nearest", at=change["at"])["nearest_feasible"]["distance"] > ROUNDED:
                faults.append(f"{change['text']}: the last position is not feasible")
    if engine.close() != 0:
        faults.append("exit status")
    return looked, faults


def main():
    looked = wrong = 0
    for scene in sorted(glob.glob(os.path.join(ROOT, "examples", "paper-*.json"))):
        levels, faults = check(sys.argv[1], scene)
        looked += levels
        wrong += len(faults)
        for fault in faults:
            print(f"{os.path.basename(scene)}: {fault}")
    print(f"{looked} levels, {wrong} faults")
    return 1 if wrong or looked < 15 else 0


if __name__ == "__main__":
    sys.exit(main())
