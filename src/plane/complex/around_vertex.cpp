// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/complex/around_vertex.h"

#include <algorithm>

#include "exact/planar/geometry_signs.h"
#include "plane/base/parallel.h"
#include "plane/base/small_sort.h"

namespace findspace::plane {
namespace {

using exact::Geometry;

exact::Heading heading(const Arrangement& a, Index h) {
  const Arrangement::Edge& e = a.edges[h / 2];
  bool right = !(h & 1u);
  bool forward =
      e.half != 0 ? (e.half < 0) == right : (a.geometry.supporting_curves[e.supporting_curve].b > 0) == right;
  return {e.supporting_curve, forward};
}

/// Of two half-edges at v, both to the right or both to the left: the order of `comes_before`.
bool before(const Arrangement& a, Index v, Index h, Index k) {
  if (h == k) return false;
  const Arrangement::Edge &e = a.edges[h / 2], &f = a.edges[k / 2];
  if (e.half == 0 && f.half == 0)
    return line_comes_before(a.geometry.supporting_curves[e.supporting_curve],
                             a.geometry.supporting_curves[f.supporting_curve]);
  return comes_before(a.geometry, a.vertex_point[v], h & 1u, heading(a, h), e.half, heading(a, k));
}

/// The half-edges at v, those that go right first: puts them in order, and notes rank and next.
void sort_around(Arrangement& a, Index v) {
  auto first = a.out.begin() + a.out_start[v], last = a.out.begin() + a.out_start[v + 1];
  auto middle = first;
  while (middle != last && !(*middle & 1u)) ++middle;
  auto less = [&](Index h, Index k) { return before(a, v, h, k); };
  small_sort(first, middle, less);
  small_sort(middle, last, less);
  Index d = Index(last - first);
  for (Index r = 0; r < d; ++r) {
    a.rank[first[r]] = r;
    a.next[first[r] ^ 1u] = first[r == 0 ? d - 1 : r - 1];
  }
}

constexpr std::size_t kManyVertices = 4000;  // from here on ranges of them are sorted at once

}  // namespace

// Angles run over [-90, 90] for those that go right, [90, 270] for the others; both ends occur where a circle starts
// with a vertical tangent.
bool comes_before(const Geometry& g, Index point, bool left, exact::Heading first, std::int8_t first_half,
                  exact::Heading second) {
  int t = turn(g, point, first, second);
  if (t != 0) return t > 0;
  if (along(g, point, first, second) < 0) return first_half == (left ? 1 : -1);  // opposite vertical tangents
  return compare_curvature(g, first, second) < 0;
}

void sort_around_vertices(Arrangement& a) {
  Index n = a.vertex_count(), m = a.edge_count();
  a.out_start.assign(n + 1, 0);
  for (const auto& e : a.edges) {
    ++a.out_start[e.v0 + 1];
    ++a.out_start[e.v1 + 1];
  }
  for (Index v = 0; v < n; ++v) a.out_start[v + 1] += a.out_start[v];
  a.out.resize(2 * m);
  ArenaVector<Index> at(a.out_start.begin(), a.out_start.end() - 1, a.out.get_allocator());
  for (Index e = 0; e < m; ++e) a.out[at[a.edges[e].v0]++] = 2 * e;  // right-going first
  for (Index e = 0; e < m; ++e) a.out[at[a.edges[e].v1]++] = 2 * e + 1;
  a.rank.resize(2 * m);
  a.next.resize(2 * m);
  in_ranges(n, kManyVertices, [&](IndexRange vertices) {
    for (std::size_t v = vertices.first; v < vertices.end; ++v) sort_around(a, Index(v));
  });
}

}  // namespace findspace::plane
