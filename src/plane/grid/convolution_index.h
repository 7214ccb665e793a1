// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The convolution (convolution.h) of two sets of grid polygons, n by m curves, not made but found: which of its curves
// reach into a box, and its displaced winding number at a point, which is the Euler characteristic of the intersection
// of a face of A and one of B reflected and moved there. Curves are an edge of one set with a corner of the other whose
// turn sweeps the edge's direction. Guarantee: exact for every point. Cost: O((n + m) log(n + m)) to prepare one face
// with one, and memory of O(n + m), when they are asked about first; a question looks at the pairs of faces whose boxes
// it meets, and there, for every corner of one (of many those in a strip alone), at the other's edges in a strip;
// microseconds for small shapes, 0.3 ms for 1000 corners each. Threads: safe once made.
// Keywords: convolution cycles, range query, point in Minkowski sum.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "plane/base/lazy.h"
#include "plane/grid/box_slabs.h"
#include "plane/grid/edge_fan.h"
#include "plane/grid/reduced_convolution.h"

namespace findspace::plane {

/// A closed box; its bounds need not be integers.
struct Range {
  double x0, y0, x1, y1;
};

class ConvolutionIndex {
 public:
  /// Keeps references to both.
  ConvolutionIndex(const GridOperand& a, const GridOperand& b);

  struct Curve {
    Index pair;
    int side;            // whose edge: 0 of A, 1 of B
    Index edge, corner;  // the corner that the edge leaves; the corner of the other set by which it is moved
  };

  const GridOperand& operand(int side) const { return side == 0 ? a_ : b_; }
  const GridCorner& edge(const Curve& c) const { return of(c.pair, c.side).fan.corners[c.edge]; }
  const GridCorner& corner(const Curve& c) const { return of(c.pair, 1 - c.side).fan.corners[c.corner]; }
  GridPoint from(const Curve& c) const { return sum(edge(c).at, corner(c).at); }
  GridPoint to(const Curve& c) const { return sum(of(c.pair, c.side).fan.corners[edge(c).next].at, corner(c).at); }

  /// Could an intersection be a ring, so that numbers alone do not decide?
  bool may_be_unresolved() const;
  /// How many curves arise at convex corners.
  std::size_t convex_count() const;

  /// Calls visit(curve) for the curves at convex corners whose boxes meet the range, while it returns true.
  template <class Visit>
  bool visit_convex(const Range& range, Visit&& visit) const {
    for (Index p : pairs_meeting(range))
      for (int s : {0, 1})
        if (!visit_side(
                p, s, range, [](const GridCorner& c) { return c.turn > 0; }, visit))
          return false;
    return true;
  }

  /// Whether the point lies in the open sum; `unresolved` is set where an intersection could be a ring, whose number is
  /// 0.
  bool holds(exact::Geometry& g, Index point, bool& unresolved) const;

 private:
  /// A face by itself.
  struct Side {
    EdgeFan fan;
    BoxSlabs slabs;
    std::vector<Index> place;                           // corner -> of its edge among the rays
    std::vector<std::pair<GridPoint, Index>> by_place;  // corners, for those at a point

    explicit Side(const GridFace& face);
  };
  struct Size {
    std::int64_t width, height;
  };
  /// Of a face: how large the boxes of its rings are.
  struct Rings {
    std::int32_t count = 0;
    Size outer{};             // where it is bounded
    std::vector<Size> holes;  // by width, each with the least height of those up to it

    explicit Rings(const GridFace& face);
    bool any_hole_in(const Size& size) const;
  };
  /// A face with one of the other set: rank and sweep of its corners.
  struct Pair {
    std::array<const Side*, 2> side;
    std::array<std::vector<Index>, 2> rank;
    std::array<std::vector<EdgeFan::Sweep>, 2> sweep;
  };

  /// Of two boxes, whose sum is one: whether the point lies inside; nothing for other faces.
  std::optional<bool> holds_as_box(exact::Geometry& g, Index point, Index pair) const;
  /// Pairs count by face of A, then of B.
  Index pair_count() const { return Index(pairs_.size()); }
  Index face_number(Index pair, int s) const {
    const Index others = Index(b_.faces.size());
    return s == 0 ? pair / others : pair % others;
  }
  const GridFace& face_of(Index pair, int s) const { return operand(s).faces[face_number(pair, s)]; }
  const Pair& pair(Index k) const {
    const Pair* known = pairs_[k].load(std::memory_order_acquire);
    return known ? *known : made(k);
  }
  const Pair& made(Index k) const;
  const Rings& rings(Index pair, int s) const;
  /// One face could go round a hole of the other.
  bool may_enclose(Index pair) const;
  /// The number far away.
  std::int32_t base(Index pair) const;

  const Side& of(Index k, int s) const { return *pair(k).side[std::size_t(s)]; }
  const EdgeFan::Sweep& sweep(Index k, int s, Index corner) const { return pair(k).sweep[std::size_t(s)][corner]; }
  Index rank(Index k, int s, Index corner) const { return pair(k).rank[std::size_t(s)][corner]; }
  /// Those whose sums can reach into the range, or around it, ascending.
  std::vector<Index> pairs_meeting(const Range& range) const;

  static GridPoint sum(GridPoint p, GridPoint q) { return {p.x + q.x, p.y + q.y}; }

  /// Visits the wanted curves of the edges of one face that reach into the range: for every corner of the other face
  /// the edges that it sweeps, or those in the strip of the range, whichever are fewer.
  template <class Wanted, class Visit>
  bool visit_side(Index p, int s, const Range& r, Wanted&& wanted, Visit&& visit) const {
    const Side &moved = of(p, s), &other = of(p, 1 - s);
    const std::vector<EdgeFan::Sweep>& sweeps = pair(p).sweep[std::size_t(1 - s)];
    const std::size_t all = moved.place.size();
    const std::optional<std::vector<Index>> near = corners_near(other, moved, r);
    const Index corners = Index(near ? near->size() : other.fan.corners.size());
    for (Index i = 0; i < corners; ++i) {
      const Index v = near ? (*near)[i] : i;
      const GridCorner& c = other.fan.corners[v];
      if (c.turn == 0 || !wanted(c)) continue;
      const EdgeFan::Sweep& swept = sweeps[v];
      const double dx = double(c.at.x), dy = double(c.at.y);
      const Range strip{r.x0 - dx, r.y0 - dy, r.x1 - dx, r.y1 - dy};
      const std::size_t count = swept.size(all);
      bool on = true;
      if (count < moved.slabs.count(strip.y0, strip.y1)) {
        for (std::size_t k = 0; on && k < count; ++k) {
          const Index edge = moved.fan.rays[(swept.first + k) % all].corner;
          if (reaches(moved.fan, edge, strip)) on = bool(visit(Curve{p, s, edge, v}));
        }
      } else {
        on = moved.slabs.visit(strip.y0, strip.y1, [&](const BoxSlabs::Entry& e) {
          if (e.x1 < strip.x0 || e.x0 > strip.x1 || !swept.holds(moved.place[e.item])) return true;
          return bool(visit(Curve{p, s, e.item, v}));
        });
      }
      if (!on) return false;
    }
    return true;
  }
  /// Of many corners those, ascending, by which an edge of `moved` can reach into the heights of the range; nothing
  /// where these are not clearly fewer than all.
  static std::optional<std::vector<Index>> corners_near(const Side& other, const Side& moved, const Range& r);
  /// Whether the box of an edge meets the range.
  static bool reaches(const EdgeFan& fan, Index edge, const Range& r) {
    const GridPoint p = fan.corners[edge].at, q = fan.corners[fan.corners[edge].next].at;
    return double(std::max(p.x, q.x)) >= r.x0 && double(std::min(p.x, q.x)) <= r.x1 &&
           double(std::max(p.y, q.y)) >= r.y0 && double(std::min(p.y, q.y)) <= r.y1;
  }

  /// Whether a corner of one face, of some that are tried, shows that the point lies in the open sum: moved back by it
  /// the point lies inside the other face. By doubles that are certain; most points inside large sums are found so.
  bool holds_by_a_corner(const exact::Point& q, Index pair) const;
  std::int32_t number(exact::Geometry& g, Index point, Index pair) const;
  std::int32_t past_curve(exact::Geometry& g, Index point, const Curve& c) const;
  std::int32_t past_corners(exact::Geometry& g, Index point, Index pair) const;
  std::int32_t past_corner(Index pair, const std::array<Index, 2>& corners) const;
  int side_of(exact::Geometry& g, Index point, const Curve& c) const;

  GridOperand a_, b_;
  mutable std::mutex guard_;                                         // of what is made when it is asked for:
  mutable std::array<std::vector<std::unique_ptr<Side>>, 2> sides_;  // by face
  mutable std::deque<Pair> made_;
  mutable std::vector<std::atomic<const Pair*>> pairs_;
  std::array<Lazy<std::vector<Rings>>, 2> rings_;
  BoxSlabs boxes_;                // of the faces of the set that has more
  std::vector<GridBox> others_;   // those of the other set
  std::vector<Index> unbounded_;  // which of these are
};

}  // namespace findspace::plane
