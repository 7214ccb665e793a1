// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/shape/box_shape.h"

#include <findspace/error.h>

#include <algorithm>
#include <map>
#include <span>

#include "space/box/box_operations.h"
#include "space/box/box_topology.h"
#include "space/mesh/mesh.h"
#include "space/polytope/convex_polygon.h"

namespace findspace::space {

using exact::Real;
using Kind = plane::Shape::Kind;

namespace {

/// The edges of rings, `times` each, against their direction where negative.
struct Edge {
  Point2 from, to;
  int times = 1;
};

/// Horizontal faces at height z. `sense` is +1 where the solid lies above them; 0: to the left of their edges it lies
/// below them.
struct Level {
  std::int64_t z = 0;
  int sense = 0;
  std::vector<Edge> edges;
};

/// The levels and all vertices of a solid, if its faces are axis-parallel.
struct Faces {
  std::vector<Level> levels;
  std::vector<Point> vertices;
};

bool one_axis(const Wide3& n) { return (n.x != 0) + (n.y != 0) + (n.z != 0) == 1; }

/// Edges between faces of one level, diagonals among them, cancel out.
std::optional<Faces> faces_of(const Mesh& mesh) {
  using Ends = std::pair<Point2, Point2>;
  std::map<std::int64_t, std::map<Ends, int>> edges;
  for (const auto& face : mesh.faces) {
    const Wide3 n = area_vector(mesh, face);
    if (!one_axis(n)) return std::nullopt;
    if (n.z == 0) continue;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Point &v = mesh.vertices[std::size_t(face[i])],
                  &w = mesh.vertices[std::size_t(face[(i + 1) % face.size()])];
      const Point2 a{v.x, v.y}, b{w.x, w.y};
      edges[v.z][std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  Faces out;
  out.vertices = mesh.vertices;
  for (const auto& [z, ends] : edges) {
    Level& level = out.levels.emplace_back(Level{z, 0, {}});
    for (const auto& [e, times] : ends) {
      if (times == 0) continue;
      if (e.first.x != e.second.x && e.first.y != e.second.y) return std::nullopt;
      level.edges.push_back({e.first, e.second, times});
    }
  }
  return out;
}

std::optional<Faces> faces_of(const Solid& solid) {
  if (solid.form == Solid::Form::kBall) return std::nullopt;
  if (solid.form == Solid::Form::kMesh) return faces_of(solid.mesh);
  if (solid.form == Solid::Form::kPolytope) {
    const Polytope hull = Polytope::hull(solid.mesh.vertices);
    Mesh mesh{{hull.vertices().begin(), hull.vertices().end()}, {}};
    for (int f = 0; f < hull.facet_count(); ++f) mesh.faces.push_back(hull.circuit(f));
    return faces_of(mesh);
  }
  Faces out;
  std::vector<Edge> edges;
  for (const plane::Contour& contour : solid.contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const plane::GridPoint a = contour[i].start, b = contour[(i + 1) % contour.size()].start;
      if (contour[i].arc || (a.x != b.x && a.y != b.y)) return std::nullopt;
      edges.push_back({{a.x, a.y}, {b.x, b.y}});
      out.vertices.push_back({a.x, a.y, solid.low});
    }
  }
  out.vertices.push_back({out.vertices[0].x, out.vertices[0].y, solid.high});
  out.levels = {{solid.low, 1, edges}, {solid.high, -1, edges}};
  return out;
}

/// The levels with those of their edges that pass the line at y, given twice as large and on no vertex.
std::vector<Level> levels_at(std::span<const Level> levels, std::int64_t y) {
  std::vector<Level> out;
  for (const Level& level : levels) {
    Level& row = out.emplace_back(Level{level.z, level.sense, {}});
    for (const Edge& e : level.edges) {
      if ((2 * e.to.y > y) != (2 * e.from.y > y)) row.edges.push_back(e);
    }
    if (row.edges.empty()) out.pop_back();
  }
  return out;
}

/// How much deeper it is in the solid above the level than below it, at x, given twice as large and on no edge: by the
/// edges that lie to the right, all of which pass the line.
int step_at(const Level& row, std::int64_t x) {
  int rounds = 0;
  for (const Edge& e : row.edges) {
    if (2 * e.from.x > x) rounds += e.to.y > e.from.y ? e.times : -e.times;
  }
  return row.sense == 0 ? -rounds : rounds % 2 != 0 ? row.sense : 0;
}

/// Those in which its boxes end, ascending.
std::array<std::vector<std::int64_t>, 3> coordinates_of(const Faces& faces) {
  std::array<std::vector<std::int64_t>, 3> at;
  for (const Point& v : faces.vertices) {
    at[0].push_back(v.x);
    at[1].push_back(v.y);
  }
  for (const Level& level : faces.levels) {
    if (!level.edges.empty()) at[2].push_back(level.z);
  }
  for (auto& axis : at) {
    std::sort(axis.begin(), axis.end());
    axis.erase(std::unique(axis.begin(), axis.end()), axis.end());
  }
  return at;
}

/// Columns of open boxes between the coordinates of all vertices, filled between the levels over them; nothing where
/// that would have too many cells.
std::optional<BoxComplex> filled(const Faces& faces) {
  const auto at = coordinates_of(faces);
  double cells = 1;
  for (const auto& axis : at) cells *= 2 * static_cast<double>(axis.size()) + 1;
  if (cells > static_cast<double>(BoxComplex::kMostCells)) return std::nullopt;
  std::vector<IntervalBox> boxes;
  for (std::size_t j = 0; j + 1 < at[1].size(); ++j) {
    const std::vector<Level> row = levels_at(faces.levels, at[1][j] + at[1][j + 1]);
    for (std::size_t i = 0; i + 1 < at[0].size(); ++i) {
      std::vector<std::pair<std::int64_t, int>> steps;
      for (const Level& level : row) {
        const int step = step_at(level, at[0][i] + at[0][i + 1]);
        if (step != 0) steps.emplace_back(level.z, step);
      }
      std::sort(steps.begin(), steps.end());
      int depth = 0;
      for (std::size_t s = 0; s + 1 < steps.size(); ++s) {
        depth += steps[s].second;
        if (steps[s].first == steps[s + 1].first) continue;
        // A surface that covers some space twice, or turns it inside out, is for the convex parts to refuse.
        if (depth < 0 || depth > 1) return std::nullopt;
        if (depth == 0) continue;
        IntervalBox box;
        box[0] = {Real(at[0][i]), Real(at[0][i + 1]), true, true};
        box[1] = {Real(at[1][j]), Real(at[1][j + 1]), true, true};
        box[2] = {Real(steps[s].first), Real(steps[s + 1].first), true, true};
        boxes.push_back(std::move(box));
      }
    }
  }
  return BoxComplex::of_boxes(boxes);
}

/// The set as one box, open or closed at each end, if it is one.
std::optional<IntervalBox> one_box(const BoxComplex& set) {
  std::vector<IntervalBox> boxes = set.simplified().boxes();
  if (boxes.size() != 1) return std::nullopt;
  return boxes[0];
}

BoxComplex of_box(const IntervalBox& box) { return BoxComplex::of_boxes(std::array<IntervalBox, 1>{box}); }

bool same_set(const BoxComplex& a, const BoxComplex& b) {
  return overlay(std::array<const BoxComplex*, 2>{&a, &b}, [](std::span<const Mark> m) { return Mark(m[0] != m[1]); })
      .empty();
}

/// Of a set that holds all corners of the box about it, or is open and comes up to all of them.
std::optional<BoxComplex> hull_of(const BoxComplex& set) {
  if (set.too_fine()) return std::nullopt;
  if (set.empty() || one_box(set)) return set;
  IntervalBox all;
  for (const IntervalBox& box : set.boxes()) {
    for (int k = 0; k < 3; ++k) {
      if (!box[k].from || !box[k].to) return std::nullopt;
      if (!all[k].from || *box[k].from < *all[k].from) all[k].from = box[k].from;
      if (!all[k].to || *all[k].to < *box[k].to) all[k].to = box[k].to;
      all[k].from_in = all[k].to_in = true;
    }
  }
  const bool open = same_set(set, interior(set));
  const BoxComplex reached = open ? closure(set) : set;
  for (int i = 0; i < 8; ++i) {
    RealVector corner;
    for (int k = 0; k < 3; ++k) corner[k] = (i >> k & 1) != 0 ? *all[k].to : *all[k].from;
    if (reached.mark(corner) == 0) return std::nullopt;
  }
  return open ? interior(of_box(all)) : of_box(all);
}

/// A ball fits into a box where its width along each axis does.
std::optional<BoxComplex> offset_of(const BoxComplex& set, const Real& amount) {
  if (amount.sign() == 0) return set;
  std::optional<IntervalBox> box = amount.sign() < 0 ? one_box(set) : std::nullopt;
  if (!box) return std::nullopt;
  for (Interval& i : *box) {
    if (i.from) i.from = *i.from - amount;
    if (i.to) i.to = *i.to + amount;
    if (i.from && i.to && (*i.to < *i.from || (*i.to == *i.from && !(i.from_in && i.to_in)))) return BoxComplex();
  }
  return of_box(*box);
}

BoxComplex united(const std::vector<BoxComplex>& sets) {
  std::vector<const BoxComplex*> all;
  for (const BoxComplex& s : sets) all.push_back(&s);
  return space::united(all);
}

/// The complement of the union of the sets, the first `inverted` of them replaced by their complements.
BoxComplex left_by(std::vector<BoxComplex> sets, std::size_t inverted) {
  for (std::size_t k = 0; k < inverted; ++k) sets[k] = complement(sets[k]);
  return complement(united(sets));
}

/// The node over its operands' sets; nothing where the result has other faces than those of boxes.
std::optional<BoxComplex> node(const plane::Shape& shape, const std::vector<BoxComplex>& c) {
  switch (shape.kind) {
    case Kind::kUnion:
      return united(c);
    case Kind::kIntersection:
      return left_by(c, c.size());
    case Kind::kDifference:
      return left_by(c, 1);
    case Kind::kComplement:
      return complement(c[0]);
    case Kind::kInterior:
      return interior(c[0]);
    case Kind::kClosure:
      return closure(c[0]);
    case Kind::kRegularize:
      return regularized(c[0]);
    case Kind::kBoundary:
      return boundary(c[0]);
    case Kind::kTranslate:
      return translated(c[0], {Real(shape.points[0].x), Real(shape.points[0].y), Real(shape.lift)});
    case Kind::kMirror:
      return mirrored(c[0]);
    case Kind::kMinkowskiSum:
      return sum(c[0], c[1]);
    case Kind::kMinkowskiDifference:
      return complement(sum(complement(c[0]), c[1]));
    case Kind::kHull:
      return hull_of(united(c));
    case Kind::kOffset:
      return offset_of(c[0], shape.amount);
    default:
      return std::nullopt;
  }
}

/// How many cells of a set are in it, of any range of cells at once.
class FullCells {
 public:
  /// More cells are not counted: each takes four bytes.
  static constexpr std::size_t kMost = std::size_t{1} << 22;

  explicit FullCells(const BoxComplex& set) : set_(set), below_(count(set)) {
    for (int z = 0; z < set.cells(2); ++z) {
      for (int y = 0; y < set.cells(1); ++y) {
        for (int x = 0; x < set.cells(0); ++x) {
          below_[index(x, y, z)] = (set.mark(x, y, z) != 0 ? 1 : 0) + below(x - 1, y, z) + below(x, y - 1, z) +
                                   below(x, y, z - 1) - below(x - 1, y - 1, z) - below(x - 1, y, z - 1) -
                                   below(x, y - 1, z - 1) + below(x - 1, y - 1, z - 1);
        }
      }
    }
  }
  static std::size_t count(const BoxComplex& set) {
    return static_cast<std::size_t>(set.cells(0)) * static_cast<std::size_t>(set.cells(1)) *
           static_cast<std::size_t>(set.cells(2));
  }

  bool full(const CellRange& r) const {
    std::int64_t count = 0, all = 1;
    for (int k = 0; k < 8; ++k) {
      const int sign = (k & 1) + (k >> 1 & 1) + (k >> 2 & 1);
      const auto end = [&](int axis) { return (k >> axis & 1) != 0 ? r[axis][0] - 1 : r[axis][1]; };
      count += (sign % 2 == 0 ? 1 : -1) * static_cast<std::int64_t>(below(end(0), end(1), end(2)));
    }
    for (const auto& [first, last] : r) all *= last - first + 1;
    return count == all;
  }

  /// As far as the set goes, along one axis after the other, by a coordinate at a time.
  void grow(CellRange& r) const {
    for (int k = 0; k < 3; ++k) {
      for (const int side : {0, 1}) {
        for (;;) {
          CellRange next = r;
          next[k][side] += side == 0 ? -2 : 2;
          if (next[k][0] < 0 || next[k][1] >= set_.cells(k) || !full(next)) break;
          r = next;
        }
      }
    }
  }

 private:
  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(set_.cells(1)) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(set_.cells(0)) +
           static_cast<std::size_t>(x);
  }
  std::int32_t below(int x, int y, int z) const { return x < 0 || y < 0 || z < 0 ? 0 : below_[index(x, y, z)]; }

  const BoxComplex& set_;
  std::vector<std::int32_t> below_;
};

/// Boxes whose union is the closed set and that may overlap, so that a flat stretch of its surface is on one of them:
/// a search over it then needs no seams.
std::vector<IntervalBox> grown_boxes(const BoxComplex& set) {
  std::vector<IntervalBox> boxes = set.boxes();
  if (boxes.size() < 2 || FullCells::count(set) > FullCells::kMost) return boxes;
  const FullCells cells(set);
  std::vector<CellRange> grown;
  for (const IntervalBox& box : boxes) {
    CellRange range{};
    for (int k = 0; k < 3; ++k) {
      if (!box[k].from || !box[k].to) return boxes;
      // An end that is not in it is that of its closure, which is in the set.
      range[k] = {set.cell_of(k, *box[k].from), set.cell_of(k, *box[k].to)};
    }
    cells.grow(range);
    if (std::find(grown.begin(), grown.end(), range) == grown.end()) grown.push_back(range);
  }
  boxes.clear();
  for (const CellRange& range : grown) {
    IntervalBox& box = boxes.emplace_back();
    for (int k = 0; k < 3; ++k) box[k] = set.interval(k, range[k][0], range[k][1]);
  }
  return boxes;
}

std::optional<BoxComplex> coarse(std::optional<BoxComplex> set) {
  return set && !set->too_fine() ? std::move(set) : std::nullopt;
}

}  // namespace

std::optional<BoxComplex> box_complex(const plane::Shape& shape) {
  if (const Solid* solid = solid_of(shape)) {
    try {
      const auto faces = faces_of(*solid);
      return faces ? coarse(filled(*faces)) : std::nullopt;
    } catch (const Error& e) {
      throw e.place().empty() && !shape.place.empty() ? e.within(shape.place) : e;
    }
  }
  std::vector<BoxComplex> children;
  for (const plane::ShapePtr& child : shape.children) {
    auto set = box_complex(*child);
    if (!set) return std::nullopt;
    children.push_back(std::move(*set));
  }
  if (children.empty()) return std::nullopt;
  auto result = coarse(node(shape, children));
  return result ? std::optional(result->simplified()) : std::nullopt;
}

std::optional<Body> body_of(const BoxComplex& set) {
  const BoxComplex open = interior(set), closed = closure(set), whole = closure(open);
  if (open.empty() || !same_set(closed, whole)) return std::nullopt;
  Body body;
  for (const IntervalBox& box : grown_boxes(whole.simplified())) {
    std::vector<Point> corners;
    std::array<std::array<std::int64_t, 2>, 3> ends{};
    bool flat = false;
    for (int k = 0; k < 3; ++k) {
      if (!box[k].from || !box[k].to) return std::nullopt;
      const auto a = box[k].from->integer(), b = box[k].to->integer();
      if (!a || !b) return std::nullopt;
      ends[k] = {static_cast<std::int64_t>(*a), static_cast<std::int64_t>(*b)};
      flat = flat || *a == *b;
    }
    if (flat) continue;  // between boxes, which hold it in their closures
    for (int i = 0; i < 8; ++i) corners.push_back({ends[0][i & 1], ends[1][i >> 1 & 1], ends[2][i >> 2 & 1]});
    body.parts.push_back({Polytope::hull(corners), {}, Real()});
  }
  return body;
}

}  // namespace findspace::space
