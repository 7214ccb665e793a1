# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Shapely, GeoJSON and trimesh both ways. What these cannot say is lost with a bound: arcs become chords."""
import json

from ._findspace import Shape


def _rings(polygon, grid):
    return Shape.polygon(polygon[0], list(polygon[1:]), grid=grid)


def shape(geometry, grid="0.000001"):
    """A Shape from anything with `__geo_interface__`, or from a GeoJSON geometry: polygons, lines, points.

    What has `vertices` and `faces`, as trimesh's meshes, becomes a solid.

    Examples
    --------
    >>> import findspace as fs
    >>> fs.shape({"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 3], [0, 0]]]}).region.area
    6.0
    """
    if hasattr(geometry, "vertices") and hasattr(geometry, "faces"):
        return Shape.mesh(geometry.vertices, geometry.faces, grid=grid)
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


def geo_interface(self, bound=None, side="on_arcs"):
    """The closure as GeoJSON; arcs become chords within a thousandth of the size."""
    if not self.bounded:
        raise ValueError("an unbounded region has no GeoJSON")
    if bound is None:
        box = self.bounds
        bound = max(box[2] - box[0], box[3] - box[1], 1e-9) / 1000 if box else 1
    return json.loads(self.geojson(bound, side))


def to_shapely(self, bound=None, side="on_arcs"):
    """A shapely geometry of the closure.

    Parameters
    ----------
    bound : float, optional
        No chord is farther than this from its arc; a thousandth of the size where it is left out.
    side : str
        Where the corners of flattened arcs lie: "inside" the set, "outside" of it, or "on_arcs".
    """
    from shapely.geometry import shape as made
    return made(geo_interface(self, bound, side))


def geo_interface_of_shape(self):
    """The closure of a shape of the plane as GeoJSON; arcs become chords within a thousandth of the size."""
    return geo_interface(self.region)


def shape_to_shapely(self, bound=None, side="on_arcs"):
    """A shapely geometry of the closure of a shape of the plane; see Region.to_shapely."""
    return to_shapely(self.region, bound, side)
