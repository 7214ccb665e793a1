// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/set_protrusion.h"

#include <algorithm>
#include <cmath>

#include "distance/search/boundary_columns.h"
#include "distance/search/tetrahedral_max_min.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"

namespace findspace::distance {

using space::Vector;

namespace {

constexpr std::size_t kMostPlaces = 6;  // that bound a cell
constexpr int kPlaceRounds = 3;
constexpr long kLeastCells = 4096;  // of the search for one place, where each cell takes searches

struct NearestPlace {
  double least = exact::kInfinity;  // nothing of A is nearer
  double value = exact::kInfinity;  // how far the place is
  Vector at;
  std::size_t set = 0;
};

/// A place that nothing of a set is nearer than; it is of the set, if said so.
struct Projection {
  double least = 0;
  Vector at;
  bool belongs = false;
};

using Ball = NearSet::Ball;

/// Of the circle about the axis, of a square of its radius.
Projection on_circle(const Vector& middle, const Vector& axis, double square, const Vector& x) {
  const Vector off = x - middle;
  Vector along = off - space::scaled(space::dot(off, axis), axis);
  double size = space::length(along);
  if (size == 0) {  // no sign: on the axis any place of the circle is as near
    along = distance::across(axis);
    size = 1;
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

/// Of x in the set, onto its boundary: from a core without interior any way that a plane of it says.
std::optional<Projection> out_of_cut(const NearSet::Cut& cut, const Vector& x) {
  Touching at = cut.boundary(x);
  if (at.value >= 0) return std::nullopt;
  if (space::length(at.slope) == 0) at.slope = highest_plane(cut.planes, {})(x).slope;  // no sign: none is stated
  return Projection{-at.value, x - space::scaled(at.value, at.slope)};
}

/// The place of the ellipse (longer * cos, shorter * sin) nearest to (x, y), both at least 0. Its normal through the
/// place leads to (x, y); along that the place is one root of a convex function, which Newton's steps reach from below.
std::pair<double, double> on_ellipse(double longer, double shorter, double x, double y) {
  const double apart = longer * longer - shorter * shorter;
  if (y == 0) {  // no sign: on the axis the root is known
    if (!(longer * x < apart)) return {longer, 0};
    const double cosine = longer * x / apart;
    return {longer * cosine, shorter * std::sqrt(1 - cosine * cosine)};
  }
  double s = shorter * y;
  for (;;) {
    const double u = longer * x / (s + apart), v = shorter * y / s;
    const double step = (u * u + v * v - 1) / (2 * (u * u / (s + apart) + v * v / s));
    if (!(s + step > s)) break;
    s += step;
  }
  return {longer * longer * x / (s + apart), shorter * shorter * y / s};
}

/// From the point of the plane in the ellipse in which it cuts a drill through it onto that ellipse; nothing where it
/// comes near the balls at the ends.
std::optional<Vector> onto_crossing(const space::HalfSpace& plane, const RoundSolid& drill, const Vector& x) {
  const double from = plane.approx_value(drill.from), to = plane.approx_value(drill.to);
  if (!(from * to < 0) || std::min(std::fabs(from), std::fabs(to)) <= drill.radius) return std::nullopt;
  const Vector way = drill.to - drill.from, middle = space::plus(drill.from, space::scaled(from / (from - to), way));
  const double ahead = std::min(1.0, std::fabs(from - to) / space::length(way));  // the cosine of the angle
  if (ahead < margin::kSharpEdge) return std::nullopt;
  Vector across = space::cross(plane.unit, way);
  if (space::length(across) <= margin::kSameNormal * space::length(way)) across = distance::across(plane.unit);
  across = space::scaled(1 / space::length(across), across);
  const Vector along = space::cross(plane.unit, across);
  const double x_along = space::dot(x - middle, along), x_across = space::dot(x - middle, across);
  const auto [u, v] = on_ellipse(drill.radius / ahead, drill.radius, std::fabs(x_along), std::fabs(x_across));
  return space::plus(middle, space::plus(space::scaled(std::copysign(u, x_along), along),
                                         space::scaled(std::copysign(v, x_across), across)));
}

/// The same where the drill runs along the plane: what they have in common is a segment grown by a disc.
std::optional<Vector> onto_groove(const space::HalfSpace& plane, const RoundSolid& drill, const Vector& x) {
  const double high = plane.approx_value(drill.from), square = drill.radius * drill.radius - high * high;
  const Vector way = drill.to - drill.from, from = drill.from - space::scaled(high, plane.unit);
  if (!(square > 0)) return std::nullopt;
  const double part = std::clamp(space::dot(x - from, way) / space::dot(way, way), 0.0, 1.0);
  const Vector on = space::plus(from, space::scaled(part, way));
  Vector across = x - on;
  if (space::length(across) == 0) across = space::cross(plane.unit, way);  // no sign: both sides are as near
  return space::plus(on, space::scaled(std::sqrt(square) / space::length(across), across));
}

/// Of x in the drill, or behind the plane's part in the drill, onto the edge in which the plane meets it.
std::optional<Projection> out_of_drill(const space::HalfSpace& plane, const NearSet::Cut& cut, const Vector& x) {
  const double high = plane.approx_value(x);
  const Vector foot = x - space::scaled(high, plane.unit);
  if (cut.boundary(high > 0 ? foot : x).value >= 0) return std::nullopt;
  const std::optional<Projection> out = out_of_cut(cut, x);
  if (out && plane.approx_value(out->at) <= 0) return std::nullopt;
  const RoundSolid& drill = *cut.drill;
  const Vector way = drill.to - drill.from;
  const bool level = std::fabs(space::dot(plane.unit, way)) <= margin::kSameNormal * space::length(way);
  const std::optional<Vector> at = level ? onto_groove(plane, drill, foot) : onto_crossing(plane, drill, foot);
  return at ? std::optional(Projection{space::length(x - *at), *at}) : std::nullopt;
}

/// Of a convex set that holds the set, of what is out of another, or of both: where it belongs to the set it is the
/// nearest place of that.
Projection projected(const NearSet& set, const Vector& x, double size) {
  const Constraints& constraints = set.places->constraints();
  Projection most{0, x};
  for (const TouchingConstraint& constraint : constraints.convex) {
    const Touching at = constraint(x);
    if (at.value > most.least) most = {at.value, x - space::scaled(at.value, at.slope)};
  }
  for (const auto& way : set.ways) {
    const Vector off = way(x);
    if (space::length(off) > most.least) most = {space::length(off), space::plus(x, off)};
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
  for (const NearSet::Cut& cut : set.cuts) {
    take(out_of_cut(cut, x));
    if (!cut.drill) continue;
    for (const space::HalfSpace& plane : set.planes) take(out_of_drill(plane, cut, x));
  }
  const double noise = margin::kDistanceNoise * size;
  most.belongs = std::all_of(constraints.convex.begin(), constraints.convex.end(),
                             [&](const TouchingConstraint& f) { return f(most.at).value <= noise; }) &&
                 std::all_of(constraints.reverse_convex.begin(), constraints.reverse_convex.end(),
                             [&](const ConvexDistance& f) { return f(most.at) >= -noise; });
  return most;
}

class PlacesOfSets : public MaxMinTarget {
 public:
  PlacesOfSets(const std::vector<NearSet>& sets, double size, double near, double ceiling)
      : sets_(sets), size_(size), share_(near / size / 4), ceiling_(ceiling) {}

  bool look(MaxMinCell& cell, const Vector& middle, MaxMinBest& best) const override {
    if (missed_) return false;
    cell.bound = std::min(cell.bound, ceiling_);
    columns(cell);
    if (!best.worth(cell.bound)) return true;
    if (spent()) {
      if (const auto place = known(middle)) keep(*place, cell);
    } else {
      cell.bound = std::min(cell.bound, seen(middle, cell, best) + reach(cell, middle) + margin::kFoundError * size_);
    }
    columns(cell);
    return true;
  }

  void offer(const Vector& x, MaxMinCell& cell, MaxMinBest& best) const override {
    if (spent()) return;
    seen(x, cell, best);
    cell.distances.push_back(column(cell.sets.back(), cell));
  }

  double distance(int set, const Vector& x) const override { return space::length(x - place(set).at); }
  double shortest_share() const override { return 1; }
  int rounds() const override { return kPlaceRounds; }
  bool spent() const override { return plane::cells_left() <= 0; }

  double offer_in(const Vector& x, MaxMinBest& best) const override {
    const NearestPlace found = nearest(x, share_);
    best.offer(x, found.least);
    return found.value;
  }

  /// Known but for that share.
  NearestPlace nearest(const Vector& x, double share) const {
    NearestPlace best;
    double missed = exact::kInfinity;
    const auto take = [&](const Projection& found, std::size_t set) {
      best.least = std::min(best.least, found.least);
      const double d = space::length(x - found.at);
      if (d < best.value) best = {best.least, d, found.at, set};
    };
    std::vector<std::pair<double, std::size_t>> left;  // with what nothing of them is nearer than
    for (std::size_t k = 0; k < sets_.size(); ++k) {
      const NearSet& set = sets_[k];
      const double least = set.places->box().distance(x);
      if (least >= best.value) continue;
      const Projection found = set.places->has_more() ? Projection{} : projected(set, x, size_);
      if (found.belongs)
        take(found, k);
      else
        left.emplace_back(std::max(least, found.least), k);
    }
    std::sort(left.begin(), left.end());
    for (const auto& [least, k] : left) {
      if (least >= best.value) break;
      if (const auto found = searched(*sets_[k].places, x, share, missed)) take(*found, k);
    }
    if (missed < best.value || best.value == exact::kInfinity) {
      const std::optional<NearestPlace> place = known(x);
      missed_ = missed_ || !place;
      const double least = std::min(best.least, missed);
      if (place && place->value < best.value) best = *place;
      best.least = least;
    }
    return best;
  }

  /// Whether some nearest place was not found: then nothing is known.
  bool missed() const { return missed_; }

 private:
  /// `missed`: nothing of a set of which no place was found is nearer.
  std::optional<Projection> searched(const PositionSet& places, const Vector& x, double share, double& missed) const {
    // Along the edge of what is cut out many places are nearly as near: they need not be distinguished.
    Until until{0, 1 - share};
    if (places.has_more()) until.cells = std::max(plane::cells_left() / plane::kShareOfSearch, kLeastCells);
    const BoundaryPlace found = places.nearest_to(distance_to_point(x), {0, {}, &until});
    if (found.found) return Projection{found.bound, found.place};
    missed = std::min(missed, found.bound);
    return std::nullopt;
  }

  static double reach(const MaxMinCell& cell, const Vector& x) {
    double out = 0;
    for (const Vector& v : cell.corner) out = std::max(out, space::length(v - x));
    return out;
  }

  const NearestPlace& place(int set) const { return places_[static_cast<std::size_t>(set)]; }

  /// The nearest place that is known without a search.
  std::optional<NearestPlace> known(const Vector& x) const {
    std::optional<NearestPlace> best;
    for (std::size_t k = 0; k < sets_.size(); ++k) {
      const std::optional<Vector> at = sets_[k].known ? sets_[k].known(x) : std::nullopt;
      if (!at) continue;
      const double d = space::length(x - *at);
      if (!best || d < best->value) best = {0, d, *at, k};
    }
    return best;
  }

  void keep(const NearestPlace& place, MaxMinCell& cell) const {
    cell.sets.push_back(static_cast<int>(places_.size()));
    places_.push_back(place);
  }

  /// The distance of a place of the cell from A; it is remembered, and offered if it is in B.
  double seen(const Vector& x, MaxMinCell& cell, MaxMinBest& best) const {
    if (cell.round && cell.round->beyond(x) > 0) offer_in(cell.round->pulled_in(x), best);
    // The bound of the cell is off by the square of its size.
    const double wide = reach(cell, x) / size_;
    const NearestPlace found = nearest(x, std::max(share_, wide * wide / 8));
    keep(found, cell);
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
  double size_, share_, ceiling_;
  mutable std::vector<NearestPlace> places_;
  mutable bool missed_ = false;
};

}  // namespace

void NearSet::take_away(const space::BodyPart& part) {
  if (part.point()) {
    balls.push_back(ball(part));
    return;
  }
  const double radius = part.radius.to_double();
  cuts.push_back({touching_boundary(part, {}, radius), part.planes()});
  if (!part.core && part.flat.size() == 2)
    cuts.back().drill = RoundSolid{exact::approx(part.flat[0]), exact::approx(part.flat[1]), radius};
}

exact::Refusal not_protruding() {
  return plane::search_spent("the protrusion from a shape that round ones are cut out of was not found");
}

Answer SetProtrusion::answer(double size) const {
  using exact::Real;
  const double noise = margin::kFoundError * size;
  Answer out = unproven_answer(Real::from_double(found.value),
                               {Real::from_double(found.value - noise), Real::from_double(found.bound + noise)});
  out.error = found.bound - found.value + noise;
  out.witness = point_pair(space::real(found.place), space::real(nearest));
  return out;
}

exact::Tried<SetProtrusion> set_protrusion(const Solids& solids, const std::vector<NearSet>& sets, double size,
                                           double near, const SolidMaxMin* known, const ProtrusionEnd& end) {
  const plane::SearchQuestion question;
  const PlacesOfSets target(sets, size, near, end.ceiling);
  MaxMinBest start(-exact::kInfinity, 0, 0, near);
  if (known) start.offer(known->place, known->value);
  if (end.first) target.offer_in(*end.first, start);
  SetProtrusion out{tetrahedral_max_min(solids, target, start, end.most), {}, 0};
  if (target.missed() || !std::isfinite(out.found.bound)) return not_protruding();
  if (known) out.found.bound = std::min(out.found.bound, known->bound);
  const NearestPlace nearest = target.nearest(out.found.place, near / size / 4);
  if (!std::isfinite(nearest.value)) return not_protruding();
  out.nearest = nearest.at;
  out.set = nearest.set;
  return out;
}

}  // namespace findspace::distance
