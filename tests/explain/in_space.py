#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Scenes of space whose formulas contradict themselves, explained, and every claim asked of `check` at many positions.

usage: in_space.py PROGRAM [--count N] [--seed N]

Each scene is a box or a ball among two or three boxes, balls and tetrahedra, and three or four random conditions. Of the
infeasible ones:
* the conflict holds at none of the positions, and without any one of its conditions it has room, as `explain` says;
* "becomes" holds with the other conditions at "at", and no position that meets the others has a level beyond "to";
* at "at" of "relax_all" no condition lacks more than "upper", and every position lacks more than "lower".
Of as many feasible ones, no position that meets the others has a level beyond the slack. Where the scene is of boxes and
all levels are 0, conflicts are asked of `map`, which is exact, too."""
import argparse
import json
import random
import re
import subprocess
import sys

SIDES = {"<=": 1, ">=": -1}


class Server:
    def __init__(self, program):
        self.pipe = subprocess.Popen([program, "serve", "--stdio"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def ask(self, method, **parameters):
        self.pipe.stdin.write(json.dumps({"id": 1, "method": method, "params": parameters}) + "\n")
        self.pipe.stdin.flush()
        answer = json.loads(self.pipe.stdout.readline())
        return answer["result"] if "result" in answer else answer["error"]


def shape(rng, boxes):
    at, size = [rng.randint(-8, 8) for _ in range(3)], [rng.randint(3, 8) for _ in range(3)]
    kind = 0 if boxes else rng.randrange(3)
    if kind == 1:
        return {"ball": {"center": at, "radius": size[0]}}
    if kind == 2:
        return {"polytope": [at, *([c + (size[k] if k == i else 0) for k, c in enumerate(at)] for i in range(3))]}
    return {"box": {"min": at, "max": [c + s for c, s in zip(at, size)]}}


class Scene:
    def __init__(self, rng):
        self.boxes = rng.random() < 0.4
        names = ["S1", "S2", "S3"][: rng.randint(2, 3)]
        self.shapes = {name: shape(rng, self.boxes) for name in names}
        ball = not self.boxes and rng.random() < 0.5
        self.shapes["B"] = {"ball": {"center": [0, 0, 0], "radius": 1}} if ball else {"box": {"min": [-1, -1, -1], "max": [1, 1, 1]}}
        self.conditions = []
        for _ in range(rng.randint(3, 4)):
            word, relation = rng.choice(["gap", "gap", "margin"] if self.boxes else ["gap", "gap", "reach", "margin"]), rng.choice(list(SIDES))
            level = 0 if self.boxes else rng.randint(-2, 14) + rng.choice([0, 0.5])
            self.conditions.append((word, rng.choice(names), relation, level))

    def texts(self):
        return [f"{word}(B, {name}) {relation} {level:g}" for word, name, relation, level in self.conditions]

    def text(self, texts):
        return json.dumps({"findspace": 1, "shapes": self.shapes, "moving": "B", "where": " and ".join(texts) or "true"})


class Check:
    def __init__(self, program, rng):
        self.server, self.rng, self.faults = Server(program), rng, []

    def expect(self, good, scene, what):
        if not good:
            self.faults.append(f"{what}\n  {scene.text(scene.texts())}")

    def explained(self, scene, texts):
        loaded = self.server.ask("load", text=scene.text(texts))
        return loaded if "code" in loaded else self.server.ask("explain")

    def values(self, scene, at):
        """Of each condition at a position: its value. A margin in what is too small is undefined: minus infinity."""
        self.server.ask("load", text=scene.text(scene.texts()))
        return [[-1e9 if a["value"] in (None, "-inf") else a["value"] for a in self.server.ask("check", at=p)["atoms"]] for p in at]

    def run(self, scene, answer):
        texts, feasible = scene.texts(), answer["feasible"]
        places = [[self.rng.uniform(-18, 18) for _ in range(3)] for _ in range(150)]
        changes = answer["slack" if feasible else "relax"]
        places += [c["at"] for c in changes if "at" in c]
        seen = self.values(scene, places)
        lacks = [[SIDES[r] * (v - level) for (_, _, r, level), v in zip(scene.conditions, row)] for row in seen]
        self.expect(len(changes) == len(texts), scene, "changes")
        for k, change in enumerate(changes):
            if change["to"] is None:
                continue
            _, _, relation, level = scene.conditions[k]
            # The least level that leaves room lies between these.
            bound = SIDES[relation] * ((change.get("lower") if relation == "<=" else change.get("upper")) if "lower" in change else change["to"])
            for row, value in zip(lacks, seen):
                if all(v <= 0 for i, v in enumerate(row) if i != k):
                    self.expect(SIDES[relation] * value[k] >= bound - 1e-9, scene, f"a better level than {change}: {value[k]}")
            at = seen[places.index(change["at"])] if "at" in change else None
            if at and change["reached"]:
                self.expect(SIDES[relation] * at[k] <= SIDES[relation] * change["to"] + 1e-9, scene, f"not taken at its place: {change}")
                self.expect(all(v <= 1e-9 for i, v in enumerate(lacks[places.index(change["at"])]) if i != k), scene, f"no place: {change}")
        if feasible:
            return
        self.expect(not any(all(v <= 0 for v in row) for row in lacks), scene, "a feasible position")
        conflict = [k for k, t in enumerate(texts) if any(same(t, c) for c in answer["conflict"])]
        self.expect(len(conflict) == len(answer["conflict"]), scene, f"names: {answer['conflict']}")
        self.expect(not any(all(row[k] <= 0 for k in conflict) for row in lacks), scene, "no conflict")
        for left in conflict:
            rest = self.explained(scene, [texts[k] for k in conflict if k != left])
            if "code" not in rest:  # decided
                self.expect(rest["feasible"], scene, f"not minimal: {answer['conflict']}")
        if scene.boxes:
            self.server.ask("load", text=scene.text([texts[k] for k in conflict]))
            self.expect(self.server.ask("map")["empty"], scene, "no conflict by the map")
        all_of_them = answer["relax_all"]
        if all_of_them["upper"] is not None:
            [row] = self.values(scene, [all_of_them["at"]])
            most = max(SIDES[r] * (v - level) for (_, _, r, level), v in zip(scene.conditions, row))
            self.expect(most <= all_of_them["upper"] + 1e-9, scene, f"{all_of_them}: lacks {most}")
            self.expect(all(max(row) >= all_of_them["lower"] for row in lacks), scene, f"less than {all_of_them}")


def same(a, b):
    """Equal but for the spelling of numbers."""
    parts = [re.split(r"(-?\d+\.?\d*)$", text) for text in (a, b)]
    return parts[0][0] == parts[1][0] and float(parts[0][1]) == float(parts[1][1])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    rng = random.Random(options.seed)
    check = Check(options.program, rng)
    left, undecided = {True: options.count // 5, False: options.count}, 0
    while any(left.values()):
        scene = Scene(rng)
        if len(set(scene.texts())) < len(scene.conditions):
            continue
        answer = check.explained(scene, scene.texts())
        if "code" in answer:
            undecided += 1
            check.expect("is not decided" in answer["message"], scene, answer["message"])
            continue
        if left[answer["feasible"]]:
            left[answer["feasible"]] -= 1
            check.run(scene, answer)
    for fault in check.faults:
        print(fault)
    print(f"{options.count} contradictions, {undecided} scenes not decided, {len(check.faults)} faults")
    return 1 if check.faults else 0


if __name__ == "__main__":
    sys.exit(main())
