// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/convolution_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/margins/plane.h"
#include "exact/planar/geometry_signs.h"
#include "plane/base/ray_crossing.h"

namespace findspace::plane {
namespace {

using exact::Geometry;

/// Of corners that are kept ring by ring.
bool one_ring(const GridFace& face) { return face.corners.back().next == 0; }

bool has_holes(const GridFace& face) { return face.unbounded ? !face.corners.empty() : !one_ring(face); }

bool is_box(const GridFace& face) {
  return face.corners.size() == 4 && std::all_of(face.corners.begin(), face.corners.end(), [](const GridCorner& c) {
           return c.turn > 0 && (c.dx == 0 || c.dy == 0);
         });
}

constexpr std::size_t kEntriesPerFace = 2;
constexpr std::size_t kManyPairs = 10'000;  // of corners, from which on corners are tried before curves are counted
constexpr std::size_t kCornerStep = 7;      // of them one of so many is tried; teeth repeat by even numbers

/// Does a point, off by `error` at most, lie inside the face? False where doubles do not tell.
bool lies_inside(const GridFace& face, const BoxSlabs& slabs, double x, double y, double error) {
  bool odd = false;  // edges that a ray to the right crosses
  const bool sure = slabs.visit(y - error, y + error, [&](const BoxSlabs::Entry& e) {
    if (e.x1 < x - error) return true;
    if (e.y0 >= y - error || e.y1 <= y + error) return false;
    if (e.x0 <= x + error) {
      const GridPoint p = face.corners[e.item].at, q = face.corners[face.corners[e.item].next].at;
      const double dx = double(q.x - p.x), dy = double(q.y - p.y);
      const double cross = dx * (y - double(p.y)) - dy * (x - double(p.x));
      if (std::abs(cross) <= error * (std::abs(dx) + std::abs(dy))) return false;
      if ((cross > 0) != (dy > 0)) return true;  // to the left of the point
    }
    odd = !odd;
    return true;
  });
  return sure && odd != face.unbounded;
}

std::vector<BoxSlabs::Entry> bounded_boxes(const GridFaces& faces) {
  std::vector<BoxSlabs::Entry> out;
  for (Index k = 0; k < faces.size(); ++k) {
    if (faces[k].unbounded) continue;
    const GridBox box = box_of({&faces[k], 1});
    out.push_back({double(box.x0), double(box.x1), double(box.y0), double(box.y1), k});
  }
  return out;
}

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
    : fan(face, kHeap), slabs(edge_slabs(face)), place(face.corners.size()) {
  for (Index k = 0; k < fan.rays.size(); ++k) place[fan.rays[k].corner] = k;
  for (Index k = 0; k < face.corners.size(); ++k) by_place.push_back({face.corners[k].at, k});
  std::sort(by_place.begin(), by_place.end(), [](const auto& p, const auto& q) {
    return before(p.first, q.first) || (!before(q.first, p.first) && p.second < q.second);
  });
}

ConvolutionIndex::ConvolutionIndex(const GridOperand& a, const GridOperand& b)
    : a_(a),
      b_(b),
      pairs_(a.faces.size() * b.faces.size()),
      boxes_(bounded_boxes((a.faces.size() > b.faces.size() ? a : b).faces), kEntriesPerFace) {
  sides_[0].resize(a.faces.size());
  sides_[1].resize(b.faces.size());
  const bool more_in_a = a.faces.size() > b.faces.size();
  const GridFaces &many = (more_in_a ? a : b).faces, &others = (more_in_a ? b : a).faces;
  for (Index i = 0; i < many.size(); ++i)
    if (many[i].unbounded) unbounded_.push_back(i);
  for (const GridFace& f : others) others_.push_back(box_of({&f, 1}));
}

const ConvolutionIndex::Pair& ConvolutionIndex::made(Index k) const {
  const std::lock_guard lock(guard_);
  if (const Pair* known = pairs_[k].load(std::memory_order_relaxed)) return *known;
  const Index others = Index(b_.faces.size());
  const std::array<Index, 2> face{k / others, k % others};
  std::array<Side*, 2> side;
  for (std::size_t s : {0, 1}) {
    std::unique_ptr<Side>& kept = sides_[s][face[s]];
    if (!kept) kept = std::make_unique<Side>(face_of(k, int(s)));
    side[s] = kept.get();
  }
  EdgeFan::place(side[0]->fan, side[1]->fan);
  Pair& pair = made_.emplace_back();
  for (std::size_t s : {0, 1}) {
    const EdgeFan& fan = side[s]->fan;
    pair.side[s] = side[s];
    pair.rank[s].assign(fan.rank.begin(), fan.rank.end());
    pair.sweep[s].reserve(fan.corners.size());
    for (Index v = 0; v < fan.corners.size(); ++v) pair.sweep[s].push_back(fan.sweep(v));
  }
  pairs_[k].store(&pair, std::memory_order_release);
  return pair;
}

ConvolutionIndex::Rings::Rings(const GridFace& face) {
  GridPoint low{}, high{};
  for (Index k = 0; k < face.corners.size(); ++k) {
    const GridCorner& c = face.corners[k];
    if (c.before >= k) low = high = c.at;  // the first of its ring
    low = {std::min(low.x, c.at.x), std::min(low.y, c.at.y)};
    high = {std::max(high.x, c.at.x), std::max(high.y, c.at.y)};
    if (c.next > k) continue;
    const Size size{high.x - low.x, high.y - low.y};
    if (count++ == 0 && !face.unbounded)
      outer = size;
    else
      holes.push_back(size);
  }
  std::sort(holes.begin(), holes.end(), [](const Size& p, const Size& q) { return p.width < q.width; });
  for (std::size_t k = 1; k < holes.size(); ++k) holes[k].height = std::min(holes[k].height, holes[k - 1].height);
}

/// One at least is no larger.
bool ConvolutionIndex::Rings::any_hole_in(const Size& size) const {
  const auto wider = std::upper_bound(holes.begin(), holes.end(), size.width,
                                      [](std::int64_t width, const Size& hole) { return width < hole.width; });
  return wider != holes.begin() && (wider - 1)->height <= size.height;
}

const ConvolutionIndex::Rings& ConvolutionIndex::rings(Index pair, int s) const {
  const auto& all = rings_[std::size_t(s)].of([&] {
    std::vector<Rings> out;
    for (const GridFace& face : operand(s).faces) out.emplace_back(face);
    return out;
  });
  return all[face_number(pair, s)];
}

bool ConvolutionIndex::may_enclose(Index pair) const {
  // Could the other one go round a hole of this one?
  const auto can_enclose = [&](int s) {
    if (!has_holes(face_of(pair, s))) return false;
    return face_of(pair, 1 - s).unbounded || rings(pair, s).any_hole_in(rings(pair, 1 - s).outer);
  };
  return can_enclose(0) || can_enclose(1);
}

std::int32_t ConvolutionIndex::base(Index pair) const {
  const auto euler = [&](int s) { return one_ring(face_of(pair, s)) ? 1 : 2 - rings(pair, s).count; };
  return face_of(pair, 0).unbounded ? euler(1) : face_of(pair, 1).unbounded ? euler(0) : 0;
}

std::vector<Index> ConvolutionIndex::pairs_meeting(const Range& r) const {
  const std::size_t many = a_.faces.size() > b_.faces.size() ? 0 : 1;
  std::vector<Index> out;
  const auto add = [&](Index of_many, Index of_few) {
    out.push_back(many == 0 ? of_many * Index(b_.faces.size()) + of_few : of_few * Index(b_.faces.size()) + of_many);
  };
  const GridFaces &faces = operand(int(many)).faces, &others = operand(1 - int(many)).faces;
  for (Index k = 0; k < others.size(); ++k) {
    if (others[k].unbounded) {
      for (Index i = 0; i < faces.size(); ++i) add(i, k);
      continue;
    }
    const GridBox& box = others_[k];
    boxes_.visit(r.y0 - double(box.y1), r.y1 - double(box.y0), [&](const BoxSlabs::Entry& e) {
      if (e.x1 >= r.x0 - double(box.x1) && e.x0 <= r.x1 - double(box.x0)) add(e.item, k);
      return true;
    });
    for (Index i : unbounded_) add(i, k);
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::optional<std::vector<Index>> ConvolutionIndex::corners_near(const Side& other, const Side& moved, const Range& r) {
  constexpr std::size_t kManyCorners = 256, kFewerBy = 8;
  const std::size_t all = other.fan.corners.size();
  if (all < kManyCorners) return std::nullopt;
  // A step more than the heights, which are rounded by much less.
  const double low = r.y0 - moved.slabs.top() - 1, high = r.y1 - moved.slabs.bottom() + 1;
  if (other.slabs.count(low, high) * kFewerBy > all) return std::nullopt;
  std::vector<Index> out;
  other.slabs.visit(low, high, [&](const BoxSlabs::Entry& e) {
    out.push_back(e.item);
    return true;
  });
  std::sort(out.begin(), out.end());
  return out;
}

bool ConvolutionIndex::may_be_unresolved() const {
  const auto any_holes = [](const GridOperand& o) { return std::any_of(o.faces.begin(), o.faces.end(), has_holes); };
  if (!any_holes(a_) && !any_holes(b_)) return false;
  for (Index p = 0; p < pair_count(); ++p)
    if (may_enclose(p)) return true;
  return false;
}

std::size_t ConvolutionIndex::convex_count() const {
  const auto convex = [](const GridOperand& o) {
    std::vector<char> out;
    for (const GridFace& f : o.faces) out.push_back(f.is_convex());
    return out;
  };
  const std::vector<char> convex_a = convex(a_), convex_b = convex(b_);
  std::size_t count = 0;
  for (Index p = 0; p < pair_count(); ++p) {
    if (convex_a[p / convex_b.size()] && convex_b[p % convex_b.size()]) {  // each edge is swept once
      count += face_of(p, 0).corners.size() + face_of(p, 1).corners.size();
      continue;
    }
    for (int s : {0, 1}) {
      const Side &moved = of(p, s), &other = of(p, 1 - s);
      for (Index v = 0; v < other.fan.corners.size(); ++v)
        if (other.fan.corners[v].turn > 0) count += sweep(p, 1 - s, v).size(moved.place.size());
    }
  }
  return count;
}

bool ConvolutionIndex::holds(Geometry& g, Index point, bool& unresolved) const {
  const exact::Point q = g.points[point];
  for (Index k : pairs_meeting({q.x - q.error, q.y - q.error, q.x + q.error, q.y + q.error})) {
    const std::optional<bool> in_box = holds_as_box(g, point, k);
    if (in_box.value_or(false)) return true;
    if (in_box) continue;
    if (holds_by_a_corner(q, k) || number(g, point, k) != 0) return true;
    unresolved |= may_enclose(k);
  }
  return false;
}

std::optional<bool> ConvolutionIndex::holds_as_box(Geometry& g, Index point, Index pair) const {
  if (!is_box(face_of(pair, 0)) || !is_box(face_of(pair, 1))) return std::nullopt;
  const GridBox a = box_of({&face_of(pair, 0), 1}), b = box_of({&face_of(pair, 1), 1});
  const GridPoint low{a.x0 + b.x0, a.y0 + b.y0}, high{a.x1 + b.x1, a.y1 + b.y1};
  const exact::Point q = g.points[point];
  const double e = q.error;
  if (q.x - e > double(low.x) && q.x + e < double(high.x) && q.y - e > double(low.y) && q.y + e < double(high.y))
    return true;
  const auto beyond = [&](GridPoint corner, int way) {
    return compare_grid(g, corner, [&](Index i) {
             return way * compare_x(g, point, i) > 0 && way * compare_y(g, point, i) > 0 ? 1 : 0;
           }) != 0;
  };
  return beyond(low, 1) && beyond(high, -1);
}

bool ConvolutionIndex::holds_by_a_corner(const exact::Point& q, Index pair) const {
  if (face_of(pair, 0).corners.size() * face_of(pair, 1).corners.size() < kManyPairs) return false;
  for (int s : {0, 1}) {
    const GridCorners& corners = face_of(pair, 1 - s).corners;
    std::optional<std::vector<Index>> near;
    if (!face_of(pair, s).unbounded) near = corners_near(of(pair, 1 - s), of(pair, s), {q.x, q.y, q.x, q.y});
    const std::size_t count = near ? near->size() : corners.size();
    for (std::size_t i = 0; i < count; i += near ? 1 : kCornerStep) {
      const std::size_t v = near ? (*near)[i] : i;
      if (v % kCornerStep != 0) continue;
      const double x = q.x - double(corners[v].at.x), y = q.y - double(corners[v].at.y);
      if (lies_inside(face_of(pair, s), of(pair, s).slabs, x, y, q.error + margin::kInsideFace)) return true;
    }
  }
  return false;
}

std::int32_t ConvolutionIndex::number(Geometry& g, Index point, Index pair) const {
  const exact::Point q = g.points[point];
  const Range ray{q.x - q.error, q.y - q.error, std::numeric_limits<double>::infinity(), q.y + q.error};
  std::int32_t number = base(pair);
  auto any = [](const GridCorner&) { return true; };
  for (int s : {0, 1})
    visit_side(pair, s, ray, any, [&](const Curve& c) {
      number += past_curve(g, point, c);
      return true;
    });
  return number + past_corners(g, point, pair);
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
std::int32_t ConvolutionIndex::past_corners(Geometry& g, Index point, Index pair) const {
  const exact::Point q = g.points[point];
  const GridPoint at{std::llround(q.x), std::llround(q.y)};
  if (std::abs(q.x - double(at.x)) > q.error || std::abs(q.y - double(at.y)) > q.error) return 0;
  if (compare_grid(g, at, [&](Index i) { return compare_xy(g, i, point); }) != 0) return 0;
  std::int32_t number = 0;
  const Side &a = of(pair, 0), &b = of(pair, 1);
  const auto& places = a.by_place;
  for (Index v = 0; v < b.fan.corners.size(); ++v) {
    const GridPoint other = b.fan.corners[v].at, wanted{at.x - other.x, at.y - other.y};
    auto k = std::lower_bound(places.begin(), places.end(), wanted,
                              [](const auto& p, GridPoint w) { return before(p.first, w); });
    for (; k != places.end() && k->first.x == wanted.x && k->first.y == wanted.y; ++k)
      number += past_corner(pair, {k->second, v});
  }
  return number;
}

/// The paths that arrive at a pair of corners, each with the curve on which it goes on: where the first of the two
/// turns, swept from the direction of arrival, ends.
std::int32_t ConvolutionIndex::past_corner(Index pair, const std::array<Index, 2>& corners) const {
  auto corner = [&](int s) -> const GridCorner& { return of(pair, s).fan.corners[corners[std::size_t(s)]]; };
  const Index count = Index(of(pair, 0).place.size() + of(pair, 1).place.size());
  // The place of an edge among those of both sets.
  auto key = [&](int s, Index edge) { return of(pair, s).place[edge] + rank(pair, s, edge); };
  // From a direction to the end of a turn, counter-clockwise if `left`.
  auto to_end = [&](int s, Index from, bool left) {
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
    const Side& side = of(pair, s);
    if (!sweep(pair, 1 - s, corners[std::size_t(1 - s)]).holds(side.place[line])) continue;
    const Index from = key(s, line);
    const bool left = (mine.turn >= 0) == forward;
    const Index ends[2] = {to_end(0, from, left), to_end(1, from, left)};
    const int next = ends[0] < ends[1] ? 0 : 1;
    const GridCorner& turning = corner(next);
    const bool goes_on = (turning.turn >= 0) == left;
    const Side& leaves = of(pair, next);
    const GridCorner& edge_out = leaves.fan.corners[goes_on ? corners[std::size_t(next)] : turning.before];
    const bool forward_out = corner(1 - next).turn > 0;
    const Heading in = forward ? heading(side.fan.corners[line]) : -heading(side.fan.corners[line]);
    const Heading out = forward_out ? heading(edge_out) : -heading(edge_out);
    const int turn = ends[next] == 0 ? 0 : left ? 1 : -1;
    number += ray_crossing(-in, out, forward == forward_out ? (forward ? -1 : 1) : turn);
  }
  return number;
}

}  // namespace findspace::plane
