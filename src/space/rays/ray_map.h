// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Ray maps: a sign map on a grid of parallel lines in the space of positions. Along each line stand its events in
// order, each with the sign at it and after it; so open and closed ends, intervals of length zero and exact fits
// survive. Guarantee: exact on the lines: the places of events are fractions (or real numbers), ties are decided. Of
// what lies between the lines nothing is said. Rows come one by one, independent of each other: memory is one row for
// each thread. Source: Pustylnik, linear ray representation; distances.md 8.3. Keywords: LRR, ray representation,
// dexel, z-buffer, tri-dexel.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "exact/number/tried.h"
#include "exact/solid/ray_sign.h"
#include "space/polytope/polytope.h"

namespace findspace::space {

struct ObliqueLine;

/// The lines: line (i, j) runs along `axis` through (u + i du, v + j dv) in the two coordinates that follow `axis` in
/// the cycle x, y, z. All in parts of a grid step, `parts` to a step.
struct RayGrid {
  int axis = 2;
  std::int64_t parts = 1;
  std::int64_t u = 0, v = 0, du = 1, dv = 1;
  int nu = 0, nv = 0;
  /// Set: there is one line only, (0, 0), which is this one; `parts` is 1.
  std::shared_ptr<const ObliqueLine> oblique = nullptr;

  std::int64_t u_at(int i) const { return u + i * du; }
  std::int64_t v_at(int j) const { return v + j * dv; }
};

/// About n lines each way in the middle of cells that cover the box (grid steps), on a grid fine enough that the cells
/// are even to a millionth. Throws Error(kBadValue) unless 1 <= n <= 2^14.
RayGrid ray_grid(const Point& low, const Point& high, int axis, int n);

/// Lines `step` grid steps apart each way, in the middle of cells from `low` on that cover the box. Throws
/// Error(kBadValue) where that needs more than 2^14 lines.
RayGrid ray_grid_by_step(const Point& low, const Point& high, int axis, std::int64_t step);

/// Gives places along lines that are not fractions.
class RayRoots {
 public:
  virtual ~RayRoots() = default;
  virtual exact::Real root(int patch, int which, int i, int j) const = 0;
};

/// A place along a line, in parts of a step: a fraction, or root `which` of a curved patch met by line (i, j).
struct RayPosition {
  double value = 0, radius = 0;  // the place is within `radius` of `value`
  exact::Fraction exact{0, 0};
  const RayRoots* roots = nullptr;  // where this is set it is not a fraction; lives as long as the source of the row
  int patch = 0, i = 0, j = 0;
  std::int8_t which = 0;

  exact::Real to_real() const { return roots ? roots->root(patch, which, i, j) : exact::to_real(exact); }
};

/// Whether both are one place by their names; others may be the same place, too.
bool same_root(const RayPosition& p, const RayPosition& q);
/// The sign of p - q, exactly.
int compare_positions(const RayPosition& p, const RayPosition& q);

struct RayEvent {
  RayPosition at;
  std::int8_t here = 0, after = 0;
};

/// The lines (0, j) to (nu - 1, j): of line i the sign before all events, and events first[i] to first[i + 1] - 1.
struct RayRow {
  std::vector<std::int8_t> before;
  std::vector<int> first{0};
  std::vector<RayEvent> events;
};

/// A sign map that can be had on the rows of a grid. Safe to ask from many threads.
class RaySource {
 public:
  virtual ~RaySource() = default;
  virtual const RayGrid& grid() const = 0;
  /// Refused where a search tells the signs and does not within its limit.
  virtual exact::Tried<RayRow> try_row(int j) const = 0;
  /// The same; Error(kUnsupported) instead of a refusal.
  RayRow row(int j) const { return try_row(j).or_throw(); }
  /// Whether a search tells the signs, so that 0 means a place near the boundary as well as on it.
  virtual bool searched() const { return false; }
  /// Whether row j is known to be + all along; of many sources few are asked for a row then.
  virtual bool apart(int /*j*/) const { return false; }
  /// What each_row() does; a source whose rows come from several processes has its own way.
  virtual void each_row(const std::function<void(int, RayRow&&)>& take) const;
};

/// One sign map from several on the same grid: the sign of `combine` at every place, from the signs of the sources
/// there. Events at which nothing changes are left out.
RayRow combined(std::span<const RayRow> rows, const std::function<std::int8_t(std::span<const std::int8_t>)>& combine);

/// The sign at height z (in parts of a step) of line i of a row.
std::int8_t sign_at(const RayRow& row, int i, const exact::Real& z);

/// All rows of a source, made in parallel; take(j, row) is called for j = 0, 1, 2 ... in order, from one thread at a
/// time.
inline void each_row(const RaySource& source, const std::function<void(int, RayRow&&)>& take) { source.each_row(take); }
std::vector<RayRow> all_rows(const RaySource& source);

}  // namespace findspace::space
