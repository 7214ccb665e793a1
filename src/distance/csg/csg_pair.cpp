// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/csg/csg_pair.h"

#include <algorithm>

#include "distance/answer/answer.h"
#include "distance/csg/csg_part.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using exact::Real;
using exact::Refusal;
using exact::Tried;
using space::Body;
using space::BodyPart;
using space::CsgPart;
using space::CsgSolid;
using space::RealVector;

namespace {

TriedAnswer defined(exact::Tried<Answer> v) {
  if (!v) return v.refusal();
  return std::optional(*std::move(v));
}

}  // namespace

CsgPair::CsgPair(std::shared_ptr<const Body> b, std::shared_ptr<const CsgSolid> a, bool cut_moves)
    : b_(std::move(b)), a_(std::move(a)), cut_moves_(cut_moves) {
  size_ = cut_size(*b_, *a_);
  for (const CsgPart& part : a_->parts) {
    CsgPartSearch search = csg_part_search(part, size_);
    if (!search.empty) parts_.push_back(std::move(search));
  }
  const auto pairs = [&](const std::vector<Body>& all, std::vector<std::unique_ptr<const SolidPair>>& out) {
    for (const Body& body : all)
      out.push_back(std::make_unique<const SolidPair>(b_, std::make_shared<const Body>(body)));
  };
  pairs(a_->containers, containers_);
  pairs(a_->obstacles, obstacles_);
}

/// How B + p fits, by each container and obstacle alone: the worst of them, which is no more than what it is by all
/// together; nothing where one container is too small.
TriedAnswer CsgPair::worst_fit(const RealVector& p) const {
  std::optional<Answer> worst;
  const auto take = [&](Answer v) {
    if (!worst || worst->value < v.value) worst = std::move(v);
  };
  for (const auto& container : containers_) {
    TriedAnswer v = container->try_value(Which::kEta1, p);
    if (!v || !*v) return v;
    take(**std::move(v));
  }
  for (const auto& obstacle : obstacles_) {
    TriedAnswer v = obstacle->try_value(Which::kGamma1, p);
    if (!v) return v;
    take(minus(**std::move(v)));
  }
  return worst;
}

/// Whether the worst fit is the true one: B fits already, or where it next fits by that alone.
Tried<bool> CsgPair::is_whole(const Answer& worst) const {
  if (worst.value.sign() <= 0) return true;
  if (!worst.proven || !worst.nearest) return false;
  const TriedAnswer there = worst_fit(*worst.nearest);
  if (!there) return there.refusal();
  return *there && (*there)->proven && (*there)->value.sign() <= 0;
}

TriedAnswer CsgPair::contained(const RealVector& p) const {
  if (containers_.empty()) return contained_in_union(p);
  TriedAnswer worst = worst_fit(p);
  if (!worst || !*worst) return worst;
  const Tried<bool> whole = is_whole(**worst);
  if (!whole) return whole.refusal();
  if (*whole) return worst;
  const Tried<const PositionSet*> fits = this->fits();
  if (!fits) return fits.refusal();
  if (!*fits) return std::nullopt;
  return (*fits)->nearest(p, false);
}

/// Null: nothing fits.
Tried<const PositionSet*> CsgPair::fits() const {
  std::call_once(fits_made_, [&] {
    std::optional<space::Bounds3> box;
    std::vector<PositionSet> all;
    const space::Bounds3 inner = bounds(*b_);
    for (const Body& container : a_->containers) {
      if (!container.convex()) {
        no_fits_.emplace(
            "how far a shape is from fitting into such a shape is computed where its containers are convex");
        return;
      }
      const space::Bounds3 outer = bounds(container);
      space::Bounds3 one{space::minus(outer.low, inner.low), space::minus(outer.high, inner.high)};
      if (!box) box = one;
      for (std::size_t k = 0; k < 3; ++k) {
        box->low[k] = std::max(box->low[k], one.low[k]);
        box->high[k] = std::min(box->high[k], one.high[k]);
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (box->high[k] < box->low[k]) return;
    }
    for (const Body& container : a_->containers)
      all.push_back(PositionSet::inside(*b_, container.parts[0], box->low, box->high));
    std::vector<GrownSet> sets;
    for (const Body& obstacle : a_->obstacles) {
      for (const BodyPart& t : obstacle.parts) {
        for (const BodyPart& s : b_->parts) sets.push_back(difference(t, s));
      }
    }
    all.push_back(PositionSet::outside(std::move(sets), box->low, box->high));
    fits_ = PositionSet::common(all, box->low, box->high);
  });
  if (no_fits_) return *no_fits_;
  return fits_ ? &*fits_ : nullptr;
}

TriedAnswer CsgPair::farthest_fit(Inner inner, const RealVector& p) const {
  if (inner == Inner::kA) {
    if (too_large()) return std::nullopt;
    return Refusal("the farthest fit of a shape that round ones are cut out of is not computed");
  }
  if (containers_.empty()) return farthest_in_union(p);
  const Tried<const PositionSet*> fits = this->fits();
  if (!fits) return fits.refusal();
  if (!*fits) return std::nullopt;
  TriedAnswer v = (*fits)->farthest(p);
  if (v && *v) (*v)->nearest.reset();
  return v;
}

TriedAnswer CsgPair::protrusion(Inner inner, const RealVector& p, Depth /*depth*/) const {
  if (inner == Inner::kA) return defined(protrusion_back(p));
  TriedAnswer worst = containers_.empty() ? contained_in_union(p) : worst_fit(p);
  // B that fits nowhere protrudes everywhere.
  if (worst && (!*worst || (*worst)->value.sign() > 0)) return std::optional(protrusion_out(p));
  return worst;
}

TriedAnswer CsgPair::hausdorff(const RealVector& p) const {
  TriedAnswer back = defined(protrusion_back(p));
  if (!back) return back;
  // No point of B is farther from A than the gap and B's own width.
  const double most = apart(p).value.to_double() + distance::diameter(*b_).to_double();
  if (most < (*back)->value.to_double() - (*back)->error) return back;
  TriedAnswer forth = protrusion(Inner::kB, p, Depth::kValue);
  return forth && (*forth)->value < (*back)->value ? back : forth;
}

/// Whether A is wider than B along an axis, and so never in it.
bool CsgPair::too_large() const {
  std::call_once(extents_made_, [&] {
    const space::Bounds3 box = bounds(*b_);
    for (std::size_t k = 0; k < 3; ++k) {
      double wide = 0;
      for (const double sense : {1.0, -1.0}) {
        const ConvexDistance ahead = [k, sense](const space::Vector& x) {
          return sense * (k == 0 ? x.x : k == 1 ? x.y : x.z);
        };
        double most = -exact::kInfinity;
        for (const CsgPartSearch& part : parts_) most = std::max(most, part.places.farthest_from(ahead).value);
        wide += most;
      }
      if (wide > (box.high[k] - box.low[k]).to_double() + 4 * margin::kFoundError * size_) too_large_ = true;
    }
  });
  return too_large_;
}

TriedAnswer CsgPair::clearance(Inner inner, const RealVector& p) const {
  TriedAnswer v = inner == Inner::kA    ? defined(protrusion_back(p))
                  : containers_.empty() ? contained_in_union(p)
                                        : worst_fit(p);
  if (!v) return v;
  return cut_off(*std::move(v), true);
}

TriedAnswer CsgPair::covered(const RealVector& p) const {
  if (too_large()) return std::nullopt;
  Tried<Answer> v = protrusion_back(p);
  if (v && v->value.to_double() > v->error)
    return Refusal("how far a shape that round ones are cut out of is from fitting into another is not computed");
  return defined(std::move(v));
}

TriedAnswer CsgPair::gap(const RealVector& p, Depth depth) const {
  Gap found = gap_at(p);
  if (found.depth > 0 && depth == Depth::kValue) return defined(overlapping(p));
  return std::optional(std::move(found.value));
}

TriedAnswer CsgPair::reach(const RealVector& p) const { return std::optional(reach_of_parts(p)); }

TriedAnswer CsgPair::diameter(const RealVector& /*p*/) const {
  return Refusal("this distance to a shape that round ones are cut out of is not computed");
}

TriedAnswer CsgPair::fit(Inner inner, const RealVector& p) const {
  return inner == Inner::kB ? contained(p) : covered(p);
}

TriedAnswer CsgPair::try_value(Which which, const RealVector& p) const {
  if (!cut_moves_) return PairDistances::try_value(which, p);
  return exchanged_back(PairDistances::try_value(exchanged(which), space::negated(p)), p);
}

/// How far B + p is from fitting, less a level above 0.
TriedBetween CsgPair::nearly_fits(const RealVector& p, double level) const {
  const exact::Tried<const PositionSet*> made = this->fits();
  if (!made) return made.refusal();
  const PositionSet* fits = *made;
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

TriedBetween CsgPair::between(Which which, const Real& level, const RealVector& p) const {
  const double at = level.to_double();
  const bool fit = which == (cut_moves_ ? Which::kDelta1 : Which::kEta1);
  const bool out = which == (cut_moves_ ? Which::kMuBack : Which::kMu) && at <= 0;
  if ((fit || out) && containers_.empty()) return nearly_in_union(cut_moves_ ? space::negated(p) : p, at);
  if (which == (cut_moves_ ? Which::kMuBack : Which::kMu) && at > 0)
    return nearly_protrudes(cut_moves_ ? space::negated(p) : p, at);
  if (fit && at > 0) return nearly_fits(cut_moves_ ? space::negated(p) : p, at);
  const TriedAnswer found = try_value(which, p);
  if (!found) return found.refusal();
  const std::optional<Answer>& v = *found;
  if (!v) return std::nullopt;
  const double d = v->value.to_double();
  return Between{d - v->error - at, d + v->error - at};
}

}  // namespace findspace::distance
