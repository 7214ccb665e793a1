// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The boundary of a region as users walk it, and points from its inside.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "api/values/limits.h"
#include "api/values/region_data.h"
#include "findspace/error.h"
#include "plane/query/summary_connect.h"

namespace findspace {

using plane::CurveNet;
using plane::Index;
using plane::kNone;

namespace api {
namespace {

/// Cells of a region by component: which of the summary's each connected set is.
class Parts {
 public:
  Parts(const plane::Region& region, const plane::Summary& summary)
      : connection_(plane::connect(region)), part_(connection_.count(), kNone) {
    plane::Locator locator(region);
    for (Index k = 0; k < summary.components.size(); ++k)
      part_[of(locator.locate(summary.components[k].sample_point))] = k;
  }
  /// kNone for those that do not belong.
  Index of_face(Index f) const { return part_[connection_.faces[f]]; }
  Index of_edge(Index e) const { return part_[connection_.edges[e]]; }
  Index of_vertex(Index v) const { return part_[connection_.vertices[v]]; }

 private:
  Index of(plane::Cell cell) const {
    return cell.dimension == 2   ? connection_.faces[cell.index]
           : cell.dimension == 1 ? connection_.edges[cell.index]
                                 : connection_.vertices[cell.index];
  }

  plane::Connection connection_;
  std::vector<Index> part_;
};

Region::Ring public_ring(const CurveNet::Ring& ring) {
  Region::Ring out;
  out.reserve(ring.size());
  for (const CurveNet::Side& s : ring) out.push_back({s.curve, s.forward});
  return out;
}

Region::Component public_component(const plane::Component& c) {
  Region::Component out;
  out.dimension = c.dimension;
  out.area = c.area;
  out.holes = std::size_t(c.holes);
  out.sample = c.sample;
  if (c.bbox) out.bounds = Bounds{c.bbox->low, c.bbox->high};
  return out;
}

Region::Edge public_edge(const plane::Region& region, const CurveNet& net, const CurveNet::Curve& k) {
  const Index h = k.first;
  Region::Edge e;
  e.start = net.number(k.from);
  e.end = net.number(k.to);
  e.belongs = k.mark > 0;
  e.left_belongs = region.faces[region.face(h)].mark > 0;
  e.right_belongs = region.faces[region.face(plane::CellComplex::twin(h))].mark > 0;
  e.arc = k.arc;
  e.center = k.center;
  e.radius = k.radius;
  if (k.arc) e.angle = net.angle(k);
  return e;
}

}  // namespace

Walk::Walk(const plane::Region& region, const plane::Summary& summary, const exact::Real& step) : net(region, step) {
  for (const Index v : net.vertices()) vertices.push_back({net.at(v), region.vertices[v].mark > 0});
  for (const CurveNet::Curve& k : net.curves()) edges.push_back(public_edge(region, net, k));
  for (const plane::Component& c : summary.components) components.push_back(public_component(c));
  if (components.empty()) return;
  const Parts parts(region, summary);
  for (Index f = 0; f < region.faces.size(); ++f) {
    const Index part = parts.of_face(f);
    if (part == kNone) continue;
    const plane::Face& face = region.faces[f];
    if (face.outer != kNone) components[part].rings.push_back(public_ring(net.ring(face.outer)));
    for (const Index h : face.inner) components[part].rings.push_back(public_ring(net.ring(h)));
  }
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const Region::Edge& e = edges[k];
    if (!e.belongs || e.left_belongs || e.right_belongs) continue;
    components[parts.of_edge(net.curves()[k].first / 2)].curves.push_back(k);
  }
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const Index v = net.vertices()[k];
    if (vertices[k].belongs && region.vertices[v].out == kNone && region.faces[region.vertices[v].face].mark <= 0)
      components[parts.of_vertex(v)].isolated.push_back(k);
  }
}

}  // namespace api

namespace api {

void add_arc(const Region::Edge& e, const Position& from, bool forward, double bound, bool around,
             std::vector<Position>& out) {
  // A chord of angle 2t is r (1 - cos t) from its arc, a corner of tangents r (1 / cos t - 1).
  const double ratio = bound / e.radius;
  const double half = around ? std::acos(1 / (1 + ratio)) : std::acos(std::max(0.0, 1 - ratio));
  const double pieces = std::max(e.angle > std::numbers::pi ? 3.0 : 1.0, std::ceil(e.angle / (2 * half)));
  const double start = std::atan2(from[1] - e.center[1], from[0] - e.center[0]), turn = forward ? 1 : -1;
  const double r = around ? e.radius / std::cos(e.angle / (2 * pieces)) : e.radius;
  for (double k = around ? 0.5 : 1; k < pieces; ++k) {
    const double t = start + turn * e.angle * k / pieces;
    out.push_back({e.center[0] + r * std::cos(t), e.center[1] + r * std::sin(t)});
  }
}

}  // namespace api

std::vector<std::vector<Position>> Region::flattened(double bound, Towards side) const {
  if (!(bound > 0)) throw Error(ErrorCode::kBadValue, "the bound must be more than 0");
  std::vector<std::vector<Position>> out;
  for (const Component& part : components()) {
    for (const Ring& ring : part.rings) {
      std::vector<Position>& points = out.emplace_back();
      for (const Side& s : ring) {
        const Edge& e = edges()[s.edge];
        const Position from = vertices()[s.forward ? e.start : e.end].at;
        points.push_back(from);
        // The set lies to the left; an arc that bends to it there is a bulge of the set.
        const bool bulge = s.forward;
        const bool around = side != Towards::kOnArcs && bulge == (side == Towards::kOutside);
        if (e.arc) api::add_arc(e, from, s.forward, bound, around, points);
      }
    }
  }
  return out;
}

namespace {

/// Points of an open region; the check of this thread is asked now and then.
std::vector<Position> sampled(const Region& inside, std::size_t count, std::uint64_t seed) {
  constexpr std::size_t kBetweenPolls = 256;
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (double(random() >> 11) / double(std::uint64_t(1) << 53));
  };
  const std::vector<Region::Component>& parts = inside.components();
  std::vector<double> up_to;  // the area of the parts so far
  for (const Region::Component& c : parts) up_to.push_back((up_to.empty() ? 0 : up_to.back()) + *c.area);
  std::vector<Position> out;
  for (std::size_t tried = 0; out.size() < count;) {
    const auto part = std::upper_bound(up_to.begin(), up_to.end() - 1, uniform(0, up_to.back())) - up_to.begin();
    const Bounds& box = *parts[std::size_t(part)].bounds;
    for (bool found = false; !found; ++tried) {
      if (tried % kBetweenPolls == 0) plane::stop_check()->poll();
      const Position p{uniform(box.low[0], box.high[0]), uniform(box.low[1], box.high[1])};
      found = inside.contains(p);
      if (found) out.push_back(p);
    }
  }
  return out;
}

}  // namespace

std::vector<Position> Region::sample(std::size_t count, const Options& options) const {
  if (!area() || !(*area() > 0))
    throw Error(ErrorCode::kUnsupported, "points are drawn from bounded regions with an area");
  return api::limited(options, [&] { return sampled(interior(), count, options.seed); });
}

}  // namespace findspace
