#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""What some tests of a build run: prints the targets, so that nothing else need be built.

usage: targets_of_tests.py PRESET CTEST_OPTION...

The options choose tests as they do for ctest (`-I 2,,3`). PRESET is a test preset of a build that has been configured.
The library of CAD files is among the targets where it is built, as programs load it."""
import os
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def chosen(preset, options):
    """The folder of the build, and the tests."""
    told = subprocess.run(["ctest", "--preset", preset, "-N", *options], cwd=ROOT, capture_output=True, text=True, check=True)
    build = re.search(r"^Test project (.*)$", told.stdout, re.MULTILINE)[1]
    return build, set(re.findall(r"^  Test +#\d+: (\S+)", told.stdout, re.MULTILINE))


def targets(build, names):
    found = set()
    with open(os.path.join(build, "tests", "CTestTestfile.cmake"), encoding="utf-8") as file:
        for line in file:
            test = re.match(r"add_test\(\[=*\[(.*?)\]=*\]", line) or re.match(r"add_test\((\S+)", line)
            if test and test[1] in names:
                found.update(os.path.relpath(path, build) for path in re.findall(r'"(/[^"]*)"', line) if path.startswith(build + "/"))
    return found


def outputs(build):
    told = subprocess.run(["ninja", "-C", build, "-t", "targets", "all"], capture_output=True, text=True, check=True)
    return {line.rpartition(":")[0] for line in told.stdout.splitlines()}


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    preset, *options = sys.argv[1:]
    build, names = chosen(preset, options)
    if not names:
        sys.exit(f"targets_of_tests: no test of {preset} for {' '.join(options)}")
    known = outputs(build)
    print(*sorted((targets(build, names) | {"findspace_cad"}) & known))


if __name__ == "__main__":
    main()
