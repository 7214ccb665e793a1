# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Pictures of regions: with matplotlib, and as SVG where a notebook shows a value."""
import math

_FILL, _LINE = "#7fb5e6", "#1f5f99"


def _codes(edge, path):
    """The edge as cubic Beziers, which matplotlib draws to a fraction of a pixel; a whole circle as well."""
    if not edge.is_arc:
        path.append((edge.end, "line"))
        return
    (cx, cy), r = edge.center, edge.radius
    begin = math.atan2(edge.start[1] - cy, edge.start[0] - cx)
    turn = edge.angle if edge.counterclockwise else -edge.angle
    pieces = max(1, math.ceil(edge.angle / (math.pi / 4)))
    for k in range(pieces):
        a, b = begin + turn * k / pieces, begin + turn * (k + 1) / pieces
        h = 4 / 3 * math.tan((b - a) / 4) * r
        p = (cx + r * math.cos(a), cy + r * math.sin(a))
        q = (cx + r * math.cos(b), cy + r * math.sin(b))
        path.append(((p[0] - h * math.sin(a), p[1] + h * math.cos(a)), "curve"))
        path.append(((q[0] + h * math.sin(b), q[1] - h * math.cos(b)), "curve"))
        path.append((q, "curve"))


def _path(edges, closed):
    from matplotlib.path import Path
    steps = [(edges[0].start, "move")]
    for edge in edges:
        _codes(edge, steps)
    kinds = {"move": Path.MOVETO, "line": Path.LINETO, "curve": Path.CURVE4}
    points, codes = [p for p, _ in steps], [kinds[k] for _, k in steps]
    if closed:
        points.append(points[0])
        codes.append(Path.CLOSEPOLY)
    return Path(points, codes)


def plot_region(self, ax=None, color=_FILL, edgecolor=_LINE):
    """Draw the region: faces filled, edges that belong in full lines, others dashed, curves and points without area.

    Parameters
    ----------
    ax : matplotlib.axes.Axes, optional
        The current one where none is given.

    Returns
    -------
    matplotlib.axes.Axes
    """
    import matplotlib.pyplot as plt
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path
    if not self.bounded:
        raise ValueError("an unbounded region cannot be drawn; intersect it with a box")
    ax = ax or plt.gca()
    for part in self.components:
        if part.rings:
            whole = Path.make_compound_path(*[_path(ring.edges, True) for ring in part.rings])
            ax.add_patch(PathPatch(whole, facecolor=color, edgecolor="none"))
        for edge in [e for ring in part.rings for e in ring.edges] + part.curves:
            style = "-" if edge.belongs else (0, (4, 3))
            ax.add_patch(PathPatch(_path([edge], False), fill=False, edgecolor=edgecolor, linestyle=style))
        points = part.points
        if len(points):
            ax.plot(points[:, 0], points[:, 1], "o", color=edgecolor, markersize=5)
    ax.set_aspect("equal")
    ax.autoscale_view()
    return ax


def plot_shape(self, ax=None, **options):
    """Draw a shape of the plane, as Region.plot does."""
    return self.region.plot(ax, **options)


def picture(self):
    """For notebooks; None where the region is unbounded or empty."""
    return self.svg if self.bounded and not self.empty else None


def picture_of_shape(self):
    return picture(self.region) if self.dimension == 2 else self.svg


def picture_of_solid(self):
    return self.svg if self.bounded and not self.empty else None


def picture_of_surface(self):
    return self.text(".svg").decode() if len(self.vertices) else None


def picture_of_placement(self):
    return self.svg


def picture_of_layout(self):
    """For notebooks; None of a layout that does not know its problem."""
    return self.svg() if hasattr(self, "problem") else None
