#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Lays out cases so that a person can read them: a ring a line, short things on one line. The contents stay.

usage: format_cases.py [FILE or FOLDER]...          rewrites the cases (default: tests/cases)
       format_cases.py --check [FILE or FOLDER]...  rewrites none; status 1 where a case is laid out otherwise

An object of at most three levels stands on one line where it fits, and so does an array of at most two. An array of
numbers or of points that does not fit fills lines of 140 columns. Of everything else each member has a line.

Only white space changes: the tool works on tokens, so that 1e-09 and 0.10 keep their spelling. It compares the tokens
and the parsed contents before and after, and writes nothing where they differ."""
import argparse
import json
import re
import sys

from run_cases import CASES, case_files

COLUMNS = 140
OBJECT_LEVELS, ARRAY_LEVELS = 3, 2  # most levels of what stands on one line
TOKEN = re.compile(r'\s*("(?:[^"\\]|\\.)*"|[-+.\w]+|[][{}:,])')


def tokens(text):
    found, at, end = [], 0, len(text.rstrip())
    while at < end:
        match = TOKEN.match(text, at)
        if not match:
            raise ValueError(f"no JSON at character {at}")
        found.append(match.group(1))
        at = match.end()
    return found


def contents(text):
    """What JSON says, with numbers as they are spelled and members in their order."""
    return json.loads(text, parse_int=str, parse_float=str, object_pairs_hook=lambda pairs: ("object", pairs))


class Value:
    """A value of JSON: a token, or the members of an array or object, with the spelled key of each (None in arrays)."""

    def __init__(self, token):
        self.token, self.keys, self.members = token, [], []

    @property
    def levels(self):
        return 1 + max((m.levels for m in self.members), default=0) if self.token in "[{" else 0

    @property
    def closing(self):
        return "]" if self.token == "[" else "}"

    def fits_one_line(self):
        """Whether its levels allow one line, its own and those of all members."""
        most = {"[": ARRAY_LEVELS, "{": OBJECT_LEVELS}.get(self.token, 0)
        return self.levels <= most and all(m.fits_one_line() for m in self.members)

    def one_line(self):
        if self.token not in "[{":
            return self.token
        inner = ", ".join(m.one_line() if key is None else f"{key}: {m.one_line()}" for key, m in zip(self.keys, self.members))
        return self.token + inner + self.closing


def parse(stream):
    """The value that begins with the next token of a reversed list of tokens of proper JSON."""
    value = Value(stream.pop())
    if value.token not in "[{":
        return value
    while stream[-1] != value.closing:
        if stream[-1] == ",":
            stream.pop()
        value.keys.append(stream.pop() if value.token == "{" else None)
        if value.token == "{":
            stream.pop()  # the colon
        value.members.append(parse(stream))
    stream.pop()
    return value


def filled(value, indent):
    """Members in lines that are as full as the columns allow."""
    lines = [""]
    for member in value.members:
        text = member.one_line()
        if lines[-1] and indent + len(lines[-1]) + len(text) + 3 > COLUMNS:
            lines.append("")
        lines[-1] += (", " if lines[-1] else "") + text
    return lines


def laid_out(value, indent, before):
    """The text of a value on a line that is indented by `indent` and has `before` columns taken, a comma to follow."""
    text = value.one_line()
    if value.token not in "[{" or value.fits_one_line() and before + len(text) + 1 <= COLUMNS:
        return text
    inner = indent + 1
    if value.token == "[" and value.levels <= ARRAY_LEVELS:
        members = filled(value, inner)
    else:
        members = []
        for key, member in zip(value.keys, value.members):
            head = "" if key is None else f"{key}: "
            members.append(head + laid_out(member, inner, inner + len(head)))
    separator = ",\n" + " " * inner
    return f"{value.token}\n{' ' * inner}{separator.join(members)}\n{' ' * indent}{value.closing}"


def formatted(text):
    before, stream = contents(text), tokens(text)
    value = parse(stream[::-1])
    value_lines = laid_out(value, 0, COLUMNS) + "\n"  # the whole is never one line
    if contents(value_lines) != before or tokens(value_lines) != stream:
        raise ValueError("laid out, it would say something else")
    return value_lines


def main(argv):
    parser = argparse.ArgumentParser(usage=__doc__.split("\n\n")[1].removeprefix("usage: "))
    parser.add_argument("--check", action="store_true")
    parser.add_argument("places", nargs="*", default=[CASES])
    options = parser.parse_intermixed_args(argv)
    count = others = 0
    for path in case_files(options.places):
        with open(path, encoding="utf-8", newline="") as file:
            text = file.read()
        try:
            wanted = formatted(text)
        except ValueError as error:
            print(f"{path}: {error}", file=sys.stderr)
            return 2
        count += 1
        if text == wanted:
            continue
        others += 1
        if options.check:
            print(f"{path}: laid out otherwise")
            continue
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(wanted)
    if options.check and others:
        print(f"{others} of {count} cases are laid out otherwise; run: python3 tools/format_cases.py", file=sys.stderr)
        return 1
    print(f"{count} cases, {others} laid out anew")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
