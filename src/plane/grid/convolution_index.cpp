// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/convolution_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/planar/geometry_signs.h"
#include "plane/base/ray_crossing.h"

namespace findspace::plane {
namespace {

using exact::Geometry;

struct Size {
  std::int64_t width, height;
};

/// Of each ring.
std::vector<Size> ring_sizes(const GridFace& face) {
  std::vector<Size> out;
  GridPoint low{}, high{};
  for (Index k = 0; k < face.corners.size(); ++k) {
    const GridCorner& c = face.corners[k];
    if (c.before >= k) low = high = c.at;  // the first of its ring
    low = {std::min(low.x, c.at.x), std::min(low.y, c.at.y)};
    high = {std::max(high.x, c.at.x), std::max(high.y, c.at.y)};
    if (c.next <= k) out.push_back({high.x - low.x, high.y - low.y});
  }
  return out;
}

/// Could `other` go round a hole of the face?
bool can_enclose(const GridFace& face, const GridFace& other) {
  std::vector<Size> rings = ring_sizes(face);
  if (rings.size() == std::size_t(!face.unbounded)) return false;
  if (other.unbounded) return true;
  Size size = ring_sizes(other)[0];
  return std::any_of(rings.begin() + !face.unbounded, rings.end(),
                     [&](const Size& r) { return r.width <= size.width && r.height <= size.height; });
}

std::int32_t euler(const GridFace& bounded) { return 2 - std::int32_t(ring_sizes(bounded).size()); }

bool before(GridPoint p, GridPoint q) { return p.x != q.x ? p.x < q.x : p.y < q.y; }

Heading heading(const GridCorner& edge) { return {edge.dx, edge.dy}; }

/// Compares with a point that is added to the geometry for that alone.
template <class Compare>
int compare_grid(Geometry& g, GridPoint p, Compare&& compare) {
  int sign = compare(g.add_grid_point(p.x, p.y));
  g.points.pop_back();
  return sign;
}

}  // namespace

ConvolutionIndex::Side::Side(const GridFace& face)
    : fan(face, std::pmr::new_delete_resource()), slabs(face), place(face.corners.size()) {
  for (Index k = 0; k < fan.rays.size(); ++k) place[fan.rays[k].corner] = k;
  for (Index k = 0; k < face.corners.size(); ++k) by_place.push_back({face.corners[k].at, k});
  std::sort(by_place.begin(), by_place.end(), [](const auto& p, const auto& q) {
    return before(p.first, q.first) || (!before(q.first, p.first) && p.second < q.second);
  });
}

void ConvolutionIndex::Side::find_sweeps() {
  for (Index v = 0; v < fan.corners.size(); ++v) sweep.push_back(fan.sweep(v));
}

ConvolutionIndex::ConvolutionIndex(const GridOperand& a, const GridOperand& b) : a_(a), b_(b) {
  for (const GridFace& p : a.faces)
    for (const GridFace& q : b.faces) {
      std::int32_t base = p.unbounded ? euler(q) : q.unbounded ? euler(p) : 0;
      Pair& pair = pairs_.emplace_back(Pair{{Side(p), Side(q)}, base, can_enclose(p, q) || can_enclose(q, p)});
      EdgeFan::place(pair.side[0].fan, pair.side[1].fan);
      for (Side& s : pair.side) s.find_sweeps();
    }
}

bool ConvolutionIndex::may_be_unresolved() const {
  return std::any_of(pairs_.begin(), pairs_.end(), [](const Pair& p) { return p.may_enclose; });
}

std::size_t ConvolutionIndex::convex_count() const {
  std::size_t count = 0;
  for (const Pair& pair : pairs_)
    for (int s : {0, 1}) {
      const Side &moved = pair.side[std::size_t(s)], &other = pair.side[std::size_t(1 - s)];
      for (Index v = 0; v < other.fan.corners.size(); ++v) {
        if (other.fan.corners[v].turn <= 0) continue;
        const EdgeFan::Sweep& sweep = other.sweep[v];
        count += sweep.size(moved.place.size());
      }
    }
  return count;
}

bool ConvolutionIndex::holds(Geometry& g, Index point, bool& unresolved) const {
  for (Index k = 0; k < pairs_.size(); ++k) {
    if (number(g, point, k) != 0) return true;
    unresolved |= pairs_[k].may_enclose;
  }
  return false;
}

std::int32_t ConvolutionIndex::number(Geometry& g, Index point, Index pair) const {
  const exact::Point q = g.points[point];
  const Range ray{q.x - q.error, q.y - q.error, std::numeric_limits<double>::infinity(), q.y + q.error};
  std::int32_t number = pairs_[pair].base;
  auto any = [](const GridCorner&) { return true; };
  for (int s : {0, 1})
    visit_side(pair, s, ray, any, [&](const Curve& c) {
      number += past_curve(g, point, c);
      return true;
    });
  return number + past_corners(g, point, pairs_[pair]);
}

/// Sign of the point's side of the line of a curve: +1 to the left of the edge's direction.
int ConvolutionIndex::side_of(Geometry& g, Index point, const Curve& c) const {
  const GridCorner& e = edge(c);
  const GridPoint p = from(c);
  const exact::Point& q = g.points[point];
  double dx = double(e.dx), dy = double(e.dy), x = q.x - double(p.x), y = q.y - double(p.y);
  double cross = dx * y - dy * x, tolerance = (std::abs(dx * y) + std::abs(dy * x)) * exact::Approx::kUnit * 8 +
                                              q.error * (std::abs(dx) + std::abs(dy)) * 2;
  if (std::abs(cross) > tolerance) return cross > 0 ? 1 : -1;
  std::uint32_t line = g.add_parallel(operand(c.side).geometry.supporting_curves[e.supporting_curve], p.x, p.y);
  const exact::SupportingCurve& k = g.supporting_curves[line];
  bool to_left = k.a == -e.dy && k.b == e.dx;
  int side = exact::side(g, point, line);
  g.supporting_curves.pop_back();
  return to_left ? side : -side;
}

/// What the ray from the point to the right, tilted up by an infinitesimal, crosses: a curve at a convex corner travels
/// as its edge does, one at a reflex corner against it; both are displaced to the left of the edge.
std::int32_t ConvolutionIndex::past_curve(Geometry& g, Index point, const Curve& c) const {
  const GridCorner &e = edge(c), &v = corner(c);
  const GridPoint p = from(c), q = to(c);
  const double y = g.points[point].y, tolerance = 2 * g.points[point].error;
  auto above = [&](GridPoint end) {
    double gap = double(end.y) - y;
    if (std::abs(gap) > tolerance) return gap > 0 ? 1 : -1;
    return compare_grid(g, end, [&](Index i) { return compare_y(g, i, point); });
  };
  int first = above(p), last = above(q);
  if (first * last > 0) return 0;
  bool ahead = double(std::min(p.x, q.x)) > g.points[point].x + tolerance;
  int side = first != last && ahead ? (first < last ? 1 : -1) : side_of(g, point, c);
  if (side == 0) {
    // On the line: at an end (its corner counts), beside the curve (level ones only), or on it.
    auto behind = [&](GridPoint end) { return compare_grid(g, end, [&](Index i) { return compare_xy(g, i, point); }); };
    return behind(p) * behind(q) >= 0 ? 0 : v.turn * -ray_crossing(heading(e), -heading(e), 1);
  }
  if (first == last || std::max(first, last) <= 0) return 0;  // level, or wholly at or below
  bool upwards = first < last;
  return upwards == (side > 0) ? (upwards ? v.turn : -v.turn) : 0;
}

/// Corners of the two paths that meet at the point.
std::int32_t ConvolutionIndex::past_corners(Geometry& g, Index point, const Pair& pair) const {
  const exact::Point q = g.points[point];
  const GridPoint at{std::llround(q.x), std::llround(q.y)};
  if (std::abs(q.x - double(at.x)) > q.error || std::abs(q.y - double(at.y)) > q.error) return 0;
  if (compare_grid(g, at, [&](Index i) { return compare_xy(g, i, point); }) != 0) return 0;
  std::int32_t number = 0;
  const std::size_t few = pair.side[0].place.size() < pair.side[1].place.size() ? 0 : 1;
  const auto& places = pair.side[1 - few].by_place;
  for (Index v = 0; v < pair.side[few].fan.corners.size(); ++v) {
    const GridPoint other = pair.side[few].fan.corners[v].at, wanted{at.x - other.x, at.y - other.y};
    auto k = std::lower_bound(places.begin(), places.end(), wanted,
                              [](const auto& p, GridPoint w) { return before(p.first, w); });
    for (; k != places.end() && k->first.x == wanted.x && k->first.y == wanted.y; ++k)
      number += past_corner(pair, few == 0 ? std::array{v, k->second} : std::array{k->second, v});
  }
  return number;
}

/// The paths that arrive at a pair of corners, each with the curve on which it goes on: where the first of the two
/// rotates, swept from the direction of arrival, ends.
std::int32_t ConvolutionIndex::past_corner(const Pair& pair, const std::array<Index, 2>& corners) {
  auto corner = [&](int s) -> const GridCorner& {
    return pair.side[std::size_t(s)].fan.corners[corners[std::size_t(s)]];
  };
  const Index count = Index(pair.side[0].place.size() + pair.side[1].place.size());
  // The place of an edge among those of both sets.
  auto key = [&](int s, Index edge) {
    const Side& side = pair.side[std::size_t(s)];
    return side.place[edge] + side.fan.rank[edge];
  };
  // From a direction to the end of a turn, counter-clockwise if `left`.
  auto tolerance = [&](int s, Index from, bool left) {
    const GridCorner& c = corner(s);
    if (c.turn == 0) return Index(0);
    Index in = key(s, c.before), out = key(s, corners[std::size_t(s)]);
    Index end = (c.turn > 0) == left ? out : in;
    return left ? (end + count - from) % count : (from + count - end) % count;
  };
  std::int32_t number = 0;
  for (int s : {0, 1}) {
    const GridCorner &mine = corner(s), &other = corner(1 - s);
    if (other.turn == 0) continue;
    const bool forward = other.turn > 0;
    const Index line = forward ? mine.before : corners[std::size_t(s)];
    const Side &side = pair.side[std::size_t(s)], &fixed = pair.side[std::size_t(1 - s)];
    if (!fixed.sweep[corners[std::size_t(1 - s)]].holds(side.place[line])) continue;
    const Index from = key(s, line);
    const bool left = (mine.turn >= 0) == forward;
    const Index rooms[2] = {tolerance(0, from, left), tolerance(1, from, left)};
    const int next = rooms[0] < rooms[1] ? 0 : 1;
    const GridCorner& turned = corner(next);
    const bool goes_on = (turned.turn >= 0) == left;
    const Side& leaves = pair.side[std::size_t(next)];
    const GridCorner& edge_out = leaves.fan.corners[goes_on ? corners[std::size_t(next)] : turned.before];
    const bool forward_out = corner(1 - next).turn > 0;
    const Heading in = forward ? heading(side.fan.corners[line]) : -heading(side.fan.corners[line]);
    const Heading out = forward_out ? heading(edge_out) : -heading(edge_out);
    const int turn = rooms[next] == 0 ? 0 : left ? 1 : -1;
    number += ray_crossing(-in, out, forward == forward_out ? (forward ? -1 : 1) : turn);
  }
  return number;
}

}  // namespace findspace::plane
