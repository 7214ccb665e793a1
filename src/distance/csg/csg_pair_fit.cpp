// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How deep B of a CsgSide is in A. And where it fits into a union of solids that balls are cut out of: it is in the
// union where it is free of what that leaves of a box about both. And the least values of all distances.
#include <algorithm>
#include <cmath>

#include "distance/csg/csg_pair.h"
#include "distance/csg/csg_part.h"
#include "distance/search/set_protrusion.h"
#include "distance/solid/far_corners.h"
#include "distance/solid/solid_least.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"
#include "space/body/cell_parts.h"
#include "space/body/outside_cells.h"

namespace findspace::distance {

using exact::Real;
using exact::Tried;
using space::Point;
using space::RealVector;
using space::Vector;

/// The distance to the nearest position at which B is free of a container, or in an obstacle, and so free of A.
std::optional<Answer> CsgSide::free_of_sets(const RealVector& p) const {
  std::optional<Answer> best;
  const auto take = [&](const TriedAnswer& found, bool negated) {
    if (!found || !*found) return;
    Answer v = negated ? minus(**found) : **found;
    if (!v.proven && !(v.nearest && v.error <= margin::kMostFoundError * size_)) return;
    if (!best || v.value < best->value) best = std::move(v);
  };
  // Others take a search as long as that for what they are to help with.
  const auto exact = [](const space::Body& body) { return body.convex() || !body.round(); };
  for (std::size_t k = 0; k < containers_.size(); ++k) {
    if (exact(a_->containers[k])) take(containers_[k].try_value(Which::kGamma1, p), true);
  }
  for (std::size_t k = 0; k < obstacles_.size(); ++k) {
    if (exact(a_->obstacles[k])) take(obstacles_[k].try_value(Which::kEta1, p), false);
  }
  return best;
}

TriedAnswer CsgSide::overlapping(const RealVector& p) const {
  const Tried<PositionSet>& free = this->free();
  if (!free) return free.refusal();
  const std::optional<Answer> known = free_of_sets(p);
  TriedAnswer found = free->nearest(p, true, [&] { return known; });
  if (!found) return found;
  return minus(**std::move(found));
}

namespace {

bool inside(const RealVector& p, const space::Bounds3& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (p[k] < box.low[k] || box.high[k] < p[k]) return false;
  }
  return true;
}

}  // namespace

struct CsgSide::Among {
  space::Bounds3 places;  // beyond this B protrudes from the box about A
  std::unique_ptr<const CsgSide> left;
  Real parts{1};  // of a step, that `places` and `left` are in

  /// Of B in A.
  Tried<PositionSet> fits() const {
    const Tried<PositionSet>& free = left->free();
    if (!free) return free.refusal();
    return free->within(space::rounded(places));
  }
  TriedAnswer in_steps(TriedAnswer v) const {
    if (!v || !*v) return v;
    return std::optional(in_unit(**v, Real(1) / parts));
  }
};

/// Minus how deep B + p is in A; nothing where it is not in A.
TriedAnswer CsgSide::inside_among(const Among& all, const RealVector& position) {
  const RealVector p = space::scaled(all.parts, position);
  if (!inside(p, all.places)) return std::nullopt;
  Tried<Gap> gap = all.left->gap_at(p);
  if (!gap) return gap.refusal();
  if (gap->depth > 0) return std::nullopt;
  return all.in_steps(std::optional(minus(std::move(gap->value))));
}

/// The same, and how far B + p is from fitting.
TriedAnswer CsgSide::fit_among(const Among& all, const RealVector& position) {
  TriedAnswer held = inside_among(all, position);
  if (!held || *held) return held;
  const Tried<PositionSet> fits = all.fits();
  if (!fits) return fits.refusal();
  return all.in_steps(fits->nearest(space::scaled(all.parts, position), false));
}

TriedAnswer CsgSide::farthest_among(const Among& all, const RealVector& position) {
  const Tried<PositionSet> fits = all.fits();
  if (!fits) return fits.refusal();
  return all.in_steps(fits->farthest(space::scaled(all.parts, position)));
}

CsgSide::TriedAmong CsgSide::made_among() const {
  const space::Bounds3 outer = bounds(*a_), inner = bounds(*b_);
  auto out = std::make_shared<Among>();
  const auto places = space::fitting(inner, outer);
  if (!places) return std::shared_ptr<const Among>();
  out->places = *places;
  std::array<std::int64_t, 3> low{}, high{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double from = outer.low[k].to_double(), to = outer.high[k].to_double(), tolerance = (to - from) / 4 + 2;
    low[k] = static_cast<std::int64_t>(std::floor(from - tolerance));
    high[k] = static_cast<std::int64_t>(std::ceil(to + tolerance));
  }
  auto left = left_in_box(*a_, Point{low[0], low[1], low[2]}, Point{high[0], high[1], high[2]});
  if (!left) return left.refusal();
  if (left->walls) return left_walls();
  out->left = std::make_unique<const CsgSide>(b_, std::make_shared<const space::CsgSolid>(*std::move(left)));
  return std::shared_ptr<const Among>(std::move(out));
}

/// Cells of the outside, and what bounds the box about the fixed one on each side.
CsgSide::TriedAmong CsgSide::among_cells(const space::Body& fixed, const space::CsgSolid& moving,
                                         const space::Bounds3& places) {
  const space::Bounds3 box = bounds(fixed);
  const RealVector wide = space::minus(box.high, box.low);
  const space::Bounds3 around{space::minus(box.low, wide), space::plus(box.high, wide)};
  std::vector<space::ConvexRegion> cells;
  for (const space::HalfSpace& wall : space::walls(box)) {
    space::ConvexRegion beyond(around.low, around.high);
    beyond.cut(wall.opposite());
    cells.push_back(std::move(beyond));
  }
  for (const space::OutsideCell& cell : space::outside_cells(fixed)) {
    if (!cell.bounded()) continue;
    space::ConvexRegion region(box.low, box.high);
    for (const space::HalfSpace& h : cell.planes) region.cut(h);
    if (region.dimension() == 3) cells.push_back(std::move(region));
  }
  const space::Body left = space::body_of(space::parts_of_cells(cells));
  if (left.rounded > 0)
    return exact::Refusal(
        "the outside of the shape has corners off every fine grid: whether another fits is not computed");
  auto out = std::make_shared<Among>();
  out->parts = Real(left.scale);
  out->places = {space::scaled(out->parts, places.low), space::scaled(out->parts, places.high)};
  auto solid = moving;
  solid.scale = 1;
  space::Body finer = left;
  finer.scale = 1;
  out->left = std::make_unique<const CsgSide>(std::make_shared<const space::Body>(std::move(finer)),
                                              std::make_shared<const space::CsgSolid>(at_scale(solid, left.scale)));
  return std::shared_ptr<const Among>(std::move(out));
}

TriedAnswer CsgSide::contained_in_union(const RealVector& p) const { return in_union(p, &CsgSide::fit_among); }

/// Minus how deep B + p is in A, or more than 0 or nothing: how far it is from fitting is not asked.
TriedAnswer CsgSide::inside_union(const RealVector& p) const { return in_union(p, &CsgSide::inside_among); }

TriedAnswer CsgSide::in_union(const RealVector& p, TriedAnswer (*among_all)(const Among&, const RealVector&)) const {
  const TriedAmong& made = among();
  if (!made) return made.refusal();
  const std::shared_ptr<const Among>& all = *made;
  if (!all) return std::nullopt;
  if (point_) {
    // What A leaves says how deep a point lies in A; else it is as far from A.
    if (a_->walls) return left_walls();
    TriedAnswer apart = this->apart(p);
    if (!apart || away(**apart)) return apart;
  }
  return among_all(*all, p);
}

TriedAnswer CsgSide::farthest_in_union(const RealVector& p) const {
  const TriedAmong& made = among();
  if (!made) return made.refusal();
  if (!*made) return std::nullopt;
  return farthest_among(**made, p);
}

Tried<SweptFit> CsgSide::fits_somewhere() const {
  if (!by_containers()) {
    const TriedAmong& made = among();
    if (!made) return made.refusal();
    if (!*made) return SweptFit{SweptFit::Found::kNowhere};
    const Tried<PositionSet> fits = (*made)->fits();
    if (!fits) return fits.refusal();
    return any_fit(*fits, fits->box().middle(), plane::kMostCellsOfQuestion / plane::kShareOfSearch / 4);
  }
  const TriedFits& fits = this->fits();
  if (!fits) return fits.refusal();
  if (!*fits) return SweptFit{SweptFit::Found::kNowhere};
  const double least = margin::kNoDepth * size_;
  const Slack most = (*fits)->deepest({least, 0});
  if (most.value > least) return SweptFit{SweptFit::Found::kSomewhere, most.place};
  return SweptFit{most.bound <= least ? SweptFit::Found::kNowhere : SweptFit::Found::kUnknown};
}

/// eta1 less the level; for levels up to 0 the slack of what protrudes takes the place of how far that is from none.
TriedBetween CsgSide::nearly_in_union(const RealVector& p, double level) const {
  const TriedAmong& made = among();
  if (!made) return made.refusal();
  const std::shared_ptr<const Among>& all = *made;
  if (!all) return std::nullopt;
  const double error = margin::kFoundError * size_, least = space::rounded(all->places).distance(space::rounded(p));
  if (least > 0 && (level <= 0 || least - error > level)) return Between{least - error - level, exact::kInfinity};
  if (inside(p, all->places)) {
    const Tried<double> slack = all->left->common_depth(p, margin::kDepthOnLines);
    if (!slack) return slack.refusal();
    if (!(*slack > 0)) {
      const Between gap = all->left->nearly_apart(p, -level);  // the gap, plus the level
      return Between{-gap.high, -gap.low};
    }
    if (level <= 0) return Between{*slack - level, exact::kInfinity};
  }
  const Until until{level, 0.5};
  const Tried<PositionSet> fits = all->fits();
  if (!fits) return fits.refusal();
  const BoundaryPlace found = fits->nearest_to(distance_to_point(space::rounded(p)), {0, {}, &until});
  if (!found.found && !found.unresolved && found.complete && found.bound == exact::kInfinity) return std::nullopt;
  return Between{found.bound - error - level, found.value + error - level};
}

namespace {

constexpr int kMostCutValues = 200, kMostGapCells = 150;  // each takes a search of its own

}  // namespace

/// A point of B at a place within A.
Tried<RealVector> CsgSide::meeting() const {
  for (const CsgPartSearch& part : parts_) {
    const Slack most = part.places.deepest({});
    const RealVector at = space::real(most.place);
    if (most.value > 0 && holds(*part.sets, at)) return space::minus(at, space::real(b_->parts[0].vertices()[0]));
  }
  return not_found_in_part();
}

/// Minus the slack of E.
TriedAnswer CsgSide::least_fit() const {
  if (containers_.empty()) return std::nullopt;
  const TriedFits& fits = this->fits();
  if (!fits || !*fits) return std::nullopt;
  const double error = margin::kFoundError * size_;
  const Slack most = (*fits)->deepest({0, 1, error});
  if (!(most.value > 0)) return std::nullopt;
  const RealVector at = space::real(most.place);
  const TriedAnswer v = fit(at);
  if (!v || !*v) return v;
  return std::optional(least_taken(at, **v, Real::from_double(-most.bound - error)));
}

/// At no position is B deeper in A than in what holds A: the highest of the least gaps.
std::optional<Answer> CsgSide::least_gap_to_container() const {
  std::optional<Answer> best;
  for (const space::Body& container : a_->containers) {
    if (container.outside || !container.convex()) continue;
    TriedAnswer v = solid_least(Which::kGamma1, *b_, container);
    if (!v || !*v || !(*v)->bounds().lower) continue;
    if (!best || *best->bounds().lower < *(*v)->bounds().lower) best = **std::move(v);
  }
  return best;
}

namespace {

/// Minus the depth at the place of a search that ended before, as near as that knows it.
Answer within_search(const SetProtrusion& out, double error) {
  const double low = out.found.value - error, high = space::length(out.found.place - out.nearest) + error;
  return unproven_answer(Real::from_double(-low), {Real::from_double(-high), Real::from_double(-low)});
}

}  // namespace

/// Minus how far a position is from being free: of all within a box, out of which all are.
TriedAnswer CsgSide::least_gap() const {
  if (a_->walls) return left_walls();
  if (points_) return std::nullopt;
  const Tried<PositionSet>& free = this->free();
  if (!free) return free.refusal();
  const plane::SearchQuestion question;
  const PositionSet around = free->within(grown(free->box(), size_ / 8));
  // Out of one container, or in one obstacle, B is free.
  NearSet set{&around};
  set.known = [this](const Vector& x) -> std::optional<Vector> {
    const std::optional<Answer> free = free_of_sets(space::real(x));
    if (free && free->value.sign() <= 0) return x;
    return free && free->nearest ? std::optional(space::rounded(*free->nearest)) : std::nullopt;
  };
  const double error = margin::kFoundError * size_;
  ProtrusionEnd end{kMostGapCells};
  if (const std::optional<Answer> held = least_gap_to_container()) {
    end.ceiling = error - held->bounds().lower->to_double();
    end.first = space::rounded(held->at);
  }
  const Tried<SetProtrusion> out =
      set_protrusion({tetrahedra_of_box(free->box())}, {set}, size_, margin::kDeepestGap * size_, nullptr, end);
  if (!out) return plane::search_spent("the deepest overlap with a shape that round ones are cut out of was not found");
  const RealVector at = space::real(out->found.place);
  TriedAnswer v = gap(at, Depth::kValue);
  if (!v && question.work().spent()) v = within_search(*out, error);
  if (!v) return v;
  return std::optional(least_taken(at, **v, Real::from_double(-out->found.bound - error)));
}

namespace {

/// Of B that moves.
class CutLeast {
 public:
  explicit CutLeast(const std::shared_ptr<const CsgSide>& side)
      : side_(*side),
        pair_(csg_pair(side, false)),
        box_(space::meeting(bounds(side->complete()), bounds(side->cut()))) {}

  TriedAnswer of(Which which) const {
    switch (which) {
      case Which::kD1:
      case Which::kPenetration:
      case Which::kDstar:
      case Which::kDstarBack:
        return zero(which);
      case Which::kGamma1:
        return or_searched(side_.least_gap(), which);
      case Which::kEta1:
      case Which::kMu:  // where B fits they are equal
        return or_searched(side_.least_fit(), which);
      case Which::kH:
        return at_least(which, of(Which::kMu), Real());
      case Which::kHBack:
        return side_.complete().convex() ? at_least(which, of(Which::kMuBack), Real()) : searched(which);
      case Which::kDiameter:
        return diameter();
      default:
        return searched(which);
    }
  }

 private:
  TriedAnswer or_searched(TriedAnswer v, Which which) const { return !v || *v ? std::move(v) : searched(which); }

  TriedAnswer searched(Which which) const {
    const bool back = which == Which::kMuBack || which == Which::kDelta1;
    LeastQuery query;
    query.convex = which == Which::kGamma2 || which == Which::kEta2 || which == Which::kDelta2 ||
                   (back && side_.complete().convex());
    if (which == Which::kHausdorff || which == Which::kHBack) query.floor = 0;
    query.most = kMostCutValues;
    return least_of_values(which, pair_, box_, query);
  }

  TriedAnswer zero(Which which) const {
    const Tried<RealVector> meeting = which == Which::kD1 ? side_.meeting() : Tried<RealVector>(box_.high);
    if (!meeting) return meeting.refusal();
    return std::optional(least_zero(which, box_, *meeting));
  }

  /// Of a distance that is the greater one of `floor` and another, where that is least.
  TriedAnswer at_least(Which which, TriedAnswer base, const Real& floor) const {
    if (!base || !*base) return base;
    const TriedAnswer v = pair_.try_value(which, (*base)->at);
    if (!v || !*v) return v;
    return std::optional(least_taken((*base)->at, **v, std::max(*(*base)->bounds().lower, floor)));
  }

  TriedAnswer diameter() const {
    TriedAnswer reach = of(Which::kGamma2);
    if (!reach) return reach;
    const TriedAnswer& own = side_.own_diameter();
    if (!own) return own;
    return at_least(Which::kDiameter, std::move(reach),
                    std::max(*(*own)->bounds().lower, distance::diameter(side_.complete())));
  }

  const CsgSide& side_;
  PairDistances pair_;
  space::Bounds3 box_;
};

}  // namespace

TriedAnswer csg_least(Which which, const std::shared_ptr<const CsgSide>& side, bool cut_moves) {
  if (!cut_moves) return CutLeast(side).of(which);
  // A + p against B is A against B - p.
  TriedAnswer v = CutLeast(side).of(exchanged(which));
  if (v && *v) (*v)->at = space::negated((*v)->at);
  return v;
}

}  // namespace findspace::distance
