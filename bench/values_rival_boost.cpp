// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Boost.Geometry: distance, and the discrete Hausdorff distance of two line strings at their vertices.
#include <boost/geometry.hpp>
#include <boost/geometry/algorithms/discrete_hausdorff_distance.hpp>
#include <boost/geometry/geometries/geometries.hpp>
#include <memory>

#include "values_rivals.h"

namespace bench {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;

}  // namespace

ValueRival boost_values(const Polygon& a, const Polygon& b) {
  using Line = bg::model::linestring<BoostPoint>;
  using Area = bg::model::polygon<BoostPoint, false>;
  struct Pair {
    Line line_a, line_b;
    Area area_a, area_b;
  };
  auto pair = std::make_shared<Pair>();
  auto fill = [](const Polygon& p, Line& line, Area& area) {
    for (std::size_t i = 0; i <= p.size(); ++i) {
      const Point& q = p[i % p.size()];
      line.emplace_back(double(q.x), double(q.y));
      area.outer().emplace_back(double(q.x), double(q.y));
    }
  };
  fill(a, pair->line_a, pair->area_a);
  fill(b, pair->line_b, pair->area_b);
  return {[pair] { return double(bg::distance(pair->area_a, pair->area_b)); },
          {},
          [pair] { return double(bg::discrete_hausdorff_distance(pair->line_a, pair->line_b)); }};
}

}  // namespace bench
