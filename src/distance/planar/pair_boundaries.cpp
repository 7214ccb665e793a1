// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/pair_boundaries.h"

#include <algorithm>
#include <cmath>

#include "plane/base/real_vector.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::operator+;
using plane::operator-;
using plane::Index;
using plane::Region;

namespace {

/// Vertex v of one shape, moved by p, lies in the set.
bool is_inside(const FeatureTree& of, Index v, const FeatureTree& set, const RealPoint& p) {
  const exact::Point& at = of.region().point(v);
  double x = at.x + near_value(p.x), y = at.y + near_value(p.y);
  if (auto in = set.contains(x, y, set.nearest(x, y))) return *in;
  return mark_of(set.region(), locate(set.region(), of.region().geometry.exact(of.region().vertices[v].point) + p)) > 0;
}

/// Every piece of the boundary of `inner`, moved by p, lies in the set: 1; none does: -1; else 0.
int pieces_inside(const FeatureTree& inner, const FeatureTree& set, const RealPoint& p) {
  const auto near = inner.representatives_in(set, near_value(p.x), near_value(p.y));
  int found = near.size() < inner.representatives().size() ? -1 : 0;
  for (Index v : near) {
    int side = is_inside(inner, v, set, p) ? 1 : -1;
    if (found != 0 && found != side) return 0;
    found = side;
  }
  return found;
}

}  // namespace

PairBoundaries::Shape::Shape(const Region& r)
    : boxed(r),
      has_boundary(std::any_of(r.edges.begin(), r.edges.end(), [](const auto& e) { return e.mark > 0; }) ||
                   std::any_of(r.vertices.begin(), r.vertices.end(), [](const auto& v) { return v.mark > 0; })) {}

const PairBoundaries::Prepared& PairBoundaries::Shape::prepared() const {
  std::call_once(made, [&] { known.emplace(boxed.region); });
  return *known;
}

PairBoundaries::PairBoundaries(const Region& b, const Region& a) : shapes_{Shape(b), Shape(a)} {}

bool PairBoundaries::bounded() const {
  return plane::is_bounded(shapes_[0].boxed.region) && plane::is_bounded(shapes_[1].boxed.region);
}

double PairBoundaries::scale(const RealPoint& p) const {
  return moving().scale() + fixed().scale() + std::abs(near_value(p.x)) + std::abs(near_value(p.y));
}

Standing PairBoundaries::standing(const RealPoint& p) const {
  using Kind = Standing::Kind;
  if (moving().empty() || fixed().empty()) return {Kind::kClose, std::nullopt};
  auto pair = nearest_pair(fixed(), moving(), p);
  if (!pair) return {Kind::kClose, std::nullopt};
  int in_fixed = pieces_inside(moving(), fixed(), p), in_moving = pieces_inside(fixed(), moving(), -p);
  // Boundaries that do not meet: what one piece of a boundary does, all around it does.
  Kind kind = in_fixed < 0 && in_moving < 0   ? Kind::kApart
              : in_fixed > 0 && in_moving < 0 ? Kind::kInside
              : in_fixed < 0 && in_moving > 0 ? Kind::kAround
                                              : Kind::kMixed;
  return {kind, std::move(pair)};
}

std::vector<Feature> PairBoundaries::corner_features(bool moves, Index v, const RealPoint& p) const {
  const Region& of = shapes_[moves ? 0 : 1].boxed.region;
  RealPoint place = of.geometry.exact(of.vertices[v].point);
  if (moves) place = place + p;
  const Feature corner{moves, plane::Cell{0, v}, place}, inside{!moves, plane::Cell{2, 0}, place};
  return moves ? std::vector{corner, inside} : std::vector{inside, corner};
}

std::vector<Feature> PairBoundaries::common_point(const Standing& s, const RealPoint& p) const {
  if (s.kind == Standing::Kind::kClose) return features(distance::common_point(fixed(), moving(), p));
  for (bool moves : {true, false}) {
    const FeatureTree &inner = moves ? moving() : fixed(), &set = moves ? fixed() : moving();
    const exact::RealPoint by = moves ? p : -p;
    for (Index v : inner.representatives_in(set, near_value(by.x), near_value(by.y))) {
      if (is_inside(inner, v, set, by)) return corner_features(moves, v, p);
    }
  }
  return {};
}

std::optional<PlanarAnswer> PairBoundaries::common_corner(const RealPoint& p) const {
  for (bool moves : {true, false}) {
    const Boxed &of = shapes_[moves ? 0 : 1].boxed, &in = shapes_[moves ? 1 : 0].boxed;
    const double sign = moves ? 1 : -1;
    auto v = vertex_within(of, in, sign * near_value(p.x), sign * near_value(p.y));
    if (v) return boundary_answer(Real(), corner_features(moves, *v, p));
  }
  return std::nullopt;
}

std::optional<PlanarAnswer> PairBoundaries::diameter(const RealPoint& p) const {
  if (!bounded()) return std::nullopt;
  std::call_once(diameters_made_, [&] {
    const RealPoint origin{Real(), Real()};
    diameters_ = {farthest_pair(fixed(), fixed(), origin), farthest_pair(moving(), moving(), origin)};
  });
  FeaturePair k = farthest_pair(fixed(), moving(), p);
  PlanarAnswer m = boundary_answer(k.distance, features(k));
  for (int i = 0; i < 2; ++i) {
    const FeaturePair& own = *diameters_[std::size_t(i)];
    if (own.distance <= m.value) continue;
    RealPoint by = i ? p : RealPoint{Real(), Real()};
    m.value = own.distance;
    m.witness = {{i == 1, own.first_cell, own.first + by}, {i == 1, own.second_cell, own.second + by}};
  }
  return m;
}

}  // namespace findspace::distance
