// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/at_position.h"

#include <algorithm>
#include <cmath>

#include "distance/planar/farthest_place.h"
#include "distance/planar/hausdorff.h"
#include "exact/number/margins.h"
#include "plane/base/real_vector.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::operator+;
using plane::operator-;
using plane::Index;
using plane::is_bounded;
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
  int found = 0;
  for (Index v : inner.representatives()) {
    int side = is_inside(inner, v, set, p) ? 1 : -1;
    if (found != 0 && found != side) return 0;
    found = side;
  }
  return found;
}

}  // namespace

AtPosition::Shape::Shape(const Region& r)
    : boxed(r),
      has_boundary(std::any_of(r.edges.begin(), r.edges.end(), [](const auto& e) { return e.mark > 0; }) ||
                   std::any_of(r.vertices.begin(), r.vertices.end(), [](const auto& v) { return v.mark > 0; })) {}

const AtPosition::Prepared& AtPosition::Shape::prepared() const {
  std::call_once(made, [&] { known.emplace(boxed.region); });
  return *known;
}

AtPosition::AtPosition(std::shared_ptr<const ShapePair> pair)
    : pair_(std::move(pair)),
      searched_(pair_->at_origin() ? pair_->at_origin()->pair : pair_),
      shapes_{Shape(searched_->moving()), Shape(searched_->fixed())} {}

double AtPosition::scale(const RealPoint& p) const {
  const auto& there = pair_->at_origin();
  const RealPoint at = there ? p + there->by : p;
  return moving().scale() + fixed().scale() + std::abs(near_value(at.x)) + std::abs(near_value(at.y));
}

std::optional<Measured> AtPosition::measure(Which which, const RealPoint& p) const {
  const auto& there = pair_->at_origin();
  if (!there) return measured(which, p);
  auto m = measured(which, p + there->by);
  if (!m) return m;
  if (m->nearest) m->nearest = *m->nearest - there->by;
  if (m->farthest) m->farthest = *m->farthest - there->by;
  // The witness, too, is as far away as A was moved.
  for (Feature& f : m->witness) f.at = f.at - there->fixed_by;
  return m;
}

AtPosition::Standing AtPosition::standing(const RealPoint& p) const {
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

const FarthestFromSet& AtPosition::farthest_search(bool back) const {
  std::call_once(searches_made_[back], [&] {
    const Region &b = searched_->moving(), &a = searched_->fixed();
    searches_[back] = std::make_unique<const FarthestFromSet>(back ? a : b, back ? b : a);
  });
  return *searches_[back];
}

/// mu(B + p, A), or mu(A, B + p) if `back`.
std::optional<Measured> AtPosition::directed(bool back, const RealPoint& p, double floor) const {
  const FeatureTree &from = back ? fixed() : moving(), &to = back ? moving() : fixed();
  if (!is_bounded(from.region())) return std::nullopt;
  const RealPoint by = back ? -p : p;
  double scale = from.scale() + to.scale() + std::abs(near_value(p.x)) + std::abs(near_value(p.y));
  auto search = [&](double least) -> std::optional<FarthestPlace> {
    if (!from.has_arcs() && !to.has_arcs())
      return farthest_place(from, to, shapes_[back ? 0 : 1].prepared().boxes, by, least);
    return farthest_search(back).greatest(by, least);
  };
  auto place = search(std::max(scale * margin::kClearlyOut, floor));
  if (!place && floor > scale * margin::kClearlyOut) return Measured{};
  if (!place) {
    Standing s = standing(p);
    if (s.kind == (back ? Standing::Kind::kAround : Standing::Kind::kInside))
      return Measured{-s.pair->distance, std::nullopt, std::nullopt, features(*s.pair)};
    // One touches the other from inside, or all but: containment decides.
    auto margin = signed_value(back ? Which::kDelta1 : Which::kEta1, s, p);
    if (margin && (margin->minus_infinity || margin->value.sign() <= 0)) return margin;
    place = search(scale * margin::kHardlyOut);
    if (!place) return Measured{};
  }
  const FeaturePair near = place->nearest ? *place->nearest : nearest_point(to, place->at);
  Feature out{!back, place->cell, place->at}, in{back, near.first_cell, near.first};
  if (back) {
    out.at = out.at + p;
    in.at = in.at + p;
  }
  Measured m{place->value, std::nullopt, std::nullopt, {out, in}};
  if (back) std::swap(m.witness[0], m.witness[1]);
  return m;
}

bool AtPosition::bounded() const { return is_bounded(searched_->moving()) && is_bounded(searched_->fixed()); }

/// How far B + p (or A, if `back`) sticks out of the other along the line through the middles of their boxes.
double AtPosition::protrudes(bool back, double px, double py) const {
  const FeatureTree &b = moving(), &a = fixed();
  const FeatureBox &s = a.nodes()[0].box, &t = b.nodes()[0].box;
  const double sign = back ? -1 : 1, dx = t.x0 + t.x1 + 2 * px - s.x0 - s.x1, dy = t.y0 + t.y1 + 2 * py - s.y0 - s.y1,
               size = plain_length(dx, dy), ux = size > 0 ? sign * dx / size : 1, uy = size > 0 ? sign * dy / size : 0;
  const double ahead = b.extreme(ux, uy).height + ux * px + uy * py - a.extreme(ux, uy).height;
  return back ? -ahead : ahead;
}

/// The greater of the two directed ones, the one that promises more first; of the other only what could be greater is
/// looked for.
std::optional<Measured> AtPosition::hausdorff(const RealPoint& p) const {
  const double px = near_value(p.x), py = near_value(p.y);
  const double scale = moving().scale() + fixed().scale() + std::abs(px) + std::abs(py);
  const bool plain = !moving().has_arcs() && !fixed().has_arcs() && !moving().empty() && !fixed().empty() && bounded();
  const double out = plain ? protrudes(false, px, py) : 0, back_out = plain ? protrudes(true, px, py) : 0;
  const bool back = back_out > out;
  auto f = directed(back, p);
  if (!f) return std::nullopt;
  auto g = directed(!back, p, near_value(f->value) - scale * margin::kHardlyOut);
  if (!g) return std::nullopt;
  if (back) std::swap(f, g);
  return f->value < g->value ? g : f;
}

/// A vertex of one shape (of B + p if `moves`) and the point inside the other where it lies.
std::vector<Feature> AtPosition::corner_features(bool moves, Index v, const RealPoint& p) const {
  const Region& of = shapes_[moves ? 0 : 1].boxed.region;
  RealPoint place = of.geometry.exact(of.vertices[v].point);
  if (moves) place = place + p;
  const Feature corner{moves, {0, v}, place}, inside{!moves, {2, 0}, place};
  return moves ? std::vector{corner, inside} : std::vector{inside, corner};
}

/// A point of both shapes: their boundaries cross there, touch, or one lies in the other.
std::vector<Feature> AtPosition::common_point(const Standing& s, const RealPoint& p) const {
  if (s.kind == Standing::Kind::kClose) {
    return features(distance::common_point(fixed(), moving(), p));
  }
  for (bool moves : {true, false}) {
    const FeatureTree &inner = moves ? moving() : fixed(), &set = moves ? fixed() : moving();
    for (Index v : inner.representatives()) {
      if (!is_inside(inner, v, set, moves ? p : -p)) continue;
      return corner_features(moves, v, p);
    }
  }
  return {};
}

/// d1 = 0, from a vertex of one shape inside the other.
std::optional<Measured> AtPosition::common_corner(const RealPoint& p) const {
  for (bool moves : {true, false}) {
    const Boxed &of = shapes_[moves ? 0 : 1].boxed, &in = shapes_[moves ? 1 : 0].boxed;
    const double sign = moves ? 1 : -1;
    auto v = vertex_within(of, in, sign * near_value(p.x), sign * near_value(p.y));
    if (v) return Measured{Real(), std::nullopt, std::nullopt, corner_features(moves, *v, p)};
  }
  return std::nullopt;
}

/// d1 = max(0, gamma1). Of shapes that overlap a common point is mostly found sooner than how they stand.
std::optional<Measured> AtPosition::plain(const RealPoint& p) const {
  if (auto found = common_corner(p)) return found;
  if (auto crossing = crossing_pair(fixed(), moving(), p))
    return Measured{Real(), std::nullopt, std::nullopt, features(*crossing)};
  Standing s = standing(p);
  if (s.kind == Standing::Kind::kApart) {
    RealPoint step = s.pair->first - s.pair->second;
    return Measured{s.pair->distance, p + step, std::nullopt, features(*s.pair)};
  }
  if (s.kind == Standing::Kind::kClose) {
    auto m = cut(signed_value(Which::kGamma1, s, p), false);
    if (m->value.sign() > 0) return m;
  }
  return Measured{Real(), std::nullopt, std::nullopt, common_point(s, p)};
}

std::optional<Measured> AtPosition::diameter(const RealPoint& p) const {
  if (!bounded()) return std::nullopt;
  std::call_once(diameters_made_, [&] {
    const RealPoint origin{Real(), Real()};
    diameters_ = {farthest_pair(fixed(), fixed(), origin), farthest_pair(moving(), moving(), origin)};
  });
  FeaturePair k = farthest_pair(fixed(), moving(), p);
  Measured m{k.distance, std::nullopt, std::nullopt, features(k)};
  for (int i = 0; i < 2; ++i) {
    const FeaturePair& own = *diameters_[std::size_t(i)];
    if (own.distance <= m.value) continue;
    RealPoint by = i ? p : RealPoint{Real(), Real()};
    m.value = own.distance;
    m.witness = {{i == 1, own.first_cell, own.first + by}, {i == 1, own.second_cell, own.second + by}};
  }
  return m;
}

/// max(0, f), or max(0, -f); what attains f attains it where it is not cut off.
std::optional<Measured> AtPosition::cut(std::optional<Measured> m, bool negated) const {
  if (!m) return negated ? std::optional(Measured{}) : std::nullopt;
  if (m->minus_infinity) return negated ? std::nullopt : std::optional(Measured{});
  if (negated) m->value = -m->value;
  if (m->value.sign() < 0) return Measured{};
  return m;
}

std::optional<Measured> AtPosition::measured(Which which, const RealPoint& p) const {
  using Kind = Standing::Kind;
  if (!shapes_[0].has_boundary || !shapes_[1].has_boundary) {
    auto v = searched_->distance(which)->value(p);
    return v ? std::optional(Measured{v->value, v->nearest, std::nullopt, {}, v->minus_infinity}) : std::nullopt;
  }
  switch (which) {
    case Which::kGamma1:
      return signed_distance(which, Kind::kApart, p);
    case Which::kEta1:
      return signed_distance(which, Kind::kInside, p);
    case Which::kDelta1:
      return signed_distance(which, Kind::kAround, p);
    case Which::kGamma2: {
      if (!bounded()) return std::nullopt;
      FeaturePair k = farthest_pair(fixed(), moving(), p);
      return Measured{k.distance, std::nullopt, std::nullopt, features(k)};
    }
    case Which::kEta2:
    case Which::kDelta2:
      return farthest(which, p);
    case Which::kMu:
      return directed(false, p);
    case Which::kMuBack:
      return directed(true, p);
    case Which::kHausdorff:
      return hausdorff(p);
    case Which::kD1:
      return plain(p);
    case Which::kH:
      return cut(directed(false, p), false);
    case Which::kHBack:
      return cut(directed(true, p), false);
    case Which::kDstar:
      return cut(signed_distance(Which::kDelta1, Kind::kAround, p), true);
    case Which::kDstarBack:
      return cut(signed_distance(Which::kEta1, Kind::kInside, p), true);
    case Which::kDiameter:
      return diameter(p);
    case Which::kPenetration:
      return cut(signed_distance(Which::kGamma1, Kind::kApart, p), true);
  }
  return std::nullopt;
}

}  // namespace findspace::distance
