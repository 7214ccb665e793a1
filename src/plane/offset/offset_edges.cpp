// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/offset/offset_edges.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "exact/margins/plane.h"
#include "plane/base/release.h"

namespace findspace::plane {
namespace {

/// How often a curve is halved to find every part near one edge.
constexpr int kHalvings = 5;
/// Up to so many questions all edges are looked through; then the tree of boxes is made.
constexpr int kFewQuestions = 8;
/// Edges before and after its own that are tried first.
constexpr Index kBeside = 4;
/// Of a ring with up to so many corners, all curves are near to the same edges.
constexpr Index kShortRing = 8;

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

/// Two numbers below 2^16, their bits in turn.
std::uint32_t interleaved(std::uint32_t x, std::uint32_t y) {
  const auto spread = [](std::uint32_t v) {
    v = (v | v << 8) & 0x00ff00ffu;
    v = (v | v << 4) & 0x0f0f0f0fu;
    v = (v | v << 2) & 0x33333333u;
    return (v | v << 1) & 0x55555555u;
  };
  return spread(x) | spread(y) << 1;
}

/// Faces by number, in the order of their first corners along a Z-curve; few stay as they are.
std::vector<Index> near_order(const GridFaces& faces) {
  constexpr std::size_t kFew = 8;
  std::vector<Index> order(faces.size());
  std::iota(order.begin(), order.end(), Index(0));
  if (faces.size() <= kFew) return order;
  PieceBox all{exact::kInfinity, exact::kInfinity, -exact::kInfinity, -exact::kInfinity};
  const auto at = [&](Index k) {
    const GridPoint p = faces[k].corners.empty() ? GridPoint{0, 0} : faces[k].corners[0].at;
    return PieceBox{double(p.x), double(p.y), double(p.x), double(p.y)};
  };
  for (const Index k : order) all = joined(all, at(k));
  constexpr double kCells = 65535;
  const double columns = kCells / std::max(1.0, all.x1 - all.x0), rows = kCells / std::max(1.0, all.y1 - all.y0);
  std::vector<std::uint32_t> place(faces.size());
  for (const Index k : order) {
    const PieceBox p = at(k);
    place[k] = interleaved(std::uint32_t((p.x0 - all.x0) * columns), std::uint32_t((p.y0 - all.y0) * rows));
  }
  std::stable_sort(order.begin(), order.end(), [&](Index k, Index l) { return place[k] < place[l]; });
  return order;
}

PieceBox grown(const PieceBox& b, double by) { return {b.x0 - by, b.y0 - by, b.x1 + by, b.y1 + by}; }

}  // namespace

GridCorners all_corners(GridFaces faces) {
  GridCorners all;
  if (faces.size() == 1) all = std::move(faces[0].corners);
  if (faces.size() < 2) return all;
  std::size_t count = 0;
  for (const GridFace& f : faces) count += f.corners.size();
  all.reserve(count);
  for (const Index k : near_order(faces)) {
    const Index base = Index(all.size());
    for (GridCorner c : faces[k].corners) {
      c.next += base;
      c.before += base;
      all.push_back(c);
    }
    release(faces[k].corners);
  }
  return all;
}

OffsetEdges::OffsetEdges(std::span<const GridCorner> corners, const exact::Real& radius)
    : corners_(corners), radius_(radius), r_(radius.to_double()) {}

void OffsetEdges::prepare_boxes() {
  if (!boxes_) boxes_.emplace(boxes_of(corners_));
}

void OffsetEdges::prepare() {
  if (!edges_.empty()) return;
  prepare_boxes();
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

void OffsetEdges::end_covering() {
  release(edges_);
  release(near_);
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
  prepare_boxes();
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

bool OffsetEdges::covered(const Part& p, const Vector* center, std::span<const Index> by) const {
  const auto any_near = [&](Vector v) {
    return std::any_of(by.begin(), by.end(), [&](Index k) { return near(edges_[k], v); });
  };
  return any_near(p.from) && any_near(p.to) && covered(p, center, by, kHalvings);
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

/// Of one that starts with corner k; else one corner is taken.
Index OffsetEdges::end_of_short_ring(Index k) const {
  Index end = k + 1;
  while (corners_[end - 1].next == end && end - k < kShortRing) ++end;
  return corners_[end - 1].next == k ? end : k + 1;
}

void OffsetEdges::find_near(Index k) {
  if (near_first_ <= k && k < near_end_) return;
  near_first_ = k;
  near_end_ = end_of_short_ring(k);
  PieceBox box = edge_box(corners_, corners_[k]);
  for (Index i = k + 1; i < near_end_; ++i) box = joined(box, edge_box(corners_, corners_[i]));
  near_.clear();
  boxes_->any_meeting(grown(box, 2 * r_), [&](Index e) {
    near_.push_back(e);
    return false;
  });
}

bool OffsetEdges::covered(const Part& p, const Vector* center, Index k) {
  if (!(certain_ > 0)) return false;
  std::array<Index, 2 * kBeside> beside;
  Index n = 0;
  for (Index i = 0, before = corners_[k].before, after = corners_[k].next; i < kBeside; ++i) {
    beside[n++] = before;
    beside[n++] = after;
    before = corners_[before].before;
    after = corners_[after].next;
  }
  if (!in_short_ring(k) && covered(p, center, beside)) return true;
  find_near(k);
  const PieceBox reach = grown({std::min({p.from.x, p.top.x, p.to.x}), std::min({p.from.y, p.top.y, p.to.y}),
                                std::max({p.from.x, p.top.x, p.to.x}), std::max({p.from.y, p.top.y, p.to.y})},
                               r_);
  nearest_.clear();
  for (const Index e : near_)
    if (edge_box(corners_, corners_[e]).meets(reach)) nearest_.push_back(e);
  return covered(p, center, nearest_);
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
