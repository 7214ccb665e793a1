#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Checks that the number of threads changes no byte of a result: every case in scope and every example, with one thread
and with two, as JSON and (maps) as SVG.

usage: same_bytes.py EXECUTABLE [--scope FILE]

Exit status 0 when all agree."""
import argparse
import json
import os
import subprocess
import sys
import tempfile

from run_cases import CASES, ROOT, Scope, cases


def output(exe, arguments, threads):
    """Exit status and everything written, with `threads` threads."""
    with tempfile.TemporaryDirectory() as folder:
        picture = os.path.join(folder, "map.svg")
        ways = [["--json"]] + ([["-o", picture]] if arguments[0] == "map" else [])
        written = []
        for way in ways:
            done = subprocess.run([exe, *arguments, *way, "--threads", str(threads)], capture_output=True, timeout=300)
            written += [done.returncode, done.stdout]
        if os.path.exists(picture):
            with open(picture, "rb") as file:
                written.append(file.read())
        return written


def scenes(scope, folder):
    """(what it is called, verb and arguments) of every case in scope and every example."""
    for case in cases([CASES], None):
        if scope.beyond(case) or "exit" in case["expect"] or "files" in case:
            continue
        path = os.path.join(folder, case["id"] + ".json")
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
    options = parser.parse_intermixed_args(argv)
    scope = Scope.read(options.scope) if options.scope else Scope()
    exe = os.path.abspath(options.executable)
    differ = count = 0
    with tempfile.TemporaryDirectory() as folder:
        for name, arguments in scenes(scope, folder):
            count += 1
            if output(exe, arguments, 1) != output(exe, arguments, 2):
                differ += 1
                print(f"{name}: one thread and two write different bytes")
    print(f"{count - differ} the same, {differ} different")
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
