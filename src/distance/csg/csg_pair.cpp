// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/csg/csg_pair.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>

#include "distance/answer/answer.h"
#include "distance/csg/csg_part.h"
#include "distance/rays/ray_directional_least.h"
#include "distance/search/solid_protrusion.h"
#include "distance/solid/far_corners.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"
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
  return about(v->value.to_double(), v->error, at);
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
  /// The least delta1 along a direction, for B that moves.
  TriedAnswer least_along(const RealVector& direction, bool both_ways) const;

 private:
  /// What holds the positions at which A fits between the planes of B, or of the box about it, and what they hold.
  struct Fits {
    std::vector<space::HalfSpace> holding, held;
    bool plain = true;  // the planes are B
  };
  exact::Tried<Fits> made_fits() const;
  /// Where the planes are those of a box.
  static std::optional<space::Bounds3> box_of(const Fits& fits);
  const exact::Tried<Fits>& fits() const {
    return fits_.of([this] { return made_fits(); });
  }
  /// Where B is a union: by what that leaves, at positions of B; null: A is larger than the box about B.
  CsgSide::TriedAmong made_among() const;
  const CsgSide::TriedAmong& among() const {
    return among_.of([this] { return made_among(); });
  }
  Answer named_protrusion(const CsgPart& part, const RealVector& p, const BoundaryPlace& found) const;
  TriedAnswer searched_protrusion(const RealVector& p) const;
  /// Whether A lies in B if it protrudes by so much, as surely as numbers tell.
  bool lies_in(const Answer& most) const {
    return most.bounds().upper->to_double() <= 4 * margin::kFoundError * side_->size_;
  }
  BoundaryPlace farthest_out(const BodyPart& part, const space::Vector& p) const;
  TriedAnswer in_round_part(const BodyPart& part, const space::Bounds3& box, const RealVector& p, bool farthest) const;
  TriedAnswer in_round_parts(const RealVector& p, bool farthest) const;

  std::shared_ptr<const CsgSide> side_;
  plane::Lazy<exact::Tried<Fits>> fits_;
  plane::Lazy<CsgSide::TriedAmong> among_;
};

/// Of A + p; inside a union B as deep as the parts alone say.
TriedAnswer CsgBackSide::searched_protrusion(const RealVector& p) const {
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
  return bound.best(std::move(best));
}

TriedAnswer CsgBackSide::protrusion(const RealVector& p, Depth depth) const {
  if (side_->a_->walls) return left_walls();
  TriedAnswer most = searched_protrusion(p);
  if (!most || side_->b_->convex() || depth == Depth::kSign || (*most)->value.to_double() > (*most)->error) return most;
  TriedAnswer inside = fit(p);
  if (!inside) return inside;
  const auto least = *inside ? (*inside)->bounds().lower : std::nullopt;
  const bool out = !*inside || (least && least->sign() > 0);
  return out ? cut_off(*std::move(most), false) : inside;
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
  const plane::ScopedSearchWork of_all(nullptr);  // kept: not of the question that comes first
  const Body& b = *side_->b_;
  Fits out;
  out.plain = b.convex() && b.parts[0].core && !b.round();
  const double error = margin::kFoundError * side_->size_;
  for (const space::HalfSpace& h : out.plain ? b.parts[0].planes() : space::walls(bounds(b))) {
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
  return unproven_answer(taken, one < taken ? Enclosure{one, taken} : Enclosure{taken, one});
}

/// A value that may be any from there on, if there is one.
Answer at_least(Answer v) {
  v.set_unproven();
  v.nearest.reset();
  v.enclosed = Enclosure{v.value, std::nullopt};
  v.error = exact::kInfinity;
  return v;
}

constexpr int kMostPlacesOut = 40;

}  // namespace

/// Of positions of B against A, whose walls are those of a box, above and below on each axis.
std::optional<space::Bounds3> CsgBackSide::box_of(const Fits& fits) {
  space::Bounds3 out;
  for (std::size_t k = 0; k < 3; ++k) {
    out.low[k] = fits.holding[2 * k].offset;
    out.high[k] = -fits.holding[2 * k + 1].offset;
    if (out.high[k] < out.low[k]) return std::nullopt;
  }
  return out;
}

/// The place of A + p that is farthest out of the part.
BoundaryPlace CsgBackSide::farthest_out(const BodyPart& part, const space::Vector& p) const {
  const ConvexDistance beyond = reverse_convex_constraint(part, space::scaled(-1, p));
  BoundaryPlace out;
  out.value = out.bound = -exact::kInfinity;
  for (const CsgPartSearch& of_a : side_->parts_) {
    const BoundaryPlace found = of_a.places.farthest_from(beyond);
    const double bound = std::max(out.bound, found.bound);
    if (found.found && found.value > out.value) out = found;
    out.bound = bound;
  }
  return out;
}

/// A lies in the part where all of its places do. Those that are farthest out, at the nearest position that all places
/// before allow, are the next. How far A is out is convex in the position: on the way to one at which it fits it does
/// so from where chords say.
TriedAnswer CsgBackSide::in_round_part(const BodyPart& part, const space::Bounds3& box, const RealVector& p,
                                       bool farthest) const {
  const double size = side_->size_, error = margin::kFoundError * size;
  const space::Vector from = space::rounded(p);
  Constraints holding;
  const auto hold = [&](const space::Vector& place) {
    holding.convex.push_back(touching_boundary(part, space::scaled(-1, place), part.radius.to_double()));
  };
  std::optional<space::Vector> inside;  // the position at which A is deepest in the part
  double depth = 0;
  std::vector<Answer> places;
  BoundaryPlace end;
  end.bound = farthest ? space::rounded(box).farthest(from) : 0;
  const auto offer = [&](const space::Vector& at) {
    BoundaryPlace taken;
    taken.place = at;
    const Answer v = searched_place(taken, p, error);
    const bool better = places.empty() || (farthest ? places[0].value < v.value : v.value < places[0].value);
    if (better) places.assign(1, v);
  };
  space::Vector middle = space::rounded(box).middle();
  for (int k = 0; k < kMostPlacesOut; ++k) {
    const BoundaryPlace of_middle = farthest_out(part, middle);
    if (of_middle.found) hold(of_middle.place);
    if (of_middle.found && -of_middle.bound > depth) {
      depth = -of_middle.bound;
      inside = middle;
    }
    const PositionSet outer = PositionSet::of_constraints(holding, space::rounded(box), size, {});
    const BoundaryPlace best =
        farthest ? outer.farthest_from(from) : outer.nearest_to(distance_to_point(from), PositionSet::Query{});
    if (!best.found && !best.unresolved && best.complete) return std::nullopt;
    end.bound = farthest ? std::min(end.bound, best.bound) : std::max(end.bound, best.bound);
    middle = outer.deepest({error}).place;
    if (!best.found) continue;
    const BoundaryPlace out = farthest_out(part, best.place);
    if (out.found) hold(out.place);
    if (out.bound <= error)
      offer(best.place);
    else if (inside)
      offer(space::plus(best.place, space::scaled(out.bound / (out.bound + depth), *inside - best.place)));
    if (!places.empty() && std::fabs(places[0].value.to_double() - end.bound) <= 8 * error) break;
  }
  return std::optional(ended_before(end, error, places, farthest));
}

/// Of a union what its parts alone say, and how far A is out of it.
TriedAnswer CsgBackSide::in_round_parts(const RealVector& p, bool farthest) const {
  const exact::Tried<Fits>& fits = this->fits();
  if (!fits) return fits.refusal();
  const auto of_b = box_of(*fits);
  if (!of_b) return std::nullopt;
  const space::Bounds3 box{space::negated(of_b->high), space::negated(of_b->low)};
  const Body& b = *side_->b_;
  BoundaryPlace out;
  out.bound = space::rounded(box).farthest(space::rounded(p));
  if (!farthest) {
    TriedAnswer most = searched_protrusion(p);
    if (!most || (b.convex() && lies_in(**most))) return most;
    const Enclosure ends = (*most)->bounds();
    if ((*most)->value.to_double() <= (*most)->error) {
      // No way out of the box about B is longer.
      Real deepest = fits->holding[0].value(p);
      for (const space::HalfSpace& h : fits->holding) deepest = std::max(deepest, h.value(p));
      const Real least = b.convex() ? *ends.lower : std::min(deepest, *ends.upper);
      if (lies_in(**most)) return between_two(least, *ends.upper);
      return std::optional(at_least(exact_answer<RealVector>(std::min(least, Real()), Way::kCut)));
    }
    out.bound = ends.lower->to_double();
  }
  std::vector<Answer> places;
  for (const BodyPart& part : b.parts) {
    TriedAnswer v = in_round_part(part, box, p, farthest);
    if (b.convex()) return v;
    if (v && *v && (*v)->error < exact::kInfinity) places.push_back(**std::move(v));
  }
  return std::optional(ended_before(out, margin::kFoundError * side_->size_, places, farthest));
}

CsgSide::TriedAmong CsgBackSide::made_among() const {
  const exact::Tried<Fits>& fits = this->fits();
  if (!fits) return fits.refusal();
  const auto places = box_of(*fits);
  if (!places) return std::shared_ptr<const CsgSide::Among>();
  return CsgSide::among_cells(*side_->b_, *side_->a_, *places);
}

TriedAnswer CsgBackSide::fit(const RealVector& p) const {
  if (side_->a_->walls) return left_walls();
  if (side_->b_->round()) return in_round_parts(p, false);
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
  if (!v || lies_in(**v)) return v;
  const bool out_of_b = (*v)->value.to_double() > (*v)->error;
  const auto inner = nearest_in(fits->held, p);
  Answer least = signed_value(p, *outer, 1);
  if (!out_of_b && least.value.sign() == 0) least.value = *(*v)->bounds().lower;
  if (!inner) return std::optional(at_least(std::move(least)));
  Answer out = between_two(least.value, signed_value(p, *inner, 1).value);
  if (out_of_b) out.nearest = inner;
  return out;
}

TriedAnswer CsgBackSide::farthest_fit(const RealVector& p) const {
  if (side_->a_->walls) return left_walls();
  if (side_->b_->round()) {
    TriedAnswer v = in_round_parts(p, true);
    if (v && *v) (*v)->farthest = std::exchange((*v)->nearest, std::nullopt);
    return v;
  }
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
  const auto inner = farthest(fits->held);
  return inner ? between_two(*outer, *inner) : at_least(Answer{});
}

/// Between the longest chords of what holds the positions, and of what they hold where B is a polytope.
TriedAnswer CsgBackSide::least_along(const RealVector& direction, bool both_ways) const {
  if (side_->a_->walls) return left_walls();
  const exact::Tried<Fits>& fits = this->fits();
  if (!fits) return fits.refusal();
  const space::Bounds3 box = space::meeting(bounds(*side_->a_), bounds(*side_->b_));
  const auto chord = [&](const std::vector<space::HalfSpace>& planes) {
    space::ConvexRegion region(box.low, box.high);
    for (const space::HalfSpace& h : planes) region.cut(h);
    return convex_directional_least(region, Real(), direction, both_ways);
  };
  const std::optional<Answer> longest = chord(fits->holding);
  if (!longest) return std::nullopt;
  const std::optional<Answer> held = fits->plain ? chord(fits->held) : std::nullopt;
  Answer out = least_answer(held ? held->value : Real(), longest->value, false, space::negated(longest->at));
  if (held) out.at = space::negated(held->at);
  if (!held) out.enclosed->upper.reset();
  if (!held || !both_ways) out.side = Side::kNone;
  return out;
}

PairDistances csg_pair(std::shared_ptr<const CsgSide> side, bool cut_moves) {
  auto back = std::make_shared<const CsgBackSide>(side);
  if (cut_moves) return {std::move(back), std::move(side)};
  return {std::move(side), std::move(back)};
}

TriedAnswer csg_directional_least(Which which, const std::shared_ptr<const CsgSide>& side, bool cut_moves,
                                  const RealVector& direction, bool both_ways) {
  if (cut_moves) {
    // A + p against B is A against B - p.
    TriedAnswer v = csg_directional_least(exchanged(which), side, false, direction, both_ways);
    if (v && *v) (*v)->at = space::negated((*v)->at);
    return v;
  }
  if (which == Which::kGamma1) return CsgSide::least_gap_along(side, direction, both_ways);
  if (which == Which::kDelta1) return CsgBackSide(side).least_along(direction, both_ways);
  if (which != Which::kEta1)
    return Refusal("least values along a direction are computed in 3D of gap, eta1 and delta1 only");
  const FitSearch search = [&](const space::Body& swept, std::int64_t finer) {
    const CsgSide fine(std::make_shared<const space::Body>(swept),
                       std::make_shared<const space::CsgSolid>(at_scale(side->cut(), side->cut().scale * finer)));
    return fine.fits_somewhere();
  };
  return least_of_swept_fits(side->complete(), bounds(side->cut()), direction, both_ways, search);
}

}  // namespace findspace::distance
