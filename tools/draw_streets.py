#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Draws docs/pictures/streets.svg: the layers and streets of src/ and apps/, and the includes between them.

usage: draw_streets.py            writes the picture
       draw_streets.py --check    ends with status 1 where the committed picture is another one
       options: [--root ROOT] [--output FILE]

A layer is a band, the lowest at the bottom. A street is a box with its files and its lines in hundreds. An arrow goes
from a street to one that it includes, always downwards; arrows that follow from others are left out. Includes of other
layers are counted at the left of the band. --check compares no counts: layers, streets and arrows are what must be right.

The same sources give the same bytes. Streets stand in rows by the longest path below them. An arrow over more than one
row passes the rows between in gaps of its own; the order in a row is the one with fewest crossings that swaps find."""
import argparse
import os
import re
import sys
from xml.sax.saxutils import escape

import check_layers

WIDTH = 1000       # of the picture, or more where a row needs it
LABEL = 240        # width of the column with the names of the layers
EDGE = 16          # free on all sides, and between the column of names and the streets
BOX, ROW = 30, 54  # height of a box; distance of two rows
BAND = 12          # free above the highest and below the lowest row of a band
GAP = 20           # least distance of two boxes of a row
STRAIGHT = 8       # an arrow that goes less aside goes straight down
LINE = 17          # of text in the column of names
NAME, SMALL = 15, 12  # font sizes
SHADES = ("#f7f7f4", "#eef1f4")
FONT = "DejaVu Sans, Verdana, sans-serif"


# --- what is drawn -------------------------------------------------------------------------------------------------

def counts_of_streets(root):
    """{(layer, street): (files, lines)}"""
    counts = {}
    for layer, street, path in check_layers.street_files(root):
        if layer is not None:
            files, lines = counts.get((layer, street), (0, 0))
            counts[layer, street] = files + 1, lines + len(check_layers.read(root, path).splitlines())
    return counts


def counts_of_layers(root):
    """{layer: {lower layer: includes}}"""
    counts = {layer: {} for layer in check_layers.LAYERS}
    for layer, _, path in check_layers.street_files(root):
        for _, _, other, _ in check_layers.included_streets(root, layer, path) if layer else ():
            if other is not None and other != layer:
                counts[layer][other] = counts[layer].get(other, 0) + 1
    return counts


def essential(below):
    """The includes that follow from no others: {street: set of streets}."""
    reached = {}

    def reach(street):
        if street not in reached:
            reached[street] = set(below[street]).union(*(reach(other) for other in below[street]))
        return reached[street]

    return {street: {other for other in others if not any(other in reach(third) for third in others)}
            for street, others in below.items()}


def rank_of_streets(order, below):
    """The row of each street, 0 the lowest: the longest path below it."""
    rank = {}
    for street in order:
        rank[street] = 1 + max((rank[other] for other in below[street]), default=-1)
    return rank


# --- one band ------------------------------------------------------------------------------------------------------

class Node:
    """A box in a row of a band, or the gap (name None) in which an arrow passes it."""

    def __init__(self, name, text, width):
        self.name, self.text, self.width = name, text, width
        self.up, self.down, self.middle = [], [], 0.0


def text_width(text, size, bold=False):
    return len(text) * size * (0.69 if bold else 0.6)


def size_text(count):
    files, lines = count
    return f"{files} / {lines / 1000:.1f}k"


def rows_of_band(order, below, counts):
    """The rows of nodes, the lowest first, joined from row to row."""
    rank = rank_of_streets(order, below)
    rows = [[] for _ in range(1 + max(rank.values()))]
    node = {}
    for street in order:
        text = size_text(counts[street])
        width = text_width(street, NAME, bold=True) + 8 + text_width(text, SMALL) + 16
        node[street] = Node(street, text, round(width))
        rows[rank[street]].append(node[street])
    for street in order:
        for other in sorted(below[street]):
            lower = node[other]
            for passed in range(rank[other] + 1, rank[street]):
                gap = Node(None, "", 4)
                rows[passed].append(gap)
                join(gap, lower)
                lower = gap
            join(node[street], lower)
    return rows


def join(upper, lower):
    upper.down.append(lower)
    lower.up.append(upper)


def crossings(upper, lower):
    place = {id(node): k for k, node in enumerate(lower)}
    ends = [(k, place[id(other)]) for k, node in enumerate(upper) for other in node.down]
    return sum((a[0] - b[0]) * (a[1] - b[1]) < 0 for i, a in enumerate(ends) for b in ends[:i])


def order_rows(rows):
    """Swaps neighbours of a row as long as that leaves fewer crossings."""
    def total():
        return sum(crossings(upper, lower) for lower, upper in zip(rows, rows[1:]))

    best, improved = total(), True
    while improved:
        improved = False
        for row in rows:
            for i in range(len(row)):
                for j in range(i + 1, len(row)):
                    row[i], row[j] = row[j], row[i]
                    now = total()
                    if now < best:
                        best, improved = now, True
                    else:
                        row[i], row[j] = row[j], row[i]


def place_row(row, wish, left, right):
    """Puts the nodes of a row next to their wishes in the sense of least squares, in order and not overlapping."""
    offset, blocks = 0.0, []
    for node in row:
        offset += node.width / 2
        blocks.append([wish(node) - offset, 1])  # the start of the row as this node would have it, and its weight
        offset += node.width / 2 + GAP
        while len(blocks) > 1 and blocks[-2][0] > blocks[-1][0]:
            (a, m), (b, n) = blocks[-2:]
            blocks[-2:] = [[(a * m + b * n) / (m + n), m + n]]
    starts = [min(max(start, left), right - offset + GAP) for start, weight in blocks for _ in range(weight)]
    offset = 0.0
    for node, start in zip(row, starts):
        node.middle = start + offset + node.width / 2
        offset += node.width + GAP


def place_nodes(rows, left, right):
    middle = (left + right) / 2
    for row in rows:
        place_row(row, lambda node: middle, left, right)

    def wish(node):
        near = node.up + node.down
        return (sum(other.middle for other in near) + 0.3 * middle) / (len(near) + 0.3)

    for _ in range(60):
        for row in rows + rows[::-1]:
            place_row(row, wish, left, right)


def wrapped(words, width, size):
    lines = [""]
    for word in words:
        longer = f"{lines[-1]} {word}".strip()
        if lines[-1] and text_width(longer, size) > width:
            lines.append(word)
        else:
            lines[-1] = longer
    return lines


class Band:
    """A layer: its rows of streets, its label, and how high it is."""

    def __init__(self, layer, graph, counts, of_other_layers):
        below = {street: set(others) for (of, street), others in graph.items() if of == layer}
        order, circle = check_layers.order_of_streets(graph, layer)
        if circle:
            raise SystemExit(f"draw_streets.py: streets of {layer} include each other in a circle: {', '.join(sorted(circle))}")
        own = {street: counts[layer, street] for street in order}
        self.layer = layer
        self.rows = rows_of_band(order, essential(below), own)
        order_rows(self.rows)
        self.width = LABEL + 2 * EDGE + max(sum(node.width + GAP for node in row) - GAP for row in self.rows)
        files, lines = (sum(count[k] for count in own.values()) for k in (0, 1))
        self.label = [f"{files} files, {lines / 1000:.1f}k lines"]
        if of_other_layers:
            words = [f"{other}\u00a0{of_other_layers[other]}," for other in reversed(check_layers.LAYERS) if other in of_other_layers]
            self.label += wrapped(["includes:"] + words[:-1] + [words[-1][:-1]], LABEL - EDGE, SMALL)
        self.height = max(2 * BAND + ROW * (len(self.rows) - 1) + BOX, 2 * BAND + 20 + LINE * len(self.label))


# --- the picture ---------------------------------------------------------------------------------------------------

def arrow(upper, lower, y):
    """The path from a box down to another, through the gaps between; y gives the middle of the row of a node."""
    points = [[port(upper, upper.down, lower), y[id(upper)] + BOX / 2]]
    while lower.name is None:
        points += [[lower.middle, y[id(lower)] - BOX / 2], [lower.middle, y[id(lower)] + BOX / 2]]
        upper, lower = lower, lower.down[0]
    points.append([port(lower, lower.up, upper), y[id(lower)] - BOX / 2 - 1])
    for first, second in zip(points, points[1:]):
        if abs(first[0] - second[0]) < STRAIGHT:  # upright rather than nearly so
            first[0] = second[0] if first is points[0] else first[0]
            second[0] = first[0]
    return "M" + "L".join(f"{x:.0f} {height:.0f}" for x, height in points)


def port(node, ends, end):
    """Where on its side an arrow leaves a box, or arrives: in the order of the other ends."""
    place = sorted(ends, key=lambda other: other.middle).index(end)
    apart = min(24.0, (node.width - 16) / max(len(ends) - 1, 1))
    return node.middle + (place - (len(ends) - 1) / 2) * apart


def band_elements(band, top, width, shade):
    place_nodes(band.rows, LABEL + EDGE, width - EDGE)
    yield f'<rect x="0" y="{top}" width="{width}" height="{band.height}" fill="{shade}"/>'
    yield f'<text x="{EDGE}" y="{top + BAND + 15}" class="layer">{band.layer}</text>'
    for k, line in enumerate(band.label):
        yield f'<text x="{EDGE}" y="{top + BAND + 36 + LINE * k}" class="small">{escape(line)}</text>'
    used = ROW * (len(band.rows) - 1)
    lowest = top + (band.height + used) / 2
    y = {id(node): lowest - ROW * k for k, row in enumerate(band.rows) for node in row}
    nodes = [node for row in reversed(band.rows) for node in row if node.name]
    for upper in nodes:
        for lower in upper.down:
            yield f'<path d="{arrow(upper, lower, y)}" marker-end="url(#tip)"/>'
    for node in nodes:
        left, high = node.middle - node.width / 2, y[id(node)] - BOX / 2
        yield f'<rect x="{left:.0f}" y="{high:.0f}" width="{node.width}" height="{BOX}" rx="4" class="street"/>'
        yield (f'<text x="{left + 8:.0f}" y="{high + 20:.0f}" class="street">{node.name}'
               f'<tspan dx="8" class="small">{node.text}</tspan></text>')


def picture(root):
    graph, counts, layers = check_layers.street_graph(root), counts_of_streets(root), counts_of_layers(root)
    bands = [Band(layer, graph, counts, layers[layer]) for layer in check_layers.LAYERS
             if any(of == layer for of, _ in graph)]
    height, width = sum(band.height for band in bands) + 34, max([WIDTH] + [band.width for band in bands])
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
             f'font-family="{FONT}" font-size="{SMALL}">',
             "<title>The layers and streets of src/</title>",
             "<style>text{fill:#222}.layer{font-size:18px;font-weight:bold}"
             f".street{{font-size:{NAME}px;font-weight:bold}}.small{{font-size:{SMALL}px;font-weight:normal;fill:#555}}"
             "rect.street{fill:#fff;stroke:#3b5b7a;stroke-width:1.2}path{fill:none;stroke:#3b5b7a;stroke-width:1.1}"
             "#tip path{fill:#3b5b7a;stroke:none}</style>",
             '<defs><marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
             '<path d="M0 0.8L8 4L0 7.2Z"/></marker></defs>',
             f'<rect width="{width}" height="{height}" fill="#fff"/>']
    top = 0
    for k, band in enumerate(reversed(bands)):
        lines += band_elements(band, top, width, SHADES[k % 2])
        top += band.height
    lines.append(f'<text x="{EDGE}" y="{top + 22}" class="small">Box: a street, its files / its lines. Arrow: includes; '
                 "left out where it follows from others. A layer includes only those below it.</text>")
    return "\n".join(lines + ["</svg>", ""])


def without_counts(drawn):
    return re.sub(r'class="small">[^<]*<', "<", drawn)


def main(argv):
    parser = argparse.ArgumentParser(usage=__doc__.split("\n\n")[1].removeprefix("usage: "))
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--root", default=check_layers.ROOT)
    parser.add_argument("--output", default=None)
    options = parser.parse_args(argv)
    name = os.path.join("docs", "pictures", "streets.svg")
    path = options.output or os.path.join(options.root, name)
    drawn = picture(options.root)
    if not options.check:
        with open(path, "w", encoding="utf-8") as file:
            file.write(drawn)
        return 0
    committed = check_layers.read("", path) if os.path.exists(path) else None
    if committed is not None and without_counts(committed) == without_counts(drawn):
        print(f"{name} shows the streets as they are")
        return 0
    print(f"{path} {'is missing' if committed is None else 'does not show the streets as they are'}; "
          "run: python3 tools/draw_streets.py", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
