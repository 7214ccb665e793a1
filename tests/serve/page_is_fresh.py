#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""The built page belongs to its sources: the first line of web/built/page.html has their hash, as web/build.mjs takes it.

usage: page_is_fresh.py

This needs neither node nor npm. Whether the bytes are those that the bundler makes, .ci/run checks."""
import hashlib
import os
import sys

WEB = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "web")


def read(name):
    with open(os.path.join(WEB, name), "rb") as file:
        return file.read()


def main():
    sources = ["src/" + name for name in sorted(os.listdir(os.path.join(WEB, "src")))] + ["build.mjs", "package-lock.json"]
    made_of = hashlib.sha256()
    for name in sources:
        made_of.update(name.encode() + b"\n")
        made_of.update(read(name))
    first = read("built/page.html").split(b"\n", 1)[0].decode()
    if first != f"<!-- made of web/ {made_of.hexdigest()} -->":
        sys.exit("web/built/page.html was made of other sources: run tools/build_page and commit web/built")
    for name in ("built/page.html", "built/space.js"):
        if len(read(name)) < 10000:
            sys.exit(f"web/{name} is no built file")
    print("the page is made of its sources")


main()
