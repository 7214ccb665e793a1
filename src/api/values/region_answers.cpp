// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "api/values/region_answers.h"

#include <array>
#include <utility>

#include "plane/complex/overlay.h"
#include "plane/query/curve_net.h"
#include "plane/query/summary_sample.h"
#include "plane/query/topology.h"

namespace findspace::api {
namespace {

using exact::Real;
using exact::RealPoint;
using plane::Index;

bool is_in_set(plane::Mark m) { return m > 0; }

}  // namespace

const plane::Region& RegionAnswers::closure() const {
  std::call_once(closed_, [&] { closure_ = plane::closure(region_); });
  return *closure_;
}

plane::Region RegionAnswers::own_part(plane::Region of) const {
  if (plane::is_closed(region_)) return of;
  return plane::intersect(std::array<const plane::Region*, 2>{&of, &region_});
}

const plane::Region& RegionAnswers::boundary() const {
  std::call_once(bounded_, [&] { boundary_ = own_part(plane::boundary(closure())); });
  return *boundary_;
}

const plane::Region& RegionAnswers::corners() const {
  std::call_once(cornered_, [&] {
    plane::Region corners = closure();
    // A vertex that only joins two pieces of one circle is none.
    const plane::CurveNet net(closure(), step_);
    for (Index v = 0; v < corners.vertices.size(); ++v)
      if (net.number(v) == plane::kNone) corners.vertices[v].mark = 0;
    for (plane::Edge& e : corners.edges) e.mark = 0;
    for (plane::Face& f : corners.faces) f.mark = 0;
    corners_ = own_part(std::move(corners));
  });
  return *corners_;
}

bool RegionAnswers::has(const RealPoint& p) const {
  std::call_once(located_, [&] { in_region_.emplace(region_); });
  return in_region_->mark(p) > 0;
}

std::optional<RegionAnswers::Near> RegionAnswers::nearest(const RealPoint& p) const {
  if (has(p)) return Near{p, Real(), true};
  const auto found = plane::nearest_in_closure(region_, closure(), p);
  if (!found) return std::nullopt;
  return Near{found->nearest.at, found->nearest.distance, found->attained};
}

std::optional<RealPoint> RegionAnswers::snapped(const RealPoint& p, const Real& within) const {
  for (const bool edges : {false, true}) {
    const auto near = plane::nearest(edges ? boundary() : corners(), is_in_set, p);
    if (near && near->distance <= within && has(near->at)) return near->at;
  }
  return std::nullopt;
}

std::optional<RealPoint> position_in(const plane::Region& region) {
  std::optional<Index> vertex;
  for (Index v = 0; v < region.vertices.size(); ++v) {
    if (region.vertices[v].mark <= 0) continue;
    if (region.vertices[v].out == plane::kNone && region.faces[region.vertices[v].face].mark <= 0)
      return region.geometry.exact(region.vertices[v].point);
    if (!vertex) vertex = v;
  }
  const plane::CellMeasures measures(region);
  plane::Sampler sampler(region, measures);
  for (Index f = 1; f < region.faces.size(); ++f)
    if (region.faces[f].mark > 0) return sampler.inside_face(f);
  if (vertex) return region.geometry.exact(region.vertices[*vertex].point);
  for (Index e = 0; e < region.edges.size(); ++e)
    if (region.edges[e].mark > 0) return sampler.middle_of_edge(e);
  if (region.faces[0].mark > 0) return sampler.inside_face(0);
  return std::nullopt;
}

}  // namespace findspace::api
