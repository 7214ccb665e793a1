// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/contour/alike.h"

#include <algorithm>
#include <map>
#include <optional>

namespace findspace::plane {
namespace {

using exact::Real;

/// A shape whose least corner, or whose centre, lies in the origin: corners, and what tells edges of the same corners
/// apart.
struct Drawn {
  std::vector<std::int64_t> corners;  // of all rings, each led by how many they are
  std::vector<Real> arcs;             // centre and radius of each arc
  std::vector<int> kinds;             // of edges: 0 a segment, 1 and -1 an arc
};

bool less_start(const ContourEdge& a, const ContourEdge& b) { return a.start < b.start; }

Contour from_least_corner(Contour ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), less_start), ring.end());
  return ring;
}

/// Nothing where the shape is of another kind.
std::optional<Drawn> drawn(const Shape& shape) {
  Drawn out;
  if (shape.kind == Shape::Kind::kDisc) {
    out.arcs.push_back(shape.amount);
    return out;
  }
  if (shape.kind != Shape::Kind::kRings || shape.contours.empty()) return std::nullopt;
  std::vector<Contour> rings;
  for (const Contour& ring : shape.contours) rings.push_back(from_least_corner(ring));
  std::sort(rings.begin() + 1, rings.end(),
            [](const Contour& a, const Contour& b) { return less_start(a.front(), b.front()); });
  const GridPoint origin = rings[0].front().start;
  for (const Contour& ring : rings) {
    out.corners.push_back(std::int64_t(ring.size()));
    for (const ContourEdge& edge : ring) {
      out.corners.insert(out.corners.end(), {edge.start.x - origin.x, edge.start.y - origin.y});
      out.kinds.push_back(!edge.arc ? 0 : edge.ccw ? 1 : -1);
      if (edge.arc)
        out.arcs.insert(out.arcs.end(), {edge.arc->cx - Real(origin.x), edge.arc->cy - Real(origin.y), edge.arc->r});
    }
  }
  return out;
}

}  // namespace

std::vector<std::size_t> first_alike(std::span<const ShapePtr> shapes) {
  struct Known {
    Drawn drawn;
    std::size_t first;
  };
  std::map<std::vector<std::int64_t>, std::vector<Known>> known;
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    out.push_back(k);
    std::optional<Drawn> here = drawn(*shapes[k]);
    if (!here) continue;
    std::vector<Known>& near = known[here->corners];
    const auto same = std::find_if(near.begin(), near.end(), [&](const Known& other) {
      return other.drawn.kinds == here->kinds && other.drawn.arcs == here->arcs;
    });
    if (same == near.end())
      near.push_back({*std::move(here), k});
    else
      out.back() = same->first;
  }
  return out;
}

}  // namespace findspace::plane
