// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/offset/offset_curves.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "exact/planar/offset_points.h"

namespace findspace::plane {
namespace {

using exact::int128;
using exact::Real;

/// Crossings of randomly placed curves (Buffon), a curve: from there on it pays to look for covered ones.
constexpr double kManyCrossings = 0.5;

/// Whether so many crossings are to be expected: squared total length over pi times the area.
bool covering_pays(std::span<const GridCorner> corners, double r) {
  double x0 = 1e300, y0 = 1e300, x1 = -1e300, y1 = -1e300, length = 0;
  for (const GridCorner& c : corners) {
    const GridPoint q = corners[c.next].at;
    const double x = double(c.at.x), y = double(c.at.y);
    const double dx = double(q.x) - x, dy = double(q.y) - y;
    length += std::sqrt(dx * dx + dy * dy);
    x0 = std::min(x0, x);
    y0 = std::min(y0, y);
    x1 = std::max(x1, x);
    y1 = std::max(y1, y);
  }
  const double area = (x1 - x0 + 2 * r) * (y1 - y0 + 2 * r);
  return length * length > kManyCrossings * 3.14 * area * double(corners.size());
}

bool points_right(const GridCorner& c) { return c.dx > 0 || (c.dx == 0 && c.dy > 0); }
/// Whether the canonical normal of its line points to the right of the way: then that goes up, or level to the left.
bool normal_right(const GridCorner& c) { return c.dy > 0 || (c.dy == 0 && c.dx < 0); }
/// Of what turns less than half round, from the directions at its ends.
std::int8_t rises(std::int64_t dy_at_start, std::int64_t dy_at_end) {
  if (dy_at_start >= 0 && dy_at_end >= 0) return 1;
  return dy_at_start <= 0 && dy_at_end <= 0 ? -1 : 0;
}
bool is_level(const GridCorner& c) { return c.dx == 0 || c.dy == 0; }

class Builder {
 public:
  Builder(std::span<const GridCorner> corners, const exact::Geometry& source, const Real& radius, OffsetEdges& edges)
      : corners_(corners), source_(source), radius_(radius), outwards_(radius), inwards_(-radius), g_(out_.geometry) {
    const std::size_t n = corners.size();
    const bool covering = covering_pays(corners, radius.to_double());
    const auto turns_left = [](const GridCorner& c) { return c.turn > 0; };
    const std::size_t arcs = std::size_t(std::count_if(corners.begin(), corners.end(), turns_left));
    capacity_ = n + arcs + n / 8 + 4;  // a few arcs are cut in two, a few edges get loose ends
    g_.supporting_curves.reserve(capacity_);
    g_.points.reserve(capacity_ + n / 8);
    made_.reserve(n);
    for (Index k = 0; k < n; ++k) {
      const GridCorner& c = corners[k];
      Made& made = made_.emplace_back();
      if (c.turn > 0 && !(covering && edges.covers_arc(k)))
        made.circle = exact::add_circle(g_, c.at.x, c.at.y, outwards_);
      if (!(covering && edges.covers_displaced(k))) made.line = add_line(c);
    }
    edges.end_covering();
    if (!radius.integer()) g_.reals.reserve(level_touches());
  }

  OffsetCurves run() {
    const Index n = Index(corners_.size());
    for (Index k = 0; k < n; ++k) add_ends(k);
    for (Index k = 0; k < n; ++k)
      if (made_[k].line != kNone && is_cut(k) && !runs_forward(k)) {
        undo_crossing(k);
        undo_crossing(corners_[k].next);
      }
    out_.pieces.reserve(capacity_);
    out_.origins.reserve(capacity_);
    for (Index k = 0, first = 0; k < n; ++k) {
      if (made_[k].circle != kNone) add_arc(k);
      if (made_[k].line != kNone) add_edge(k);
      if (corners_[k].next == k + 1) continue;
      close_ring(first);
      first = Index(out_.pieces.size());
    }
    return std::move(out_);
  }

 private:
  /// What is made of a corner and of the edge that leaves it; kNone: left out.
  struct Made {
    Index line = kNone, from = kNone, to = kNone;  // the displaced edge and its ends
    Index circle = kNone, arc_from = kNone, arc_to = kNone;
  };

  const exact::Displacement& shift(const GridCorner& edge) const { return normal_right(edge) ? outwards_ : inwards_; }

  /// Where arcs touch level or upright edges.
  std::size_t level_touches() const {
    std::size_t count = 0;
    for (Index k = 0; k < corners_.size(); ++k)
      if (made_[k].circle != kNone) count += is_level(corners_[k]) + is_level(corners_[corners_[k].before]);
    return count;
  }

  Index add_line(const GridCorner& c) {
    return exact::add_displaced(g_, source_.supporting_curves[c.supporting_curve], shift(c));
  }

  /// The displaced line of an edge, as it lies to its corners.
  exact::ShiftedLine shifted(Index line, Index edge) const { return {line, shift(corners_[edge])}; }

  /// The corner, r to the right of a way parallel to an axis.
  Index beside(GridPoint at, const GridCorner& way) {
    const int x = (way.dy > 0) - (way.dy < 0), y = (way.dx < 0) - (way.dx > 0);
    return g_.add_real_point(moved(at.x, x), moved(at.y, y));
  }
  Real moved(std::int64_t from, int way) const {
    return way == 0 ? Real(from) : Real(from) + (way > 0 ? radius_ : inwards_.reals.w());
  }

  /// Where a displaced edge, which may be left out, and the arc about corner k touch.
  Index touching_point(Index k, Index edge) {
    const GridPoint at = corners_[k].at;
    if (is_level(corners_[edge])) return beside(at, corners_[edge]);
    const Index line = made_[edge].line != kNone ? made_[edge].line : add_line(corners_[edge]);
    return exact::add_shifted_touch(g_, shifted(line, edge), made_[k].circle, at.x, at.y);
  }

  /// The end of a displaced edge beside corner k, without an arc there.
  Index loose_end(Index k, Index edge) {
    const GridCorner& c = corners_[edge];
    const GridPoint at = corners_[k].at;
    if (is_level(c)) return beside(at, c);
    std::int64_t a = c.dx, b = c.dy;
    if (a < 0) {
      a = -a;
      b = -b;
    }
    return g_.add_crossing(made_[edge].line, g_.add_line(a, b, int128(a) * at.x + int128(b) * at.y), 0);
  }

  /// The ends beside corner k of the displaced edges before and after it.
  void add_ends(Index k) {
    const Index before = corners_[k].before;
    Made &in = made_[before], &out = made_[k];
    if (out.circle != kNone) {
      out.arc_from = touching_point(k, before);
      out.arc_to = touching_point(k, k);
      if (in.line != kNone) in.to = out.arc_from;
      if (out.line != kNone) out.from = out.arc_to;
    } else if (corners_[k].turn < 0 && in.line != kNone && out.line != kNone) {
      const GridPoint at = corners_[k].at;
      in.to = out.from = exact::add_shifted_crossing(g_, shifted(in.line, before), shifted(out.line, k), at.x, at.y);
    } else {
      if (in.line != kNone) in.to = loose_end(k, before);
      if (out.line != kNone) out.from = loose_end(k, k);
    }
  }

  bool is_cut(Index k) const { return corners_[k].turn < 0 || corners_[corners_[k].next].turn < 0; }

  /// Along the longer axis, where the filter decides more often.
  bool runs_forward(Index k) const {
    const GridCorner& c = corners_[k];
    const Made& made = made_[k];
    if (std::abs(c.dy) <= std::abs(c.dx))
      return c.dx > 0 ? compare_x(g_, made.from, made.to) < 0 : compare_x(g_, made.from, made.to) > 0;
    return c.dy > 0 ? compare_y(g_, made.from, made.to) < 0 : compare_y(g_, made.from, made.to) > 0;
  }

  /// Gives the edges at a reflex corner their whole length.
  void undo_crossing(Index k) {
    const Index before = corners_[k].before;
    Made &in = made_[before], &out = made_[k];
    if (corners_[k].turn > 0 || in.line == kNone || out.line == kNone || in.to != out.from) return;
    in.to = loose_end(k, before);
    out.from = loose_end(k, k);
  }

  void add_edge(Index k) {
    const GridCorner& c = corners_[k];
    const bool right = points_right(c);
    add_piece(made_[k].line, made_[k].from, made_[k].to, 0,
              {.right = right, .arc = false, .rises = rises(c.dy, c.dy), .corner = k});
  }

  /// An arc is less than half a circle, so it passes at most one of the points with a vertical tangent.
  void add_arc(Index k) {
    const GridCorner &in = corners_[corners_[k].before], &out = corners_[k];
    const Made& made = made_[k];
    const bool passes_right = in.dx > 0 && out.dx < 0, passes_left = in.dx < 0 && out.dx > 0;
    if (!passes_right && !passes_left) {
      const bool upper = in.dx != 0 ? in.dx < 0 : out.dx < 0;
      return add_piece(made.circle, made.arc_from, made.arc_to, upper ? 1 : -1,
                       {.right = !upper, .arc = true, .rises = rises(in.dy, out.dy), .corner = k});
    }
    const Index extreme =
        g_.add_real_point(Real(out.at.x) + (passes_right ? radius_ : inwards_.reals.w()), Real(out.at.y));
    const int there = passes_right ? 1 : -1;  // it goes up, or down
    add_piece(made.circle, made.arc_from, extreme, -there,
              {.right = passes_right, .arc = true, .rises = rises(in.dy, there), .corner = k});
    add_piece(made.circle, extreme, made.arc_to, there,
              {.right = !passes_right, .arc = true, .rises = rises(there, out.dy), .corner = k});
  }

  void add_piece(Index supporting_curve, Index from, Index to, int half, const OffsetOrigin& origin) {
    if (from == last_end_) out_.origins.back().next = Index(out_.pieces.size());
    last_end_ = to;
    Piece& p = out_.pieces.emplace_back();
    p.supporting_curve = supporting_curve;
    p.p0 = origin.right ? from : to;
    p.p1 = origin.right ? to : from;
    p.half = std::int8_t(half);
    OffsetOrigin& o = out_.origins.emplace_back();  // not copied: that would wait for what was just written
    o.right = origin.right;
    o.arc = origin.arc;
    o.rises = origin.rises;
    o.corner = origin.corner;
  }

  /// The pieces from `first` on are those of one ring.
  void close_ring(Index first) {
    if (first < out_.pieces.size() && out_.start(first) == last_end_) out_.origins.back().next = first;
    last_end_ = kNone;
  }

  std::span<const GridCorner> corners_;
  const exact::Geometry& source_;
  const Real& radius_;
  exact::Displacement outwards_, inwards_;  // by the radius to the right of a normal, and to its left
  OffsetCurves out_;
  exact::Geometry& g_;
  std::size_t capacity_ = 0;
  std::vector<Made> made_;
  Index last_end_ = kNone;  // of the piece before, of the same ring
};

}  // namespace

OffsetCurves offset_curves(std::span<const GridCorner> corners, const exact::Geometry& geometry, const Real& radius,
                           OffsetEdges& edges) {
  return Builder(corners, geometry, radius, edges).run();
}

}  // namespace findspace::plane
