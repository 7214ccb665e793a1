#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Compares what gdb prints with tools/gdb/findspace_printers.py with what tests/tools/gdb_values.cpp says.

usage: gdb_printers.py PROGRAM    (gdb_values.cpp compiled with debug information)

Exit status 0 where all texts are equal, 77 (skipped) where there is no gdb or it may not run programs here."""
import os
import re
import shutil
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PRINTERS = os.path.join(ROOT, "tools", "gdb", "findspace_printers.py")
SOURCE = os.path.join(ROOT, "tests", "tools", "gdb_values.cpp")
SKIPPED = 77


def expectations():
    """For each function that stops: its (expression, text) pairs, in the order in which they run."""
    with open(SOURCE, encoding="utf-8") as file:
        parts = re.split(r"^  look\(\);$", file.read(), flags=re.M)
    return [re.findall(r"^  /// (\S+) = (.+)$", part, re.M) for part in parts[:-1]]


def gdb(program, commands):
    arguments = ["gdb", "-nx", "-batch", "-ex", "set width 0", "-ex", "set print elements 0"]
    for command in commands:
        arguments += ["-ex", command]
    environment = {**os.environ, "ASAN_OPTIONS": "detect_leaks=0", "DEBUGINFOD_URLS": ""}
    done = subprocess.run([*arguments, program], capture_output=True, text=True, timeout=300, env=environment, check=False)
    return done.stdout + done.stderr


def commands_for(stops):
    yield f"source {PRINTERS}"
    yield "break gdb_values.cpp:look"
    yield "run"
    for stop in stops:
        yield "up"
        for number, (expression, _) in enumerate(stop):
            yield f"printf \"<{number}> \""
            yield f"output {expression}"
            yield "printf \"\\n\""
        yield "continue"


def main(argv):
    if len(argv) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    if shutil.which("gdb") is None:
        print("skipped: gdb is not installed (tools/setup check)")
        return SKIPPED
    if "exited normally" not in gdb("/bin/true", ["run"]):
        print("skipped: gdb may not run programs here")
        return SKIPPED
    stops = expectations()
    said = gdb(argv[0], commands_for(stops))
    printed = re.findall(r"^<(\d+)> (.*)$", said, re.M)
    wanted = [(str(number), expression, text) for stop in stops for number, (expression, text) in enumerate(stop)]
    if len(wanted) < len(stops) or [number for number, _ in printed] != [number for number, _, _ in wanted]:
        print(f"gdb printed {len(printed)} of {len(wanted)} values:\n{said}")
        return 1
    wrong = [(expression, text, found) for (_, expression, text), (_, found) in zip(wanted, printed) if text != found]
    for expression, text, found in wrong:
        print(f"{expression}:\n  should be {text}\n  is        {found}")
    print(f"{len(wanted) - len(wrong)} of {len(wanted)} values printed as they should be")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
