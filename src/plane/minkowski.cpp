// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/minkowski.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "plane/arrangement.h"
#include "plane/convolution.h"
#include "plane/grid_sum.h"
#include "plane/overlay.h"
#include "plane/point_winding.h"

namespace findspace::plane {
namespace {

bool in(Mark m) { return m > 0; }
bool out(Mark m) { return m <= 0; }

/// Could a set as large as `around` go round one as large as `inner`?
bool fits(const Extent& inner, const Extent& around) {
  return inner.x1 - inner.x0 - 4 <= around.x1 - around.x0 && inner.y1 - inner.y0 - 4 <= around.y1 - around.y0;
}

bool can_enclose(const Part& ring, const Part& other) {
  return std::any_of(ring.holes.begin(), ring.holes.end(),
                     [&](const Extent& hole) { return other.unbounded || fits(hole, other.filled); });
}

exact::Real reach_of(const Part& p) {
  return exact::Real::from_double(std::ceil(std::hypot(p.filled.x1 - p.filled.x0, p.filled.y1 - p.filled.y0))) +
         exact::Real(2);
}

/// Adds up the convolutions of pairs of parts; where an intersection of the two could be a ring, whose Euler
/// characteristic is 0, holes are bridged first so that every number counts simply connected components.
class SumOfPairs {
 public:
  /// The curves are added to the given geometry.
  explicit SumOfPairs(bool open, exact::Geometry geometry = {}) : builder_(open) {
    builder_.curves.geometry = std::move(geometry);
  }

  void add(const Part& a, const Part& b) {
    const Part* p = &a;
    const Part* q = &b;
    Part a_bridged, b_bridged;
    // A curve goes round nothing, and it could lie in a bridge.
    if (!b.flat && can_enclose(a, b)) p = &(a_bridged = bridged(a, reach_of(b)));
    if (!a.flat && can_enclose(b, a)) q = &(b_bridged = bridged(b, reach_of(a)));
    if (p->unbounded) base_ += q->euler;
    builder_.add(*p, *q);
  }

  /// -1 where the number is positive, 0 on the boundary of that, +1 elsewhere.
  SignMap open_sum() && {
    Arrangement a = arranged();
    Windings w = windings(a, strands_, corners_, base_);
    add_circled(a, w);
    for (Index p : lonely_)
      w.vertices[a.point_vertex[p]] -= w.vertices[a.point_vertex[p]] != kUnwanted;  // a missing point
    Marks m;
    for (auto k : w.faces) m.faces.push_back(k > 0 ? -1 : 1);
    for (Index e = 0; e < a.edge_count(); ++e) {
      bool beside = w.faces[a.face[2 * e]] > 0 || w.faces[a.face[2 * e + 1]] > 0;
      m.edges.push_back(w.edges[e] > 0 ? -1 : beside ? 0 : 1);
    }
    for (Index v = 0; v < a.vertex_count(); ++v) {
      bool beside = w.faces[a.some_face(v)] > 0;
      for (Index k = a.out_start[v]; !beside && k < a.out_start[v + 1]; ++k) beside = w.faces[a.face[a.out[k]]] > 0;
      m.vertices.push_back(w.vertices[v] != kUnwanted && w.vertices[v] > 0 ? -1 : beside ? 0 : 1);
    }
    return extract(a, m);
  }

  /// The numbers at single points, of solid parts bounded by segments.
  PointWinding numbers() && { return PointWinding(std::move(builder_), base_); }

  /// 1 where the number is positive.
  Region closed_sum() && {
    Arrangement a = arranged();
    Windings w = windings(a, strands_, corners_, base_, VertexScope::kAll);
    add_circled(a, w);
    for (Index p : lonely_) w.vertices[a.point_vertex[p]] = 1;
    Marks m;
    for (auto k : w.faces) m.faces.push_back(k > 0);
    for (auto k : w.edges) m.edges.push_back(k > 0);
    for (auto k : w.vertices) m.vertices.push_back(k > 0);
    return extract(a, m);
  }

 private:
  Arrangement arranged() {
    strands_ = std::move(builder_.strands);
    corners_ = std::move(builder_.corners);
    lonely_ = std::move(builder_.points);
    circled_ = std::move(builder_.circled);
    std::vector<Index> isolated = lonely_;
    for (const auto& c : circled_) isolated.push_back(c.point);
    return arrange(std::move(builder_.curves.geometry), std::move(builder_.curves.pieces), isolated);
  }

  void add_circled(const Arrangement& a, Windings& w) const {
    for (const auto& c : circled_) {
      std::int32_t& number = w.vertices[a.point_vertex[c.point]];
      if (number != kUnwanted) number += c.rounds;
    }
  }

  ConvolutionBuilder builder_;
  std::int32_t base_ = 0;
  std::vector<Strand> strands_;
  std::vector<Corner> corners_;
  std::vector<Index> lonely_;
  std::vector<ConvolutionBuilder::Circled> circled_;
};

/// A set whose sums are asked for; which marks belong to it; whether it is to be reflected through the origin.
struct Operand {
  const CellComplex& cells;
  bool (*wanted)(Mark);
  bool mirrored = false;
  bool flat = true;  // with its parts that have no interior

  std::vector<Part> solid_parts() const { return turned(face_parts(cells, wanted)); }
  std::vector<Part> flat_parts() const { return flat ? turned(plane::flat_parts(cells, wanted)) : std::vector<Part>(); }
  std::optional<std::vector<GridFace>> grid() const { return grid_faces(cells, wanted, mirrored); }

 private:
  std::vector<Part> turned(std::vector<Part> parts) const {
    if (mirrored)
      for (Part& p : parts) p = plane::mirrored(std::move(p));
    return parts;
  }
};

/// Whether a point lies in the sum of the solid parts: built when first asked.
class SolidSum {
 public:
  SolidSum(const Operand& a, const Operand& b) : a_(a), b_(b) {}

  bool holds(exact::Geometry& g, Index point) {
    if (!numbers_) build(g);
    return numbers_->at(g, point) > 0;
  }

 private:
  void build(exact::Geometry& g) {
    SumOfPairs sum(true, std::move(g));
    std::vector<Part> q = b_.solid_parts();
    for (const Part& x : a_.solid_parts())
      for (const Part& y : q) sum.add(x, y);
    numbers_ = std::move(sum).numbers();
    g = numbers_->take_geometry();
  }

  const Operand &a_, &b_;
  std::optional<PointWinding> numbers_;
};

/// The open sum of two sets bounded by grid segments, without parts that have no interior.
std::optional<SignMap> open_grid_sum(const Operand& a, const Operand& b) {
  auto p = a.grid();
  if (!p) return std::nullopt;
  auto q = b.grid();
  if (!q) return std::nullopt;
  SolidSum solid(a, b);
  return grid_sum({*p, a.cells.geometry}, {*q, b.cells.geometry},
                  [&](exact::Geometry& g, Index point) { return solid.holds(g, point); });
}

/// -1 on U = (int A (+) B) u (A (+) int B), 0 on its boundary, +1 elsewhere.
SignMap open_sum(const Operand& a, const Operand& b) {
  SumOfPairs sum(true);
  std::vector<Part> p = a.solid_parts(), q = b.solid_parts(), p_flat = a.flat_parts(), q_flat = b.flat_parts();
  for (const Part& x : p) {
    for (const Part& y : q) sum.add(x, y);
    for (const Part& y : q_flat) sum.add(x, y);
  }
  for (const Part& x : p_flat)
    for (const Part& y : q) sum.add(x, y);
  return std::move(sum).open_sum();
}

/// {a + b} for a in A, b in B: -1 on the open part U, 0 on the rest of the sum, +1 elsewhere.
SignMap sum_map(const Operand& a, const Operand& b) {
  if (auto map = open_grid_sum(a, b)) return *std::move(map);
  SignMap open = open_sum(a, b);
  std::vector<Part> p = a.flat_parts(), q = p.empty() ? p : b.flat_parts();
  if (q.empty()) return open;
  SumOfPairs flat(false);
  for (const Part& x : p)
    for (const Part& y : q) flat.add(x, y);
  Region closed = std::move(flat).closed_sum();
  std::array<const CellComplex*, 2> both{&open, &closed};
  return overlay(both, [](std::span<const Mark> m) { return Mark(m[0] <= 0 ? m[0] : m[1] > 0 ? 0 : 1); });
}

}  // namespace

SignMap contact_map(const Region& a, const Region& b) { return sum_map({a, in}, {b, in, true}); }

SignMap containment_map(const Region& a, const Region& b) {
  // B + p leaves A where it meets the open complement; it leaves int A where it meets the closure of that.
  Operand outside{a, out, false, false}, moving{b, in, true};
  auto grid = open_grid_sum(outside, moving);
  SignMap leaves = grid ? *std::move(grid) : open_sum(outside, moving);
  return remark(std::move(leaves), [](Mark m) { return Mark(-m); });
}

Region minkowski_sum(const Region& a, const Region& b) {
  return remark(sum_map({a, in}, {b, in}), [](Mark m) { return Mark(m <= 0); });
}

Region minkowski_difference(const Region& a, const Region& b) {
  return remark(containment_map(a, mirrored(b)), [](Mark m) { return Mark(m <= 0); });
}

namespace {

void mirror_geometry(exact::Geometry& g) {
  using exact::Carrier;
  // A crossing with a line keeps its root only if the line's direction is mirrored too, and that stays canonical.
  for (exact::Point& p : g.points) {
    p.gx = -p.gx, p.gy = -p.gy, p.x = -p.x, p.y = -p.y;
    if (p.kind == exact::Point::Kind::kCross && g.carriers[p.i].circle != g.carriers[p.j].circle)
      p.root = std::int8_t(-p.root);
  }
  for (Carrier& k : g.carriers) {
    if (k.circle)
      k = k.grid ? Carrier::circle_at(-k.a, -k.b, k.w) : Carrier::circle_at(-k.real->x, -k.real->y, k.w);
    else
      k = k.real ? Carrier::line(k.a, k.b, -k.real->x) : Carrier::displaced_line(k.a, k.b, -k.c, -k.w);
  }
  for (exact::RealPoint& p : g.reals) p = {-p.x, -p.y};
}

}  // namespace

CellComplex mirrored(const CellComplex& c) {
  CellComplex m = c;
  mirror_geometry(m.geometry);
  // What ran to the right runs to the left: half-edges 2e and 2e + 1 change places.
  auto flip = [](Index h) { return h == kNone ? kNone : h ^ 1u; };
  for (Edge& e : m.edges) {
    std::swap(e.v0, e.v1);
    e.half = std::int8_t(-e.half);
  }
  for (Index h = 0; h < c.half_edges.size(); ++h)
    m.half_edges[flip(h)] = {flip(c.half_edges[h].next), c.half_edges[h].face};
  for (Face& f : m.faces) {
    f.outer = flip(f.outer);
    for (Index& h : f.inner) h = flip(h);
  }
  for (Index v = 0; v < c.vertices.size(); ++v) {
    // Counter-clockwise from straight down now means from straight up before: the first of those that went left, if
    // there are others.
    Index first = c.vertices[v].out;
    if (first != kNone && !(first & 1u)) {
      Index h = c.clockwise(first);
      for (; h & 1u; h = c.clockwise(h)) first = h;
    }
    m.vertices[v].out = flip(first);
  }
  return m;
}

}  // namespace findspace::plane
