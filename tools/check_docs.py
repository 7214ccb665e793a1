#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Checks that the documentation reads easily and that its links lead somewhere.

usage: check_docs.py [--table] [ROOT]

It reads README.md, CONTRIBUTING.md, examples/README.md, docs/*.md and docs/decisions/*.md.

1. The mean sentence of a page has at most 25 words, the longest at most 40 (README.md and docs/*.md).
2. Every relative link names a file that exists; one with #place names a heading of that file.

A sentence ends at . ? or ! before a blank, and at the end of its paragraph, list item or table cell. Code blocks and
headings are left out. A word is what blanks separate and has a letter or digit; code between backticks is one word.
The mean counts paragraphs and list items, the longest table cells too: short cells would flatter the mean.

--table prints one row a page. Exit status 0 when all hold."""
import argparse
import glob
import os
import re
import sys

MEAN = 25
LONGEST = 40
LIMITED = ("README.md", "docs/*.md")
READ = LIMITED + ("CONTRIBUTING.md", "examples/README.md", "docs/decisions/*.md")
CODE = "Code"  # stands for what was between backticks
END = re.compile(r"(?<=[.?!])[)\"”]*\s+(?=[^a-z])")
ABBREVIATION = re.compile(r"\b(e\.g|i\.e|et al|cf|vs|No|fig)\.(?=\s)")
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\[\]]*\])*)\]\(([^()\s]+)\)")
ITEM = re.compile(r"\s*(?:[*+-]|\d+\.)\s+")


def blocks(text):
    """(kind, text) of every paragraph, list item ("prose") and table cell ("cell") of a page, code blocks left out."""
    paragraph, fenced = [], False

    def flush():
        if paragraph:
            yield "prose", " ".join(paragraph)
            paragraph.clear()

    for line in text.split("\n"):
        bare = line.strip()
        if bare.startswith("```"):
            fenced = not fenced
            yield from flush()
        elif fenced:
            continue
        elif not bare or bare.startswith("#") or (line.startswith("    ") and not paragraph):
            yield from flush()
        elif bare.startswith("|"):
            yield from flush()
            for cell in re.split(r"(?<!\\)\|", hide_code(bare.strip("|"))):
                for part in cell.split("<br>"):
                    yield "cell", part
        else:
            if ITEM.match(line):
                yield from flush()
                line = ITEM.sub("", line, count=1)
            paragraph.append(line.strip())
    yield from flush()


def hide_code(text):
    return re.sub(r"``.+?``|`[^`]*`", CODE, text)


def plain(text):
    """A block as it is read: links by their text, pictures and code hidden."""
    text = hide_code(text)
    text = LINK.sub(lambda m: "" if m[1] else m[2], text)
    text = re.sub(r"</?[a-z][^>]*>|[*_]{1,2}(?=\S)|(?<=\S)[*_]{1,2}", "", text)
    return ABBREVIATION.sub(lambda m: m[1], text)


def sentences(block):
    for sentence in END.split(plain(block)):
        words = [w for w in sentence.split() if any(c.isalnum() for c in w)]
        if words:
            yield words


def measure(text):
    """Mean words a sentence of the prose, the longest sentence of all, and how many sentences of prose there are."""
    prose, longest = [], []
    for kind, block in blocks(text):
        for words in sentences(block):
            if kind == "prose":
                prose.append(len(words))
            longest = max(longest, words, key=len)
    return sum(prose) / len(prose) if prose else 0.0, longest, len(prose)


def anchors(text):
    """The places of a page that a link may name, as GitHub makes them of headings."""
    found = set()
    for heading in re.findall(r"(?m)^#+\s+(.*)$", re.sub(r"(?ms)^```.*?^```", "", text)):
        heading = LINK.sub(lambda m: m[2], heading).replace("`", "").lower()
        found.add(re.sub(r"[^\w\- ]", "", heading).replace(" ", "-"))
    return found


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def dead_links(root, page, text):
    text = re.sub(r"(?ms)^```.*?^```", "", text)
    for _, _, target in LINK.findall(re.sub(r"`[^`]*`", "", text)):
        if re.match(r"[a-z]+:", target):
            continue
        name, _, place = target.partition("#")
        path = os.path.normpath(os.path.join(root, os.path.dirname(page), name)) if name else os.path.join(root, page)
        if not os.path.exists(path):
            yield f"{page}: the link to {target} leads nowhere"
        elif place and path.endswith(".md") and place not in anchors(read(path)):
            yield f"{page}: {target} names no heading"


def pages(root, patterns):
    return [os.path.relpath(path, root) for pattern in patterns for path in sorted(glob.glob(os.path.join(root, pattern)))]


def main(argv):
    parser = argparse.ArgumentParser(description="Checks sentences and links of the documentation.")
    parser.add_argument("--table", action="store_true", help="print words a sentence of every page")
    parser.add_argument("root", nargs="?", default=os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    options = parser.parse_args(argv)
    limited = set(pages(options.root, LIMITED))
    wrong = []
    for page in pages(options.root, READ):
        text = read(os.path.join(options.root, page))
        mean, longest, count = measure(text)
        if options.table:
            print(f"{page:50} {count:4} sentences, {mean:5.1f} words in the mean, {len(longest):3} in the longest")
        wrong += dead_links(options.root, page, text)
        if page not in limited:
            continue
        if mean > MEAN:
            wrong.append(f"{page}: {mean:.1f} words a sentence in the mean, more than {MEAN}")
        if len(longest) > LONGEST:
            wrong.append(f"{page}: a sentence of {len(longest)} words, more than {LONGEST}: {' '.join(longest)}")
    for line in wrong:
        print(line, file=sys.stderr)
    if not wrong:
        print("docs: sentences and links hold")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
