// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "plane/walk/region_curves.h"

#include <algorithm>
#include <cmath>

#include "exact/planar/geometry_signs.h"
#include "plane/complex/piece_meet.h"
#include "plane/complex/side_by_side.h"

namespace findspace::plane {
namespace {

constexpr std::size_t kLooksPerCurve = 128;  // an arrangement costs more a curve,
constexpr std::size_t kLooksPerPart = 12;    // and more a part between crossings
constexpr std::size_t kFewPairs = 4096;      // from here on a grid of cells costs less than all pairs,
constexpr std::size_t kLooksOfGrid = 96;     // and as much as so many looks a curve

/// As many edges as vertices, and none of them isolated, so that each vertex of a closed regular set has two edges.
bool is_rings(const Region& r) {
  if (is_in(r.faces[0].mark) || r.edges.size() != r.vertices.size()) return false;
  return std::all_of(r.vertices.begin(), r.vertices.end(),
                     [](const Vertex& v) { return is_in(v.mark) && v.out != kNone; });
}

PieceBox common(const PieceBox& a, const PieceBox& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

}  // namespace

std::optional<RegionCurves> RegionCurves::of(std::span<const Region* const> regions, Memory memory) {
  RegionCurves all(memory);
  all.reserve(regions);
  for (const Region* r : regions)
    if (!all.add(*r)) return std::nullopt;
  all.first_.push_back(Index(all.curves.pieces.size()));
  all.set_boxes();
  return all;
}

std::optional<RegionCurves> RegionCurves::of(Polygons polygons, Memory memory) {
  RingCurves rings = ring_curves(polygons, memory);
  if (rings.could_merge) return std::nullopt;
  RegionCurves all(memory);
  all.curves.geometry = std::move(rings.geometry);
  all.curves.pieces.reserve(rings.edges.size());
  all.curves.sides.reserve(rings.edges.size());
  all.first_.reserve(polygons.size() + 1);
  for (std::size_t r = 0; r < rings.rings.size(); ++r) {
    const Index first = rings.rings[r].start;
    const Index end = r + 1 < rings.rings.size() ? rings.rings[r + 1].start : Index(rings.edges.size());
    if (rings.rings[r].outer) all.first_.push_back(first);
    const Index number = Index(all.first_.size()) - 1;
    for (Index k = first; k < end; ++k) {
      const RingEdge& e = rings.edges[k];
      if (e.half != 0) return std::nullopt;
      const Index to = rings.edges[k + 1 == end ? first : k + 1].point;
      all.curves.pieces.push_back({.supporting_curve = e.supporting_curve,
                                   .p0 = e.right ? e.point : to,
                                   .p1 = e.right ? to : e.point,
                                   .group = number});
      all.curves.sides.push_back({.left = e.right});
    }
  }
  all.first_.push_back(Index(all.curves.pieces.size()));
  all.set_boxes();
  return all;
}

void RegionCurves::reserve(std::span<const Region* const> regions) {
  std::size_t supporting_curves = 0, points = 0, edges = 0;
  for (const Region* r : regions) {
    supporting_curves += r->geometry.supporting_curves.size();
    points += r->geometry.points.size();
    edges += r->edges.size();
  }
  curves.geometry.supporting_curves.reserve(supporting_curves);
  curves.geometry.points.reserve(points + points / 4);  // and some crossings
  curves.pieces.reserve(edges);
  curves.sides.reserve(edges);
  first_.reserve(regions.size() + 1);
}

bool RegionCurves::add(const Region& r) {
  if (!is_rings(r)) return false;
  const Index line = Index(curves.geometry.supporting_curves.size()), point = append(curves.geometry, r.geometry);
  const Index number = Index(first_.size());
  first_.push_back(Index(curves.pieces.size()));
  for (Index e = 0; e < r.edges.size(); ++e) {
    const Edge& d = r.edges[e];
    const bool left = is_in(r.faces[r.face(2 * e)].mark), right = is_in(r.faces[r.face(2 * e + 1)].mark);
    if (left == right || d.half != 0 || !is_in(d.mark) || !r.supporting_curve(e).grid) return false;
    curves.pieces.push_back({.supporting_curve = d.supporting_curve + line,
                             .p0 = r.vertices[d.v0].point + point,
                             .p1 = r.vertices[d.v1].point + point,
                             .group = number});
    curves.sides.push_back({.left = left});
  }
  return true;
}

void RegionCurves::set_boxes() {
  double error = 0, largest = 0;
  for (const exact::Point& p : curves.geometry.points) {
    error = std::max<double>(error, p.error);
    largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  }
  slack_ = box_slack(error, largest);
  boxes_.reserve(curves.pieces.size());
  region_boxes_.reserve(first_.size());
  for (std::size_t r = 0; r + 1 < first_.size(); ++r) {
    PieceBox all{exact::kInfinity, exact::kInfinity, -exact::kInfinity, -exact::kInfinity};
    for (Index i = first_[r]; i < first_[r + 1]; ++i) {
      const Piece& p = curves.pieces[i];
      boxes_.push_back(segment_box(curves.geometry.points[p.p0], curves.geometry.points[p.p1], slack_));
      all = joined(all, boxes_.back());
    }
    region_boxes_.push_back(all);
  }
}

std::optional<RegionCurves::Pairs> RegionCurves::pairs() {
  Pairs pairs(near_.get_allocator()), met(near_.get_allocator());
  looks_ = kLooksPerCurve * curves.pieces.size();
  bool few = true;
  meeting_boxes(region_boxes_, [&](Index a, Index b) {
    few = take_looks(first_[a + 1] - first_[a] + first_[b + 1] - first_[b]);
    if (!few) return false;
    met.emplace_back(a, b);
    return few = add_pairs(a, b, common(region_boxes_[a], region_boxes_[b]), pairs);
  });
  if (!few) return std::nullopt;
  set_near(met);
  return pairs;
}

void RegionCurves::append_meeting(Index region, const PieceBox& common, std::vector<Index>& to) const {
  for (Index i = first_[region]; i < first_[region + 1]; ++i)
    if (boxes_[i].meets(common)) to.push_back(i);
}

bool RegionCurves::add_pairs(Index a, Index b, const PieceBox& common, Pairs& to) {
  of_a_.clear();
  of_b_.clear();
  append_meeting(a, common, of_a_);
  append_meeting(b, common, of_b_);
  if (of_a_.size() * of_b_.size() <= kFewPairs) {
    for (const Index i : of_a_)
      for (const Index j : of_b_)
        if (boxes_[i].meets(boxes_[j])) to.emplace_back(i, j);
    return true;
  }
  if (!take_looks(kLooksOfGrid * (of_a_.size() + of_b_.size()))) return false;
  std::vector<Piece> pieces;
  of_a_.insert(of_a_.end(), of_b_.begin(), of_b_.end());
  for (const Index i : of_a_) pieces.push_back(curves.pieces[i]);
  const CellGrid grid(curves.geometry, pieces, {}, std::pmr::new_delete_resource());
  grid.pairs([&](Index i, Index j) {
    if (pieces[i].group != pieces[j].group) to.emplace_back(of_a_[i], of_a_[j]);
  });
  return true;
}

void RegionCurves::set_near(std::span<const std::pair<Index, Index>> met) {
  first_near_.assign(first_.size(), 0);
  near_curves_.assign(first_.size(), 0);
  for (const auto& [a, b] : met) {
    ++first_near_[a];
    ++first_near_[b];
    near_curves_[a] += first_[b + 1] - first_[b];
    near_curves_[b] += first_[a + 1] - first_[a];
  }
  Index end = 0;
  for (Index& first : first_near_) first = end += first;
  near_.resize(end);
  for (const auto& [a, b] : met) {
    near_[--first_near_[a]] = b;
    near_[--first_near_[b]] = a;
  }
}

void RegionCurves::allow_looks(std::size_t parts) { looks_ = kLooksPerPart * parts; }

bool RegionCurves::look_near(Index set) { return take_looks(near_curves_[set]); }

bool RegionCurves::take_looks(std::size_t count) {
  if (count > looks_) return false;
  looks_ -= count;
  return true;
}

bool RegionCurves::is_inside_another(Index point, Index a, Index b) const {
  for (Index k = first_near_[a]; k < first_near_[a + 1]; ++k)
    if (near_[k] != b && holds(near_[k], point)) return true;
  return false;
}

bool RegionCurves::is_covered(Index point, Index curve) const {
  const Index own = curves.pieces[curve].group;
  for (Index k = first_near_[own]; k < first_near_[own + 1]; ++k) {
    const Index other = along(near_[k], point, curve);
    const bool covers =
        other != kNone ? runs_right(curves, other) != runs_right(curves, curve) : holds(near_[k], point);
    if (covers) return true;
  }
  return false;
}

Index RegionCurves::along(Index region, Index point, Index curve) const {
  const exact::SupportingCurve& k = curves.geometry.supporting_curves[curves.pieces[curve].supporting_curve];
  for (Index i = first_[region]; i < first_[region + 1]; ++i) {
    const Piece& piece = curves.pieces[i];
    const exact::SupportingCurve& l = curves.geometry.supporting_curves[piece.supporting_curve];
    const bool on_one_line = k.a == l.a && k.b == l.b && k.c == l.c;
    if (on_one_line && within(curves.geometry, piece, point) != Within::kOutside) return i;
  }
  return kNone;
}

/// By the number of edges that a ray straight down, a little to the left of the point, meets.
bool RegionCurves::holds(Index region, Index point) const {
  const exact::Geometry& g = curves.geometry;
  const exact::Point& p = g.points[point];
  const PieceBox at{p.x - slack_, p.y - slack_, p.x + slack_, p.y + slack_};
  if (!region_boxes_[region].meets(at)) return false;
  bool inside = false;
  for (Index i = first_[region]; i < first_[region + 1]; ++i) {
    const PieceBox& box = boxes_[i];
    if (box.x0 > at.x1 || box.x1 < at.x0 || box.y0 > at.y1) continue;
    const Piece& piece = curves.pieces[i];
    if (compare_x(g, piece.p0, point) < 0 && compare_x(g, piece.p1, point) >= 0)
      inside ^= box.y1 < at.y0 || height(g, piece, point) > 0;
  }
  return inside;
}

}  // namespace findspace::plane
