// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Who is measured. Every contender does the whole job from integer vertices to its own result and returns the number of
// vertices of that result, so that nothing is optimised away and a wrong result stands out. One file a contender; those
// whose library is not installed are not built.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "inputs.h"

namespace bench {

struct Contender {
  std::string name;
  /// A (+) -B, the set of positions in which B meets A. Ours: the sign of gamma1(B, A) at level 0 on every cell.
  std::function<std::size_t(const Polygon& a, const Polygon& b)> sum = {};
  /// The same, with both operands made before what is measured begins.
  std::function<std::function<std::size_t()>(const Polygon& a, const Polygon& b)> sum_alone = {};
  /// The sums of every `step`-th ordered pair of parts, each part prepared once; where empty, `sum` for each.
  std::function<std::size_t(const std::vector<Polygon>& parts, std::size_t step)> pairs = {};
  /// {p : d(p, A) <= r}, or the erosion by |r| where r < 0.
  std::function<std::size_t(const Polygon& a, double r)> offset = {};
  /// The union of all.
  std::function<std::size_t(const std::vector<Polygon>& all)> unite = {};
};

std::vector<Contender> ours();
std::vector<Contender> cgal_rivals();
std::vector<Contender> clipper_rivals();
std::vector<Contender> geos_rivals();

}  // namespace bench
