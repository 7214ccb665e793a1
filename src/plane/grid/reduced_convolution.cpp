// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/reduced_convolution.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "exact/planar/parallel_line.h"
#include "plane/base/append_made.h"
#include "plane/base/parallel.h"
#include "plane/base/reserve_more.h"
#include "plane/grid/edge_fan.h"
#include "plane/grid/prune_inside.h"

namespace findspace::plane {
namespace {

constexpr std::size_t kFewToChoose = 2000;   // curves of a pair, from which on it may pay to leave some out
constexpr std::size_t kManyCurves = 20'000;  // from here on, also by a look at each
constexpr std::size_t kSample = 256;         // of them, looked at first: three quarters must be covered
// A look at a curve costs what the mask of prune_inside.h does for some crossings of its. Where more are estimated, the
// mask costs more, but it also cuts away parts of curves. Nearly coinciding curves cross far more than is estimated.
constexpr double kMostCrossings = 8;
constexpr std::size_t kPointsOfCut = 7;   // about, in the end, where many curves are cut and cross: for each
constexpr std::size_t kManyLooks = 8000;  // curves: from here on ranges of corners are looked at at once

struct Extent {
  double width, height;
};

Extent extent(const EdgeFan& fan) {
  double x0 = INFINITY, y0 = INFINITY, x1 = -INFINITY, y1 = -INFINITY;
  for (const GridCorner& c : fan.corners) {
    x0 = std::min(x0, double(c.at.x));
    x1 = std::max(x1, double(c.at.x));
    y0 = std::min(y0, double(c.at.y));
    y1 = std::max(y1, double(c.at.y));
  }
  return {x1 - x0, y1 - y0};
}

/// Sums of two corners, each a point once. A table of all pairs where that is small, else an open-addressing one.
class CornerSums {
 public:
  CornerSums(std::size_t most, const EdgeFan& a, const EdgeFan& b, Memory memory)
      : columns_(b.corners.size()), all_(memory), slots_(memory) {
    const std::size_t slots = std::bit_ceil(2 * most + 2), pairs = a.corners.size() * columns_;
    if (pairs <= kSlotsOfAll * slots)
      all_.resize(pairs, kNone);
    else
      slots_.resize(slots);
  }

  /// The point of a sum; kNone until it is set.
  Index& of(Index i, Index j) { return all_.empty() ? slot(i, j) : all_[i * columns_ + j]; }

 private:
  static constexpr std::size_t kSlotsOfAll = 8;  // so many pairs a slot take about the time of the other table

  struct Slot {
    std::uint64_t key = 0;
    Index point = kNone;
  };

  Index& slot(Index i, Index j) {
    const std::uint64_t key = (std::uint64_t(i) << 32 | j) + 1, mask = slots_.size() - 1;
    std::uint64_t at = (key * 0x9e3779b97f4a7c15u) >> 32 & mask;
    while (slots_[at].key != 0 && slots_[at].key != key) at = (at + 1) & mask;
    slots_[at].key = key;
    return slots_[at].point;
  }

  std::size_t columns_;
  ArenaVector<Index> all_;
  ArenaVector<Slot> slots_;
};

/// The operands, and which of their curves are made.
struct Choice {
  const GridOperand& a;
  const GridOperand& b;
  const std::optional<GridBox>& within;
  CoveredCurves* covered;

  bool one_pair() const { return a.faces.size() == 1 && b.faces.size() == 1; }
};

class FacePair {
 public:
  FacePair(ReducedConvolution& out, EdgeFan& a, EdgeFan& b, const Choice& choice, Memory memory)
      : out_(out), a_(a), b_(b), choice_(choice), within_(choice.within), sums_(place_and_count(), a, b, memory) {}

  void add() {
    add_edges<false>(b_, choice_.b.geometry, a_);
    add_edges<true>(a_, choice_.a.geometry, b_);
  }

 private:
  /// The edges of `moved` whose directions the convex corners of `fan` sweep.
  template <class Visit>
  static void each(const EdgeFan& moved, const EdgeFan& fan, Visit&& visit) {
    each(moved, fan, {0, fan.corners.size()}, visit);
  }
  template <class Visit>
  static void each(const EdgeFan& moved, const EdgeFan& fan, IndexRange corners, Visit&& visit) {
    const Index n = Index(moved.rays.size());
    for (Index v = Index(corners.first); v < corners.end; ++v) {
      if (fan.corners[v].turn <= 0) continue;
      const EdgeFan::Sweep s = fan.sweep(v);
      Index k = s.first;
      for (std::size_t left = s.size(n); left > 0; --left, ++k) {
        if (k == n) k = 0;
        visit(moved.rays[k].corner, v);
      }
    }
  }

  bool reaches(const EdgeFan& moved, Index e, const EdgeFan& fan, Index v) const {
    if (!within_) return true;
    const GridPoint by = fan.corners[v].at, p = moved.corners[e].at, q = moved.corners[moved.corners[e].next].at;
    return std::max(p.x, q.x) + by.x >= within_->x0 && std::min(p.x, q.x) + by.x <= within_->x1 &&
           std::max(p.y, q.y) + by.y >= within_->y0 && std::min(p.y, q.y) + by.y <= within_->y1;
  }

  std::size_t count_edges(const EdgeFan& moved, const EdgeFan& fan) const {
    std::size_t count = 0;
    if (within_) each(moved, fan, [&](Index e, Index v) { count += reaches(moved, e, fan, v); });
    for (Index v = 0; !within_ && v < fan.corners.size(); ++v)
      if (fan.corners[v].turn > 0) count += fan.sweep(v).size(moved.rays.size());
    return count;
  }

  struct MovedEdge {
    Index edge, corner;
  };

  static LatticeEdge segment(const EdgeFan& moved, const EdgeFan& fan, const MovedEdge& curve) {
    const GridCorner& c = moved.corners[curve.edge];
    const GridPoint by = fan.corners[curve.corner].at, p = c.at, q = moved.corners[c.next].at;
    return {double(p.x + by.x), double(p.y + by.y), double(q.x + by.x), double(q.y + by.y)};
  }

  bool is_covered(const EdgeFan& moved, const EdgeFan& fan, const MovedEdge& curve) const {
    const LatticeEdge s = segment(moved, fan, curve);
    return choice_.covered->covers(
        {std::min(s.x0, s.x1), std::min(s.y0, s.y1), std::max(s.x0, s.x1), std::max(s.y0, s.y1)});
  }

  /// Every so many of the curves.
  static std::vector<MovedEdge> sample(const EdgeFan& moved, const EdgeFan& fan, std::size_t step) {
    std::vector<MovedEdge> taken;
    std::size_t left = 1;
    each(moved, fan, [&](Index e, Index v) {
      if (--left > 0) return;
      left = step;
      taken.push_back({e, v});
    });
    return taken;
  }

  static double length(const EdgeFan& moved, const EdgeFan& fan, std::span<const MovedEdge> curves) {
    double sum = 0;
    for (const MovedEdge& c : curves) {
      const LatticeEdge s = segment(moved, fan, c);
      sum += std::hypot(s.x1 - s.x0, s.y1 - s.y0);
    }
    return sum;
  }

  /// Where it pays, the curves of which it is not known that they lie inside the sum. By a sample spread over them.
  void choose(std::size_t count) {
    if (!choice_.covered || count < kFewToChoose) return;
    const std::size_t step = count / kSample;
    const std::vector<MovedEdge> p = sample(b_, a_, step), q = sample(a_, b_, step);
    const Extent x = extent(a_), y = extent(b_);
    const CurveExtent all{count, (length(b_, a_, p) + length(a_, b_, q)) * double(step), x.width + y.width,
                          x.height + y.height};
    if (count >= kManyCurves && estimated_crossings(all) <= kMostCrossings * double(count) && mostly_covered(p, q)) {
      chosen_ = true;
      keep(b_, a_, 0, [&](const MovedEdge& c) { return !is_covered(b_, a_, c); });
      keep(a_, b_, 1, [&](const MovedEdge& c) { return !is_covered(a_, b_, c); });
    } else if (choice_.one_pair() && pruning_pays(all)) {
      chosen_ = true;
      const InnerMask& mask = out_.mask.emplace(mask_for(all, choice_.a, choice_.b));
      keep_at_once(b_, a_, 0, mask, count);
      keep_at_once(a_, b_, 1, mask, count);
    }
  }

  /// One that is not covered costs many looks.
  bool mostly_covered(const std::vector<MovedEdge>& p, const std::vector<MovedEdge>& q) const {
    const auto covered = std::count_if(p.begin(), p.end(), [&](const MovedEdge& c) { return is_covered(b_, a_, c); }) +
                         std::count_if(q.begin(), q.end(), [&](const MovedEdge& c) { return is_covered(a_, b_, c); });
    return 4 * std::size_t(covered) >= 3 * (p.size() + q.size());
  }

  template <class Test>
  void keep(const EdgeFan& moved, const EdgeFan& fan, int side, Test&& test) {
    each(moved, fan, [&](Index e, Index v) {
      if (test(MovedEdge{e, v})) kept_[side].push_back({e, v});
    });
  }

  /// Those that the mask does not hold; ranges of corners at once. `count`: of the curves of both sides.
  void keep_at_once(const EdgeFan& moved, const EdgeFan& fan, int side, const InnerMask& mask, std::size_t count) {
    const std::size_t ranges = range_count(count, kManyLooks);
    std::vector<std::vector<MovedEdge>> kept(ranges);
    const auto test = [&](std::size_t k) {
      each(moved, fan, range(k, ranges, fan.corners.size()), [&](Index e, Index v) {
        if (!lies_in(mask, segment(moved, fan, {e, v}))) kept[k].push_back({e, v});
      });
    };
    if (ranges == 1)
      test(0);
    else
      parallel_for(ranges, test);
    for (const auto& some : kept) kept_[side].insert(kept_[side].end(), some.begin(), some.end());
  }

  std::size_t place_and_count() {
    EdgeFan::place(a_, b_);
    std::size_t count = count_edges(b_, a_) + count_edges(a_, b_);
    choose(count);
    if (chosen_) count = kept_[0].size() + kept_[1].size();
    make_room(count);
    return count;
  }

  /// Makes the pieces, which are then set one by one, and reserves the rest.
  void make_room(std::size_t count) {
    auto& g = out_.geometry;
    // Many ends are shared. Curves that will be cut have points there, and meet: to make room then copies all of them.
    reserve_more(g.supporting_curves, out_.mask ? count + count / 8 : count);
    reserve_more(g.points, out_.mask ? kPointsOfCut * count : count + count / 4);
    reserve_more(out_.pieces, count);
    reserve_more(out_.sides, count);
    piece_ = Index(out_.pieces.size());
    out_.pieces.resize(piece_ + count);
    out_.sides.resize(piece_ + count);
  }

  /// `kMovedFirst`: the edges are those of A. Small sums spend much here, so little in the loops is left to be called.
  template <bool kMovedFirst>
  void add_edges(const EdgeFan& moved, const exact::Geometry& geometry, const EdgeFan& fan) {
    auto& points = out_.geometry.points;
    const GridCorner *const edges = moved.corners.data(), *const corners = fan.corners.data();
    Piece* piece = out_.pieces.data() + piece_;
    InnerSide* side = out_.sides.data() + piece_;
    Index point_count = Index(points.size());
    const auto point = [&](Index e, Index v, std::int64_t x, std::int64_t y) __attribute__((always_inline)) {
      Index& at = kMovedFirst ? sums_.of(e, v) : sums_.of(v, e);
      if (at == kNone) {
        at = point_count++;
        points.emplace_back(x, y);
      }
      return at;
    };
    const auto add = [&](Index e, Index v) __attribute__((always_inline)) {
      if (!reaches(moved, e, fan, v)) return;
      const GridCorner &edge = edges[e], &next = edges[edge.next];
      const GridPoint by = corners[v].at;
      const Index p = point(e, v, edge.at.x + by.x, edge.at.y + by.y);
      const Index q = point(edge.next, v, next.at.x + by.x, next.at.y + by.y);
      const bool right = edge.dx > 0 || (edge.dx == 0 && edge.dy > 0), hides = edge.turn < 0;
      piece->supporting_curve = edge.supporting_curve;
      piece->p0 = right ? p : q;
      piece->p1 = right ? q : p;
      ++piece;
      *side++ = {.left = right, .hides_at_p0 = !right || hides, .hides_at_p1 = right || hides};
    };
    if (chosen_)
      for (const auto& [e, v] : kept_[kMovedFirst ? 1 : 0]) add(e, v);
    else
      each(moved, fan, add);
    const Index end = Index(piece - out_.pieces.data());
    add_lines(piece_, end, geometry.supporting_curves.data());
    piece_ = end;
  }

  /// The lines of some pieces, which so far have the numbers of those to which they are parallel.
  void add_lines(Index first, Index end, const exact::SupportingCurve* parallel) {
    auto& lines = out_.geometry.supporting_curves;
    append_made(lines, end - first,
                [parallel, piece = out_.pieces.data() + first, side = out_.sides.data() + first,
                 points = out_.geometry.points.data(), line = Index(lines.size())](std::size_t k) {
                  const exact::Point& start = points[side[k].left ? piece[k].p0 : piece[k].p1];
                  const exact::SupportingCurve& along =
                      parallel[std::exchange(piece[k].supporting_curve, line + Index(k))];
                  return exact::parallel_line(along, start.gx, start.gy);
                });
  }

  ReducedConvolution& out_;
  EdgeFan &a_, &b_;
  const Choice& choice_;
  const std::optional<GridBox>& within_;
  bool chosen_ = false;                         // some are left out
  std::array<std::vector<MovedEdge>, 2> kept_;  // then the others: edges of B, of A
  Index piece_ = 0;                             // the next one to set
  CornerSums sums_;
};

ArenaVector<EdgeFan> fans(const GridOperand& o, Memory memory) {
  ArenaVector<EdgeFan> out(memory);
  out.reserve(o.faces.size());
  for (const GridFace& f : o.faces) out.emplace_back(f, memory);
  return out;
}

std::size_t corner_count(const GridOperand& o) {
  std::size_t n = 0;
  for (const GridFace& f : o.faces) n += f.corners.size();
  return n;
}

/// Of many faces that are made pair by pair, the room that all of them fill: a list that grows is copied, and both are
/// there. Where curves are left out less is filled, and what is not filled costs nothing.
void reserve_all(ReducedConvolution& out, const ArenaVector<EdgeFan>& p, const ArenaVector<EdgeFan>& q) {
  const auto corners = [](const ArenaVector<EdgeFan>& fans) {
    std::size_t n = 0;
    for (const EdgeFan& f : fans) n += f.corners.size();
    return n;
  };
  const std::size_t count = corners(p) * q.size() + corners(q) * p.size();
  out.geometry.supporting_curves.reserve(count);
  out.geometry.points.reserve(count);
  out.pieces.reserve(count);
  out.sides.reserve(count);
}

}  // namespace

ReducedConvolution reduced_convolution(const GridOperand& a, const GridOperand& b, const std::optional<GridBox>& within,
                                       CoveredCurves* covered) {
  ReducedConvolution out;
  Arena arena(corner_count(a) + corner_count(b));
  ArenaVector<EdgeFan> p = fans(a, arena.memory()), q = fans(b, arena.memory());
  if (!within && (p.size() == 1) != (q.size() == 1)) reserve_all(out, p, q);
  const Choice choice{a, b, within, covered};
  for (EdgeFan& f : p)
    for (EdgeFan& g : q) FacePair(out, f, g, choice, arena.memory()).add();
  return out;
}

}  // namespace findspace::plane
