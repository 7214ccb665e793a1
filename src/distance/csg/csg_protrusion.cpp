// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/csg/csg_protrusion.h"

#include <algorithm>
#include <cmath>

#include "distance/search/boundary_columns.h"
#include "distance/search/tetrahedral_max_min.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using space::Vector;

namespace {

constexpr int kMostProtrusionCells = 4000;
constexpr std::size_t kMostPlaces = 6;  // that bound a cell
constexpr int kPlaceRounds = 3;

struct NearestPlace {
  double least = exact::kInfinity;  // nothing of A is nearer
  Vector at;
  const CsgPartSearch* part = nullptr;
};

/// A place that nothing of a set is nearer than.
struct Projection {
  double least = 0;
  Vector at;
};

struct BallOut {
  Vector center;
  double radius;
};

/// Of x in the ball, or behind the plane's part in the ball, onto what the half-space has out of the ball: onto the
/// sphere, or the circle in which the plane meets it. Along the sphere the distance from x grows with the angle.
std::optional<Projection> out_of_ball(const space::HalfSpace& plane, const BallOut& ball, const Vector& x) {
  const double high = plane.approx_value(x);
  const Vector on = x - space::scaled(std::max(high, 0.0), plane.unit);
  if (space::length(on - ball.center) >= ball.radius) return std::nullopt;
  const Vector way = x - ball.center;
  const double far = space::length(way);
  if (high <= 0 && far > 0) {
    const Vector y = space::plus(ball.center, space::scaled(ball.radius / far, way));
    if (plane.approx_value(y) <= 0) return Projection{ball.radius - far, y};
  }
  const double above = plane.approx_value(ball.center), square = ball.radius * ball.radius - above * above;
  if (!(square > 0)) return std::nullopt;
  const Vector middle = ball.center - space::scaled(above, plane.unit);
  Vector along = on - middle - space::scaled(plane.approx_value(on), plane.unit);
  double size = space::length(along);
  if (size == 0) {  // no sign: on the axis any place of the circle is as near
    along = space::cross(plane.unit, std::fabs(plane.unit.x) < 0.6 ? Vector{1, 0, 0} : Vector{0, 1, 0});
    size = space::length(along);
  }
  const Vector y = space::plus(middle, space::scaled(std::sqrt(square) / size, along));
  return Projection{space::length(x - y), y};
}

/// What says without a search which place of a part is nearest, mostly.
struct Sides {
  const CsgPartSearch* part = nullptr;
  std::vector<space::HalfSpace> planes;
  std::vector<BallOut> balls;

  explicit Sides(const CsgPartSearch& of) : part(&of) {
    for (const space::BodyPart& set : of.sets->within) {
      const std::vector<space::HalfSpace> all = set.radius.sign() == 0 ? set.planes() : std::vector<space::HalfSpace>();
      planes.insert(planes.end(), all.begin(), all.end());
    }
    for (const space::BodyPart& set : of.sets->without) {
      if (set.point()) balls.push_back({exact::approx(set.center), set.radius.to_double()});
    }
  }

  /// Of a set that holds the part, of what is out of a ball, or of both: where it belongs to the part it is the nearest
  /// place of that.
  std::optional<NearestPlace> nearest(const Vector& x, double size) const {
    const Constraints& constraints = part->places.constraints();
    Projection most{0, x};
    for (const TouchingConstraint& constraint : constraints.convex) {
      const Touching at = constraint(x);
      if (at.value > most.least) most = {at.value, x - space::scaled(at.value, at.slope)};
    }
    for (const BallOut& ball : balls) {
      const Vector way = x - ball.center;
      const double far = space::length(way);
      if (ball.radius - far > most.least && far > 0)
        most = {ball.radius - far, space::plus(ball.center, space::scaled(ball.radius / far, way))};
      for (const space::HalfSpace& plane : planes) {
        const auto both = out_of_ball(plane, ball, x);
        if (both && both->least > most.least) most = *both;
      }
    }
    const double noise = margin::kDistanceNoise * size;
    const bool belongs = std::all_of(constraints.convex.begin(), constraints.convex.end(),
                                     [&](const TouchingConstraint& f) { return f(most.at).value <= noise; }) &&
                         std::all_of(constraints.reverse_convex.begin(), constraints.reverse_convex.end(),
                                     [&](const ConvexDistance& f) { return f(most.at) >= -noise; });
    if (!belongs) return std::nullopt;
    return NearestPlace{most.least, most.at, part};
  }
};

class PlacesOfCsg : public MaxMinTarget {
 public:
  PlacesOfCsg(const std::vector<CsgPartSearch>& a, double size, double near) : size_(size), share_(near / size / 4) {
    for (const CsgPartSearch& part : a) sides_.emplace_back(part);
  }

  bool look(MaxMinCell& cell, const Vector& middle, MaxMinBest& best) const override {
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
    return space::length(x - found.at);
  }

  NearestPlace nearest(const Vector& x) const {
    NearestPlace best;
    double value = exact::kInfinity;
    for (const Sides& sides : sides_) {
      if (sides.part->box().distance(x) >= value) continue;
      auto found = sides.nearest(x, size_);
      if (!found) found = searched(*sides.part, x);
      const double d = space::length(x - found->at);
      best.least = std::min(best.least, found->least);
      if (d >= value) continue;
      value = d;
      best.at = found->at;
      best.part = found->part;
    }
    return best;
  }

 private:
  std::optional<NearestPlace> searched(const CsgPartSearch& part, const Vector& x) const {
    // Along the edge of what is cut out many places are nearly as near: they need not be distinguished.
    const Until until{0, 1 - share_};
    const BoundaryPlace found = part.places.nearest_to(distance_to_point(x), {0, {}, &until});
    return NearestPlace{found.bound, found.place, &part};
  }

  const NearestPlace& place(int set) const { return places_[static_cast<std::size_t>(set)]; }

  /// The distance of a place of the cell from A; it is remembered, and offered if it is in B.
  double seen(const Vector& x, MaxMinCell& cell, MaxMinBest& best) const {
    if (cell.round && cell.round->beyond(x) > 0) offer_in(cell.round->pulled_in(x), best);
    const NearestPlace found = nearest(x);
    cell.sets.push_back(static_cast<int>(places_.size()));
    places_.push_back(found);
    if (!cell.round || cell.round->beyond(x) <= 0) best.offer(x, found.least);
    return space::length(x - found.at);
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

  std::vector<Sides> sides_;
  double size_, share_;
  mutable std::vector<NearestPlace> places_;
};

}  // namespace

CsgProtrusion csg_protrusion(const Solids& b, const std::vector<CsgPartSearch>& a, double size, double near) {
  const PlacesOfCsg target(a, size, near);
  CsgProtrusion out{
      tetrahedral_max_min(b, target, MaxMinBest(-exact::kInfinity, 0, 0, near), kMostProtrusionCells), {}, nullptr};
  const NearestPlace nearest = target.nearest(out.found.place);
  out.nearest = nearest.at;
  out.part = nearest.part;
  return out;
}

}  // namespace findspace::distance
