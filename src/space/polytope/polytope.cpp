// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/polytope/polytope.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <utility>

namespace findspace::space {
namespace {

/// Joins every half-edge with the one that runs the other way, by sorting both under the same key.
void join_twins(std::vector<HalfEdge>& half_edges) {
  std::vector<std::pair<std::uint64_t, int>> keys;
  keys.reserve(half_edges.size());
  for (int h = 0; h < static_cast<int>(half_edges.size()); ++h) {
    const auto a = static_cast<std::uint64_t>(half_edges[h].origin);
    const auto b = static_cast<std::uint64_t>(half_edges[h].target);
    keys.emplace_back(std::min(a, b) << 32 | std::max(a, b), h);
  }
  std::sort(keys.begin(), keys.end());
  for (std::size_t i = 0; i + 1 < keys.size(); i += 2) {
    assert(keys[i].first == keys[i + 1].first);
    half_edges[keys[i].second].twin = keys[i + 1].second;
    half_edges[keys[i + 1].second].twin = keys[i].second;
  }
}

Plane plane_through(const Point& a, const Point& b, const Point& c) {
  const Wide3 normal = exact::primitive(exact::cross(b - a, c - a));
  return {normal, -exact::dot(normal, a)};
}

}  // namespace

Polytope PolytopeBuilder::build(std::vector<Point> vertices, const std::vector<std::vector<int>>& circuits) {
  Polytope p;
  p.vertices_ = std::move(vertices);
  p.outgoing_.assign(p.vertices_.size(), -1);
  p.first_.push_back(0);
  for (int f = 0; f < static_cast<int>(circuits.size()); ++f) {
    const std::vector<int>& ring = circuits[f];
    const int begin = p.first_.back(), size = static_cast<int>(ring.size());
    for (int i = 0; i < size; ++i) {
      const int after = i + 1 == size ? 0 : i + 1;
      p.half_edges_.push_back({ring[i], ring[after], -1, begin + after, -1, f, -1});
      p.outgoing_[ring[i]] = begin + i;
    }
    p.first_.push_back(begin + size);
    // A strictly convex circuit: any three of its vertices span the plane, in its sense.
    p.planes_.push_back(plane_through(p.vertices_[ring[0]], p.vertices_[ring[1]], p.vertices_[ring[2]]));
    p.normal_approx_.push_back(exact::approx(p.planes_.back().normal));
  }
  join_twins(p.half_edges_);
  for (const Point& v : p.vertices_) p.vertex_approx_.push_back(exact::approx(v));
  for (HalfEdge& h : p.half_edges_) {
    h.turn = p.half_edges_[h.twin].next;
    h.right = p.half_edges_[h.twin].facet;
    p.edge_approx_.push_back(p.vertex_approx_[h.target] - p.vertex_approx_[h.origin]);
  }
  return p;
}

std::vector<int> Polytope::circuit(int f) const {
  std::vector<int> ring;
  for (int h = first_[f]; h < first_[f + 1]; ++h) ring.push_back(half_edges_[h].origin);
  return ring;
}

Polytope Polytope::translated(const Point& t) const {
  Polytope p = *this;
  for (std::size_t i = 0; i < p.vertices_.size(); ++i) {
    p.vertices_[i] = p.vertices_[i] + t;
    p.vertex_approx_[i] = exact::approx(p.vertices_[i]);
  }
  for (Plane& plane : p.planes_) plane.offset -= exact::dot(plane.normal, t);
  return p;
}

Polytope Polytope::mirrored() const {
  std::vector<Point> points;
  for (const Point& v : vertices_) points.push_back(-v);
  std::vector<std::vector<int>> circuits;
  for (int f = 0; f < facet_count(); ++f) {
    circuits.push_back(circuit(f));
    std::reverse(circuits.back().begin(), circuits.back().end());
  }
  return PolytopeBuilder::build(std::move(points), circuits);
}

double Polytope::volume() const {
  const Point base = vertices_[0];
  double six = 0;
  for (int f = 0; f < facet_count(); ++f) {
    const Point a = vertices_[half_edges_[first_[f]].origin];
    for (int h = first_[f] + 1; h + 1 < first_[f + 1]; ++h) {
      const Point b = vertices_[half_edges_[h].origin], c = vertices_[half_edges_[h + 1].origin];
      six += static_cast<double>(exact::dot(exact::cross(b - a, c - a), a - base));
    }
  }
  return six / 6;
}

}  // namespace findspace::space
