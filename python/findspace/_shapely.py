# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Shapely and GeoJSON both ways. What these cannot say is lost with a bound: arcs become chords."""
from ._findspace import Shape


def _rings(polygon, grid):
    return Shape.polygon(polygon[0], list(polygon[1:]), grid=grid)


def shape(geometry, grid="0.000001"):
    """A Shape from anything with `__geo_interface__`, or from a GeoJSON geometry: polygons, lines, points.

    Examples
    --------
    >>> import findspace as fs
    >>> fs.shape({"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 3], [0, 0]]]}).region.area
    6.0
    """
    data = getattr(geometry, "__geo_interface__", geometry)
    kind = data.get("type")
    if kind == "Feature":
        return shape(data["geometry"], grid)
    if kind == "GeometryCollection":
        return Shape.unite([shape(part, grid) for part in data["geometries"]])
    if kind not in _MAKERS:
        raise ValueError(f"a geometry of type {kind!r} is not known; these are: {', '.join(sorted(_MAKERS))}")
    parts = _MAKERS[kind](data["coordinates"], grid)
    return parts[0] if len(parts) == 1 else Shape.unite(parts)


_MAKERS = {
    "Polygon": lambda c, g: [_rings(c, g)],
    "MultiPolygon": lambda c, g: [_rings(p, g) for p in c],
    "LineString": lambda c, g: [Shape.polyline(c, grid=g)],
    "MultiLineString": lambda c, g: [Shape.polyline(p, grid=g) for p in c],
    "Point": lambda c, g: [Shape.points([c], grid=g)],
    "MultiPoint": lambda c, g: [Shape.points(c, grid=g)],
}


def geo_interface(self, bound=None):
    """The closure as GeoJSON; arcs become chords within a thousandth of the size."""
    if not self.bounded:
        raise ValueError("an unbounded region has no GeoJSON")
    if bound is None:
        box = self.bounds
        bound = max(box[2] - box[0], box[3] - box[1], 1e-9) / 1000 if box else 1
    parts = []
    for component in self.components:
        parts += _geometries(component, bound)
    if len(parts) == 1:
        return parts[0]
    if parts and all(p["type"] == "Polygon" for p in parts):
        return {"type": "MultiPolygon", "coordinates": [p["coordinates"] for p in parts]}
    return {"type": "GeometryCollection", "geometries": parts}


def _points(edges, bound):
    import math
    out = []
    for e in edges:
        out.append(tuple(e.start))
        if not e.is_arc:
            continue
        half = math.acos(max(-1.0, 1 - bound / e.radius))
        pieces = max(3 if e.angle > math.pi else 1, math.ceil(e.angle / (2 * half)))
        begin = math.atan2(e.start[1] - e.center[1], e.start[0] - e.center[0])
        turn = e.angle if e.counterclockwise else -e.angle
        for k in range(1, pieces):
            a = begin + turn * k / pieces
            out.append((e.center[0] + e.radius * math.cos(a), e.center[1] + e.radius * math.sin(a)))
    return out


def _area(ring):
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:] + ring[:1])) / 2


def _geometries(component, bound):
    out = []
    for ring in component.rings:
        points = _points(ring.edges, bound)
        points.append(points[0])
        if _area(points) > 0:
            out.append({"type": "Polygon", "coordinates": [points]})
        else:
            out[-1]["coordinates"].append(points)
    for curve in component.curves:
        out.append({"type": "LineString", "coordinates": _points([curve], bound) + [tuple(curve.end)]})
    out += [{"type": "Point", "coordinates": tuple(p)} for p in component.points.tolist()]
    return out


def to_shapely(self, bound=None):
    """A shapely geometry of the closure.

    Parameters
    ----------
    bound : float, optional
        No chord is farther than this from its arc; a thousandth of the size where it is left out.
    """
    from shapely.geometry import shape as made
    return made(geo_interface(self, bound))


def geo_interface_of_shape(self):
    """The closure of a shape of the plane as GeoJSON; arcs become chords within a thousandth of the size."""
    return geo_interface(self.region)


def shape_to_shapely(self, bound=None):
    """A shapely geometry of the closure of a shape of the plane; see Region.to_shapely."""
    return to_shapely(self.region, bound)
