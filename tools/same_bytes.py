#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Checks that the number of threads changes no byte of a result: every case in scope and every example, with one thread
and with two, as JSON and (maps) as SVG; and that the order in which unions and intersections list their shapes changes
none of a map or description, as JSON.

usage: same_bytes.py EXECUTABLE [--scope FILE] [--part K/N]

  --part K/N  every Nth of them, beginning with the Kth (1 to N); K may be `day`: which part it is turns with the date
              of the commit, so that N days see them all

Exit status 0 when all agree."""
import argparse
import itertools
import json
import os
import subprocess
import sys
import tempfile

from part_of_day import part_of
from run_cases import CASES, ROOT, SECONDS, Scope, cases


def output(exe, arguments, threads):
    """Exit status and everything written, with `threads` threads."""
    with tempfile.TemporaryDirectory() as folder:
        picture = os.path.join(folder, "map.svg")
        drawn = ["-o", picture] if arguments[0] == "map" else []
        done = subprocess.run([exe, *arguments, "--json", *drawn, "--threads", str(threads)], capture_output=True,
                              timeout=SECONDS)
        written = [done.returncode, done.stdout]
        if os.path.exists(picture):
            with open(picture, "rb") as file:
                written.append(file.read())
        return written


def backwards(node):
    """The same shapes with every union and intersection listed the other way round."""
    if isinstance(node, dict):
        return {key: backwards(value)[::-1] if key in ("union", "intersection") else backwards(value)
                for key, value in node.items()}
    return [backwards(n) for n in node] if isinstance(node, list) else node


def scenes_backwards(scope, folder):
    """(what it is called, arguments, arguments of the scene listed backwards) where that is another scene."""
    for case in cases([CASES], None):
        scene = case.get("scene", {})
        if scope.beyond(case) or "files" in case or case["run"][0] not in ("map", "describe"):
            continue
        other = {**scene, "shapes": backwards(scene.get("shapes"))}
        if "exit" in case["expect"] or other == scene:
            continue
        ways = []
        for name, what in (("forth", scene), ("back", other)):
            path = os.path.join(folder, f"{case['id']}-{name}.json")
            with open(path, "w", encoding="utf-8") as file:
                json.dump(what, file)
            ways.append([case["run"][0], path, *case["run"][1:]])
        yield case["id"], *ways


def scenes(scope, folder):
    """(what it is called, verb and arguments) of every case in scope and every example."""
    for case in cases([CASES], None):
        if scope.beyond(case) or "exit" in case["expect"] or "files" in case:
            continue
        ending = os.path.splitext(case.get("scene_file", "scene.json"))[1]
        path = os.path.join(folder, case["id"] + ending)
        with open(path, "w", encoding="utf-8") as file:
            file.write(case.get("scene_text") or json.dumps(case["scene"]))
        yield case["id"], [case["run"][0], path, *case["run"][1:]]
    examples = os.path.join(ROOT, "examples")
    for name in sorted(n for n in os.listdir(examples) if n.endswith(".json")):
        path = os.path.join(examples, name)
        with open(path, encoding="utf-8") as file:
            if '"where"' in file.read():    # else it is no question for map
                yield name, ["map", path]


def main(argv):
    parser = argparse.ArgumentParser()
    parser.add_argument("executable")
    parser.add_argument("--scope")
    parser.add_argument("--part", type=part_of, default=(1, 1))
    options = parser.parse_intermixed_args(argv)
    scope = Scope.read(options.scope) if options.scope else Scope()
    exe = os.path.abspath(options.executable)
    first, step = options.part
    differ = count = 0
    with tempfile.TemporaryDirectory() as folder:
        for name, arguments in itertools.islice(scenes(scope, folder), first - 1, None, step):
            count += 1
            if output(exe, arguments, 1) != output(exe, arguments, 2):
                differ += 1
                print(f"{name}: one thread and two write different bytes")
        for name, forth, back in itertools.islice(scenes_backwards(scope, folder), first - 1, None, step):
            count += 1
            if output(exe, forth, 1)[:2] != output(exe, back, 1)[:2]:
                differ += 1
                print(f"{name}: the order of the shapes changes the bytes")
    print(f"{count - differ} the same, {differ} different")
    return 1 if differ or not count else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
