// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_features/window_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "plane/complex/overlay.h"
#include "plane/offset/level.h"

namespace findspace::distance {

using exact::Real;
using plane::CellComplex;
using plane::Index;
using plane::Mark;
using plane::SignMap;

namespace {

/// The end of a straight edge that is its nearest point for all of the window.
std::optional<Index> nearest_end(const plane::Region& edges, Index e, const PlacedWindow& w) {
  const BoundaryFeature s = edge_feature(edges, e);
  if (s.arc) return std::nullopt;
  const double dx = s.x1 - s.x0, dy = s.y1 - s.y0, length = plain_length(dx, dy);
  const double along = ((w.x - s.x0) * dx + (w.y - s.y0) * dy) / length;
  const double off = w.radius + w.noise(std::abs(along) + length);
  if (along + off < 0) return edges.edges[e].v0;
  if (along - off > length) return edges.edges[e].v1;
  return std::nullopt;
}

}  // namespace

std::size_t WindowDistance::edges_seen(const plane::Region& edges, const plane::PieceBox& window) {
  const PlacedWindow placed(window);
  std::size_t seen = 0;
  for (Index e = 0; e < edges.edges.size(); ++e)
    if (edges.edges[e].mark > 0 && !nearest_end(edges, e, placed)) ++seen;
  return seen;
}

WindowDistance::WindowDistance(const plane::Region& edges, const plane::PieceBox& window)
    : window_(window), filled_(region_of_boxes({&window, 1})) {
  std::vector<char> counts(edges.vertices.size());
  const auto add = [&](const BoundaryFeature& s) {
    parts_.push_back({boundary_alone(edges, {&s.cell, 1}, 1, 0), s.distance(window_.x, window_.y)});
  };
  for (Index e = 0; e < edges.edges.size(); ++e) {
    if (edges.edges[e].mark <= 0) continue;
    if (const auto end = nearest_end(edges, e, window_)) {
      counts[*end] = 1;
      continue;
    }
    add(edge_feature(edges, e));
  }
  for (Index v = 0; v < edges.vertices.size(); ++v)
    if (edges.vertices[v].mark > 0 && (counts[v] != 0 || edges.vertices[v].out == plane::kNone))
      add(vertex_feature(edges, v));
}

SignMap WindowDistance::map(const Real& radius) const {
  const auto size = radius.interval();
  std::vector<CellComplex> cut;
  for (const Part& part : parts_) {
    const double off = window_.radius + window_.noise(part.distance);
    if (part.distance - off > size.hi) continue;
    if (part.distance + off < size.lo) return CellComplex::uniform(-1);
    const SignMap map = plane::distance_map(part.alone, radius);
    const std::array<const CellComplex*, 2> both{&map, &filled_};
    cut.push_back(plane::overlay(both, [](std::span<const Mark> m) { return m[1] > 0 ? m[0] : Mark(1); }));
  }
  if (cut.empty()) return CellComplex::uniform(1);
  std::vector<const CellComplex*> all;
  for (const CellComplex& c : cut) all.push_back(&c);
  return plane::overlay(all, [](std::span<const Mark> m) { return *std::min_element(m.begin(), m.end()); });
}

}  // namespace findspace::distance
