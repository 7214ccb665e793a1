#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""What doxygen reads of a header, in the house's way of writing:

* the opening prose is the page of the file, and the words of a class or struct that has none of its own;
* what stands behind a value (`Data`) is left out;
* `//` behind a member or an enumerator is its word, of several on one line that of each;
* a declaration right below another, with no blank line between, shares the words above it.
"""
import re
import sys

FIELD = re.compile(r"^(\s+)([\w:<>, ]+?[\w>]) (\w+(?: = [\w.\"]+|\{\})?(?:, \w+(?: = [\w.\"]+|\{\})?)+);(\s*///<.*)?$")
INTERNAL = re.compile(r"shared_ptr<const Data> data\)|Data& data\(\)|shared_data\(\)|struct Data;")
DECLARES = re.compile(r"^\s*(?:\[\[nodiscard\]\] )?(?:template|static|friend|explicit|using|inline|const|class|struct|enum|[A-Za-z_][\w:<>]*[ (&*,])")


def prose_of(text):
    match = re.match(r"(?:// SPDX.*\n)*//\n((?://.*\n)+)", text)
    return ([line[2:].strip() for line in match[1].splitlines()], match.end()) if match else ([], 0)


def split_fields(line):
    match = FIELD.match(line)
    if not match or "(" in line.split("///<")[0]:
        return [line]
    return [f"{match[1]}{match[2]} {name};{match[4] or ''}" for name in match[3].split(", ")]


def filtered(text):
    prose, end = prose_of(text)
    out = ["/** \\file", *(f" * {line}" for line in prose), " */"]
    words, fresh, open_declaration = [], False, False
    for raw in text[end:].splitlines():
        if INTERNAL.search(raw):
            continue
        raw = re.sub(r"(;|,|\{\}|\b\w)( +)// (?!NOLINT|----)", r"\1\2///< ", raw) if not raw.lstrip().startswith("//") else raw
        for line in split_fields(raw):
            bare = line.strip()
            if bare.startswith("///") and not bare.startswith("///<"):
                words = words + [line] if fresh else [line]
                fresh = True
            elif not bare or bare.startswith(("//", "}", "public:", "private:", "#", "namespace")):
                words, fresh, open_declaration = [], False, False
            else:
                starts = not open_declaration and DECLARES.match(line) and not bare.startswith(("return", "requires"))
                if starts and not fresh and "///<" not in line:
                    if words:
                        out += words
                    elif re.match(r"(class|struct) \w+( : .*)? \{$", bare):
                        out += [f"/// {line}" for line in prose]
                fresh = False
                open_declaration = not re.split("//", bare)[0].rstrip().endswith((";", "{", "}", ","))
                if bare.endswith("{"):
                    words = []
            out.append(line)
    return "\n".join(out) + "\n"


if __name__ == "__main__":
    print(filtered(open(sys.argv[1], encoding="utf-8").read()), end="")
