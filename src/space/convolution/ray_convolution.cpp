// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/ray_convolution.h"

#include <algorithm>
#include <utility>

#include "plane/base/parallel.h"
#include "space/convolution/ray_cones.h"

namespace findspace::space {
namespace {

/// The units of parallel work: fixed, so that the order of facets does not depend on the number of threads.
constexpr std::size_t kBlock = 256;

std::vector<Approx3> unit_normals(const RayBody& body) {
  std::vector<Approx3> units;
  units.reserve(body.faces.size());
  for (const Approx3& n : body.normal_approx) units.push_back(unit(n));
  return units;
}

std::vector<Cone> vertex_cones(const RayBody& body, const std::vector<Approx3>& units) {
  std::vector<Cone> cones;
  std::vector<Approx3> about;
  for (const RayVertex& v : body.vertices) {
    about.clear();
    for (int j = 0; j < v.count; ++j) about.push_back(units[body.corners[v.first + j].face]);
    cones.push_back(cone_of(about));
  }
  return cones;
}

Cone edge_cone(const RayEdge& e, const std::vector<Approx3>& units) {
  const Approx3 two[2] = {units[e.left], units[e.right]};
  return cone_of(two);
}

/// Runs task(k, facets) for k below count in blocks, and puts the facets one after another.
template <class Task>
void in_blocks(std::size_t count, std::vector<RayFacet>& facets, Task task) {
  const std::size_t blocks = (count + kBlock - 1) / kBlock;
  std::vector<std::vector<RayFacet>> parts(blocks);
  plane::parallel_for(blocks, [&](std::size_t b) {
    for (std::size_t k = b * kBlock; k < std::min(count, (b + 1) * kBlock); ++k) task(static_cast<int>(k), parts[b]);
  });
  for (const auto& part : parts) facets.insert(facets.end(), part.begin(), part.end());
}

/// Whether no edge of the vertex rises along n.
bool highest(const RayBody& body, const RayVertex& vertex, const Wide3& n, const Approx3& n_approx) {
  const auto first = body.corners.begin() + vertex.first;
  return std::all_of(first, first + vertex.count, [&](const RayCorner& corner) {
    return exact::sign_dot(n, n_approx, body.points[corner.to] - body.points[vertex.point]) <= 0;
  });
}

/// Faces of `of_faces` with vertices of `of_vertices`; tie: +1 where the faces are those of A.
void faces_with_vertices(const RayBody& of_faces, const std::vector<Approx3>& units, const RayBody& of_vertices,
                         const std::vector<Approx3>& others, int tie, std::vector<RayFacet>& facets) {
  const ConeTree tree(vertex_cones(of_vertices, others));
  in_blocks(of_faces.faces.size(), facets, [&](int f, std::vector<RayFacet>& out) {
    tree.each_meeting({units[f], 0}, [&](int v) {
      const RayVertex& vertex = of_vertices.vertices[v];
      const int index = local_index(of_vertices, vertex, of_faces.normals[f], of_faces.normal_approx[f], tie);
      if (index == 0) return;
      RayFacet facet;
      for (int k = 0; k < 3; ++k) facet.corner[k] = of_faces.corner(f, k) + of_vertices.points[vertex.point];
      facet.weight = index;
      facet.outer = highest(of_vertices, vertex, of_faces.normals[f], of_faces.normal_approx[f]);
      out.push_back(facet);
    });
  });
}

/// The sign of the normal of face f along e, as the moved normals of A have it.
int moved_sign(const RayBody& body, int f, const Point& e, int tie) {
  const int s = exact::sign_dot(body.normals[f], body.normal_approx[f], e);
  return s != 0 ? s : tie * exact::lexicographic_sign(body.normals[f]) * exact::lexicographic_sign(e);
}

void edge_with_edge(const RayBody& a, const RayEdge& e, const RayBody& c, const RayEdge& g,
                    std::vector<RayFacet>& out) {
  const Point u = a.points[e.to] - a.points[e.from], v = c.points[g.to] - c.points[g.from];
  const int left = moved_sign(a, e.left, v, 1), right = moved_sign(a, e.right, v, 1);
  if (left == right) return;
  const int other_left = moved_sign(c, g.left, u, -1), other_right = moved_sign(c, g.right, u, -1);
  if (other_left == other_right) return;
  // The arcs meet the line of u x v at -right * bend and at other_right * bend of it; they cross where these agree.
  const int sense = -right * e.bend;
  if (sense != other_right * g.bend) return;
  if (exact::is_zero(exact::cross(u, v))) return;  // without area
  RayFacet facet;
  const Point &p = a.points[e.from], &q = c.points[g.from];
  facet.corner = {p + q, p + q + u, p + q + u + v, p + q + v};
  if (sense < 0) std::swap(facet.corner[1], facet.corner[3]);
  facet.corners = 4;
  facet.weight = e.bend * g.bend;
  facet.outer = e.bend > 0 && g.bend > 0;
  out.push_back(facet);
}

void edges_with_edges(const RayBody& a, const std::vector<Approx3>& a_units, const RayBody& c,
                      const std::vector<Approx3>& c_units, std::vector<RayFacet>& facets) {
  std::vector<Cone> cones;
  std::vector<int> bent;
  for (std::size_t k = 0; k < c.edges.size(); ++k) {
    if (c.edges[k].bend == 0) continue;
    bent.push_back(static_cast<int>(k));
    cones.push_back(edge_cone(c.edges[k], c_units));
  }
  const ConeTree tree(std::move(cones));
  in_blocks(a.edges.size(), facets, [&](int k, std::vector<RayFacet>& out) {
    const RayEdge& e = a.edges[k];
    if (e.bend == 0) return;
    tree.each_meeting(edge_cone(e, a_units), [&](int g) { edge_with_edge(a, e, c, c.edges[bent[g]], out); });
  });
}

}  // namespace

std::vector<RayFacet> convolution(const RayBody& a, const RayBody& c) {
  std::vector<RayFacet> facets;
  const std::vector<Approx3> a_units = unit_normals(a), c_units = unit_normals(c);
  faces_with_vertices(a, a_units, c, c_units, 1, facets);
  faces_with_vertices(c, c_units, a, a_units, -1, facets);
  edges_with_edges(a, a_units, c, c_units, facets);
  return facets;
}

}  // namespace findspace::space
