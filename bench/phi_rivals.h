// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The rivals of the Phi benchmarks behind plain types, one translation unit each. Inputs are vertex lists and convex
// faces of A and B in doubles that are exact integers. Times are seconds of the construction or query alone; converting
// the input into a rival's own types is not counted.
#pragma once

#include <array>
#include <functional>
#include <vector>

namespace phi_bench {

struct Body {
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::vector<int>> faces;
};

struct Built {
  double seconds = 0;
  int facets = 0;  // 0 where the rival does not tell
};

/// CGAL: minkowski_sum_3 of Nef polyhedra of A and the reflected B, exact kernel.
Built build_with_cgal(const Body& a, const Body& b);
/// Qhull (libqhull_r): the hull of all differences, facets merged, in doubles.
Built build_with_qhull(const Body& a, const Body& b);

/// A penetration depth query: the depth of B translated by u in A.
using DepthQuery = std::function<double(const std::array<double, 3>& u)>;
DepthQuery depth_with_fcl(const Body& a, const Body& b);
DepthQuery depth_with_ccd(const Body& a, const Body& b);

double now();

}  // namespace phi_bench
