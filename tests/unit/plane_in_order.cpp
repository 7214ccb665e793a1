// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Cells numbered by where they lie: degenerate sets first, then sets put together in different orders.
#include <gtest/gtest.h>

#include <array>
#include <tuple>

#include "exact/planar/geometry_signs.h"
#include "plane/query/in_order.h"
#include "plane_topology_sets.h"

namespace findspace::plane {
namespace plane_in_order {

/// All that a writer sees of the cells, supporting curves by their course.
auto cells(const CellComplex& c) {
  std::vector<std::tuple<double, double, int, Index>> vertices;
  for (const Vertex& v : c.vertices) {
    const exact::RealPoint at = c.geometry.exact(v.point);
    vertices.emplace_back(at.x.to_double(), at.y.to_double(), v.mark, v.out);
  }
  std::vector<std::array<Index, 6>> edges;
  for (std::size_t e = 0; e < c.edges.size(); ++e)
    edges.push_back({c.edges[e].v0, c.edges[e].v1, Index(c.edges[e].half + 1), Index(c.edges[e].mark),
                     c.half_edges[2 * e].face, c.half_edges[2 * e + 1].face});
  std::vector<std::tuple<int, Index, ShortList<Index>, ShortList<Index>>> faces;
  for (const Face& f : c.faces) faces.emplace_back(f.mark, f.outer, f.inner, f.isolated);
  return std::tuple(vertices, edges, faces);
}

TEST(InOrder, PlaneAndEmptySet) {
  for (Mark mark : {0, 1}) {
    const Region s = in_order(Region::uniform(mark));
    EXPECT_EQ(s.faces.size(), 1u);
    EXPECT_EQ(s.faces[0].mark, mark);
  }
}

TEST(InOrder, PointsAreSortedAndKeepTheirFaces) {
  const Region s = in_order((box(0, 0, 10, 10) - point(5, 7) - point(5, 2)) + point(20, 0) + point(-3, 0));
  ASSERT_EQ(s.vertices.size(), 8u);
  for (std::size_t v = 1; v < s.vertices.size(); ++v)
    EXPECT_LT(compare_xy(s.geometry, s.vertices[v - 1].point, s.vertices[v].point), 0);
  EXPECT_TRUE(same_set(s, (box(0, 0, 10, 10) - point(5, 7) - point(5, 2)) + point(20, 0) + point(-3, 0)));
}

TEST(InOrder, TheOrderOfTheShapesIsForgotten) {
  const std::array<Region, 5> parts{box(0, 0, 4, 4), box(4, 0, 8, 2), disc(6, 6, 3), point(20, 1),
                                    segment({-5, 1}, {12, 1})};
  const Region forth = parts[0] + parts[1] + parts[2] + parts[3] + parts[4];
  const Region back = parts[4] + parts[3] + parts[2] + parts[1] + parts[0];
  EXPECT_NE(cells(forth), cells(back));  // else there is nothing to test
  EXPECT_EQ(cells(in_order(forth)), cells(in_order(back)));
  EXPECT_TRUE(same_set(in_order(forth), forth));
  EXPECT_EQ(cells(in_order(in_order(forth))), cells(in_order(forth)));
}

}  // namespace plane_in_order
}  // namespace findspace::plane
