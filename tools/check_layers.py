#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Checks the rules of the house that a compiler does not see, and prints every place that breaks one.

usage: check_layers.py [ROOT]

1. A file of src/<layer>/<street>/ includes only its own layer and lower ones, always as "layer/street/file.h". The
   program, apps/<street>/, stands above all layers; its own files are "street/file.h". Within a layer no streets
   include each other in a circle. A street has at most 40 files, and its layer's README names it.
2. A header of include/findspace/ includes only the standard library and its neighbours.
3. Every source file opens with the two SPDX lines.
4. Outside src/exact no small constant (1e-9, ratio(1, 1000000)) and no power of two (0x1p-40, 1 / (1 << 40)) stands
   in the code: only src/exact decides
   signs, and margins stand in src/exact/margins with their derivation. One that is no margin says so on its
   line: `// no sign: why`.
5. The program is a client of the public headers: its files include no layer.

Exit status 0 when all hold. docs/architecture.md says what the layers are for."""
import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LAYERS = ["exact", "plane", "space", "distance", "formula", "planning", "packing", "api", "io", "apps"]
CODE = (".h", ".cpp")
MOST_FILES = 40  # of a street
MOST_LINES = 10  # of the README of a layer
OWN = ("src", "include", "apps", "tests", "bench", "python", "cad", "tools")
SPDX = ("SPDX-License-Identifier: Apache-2.0", "SPDX-FileCopyrightText: findspace contributors")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
SMALL = re.compile(r"(?<![\w.])\d*\.?\d*[eE]-\d+")
POWER = re.compile(r"(?<![\w.])0[xX][\da-fA-F.']+[pP][+-]?\d+|/ *\(1 *<< *[2-6]\d\)")
PART = re.compile(r"\bconst\w* [^;]*\bratio\(1, *1(?:'?000){2,}\)")
NOT_YET = ()


def files(root, folder):
    for path, folders, names in os.walk(os.path.join(root, folder)):
        folders[:] = sorted(f for f in folders if not f.startswith(".") and f != "__pycache__")
        for name in sorted(names):
            yield os.path.relpath(os.path.join(path, name), root)


def read(root, path):
    with open(os.path.join(root, path), encoding="utf-8", errors="replace") as file:
        return file.read()


def without_comments(text):
    """The text with comments and the insides of strings blanked, line numbers kept."""
    token = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)
    return token.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), text)


def includes(text):
    for number, line in enumerate(text.splitlines(), 1):
        found = INCLUDE.match(line)
        if found:
            yield number, found.group(1), found.group(2)


def folder_of(layer):
    return "apps" if layer == "apps" else os.path.join("src", layer)


def street_files(root):
    """(layer, street, path) of every source file, and what stands elsewhere as (None, None, path)."""
    for path in files(root, "src"):
        parts = path.split(os.sep)
        if path.endswith(CODE):
            known = len(parts) == 4 and parts[1] in LAYERS[:-1]
            yield (parts[1], parts[2], path) if known else (None, None, path)
    for path in files(root, "apps"):
        parts = path.split(os.sep)
        if path.endswith(CODE) and parts[1:] != ["findspace.cpp"]:  # main
            yield ("apps", parts[1], path) if len(parts) == 3 else (None, None, path)


def included_streets(root, layer, path):
    """(line, name, layer, street) of each include of the project; layer and street are None where it names none."""
    for number, kind, name in includes(read(root, path)):
        parts = name.split("/")
        if kind == "<" or parts[0] == "findspace":
            continue
        if layer == "apps" and len(parts) == 2:
            parts.insert(0, "apps")
        known = len(parts) == 3 and parts[0] in LAYERS
        yield number, name, *(parts[:2] if known else (None, None))


def check_layer_includes(root):
    for layer, _, path in street_files(root):
        if layer is None:
            yield path, 1, "is in no street src/<layer>/<street>/ or apps/<street>/"
            continue
        for number, name, other, _ in included_streets(root, layer, path):
            if other is None:
                yield path, number, f'include "{name}" names no layer and street'
            elif LAYERS.index(other) > LAYERS.index(layer):
                yield path, number, f'{layer} includes "{name}" from a higher layer'


def check_clients(root):
    for layer, _, path in street_files(root):
        if layer != "apps":
            continue
        for number, name, other, _ in included_streets(root, layer, path):
            if other != "apps":
                yield path, number, f'a client of the public headers includes "{name}"'


def street_graph(root):
    """{(layer, street): {street of the same layer: (path, line) of the first include}}"""
    graph = {}
    for layer, street, path in street_files(root):
        if layer is None:
            continue
        below = graph.setdefault((layer, street), {})
        for number, _, other, there in included_streets(root, layer, path):
            if other == layer and there != street:
                below.setdefault(there, (path, number))
    return graph


def order_of_streets(graph, layer):
    """The streets of a layer, lower ones first, and the circles that remain."""
    left = {street: set(below) for (of, street), below in graph.items() if of == layer}
    order = []
    while left:
        free = sorted(street for street, below in left.items() if not below & set(left))
        if not free:
            break
        order += free
        for street in free:
            del left[street]
    return order, left


def check_streets(root):
    graph = street_graph(root)
    for layer in LAYERS:
        order, circle = order_of_streets(graph, layer)
        for street in sorted(circle):
            for other in sorted(set(graph[layer, street]) & set(circle)):
                path, number = graph[layer, street][other]
                yield path, number, f"street {layer}/{street} stands in a circle with {layer}/{other}"
        readme = os.path.join(folder_of(layer), "README.md")
        text = read(root, readme) if os.path.exists(os.path.join(root, readme)) else ""
        if not text or len(text.splitlines()) > MOST_LINES:
            yield readme, 1, f"a layer has a README of at most {MOST_LINES} lines that says what each street holds"
        named = re.findall(r"(?:^\* |\. |, )`(\w+)/`", text, re.M)  # a line may name two
        if sorted(named) != sorted(order + list(circle)):
            yield readme, 1, f"names the streets {named}, and there are {order}"
        below = {street: number for number, street in enumerate(named)}
        for street in named:
            for other in graph.get((layer, street), {}):
                if below.get(other, -1) > below[street]:
                    yield readme, 1, f"{street} includes {other}, which the README names later"
    count = {}
    for layer, street, path in street_files(root):
        count[layer, street] = count.get((layer, street), 0) + 1
    for (layer, street), number in sorted(count.items(), key=str):
        if number > MOST_FILES:
            yield os.path.join(folder_of(layer), street), 1, f"has {number} files; a street has at most {MOST_FILES}"


def check_public_headers(root):
    for path in files(root, "include"):
        for number, kind, name in includes(read(root, path)):
            standard = kind == "<" and re.fullmatch(r"[a-z_]+", name)
            if not standard and not name.startswith("findspace/"):
                yield path, number, f"a public header includes {name}"


def check_licence_lines(root):
    for folder in OWN:
        for path in files(root, folder):
            text = read(root, path)
            if not (path.endswith(CODE + (".py", "CMakeLists.txt")) or text.startswith("#!")):
                continue
            lines = text.splitlines()
            first = 1 if lines and lines[0].startswith("#!") else 0
            if any(mark not in line for mark, line in zip(SPDX, lines[first:first + 2] + ["", ""])):
                yield path, 1, "does not open with the two SPDX lines"


def check_small_constants(root):
    for folder in ("src", "include", "apps"):
        for path in files(root, folder):
            if not path.endswith(CODE) or path.startswith(os.path.join("src", "exact")):
                continue
            text = read(root, path)
            code = without_comments(text).splitlines()
            for number, (line, whole) in enumerate(zip(code, text.splitlines()), 1):
                if "// no sign: " in whole:
                    continue
                if SMALL.search(line) or PART.search(line) or (POWER.search(line) and not path.startswith(NOT_YET)):
                    yield path, number, "a small constant outside src/exact; margins stand in exact/margins"


def main(argv):
    root = argv[0] if argv else ROOT
    faults = 0
    for check in (check_layer_includes, check_clients, check_streets, check_public_headers, check_licence_lines,
                  check_small_constants):
        for path, line, fault in check(root):
            print(f"{path}:{line}: {fault}")
            faults += 1
    print("layers and house rules hold" if not faults else f"{faults} places break a rule of the house")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
