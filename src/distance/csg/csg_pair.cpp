// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/csg/csg_pair.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>

#include "distance/answer/answer.h"
#include "distance/csg/csg_part.h"
#include "distance/search/search_work.h"
#include "distance/search/solid_protrusion.h"
#include "exact/margins/space_distance.h"
#include "space/body/body_boxes.h"
#include "space/polytope/convex_region.h"

namespace findspace::distance {

using exact::Real;
using exact::Refusal;
using exact::Tried;
using space::Body;
using space::BodyPart;
using space::CsgPart;
using space::CsgSolid;
using space::RealVector;

CsgSide::CsgSide(std::shared_ptr<const Body> b, std::shared_ptr<const CsgSolid> a)
    : b_(std::move(b)), a_(std::move(a)) {
  size_ = cut_size(*b_, *a_);
  points_ = std::any_of(b_->parts.begin(), b_->parts.end(),
                        [](const BodyPart& part) { return part.point() && part.radius.sign() == 0; });
  point_ = points_ && b_->parts.size() == 1;
  for (const CsgPart& part : a_->parts) {
    CsgPartSearch search = csg_part_search(part, size_);
    if (!search.empty) parts_.push_back(std::move(search));
  }
  for (const Body& body : a_->containers) containers_.push_back(solid_pair(b_, std::make_shared<const Body>(body)));
  for (const Body& body : a_->obstacles) obstacles_.push_back(solid_pair(b_, std::make_shared<const Body>(body)));
}

Refusal left_walls() {
  return Refusal("not computed where a rounded shape that is taken away is flush with another: let them overlap");
}

/// How B + p fits, by each container and obstacle alone: the worst of them, which is no more than what it is by all
/// together; nothing where one container is too small.
TriedAnswer CsgSide::worst_fit(const RealVector& p) const {
  std::optional<Answer> worst;
  const auto take = [&](Answer v) {
    if (!worst || worst->value < v.value) worst = std::move(v);
  };
  for (const auto& container : containers_) {
    TriedAnswer v = container.try_value(Which::kEta1, p);
    if (!v || !*v) return v;
    take(**std::move(v));
  }
  for (const auto& obstacle : obstacles_) {
    TriedAnswer v = obstacle.try_value(Which::kGamma1, p);
    if (!v) return v;
    take(minus(**std::move(v)));
  }
  return worst;
}

/// Whether the worst fit is the true one: B fits already, or where it next fits by that alone.
Tried<bool> CsgSide::is_whole(const Answer& worst) const {
  if (worst.value.sign() <= 0) return true;
  if (!worst.proven || !worst.nearest) return false;
  const TriedAnswer there = worst_fit(*worst.nearest);
  if (!there) return there.refusal();
  return *there && (*there)->proven && (*there)->value.sign() <= 0;
}

/// Whether made_fits() takes them; else A is a union of its parts.
bool CsgSide::by_containers() const {
  const auto taken = [](const Body& body) { return body.convex() || !(body.outside || body.round()); };
  return !containers_.empty() && (a_->walls || std::all_of(a_->containers.begin(), a_->containers.end(), taken));
}

TriedAnswer CsgSide::fit(const RealVector& p) const {
  if (containers_.empty()) return contained_in_union(p);
  TriedAnswer worst = worst_fit(p);
  if (!worst || !*worst) return worst;
  const Tried<bool> whole = is_whole(**worst);
  if (!whole) return whole.refusal();
  if (*whole) return worst;
  if (!by_containers()) return contained_in_union(p);
  const TriedFits& fits = this->fits();
  if (!fits) return fits.refusal();
  if (!*fits) return std::nullopt;
  return (*fits)->nearest(p, false);
}

CsgSide::TriedFits CsgSide::made_fits() const {
  std::optional<space::Bounds3> box;
  std::vector<PositionSet> all;
  const space::Bounds3 inner = bounds(*b_);
  for (const Body& container : a_->containers) {
    if (!container.convex() && (container.outside || container.round()))
      return Refusal(
          "how far a shape is from fitting into such a shape is not computed where a container is round and "
          "not convex");
    const space::Bounds3 outer = bounds(container);
    space::Bounds3 one{space::minus(outer.low, inner.low), space::minus(outer.high, inner.high)};
    if (!box) box = one;
    for (std::size_t k = 0; k < 3; ++k) {
      box->low[k] = std::max(box->low[k], one.low[k]);
      box->high[k] = std::min(box->high[k], one.high[k]);
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (box->high[k] < box->low[k]) return std::nullopt;
  }
  std::vector<GrownSet> sets;
  for (const Body& container : a_->containers) {
    if (container.convex()) {
      all.push_back(PositionSet::inside(*b_, container.parts[0], box->low, box->high));
      continue;
    }
    for (GrownSet& set : differences_of_outside(container, *b_)) sets.push_back(std::move(set));
  }
  for (const Body& obstacle : a_->obstacles) {
    for (GrownSet& set : differences_of_parts(obstacle, *b_)) sets.push_back(std::move(set));
  }
  all.push_back(PositionSet::outside(std::move(sets), box->low, box->high));
  return std::optional(PositionSet::common(all, box->low, box->high));
}

TriedAnswer CsgSide::farthest_fit(const RealVector& p) const {
  if (!by_containers()) return farthest_in_union(p);
  const TriedFits& fits = this->fits();
  if (!fits) return fits.refusal();
  if (!*fits) return std::nullopt;
  return (*fits)->farthest(p);
}

TriedAnswer CsgSide::protrusion(const RealVector& p, Depth /*depth*/) const {
  TriedAnswer worst = containers_.empty() ? inside_union(p) : worst_fit(p);
  // B that fits nowhere protrudes everywhere.
  if (!worst || (*worst && (*worst)->value.sign() <= 0)) return worst;
  if (a_->walls) return left_walls();
  return protrusion_out(p);
}

/// The gap and B's own width.
double CsgSide::protrudes_at_most(const RealVector& p) const {
  if (a_->walls) return exact::kInfinity;
  const TriedAnswer apart = this->apart(p);
  if (!apart) return exact::kInfinity;
  return (*apart)->value.to_double() + (*apart)->error + distance::diameter(*b_).to_double();
}

TriedAnswer CsgSide::clearance(const RealVector& p) const {
  TriedAnswer v = containers_.empty() ? inside_union(p) : worst_fit(p);
  if (!v) return v;
  return cut_off(*std::move(v), true);
}

TriedAnswer CsgSide::gap(const RealVector& p, Depth depth) const {
  if (a_->walls) return left_walls();
  if (points_) {
    TriedAnswer apart = this->apart(p);
    if (!apart || away(**apart) || depth == Depth::kSign) return apart;
    if (point_) return fit(p);  // they are one function
  }
  exact::Tried<Gap> found = gap_at(p);
  if (!found) return found.refusal();
  if (found->depth > 0 && depth == Depth::kValue) return overlapping(p);
  return std::optional(std::move(found->value));
}

/// How far B + p is from fitting, less a level above 0.
TriedBetween CsgSide::nearly_fits(const RealVector& p, double level) const {
  const TriedFits& made = this->fits();
  if (!made) return made.refusal();
  const std::optional<PositionSet>& fits = *made;
  if (!fits) return std::nullopt;
  const double least = fits->beyond(space::rounded(p)), error = margin::kFoundError * size_;
  if (least - error > level) return Between{least - error - level, exact::kInfinity};
  if (least + error < 0) return Between{-exact::kInfinity, least + error - level};
  const TriedAnswer worst = worst_fit(p);
  if (!worst) return worst.refusal();
  if (*worst) {
    const exact::Tried<bool> whole = is_whole(**worst);
    if (!whole) return whole.refusal();
    const double v = (*worst)->value.to_double();
    if (*whole) return Between{v - error - level, v + error - level};
  }
  const Until until{level, margin::kRoughShare};
  const BoundaryPlace found = fits->nearest_to(distance_to_point(space::rounded(p)), {least, {}, &until});
  if (!found.found && !found.unresolved && found.complete && found.bound == exact::kInfinity) return std::nullopt;
  return Between{std::max(least, found.bound) - error - level, found.value + error - level};
}

std::optional<TriedBetween> CsgSide::nearly(Which which, double level, const RealVector& p) const {
  const bool fit = which == Which::kEta1, out = which == Which::kMu;
  if (points_ && containers_.empty() && (fit || (out && level <= 0))) return std::nullopt;
  if ((fit || (out && level <= 0)) && containers_.empty()) return nearly_in_union(p, level);
  if (out && level > 0) return a_->walls ? TriedBetween(left_walls()) : nearly_protrudes(p, level);
  if (fit && level > 0 && !by_containers()) return points_ ? std::nullopt : std::optional(nearly_in_union(p, level));
  if (fit && level > 0) return nearly_fits(p, level);
  return std::nullopt;
}

TriedBetween between(const std::shared_ptr<const CsgSide>& side, Which which, const Real& level, const RealVector& p) {
  const double at = level.to_double();
  if (const auto nearly = side->nearly(which, at, p)) return *nearly;
  if (which == Which::kMuBack && at > 0) which = Which::kHBack;  // how deep does not matter
  const TriedAnswer found = csg_pair(side, false).try_value(which, p);
  if (!found) return found.refusal();
  const std::optional<Answer>& v = *found;
  if (!v) return std::nullopt;
  const double d = v->value.to_double();
  return Between{d - v->error - at, d + v->error - at};
}

/// "A in B", at positions of A.
class CsgBackSide : public PairSide {
 public:
  explicit CsgBackSide(std::shared_ptr<const CsgSide> side) : side_(std::move(side)) {}

  TriedAnswer gap(const RealVector& p, Depth depth) const override {
    return exchanged_back(side_->gap(space::negated(p), depth), p);
  }
  TriedAnswer reach(const RealVector& p) const override { return exchanged_back(side_->reach(space::negated(p)), p); }
  TriedAnswer diameter(const RealVector& p) const override {
    return exchanged_back(side_->diameter(space::negated(p)), p);
  }
  TriedAnswer protrusion(const RealVector& p, Depth depth) const override;
  TriedAnswer clearance(const RealVector& p) const override {
    TriedAnswer v = protrusion(p, Depth::kValue);
    if (!v) return v;
    return cut_off(*std::move(v), true);
  }
  TriedAnswer fit(const RealVector& p) const override;
  TriedAnswer farthest_fit(const RealVector& p) const override;

 private:
  /// What holds the positions at which A fits between the planes of B, or of the box about it, and what they hold.
  struct Fits {
    std::vector<space::HalfSpace> holding, held;
    bool exact = true;  // the planes are B
  };
  exact::Tried<Fits> made_fits() const;
  const exact::Tried<Fits>& fits() const {
    return fits_.of([this] { return made_fits(); });
  }
  /// Where B is a union: by what that leaves, at positions of B; null: A is larger than the box about B.
  CsgSide::TriedAmong made_among() const;
  const CsgSide::TriedAmong& among() const {
    return among_.of([this] { return made_among(); });
  }
  Answer named_protrusion(const CsgPart& part, const RealVector& p, const BoundaryPlace& found) const;

  std::shared_ptr<const CsgSide> side_;
  plane::Lazy<exact::Tried<Fits>> fits_;
  plane::Lazy<CsgSide::TriedAmong> among_;
};

TriedAnswer CsgBackSide::protrusion(const RealVector& p, Depth depth) const {
  if (side_->a_->walls) return left_walls();
  const Body& b = *side_->b_;
  const RealVector by = space::negated(p);  // of B
  std::vector<ConvexDistance> beyond;
  for (const BodyPart& part : b.parts) beyond.push_back(reverse_convex_constraint(part, space::rounded(by)));
  std::optional<Answer> best;
  BoundOfParts bound(-1, side_->size_);
  for (const CsgPartSearch& part : side_->parts_) {
    const BoundaryPlace found = part.places.farthest_from(beyond);
    bound.add(found);
    if (!found.found || (best && found.value <= best->value.to_double())) continue;
    best = named_protrusion(*part.sets, p, found);
  }
  TriedAnswer most = bound.best(std::move(best));
  if (!most || b.convex() || depth == Depth::kSign || (*most)->value.to_double() > (*most)->error) return most;
  return fit(p);
}

/// A set of A protrudes from a convex B by no less than A; where it does so at a place of A, by as much.
Answer CsgBackSide::named_protrusion(const CsgPart& part, const RealVector& p, const BoundaryPlace& found) const {
  Answer out = searched_answer(found, side_->size_);
  const Body& b = *side_->b_;
  for (const BodyPart& set : part.within) {
    if (!b.convex()) break;
    Answer complete = protrusion_of_convex(space::body_of_part(set), b.parts[0], p);
    const bool same = std::fabs(complete.value.to_double() - found.value) <= out.error;  // no sign: the same value
    if (!same || complete.witness.empty()) continue;
    if (!holds(part, space::minus(complete.witness[0].at, p))) continue;
    complete.nearest.reset();
    return complete;
  }
  return out;
}

/// As far as A reaches along the normal of each plane, from below and from above.
exact::Tried<CsgBackSide::Fits> CsgBackSide::made_fits() const {
  const ScopedSearchWork of_all(nullptr);  // kept: not of the question that comes first
  const Body& b = *side_->b_;
  Fits out;
  out.exact = b.convex() && b.parts[0].core && !b.round();
  const double error = margin::kFoundError * side_->size_;
  for (const space::HalfSpace& h : out.exact ? b.parts[0].planes() : space::walls(bounds(b))) {
    const ConvexDistance ahead = [n = h.unit](const space::Vector& x) { return space::dot(n, x); };
    double least = -exact::kInfinity, most = least;
    for (const CsgPartSearch& part : side_->parts_) {
      const BoundaryPlace found = part.places.farthest_from(ahead);
      least = std::max(least, found.value);
      most = std::max(most, found.bound);
    }
    if (!std::isfinite(least) || !std::isfinite(most)) return not_found_in_part();
    const double size = space::length(space::rounded(h.normal));
    out.holding.emplace_back(h.normal, h.offset + Real::from_double(size * (least - error)));
    out.held.emplace_back(h.normal, h.offset + Real::from_double(size * (most + error)));
  }
  return out;
}

namespace {

/// A value between two, of which the second is taken.
Answer between_two(const Real& one, const Real& taken) {
  Answer out;
  out.value = taken;
  out.set_unproven();
  out.error = abs(taken - one).to_double();
  out.enclosed = one < taken ? Enclosure{one, taken} : Enclosure{taken, one};
  return out;
}

Refusal not_fitting() {
  return Refusal("how far a shape that round ones are cut out of is from fitting into another is not computed");
}

}  // namespace

CsgSide::TriedAmong CsgBackSide::made_among() const {
  const exact::Tried<Fits>& fits = this->fits();
  if (!fits) return fits.refusal();
  // A's walls are those of a box, above and below on each axis.
  space::Bounds3 places;
  for (std::size_t k = 0; k < 3; ++k) {
    places.low[k] = fits->holding[2 * k].offset;
    places.high[k] = -fits->holding[2 * k + 1].offset;
    if (places.high[k] < places.low[k]) return std::shared_ptr<const CsgSide::Among>();
  }
  return CsgSide::among_cells(*side_->b_, *side_->a_, places);
}

TriedAnswer CsgBackSide::fit(const RealVector& p) const {
  if (side_->a_->walls) return left_walls();
  if (!side_->b_->convex()) {
    const CsgSide::TriedAmong& among = this->among();
    if (!among) return among.refusal();
    if (!*among) return std::nullopt;
    return exchanged_back(CsgSide::fit_among(**among, space::negated(p)), p);
  }
  const exact::Tried<Fits>& fits = this->fits();
  if (!fits) return fits.refusal();
  const auto outer = nearest_in(fits->holding, p);
  if (!outer) return std::nullopt;
  TriedAnswer v = protrusion(p, Depth::kValue);
  if (!v || (*v)->value.to_double() <= (*v)->error) return v;
  const auto inner = fits->exact ? nearest_in(fits->held, p) : std::nullopt;
  if (!inner) return not_fitting();
  Answer out = between_two(signed_value(p, *outer, 1).value, signed_value(p, *inner, 1).value);
  out.nearest = inner;
  return out;
}

TriedAnswer CsgBackSide::farthest_fit(const RealVector& p) const {
  if (side_->a_->walls) return left_walls();
  if (!side_->b_->convex()) {
    const CsgSide::TriedAmong& among = this->among();
    if (!among) return among.refusal();
    if (!*among) return std::nullopt;
    return exchanged_back(CsgSide::farthest_among(**among, space::negated(p)), p);
  }
  const exact::Tried<Fits>& fits = this->fits();
  if (!fits) return fits.refusal();
  const space::Bounds3 box = space::meeting(bounds(*side_->a_), bounds(*side_->b_));
  const auto farthest = [&](const std::vector<space::HalfSpace>& planes) -> std::optional<Real> {
    space::ConvexRegion region(box.low, box.high);
    for (const space::HalfSpace& h : planes) region.cut(h);
    std::optional<Real> most;
    for (const space::ConvexRegion::Vertex& v : region.vertices()) {
      const Real d = signed_value(p, v.at, 1).value;
      if (!most || *most < d) most = d;
    }
    return most;
  };
  const auto outer = farthest(fits->holding);
  if (!outer) return std::nullopt;
  const auto inner = fits->exact ? farthest(fits->held) : std::nullopt;
  if (!inner) return not_fitting();
  return between_two(*outer, *inner);
}

PairDistances csg_pair(std::shared_ptr<const CsgSide> side, bool cut_moves) {
  auto back = std::make_shared<const CsgBackSide>(side);
  if (cut_moves) return {std::move(back), std::move(side)};
  return {std::move(side), std::move(back)};
}

}  // namespace findspace::distance
