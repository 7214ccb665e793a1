# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Pretty-printers for gdb: the types of findspace that one looks at most, as text that a person reads.

usage: gdb -x tools/gdb/findspace_printers.py build/dev/findspace       (or `source FILE` in gdb)

exact      Real in closed form or as an expression, with about its value; Interval, WideInt, Point, SupportingCurve, Geometry
plane      grid points, contour edges; CellComplex (Region, SignMap): cells, marks and the box; Shape
space      Point, Vector, RealVector, Plane, HalfSpace, Polytope, Body, BoxComplex
formula  Distance, Atom, SignMap, Node and Formula, spelled as formulas are written

Nothing of the program is called: the printers read memory, so they work on core files and in optimised builds with
debug information. tests/tools/gdb_values.cpp says what is printed for what, and a test compares."""
import functools
import math
import os
import re
import sys

import gdb
import gdb.printing

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from standard_library import column, counted, elements, enumerator, held, pointed, size, string  # beside this file

MOST_OPERATIONS = 12  # of an expression of Reals that are printed


# --- exact ---------------------------------------------------------------------------------------------------------

def wide(limbs):
    """The integer of 64-bit limbs in two's complement, the lowest first."""
    number = sum((int(limb) % 2**64) << (64 * k) for k, limb in enumerate(limbs))
    return number - 2 ** (64 * len(limbs)) if number >> (64 * len(limbs) - 1) else number


def int128(value):
    return int(value.format_string(format="d"))


def big(mpz):
    """The integer of an mpz_class."""
    data = mpz["mp"][0] if mpz["mp"].type.strip_typedefs().code == gdb.TYPE_CODE_ARRAY else mpz["mp"]
    count = int(data["_mp_size"])
    limbs = [int(data["_mp_d"][k]) for k in range(abs(count))]
    number = sum(limb << (64 * k) for k, limb in enumerate(limbs))
    return -number if count < 0 else number


def node_of(real, name):
    return real["node_"].cast(gdb.lookup_type(f"findspace::exact::detail::{name}").pointer()).dereference()


def closed_text(p, r, q, n):
    """(p + r*sqrt(n)) / q, as RealWriter (exact/number/real_text.h) spells it."""
    if r == 0:
        return str(p) if q == 1 else f"{p}/{q}"
    root = ("" if r == 1 else "-" if r == -1 else f"{r}*") + f"sqrt({n})"
    whole = root if p == 0 else f"{p}{'' if root.startswith('-') else '+'}{root}"
    return whole if q == 1 else f"({whole})/{q}"


class Expression:
    """The text of a Real; `left` operations may still be written out, below them stands about what they are."""

    def __init__(self):
        self.left = MOST_OPERATIONS

    def text(self, real):
        """(text, how tightly it binds: 3 a number, 2 a product, 1 a sum)"""
        if int(real["node_"]) == 0:
            p, q = int128(real["numerator_"]), int(real["denominator_"])
            return closed_text(p, 0, q, 0), 1 if p < 0 else 3 if q == 1 else 2
        kind = enumerator(real["node_"]["kind"])
        if kind in ("Rational", "Quadratic"):
            value = node_of(real, "QuadraticNode")["value"]
            p, r, q, n = (big(value[name]) for name in ("p", "r", "q", "n"))
            return closed_text(p, r, q, n), 3 if q == 1 and (r == 0) != (p == 0) and p + r > 0 else 2 if q != 1 else 1
        self.left -= 1
        if kind == "PolynomialRoot":
            polynomial = [self.text(c)[0] for c in elements(node_of(real, "RootNode")["coefficients"])]
            return f"root of [{', '.join(polynomial)}]", 3
        if self.left < 0:
            return f"~{about(real)}", 3
        return self.operation(kind, node_of(real, "OperationNode"))

    def operation(self, kind, node):
        if kind == "Sqrt":
            return f"sqrt({self.text(node['a'])[0]})", 3
        if kind == "Neg":
            return f"-{self.inside(node['a'], 3)}", 1
        sign, level = {"Add": ("+", 1), "Sub": ("-", 1), "Mul": ("*", 2), "Div": ("/", 2)}[kind]
        return self.inside(node["a"], level) + sign + self.inside(node["b"], level + (kind != "Add")), level

    def inside(self, real, least):
        text, level = self.text(real)
        return text if level >= least else f"({text})"


def about(real):
    """The middle of the enclosure of a number, as text."""
    if int(real["node_"]) == 0:
        return f"{int128(real['numerator_']) / int(real['denominator_']):.10g}"
    enclosure = real["node_"]["interval"]
    return f"{(float(enclosure['lo']) + float(enclosure['hi'])) / 2:.10g}"


def short(real):
    """A number inside of something else: exact where that is short."""
    text = Expression().text(real)[0]
    return text if len(text) <= 24 else f"~{about(real)}"


def real_text(real):
    text = Expression().text(real)[0]
    return text if re.fullmatch(r"-?\d+", text) else f"{text} ~ {about(real)}"


def interval_text(value):
    return f"[{float(value['lo']):.17g}, {float(value['hi']):.17g}]"


def wide_text(value):
    limbs = value["limb"]
    return str(wide([limbs[k] for k in range(limbs.type.range()[1] + 1)]))


def real_point_text(value):
    return f"({short(value['x'])}, {short(value['y'])})"


def point_text(value):
    kind = enumerator(value["kind"])
    if kind == "Grid":
        return f"({int(value['gx'])}, {int(value['gy'])})"
    near = f"~ ({float(value['x']):.10g}, {float(value['y']):.10g})"
    if kind == "Cross":
        root = int(value["root"])
        return f"supporting_curves {int(value['i'])} and {int(value['j'])} meet{f', root {root:+d},' if root else ''} {near}"
    return f"real {int(value['i'])} {near}"


def linear_text(pairs):
    """'3*x - y' of numbers and names."""
    terms = ""
    for factor, name in pairs:
        if factor:
            size_text = "" if abs(factor) == 1 else f"{abs(factor)}*"
            terms += (" - " if factor < 0 else " + ") + size_text + name if terms else ("-" if factor < 0 else "") + size_text + name
    return terms or "0"


def supporting_curve_text(value):
    kept, a, b = value["reals"]["kept_"], int(value["a"]), int(value["b"])
    real = held(kept["point"]) if int(kept) else None
    if value["circle"]:
        centre = f"({a}, {b})" if value["grid"] else real_point_text(real)
        return f"circle about {centre}, radius {short(kept['w'])}"
    line = f"line {linear_text([(a, 'x'), (b, 'y')])} = "
    if value["grid"]:
        return line + str(int128(value["c"]))
    if real is not None:
        return line + short(real["x"])
    return f"{line}{int128(value['c'])}, moved by {short(kept['w'])}"


def geometry_text(value):
    return f"{size(value['supporting_curves'])} supporting_curves, {size(value['points'])} points, {size(value['reals'])} of them real"


# --- plane ---------------------------------------------------------------------------------------------------------

def grid_point_text(value):
    return f"({int(value['x'])}, {int(value['y'])})"


def contour_edge_text(value):
    arc = pointed(value["arc"])
    if arc is None:
        return f"segment from {grid_point_text(value['start'])}"
    turn = "counter-clockwise" if value["ccw"] else "clockwise"
    centre = f"({short(arc['cx'])}, {short(arc['cy'])})"
    return f"arc from {grid_point_text(value['start'])} {turn} about {centre}, radius {short(arc['r'])}"


def complex_box(value):
    """The box of all vertices and arcs, in doubles; None where there is none."""
    near = column(value["geometry"]["points"], "x", "y")
    points = [near[p] for p in column(value["vertices"], "point")]
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    for v0, v1, supporting_curve, half in column(value["edges"], "v0", "v1", "supporting_curve", "half"):
        if half == 0:
            continue
        circle = (value["geometry"]["supporting_curves"]["_M_impl"]["_M_start"] + supporting_curve).dereference()
        x, y, radius = (float(circle[name]) for name in ("x_", "y_", "z_"))
        if points[v0][0] <= x <= points[v1][0]:  # the arc is highest or lowest there
            ys.append(y + half * radius)
    return (min(xs), max(xs), min(ys), max(ys)) if xs else None


def complex_text(value):
    kinds = (("vertex", "vertices"), ("edge", "edges"), ("face", "faces"))
    marks = {name: column(value[name], "mark") for _, name in kinds}
    total = ", ".join(counted(len(marks[name]), one, name) for one, name in kinds)
    cells = [f"mark {mark}: " + ", ".join(counted(marks[name].count(mark), one, name) for one, name in kinds if mark in marks[name])
             for mark in sorted(set().union(*marks.values()))]
    box = complex_box(value)
    where = "" if box is None else " in [{:.10g}, {:.10g}] x [{:.10g}, {:.10g}]".format(*box)
    return f"{total}{where}; {'; '.join(cells)}"


def shape_text(value):
    kind = enumerator(value["kind"])
    name = string(value["name"])
    text = kind + (f" '{name}'" if name else "")
    points = elements(value["points"])
    if kind == "Disc":
        return f"{text} about {grid_point_text(points[0])}, radius {short(value['amount'])}"
    if int(value["solid"]["_M_ptr"]):
        return f"{text}, a solid"
    counts = [(size(value["children"]), "child", "children"), (size(value["contours"]), "contour", "contours"),
              (len(points), "point", "points")]
    found = [counted(*count) for count in counts if count[0]]
    return f"{text} of {', '.join(found)}" if found else text


# --- space ---------------------------------------------------------------------------------------------------------

def integers_text(value):
    return "({}, {}, {})".format(*(int128(value[name]) for name in "xyz"))


def doubles_text(value):
    return "({:.10g}, {:.10g}, {:.10g})".format(*(float(value[name]) for name in "xyz"))


def real_vector_text(value):
    return "({}, {}, {})".format(*(short(value["_M_elems"][k]) for k in range(3)))


def plane_text(value):
    normal, offset = [int128(value["normal"][name]) for name in "xyz"], int128(value["offset"])
    return linear_text(list(zip(normal, "xyz")) + [(offset, "1")]).replace("*1", "") + " = 0"


def half_space_text(value):
    return f"{real_vector_text(value['normal'])} . x + {short(value['offset'])} <= 0"


def box_of(points):
    return " x ".join(f"[{min(c)}, {max(c)}]" for c in zip(*points)) if points else "nowhere"


def polytope_text(value):
    box = box_of(column(value["vertices_"], "x", "y", "z"))
    return f"{size(value['vertices_'])} vertices, {size(value['planes_'])} facets in {box}"


def body_part_text(value):
    core, flat = held(value["core"]), elements(value["flat"])
    radius = short(value["radius"])
    grown = "" if radius == "0" else f", grown by {radius}"
    if core is not None:
        return polytope_text(core) + grown
    if flat:
        return f"flat, {len(flat)} corners in {box_of(column(value['flat'], 'x', 'y', 'z'))}{grown}"
    return f"the point {integers_text(value['center'])}" if not grown else f"ball about {integers_text(value['center'])}, radius {radius}"


def body_text(value):
    parts = elements(value["parts"])
    outside = "complement of " if value["outside"] else ""
    return f"{outside}{counted(len(parts), 'part', 'parts')} at scale {int(value['scale'])}"


def box_complex_text(value):
    axes = [elements(value["at_"]["_M_elems"][k]) for k in range(3)]
    negative, marked = set_bits(value["negative_"]), set_bits(value["in_"])
    counts = {-1: negative, 0: math.prod(2 * len(axis) + 1 for axis in axes) - marked, 1: marked - negative}
    box = " x ".join(f"[{short(axis[0])}, {short(axis[-1])}]" if axis else "[]" for axis in axes)
    cells = ", ".join(f"mark {mark}: {n} cells" for mark, n in counts.items() if n)
    return f"{' x '.join(str(len(axis)) for axis in axes)} coordinates in {box}; {cells}"


def set_bits(cell_bits):
    words = cell_bits["bits_"]
    bytes_ = 8 * size(words)
    memory = gdb.selected_inferior().read_memory(int(words["_M_impl"]["_M_start"]), bytes_).tobytes() if bytes_ else b""
    return int.from_bytes(memory, "little").bit_count()


# --- formula -----------------------------------------------------------------------------------------------------

RELATIONS = {"Less": "<", "LessEqual": "<=", "Equal": "=", "NotEqual": "!=", "GreaterEqual": ">=", "Greater": ">"}


def distance_text(value):
    prefix, mode = enumerator(value["prefix"]), enumerator(value["mode"])
    shapes = ["+".join(string(name) for name in elements(value[side])) for side in ("first", "second")]
    if mode != "Plain":
        shapes.append(f"{mode.lower()}={string(value['vector_text'])}")
    return ("" if prefix == "None" else prefix.lower() + " ") + f"{enumerator(value['kind']).lower()}({', '.join(shapes)})"


def sign_map_text(value):
    distance = distance_text(value["distance"])
    return f"{distance} -> min" if value["minimum"] else f"sign of {distance} - {short(value['level'])}"


def atom_text(value):
    distance = distance_text(value["distance"])
    return f"{distance} -> min" if value["minimum"] else f"{distance} {RELATIONS[enumerator(value['relation'])]} {short(value['level'])}"


def node_text(node, atom):
    """A tree as a formula is written; `atom` gives the text of an atom by its number."""
    op, operands = enumerator(node["op"]), elements(node["operands"])
    if op == "Atom":
        return atom(int(node["atom"]))
    if op in ("True", "False"):
        return op.lower()
    texts = []
    for operand in operands:
        inner = enumerator(operand["op"])
        text = node_text(operand, atom)
        texts.append(f"({text})" if inner == "Or" or op == "Not" and inner == "And" else text)
    return f"not {texts[0]}" if op == "Not" else f" {op.lower()} ".join(texts)


def formula_text(value):
    content = value["content_"]["_M_ptr"].dereference()
    atoms = elements(content["atoms"])
    return node_text(content["root"], lambda k: atom_text(atoms[k]))


# --- all of them ---------------------------------------------------------------------------------------------------

TEXT_OF = {
    "exact::Real": real_text, "exact::Interval": interval_text, "exact::WideInt<[0-9]+>": wide_text,
    "exact::RealPoint": real_point_text, "exact::Point": point_text, "exact::SupportingCurve": supporting_curve_text,
    "exact::Geometry": geometry_text, "exact::Grid3": integers_text, "exact::Wide3": integers_text,
    "exact::Approx3": doubles_text,
    "plane::GridPoint": grid_point_text, "plane::ContourEdge": contour_edge_text, "plane::CellComplex": complex_text,
    "plane::Shape": shape_text,
    "space::Plane": plane_text, "space::HalfSpace": half_space_text, "space::Polytope": polytope_text,
    "space::BodyPart": body_part_text, "space::Body": body_text, "space::BoxComplex": box_complex_text,
    "formula::Distance": distance_text, "formula::SignMap": sign_map_text, "formula::Atom": atom_text,
    "formula::Node": functools.partial(node_text, atom=lambda k: f"atom {k}"), "formula::Formula": formula_text,
}
REAL_VECTOR = r"^std::array<findspace::exact::Real, 3(u?l*)?>$"


class Printer:
    def __init__(self, text_of, value):
        self.text_of, self.value = text_of, value

    def to_string(self):
        try:
            return self.text_of(self.value)
        except (gdb.error, ValueError, KeyError, IndexError, TypeError, ZeroDivisionError) as error:
            return f"<not readable: {error}>"  # not constructed yet, or a type without debug information


def register():
    collection = gdb.printing.RegexpCollectionPrettyPrinter("findspace")
    for name, text_of in TEXT_OF.items():
        collection.add_printer(name, f"^findspace::{name}$", functools.partial(Printer, text_of))
    collection.add_printer("space::RealVector", REAL_VECTOR, functools.partial(Printer, real_vector_text))
    gdb.printing.register_pretty_printer(gdb.current_objfile(), collection, replace=True)


register()
