// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/solid/solid_least.h"

#include <algorithm>
#include <memory>

#include "distance/search/convex_distance.h"
#include "distance/search/least_in_box.h"
#include "distance/search/position_set.h"
#include "distance/search/round_solid.h"
#include "distance/solid/far_corners.h"
#include "exact/margins/space_distance.h"
#include "space/body/body_boxes.h"
#include "space/body/outside_cells.h"
#include "space/body/union_frontier.h"
#include "space/polytope/deepest.h"
#include "space/polytope/min_ball.h"

namespace findspace::distance {

using exact::Real;
using space::Body, space::ConvexRegion, space::HalfSpace, space::RealVector, space::Vector;

namespace {

/// Convex sets that are to be kept away from, each with its planes, the ones that can bound a ball.
struct Obstacles {
  std::vector<Tetrahedron> domain;
  std::vector<ConvexDistance> distances;
  std::vector<std::vector<HalfSpace>> planes;
};

/// The planes that obstacles near `place` turn to it: the ball about the place touches their insides.
std::vector<HalfSpace> touched_planes(const Obstacles& all, const Vector& place, double radius) {
  const double slack = margin::kTouchedPlane * (radius + margin::kTouchedOfSize * space::size_of(place));
  std::vector<HalfSpace> planes;
  for (std::size_t k = 0; k < all.distances.size(); ++k) {
    if (all.distances[k](place) > radius + slack) continue;
    for (const HalfSpace& h : all.planes[k]) {
      if (std::fabs(h.approx_value(place) - radius) <= slack) planes.push_back(h.opposite());
    }
  }
  return planes;
}

/// Positions near a place that is known to rounding, of numbers that the true one may well have.
std::vector<RealVector> likely_places(const Obstacles& all, const Vector& place, double radius) {
  std::vector<RealVector> out;
  const double tolerance = margin::kLikelyBox * (radius + space::size_of(place)) + 1;
  const Vector by{tolerance, tolerance, tolerance};
  if (const auto exact = space::deepest(touched_planes(all, place, radius), space::real(place - by),
                                        space::real(space::plus(place, by))))
    out.push_back(exact->at);
  RealVector even = space::real(place);
  for (Real& c : even) c = simple(c.to_double(), margin::kSimpleCoordinate * (radius + 1));
  out.push_back(even);
  out.push_back(space::real(place));
  return out;
}

/// Of a signed distance: -(max-min value - radius).
TriedAnswer deepest_place(const Obstacles& all, const Real& radius, const RealVector& somewhere,
                          const std::function<TriedAnswer(const RealVector&)>& value) {
  const double size = space::size_of(space::rounded(somewhere)) + radius.to_double() + 1;
  const SolidMaxMin max_min =
      all.domain.empty() ? SolidMaxMin{} : solid_max_min({all.domain}, all.distances, margin::kTangentNoise * size);
  const Real bound = radius - Real::from_double(max_min.bound + margin::kTangentNoise * size);
  std::optional<Answer> best;
  std::optional<exact::Refusal> refused;
  // Values are right to 2^-40, so what is less by less than that is no better than a likelier place.
  const Real blur = Real::from_double(margin::kNoBetter * size);  // no sign: it chooses among positions
  const auto offer = [&](const RealVector& p) {
    if (refused) return;
    const TriedAnswer found = value(p);
    if (!found) {
      refused = found.refusal();
      return;
    }
    const std::optional<Answer>& v = *found;
    // A round shape may not fit there.
    if (!v || !(v->error < exact::kInfinity) || (best && !(v->value < best->value - blur))) return;
    best = least_answer(v->value, std::min(bound, v->value), false, p);
  };
  if (max_min.value > 0) {
    for (const RealVector& p : likely_places(all, max_min.place, max_min.value)) offer(p);
  }
  if (!best) offer(somewhere);
  if (refused) return *refused;
  return best;
}

class Least {
 public:
  Least(const Body& b, const Body& a)
      : b_(b), a_(a), pair_(solid_pair(std::make_shared<const Body>(b), std::make_shared<const Body>(a))) {
    const space::Bounds3 box = space::meeting(bounds(b), bounds(a));
    low_ = box.low;
    high_ = box.high;
  }

  TriedAnswer of(Which which) const {
    switch (which) {
      case Which::kGamma1:
        return a_.round() || b_.round() ? searched(which, -exact::kInfinity) : overlap();
      case Which::kEta1:
        return a_.round() || radii_differ() ? searched(which, -exact::kInfinity) : containment();
      case Which::kMu:
        if (!a_.round() && !radii_differ()) {
          TriedAnswer fits = containment();
          if (!fits || *fits) return fits;
        }
        return searched(which, -exact::kInfinity);
      case Which::kGamma2:
        return reach();
      case Which::kDiameter:
        return at_least(reach(), std::max(diameter(a_), diameter(b_)));
      case Which::kEta2:
        return farthest_fit();
      case Which::kD1:
      case Which::kPenetration:
      case Which::kDstarBack:
        return least_zero(which, {low_, high_},
                          space::minus(space::real(a_.parts[0].vertices()[0]), space::real(b_.parts[0].vertices()[0])));
      case Which::kH:
        return at_least(of(Which::kMu), Real());
      case Which::kHausdorff:
        return searched(which, 0);
      default:
        return searched(which, -exact::kInfinity);
    }
  }

 private:
  bool radii_differ() const {
    return !a_.convex() && std::any_of(b_.parts.begin(), b_.parts.end(),
                                       [&](const space::BodyPart& part) { return part.radius != b_.parts[0].radius; });
  }

  Obstacles around_overlap() const {
    const space::OpenUnion cover = space::overlap_cover(b_, a_);
    RealVector low = low_, high = high_;
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] -= Real(1);
      high[k] += Real(1);
    }
    std::vector<std::vector<HalfSpace>> sets;
    Obstacles all;
    for (std::size_t k = 0; k < cover.size(); ++k) {
      sets.push_back(cover.planes(k));
      ConvexRegion body(low, high);
      for (const HalfSpace& h : sets.back()) body.cut(h);
      const std::vector<Tetrahedron> more = tetrahedra(body);
      all.domain.insert(all.domain.end(), more.begin(), more.end());
    }
    for (const ConvexRegion& piece : space::cover_frontier(sets, low, high)) {
      all.distances.push_back(distance_to_flat(piece));
      all.planes.emplace_back();
      for (const HalfSpace& h : piece.planes()) {
        const ConvexRegion::Sides sides = piece.sides(h);
        if (!sides.inside && !sides.outside) all.planes.back().push_back(h);
      }
    }
    return all;
  }

  TriedAnswer overlap() const {
    return deepest_place(around_overlap(), Real(), low_,
                         [&](const RealVector& p) { return pair_.try_value(Which::kGamma1, p); });
  }

  TriedAnswer containment() const {
    const auto box = space::fitting(bounds(b_), bounds(a_));  // where B can be at all
    if (!box) return std::nullopt;
    const RealVector &low = box->low, &high = box->high;
    Body core = b_;
    Real radius;
    if (!a_.convex()) {
      radius = b_.parts[0].radius;
      for (space::BodyPart& part : core.parts) {
        part.radius = Real();
      }
    }
    const std::vector<space::OutsideCell> cells = space::outside_cells(a_);
    const space::OpenUnion cover = space::outside_cover(core, cells);
    const auto somewhere = space::farthest_in_complement(cover, low, high, low);
    if (!somewhere) return somewhere.refusal();
    if (!*somewhere) return std::nullopt;
    Obstacles all;
    for (const ConvexRegion& piece : space::complement_pieces(cover, low, high)) {
      const std::vector<Tetrahedron> more = tetrahedra(piece);
      all.domain.insert(all.domain.end(), more.begin(), more.end());
    }
    if (all.domain.empty() && radius.sign() == 0) return least_answer(Real(), Real(), true, **somewhere);
    for (std::size_t k = 0; k < cover.size(); ++k) {
      all.distances.push_back(distance_to(cover.planes(k)));
      all.planes.push_back(cover.planes(k));
    }
    auto found =
        deepest_place(all, radius, **somewhere, [&](const RealVector& p) { return pair_.try_value(Which::kEta1, p); });
    // Where it fits nowhere with its radius the value says so, or that this is not decided.
    return found && !*found && radius.sign() > 0 ? searched(Which::kEta1, -exact::kInfinity) : found;
  }

  TriedAnswer farthest_fit() const {
    if (a_.round() || b_.round()) return searched(Which::kEta2, 0);
    const auto box = space::fitting(bounds(b_), bounds(a_));
    if (!box) return std::nullopt;
    auto [low, high] = *box;
    const std::vector<space::OutsideCell> cells = space::outside_cells(a_);
    const space::OpenUnion cover = space::outside_cover(b_, cells);
    const auto somewhere = space::farthest_in_complement(cover, low, high, low);
    if (!somewhere) return somewhere.refusal();
    if (!*somewhere) return std::nullopt;
    std::vector<std::vector<HalfSpace>> sets;
    for (std::size_t k = 0; k < cover.size(); ++k) sets.push_back(cover.planes(k));
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] -= Real(1);
      high[k] += Real(1);
    }
    std::vector<RealVector> points;
    for (const ConvexRegion& piece : space::cover_frontier(sets, low, high)) {
      for (const ConvexRegion::Vertex& v : piece.vertices()) points.push_back(v.at);
    }
    const space::EnclosingBall ball = space::min_ball(points);
    const Real value = sqrt(ball.square);
    return least_answer(value, value, true, ball.center);
  }

  static TriedAnswer at_least(TriedAnswer found, const Real& floor) {
    if (!found) return found;
    std::optional<Answer> v = *std::move(found);
    if (v && v->value <= floor) return least_answer(floor, floor, true, v->at);
    if (v && v->enclosed && *v->enclosed->lower < floor) v->enclosed->lower = floor;
    return v;
  }

  /// The farthest points of A and B + p are vertices: the centre of the smallest ball around their differences is
  /// nearest to all.
  TriedAnswer reach() const {
    const Real round = a_.parts[0].radius + b_.parts[0].radius;
    std::vector<RealVector> points;
    for (const space::BodyPart& t : a_.parts) {
      for (const space::BodyPart& s : b_.parts) {
        if (t.radius + s.radius != round) return searched(Which::kGamma2, 0);
        for (const space::Point& v : t.vertices()) {
          for (const space::Point& w : s.vertices()) points.push_back(space::real(v - w));
        }
      }
    }
    const space::EnclosingBall ball = space::min_ball(points);
    const Real value = sqrt(ball.square) + round;
    return least_answer(value, value, true, ball.center);
  }

  TriedAnswer searched(Which which, double floor) const {
    const bool convex = which == Which::kGamma2 || which == Which::kEta2 ||
                        (a_.convex() && (which == Which::kMu || (which == Which::kHausdorff && b_.convex())));
    return least_of_values(which, pair_, {low_, high_}, {floor, convex});
  }

  const Body &b_, &a_;
  PairDistances pair_;
  RealVector low_, high_;  // beyond this box the bodies' boxes do not meet: every distance grows
};

bool of_back(Which which) {
  return which == Which::kDelta1 || which == Which::kDelta2 || which == Which::kMuBack || which == Which::kHBack ||
         which == Which::kDstar;
}

}  // namespace

TriedAnswer least_of_values(Which which, const PairDistances& pair, const space::Bounds3& box,
                            const LeastQuery& query) {
  const TriedAnswer corner = pair.try_value(which, box.low);
  if (!corner || !*corner) return corner;
  const Vector low = space::rounded(box.low), high = space::rounded(box.high);
  const auto value = [&](const RealVector& p) -> exact::Tried<Answer> {
    TriedAnswer v = pair.try_value(which, p);
    if (!v) return v.refusal();
    return **std::move(v);
  };
  if (query.convex) {
    TriedAnswer v = convex_least(value, low, high);
    if (!v || *v) return v;
  }
  exact::Tried<Answer> least = least_in_box(value, low, high, query.floor, query.most);
  if (!least) return least.refusal();
  return *std::move(least);
}

Answer least_zero(Which which, const space::Bounds3& box, const RealVector& meeting) {
  RealVector at = which == Which::kD1 ? meeting : box.high;
  if (which != Which::kD1) at[0] += Real(1);
  return least_answer(Real(), Real(), true, at);
}

TriedAnswer solid_least(Which which, const Body& b, const Body& a) {
  if (a.outside || b.outside) return exact::Refusal("over all positions a distance to a complement has no least value");
  if (!of_back(which)) return Least(b, a).of(which);
  // A in B + p is -A + p in -B.
  const Body back_b = mirrored(a), back_a = mirrored(b);
  return Least(back_b, back_a).of(exchanged(which));
}

}  // namespace findspace::distance
