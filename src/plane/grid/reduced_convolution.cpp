// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/reduced_convolution.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "plane/base/reserve_more.h"
#include "plane/grid/edge_fan.h"

namespace findspace::plane {
namespace {

constexpr std::size_t kManyCurves = 20'000;  // of a pair: from here on it may pay to look which are covered
constexpr std::size_t kSample = 256;         // of them, looked at first: three quarters must be covered
// A look at a curve costs what the mask of prune_inside.h does for some crossings of its. Where more are estimated, the
// mask costs more, but it also cuts away parts of curves. Nearly coinciding curves cross far more than is estimated.
constexpr double kMostCrossings = 8;

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

/// Sums of two corners, each a point once. An open-addressing table of pairs.
class CornerSums {
 public:
  CornerSums(std::size_t most, Memory memory) : slots_(std::bit_ceil(2 * most + 2), memory) {}

  Index point(exact::Geometry& g, const EdgeFan& a, Index i, const EdgeFan& b, Index j) {
    std::uint64_t key = (std::uint64_t(i) << 32 | j) + 1, mask = slots_.size() - 1;
    std::uint64_t at = (key * 0x9e3779b97f4a7c15u) >> 32 & mask;
    while (slots_[at].key != 0 && slots_[at].key != key) at = (at + 1) & mask;
    Slot& slot = slots_[at];
    if (slot.key == 0) {
      GridPoint p = a.corners[i].at, q = b.corners[j].at;
      slot = {key, g.add_grid_point(p.x + q.x, p.y + q.y)};
    }
    return slot.point;
  }

 private:
  struct Slot {
    std::uint64_t key = 0;
    Index point = kNone;
  };
  std::pmr::vector<Slot> slots_;
};

class FacePair {
 public:
  FacePair(ReducedConvolution& out, EdgeFan& a, EdgeFan& b, const std::optional<GridBox>& within,
           CoveredCurves* covered, Memory memory)
      : out_(out), a_(a), b_(b), within_(within), covered_(covered), sums_(place_and_count(), memory) {}

  void add(const exact::Geometry& a, const exact::Geometry& b) {
    add_edges(b_, b, a_, false);
    add_edges(a_, a, b_, true);
  }

 private:
  /// The edges of `moved` whose directions the convex corners of `fan` sweep.
  template <class Visit>
  static void each(const EdgeFan& moved, const EdgeFan& fan, Visit&& visit) {
    Index n = Index(moved.rays.size());
    for (Index v = 0; v < fan.corners.size(); ++v) {
      if (fan.corners[v].turn <= 0) continue;
      EdgeFan::Sweep s = fan.sweep(v);
      for (Index k = s.first; k < (s.wraps ? n : s.end); ++k) visit(moved.rays[k].corner, v);
      for (Index k = 0; s.wraps && k < s.end; ++k) visit(moved.rays[k].corner, v);
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

  bool is_covered(const EdgeFan& moved, const EdgeFan& fan, const MovedEdge& curve) const {
    const GridCorner& c = moved.corners[curve.edge];
    const GridPoint by = fan.corners[curve.corner].at, p = c.at, q = moved.corners[c.next].at;
    return covered_->covers({double(std::min(p.x, q.x) + by.x), double(std::min(p.y, q.y) + by.y),
                             double(std::max(p.x, q.x) + by.x), double(std::max(p.y, q.y) + by.y)});
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

  static double length(const EdgeFan& moved, std::span<const MovedEdge> curves) {
    double sum = 0;
    for (const MovedEdge& c : curves)
      sum += std::hypot(double(moved.corners[c.edge].dx), double(moved.corners[c.edge].dy));
    return sum;
  }

  /// Does it pay to look at all `count` curves? By a sample spread over them: one that is not covered costs many looks.
  bool looks_pay(std::size_t count) const {
    if (count < kManyCurves) return false;
    const std::size_t step = count / kSample;
    const std::vector<MovedEdge> p = sample(b_, a_, step), q = sample(a_, b_, step);
    const Extent x = extent(a_), y = extent(b_);
    const double crossings =
        estimated_crossings((length(b_, p) + length(a_, q)) * double(step), x.width + y.width, x.height + y.height);
    if (crossings > kMostCrossings * double(count)) return false;
    const auto covered = std::count_if(p.begin(), p.end(), [&](const MovedEdge& c) { return is_covered(b_, a_, c); }) +
                         std::count_if(q.begin(), q.end(), [&](const MovedEdge& c) { return is_covered(a_, b_, c); });
    return 4 * std::size_t(covered) >= 3 * (p.size() + q.size());
  }

  /// Those that are not covered.
  std::size_t keep_edges(const EdgeFan& moved, const EdgeFan& fan, int side) {
    each(moved, fan, [&](Index e, Index v) {
      if (!is_covered(moved, fan, {e, v})) kept_[side].push_back({e, v});
    });
    return kept_[side].size();
  }

  template <class Visit>
  void each_kept(const EdgeFan& moved, const EdgeFan& fan, int side, Visit&& visit) const {
    if (!covered_) return each(moved, fan, visit);
    for (const auto& [e, v] : kept_[side]) visit(e, v);
  }

  std::size_t place_and_count() {
    EdgeFan::place(a_, b_);
    std::size_t count = count_edges(b_, a_) + count_edges(a_, b_);
    if (covered_ && !looks_pay(count)) covered_ = nullptr;
    if (covered_) count = keep_edges(b_, a_, 0) + keep_edges(a_, b_, 1);
    auto& g = out_.geometry;
    reserve_more(g.supporting_curves, count);
    reserve_more(g.points, 2 * count);
    reserve_more(out_.pieces, count);
    reserve_more(out_.sides, count);
    return count;
  }

  void add_edges(const EdgeFan& moved, const exact::Geometry& geometry, const EdgeFan& fan, bool moved_first) {
    auto& g = out_.geometry;
    each_kept(moved, fan, moved_first ? 1 : 0, [&](Index e, Index v) {
      if (!reaches(moved, e, fan, v)) return;
      const GridCorner& edge = moved.corners[e];
      Index from = moved_first ? sums_.point(g, moved, e, fan, v) : sums_.point(g, fan, v, moved, e);
      Index to = moved_first ? sums_.point(g, moved, edge.next, fan, v) : sums_.point(g, fan, v, moved, edge.next);
      bool right = edge.dx > 0 || (edge.dx == 0 && edge.dy > 0), hides = edge.turn < 0;
      Index supporting_curve =
          g.add_parallel(geometry.supporting_curves[edge.supporting_curve], g.points[from].gx, g.points[from].gy);
      out_.pieces.push_back({.supporting_curve = supporting_curve, .p0 = right ? from : to, .p1 = right ? to : from});
      out_.sides.push_back({.left = right, .hides_at_p0 = !right || hides, .hides_at_p1 = right || hides});
    });
  }

  ReducedConvolution& out_;
  EdgeFan &a_, &b_;
  const std::optional<GridBox>& within_;
  CoveredCurves* covered_;
  std::array<std::vector<MovedEdge>, 2> kept_;  // edges of B, of A
  CornerSums sums_;
};

std::pmr::vector<EdgeFan> fans(const GridOperand& o, Memory memory) {
  std::pmr::vector<EdgeFan> out(memory);
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
void reserve_all(ReducedConvolution& out, const std::pmr::vector<EdgeFan>& p, const std::pmr::vector<EdgeFan>& q) {
  const auto corners = [](const std::pmr::vector<EdgeFan>& fans) {
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

double estimated_crossings(double length, double width, double height) {
  return length * length / (3.14 * std::max(width * height, 1.0));
}

ReducedConvolution reduced_convolution(const GridOperand& a, const GridOperand& b, const std::optional<GridBox>& within,
                                       CoveredCurves* covered) {
  ReducedConvolution out;
  Arena arena(corner_count(a) + corner_count(b));
  std::pmr::vector<EdgeFan> p = fans(a, arena.memory()), q = fans(b, arena.memory());
  if (!within && (p.size() == 1) != (q.size() == 1)) reserve_all(out, p, q);
  for (EdgeFan& f : p)
    for (EdgeFan& g : q) FacePair(out, f, g, within, covered, arena.memory()).add(a.geometry, b.geometry);
  return out;
}

}  // namespace findspace::plane
