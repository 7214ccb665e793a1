// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/offset/plain_sum.h"

#include <utility>
#include <vector>

#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/complex/simplify.h"
#include "plane/offset/level.h"
#include "plane/query/topology.h"
#include "plane/sum/curve_sums.h"
#include "plane/sum/minkowski.h"
#include "plane/walk/unite.h"

namespace findspace::plane {
namespace {

Region inside(SignMap map) {
  return remark(std::move(map), [](Mark m) { return Mark(m < 0); });
}

Region not_outside(SignMap map) {
  return remark(std::move(map), [](Mark m) { return Mark(m <= 0); });
}

/// Edges of the set with no face of the set beside them, each closed and by itself.
std::vector<Region> lonely_edges(const Region& r) {
  std::vector<Region> found;
  for (Index e = 0; e < r.edges.size(); ++e) {
    if (r.edges[e].mark <= 0 || r.faces[r.face(2 * e)].mark > 0 || r.faces[r.face(2 * e + 1)].mark > 0) continue;
    Region only = r;
    for (Face& f : only.faces) f.mark = 0;
    for (Vertex& v : only.vertices) v.mark = 0;
    for (Edge& f : only.edges) f.mark = 0;
    only.edges[e].mark = only.vertices[r.edges[e].v0].mark = only.vertices[r.edges[e].v1].mark = 1;
    found.push_back(simplify(std::move(only)));
  }
  return found;
}

Region mixed_sum(const Region& a, const Region& b) {
  std::vector<Region> parts{plain_sum(interior(a), closure(b)), plain_sum(closure(a), interior(b)), curve_sums(a, b)};
  std::vector<Region> a_edges = lonely_edges(a), b_edges = a_edges.empty() ? a_edges : lonely_edges(b);
  for (const Region& e : a_edges)
    for (const Region& f : b_edges) parts.push_back(interior(minkowski_sum(e, f)));
  std::vector<const Region*> all;
  for (const Region& part : parts) all.push_back(&part);
  return unite(all);
}

}  // namespace

Region plain_sum(const Region& a, const Region& b) {
  if (is_empty(a) || is_empty(b)) return CellComplex::uniform(0);
  if (!is_bounded(a) && !is_bounded(b)) return CellComplex::uniform(1);  // both hold everything far away
  if (!is_bounded(b)) return plain_sum(b, a);
  bool a_open = is_open(a), b_open = is_open(b);
  if (a_open || b_open) return inside(contact_map(a_open ? a : closure(a), mirrored(b_open ? b : closure(b))));
  return is_closed(a) && is_closed(b) ? minkowski_sum(a, b) : mixed_sum(a, b);
}

Region plain_difference(const Region& a, const Region& b) { return complement(plain_sum(complement(a), b)); }

Region plain_offset(const Region& a, const exact::Real& distance) {
  int side = distance.sign();
  if (side == 0) return a;
  if (side > 0) return not_outside(distance_map(closure(a), distance));
  if (!is_open(a) && !is_closed(a)) return plain_difference(a, region_of_disc(0, 0, -distance));
  SignMap map = distance_map(closure(complement(a)), -distance);
  return complement(is_closed(a) ? inside(std::move(map)) : not_outside(std::move(map)));
}

}  // namespace findspace::plane
