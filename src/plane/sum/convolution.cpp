// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/sum/convolution.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "plane/base/parallel.h"
#include "plane/base/reserve_more.h"
#include "plane/sum/convolution_walks.h"

namespace findspace::plane {

using exact::int128;
using exact::Real;
using exact::SupportingCurve;

namespace {

constexpr std::size_t kManyNodes = 1000;  // from here on ranges of them are worked on at once

Index add_position(exact::Geometry& g, const Position& p) {
  return p.grid() ? g.add_grid_point(p.x, p.y) : g.add_real_point(p.real->x, p.real->y);
}

}  // namespace

/// Gives the convolution of one path of a with one path of b its coordinates.
class PathPair {
 public:
  PathPair(ConvolutionBuilder& out, const Tracing& a, const Tracing& b, Index keys) : out_(out), nodes_(a, b, keys) {}

  void run() {
    out_.reserve(nodes_.nodes.size());
    for (const StillWalk& still : connect_nodes(nodes_)) {
      Position at = *nodes_.turn(0, still.at[0]).center + *nodes_.turn(1, still.at[1]).center;
      out_.circled.push_back({add_position(out_.curves.geometry, at), still.rounds});
    }
    add_supporting_curves();
    add_ends();
    add_pieces();
  }

 private:
  using Node = ConvolutionNodes::Node;
  using Kind = ConvolutionNodes::Kind;
  using Line = ConvolutionNodes::Line;
  using Turn = ConvolutionNodes::Turn;

  /// Those of all nodes; arcs that follow each other on one circle share it.
  void add_supporting_curves() {
    auto& nodes = nodes_.nodes;
    auto& curves = out_.curves.geometry.supporting_curves;
    std::size_t count = curves.size();
    for (Index k = 0; k < nodes.size(); ++k) {
      const bool shared = k > 0 && on_one_circle(nodes[k - 1], nodes[k]);
      nodes[k].supporting_curve = shared ? nodes[k - 1].supporting_curve : Index(count++);
    }
    curves.resize(count);
    const std::size_t ranges = range_count(nodes.size(), kManyNodes);
    std::vector<SharedReals> more(ranges - 1);
    each_range(ranges, [&](std::size_t r) {
      const IndexRange some = range(r, ranges, nodes.size());
      SharedReals& shared = r == 0 ? out_.shared_ : more[r - 1];
      for (std::size_t k = some.first; k < some.end; ++k) {
        const Node& n = nodes[k];
        if (k > 0 && nodes[k - 1].supporting_curve == n.supporting_curve) continue;
        curves[n.supporting_curve] =
            n.kind == Kind::kLine ? line(nodes_.line_of(n), nodes_.turn_of(n), shared) : circle(n, shared);
      }
    });
  }

  /// The points where nodes end; of ranges of them at once, each in a geometry of its own first.
  void add_ends() {
    auto& nodes = nodes_.nodes;
    auto& g = out_.curves.geometry;
    const std::size_t ranges = range_count(nodes.size(), kManyNodes);
    std::vector<exact::Geometry> more(ranges - 1);
    each_range(ranges, [&](std::size_t k) {
      const IndexRange some = range(k, ranges, nodes.size());
      exact::Geometry& to = k == 0 ? g : more[k - 1];
      for (std::size_t i = some.first; i < some.end; ++i) nodes[i].end = add_end(to, nodes[i], nodes[nodes[i].next]);
    });
    for (std::size_t k = 1; k < ranges; ++k) {
      const auto points = Index(g.points.size()), reals = Index(g.reals.size());
      for (exact::Point p : more[k - 1].points) {
        if (p.kind == exact::Point::Kind::kReal) p.i += reals;
        g.points.push_back(p);
      }
      std::move(more[k - 1].reals.begin(), more[k - 1].reals.end(), std::back_inserter(g.reals));
      const IndexRange some = range(k, ranges, nodes.size());
      for (std::size_t i = some.first; i < some.end; ++i) nodes[i].end += points;
    }
    for (const Node& n : nodes) nodes[n.next].start = n.end;
  }

  /// Of each node one, and the corner at its end.
  void add_pieces() {
    auto& nodes = nodes_.nodes;
    first_piece_ = out_.curves.pieces.size();
    first_corner_ = out_.corners.size();
    out_.curves.pieces.resize(first_piece_ + nodes.size());
    out_.curves.forward.resize(first_piece_ + nodes.size());
    out_.chains.resize(first_piece_ + nodes.size());
    out_.corners.resize(first_corner_ + nodes.size());
    in_ranges(nodes.size(), kManyNodes, [&](IndexRange some) {
      for (std::size_t k = some.first; k < some.end; ++k) set_piece(k);
    });
  }

  /// centre + radius * normal of a turn in the direction of a line.
  static Position place(const Turn& t, const Direction& d) {
    if (!t.arc) return *t.center;
    Position n = d.right_normal();
    Real r = t.radius();
    return Position::of(t.center->real_x() + r * n.real_x(), t.center->real_y() + r * n.real_y());
  }

  /// Where node n ends and m, the next one, starts.
  Index add_end(exact::Geometry& g, const Node& n, const Node& m) const {
    const auto touch = [&](const Node& p, const Node& q) {
      g.points.push_back(out_.curves.geometry.crossing(p.supporting_curve, q.supporting_curve, 0));
      return Index(g.points.size() - 1);
    };
    if (n.kind == Kind::kLine) {
      const Line& l = nodes_.line_of(n);
      const Turn& t = nodes_.turn_of(n);
      const Position &p = n.forward ? *l.to : *l.from, &q = *t.center;
      if (!t.arc && p.grid() && q.grid()) return g.add_grid_point(p.x + q.x, p.y + q.y);
      if (n.smooth_end && touch_obliquely(n, m)) return touch(n, m);
      return add_position(g, p + place(t, *l.direction));
    }
    if (n.smooth_end && touch_obliquely(m, n)) return touch(m, n);
    const Direction& d = nodes_.direction_at(n, n.key_out);
    return add_position(g, place(nodes_.turn(0, n.at[0]), d) + place(nodes_.turn(1, n.at[1]), d));
  }

  /// Smooth neighbours, a line and a circle: their common point needs no coordinates; but where the line is parallel to
  /// an axis these are simple.
  bool touch_obliquely(const Node& line, const Node& arc) const {
    if (line.kind != Kind::kLine || arc.kind != Kind::kArc) return false;
    const Direction& d = *nodes_.line_of(line).direction;
    return d.grid() && d.x != 0 && d.y != 0;
  }

  void set_piece(std::size_t k) {
    const Node& n = nodes_.nodes[k];
    std::int8_t half = 0;
    bool right;
    if (n.kind == Kind::kLine) {
      const Direction& d = *nodes_.line_of(n).direction;
      right = (d.x > 0 || (d.x == 0 && d.y > 0)) == n.forward;
    } else {
      const Turn &p = nodes_.turn(0, n.at[0]), &q = nodes_.turn(1, n.at[1]);
      half = std::int8_t((p.radius() + q.radius()).sign() * (p.arc ? p.normal_up() : q.normal_up()));
      right = (half < 0) == n.turns_left;
    }
    const std::size_t piece = first_piece_ + k;
    out_.curves.pieces[piece] = {.supporting_curve = n.supporting_curve,
                                 .p0 = right ? n.start : n.end,
                                 .p1 = right ? n.end : n.start,
                                 .half = half,
                                 .smooth0 = right ? n.smooth_start : n.smooth_end,
                                 .smooth1 = right ? n.smooth_end : n.smooth_start};
    out_.curves.forward[piece] = right;
    out_.chains[piece] = {.forward = right, .displaced_left = n.forward == out_.inward_};
    out_.corners[first_corner_ + k] = {Index(piece), Index(first_piece_ + n.next), n.rotation, n.extra};
  }

  /// Two arcs of one circle about one vertex, as far as that shows at once.
  bool on_one_circle(const Node& n, const Node& m) const {
    if (n.kind != Kind::kArc || m.kind != Kind::kArc || n.at[0] != m.at[0]) return false;
    const Turn &p = nodes_.turn(1, n.at[1]), &q = nodes_.turn(1, m.at[1]);
    if (!p.arc || !q.arc || p.sign != q.sign) return false;
    return p.center->grid() && q.center->grid() && p.center->x == q.center->x && p.center->y == q.center->y &&
           p.radius() == q.radius();
  }

  SupportingCurve circle(const Node& n, SharedReals& shared) const {
    const Turn &p = nodes_.turn(0, n.at[0]), &q = nodes_.turn(1, n.at[1]);
    Position c = *p.center + *q.center;
    Real r = abs(p.radius() + q.radius());
    return c.grid() ? SupportingCurve::circle_at(c.x, c.y, shared.of(r))
                    : SupportingCurve::circle_at(c.real->x, c.real->y, r);
  }

  static SupportingCurve line(const Line& l, const Turn& t, SharedReals& shared) {
    // Directions are primitive: the canonical normal needs no division.
    std::int64_t a = l.direction->y, b = -l.direction->x;
    bool flipped = a < 0 || (a == 0 && b < 0);
    if (flipped) {
      a = -a;
      b = -b;
    }
    const Position &p = *l.from, &q = *t.center;
    if (!t.arc && p.grid() && q.grid())
      return SupportingCurve::line(a, b, int128(a) * (p.x + q.x) + int128(b) * (p.y + q.y));
    // The place on an arc is the centre plus the radius times the unit normal, which is (a, b) / |(a, b)| or its
    // opposite.
    Real shift = flipped ? -t.radius() : t.radius();
    Position sum = p + q;
    if (sum.grid())
      return SupportingCurve::displaced_line(a, b, int128(a) * sum.x + int128(b) * sum.y, shared.of(shift));
    Real c = Real(a) * sum.real_x() + Real(b) * sum.real_y();
    if (t.arc) c += shift * sqrt(Real(int128(a) * a + int128(b) * b));
    return SupportingCurve::line(a, b, c);
  }

  ConvolutionBuilder& out_;
  ConvolutionNodes nodes_;
  std::size_t first_piece_ = 0, first_corner_ = 0;  // of its own
};

const exact::CurveReals& SharedReals::of(const Real& w) {
  auto& [last, before] = known_;
  const auto same = [&w](const exact::CurveReals& known) {
    return known.w().is_rational() && w.is_rational() && known.w() == w;
  };
  if (same(last)) return last;
  std::swap(last, before);
  if (!same(last)) last = w;
  return last;
}

void ConvolutionBuilder::reserve(std::size_t more) {
  reserve_more(curves.geometry.supporting_curves, more);
  reserve_more(curves.geometry.points, more);
  reserve_more(curves.pieces, more);
  reserve_more(curves.forward, more);
  reserve_more(chains, more);
  reserve_more(corners, more);
}

void ConvolutionBuilder::add(const Part& a, const Part& b) {
  std::vector<Tracing> p, q;
  p.reserve(a.paths.size());
  q.reserve(b.paths.size());
  for (const Path& path : a.paths) p.push_back(Tracing::from(path, a.flat));
  for (const Path& path : b.paths) q.push_back(Tracing::from(path, b.flat));
  Index keys = assign_keys(p, q);
  for (const Path& path : a.paths)
    for (const Path& other : b.paths)
      if (path.lonely && other.lonely) {
        Position at = *path.lonely + *other.lonely;
        points.push_back(add_position(curves.geometry, at));
      }
  for (const Tracing& x : p)
    for (const Tracing& y : q) PathPair(*this, x, y, keys).run();
}

}  // namespace findspace::plane
