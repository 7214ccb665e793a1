// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/signed_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "distance/planar_features/near_parts.h"
#include "distance/planar_features/window_distance.h"
#include "exact/margins/planar_distance.h"
#include "exact/margins/rounding.h"
#include "plane/complex/extent.h"
#include "plane/complex/overlay.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Mark;
using plane::SignMap;

namespace {

/// From here on a base is not kept beside the first level: it is made again if a second question needs it.
constexpr std::size_t kManyEdges = 200'000;
/// Where more show in a window, a map of the whole plane may cost less.
constexpr std::size_t kMostEdges = 12;
/// Of a map, and values of it, from where on places are found by tables.
constexpr std::size_t kEdgesToPrepare = 64;
constexpr int kValuesAtOnce = 16;

bool is_not_outside(Mark m) { return m <= 0; }
bool is_not_inside(Mark m) { return m >= 0; }

}  // namespace

SignedDistance::SignedDistance(SignMap base) : defined_(plane::any_mark(base, [](Mark m) { return m <= 0; })) {
  base_->map = std::move(base);
}

SignedDistance SignedDistance::gamma1(plane::SharedRegion b, plane::SharedRegion a) {
  SignedDistance out;
  out.defined_ = !plane::is_empty(a) && !plane::is_empty(b);
  out.base_->of.emplace(std::move(a), std::move(b));
  return out;
}

SignedDistance SignedDistance::eta1(const plane::Region& b, const plane::Region& a) {
  return SignedDistance(containment_map(a, b));
}

SignedDistance SignedDistance::delta1(const plane::Region& b, const plane::Region& a) {
  // A lies in B + p where A - p lies in B.
  return SignedDistance(mirrored(containment_map(b, a)));
}

const SignMap& SignedDistance::base() const {
  if (!base_->of) return base_->map;
  base_->asked = true;
  std::call_once(base_->made, [this] { base_->map = contact_map(base_->of->first, base_->of->second); });
  return base_->map;
}

SignMap SignedDistance::sign_map(const exact::Real& level) const {
  if (!defined_) return CellComplex::uniform(1);
  if (window_) return level.sign() > 0 ? window_->map(level) : plane::negated(window_->map(-level));
  if (base_->of && !base_->asked.exchange(true)) {
    const plane::Region &fixed = base_->of->first, &moving = base_->of->second;
    if (auto map = contact_level_in_batches(fixed, moving, level)) return *std::move(map);
    if (fixed.edges.size() + moving.edges.size() > kManyEdges) return level_map(contact_map(fixed, moving), level);
  }
  return level_map(base(), level);
}

SignedDistance::Prepared::Prepared(const SignMap& base)
    : cells(base), inside(base, is_not_outside), outside(base, is_not_inside) {}

/// From some values on; nothing where the map is small.
const SignedDistance::Prepared* SignedDistance::prepared() const {
  if (base().edges.size() < kEdgesToPrepare || base_->values.fetch_add(1) < kValuesAtOnce) return nullptr;
  std::call_once(base_->prepared, [this] { base_->many = std::make_shared<const Prepared>(base()); });
  return base_->many.get();
}

std::optional<PlanarAnswer> SignedDistance::value(const exact::RealPoint& p) const {
  if (!defined_) return std::nullopt;
  const Prepared* many = prepared();
  Mark sign = many ? many->cells.mark(p) : mark_of(base(), locate(base(), p));
  if (sign == 0) return exact_answer(exact::Real(), Way::kMap);
  const auto n = many       ? (sign > 0 ? many->inside : many->outside).nearest(p)
                 : sign > 0 ? nearest(base(), is_not_outside, p)
                            : nearest(base(), is_not_inside, p);
  if (!n) return lowest_answer(Way::kMap);  // inside everywhere
  return exact_answer(sign > 0 ? n->distance : -n->distance, Way::kMap, std::optional(n->at));
}

std::optional<std::vector<SmoothForm>> SignedDistance::forms(const RealPoint& p, double radius) const {
  if (!defined_) return std::nullopt;
  std::call_once(sides_.made, [this] {
    sides_.outside = std::make_unique<const BoundaryForms>(base(), 1);
    sides_.inside = std::make_unique<const BoundaryForms>(base(), -1);
  });
  const double x = near_value(p.x), y = near_value(p.y);
  const Mark at = mark_of(base(), locate(base(), p));
  std::vector<SmoothForm> out;
  for (const int sign : {1, -1}) {
    const BoundaryForms& side = sign > 0 ? *sides_.outside : *sides_.inside;
    // The disc has positions on the other side only if the boundary is within its radius.
    const double other = at * sign < 0 ? (sign < 0 ? *sides_.outside : *sides_.inside).nearest(x, y) : 0;
    if (other <= radius * margin::kUpward) side.add_forms(x, y, radius, out);
  }
  return out;
}

std::optional<TDistance::Size> SignedDistance::size() const {
  if (!defined_) return std::nullopt;
  Size out{base().edges.size(), std::nullopt};
  if (const auto box = plane::extent(base()); box && base().faces[0].mark > 0)
    out.reach = plain_length(std::max(-box->x0, box->x1), std::max(-box->y0, box->y1)) * margin::kUpward;
  return out;
}

TDistancePointer SignedDistance::near(const plane::PieceBox& window, double low, double high) const {
  const PlacedWindow w(window);
  const int sign = low > 0 ? 1 : -1;
  if (low <= 0 && high >= 0) return nullptr;
  // Where f has one sign, the nearest edges of the other side tell it.
  const auto middle = value({Real::from_double(w.x), Real::from_double(w.y)});
  if (!middle || middle->minus_infinity || sign * near_value(middle->value) <= w.radius + w.noise(1)) return nullptr;
  const double most = sign > 0 ? high : -low, reach = (most + w.radius) * margin::kUpward + w.noise(most);
  std::vector<plane::Cell> chosen;
  for (const BoundaryFeature& s : distance::features(base(), [sign](Mark m) { return m * sign <= 0; }))
    if (s.distance(w.x, w.y) <= reach) chosen.push_back(s.cell);
  auto out = std::make_shared<SignedDistance>(boundary_alone(base(), chosen, 0, Mark(sign)));
  const auto edges = plane::remark(out->base(), [](Mark m) { return Mark(m == 0); });
  if (WindowDistance::edges_seen(edges, window) > kMostEdges) return nullptr;
  out->window_ = std::make_shared<const WindowDistance>(edges, window);
  return out;
}

RealPoint SignedDistance::seed() const {
  if (base().vertices.empty()) return {Real(), Real()};
  return base().geometry.exact(base().vertices[0].point);
}

namespace {

/// Calls see(feature) for those whose mark times the sign is not positive; they are made anew each time, as a list of
/// all takes more memory than the set.
template <class See>
void each_feature(const plane::CellComplex& c, int sign, See&& see) {
  for (plane::Index v = 0; v < c.vertices.size(); ++v)
    if (c.vertices[v].mark * sign <= 0) see(vertex_feature(c, v));
  for (plane::Index e = 0; e < c.edges.size(); ++e)
    if (c.edges[e].mark * sign <= 0) see(edge_feature(c, e));
}

}  // namespace

std::vector<NearLevelCurve> SignedDistance::level_curves(const RealPoint& p, double tolerance) const {
  double x = near_value(p.x), y = near_value(p.y);
  Mark at = mark_of(base(), locate(base(), p));
  std::vector<NearLevelCurve> out;
  for (int sign : {-1, 1}) {
    // Outside the distance to marks <= 0 counts, inside minus that to marks >= 0.
    if (at * sign < 0) continue;
    double least = std::numeric_limits<double>::infinity();
    each_feature(base(), sign, [&](const BoundaryFeature& s) { least = std::min(least, s.distance(x, y)); });
    each_feature(base(), sign, [&](const BoundaryFeature& s) {
      const double gap = s.distance(x, y) - least;
      if (gap <= tolerance) out.push_back({near_level_curve(base(), s, x, y, sign), gap});
    });
  }
  return out;
}

}  // namespace findspace::distance
