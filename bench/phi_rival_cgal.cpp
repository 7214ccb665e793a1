// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/minkowski_sum_3.h>

#include "phi_rivals.h"

namespace phi_bench {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;

Nef nef(const Body& body, double sign) {
  std::vector<Kernel::Point_3> points;
  for (const auto& v : body.vertices) points.emplace_back(sign * v[0], sign * v[1], sign * v[2]);
  Polyhedron hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  return Nef(hull);
}

}  // namespace

Built build_with_cgal(const Body& a, const Body& b) {
  Nef p = nef(a, 1), q = nef(b, -1);
  const double start = now();
  const Nef sum = CGAL::minkowski_sum_3(p, q);
  const double seconds = now() - start;
  // Halffacets come in pairs.
  return {seconds, static_cast<int>(sum.number_of_halffacets() / 2)};
}

}  // namespace phi_bench
