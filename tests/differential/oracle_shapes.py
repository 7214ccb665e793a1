# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Shapes of the oracles in doubles: convex polygons, boxes, tetrahedra and pairs of boxes, with distances of points to them."""
import math
from itertools import combinations


def hull(points):
    points = sorted(set(points))
    chains = []
    for run in (points, points[::-1]):
        chain = []
        for p in run:
            while len(chain) > 1 and cross2(chain[-2], chain[-1], p) <= 0:
                chain.pop()
            chain.append(p)
        chains += chain[:-1]
    return chains


def cross2(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def polygon(rng, x, y, size):
    while True:
        points = hull([(x + rng.randint(-size, size), y + rng.randint(-size, size)) for _ in range(5)])
        if len(points) > 2:
            return points


def to_segment(p, a, b):
    d = (b[0] - a[0], b[1] - a[1])
    t = max(0, min(1, ((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / (d[0] ** 2 + d[1] ** 2)))
    return math.dist(p, (a[0] + t * d[0], a[1] + t * d[1]))


def edges(points):
    return list(zip(points, points[1:] + points[:1]))


def to_convex(p, points):
    """The distance of a point to a convex polygon."""
    if all(cross2(a, b, p) >= 0 for a, b in edges(points)):
        return 0.0
    return min(to_segment(p, a, b) for a, b in edges(points))


def apart(first, second):
    """The distance of two convex polygons; 0 where an edge's line does not part them."""
    for one, other in ((first, second), (second, first)):
        if any(all(cross2(a, b, p) < 0 for p in other) for a, b in edges(one)):
            return min(min(to_convex(p, second) for p in first), min(to_convex(p, first) for p in second))
    return 0.0


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross3(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


class Box:
    def __init__(self, rng, origin=False):
        self.low = tuple(rng.randint(-5, 1) for _ in range(3)) if not origin else tuple(-rng.randint(1, 3) for _ in range(3))
        self.high = tuple(c + rng.randint(1, 6) for c in self.low)

    def json(self):
        return {"box": {"min": self.low, "max": self.high}}

    def corners(self):
        return [tuple((self.low, self.high)[k >> i & 1][i] for i in range(3)) for k in range(8)]

    def distance(self, p):
        return math.hypot(*(max(low - x, 0, x - high) for low, x, high in zip(self.low, p, self.high)))


class Tetrahedron:
    def __init__(self, rng):
        while True:
            self.points = [tuple(rng.randint(-5, 5) for _ in range(3)) for _ in range(4)]
            o = self.points[0]
            if abs(dot(sub(self.points[3], o), cross3(sub(self.points[1], o), sub(self.points[2], o)))) > 5:
                return

    def json(self):
        return {"polytope": self.points}

    def corners(self):
        return self.points

    def distance(self, p):
        """To the nearest point of a corner, an edge or a facet, or 0 inside."""
        best, outside = min(math.dist(p, c) for c in self.points), False
        for a, b in combinations(self.points, 2):
            d = sub(b, a)
            t = dot(sub(p, a), d) / dot(d, d)
            if 0 < t < 1:
                best = min(best, math.dist(p, tuple(x + t * y for x, y in zip(a, d))))
        for k in range(4):
            a, b, c = (self.points[i] for i in range(4) if i != k)
            u, v, w = sub(b, a), sub(c, a), sub(p, a)
            n = cross3(u, v)
            side = dot(n, w)
            outside = outside or side * dot(n, sub(self.points[k], a)) < 0
            nn = dot(n, n)
            beta, gamma = dot(cross3(w, v), n) / nn, dot(cross3(u, w), n) / nn
            if beta >= 0 and gamma >= 0 and beta + gamma <= 1:
                best = min(best, abs(side) / math.sqrt(nn))
        return best if outside else 0.0


class Pair:
    """Two boxes."""

    def __init__(self, rng):
        self.boxes = [Box(rng), Box(rng)]

    def json(self):
        return {"union": [b.json() for b in self.boxes]}

    def distance(self, p):
        return min(b.distance(p) for b in self.boxes)


def lattice(box, n):
    """Points of a box, and how far another point of it is from one of them at most."""
    sizes = [(high - low) / n for low, high in zip(box.low, box.high)]
    points = [
        tuple(low + (k[i] + 0.5) * sizes[i] for i, low in enumerate(box.low))
        for k in ((x, y, z) for x in range(n) for y in range(n) for z in range(n))
    ]
    return points, math.hypot(*sizes) / 2
