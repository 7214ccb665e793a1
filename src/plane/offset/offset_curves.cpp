// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/offset/offset_curves.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "exact/planar/offset_points.h"
#include "plane/complex/piece_meet.h"

namespace findspace::plane {
namespace {

using exact::int128;
using exact::Real;
using exact::SupportingCurve;

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
/// Whether the normal of its line points to the right of the way: it does for (-b, a), to the left for (b, -a).
bool normal_right(const GridCorner& c, const SupportingCurve& l) { return c.dx == -l.b && c.dy == l.a; }
bool is_level(const GridCorner& c) { return c.dx == 0 || c.dy == 0; }

class Builder {
 public:
  Builder(std::span<const GridCorner> corners, const exact::Geometry& source, const Real& radius, OffsetEdges& edges)
      : corners_(corners),
        source_(source),
        radius_(radius),
        opposite_(-radius),
        outwards_(radius),
        inwards_(opposite_),
        approx_(exact::approx(radius)),
        g_(out_.geometry) {
    const std::size_t n = corners.size();
    const bool covering = covering_pays(corners, radius.to_double());
    line_.assign(n, kNone);
    circle_.assign(n, kNone);
    from_.assign(n, kNone);
    to_.assign(n, kNone);
    arc_from_.assign(n, kNone);
    arc_to_.assign(n, kNone);
    const auto turns_left = [](const GridCorner& c) { return c.turn > 0; };
    const std::size_t arcs = std::size_t(std::count_if(corners.begin(), corners.end(), turns_left));
    capacity_ = n + arcs + n / 8 + 4;  // a few arcs are cut in two, a few edges get loose ends
    g_.supporting_curves.reserve(capacity_);
    g_.points.reserve(capacity_ + n / 8);
    for (Index k = 0; k < n; ++k) {
      if (corners[k].turn > 0 && !(covering && edges.covers_arc(k)))
        circle_[k] = g_.add(SupportingCurve::circle_at(corners[k].at.x, corners[k].at.y, outwards_));
      if (!(covering && edges.covers_displaced(k))) line_[k] = add_line(corners[k]);
    }
  }

  OffsetCurves run() {
    const Index n = Index(corners_.size());
    for (Index k = 0; k < n; ++k) add_ends(k);
    for (Index k = 0; k < n; ++k)
      if (line_[k] != kNone && is_cut(k) && !runs_forward(k)) {
        undo_crossing(k);
        undo_crossing(corners_[k].next);
      }
    out_.pieces.reserve(capacity_);
    out_.origins.reserve(capacity_);
    for (Index k = 0; k < n; ++k) {
      if (circle_[k] != kNone) add_arc(k);
      if (line_[k] != kNone) add_piece(line_[k], from_[k], to_[k], 0, points_right(corners_[k]), false, k);
    }
    link();
    return std::move(out_);
  }

 private:
  Index add_line(const GridCorner& c) {
    const SupportingCurve& l = source_.supporting_curves[c.supporting_curve];
    return g_.add_displaced(l, normal_right(c, l) ? outwards_ : inwards_);
  }

  /// The displaced line of an edge, as it lies to its corners.
  exact::ShiftedLine shifted(Index line, Index edge) const {
    return {line, normal_right(corners_[edge], g_.supporting_curves[line]) ? approx_ : -approx_};
  }

  /// The corner, r to the right of a way parallel to an axis.
  Index beside(GridPoint at, const GridCorner& way) {
    const int x = (way.dy > 0) - (way.dy < 0), y = (way.dx < 0) - (way.dx > 0);
    return g_.add_real_point(Real(at.x) + Real(x) * radius_, Real(at.y) + Real(y) * radius_);
  }

  /// Where a displaced edge, which may be left out, and the arc about corner k touch.
  Index touching_point(Index k, Index edge) {
    const GridPoint at = corners_[k].at;
    if (is_level(corners_[edge])) return beside(at, corners_[edge]);
    const Index line = line_[edge] != kNone ? line_[edge] : add_line(corners_[edge]);
    return exact::add_shifted_touch(g_, shifted(line, edge), circle_[k], at.x, at.y);
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
    return g_.add_crossing(line_[edge], g_.add_line(a, b, int128(a) * at.x + int128(b) * at.y), 0);
  }

  /// The ends beside corner k of the displaced edges before and after it.
  void add_ends(Index k) {
    const Index before = corners_[k].before;
    if (corners_[k].turn > 0 && circle_[k] != kNone) {
      arc_from_[k] = touching_point(k, before);
      arc_to_[k] = touching_point(k, k);
      if (line_[before] != kNone) to_[before] = arc_from_[k];
      if (line_[k] != kNone) from_[k] = arc_to_[k];
    } else if (corners_[k].turn < 0 && line_[before] != kNone && line_[k] != kNone) {
      const GridPoint at = corners_[k].at;
      to_[before] = from_[k] =
          exact::add_shifted_crossing(g_, shifted(line_[before], before), shifted(line_[k], k), at.x, at.y);
    } else {
      if (line_[before] != kNone) to_[before] = loose_end(k, before);
      if (line_[k] != kNone) from_[k] = loose_end(k, k);
    }
  }

  bool is_cut(Index k) const { return corners_[k].turn < 0 || corners_[corners_[k].next].turn < 0; }

  bool runs_forward(Index k) const {
    const Piece along{.supporting_curve = line_[k]};
    const int order = compare_along(g_, along, from_[k], to_[k]);
    return points_right(corners_[k]) ? order < 0 : order > 0;
  }

  /// Gives the edges at a reflex corner their whole length.
  void undo_crossing(Index k) {
    const Index before = corners_[k].before;
    if (corners_[k].turn > 0 || line_[before] == kNone || line_[k] == kNone || to_[before] != from_[k]) return;
    to_[before] = loose_end(k, before);
    from_[k] = loose_end(k, k);
  }

  /// An arc is less than half a circle, so it passes at most one of the points with a vertical tangent.
  void add_arc(Index k) {
    const GridCorner &in = corners_[corners_[k].before], &out = corners_[k];
    const bool passes_right = in.dx > 0 && out.dx < 0, passes_left = in.dx < 0 && out.dx > 0;
    if (!passes_right && !passes_left) {
      const bool upper = in.dx != 0 ? in.dx < 0 : out.dx < 0;
      return add_piece(circle_[k], arc_from_[k], arc_to_[k], upper ? 1 : -1, !upper, true, k);
    }
    const Index extreme = g_.add_real_point(Real(out.at.x) + (passes_right ? radius_ : opposite_), Real(out.at.y));
    add_piece(circle_[k], arc_from_[k], extreme, passes_right ? -1 : 1, passes_right, true, k);
    add_piece(circle_[k], extreme, arc_to_[k], passes_right ? 1 : -1, !passes_right, true, k);
  }

  void add_piece(Index supporting_curve, Index from, Index to, int half, bool right, bool arc, Index corner) {
    out_.pieces.push_back({.supporting_curve = supporting_curve,
                           .p0 = right ? from : to,
                           .p1 = right ? to : from,
                           .half = std::int8_t(half)});
    out_.origins.push_back({.right = right, .arc = arc, .corner = corner});
  }

  void link() {
    std::vector<Index> starts_at(g_.points.size(), kNone);
    for (Index i = 0; i < out_.pieces.size(); ++i) starts_at[out_.start(i)] = i;
    for (Index i = 0; i < out_.pieces.size(); ++i) out_.origins[i].next = starts_at[out_.end(i)];
  }

  std::span<const GridCorner> corners_;
  const exact::Geometry& source_;
  const Real& radius_;
  Real opposite_;
  exact::CurveReals outwards_, inwards_;  // these two, shared by the curves
  exact::Approx approx_;                  // of the radius
  OffsetCurves out_;
  exact::Geometry& g_;
  std::size_t capacity_ = 0;
  std::vector<Index> line_, circle_;      // of the displaced edge and of the arc of a corner; kNone: left out
  std::vector<Index> from_, to_;          // ends of the displaced edges
  std::vector<Index> arc_from_, arc_to_;  // ends of the arcs
};

}  // namespace

OffsetCurves offset_curves(std::span<const GridCorner> corners, const exact::Geometry& geometry, const Real& radius,
                           OffsetEdges& edges) {
  return Builder(corners, geometry, radius, edges).run();
}

}  // namespace findspace::plane
