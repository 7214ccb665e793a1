// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// CGAL: Minkowski sums by reduced convolution with exact constructions, offsets exactly (conic arcs) and within a bound
// (circular arcs of rational circles).
#include <CGAL/Arr_conic_traits_2.h>
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/CORE_algebraic_number_traits.h>
#include <CGAL/Cartesian.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gps_circle_segment_traits_2.h>
#include <CGAL/Gps_traits_2.h>
#include <CGAL/approximated_offset_2.h>
#include <CGAL/minkowski_sum_2.h>
#include <CGAL/offset_polygon_2.h>

#include <cmath>
#include <iterator>

#include "contenders.h"

namespace bench {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

template <class K>
CGAL::Polygon_2<K> converted(const Polygon& polygon) {
  CGAL::Polygon_2<K> p;
  for (const Point& q : polygon) p.push_back(typename K::Point_2(double(q.x), double(q.y)));
  return p;
}

template <class WithHoles>
std::size_t vertices(const WithHoles& polygon) {
  std::size_t n = polygon.outer_boundary().size();
  for (auto h = polygon.holes_begin(); h != polygon.holes_end(); ++h) n += h->size();
  return n;
}

std::size_t sum(const Polygon& a, const Polygon& b) {
  auto result = CGAL::minkowski_sum_by_reduced_convolution_2(converted<Kernel>(a), converted<Kernel>(mirrored(b)));
  return vertices(result);
}

std::size_t exact_offset(const Polygon& a, double r) {
  using Numbers = CGAL::CORE_algebraic_number_traits;
  using Rational = CGAL::Cartesian<Numbers::Rational>;
  using Algebraic = CGAL::Cartesian<Numbers::Algebraic>;
  using Traits = CGAL::Arr_conic_traits_2<Rational, Algebraic, Numbers>;
  Traits traits;
  auto p = converted<Rational>(a);
  if (r > 0) return vertices(CGAL::offset_polygon_2(p, Numbers::Rational(r), traits));
  std::vector<CGAL::Gps_traits_2<Traits>::Polygon_2> parts;
  CGAL::inset_polygon_2(p, Numbers::Rational(-r), traits, std::back_inserter(parts));
  std::size_t n = 0;
  for (const auto& part : parts) n += part.size();
  return n;
}

std::size_t approximate_offset(const Polygon& a, double r) {
  double bound = std::abs(r) * 1e-5;
  auto p = converted<Kernel>(a);
  if (r > 0) return vertices(CGAL::approximated_offset_2(p, Kernel::FT(r), bound));
  std::vector<CGAL::Gps_circle_segment_traits_2<Kernel>::Polygon_2> parts;
  CGAL::approximated_inset_2(p, Kernel::FT(-r), bound, std::back_inserter(parts));
  std::size_t n = 0;
  for (const auto& part : parts) n += part.size();
  return n;
}

std::size_t unite(const std::vector<Polygon>& all) {
  std::vector<CGAL::Polygon_2<Kernel>> polygons;
  for (const Polygon& p : all) polygons.push_back(converted<Kernel>(p));
  std::vector<CGAL::Polygon_with_holes_2<Kernel>> result;
  CGAL::join(polygons.begin(), polygons.end(), std::back_inserter(result));
  std::size_t n = 0;
  for (const auto& p : result) n += vertices(p);
  return n;
}

}  // namespace

std::vector<Contender> cgal_rivals() {
  return {{.name = "CGAL exact", .sum = sum, .offset = exact_offset, .unite = unite},
          {.name = "CGAL approximated", .sum = {}, .offset = approximate_offset, .unite = {}}};
}

}  // namespace bench
