// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/set_protrusion.h"

#include <algorithm>
#include <cmath>

#include "distance/search/boundary_columns.h"
#include "distance/search/tetrahedral_max_min.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using space::Vector;

namespace {

constexpr std::size_t kMostPlaces = 6;  // that bound a cell
constexpr int kPlaceRounds = 3;

struct NearestPlace {
  double least = exact::kInfinity;  // nothing of A is nearer
  double value = exact::kInfinity;  // how far the place is
  Vector at;
  std::size_t set = 0;
};

/// A place that nothing of a set is nearer than.
struct Projection {
  double least = 0;
  Vector at;
};

using Ball = NearSet::Ball;

/// Of the circle about the axis, of a square of its radius.
Projection on_circle(const Vector& middle, const Vector& axis, double square, const Vector& x) {
  const Vector off = x - middle;
  Vector along = off - space::scaled(space::dot(off, axis), axis);
  double size = space::length(along);
  if (size == 0) {  // no sign: on the axis any place of the circle is as near
    along = space::cross(axis, std::fabs(axis.x) < 0.6 ? Vector{1, 0, 0} : Vector{0, 1, 0});
    size = space::length(along);
  }
  const Vector y = space::plus(middle, space::scaled(std::sqrt(square) / size, along));
  return {space::length(x - y), y};
}

/// The nearest place of the sphere.
Vector on_sphere(const Ball& ball, const Vector& way, double far) {
  return space::plus(ball.center, space::scaled(ball.radius / far, way));
}

/// Of x in the ball, or behind the plane's part in the ball, onto what the half-space has out of the ball: from inside
/// the ball onto the sphere, or the circle in which the plane meets it. Along the sphere the distance from x grows with
/// the angle.
std::optional<Projection> out_of_ball(const space::HalfSpace& plane, const Ball& ball, const Vector& x) {
  const double high = plane.approx_value(x);
  const Vector on = x - space::scaled(std::max(high, 0.0), plane.unit);
  if (space::length(on - ball.center) >= ball.radius) return std::nullopt;
  const Vector way = x - ball.center;
  const double far = space::length(way);
  if (far > 0 && far < ball.radius) {
    const Vector y = on_sphere(ball, way, far);
    if (plane.approx_value(y) <= 0) return Projection{ball.radius - far, y};
  }
  const double above = plane.approx_value(ball.center), square = ball.radius * ball.radius - above * above;
  if (!(square > 0)) return std::nullopt;
  return on_circle(ball.center - space::scaled(above, plane.unit), plane.unit, square, x);
}

/// The same of what another ball has out of the ball: where neither sphere holds the nearest place alone it is on the
/// circle in which they meet, if they do so at an angle that doubles tell.
std::optional<Projection> out_of_ball(const Ball& outer, const Ball& ball, const Vector& x) {
  const Vector from = x - outer.center, way = x - ball.center, apart = ball.center - outer.center;
  const double high = space::length(from) - outer.radius, far = space::length(way), d = space::length(apart);
  const Vector on = high > 0 ? on_sphere(outer, from, space::length(from)) : x;
  if (space::length(on - ball.center) >= ball.radius) return std::nullopt;
  if (far > 0 && far < ball.radius) {
    const Vector y = on_sphere(ball, way, far);
    if (space::length(y - outer.center) <= outer.radius) return Projection{ball.radius - far, y};
  }
  if (!(d > 0)) return std::nullopt;
  const double ahead = (d * d + outer.radius * outer.radius - ball.radius * ball.radius) / (2 * d),
               square = outer.radius * outer.radius - ahead * ahead;
  if (!(square > 0) || std::sqrt(square) * d < margin::kSharpEdge * outer.radius * ball.radius) return std::nullopt;
  const Vector axis = space::scaled(1 / d, apart);
  return on_circle(space::plus(outer.center, space::scaled(ahead, axis)), axis, square, x);
}

/// Of a convex set that holds the set, of what is out of a ball, or of both: where it belongs to the set it is the
/// nearest place of that.
std::optional<Projection> projected(const NearSet& set, const Vector& x, double size) {
  const Constraints& constraints = set.places->constraints();
  Projection most{0, x};
  for (const TouchingConstraint& constraint : constraints.convex) {
    const Touching at = constraint(x);
    if (at.value > most.least) most = {at.value, x - space::scaled(at.value, at.slope)};
  }
  const auto take = [&](const std::optional<Projection>& found) {
    if (found && found->least > most.least) most = *found;
  };
  for (const Ball& ball : set.balls) {
    const Vector way = x - ball.center;
    const double far = space::length(way);
    if (far > 0) take(Projection{ball.radius - far, on_sphere(ball, way, far)});
    for (const space::HalfSpace& plane : set.planes) take(out_of_ball(plane, ball, x));
    for (const Ball& outer : set.outer) take(out_of_ball(outer, ball, x));
  }
  const double noise = margin::kDistanceNoise * size;
  const bool belongs = std::all_of(constraints.convex.begin(), constraints.convex.end(),
                                   [&](const TouchingConstraint& f) { return f(most.at).value <= noise; }) &&
                       std::all_of(constraints.reverse_convex.begin(), constraints.reverse_convex.end(),
                                   [&](const ConvexDistance& f) { return f(most.at) >= -noise; });
  return belongs ? std::optional(most) : std::nullopt;
}

class PlacesOfSets : public MaxMinTarget {
 public:
  PlacesOfSets(const std::vector<NearSet>& sets, double size, double near)
      : sets_(sets), size_(size), share_(near / size / 4) {}

  bool look(MaxMinCell& cell, const Vector& middle, MaxMinBest& best) const override {
    if (missed_) return false;
    double reach = 0;
    for (const Vector& v : cell.corner) reach = std::max(reach, space::length(v - middle));
    columns(cell);
    if (!best.worth(cell.bound)) return true;
    cell.bound = std::min(cell.bound, seen(middle, cell, best) + reach + margin::kFoundError * size_);
    columns(cell);
    return true;
  }

  void offer(const Vector& x, MaxMinCell& cell, MaxMinBest& best) const override {
    seen(x, cell, best);
    cell.distances.push_back(column(cell.sets.back(), cell));
  }

  double distance(int set, const Vector& x) const override { return space::length(x - place(set).at); }
  double shortest_share() const override { return 1; }
  int rounds() const override { return kPlaceRounds; }

  double offer_in(const Vector& x, MaxMinBest& best) const override {
    const NearestPlace found = nearest(x);
    best.offer(x, found.least);
    return found.value;
  }

  NearestPlace nearest(const Vector& x) const {
    NearestPlace best;
    double missed = exact::kInfinity;
    for (std::size_t k = 0; k < sets_.size(); ++k) {
      const NearSet& set = sets_[k];
      if (set.places->box().distance(x) >= best.value) continue;
      auto found = set.places->has_more() ? std::nullopt : projected(set, x, size_);
      if (!found) found = searched(*set.places, x, missed);
      if (!found) continue;
      best.least = std::min(best.least, found->least);
      const double d = space::length(x - found->at);
      if (d < best.value) best = {best.least, d, found->at, k};
    }
    missed_ = missed_ || missed < best.value || best.value == exact::kInfinity;
    return best;
  }

  /// Whether some nearest place was not found: then nothing is known.
  bool missed() const { return missed_; }

 private:
  /// `missed`: nothing of a set of which no place was found is nearer.
  std::optional<Projection> searched(const PositionSet& places, const Vector& x, double& missed) const {
    // Along the edge of what is cut out many places are nearly as near: they need not be distinguished.
    const Until until{0, 1 - share_};
    const BoundaryPlace found = places.nearest_to(distance_to_point(x), {0, {}, &until});
    if (found.found) return Projection{found.bound, found.place};
    missed = std::min(missed, found.bound);
    return std::nullopt;
  }

  const NearestPlace& place(int set) const { return places_[static_cast<std::size_t>(set)]; }

  /// The distance of a place of the cell from A; it is remembered, and offered if it is in B.
  double seen(const Vector& x, MaxMinCell& cell, MaxMinBest& best) const {
    if (cell.round && cell.round->beyond(x) > 0) offer_in(cell.round->pulled_in(x), best);
    const NearestPlace found = nearest(x);
    cell.sets.push_back(static_cast<int>(places_.size()));
    places_.push_back(found);
    if (!cell.round || cell.round->beyond(x) <= 0) best.offer(x, found.least);
    return found.value;
  }
  Column column(int set, const MaxMinCell& cell) const {
    Column out{};
    for (std::size_t v = 0; v < 4; ++v) out[v] = distance(set, cell.corner[v]);
    return out;
  }

  /// Of the places that bound the cell best.
  void columns(MaxMinCell& cell) const {
    std::vector<std::pair<double, int>> order;
    for (const int set : cell.sets) order.emplace_back(most(column(set, cell)), set);
    std::sort(order.begin(), order.end());
    order.resize(std::min(order.size(), kMostPlaces));
    cell.sets.clear();
    cell.distances.clear();
    for (const auto& [bound, set] : order) {
      cell.sets.push_back(set);
      cell.distances.push_back(column(set, cell));
      cell.bound = std::min(cell.bound, bound);
    }
  }

  const std::vector<NearSet>& sets_;
  double size_, share_;
  mutable std::vector<NearestPlace> places_;
  mutable bool missed_ = false;
};

}  // namespace

exact::Refusal not_protruding() {
  return exact::Refusal(
      "the protrusion from a shape that round ones are cut out of was not found within the limit of the search");
}

Answer SetProtrusion::answer(double size) const {
  Answer out;
  const double noise = margin::kFoundError * size;
  out.value = exact::Real::from_double(found.value);
  out.set_unproven();
  out.error = found.bound - found.value + noise;
  out.enclosed =
      Enclosure{exact::Real::from_double(found.value - noise), exact::Real::from_double(found.bound + noise)};
  out.witness = point_pair(space::real(found.place), space::real(nearest));
  return out;
}

exact::Tried<SetProtrusion> set_protrusion(const Solids& solids, const std::vector<NearSet>& sets, double size,
                                           double near, const SolidMaxMin* known, int most) {
  const PlacesOfSets target(sets, size, near);
  MaxMinBest start(-exact::kInfinity, 0, 0, near);
  if (known) start.offer(known->place, known->value);
  SetProtrusion out{tetrahedral_max_min(solids, target, start, most), {}, 0};
  if (target.missed()) return not_protruding();
  if (known) out.found.bound = std::min(out.found.bound, known->bound);
  const NearestPlace nearest = target.nearest(out.found.place);
  out.nearest = nearest.at;
  out.set = nearest.set;
  return out;
}

}  // namespace findspace::distance
