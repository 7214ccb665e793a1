// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/reduced_convolution.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "plane/scratch.h"

namespace findspace::plane {
namespace {

using exact::int128;

/// Grows with the angle in [0, 360), by 4 in all; off by less than kAngleError.
double diamond_angle(const GridCorner& c) {
  double x = double(c.dx), y = double(c.dy), t = y / (std::abs(x) + std::abs(y));
  return x < 0 ? 2 - t : t < 0 ? 4 + t : t;
}
constexpr double kAngleError = 0x1p-46;

struct Ray {
  double angle;
  Index corner;  // whose edge it is
};

/// Order of the directions of two edges by angle in [0, 360).
int compare(const Ray& p, const GridCorner& c, const Ray& q, const GridCorner& d) {
  double gap = p.angle - q.angle;
  if (std::abs(gap) > kAngleError) return gap > 0 ? 1 : -1;
  int128 cross = int128(c.dx) * d.dy - int128(c.dy) * d.dx;
  return (cross < 0) - (cross > 0);
}

/// The edges of a face by angle.
class Fan {
 public:
  Fan(const GridFace& face, Memory memory) : corners(face.corners), rays(memory), rank(memory) {
    rays.reserve(corners.size());
    for (Index k = 0; k < corners.size(); ++k) rays.push_back({diamond_angle(corners[k]), k});
    std::sort(rays.begin(), rays.end(), [this](const Ray& p, const Ray& q) {
      int order = compare(p, corners[p.corner], q, corners[q.corner]);
      return order != 0 ? order < 0 : p.corner < q.corner;
    });
  }

  /// Per edge: how many edges of `other` come before it; of one direction, those of `first` come first.
  static void place(Fan& first, Fan& other) {
    first.rank.resize(first.rays.size());
    other.rank.resize(other.rays.size());
    Index i = 0, j = 0;
    while (i < first.rays.size() || j < other.rays.size()) {
      bool take_first = j == other.rays.size() || (i < first.rays.size() && !before(other, j, first, i));
      if (take_first)
        first.rank[first.rays[i].corner] = j, ++i;
      else
        other.rank[other.rays[j].corner] = i, ++j;
    }
  }

  const std::vector<GridCorner>& corners;
  std::pmr::vector<Ray> rays;    // by angle
  std::pmr::vector<Index> rank;  // corner -> rays of the other fan before its own

 private:
  static bool before(const Fan& p, Index i, const Fan& q, Index j) {
    return compare(p.rays[i], p.corners[p.rays[i].corner], q.rays[j], q.corners[q.rays[j].corner]) < 0;
  }
};

/// Sums of two corners, each a point once. An open-addressing table of pairs.
class CornerSums {
 public:
  CornerSums(std::size_t most, Memory memory) : slots_(std::bit_ceil(2 * most + 2), memory) {}

  Index point(exact::Geometry& g, const Fan& a, Index i, const Fan& b, Index j) {
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
  FacePair(ReducedConvolution& out, Fan& a, Fan& b, Memory memory)
      : out_(out), a_(a), b_(b), sums_(place_and_count(), memory) {}

  void add(const exact::Geometry& a, const exact::Geometry& b) {
    add_edges(b_, b, a_, false);
    add_edges(a_, a, b_, true);
  }

 private:
  /// The edges of `moved` whose directions the convex corners of `fan` sweep.
  template <class Visit>
  static void each(const Fan& moved, const Fan& fan, Visit&& visit) {
    Index n = Index(moved.rays.size());
    for (Index v = 0; v < fan.corners.size(); ++v) {
      const GridCorner& c = fan.corners[v];
      if (c.turn <= 0) continue;
      const GridCorner& in = fan.corners[c.before];
      Index first = fan.rank[c.before], end = fan.rank[v];
      // A corner that sweeps the direction 0 ends below where it starts; so does none else.
      bool wraps = lower(in) && !lower(c);
      for (Index k = first; k < (wraps ? n : end); ++k) visit(moved.rays[k].corner, v);
      for (Index k = 0; wraps && k < end; ++k) visit(moved.rays[k].corner, v);
    }
  }

  static bool lower(const GridCorner& c) { return c.dy < 0 || (c.dy == 0 && c.dx < 0); }

  std::size_t place_and_count() {
    Fan::place(a_, b_);
    std::size_t count = 0;
    each(b_, a_, [&](Index, Index) { ++count; });
    each(a_, b_, [&](Index, Index) { ++count; });
    auto& g = out_.geometry;
    g.carriers.reserve(g.carriers.size() + count);
    g.points.reserve(g.points.size() + 2 * count);
    out_.pieces.reserve(out_.pieces.size() + count);
    out_.sides.reserve(out_.sides.size() + count);
    return count;
  }

  void add_edges(const Fan& moved, const exact::Geometry& geometry, const Fan& fan, bool moved_first) {
    auto& g = out_.geometry;
    each(moved, fan, [&](Index e, Index v) {
      const GridCorner& edge = moved.corners[e];
      Index from = moved_first ? sums_.point(g, moved, e, fan, v) : sums_.point(g, fan, v, moved, e);
      Index to = moved_first ? sums_.point(g, moved, edge.next, fan, v) : sums_.point(g, fan, v, moved, edge.next);
      bool right = edge.dx > 0 || (edge.dx == 0 && edge.dy > 0), hides = edge.turn < 0;
      Index carrier = g.add_parallel(geometry.carriers[edge.carrier], g.points[from].gx, g.points[from].gy);
      out_.pieces.push_back({.carrier = carrier, .p0 = right ? from : to, .p1 = right ? to : from});
      out_.sides.push_back({.left = right, .hides_at_p0 = !right || hides, .hides_at_p1 = right || hides});
    });
  }

  ReducedConvolution& out_;
  Fan &a_, &b_;
  CornerSums sums_;
};

std::pmr::vector<Fan> fans(const GridOperand& o, Memory memory) {
  std::pmr::vector<Fan> out(memory);
  out.reserve(o.faces.size());
  for (const GridFace& f : o.faces) out.emplace_back(f, memory);
  return out;
}

std::size_t corner_count(const GridOperand& o) {
  std::size_t n = 0;
  for (const GridFace& f : o.faces) n += f.corners.size();
  return n;
}

}  // namespace

ReducedConvolution reduced_convolution(const GridOperand& a, const GridOperand& b) {
  ReducedConvolution out;
  Scratch scratch(corner_count(a) + corner_count(b));
  std::pmr::vector<Fan> p = fans(a, scratch.memory()), q = fans(b, scratch.memory());
  for (Fan& f : p)
    for (Fan& g : q) FacePair(out, f, g, scratch.memory()).add(a.geometry, b.geometry);
  return out;
}

}  // namespace findspace::plane
