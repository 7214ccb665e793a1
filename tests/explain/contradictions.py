#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Scenes whose formulas contradict themselves, explained, and every claim of the explanation asked of `map`.

usage: contradictions.py PROGRAM [--count N] [--seed N] [--poses | --angles | --instants]

Each scene is a disc or a box among two to four shapes and three to six random conditions, some joined by `or` and
`not`. Of the infeasible ones:
* the conflict alone is infeasible, and feasible without any one of its conditions;
* "becomes" makes room, and where the level is exact, a level a thousandth short of it does not;
* with "to": null the other conditions are infeasible alone;
* all levels moved by "upper" make room, by "lower" they do not.
Of as many feasible ones, a level moved by less than its slack leaves room, and by more it does not.
With --poses B is an L at two to four right angles: `map` is asked at each, of B drawn as it stands there, and at
`at` and `angle` the conditions hold. With --angles it stays at a position and turns: `map` is asked for its angles. With --instants B moves along a path, a
position stays, and `map` is asked for instants."""
import argparse
import json
import random
import re
import subprocess
import sys

SIDES = {"<=": 1, "<": 1, ">=": -1, ">": -1}


def asked(program, verb, scene, more):
    """The answer, and what the exit status says."""
    done = subprocess.run([program, verb, "-", "--json", *more], input=json.dumps(scene), capture_output=True, text=True)
    if done.returncode not in (0, 1):
        sys.exit(f"{verb} ends with {done.returncode}: {done.stderr}\n{json.dumps(scene)}")
    return json.loads(done.stdout), done.returncode == 0


class Maps:
    """Whether scenes have feasible positions, of one process that keeps answering."""

    def __init__(self, program):
        self.program = program
        self.pipe = subprocess.Popen([program, "serve", "--stdio"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def ask(self, method, **parameters):
        self.pipe.stdin.write(json.dumps({"id": 1, "method": method, "params": parameters}) + "\n")
        self.pipe.stdin.flush()
        answer = json.loads(self.pipe.stdout.readline())
        if "result" not in answer:
            sys.exit(f"{method}: {answer}\n{parameters}")
        return answer["result"]

    def found(self, verb, scene, more):
        return asked(self.program, verb, scene, more)[1]

    def room(self, scene):
        self.ask("load", text=json.dumps(scene))
        return not self.ask("map")["empty"]


class Condition:
    """word(B, S) relation level, perhaps written as the negation of the opposite."""

    def __init__(self, rng, shapes):
        self.word = rng.choice(["gap", "gap", "reach", "margin", "protrusion"])
        self.shape = rng.choice(shapes)
        self.relation = rng.choice(["<=", "<=", ">=", ">=", "<", ">", "="])
        self.level = rng.randint(-4, 14) + rng.choice([0, 0.5])
        self.negated = self.relation != "=" and rng.random() < 0.2

    def text(self, level=None):
        level = self.level if level is None else level
        stated = {"<=": ">", "<": ">=", ">=": "<", ">": "<="}[self.relation] if self.negated else self.relation
        return f"{'not ' if self.negated else ''}{self.word}(B, {self.shape}) {stated} {level:.12g}"

    def atom(self):
        return self.text().removeprefix("not ")

    def relaxed(self, by):
        if self.relation != "=":
            return self.text(self.level + SIDES[self.relation] * by)
        name = f"{self.word}(B, {self.shape})"
        return f"({name} <= {self.level + by:.12g} and {name} >= {self.level - by:.12g})"


def shape(rng):
    x, y, w, h = (rng.randint(-12, 12), rng.randint(-12, 12), rng.randint(3, 9), rng.randint(3, 9))
    if rng.random() < 0.4:
        return {"disc": {"center": [x, y], "radius": h}}
    return {"box": {"min": [x, y], "max": [x + w, y + h]}}


class Scene:
    def __init__(self, rng):
        self.names = ["S1", "S2", "S3", "S4"][: rng.randint(2, 4)]
        self.shapes = {name: shape(rng) for name in self.names}
        self.shapes["B"] = rng.choice([{"disc": {"center": [0, 0], "radius": 1}}, {"box": {"min": [-1, -1], "max": [1, 1]}}])
        self.conditions = [Condition(rng, self.names) for _ in range(rng.randint(3, 6))]
        # The last two may be alternatives.
        self.either = len(self.conditions) > 3 and rng.random() < 0.4

    def scene(self, texts):
        """`texts`: of each condition; None drops it."""
        texts = list(texts)
        if self.either:
            last = texts[-2:]
            texts[-2:] = [None if None in last else f"({last[0]} or {last[1]})"]
        where = " and ".join(t for t in texts if t is not None) or "true"
        return {"findspace": 1, "unit": "mm", "shapes": self.shapes, "moving": "B", "where": where}

    def poses(self, texts):
        """A scene for each pose of B."""
        return [self.scene(texts)]

    def room(self, maps, texts):
        return any(maps.room(pose) for pose in self.poses(texts))

    def position(self):
        """What the program is told of it besides."""
        return []

    def texts(self):
        return [c.text() for c in self.conditions]

    def with_text(self, k, text):
        texts = self.texts()
        texts[k] = text
        return texts


class PosedScene(Scene):
    L = [[-1, -1], [1.5, -1], [1.5, 0], [0, 0], [0, 1], [-1, 1]]  # lies in every other shape somewhere

    def __init__(self, rng):
        super().__init__(rng)
        self.about = [rng.randint(-2, 2), rng.randint(-2, 2)]
        self.angles = rng.sample([0, 90, 180, 270], rng.randint(2, 4))

    def scene(self, texts):
        self.shapes["B"] = {"polygon": self.L}
        return super().scene(texts) | {"free": {"pose": {"about": self.about, "angles": self.angles}}}

    def stands(self, angle):
        (a, b), out = self.about, []
        cosine, sine = {0: (1, 0), 90: (0, 1), 180: (-1, 0), 270: (0, -1)}[angle]
        for x, y in self.L:
            out.append([a + cosine * (x - a) - sine * (y - b), b + sine * (x - a) + cosine * (y - b)])
        return {"polygon": out}

    def poses(self, texts, angles=None):
        drawn = super().scene(texts)
        return [drawn | {"shapes": self.shapes | {"B": self.stands(a)}} for a in angles or self.angles]


class AngledScene(PosedScene):
    def __init__(self, rng):
        super().__init__(rng)
        self.place = f"{rng.randint(-6, 6)},{rng.randint(-6, 6)}"

    def scene(self, texts):
        return super().scene(texts) | {"free": {"angle": {"about": self.about}}}

    def room(self, maps, texts):
        return maps.found("map", self.scene(texts), self.position())

    def position(self):
        return ["--at", self.place]


class MovingScene(Scene):
    def __init__(self, rng):
        super().__init__(rng)
        self.place = f"{rng.randint(-6, 6)},{rng.randint(-6, 6)}"
        times = sorted(rng.sample(range(10), rng.randint(2, 4)))
        self.motion = {"time": [0, 10], "B": {"times": times, "path": [[rng.randint(-9, 9), rng.randint(-9, 9)] for _ in times]}}

    def scene(self, texts):
        return super().scene(texts) | {"motion": self.motion, "free": "time"}

    def room(self, maps, texts):
        return maps.found("map", self.scene(texts), self.position())

    def position(self):
        return ["--at", self.place]


class Check:
    def __init__(self, program):
        self.program, self.maps = program, Maps(program)
        self.faults = []

    def room(self, scene, texts):
        return scene.room(self.maps, texts)

    def at(self, scene, texts, found):
        """At the position and the angle that are named the conditions hold, but for the rounding of the position."""
        if "time" in found:
            # The instant is rounded, and may be the only one.
            holds = asked(self.program, "map", scene.scene(texts), scene.position())[0]["intervals"]
            good = any(i["from"] - 1e-9 <= found["time"] <= i["to"] + 1e-9 for i in holds)
            self.expect(good, scene, f"does not hold at {scene.place}: {found}, {holds}")
        if "angle" not in found:
            return
        if "at" not in found:
            # The angle is rounded: a touching may be lost, but not by more than that.
            near = [f"--angle={found['angle'] + by!r}" for by in (0, -1e-9, 1e-9)]
            good = any(self.maps.found("check", scene.scene(texts), [*scene.position(), a]) for a in near)
            self.expect(good, scene, f"does not hold at {scene.place}: {found}")
            return
        (pose,) = scene.poses(texts, [found["angle"]])
        self.maps.ask("load", text=json.dumps(pose))
        if not self.maps.ask("check", at=found["at"])["true"]:
            near = self.maps.ask("nearest", at=found["at"])["nearest_feasible"]
            self.expect(near is not None and near["distance"] < 1e-9, scene, f"does not hold: {found}, {near}")

    def expect(self, good, scene, what):
        if not good:
            self.faults.append(f"{what}\n  {json.dumps(scene.scene(scene.texts()))}")

    def index(self, scene, text):
        found = [k for k, c in enumerate(scene.conditions) if same(c.atom(), text)]
        self.expect(len(found) == 1, scene, f"names no condition: {text}")
        return found[0] if found else 0

    def conflict(self, scene, answer):
        kept = {self.index(scene, t) for t in answer["conflict"]}

        def only(some):
            return [t if k in some else None for k, t in enumerate(scene.texts())]

        self.expect(not self.room(scene, only(kept)), scene, f"no conflict: {answer['conflict']}")
        for k in kept:
            self.expect(self.room(scene, only(kept - {k})), scene, f"not minimal: {answer['conflict']}")
        self.expect(answer["smallest"], scene, "smallest is not proved")

    def level(self, scene, change, slack):
        k = self.index(scene, change["text"])
        c = scene.conditions[k]
        if change["to"] is None:
            if not slack:
                self.expect(not self.room(scene, scene.with_text(k, None)), scene, f"some level: {change['text']}")
            return
        if c.relation == "=" or (not change.get("proven", True) and not isinstance(scene, AngledScene)):
            return
        word = "not " if c.negated else ""
        if "becomes" in change:
            self.expect(self.room(scene, scene.with_text(k, word + change["becomes"])), scene, f"no room: {change}")
            if change["reached"]:
                self.at(scene, scene.with_text(k, word + change["becomes"]), change)
        nearest = change.get("lower" if SIDES[c.relation] > 0 else "upper", change["to"])
        short = float(f"{nearest - SIDES[c.relation] * 1e-3:.12g}")
        self.expect(not self.room(scene, scene.with_text(k, c.text(short))), scene, f"not least: {change}")

    def together(self, scene, t):
        if t["upper"] is None:
            return
        for by, room in ((t["upper"], True), (t["lower"], False)):
            self.expect(self.room(scene, [c.relaxed(by) for c in scene.conditions]) == room, scene, f"{t} at {by}")
        self.at(scene, [c.relaxed(t["upper"]) for c in scene.conditions], t)
        self.expect(t["upper"] - t["lower"] <= t["upper"] / 500, scene, f"wide: {t}")


def same(a, b):
    """Equal but for the spelling of numbers."""
    parts = [re.split(r"(-?\d+\.?\d*)$", text) for text in (a, b)]
    return parts[0][0] == parts[1][0] and float(parts[0][1]) == float(parts[1][1])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--poses", action="store_true")
    parser.add_argument("--angles", action="store_true")
    parser.add_argument("--instants", action="store_true")
    options = parser.parse_args()
    rng = random.Random(options.seed)
    check = Check(options.program)
    left = {True: options.count // 5, False: options.count}
    while any(left.values()):
        kind = AngledScene if options.angles else MovingScene if options.instants else PosedScene if options.poses else Scene
        scene = kind(rng)
        if len({c.atom() for c in scene.conditions}) < len(scene.conditions):
            continue
        if not left[check.room(scene, scene.texts())]:
            continue
        answer, feasible = asked(options.program, "explain", scene.scene(scene.texts()), scene.position())
        left[feasible] -= 1
        check.expect(feasible == answer["feasible"], scene, "exit status")
        if not feasible:
            check.conflict(scene, answer)
            check.together(scene, answer["relax_all"])
        for change in answer["slack" if feasible else "relax"]:
            check.level(scene, change, feasible)
    for fault in check.faults:
        print(fault)
    print(f"{options.count} contradictions, {len(check.faults)} faults")
    return 1 if check.faults else 0


if __name__ == "__main__":
    sys.exit(main())
