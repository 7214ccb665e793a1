# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Solids of the oracle of `drilled_parts.py`, as functions of points.

A solid has `field(points)`: at most 0 on the solid, at least 0 off its interior, and it changes by no more than a step of
the point. A `Round` is a convex core of flat faces grown by a ball; there the field is the signed distance itself outside
and on the boundary. Unions, intersections and differences take the least and the greatest of fields, so they keep the
property, and a cell of points about c is off the solid where the field at c exceeds the cell's half diagonal.
Nothing here is the program's: closed forms of doubles on numpy arrays of points."""
from itertools import combinations

import numpy as np


def lengths(vectors):
    return np.sqrt(np.einsum("ij,ij->i", vectors, vectors))


def to_segment(points, a, b):
    d = b - a
    t = np.clip((points - a) @ d / (d @ d), 0, 1)
    return lengths(points - a - t[:, None] * d)


class Flat:
    """The convex hull of a few points, also of one, two or three: its facets as rings, and its edges."""

    def __init__(self, corners):
        self.corners = np.array(corners, float)
        self.facets = []
        planes = set()
        for triple in combinations(range(len(corners)), 3):
            a, b, c = self.corners[list(triple)]
            normal = np.cross(b - a, c - a)
            size = np.linalg.norm(normal)
            if size < 1e-9:
                continue
            heights = (self.corners - a) @ (normal / size)
            ring = tuple(np.flatnonzero(np.abs(heights) < 1e-9))
            if ring in planes:
                continue
            for outwards in (normal / size, -normal / size):  # both of what is flat
                if ((self.corners - a) @ outwards < 1e-9).all():
                    planes.add(ring)
                    self.facets.append((outwards, a, self.round_about(ring, outwards)))
        shared = [pair for pair in combinations(range(len(corners)), 2) if sum(set(pair) <= set(p) for p in planes) > 1]
        self.edges = shared or list(combinations(range(len(corners)), 2))

    def round_about(self, ring, normal):
        points = self.corners[list(ring)]
        arms = points - points.mean(axis=0)
        other = np.cross(normal, arms[0])
        return points[np.argsort(np.arctan2(arms @ other, arms @ arms[0] * np.linalg.norm(other) / np.linalg.norm(arms[0])))]

    def distance(self, points):
        """Signed, where it has an interior."""
        best = np.full(len(points), np.inf)
        for c in self.corners:
            best = np.minimum(best, lengths(points - c))
        for i, j in self.edges:
            best = np.minimum(best, to_segment(points, self.corners[i], self.corners[j]))
        if not self.facets:
            return best
        inside = np.full(len(points), -np.inf)
        for normal, a, ring in self.facets:
            height = (points - a) @ normal
            inside = np.maximum(inside, height)
            within = np.ones(len(points), bool)
            for c, d in zip(ring, np.roll(ring, -1, axis=0)):
                within &= (points - c) @ np.cross(normal, d - c) >= 0
            best = np.where(within & (height >= 0), np.minimum(best, height), best)
        return np.where(inside < 0, inside, best)


class Block:
    """A box along the axes."""

    def __init__(self, low, high):
        self.low, self.high = np.array(low, float), np.array(high, float)
        self.corners = np.array([[(low, high)[k >> i & 1][i] for i in range(3)] for k in range(8)], float)

    def distance(self, points):
        beyond = np.maximum(self.low - points, points - self.high)
        return np.where(beyond.max(axis=1) < 0, beyond.max(axis=1), lengths(np.maximum(beyond, 0)))


class Solid:
    def box(self):
        raise NotImplementedError


class Round(Solid):
    """A core grown by a ball."""

    def __init__(self, core, radius, text):
        self.core, self.radius, self.text = core, radius, text

    def json(self):
        return self.text

    def field(self, points):
        return self.core.distance(points) - self.radius

    def farthest(self, points):
        return np.max([lengths(points - c) for c in self.core.corners], axis=0) + self.radius

    def box(self):
        return self.core.corners.min(axis=0) - self.radius, self.core.corners.max(axis=0) + self.radius

    def plus(self, other):
        return self.plus_reflected(Round(mirrored(other.core), other.radius, None))

    def plus_reflected(self, other):
        """The differences of its points and those of `other`: where `other` meets it."""
        corners = [a - b for a in self.core.corners for b in other.core.corners]
        if isinstance(self.core, Block) and isinstance(other.core, Block):
            core = Block(self.core.low - other.core.high, self.core.high - other.core.low)
        elif len(other.core.corners) == 1:
            core = moved(self.core, -other.core.corners[0])
        elif len(self.core.corners) == 1:
            core = moved(mirrored(other.core), self.core.corners[0])
        else:
            core = Hull(corners)
        return Round(core, self.radius + other.radius, None)


def moved(core, by):
    if isinstance(core, Block):
        return Block(core.low + by, core.high + by)
    return Flat(core.corners + by)


def mirrored(core):
    return Block(-core.high, -core.low) if isinstance(core, Block) else Flat(-core.corners)


class Hull(Flat):
    """Of many points: those that are no corners are dropped first."""

    def __init__(self, corners):
        corners = np.unique(np.round(np.array(corners, float), 9), axis=0)
        directions = np.random.default_rng(1).normal(size=(4000, 3))
        super().__init__(corners[np.unique(np.argmax(corners @ directions.T, axis=0))])


class Prism(Solid):
    """A simple polygon with holes, along z."""

    def __init__(self, rings, low, high):
        self.rings = [np.array(r, float) for r in rings]
        self.low, self.high = low, high

    def json(self):
        rings = [r.tolist() for r in self.rings]
        return {"prism": {"polygon": rings[0], "holes": rings[1:], "z": [self.low, self.high]}}

    def field(self, points):
        x, y = points[:, 0], points[:, 1]
        best, inside = np.full(len(points), np.inf), np.zeros(len(points), bool)
        for ring in self.rings:
            for a, b in zip(ring, np.roll(ring, -1, axis=0)):
                d = b - a
                t = np.clip(((x - a[0]) * d[0] + (y - a[1]) * d[1]) / (d @ d), 0, 1)
                best = np.minimum(best, np.hypot(x - a[0] - t * d[0], y - a[1] - t * d[1]))
                if d[1] != 0:
                    crosses = (a[1] > y) != (b[1] > y)
                    inside ^= crosses & (x < a[0] + (y - a[1]) * d[0] / d[1])
        flat = np.where(inside, -best, best)
        high = np.maximum(self.low - points[:, 2], points[:, 2] - self.high)
        outside = np.hypot(np.maximum(flat, 0), np.maximum(high, 0))
        return np.where(np.maximum(flat, high) < 0, np.maximum(flat, high), outside)

    def box(self):
        low, high = self.rings[0].min(axis=0), self.rings[0].max(axis=0)
        return np.array([*low, self.low]), np.array([*high, self.high])


class Joined(Solid):
    """The union, intersection or difference of solids."""

    def __init__(self, word, solids, opened=False):
        self.word, self.solids, self.opened = word, solids, opened

    def json(self):
        parts = [s.json() for s in self.solids]
        if self.opened:
            parts[1:] = [{"interior": p} for p in parts[1:]]
        return {self.word: parts}

    def field(self, points):
        fields = [s.field(points) for s in self.solids]
        if self.word == "union":
            return np.minimum.reduce(fields)
        if self.word == "difference":
            fields[1:] = [-f for f in fields[1:]]
        return np.maximum.reduce(fields)

    def box(self):
        boxes = [s.box() for s in self.solids]
        if self.word == "difference":
            return boxes[0]
        low, high = np.array([b[0] for b in boxes]), np.array([b[1] for b in boxes])
        return (low.min(axis=0), high.max(axis=0)) if self.word == "union" else (low.max(axis=0), high.min(axis=0))


class Shrunk(Solid):
    """Positions at which a round solid lies in `of`, a convex Round or a difference of Rounds: `of` less `by`, reflected."""

    def __init__(self, of, by):
        parts = of.solids if isinstance(of, Joined) and of.word == "difference" else [of]
        self.outer = parts[0].solids if isinstance(parts[0], Joined) else [parts[0]]
        self.by, self.cut = by, [c.plus_reflected(by) for c in parts[1:]]

    def field(self, points):
        out = [o.field(points + c) for o in self.outer for c in self.by.core.corners]
        return np.maximum.reduce([np.maximum.reduce(out) + self.by.radius] + [-c.field(points) for c in self.cut])

    def box(self):
        boxes = [o.box() for o in self.outer]
        corner = self.by.core.corners[0]
        return np.max([b[0] for b in boxes], axis=0) - corner, np.min([b[1] for b in boxes], axis=0) - corner


class Outside(Solid):
    """The closure of the complement, within a box."""

    def __init__(self, of, low, high):
        self.of, self.low, self.high = of, low, high

    def field(self, points):
        return -self.of.field(points)

    def box(self):
        return self.low, self.high


def least(solid, value, tolerance, most=120000, start=None):
    """Bounds of the least `value` on the solid, where it changes by no more than a step: (lower, upper, a place).
    (inf, inf, None) where the solid is certainly empty; upper is inf where no point of it was found."""
    low, high = solid.box()
    if (low > high + 1e-9).any():
        return np.inf, np.inf, None
    size = np.maximum(high - low, 1e-6) / 2
    number = np.maximum(1, np.round(4 * size / size.max())).astype(int)
    axes = [low[i] + (np.arange(number[i]) + 0.5) * 2 * size[i] / number[i] for i in range(3)]
    centers = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    size = size / number
    upper, place = np.inf, None
    lower = np.inf  # of what was left for its bound

    def offer(points, fields, values):
        nonlocal upper, place
        good = np.flatnonzero(fields <= 0)
        if len(good):
            k = good[np.argmin(values[good])]
            if values[k] < upper:
                upper, place = values[k], points[k]

    if start is not None:
        start = np.atleast_2d(start)
        offer(start, solid.field(start), value(start))
    steps = np.array([[i, j, k] for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]) / 2.0
    while True:
        fields, values = solid.field(centers), value(centers)
        offer(centers, fields, values)
        half = np.linalg.norm(size)
        if place is not None:  # a few steps beside the best place
            step = half
            for _ in range(12):
                near = place + step * np.random.default_rng(7).normal(size=(40, 3))
                before = upper
                offer(near, solid.field(near), value(near))
                step *= 1 if upper < before else 0.5
        alive = fields <= half
        bounds = values - half
        left = alive & (bounds >= upper - tolerance)
        if left.any():
            lower = min(lower, bounds[left].min())
        alive &= ~left
        centers = centers[alive]
        if len(centers) == 0:
            return min(lower, upper), upper, place
        if len(centers) * 8 > most:
            return min(lower, bounds[alive].min(), upper), upper, place
        size = size / 2
        centers = (centers[:, None, :] + steps[None] * 2 * size).reshape(-1, 3)
