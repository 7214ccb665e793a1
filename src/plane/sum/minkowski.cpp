// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/sum/minkowski.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>

#include "exact/margins/rounding.h"
#include "plane/base/result_store.h"
#include "plane/base/stage_observer.h"
#include "plane/complex/cell_bytes.h"
#include "plane/complex/extent.h"
#include "plane/complex/overlay.h"
#include "plane/grid/edge_fan.h"
#include "plane/grid/grid_sum.h"
#include "plane/query/in_batches.h"
#include "plane/sum/pair_sums.h"

namespace findspace::plane {
namespace {

/// The faces of an operand, which may have been made before.
class GridOf {
 public:
  GridOf(const Operand& o, Memory memory) : known_(o.known_grid) {
    if (known_ == nullptr) made_ = o.grid(memory);
  }

  const std::optional<GridFaces>& faces() const { return known_ != nullptr ? *known_ : made_; }

 private:
  const std::optional<GridFaces>* known_;
  std::optional<GridFaces> made_;
};

/// With what many sums need.
std::optional<GridFaces> prepared_grid(const Operand& o) {
  std::optional<GridFaces> faces = o.grid();
  if (faces) make_rays(*faces);
  return faces;
}

/// Made when it is asked first.
struct InsideOfSum {
  InsideOfSum(const Operand& a, const Operand& b, const GridOperand& x, const GridOperand& y)
      : index(x, y), solid(a, b, index) {}

  ConvolutionIndex index;
  SolidSum solid;
};

/// The open sum of two sets bounded by grid segments, without parts that have no interior. `p`, `q`: their faces.
SignMap open_grid_sum(const Operand& a, const GridFaces& p, const Operand& b, const GridFaces& q) {
  const GridOperand x{p, a.cells.geometry}, y{q, b.cells.geometry};
  std::unique_ptr<InsideOfSum> sum;
  const auto inside = [&](exact::Geometry& g, Index point) {
    if (!sum) sum = std::make_unique<InsideOfSum>(a, b, x, y);
    return sum->solid.holds(g, point);
  };
  return grid_sum(x, y, std::cref(inside));
}

bool unbounded(const Operand& a) { return a.wanted(a.cells.faces[0].mark); }

using Drop = std::function<void()>;

/// -1 on U = (int A (+) B) u (A (+) int B), 0 on the rest of the sum, +1 elsewhere. `drop`: A is not read again.
SignMap sum_at_once(const Operand& a, const Operand& b, const Drop& drop) {
  Arena arena(a.cells.edges.size() + b.cells.edges.size());
  if (const GridOf p(a, arena.memory()); p.faces())
    if (const GridOf q(b, arena.memory()); q.faces()) return open_grid_sum(a, *p.faces(), b, *q.faces());
  SumOfPairs sum(true);
  sum.reserve(a.cells.edges.size() + a.cells.vertices.size());  // about what a convex set makes of a larger one
  const std::vector<Part> q = b.solid_parts(), p_flat = a.flat_parts(), q_flat = b.flat_parts();
  a.each_solid_part([&](const Part& x) {
    for (const Part& y : q) sum.add(x, y);
    for (const Part& y : q_flat) sum.add(x, y);
  });
  for (const Part& x : p_flat)
    for (const Part& y : q) sum.add(x, y);
  sum.prune(a, b);
  if (drop) drop();
  SignMap open = std::move(sum).open_sum();
  if (p_flat.empty() || q_flat.empty()) return open;
  SumOfPairs flat(false);
  for (const Part& x : p_flat)
    for (const Part& y : q_flat) flat.add(x, y);
  Region closed = std::move(flat).closed_sum();
  std::array<const CellComplex*, 2> both{&open, &closed};
  return overlay(both, [](std::span<const Mark> m) { return Mark(m[0] <= 0 ? m[0] : m[1] > 0 ? 0 : 1); });
}

/// A box around the operand, as it counts in the sum; nothing where it has no boundary.
std::optional<PieceBox> extent_of(const Operand& a) {
  const std::optional<PieceBox> box = extent(a.cells);
  return box && a.mirrored ? PieceBox{-box->x1, -box->y1, -box->x0, -box->y0} : box;
}

/// Whether a bounded operand is certainly wider or higher than all that an unbounded one leaves out: it meets that
/// wherever it is.
bool sticks_out(const Operand& b, const Operand& unbounded) {
  const std::optional<PieceBox> most = extent(unbounded.cells);
  if (!most) return false;
  PieceBox least{INFINITY, INFINITY, -INFINITY, -INFINITY};
  for (const Face& f : b.cells.faces) {
    if (!b.wanted(f.mark)) continue;
    Index h = f.outer;
    do {
      const exact::Point& p = b.cells.point(b.cells.origin(h));
      least.x0 = std::min(least.x0, p.x + p.error);
      least.y0 = std::min(least.y0, p.y + p.error);
      least.x1 = std::max(least.x1, p.x - p.error);
      least.y1 = std::max(least.y1, p.y - p.error);
      h = b.cells.next(h);
    } while (h != f.outer);
  }
  const auto exceeds = [](double low, double high, double from, double to) {
    const double slack = (std::abs(low) + std::abs(high) + std::abs(from) + std::abs(to)) * margin::kRoundings8;
    return high - low > to - from + slack;
  };
  return exceeds(least.x0, least.x1, most->x0, most->x1) || exceeds(least.y0, least.y1, most->y0, most->y1);
}

SignMap made_sum(const Operand& a, const Operand& b, const Drop& drop) {
  if (unbounded(b)) return unbounded(a) ? CellComplex::uniform(-1) : made_sum(b, a, {});
  if (unbounded(a) && sticks_out(b, a)) return CellComplex::uniform(-1);
  if (is_worth_batches(a.cells) && !a.mirrored)
    if (const auto reach = extent_of(b)) {
      const Lazy<std::optional<GridFaces>> of_b;
      if (auto sum = made_in_batches(a.cells, *reach, [&](const CellComplex& part) {
            Operand again = b;
            if (b.known_grid == nullptr) again.known_grid = &of_b.of([&] { return prepared_grid(b); });
            return sum_at_once({part, a.wanted, a.mirrored, a.flat}, again, {});
          }))
        return *std::move(sum);
    }
  return sum_at_once(a, b, drop);
}

bool put_operand(const Operand& a, ByteWriter& out) {
  out.put(std::int8_t(a.wanted == is_in));
  out.put(std::int8_t(a.mirrored));
  out.put(std::int8_t(a.flat));
  return put_cells(a.cells, out);
}

/// {a + b} for a in A, b in B: -1 on the open part U, 0 on the rest of the sum, +1 elsewhere.
SignMap sum_map(const Operand& a, const Operand& b, const Drop& drop = {}) {
  SignMap sum = stored<SignMap>({"sum", [&](ByteWriter& out) { return put_operand(a, out) && put_operand(b, out); },
                                 [&] { return made_sum(a, b, drop); }, put_cells, take_cells});
  if (StageObserver* observer = stage_observer())
    observer->cells("sum", "Minkowski sum: -1 in its open part, 0 on the rest of it, 1 elsewhere", sum);
  return sum;
}

}  // namespace

SignMap contact_map(const Region& a, const Region& b) { return sum_map({a, is_in}, {b, is_in, true}); }

SignMap contact_map(Region&& a, const Region& b) {
  Region own = std::move(a);
  return sum_map({own, is_in}, {b, is_in, true}, [&] { own = Region{}; });
}

const std::optional<GridFaces>& SumOperand::faces(bool mirrored) const {
  return faces_[mirrored ? 1 : 0].of([&] { return prepared_grid({region_, is_in, mirrored}); });
}

SignMap contact_map(const SumOperand& a, const SumOperand& b) {
  return sum_map({a.region(), is_in, false, true, &a.faces(false)}, {b.region(), is_in, true, true, &b.faces(true)});
}

SignMap containment_map(const Region& a, const Region& b) {
  // B + p leaves A where it meets the open complement; it leaves int A where it meets the closure of that.
  Operand outside{a, is_out, false, false}, moving{b, is_in, true};
  return remark(sum_map(outside, moving), [](Mark m) { return Mark(-m); });
}

Region minkowski_sum(const Region& a, const Region& b) {
  return remark(sum_map({a, is_in}, {b, is_in}), [](Mark m) { return Mark(m <= 0); });
}

Region minkowski_difference(const Region& a, const Region& b) {
  return remark(containment_map(a, mirrored(b)), [](Mark m) { return Mark(m <= 0); });
}

namespace {

void mirror_geometry(exact::Geometry& g) {
  using exact::SupportingCurve;
  // A crossing with a line keeps its root only if the line's direction is mirrored too, and that stays canonical.
  for (exact::Point& p : g.points) {
    if (p.kind == exact::Point::Kind::kGrid) {
      p.gx = -p.gx;
      p.gy = -p.gy;
    }
    p.x = -p.x;
    p.y = -p.y;
    if (p.kind == exact::Point::Kind::kCross && g.supporting_curves[p.i].circle != g.supporting_curves[p.j].circle)
      p.root = std::int8_t(-p.root);
  }
  for (SupportingCurve& k : g.supporting_curves) {
    if (k.circle)
      k = k.grid ? SupportingCurve::circle_at(-k.a, -k.b, k.reals)
                 : SupportingCurve::circle_at(-k.real()->x, -k.real()->y, k.w());
    else
      k = k.real() ? SupportingCurve::line(k.a, k.b, -k.real()->x)
                   : SupportingCurve::displaced_line(k.a, k.b, -k.c, -k.w());
  }
  for (exact::RealPoint& p : g.reals) p = {-p.x, -p.y};
}

}  // namespace

CellComplex mirrored(const CellComplex& c) {
  CellComplex m = c;
  mirror_geometry(m.geometry);
  // What ran to the right runs to the left: half-edges 2e and 2e + 1 change places.
  auto flip = [](Index h) { return h == kNone ? kNone : h ^ 1u; };
  for (Edge& e : m.edges) {
    std::swap(e.v0, e.v1);
    e.half = std::int8_t(-e.half);
  }
  for (Index h = 0; h < c.half_edges.size(); ++h)
    m.half_edges[flip(h)] = {flip(c.half_edges[h].next), c.half_edges[h].face};
  for (Face& f : m.faces) {
    f.outer = flip(f.outer);
    for (Index& h : f.inner) h = flip(h);
  }
  for (Index v = 0; v < c.vertices.size(); ++v) {
    // Counter-clockwise from straight down now means from straight up before: the first of those that went left, if
    // there are others.
    Index first = c.vertices[v].out;
    if (first != kNone && !(first & 1u)) {
      Index h = c.clockwise(first);
      for (; h & 1u; h = c.clockwise(h)) first = h;
    }
    m.vertices[v].out = flip(first);
  }
  return m;
}

}  // namespace findspace::plane
