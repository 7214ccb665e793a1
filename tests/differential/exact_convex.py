# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Distances of convex polygons grown by discs against levels, in fractions: each answer is the sign of value - level.

A shape is a core, a convex polygon, chain of two points or point, and the radius by which it is grown. The contact
obstacle of two such shapes is the hull of the differences of their corners, grown by both radii. The signed distance to
a convex set is a convex function, so its largest value over a way is taken at a way point."""
from fractions import Fraction

from oracle_shapes import cross2, dot, edges, hull, sub


def sign(x):
    return (x > 0) - (x < 0)


def outline(points):
    return hull(points) or points[:1]  # of one point


def add(a, b):
    return (a[0] + b[0], a[1] + b[1])


def square(v):
    return dot(v, v)


def to_segment2(p, a, b):
    """The squared distance."""
    d = sub(b, a)
    if not square(d):
        return square(sub(p, a))
    t = max(Fraction(0), min(Fraction(1), Fraction(dot(sub(p, a), d)) / square(d)))
    return square(sub(add(a, (t * d[0], t * d[1])), p))


def to_core2(p, core):
    return min(to_segment2(p, a, b) for a, b in edges(core))


def within(p, core):
    """1 inside, 0 on the boundary, -1 outside; a core without area has no inside."""
    if len(core) < 3:
        return 0 if to_core2(p, core) == 0 else -1
    return min(sign(cross2(a, b, p)) for a, b in edges(core))


def signed(p, core, level):
    """Of the signed distance of p to the core."""
    side = within(p, core)
    if side <= 0:
        return 1 if level < 0 else sign((0 if side == 0 else to_core2(p, core)) - level * level)
    if level >= 0:
        return -1
    return max(-sign(cross2(a, b, p) ** 2 - level * level * square(sub(b, a))) for a, b in edges(core))


class Round:
    def __init__(self, core, radius):
        self.core = outline([(Fraction(x), Fraction(y)) for x, y in core])
        self.radius = Fraction(radius)

    def json(self):
        core, radius = [[float(c) for c in p] for p in self.core], float(self.radius)
        if len(core) == 1:
            return {"disc": {"center": core[0], "radius": radius}}
        if len(core) == 2:
            return {"offset": radius, "of": {"polyline": core}}
        return {"offset": radius, "of": {"polygon": core}} if radius else {"polygon": core}


def obstacle(b, a):
    return outline([sub(p, q) for p in a.core for q in b.core]), a.radius + b.radius


def gap(b, a, p, level):
    core, radius = obstacle(b, a)
    return signed(p, core, level + radius)


def reach(b, a, p, level):
    core, radius = obstacle(b, a)
    rest = level - radius
    return max(1 if rest < 0 else sign(square(sub(p, v)) - rest * rest) for v in core)


def protrusion(b, a, p, level):
    return max(signed(add(p, v), a.core, level - b.radius + a.radius) for v in b.core)


def back(b, a, p, level):
    return protrusion(a, b, (-p[0], -p[1]), level)


def hausdorff(b, a, p, level):
    return max(protrusion(b, a, p, level), back(b, a, p, level))


def margin(b, a, p, level):
    """At levels from 0 on: where B fits, A's boundary is as near as B's farthest place says."""
    return -protrusion(b, a, p, -level)


def cover(b, a, p, level):
    return -back(b, a, p, -level)


def directed(b, a, p, level, unit, both):
    """Of the gap along a direction, which is rational as a unit vector."""
    core, radius = obstacle(b, a)

    def place(t):
        return (p[0] + t * unit[0], p[1] + t * unit[1])

    def beside(t):
        return signed(place(t), core, radius)

    if beside(0) < 0:
        if level >= 0:
            return -1
        ends = [beside(-level), beside(level)] if both else [beside(-level)]
        return -1 if max(ends) < 0 else max(ends)
    if beside(0) == 0 or level <= 0:
        return sign(-level) if beside(0) == 0 else 1
    low = -level if both else Fraction(0)
    # The core is nearest to the way beside a corner, where an edge crosses it, between two such places, or at an end.
    times = {low, level, *(dot(sub(v, p), unit) for v in core)}
    for v, w in edges(core):
        of_v, of_w = (unit[0] * (q[1] - p[1]) - unit[1] * (q[0] - p[0]) for q in (v, w))
        if of_v != of_w:
            k = Fraction(of_v) / (of_v - of_w)
            if 0 <= k <= 1:
                times.add(dot(sub(add(v, (k * (w[0] - v[0]), k * (w[1] - v[1]))), p), unit))
    times = sorted(t for t in times if low <= t <= level)
    times += [(s + t) / 2 for s, t in zip(times, times[1:])]
    signs = [(abs(t) < level, beside(t)) for t in times]
    if any(s < 0 or (s == 0 and inner) for inner, s in signs):
        return -1
    return 0 if any(s == 0 for _, s in signs) else 1


def swept(b, a, p, level, way):
    """Of the least gap over the way, at levels from minus both radii on."""
    core, radius = obstacle(b, a)
    out = 1
    for start, end in zip(way, way[1:]):
        s, e = add(p, start), add(p, end)
        out = min(out, sign(to_way2(s, e, core) - (level + radius) ** 2) if not runs_through(s, e, core) else -1)
    return out


def runs_through(s, e, core):
    """Whether a segment meets the interior of the core."""
    if len(core) < 3:
        return False
    low, high = Fraction(0), Fraction(1)
    for a, b in edges(core):
        first, last = cross2(a, b, s), cross2(a, b, e)
        if first <= 0 and last <= 0:
            return False
        if first != last:
            t = Fraction(first) / (first - last)
            low, high = (max(low, t), high) if last > first else (low, min(high, t))
    return low < high or (s == e and within(s, core) > 0)


def crosses(a, b, c, d):
    return cross2(a, b, c) * cross2(a, b, d) < 0 and cross2(c, d, a) * cross2(c, d, b) < 0


def to_way2(s, e, core):
    if any(crosses(s, e, a, b) for a, b in edges(core)):
        return Fraction(0)
    corners = min(to_segment2(v, s, e) for v in core)
    ends = min(0 if within(q, core) >= 0 else to_core2(q, core) for q in (s, e))
    return min(corners, ends)


def greatest(distance, b, a, p, level, way):
    return max(distance(b, a, add(p, q), level) for q in way)


def least(distance, b, a, p, level, way):
    return min(distance(b, a, add(p, q), level) for q in way)
