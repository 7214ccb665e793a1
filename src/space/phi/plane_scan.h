// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The inner loop of Phi values: the highest of many planes at a point, eight planes at a time in the widest vector
// registers that the machine has. Guarantee: the same bits on every machine, for products and sums are rounded one by
// one and a maximum has no rounding.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "space/phi/phi_function.h"

namespace findspace::space {

using Lanes = double __attribute__((vector_size(64)));
/// The same as it lies in a PlaneBlock.
using StoredLanes = double __attribute__((vector_size(64), aligned(8), may_alias));
using LaneIndex = long long __attribute__((vector_size(64)));

/// Blocks of eight planes; the rest of the last block never is the highest.
inline std::vector<PlaneBlock> pack_planes(std::span<const Vector> normals, std::span<const double> offsets) {
  std::vector<PlaneBlock> blocks((normals.size() + 7) / 8);
  for (std::size_t i = 0; i < blocks.size() * 8; ++i) {
    PlaneBlock& b = blocks[i / 8];
    const bool real = i < normals.size();
    b.x[i % 8] = real ? normals[i].x : 0;
    b.y[i % 8] = real ? normals[i].y : 0;
    b.z[i % 8] = real ? normals[i].z : 0;
    b.d[i % 8] = real ? offsets[i] : -std::numeric_limits<double>::infinity();
  }
  return blocks;
}

__attribute__((always_inline)) inline Highest scan_planes_inline(const PlaneBlock* blocks, std::size_t count,
                                                                 const Vector& u) {
  const Lanes zero{}, x = zero + u.x, y = zero + u.y, z = zero + u.z;
  Lanes best = zero - std::numeric_limits<double>::infinity();
  LaneIndex where = {0, 1, 2, 3, 4, 5, 6, 7}, here = where;
  for (std::size_t b = 0; b < count; ++b) {
    const auto* row = reinterpret_cast<const StoredLanes*>(blocks + b);
    const Lanes value = ((row[0] * x + row[1] * y) + row[2] * z) + row[3];
    const LaneIndex better = value > best;
    best = better ? value : best;
    where = better ? here : where;
    here += 8;
  }
  // Across the lanes: the maximum, then the first plane that has it. Without branches, for they would be guessed wrong.
  Lanes most = best, other = __builtin_shufflevector(most, most, 4, 5, 6, 7, 0, 1, 2, 3);
  most = other > most ? other : most;
  other = __builtin_shufflevector(most, most, 2, 3, 0, 1, 6, 7, 4, 5);
  most = other > most ? other : most;
  other = __builtin_shufflevector(most, most, 1, 0, 3, 2, 5, 4, 7, 6);
  most = other > most ? other : most;
  LaneIndex first = best == most ? where : LaneIndex{} + std::numeric_limits<long long>::max();
  LaneIndex rival = __builtin_shufflevector(first, first, 4, 5, 6, 7, 0, 1, 2, 3);
  first = rival < first ? rival : first;
  rival = __builtin_shufflevector(first, first, 2, 3, 0, 1, 6, 7, 4, 5);
  first = rival < first ? rival : first;
  rival = __builtin_shufflevector(first, first, 1, 0, 3, 2, 5, 4, 7, 6);
  first = rival < first ? rival : first;
  return {most[0], static_cast<int>(first[0])};
}

/// The open stretch of a line where all planes are negative; crossed where there is none.
struct LineStretch {
  double from = std::numeric_limits<double>::infinity(), to = -std::numeric_limits<double>::infinity();
};

/// {t : plane(u + t way) + raised < 0 for all planes}. A plane whose slope along the line is not more than `level` ends
/// nothing; there it is only asked whether it is negative at u.
__attribute__((always_inline)) inline LineStretch scan_line_inline(const PlaneBlock* blocks, std::size_t count,
                                                                   const Vector& u, const Vector& way, double raised,
                                                                   double level) {
  const Lanes zero{}, x = zero + u.x, y = zero + u.y, z = zero + u.z;
  const Lanes infinite = zero + std::numeric_limits<double>::infinity();
  Lanes from = -infinite, to = infinite;
  for (std::size_t b = 0; b < count; ++b) {
    const auto* row = reinterpret_cast<const StoredLanes*>(blocks + b);
    const Lanes slope = (row[0] * way.x + row[1] * way.y) + row[2] * way.z;
    const Lanes value = (((row[0] * x + row[1] * y) + row[2] * z) + row[3]) + raised;
    const Lanes end = -value / slope;
    const LaneIndex rises = slope > level, falls = slope < -level;
    const Lanes upper = rises ? end : infinite, lower = falls ? end : -infinite;
    to = upper < to ? upper : to;
    from = lower > from ? lower : from;
    const LaneIndex outside = ~(rises | falls) & (value >= zero);
    from = outside ? infinite : from;
  }
  LineStretch result{from[0], to[0]};
  for (int k = 1; k < 8; ++k) {
    result.from = from[k] > result.from ? from[k] : result.from;
    result.to = to[k] < result.to ? to[k] : result.to;
  }
  return result;
}

/// Kinds of vector registers, narrowest first.
enum class VectorUnit { kPlain, kAvx2, kAvx512 };

/// Those of this machine; the first is everywhere.
std::vector<VectorUnit> vector_units();

/// The highest of 8 * count planes at u, and which it is (the first of equals); by the machine's widest registers.
Highest scan_planes(const PlaneBlock* blocks, std::size_t count, const Vector& u);

/// See scan_line_inline; by the machine's widest registers.
LineStretch scan_line(const PlaneBlock* blocks, std::size_t count, const Vector& u, const Vector& way, double raised,
                      double level);

/// The same by the registers of one kind, which must be one of vector_units().
Highest scan_planes_on(VectorUnit unit, const PlaneBlock* blocks, std::size_t count, const Vector& u);
LineStretch scan_line_on(VectorUnit unit, const PlaneBlock* blocks, std::size_t count, const Vector& u,
                         const Vector& way, double raised, double level);

}  // namespace findspace::space
