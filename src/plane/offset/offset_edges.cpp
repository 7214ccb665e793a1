// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/offset/offset_edges.h"

#include <cmath>
#include <utility>

#include "exact/margins/plane.h"

namespace findspace::plane {
namespace {

/// How often a curve is halved to find every part near one edge.
constexpr int kHalvings = 5;
/// Up to so many questions all edges are looked through; then the tree of boxes is made.
constexpr int kFewQuestions = 8;
/// Edges before and after its own that are tried first.
constexpr Index kBeside = 4;

PieceBox edge_box(std::span<const GridCorner> corners, const GridCorner& c) {
  const GridPoint p = c.at, q = corners[c.next].at;
  return {double(std::min(p.x, q.x)), double(std::min(p.y, q.y)), double(std::max(p.x, q.x)),
          double(std::max(p.y, q.y))};
}

/// Whether the box of an edge from p to q meets another: mostly its first side tells.
bool edge_meets(GridPoint p, GridPoint q, const PieceBox& box) {
  return double(std::min(p.x, q.x)) <= box.x1 && double(std::max(p.x, q.x)) >= box.x0 &&
         double(std::min(p.y, q.y)) <= box.y1 && double(std::max(p.y, q.y)) >= box.y0;
}

std::vector<PieceBox> boxes_of(std::span<const GridCorner> corners) {
  std::vector<PieceBox> boxes;
  boxes.reserve(corners.size());
  for (const GridCorner& c : corners) boxes.push_back(edge_box(corners, c));
  return boxes;
}

PieceBox grown(const PieceBox& b, double by) { return {b.x0 - by, b.y0 - by, b.x1 + by, b.y1 + by}; }

}  // namespace

GridCorners all_corners(GridFaces faces) {
  GridCorners all;
  for (GridFace& f : faces) {
    const Index base = Index(all.size());
    if (base == 0) {
      all = std::move(f.corners);
      continue;
    }
    for (GridCorner c : f.corners) {
      c.next += base;
      c.before += base;
      all.push_back(c);
    }
  }
  return all;
}

OffsetEdges::OffsetEdges(std::span<const GridCorner> corners, const exact::Real& radius)
    : corners_(corners), radius_(radius), r_(radius.to_double()) {}

void OffsetEdges::prepare() {
  if (boxes_) return;
  boxes_.emplace(boxes_of(corners_));
  double largest = 0;
  edges_.reserve(corners_.size());
  for (const GridCorner& c : corners_) {
    const GridPoint q = corners_[c.next].at;
    const Vector from{double(c.at.x), double(c.at.y)}, way = Vector{double(q.x), double(q.y)} - from;
    const double length = std::sqrt(dot(way, way));
    largest = std::max({largest, std::abs(from.x), std::abs(from.y)});
    edges_.push_back({from, way, {way.y / length, -way.x / length}, 1 / dot(way, way)});
  }
  certain_ = r_ - (largest + r_) * margin::kCertainlyFarther;
}

bool OffsetEdges::holds(const exact::Geometry& g, Index point, std::span<const Index> own) {
  const exact::Point& p = g.points[point];
  const double reach =
      (r_ + p.error) * (1 + margin::kCertainlyFarther) + (std::abs(p.x) + std::abs(p.y)) * margin::kCertainlyFarther;
  const PieceBox around = grown({p.x, p.y, p.x, p.y}, reach);
  const auto is_near = [&](Index k) {
    if (std::find(own.begin(), own.end(), k) != own.end()) return false;
    const GridPoint a = corners_[k].at, b = corners_[corners_[k].next].at;
    return exact::is_nearer(g, point, {a.x, a.y, b.x, b.y}, radius_);
  };
  if (!boxes_ && ++asked_ <= kFewQuestions) {
    for (Index k = 0; k < corners_.size(); ++k)
      if (edge_meets(corners_[k].at, corners_[corners_[k].next].at, around) && is_near(k)) return true;
    return false;
  }
  prepare();
  return boxes_->any_meeting(around, is_near);
}

bool OffsetEdges::near(const Edge& e, Vector p) const {
  const Vector d = p - e.from;
  const Vector away = d - std::clamp(dot(d, e.way) * e.per_square, 0.0, 1.0) * e.way;
  return dot(away, away) < certain_ * certain_;
}

OffsetEdges::Vector OffsetEdges::middle(const Part& p, const Vector* center) const {
  const Vector m = 0.5 * (p.from + p.to);
  if (!center) return m;
  const Vector d = m - *center;
  return *center + (r_ / std::sqrt(dot(d, d))) * d;
}

OffsetEdges::Part OffsetEdges::part(Vector from, Vector to, const Vector* center) const {
  if (!center) return {from, to, to};
  // The tangents at the ends meet on the ray through the middle of the chord, at r^2 over its distance. More than a
  // quarter of a circle is halved first.
  const Vector d = 0.5 * (from + to) - *center;
  if (!(2 * dot(d, d) >= r_ * r_)) return {from, {exact::kInfinity, exact::kInfinity}, to};
  return {from, *center + (r_ * r_ / dot(d, d)) * d, to};
}

bool OffsetEdges::covered(const Part& p, const Vector* center, std::span<const Index> by, int halvings) const {
  for (Index k : by)
    if (near(edges_[k], p)) return true;
  if (halvings == 0) return false;
  const Vector m = middle(p, center);
  if (std::none_of(by.begin(), by.end(), [&](Index k) { return near(edges_[k], m); })) return false;
  return covered(part(p.from, m, center), center, by, halvings - 1) &&
         covered(part(m, p.to, center), center, by, halvings - 1);
}

bool OffsetEdges::covered(const Part& p, const Vector* center, Index k) const {
  if (!(certain_ > 0)) return false;
  std::array<Index, 2 * kBeside> beside;
  Index n = 0;
  for (Index i = 0, before = corners_[k].before, after = corners_[k].next; i < kBeside; ++i) {
    beside[n++] = before;
    beside[n++] = after;
    before = corners_[before].before;
    after = corners_[after].next;
  }
  if (covered(p, center, beside, kHalvings)) return true;
  PieceBox box{std::min({p.from.x, p.top.x, p.to.x}), std::min({p.from.y, p.top.y, p.to.y}),
               std::max({p.from.x, p.top.x, p.to.x}), std::max({p.from.y, p.top.y, p.to.y})};
  if (center) box = grown({center->x, center->y, center->x, center->y}, r_);
  std::vector<Index> near_by;
  boxes_->any_meeting(grown(box, r_), [&](Index e) {
    near_by.push_back(e);
    return false;
  });
  return covered(p, center, near_by, kHalvings);
}

bool OffsetEdges::covers_displaced(Index k) {
  prepare();
  const Edge& e = edges_[k];
  const Vector from = e.from + r_ * e.normal;
  return covered(part(from, from + e.way, nullptr), nullptr, k);
}

bool OffsetEdges::covers_arc(Index k) {
  prepare();
  const Edge &in = edges_[corners_[k].before], &out = edges_[k];
  return covered(part(out.from + r_ * in.normal, out.from + r_ * out.normal, &out.from), &out.from, k);
}

}  // namespace findspace::plane
