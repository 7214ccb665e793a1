// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "serve/region_answers.h"

#include "plane/query/curve_net.h"
#include "plane/query/in_order.h"
#include "plane/query/summary_sample.h"
#include "plane/query/topology.h"

namespace findspace::app {
namespace {

using exact::Real;
using exact::RealPoint;

bool is_marked(plane::Mark m) { return m > 0; }

}  // namespace

const plane::Region& RegionAnswers::in_order() const {
  if (!ordered_) ordered_ = plane::in_order(region_);
  return *ordered_;
}

const plane::Region& RegionAnswers::closure() const {
  if (!closure_) closure_ = plane::closure(region_);
  return *closure_;
}

const plane::Region& RegionAnswers::corners() const {
  if (corners_) return *corners_;
  corners_ = closure();
  // A vertex that only joins two pieces of one circle is none.
  const plane::CurveNet net(closure(), step_);
  for (plane::Index v = 0; v < corners_->vertices.size(); ++v)
    if (net.number(v) == plane::kNone) corners_->vertices[v].mark = 0;
  for (plane::Edge& e : corners_->edges) e.mark = 0;
  for (plane::Face& f : corners_->faces) f.mark = 0;
  return *corners_;
}

bool RegionAnswers::has(const RealPoint& p) const {
  if (!in_region_) in_region_.emplace(region_);
  return in_region_->mark(p) > 0;
}

std::optional<RegionAnswers::Near> RegionAnswers::nearest(const RealPoint& p) const {
  if (has(p)) return Near{p, Real(), true};
  if (!in_closure_) in_closure_.emplace(closure());
  if (in_closure_->mark(p) > 0) return Near{p, Real(), false};
  const auto found = plane::nearest(closure(), is_marked, p);
  if (!found) return std::nullopt;
  return Near{found->at, found->distance, has(found->at)};
}

std::optional<RealPoint> RegionAnswers::snapped(const RealPoint& p, const Real& within) const {
  if (!boundary_) boundary_ = plane::boundary(closure());
  const plane::Region& edges = *boundary_;
  for (const plane::Region* set : {&corners(), &edges}) {
    const auto near = plane::nearest(*set, is_marked, p);
    if (near && near->distance <= within && has(near->at)) return near->at;
  }
  return std::nullopt;
}

std::optional<RealPoint> RegionAnswers::sample() const {
  std::optional<plane::Index> vertex;
  for (plane::Index v = 0; v < region_.vertices.size(); ++v) {
    if (region_.vertices[v].mark <= 0) continue;
    if (region_.vertices[v].out == plane::kNone && region_.faces[region_.vertices[v].face].mark <= 0)
      return region_.geometry.exact(region_.vertices[v].point);
    if (!vertex) vertex = v;
  }
  const plane::CellMeasures measures(region_);
  plane::Sampler sampler(region_, measures);
  for (plane::Index f = 1; f < region_.faces.size(); ++f)
    if (region_.faces[f].mark > 0) return sampler.inside_face(f);
  if (vertex) return region_.geometry.exact(region_.vertices[*vertex].point);
  for (plane::Index e = 0; e < region_.edges.size(); ++e)
    if (region_.edges[e].mark > 0) return sampler.middle_of_edge(e);
  if (region_.faces[0].mark > 0) return sampler.inside_face(0);
  return std::nullopt;
}

}  // namespace findspace::app
