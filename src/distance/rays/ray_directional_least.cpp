// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/rays/ray_directional_least.h"

#include <algorithm>

#include "distance/rays/ray_covers.h"
#include "distance/rays/round_runs.h"
#include "distance/rays/swept_fits.h"
#include "distance/search/convex_distance.h"
#include "distance/search/grown_set.h"
#include "distance/search/position_set.h"
#include "distance/search/union_fit.h"
#include "exact/margins/rounding.h"
#include "exact/margins/space_distance.h"
#include "space/body/body_boxes.h"
#include "space/body/union_frontier.h"
#include "space/polytope/longest_chord.h"
#include "space/rays/longest_run.h"

namespace findspace::distance {
namespace {

using exact::Real;
using exact::Refusal;
using space::Body;
using space::ConvexRegion;
using space::HalfSpace;
using space::LongestRun;
using space::RealVector;
using space::RunStart;

/// Of a longest stretch, in lengths of the direction.
Answer least_of_run(const Real& length, const std::optional<RealVector>& middle, const RealVector& direction,
                    bool both_ways) {
  const Real value = -length * sqrt(space::dot(direction, direction)) / Real(both_ways ? 2 : 1);
  Answer out = least_answer(value, value, true, middle.value_or(RealVector()), Way::kConvex);
  if (!both_ways || !middle) out.side = Side::kNone;
  return out;
}

Answer touching(const RealVector& at) { return least_answer(Real(), Real(), true, at, Way::kConvex); }

/// The plane of a polygon, with the direction; nothing where that runs along it.
std::optional<HalfSpace> crossed_plane(const ConvexRegion& polygon, const RealVector& u) {
  for (const HalfSpace& h : polygon.planes()) {
    const ConvexRegion::Sides sides = polygon.sides(h);
    if (sides.inside || sides.outside) continue;
    const int way = space::dot(h.normal, u).sign();
    if (way != 0) return way > 0 ? h : h.opposite();
  }
  return std::nullopt;
}

/// Whether one of the sets begins at the polygon.
bool entered(const ConvexRegion& polygon, const RayCover& cover, const RealVector& u) {
  RealVector middle;
  for (const ConvexRegion::Vertex& v : polygon.vertices()) middle = space::plus(middle, v.at);
  middle = space::scaled(Real::ratio(1, static_cast<int>(polygon.vertices().size())), middle);
  const space::Vector near = space::rounded(middle);
  const double tolerance = margin::kWiderBox * space::size_of(near);
  for (std::size_t k = 0; k < cover.sets.size(); ++k) {
    if (!cover.extents[k].holds(near, tolerance)) continue;
    const auto& set = cover.sets[k];
    const bool begins = std::all_of(set.begin(), set.end(), [&](const HalfSpace& h) {
      const int sign = h.sign(middle, near);
      return sign < 0 || (sign == 0 && space::dot(h.normal, u).sign() < 0);
    });
    if (begins && std::all_of(set.begin(), set.end(), [&](const HalfSpace& h) { return !polygon.sides(h).outside; }))
      return true;
  }
  return false;
}

/// Stretches in the union of the open sets, from frontier to frontier.
std::optional<LongestRun> run_in(const RayCover& cover, const RealVector& u) {
  const std::vector<ConvexRegion> frontier = space::cover_frontier(cover.sets, cover.low, cover.high);
  std::vector<RunStart> starts;
  for (const ConvexRegion& piece : frontier) {
    if (piece.dimension() < 2) continue;
    auto plane = crossed_plane(piece, u);
    if (plane && entered(piece, cover, u)) starts.push_back({piece, *std::move(plane)});
  }
  return space::longest_run(frontier, starts, u, cover.low, cover.high);
}

/// Stretches in what the closures of the sets leave.
std::optional<LongestRun> run_between(const RayCover& cover, const RealVector& u) {
  std::vector<ConvexRegion> closed;
  std::vector<RunStart> starts;
  for (const auto& set : cover.sets) {
    ConvexRegion region = cut_from(cover.low, cover.high, set);
    if (region.dimension() < 3) continue;
    for (const int f : region.facets()) {
      const HalfSpace& plane = region.planes()[static_cast<std::size_t>(f)];
      if (f < 6 || space::dot(plane.normal, u).sign() <= 0) continue;  // the box
      ConvexRegion facet = region;
      facet.cut(plane.opposite());
      starts.push_back({std::move(facet), plane});
    }
    closed.push_back(std::move(region));
  }
  return space::longest_run(closed, starts, u, cover.low, cover.high);
}

/// U; A has no radius, nor has B.
Answer least_gap(const Body& b, const Body& a, const RealVector& direction, bool both_ways) {
  const RayCover cover = overlap_sets(b, a);
  if (const auto run = run_in(cover, direction)) return least_of_run(run->length, run->middle, direction, both_ways);
  return touching(space::minus(space::real(a.parts[0].vertices()[0]), space::real(b.parts[0].vertices()[0])));
}

/// E; A has no radius, and B only where A is convex.
TriedAnswer least_fit(const Body& b, const Body& a, const RealVector& direction, bool both_ways) {
  const RayCover cover = outside_sets(b, a);
  if (cover.all) return std::nullopt;
  if (const auto run = run_between(cover, direction))
    return least_of_run(run->length, run->middle, direction, both_ways);
  const auto somewhere = space::farthest_in_complement(cover.lazy(), cover.low, cover.high, cover.low);
  if (!somewhere) return somewhere.refusal();
  if (!*somewhere) return std::nullopt;
  return touching(**somewhere);
}

/// Found by search, to be confirmed at `at`.
TriedAnswer least_of_search(const RoundRunQuery& query, bool both_ways) {
  const RoundRun run = longest_round_run(query);
  const double noise = margin::kRayCertain * space::length(query.box.high - query.box.low);
  if (run.length <= noise) return Refusal("no position of depth was found along the direction");
  const auto value = [&](double length) { return -Real::from_double(length) / Real(both_ways ? 2 : 1); };
  Answer out = least_answer(value(run.length), value(run.bound), false, space::real(run.middle));
  if (!both_ways) out.side = Side::kNone;
  return out;
}

RoundRunQuery round_query(const RealVector& low, const RealVector& high, const RealVector& direction) {
  const RealVector unit = space::scaled(Real(1) / sqrt(space::dot(direction, direction)), direction);
  return {{}, false, {space::rounded(low), space::rounded(high)}, space::rounded(unit)};
}

/// The positions less than the radius from the set of the planes, or from the point.
TouchingConstraint grown_constraint(const GrownSet& set) {
  const double radius = set.radius.to_double();
  if (set.planes.empty()) return less_radius(distance_to_point(space::rounded(set.center)), radius);
  return set.radius.sign() == 0 ? highest_plane(set.planes, {}) : touching_way(way_to(set.planes), {}, radius);
}

TriedAnswer round_gap(const Body& b, const Body& a, const RealVector& direction, bool both_ways) {
  const space::Bounds3 of_a = bounds(a), of_b = bounds(b);
  RoundRunQuery query = round_query(space::minus(of_a.low, of_b.high), space::minus(of_a.high, of_b.low), direction);
  for (const GrownSet& set : differences_of_parts(a, b)) query.sets.push_back(grown_constraint(set));
  return least_of_search(query, both_ways);
}

/// A has no radius, or is one convex part.
TriedAnswer round_fit(const Body& b, const Body& a, const RealVector& direction, bool both_ways) {
  const auto box = space::fitting(bounds(b), bounds(a));
  if (!box) return std::nullopt;
  RoundRunQuery query = round_query(box->low, box->high, direction);
  if (a.convex()) {
    const PositionSet fits = PositionSet::inside(b, a.parts[0], box->low, box->high);
    query.sets.push_back([corners = fits.constraints().convex](const space::Vector& x) {
      Touching most = corners[0](x);
      for (std::size_t k = 1; k < corners.size(); ++k) {
        const Touching next = corners[k](x);
        if (next.value > most.value) most = next;
      }
      return most;
    });
    return least_of_search(query, both_ways);
  }
  query.between = true;
  for (const GrownSet& set : differences_of_outside(a, b)) query.sets.push_back(grown_constraint(set));
  return least_of_search(query, both_ways);
}

/// E of a ball in a convex part that is round: nothing where it is something else.
struct BallFits {
  ConvexRegion positions;
  Real radius;
};
std::optional<BallFits> ball_fits(const Body& b, const Body& a) {
  if (!b.convex() || !b.parts[0].point() || !a.convex()) return std::nullopt;
  BallFits out{difference_core(a.parts[0], b.parts[0]), a.parts[0].radius - b.parts[0].radius};
  if (out.radius.sign() >= 0) return out;
  ConvexRegion worn = out.positions;
  for (const HalfSpace& h : out.positions.planes()) {
    if (a.parts[0].point()) return BallFits{ConvexRegion({}, {}), Real(-1)};
    worn.cut(HalfSpace(h.normal, h.offset - out.radius * sqrt(space::dot(h.normal, h.normal))));
  }
  return BallFits{std::move(worn), Real()};
}

constexpr long kCellsOfUnionFit = 1500;  // each takes searches

/// Of round parts.
TriedAnswer least_fit_in_union(const Body& b, const Body& a, const RealVector& direction, bool both_ways) {
  space::Vector near = space::rounded(space::fitting(bounds(b), bounds(a)).value_or(bounds(a))).middle();
  const FitSearch search = [&](const Body& swept, std::int64_t finer) -> exact::Tried<SweptFit> {
    const Body outer = at_scale(a, a.scale * finer);
    const auto box = space::fitting(bounds(swept), bounds(outer));
    if (!box) return SweptFit{SweptFit::Found::kNowhere};
    return any_fit(fits_in_union(swept, outer, space::rounded(*box)), space::scaled(double(finer), near),
                   kCellsOfUnionFit);
  };
  return least_of_swept_fits(b, bounds(a), direction, both_ways, search);
}

TriedAnswer least_eta(const Body& b, const Body& a, const RealVector& direction, bool both_ways) {
  if (!a.round() && (a.convex() || !b.round())) return least_fit(b, a, direction, both_ways);
  if (const auto ball = ball_fits(b, a)) {
    if (ball->radius.sign() < 0) return std::nullopt;
    return convex_directional_least(ball->positions, ball->radius, direction, both_ways);
  }
  if (a.round() && !a.convex()) return least_fit_in_union(b, a, direction, both_ways);
  return round_fit(b, a, direction, both_ways);
}

}  // namespace

std::optional<Answer> convex_directional_least(const ConvexRegion& positions, const Real& radius,
                                               const RealVector& direction, bool both_ways) {
  if (positions.empty()) return std::nullopt;
  if (radius.sign() == 0 && positions.dimension() < 3) return touching(positions.vertices()[0].at);
  const space::LongestChord chord =
      radius.sign() > 0 ? longest_chord(positions, radius, direction) : longest_chord(positions, direction);
  return least_of_run(chord.length, chord.inside ? std::optional(chord.middle) : std::nullopt, direction, both_ways);
}

TriedAnswer ray_directional_least(Which which, const RealVector& direction, bool both_ways, const Body& b,
                                  const Body& a) {
  if (a.outside || b.outside) return Refusal("over all positions a distance to a complement has no least value");
  switch (which) {
    case Which::kGamma1:
      if (!a.round() && !b.round()) return least_gap(b, a, direction, both_ways);
      if (a.convex() && b.convex()) {
        return convex_directional_least(difference_core(a.parts[0], b.parts[0]), a.parts[0].radius + b.parts[0].radius,
                                        direction, both_ways);
      }
      return round_gap(b, a, direction, both_ways);
    case Which::kEta1:
      return least_eta(b, a, direction, both_ways);
    case Which::kDelta1:  // A in B + p is -A + p in -B
      return least_eta(mirrored(a), mirrored(b), direction, both_ways);
    default:
      return Refusal("least values along a direction are computed in 3D of gap, eta1 and delta1 only");
  }
}

}  // namespace findspace::distance
