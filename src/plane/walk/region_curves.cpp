// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "plane/walk/region_curves.h"

#include <algorithm>
#include <cmath>

#include "exact/planar/geometry_signs.h"
#include "exact/planar/unreduced_lines.h"
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

constexpr PieceBox kNoBox{exact::kInfinity, exact::kInfinity, -exact::kInfinity, -exact::kInfinity};

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
  std::size_t edges = 0;
  for (const auto& polygon : polygons)
    for (const Contour& ring : polygon) edges += ring.size();
  RegionCurves all(memory);
  all.curves.geometry.supporting_curves.resize(edges, exact::SupportingCurve());
  all.curves.geometry.points.reserve(edges + edges / 2);  // and some crossings
  all.curves.geometry.points.resize(edges, exact::Point());
  all.curves.pieces.resize(edges);
  all.curves.sides.resize(edges);
  all.curves.unreduced = true;
  all.first_.reserve(polygons.size() + 1);
  Index first = 0;  // of a ring
  for (Index number = 0; number < polygons.size(); ++number) {
    all.first_.push_back(first);
    for (const Contour& ring : polygons[number]) {
      if (!all.set_curves(ring, first, number)) return std::nullopt;
      first += Index(ring.size());
    }
  }
  all.first_.push_back(first);
  all.set_boxes();
  return all;
}

bool RegionCurves::set_curves(const Contour& ring, Index first, Index number) {
  const Index end = first + Index(ring.size());
  const ContourEdge* edge = ring.data();
  for (Index k = first; k < end; ++k, ++edge) {
    if (edge->arc) return false;
    const Index next = k + 1 == end ? first : k + 1;
    const GridPoint from = edge->start, to = ring[next - first].start;
    exact::Point& point = curves.geometry.points[k];
    point.gx = from.x;
    point.gy = from.y;
    point.x = double(from.x);
    point.y = double(from.y);
    exact::set_unreduced_line(curves.geometry.supporting_curves[k], from.x, from.y, to.x, to.y);
    const bool right = from < to;
    Piece& piece = curves.pieces[k];
    piece.supporting_curve = k;
    piece.p0 = right ? k : next;
    piece.p1 = right ? next : k;
    piece.group = number;
    curves.sides[k].left = right;
  }
  for (Index k = first, before = end - 1; k < end; before = k++)
    if (are_parallel(curves.geometry.supporting_curves[before], curves.geometry.supporting_curves[k])) return false;
  return true;
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
  double error = 0;
  PieceBox all = kNoBox;
  for (const exact::Point& p : curves.geometry.points) {
    error = std::max(error, double(p.error));
    all = joined(all, {p.x, p.y, p.x, p.y});
  }
  slack_ = box_slack(
      error, std::max(std::max(std::abs(all.x0), std::abs(all.x1)), std::max(std::abs(all.y0), std::abs(all.y1))));
  grid_ = CoarseGrid({all.x0 - slack_, all.y0 - slack_, all.x1 + slack_, all.y1 + slack_});
  const Index count = Index(curves.pieces.size());
  boxes_.resize(count + set_count());
  region_boxes_.resize(set_count());
  Index most = 0;
  for (Index r = 0; r < set_count(); ++r) {
    PieceBox of_set = kNoBox;
    for (Index i = first_[r]; i < first_[r + 1]; ++i) {
      const Piece& p = curves.pieces[i];
      const PieceBox box = segment_box(curves.geometry.points[p.p0], curves.geometry.points[p.p1], slack_);
      boxes_[i] = grid_.box(box);
      of_set = joined(of_set, box);
    }
    region_boxes_[r] = of_set;
    if (first_[r] < first_[r + 1]) boxes_[count + r] = grid_.box(of_set);  // an empty set meets nothing
    most = std::max(most, first_[r + 1] - first_[r]);
  }
  of_a_.resize(most);
  of_b_.resize(most);
}

std::optional<RegionCurves::Pairs> RegionCurves::pairs() {
  Pairs pairs(near_.get_allocator()), met(near_.get_allocator());
  pairs.reserve(curves.pieces.size());
  looks_ = kLooksPerCurve * curves.pieces.size();
  bool few = true;
  meeting_boxes(region_boxes_, [&](Index a, Index b) {
    few = take_looks(first_[a + 1] - first_[a] + first_[b + 1] - first_[b]);
    if (!few) return false;
    met.emplace_back(a, b);
    return few = add_pairs(a, b, pairs);
  });
  if (!few) return std::nullopt;
  set_near(met);
  return pairs;
}

std::span<const Index> RegionCurves::meeting(Index region, Index other, std::span<Index> list) const {
  const CoarseBox of_other = boxes_[curves.pieces.size() + other];
  const CoarseBox* box = boxes_.data() + first_[region];
  Index* end = list.data();
  for (Index i = first_[region], last = first_[region + 1]; i < last; ++i, ++box) {
    *end = i;
    end += box->meets(of_other) ? 1 : 0;  // as likely as not, so without a jump
  }
  return {list.data(), end};
}

bool RegionCurves::add_pairs(Index a, Index b, Pairs& to) {
  const auto of_a = meeting(a, b, of_a_), of_b = meeting(b, a, of_b_);
  if (of_a.size() * of_b.size() <= kFewPairs) {
    const CoarseBox* const boxes = boxes_.data();
    for (const Index i : of_a) {
      const CoarseBox box = boxes[i];
      for (const Index j : of_b)
        if (box.meets(boxes[j])) to.emplace_back(i, j);
    }
    return true;
  }
  if (!take_looks(kLooksOfGrid * (of_a.size() + of_b.size()))) return false;
  std::vector<Index> numbers(of_a.begin(), of_a.end());
  numbers.insert(numbers.end(), of_b.begin(), of_b.end());
  std::vector<Piece> pieces;
  for (const Index i : numbers) pieces.push_back(curves.pieces[i]);
  const CellGrid grid(curves.geometry, pieces, {}, kHeap);
  grid.pairs([&](Index i, Index j) {
    if (pieces[i].group != pieces[j].group) to.emplace_back(numbers[i], numbers[j]);
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
  const CoarseBox at = box_at(point);
  for (Index k = first_near_[a]; k < first_near_[a + 1]; ++k)
    if (near_[k] != b && holds(near_[k], point, at)) return true;
  return false;
}

bool RegionCurves::is_covered(Index point, Index curve) const {
  const CoarseBox at = box_at(point);
  const Index own = curves.pieces[curve].group;
  for (Index k = first_near_[own]; k < first_near_[own + 1]; ++k) {
    const Index other = along(near_[k], point, curve);
    const bool covers =
        other != kNone ? runs_right(curves, other) != runs_right(curves, curve) : holds(near_[k], point, at);
    if (covers) return true;
  }
  return false;
}

Index RegionCurves::along(Index region, Index point, Index curve) const {
  const exact::SupportingCurve& k = curves.geometry.supporting_curves[curves.pieces[curve].supporting_curve];
  for (Index i = first_[region]; i < first_[region + 1]; ++i) {
    const Piece& piece = curves.pieces[i];
    const exact::SupportingCurve& l = curves.geometry.supporting_curves[piece.supporting_curve];
    const bool on_one_line =
        are_parallel(k, l) && side(curves.geometry, piece.p0, curves.pieces[curve].supporting_curve) == 0;
    if (on_one_line && within(curves.geometry, piece, point) != Within::kOutside) return i;
  }
  return kNone;
}

CoarseBox RegionCurves::box_at(Index point) const {
  const exact::Point& p = curves.geometry.points[point];
  return grid_.nearest_box({p.x - slack_, p.y - slack_, p.x + slack_, p.y + slack_});
}

/// By the number of edges that a ray straight down, a little to the left of the point, meets.
bool RegionCurves::holds(Index region, Index point, const CoarseBox& at) const {
  if (!boxes_[curves.pieces.size() + region].meets(at)) return false;
  const exact::Geometry& g = curves.geometry;
  bool inside = false;
  for (Index i = first_[region]; i < first_[region + 1]; ++i) {
    if (!boxes_[i].meets_strip_below(at)) continue;
    const Piece& piece = curves.pieces[i];
    if (compare_x(g, piece.p0, point) < 0 && compare_x(g, piece.p1, point) >= 0)
      inside ^= boxes_[i].is_below(at) || height(g, piece, point) > 0;
  }
  return inside;
}

}  // namespace findspace::plane
