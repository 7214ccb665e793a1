#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Checks that each acceptance case of a folder stands in tests/cases too, with the same contents: the same JSON, however
it is laid out.

usage: same_cases.py FOLDER

Exit status 0 when all do, 1 when one does not, 2 where FOLDER holds no case."""
import decimal
import json
import os
import sys

from run_cases import CASES

ENDING = ".case.json"


def number(text):
    """A number by what it is, not by how it is written, and not equal to true."""
    return "number", decimal.Decimal(text)


def contents(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file, parse_float=number, parse_int=number)


def main(argv):
    names = sorted(n for n in os.listdir(argv[0]) if n.endswith(ENDING))
    differ = 0
    for name in names:
        ours = os.path.join(CASES, name)
        if not os.path.exists(ours):
            print(f"{name} is missing in tests/cases")
        elif contents(ours) != contents(os.path.join(argv[0], name)):
            print(f"{name} says something else than the given one")
        else:
            continue
        differ += 1
    print(f"{len(names) - differ} cases are the given ones, {differ} are not")
    return 2 if not names else 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
