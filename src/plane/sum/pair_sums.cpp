// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/sum/pair_sums.h"

#include <algorithm>
#include <cmath>

#include "plane/base/parallel.h"
#include "plane/base/release.h"
#include "plane/complex/arrangement.h"
#include "plane/complex/observe_pieces.h"
#include "plane/sum/merged_pieces.h"
#include "plane/sum/sum_mask.h"

namespace findspace::plane {
namespace {

/// Could a set as large as `around` go round one as large as `inner`?
bool fits(const Extent& inner, const Extent& around) {
  return inner.x1 - inner.x0 - 4 <= around.x1 - around.x0 && inner.y1 - inner.y0 - 4 <= around.y1 - around.y0;
}

bool can_enclose(const Part& ring, const Part& other) {
  return std::any_of(ring.holes.begin(), ring.holes.end(),
                     [&](const Extent& hole) { return other.unbounded || fits(hole, other.filled); });
}

exact::Real reach_of(const Part& p) {
  return exact::Real::from_double(std::ceil(std::hypot(p.filled.x1 - p.filled.x0, p.filled.y1 - p.filled.y0))) +
         exact::Real(2);
}

constexpr std::size_t kManyPieces = 1000;  // from here on those that need not be arranged are looked for
constexpr std::size_t kManyCells = 4000;   // edges: from here on ranges of cells are marked at once

/// -1 where the number is positive, 0 beside a face where it is, else 1.
Marks marks_of_open_sum(const Arrangement& a, Windings w) {
  Marks m;
  m.faces.reserve(w.faces.size());
  for (auto k : w.faces) m.faces.push_back(k > 0 ? -1 : 1);
  m.edges.resize(a.edge_count());
  m.vertices.resize(a.vertex_count());
  in_ranges(a.edge_count(), kManyCells, [&](IndexRange edges) {
    for (std::size_t e = edges.first; e < edges.end; ++e) {
      bool beside = w.faces[a.face[2 * e]] > 0 || w.faces[a.face[2 * e + 1]] > 0;
      m.edges[e] = w.edges[e] > 0 ? -1 : beside ? 0 : 1;
    }
  });
  in_ranges(a.vertex_count(), kManyCells, [&](IndexRange vertices) {
    for (auto v = Index(vertices.first); v < vertices.end; ++v) {
      bool beside = w.faces[a.some_face(v)] > 0;
      for (Index k = a.out_start[v]; !beside && k < a.out_start[v + 1]; ++k) beside = w.faces[a.face[a.out[k]]] > 0;
      m.vertices[v] = w.vertices[v] > 0 ? -1 : beside ? 0 : 1;
    }
  });
  return m;
}

/// Of an arrangement whose cells are numbered, what extract() does not read.
void drop_pieces(Arrangement& a) {
  release(a.pieces);
  for (auto* list : {&a.point_vertex, &a.cover_start, &a.cover, &a.chain_start, &a.chain, &a.rank}) release(*list);
}

}  // namespace

std::vector<Part> Operand::oriented(std::vector<Part> parts) const {
  if (mirrored)
    for (Part& p : parts) p = plane::mirrored(std::move(p));
  return parts;
}

SumOfPairs::SumOfPairs(bool open, exact::Geometry geometry) : builder_(open) {
  builder_.curves.geometry = std::move(geometry);
}

void SumOfPairs::add(const Part& a, const Part& b) {
  const Part* p = &a;
  const Part* q = &b;
  Part a_bridged, b_bridged;
  // A curve goes round nothing, and it could lie in a bridge.
  if (!b.flat && can_enclose(a, b)) p = &(a_bridged = bridged(a, reach_of(b)));
  if (!a.flat && can_enclose(b, a)) q = &(b_bridged = bridged(b, reach_of(a)));
  if (p->unbounded) base_ += q->euler;
  builder_.add(*p, *q);
}

void SumOfPairs::prune(const Operand& a, const Operand& b) {
  if (builder_.curves.pieces.size() < kManyPieces) return;
  merge_equal_pieces(builder_);
  if (const auto mask = mask_that_pays(builder_, a, b)) inner_ = plane::prune(builder_, *mask, base_);
}

void SumOfPairs::prune(const InnerMask& mask) {
  merge_equal_pieces(builder_);
  inner_ = plane::prune(builder_, mask, base_);
}

SignMap SumOfPairs::open_sum() && {
  std::vector<Index> seeds;
  if (inner_)
    for (const InnerPart::Seed& s : inner_->seeds) seeds.push_back(s.point);
  Arrangement a = arranged(seeds);
  Windings w = inner_ ? windings(a, chains_, corners_, *inner_) : windings(a, chains_, corners_, base_);
  add_circled(a, w);
  for (Index p : lonely_)
    w.vertices[a.point_vertex[p]] -= w.vertices[a.point_vertex[p]] != kUnwanted;  // a missing point
  release(chains_);
  release(corners_);
  drop_pieces(a);
  const Marks m = marks_of_open_sum(a, std::move(w));
  return extract(std::move(a), m);
}

Region SumOfPairs::closed_sum() && {
  Arrangement a = arranged({});
  Windings w = windings(a, chains_, corners_, base_, VertexScope::kAll);
  add_circled(a, w);
  for (Index p : lonely_) w.vertices[a.point_vertex[p]] = 1;
  Marks m;
  for (auto k : w.faces) m.faces.push_back(k > 0);
  for (auto k : w.edges) m.edges.push_back(k > 0);
  for (auto k : w.vertices) m.vertices.push_back(k > 0);
  return extract(std::move(a), m);
}

Arrangement SumOfPairs::arranged(std::span<const Index> more_points) {
  chains_ = std::move(builder_.chains);
  corners_ = std::move(builder_.corners);
  lonely_ = std::move(builder_.points);
  circled_ = std::move(builder_.circled);
  std::vector<Index> isolated = lonely_;
  isolated.insert(isolated.end(), more_points.begin(), more_points.end());
  for (const auto& c : circled_) isolated.push_back(c.point);
  observe_pieces("convolution", "convolution of two sets", builder_.curves.geometry, builder_.curves.pieces);
  return arrange(std::move(builder_.curves.geometry), std::move(builder_.curves.pieces), isolated);
}

void SumOfPairs::add_circled(const Arrangement& a, Windings& w) const {
  for (const auto& c : circled_) {
    std::int32_t& number = w.vertices[a.point_vertex[c.point]];
    if (number != kUnwanted) number += c.rounds;
  }
}

bool SolidSum::holds(exact::Geometry& g, Index point) {
  bool unresolved = false;
  if (index_.holds(g, point, unresolved)) return true;
  if (!unresolved) return false;
  if (!numbers_) build(g);
  return numbers_->at(g, point) > 0;
}

void SolidSum::build(exact::Geometry& g) {
  SumOfPairs sum(true, std::move(g));
  std::vector<Part> q = b_.solid_parts();
  a_.each_solid_part([&](const Part& x) {
    for (const Part& y : q) sum.add(x, y);
  });
  numbers_ = std::move(sum).numbers();
  g = numbers_->take_geometry();
}

}  // namespace findspace::plane
