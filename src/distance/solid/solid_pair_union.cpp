// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How far a body is from fitting into a union of round parts, and the farthest place where it does (solid_pair.h). The
// places at which it lies in a single part are those of a convex A, exactly; one is decided where the search through
// all others (union_fit.h) finds none that is better. Guarantee: else found by search, to 2^-36 of the sizes; where a
// fit of zero clearance, and is none in a single part, may be nearer, it is refused.
// Keywords: erosion, containment.

#include <cmath>

#include "distance/answer/answer.h"
#include "distance/search/union_fit.h"
#include "distance/solid/solid_pair.h"
#include "exact/margins/space_distance.h"
#include "space/body/body_boxes.h"

namespace findspace::distance {

using exact::Real;
using space::RealVector;

/// What is kept from position to position.
struct UnionContainers {
  std::vector<std::unique_ptr<SolidSide>> alone;  // with each part of A
  double size;
  PositionSet fits;  // E
};

namespace {

/// The nearest (farthest) place in a single part, where that is known.
std::optional<Answer> in_one_part(const UnionContainers& containers, const RealVector& p, bool farthest) {
  std::optional<Answer> best;
  for (const auto& pair : containers.alone) {
    TriedAnswer tried = farthest ? pair->farthest_fit(p) : pair->fit(p);
    if (!tried || !*tried) continue;  // the search will tell
    Answer& v = **tried;
    if (!best || (farthest ? best->value < v.value : v.value < best->value)) best = std::move(v);
  }
  return best;
}

TriedAnswer settled(const BoundaryPlace& found, const std::optional<Answer>& known, double size) {
  const double slack = margin::kUnionFitError * size, off = std::fabs(found.value - found.bound);
  if (found.known && off <= slack) return known;
  if (found.found && off <= slack) {
    Answer out;
    out.value = Real::from_double(found.value);
    out.nearest = RealVector{Real::from_double(found.place.x), Real::from_double(found.place.y),
                             Real::from_double(found.place.z)};
    out.set_unproven();
    out.error = slack;
    return std::optional(std::move(out));
  }
  if (!found.complete)
    return exact::Refusal(
        "how far a shape is from fitting into a union of round parts was not found within the limit of the search");
  if (!found.unresolved) return std::nullopt;
  return exact::Refusal(
      "whether a shape fits into a union of round parts with zero clearance "
      "is not decided");
}

}  // namespace

std::shared_ptr<const UnionContainers> SolidSide::union_containers(const space::Bounds3& box) const {
  const auto protrusion = std::make_shared<const UnionProtrusion>(*b_, *a_);
  auto out = std::make_shared<UnionContainers>(
      UnionContainers{{}, protrusion->size(), fits_in_union(protrusion, space::rounded(box))});
  for (const space::BodyPart& part : a_->parts) {
    auto one = std::make_shared<space::Body>();
    one->scale = a_->scale;
    one->parts.push_back(part);
    out->alone.push_back(std::make_unique<SolidSide>(b_, std::move(one)));
  }
  return out;
}

TriedAnswer SolidSide::into_union(const Fit& fit, const RealVector& p, const Answer& outside) const {
  // Moved by as much, the way that B protrudes by, it often fits, and no shorter way leads to where it does.
  if (!outside.witness.empty() && outside.proven) {
    const RealVector q = space::minus(p, space::minus(outside.witness[0].at, outside.witness[1].at));
    const TriedAnswer there = protrusion(q, Depth::kSign);
    if (!there) return there;
    if ((*there)->value.sign() <= 0) return std::optional(signed_value(p, q, 1));
  }
  const UnionContainers& containers = *fit.in_union;
  const auto known = in_one_part(containers, p, false);
  PositionSet::Query query{outside.value.to_double() - outside.error};
  if (known) query.known = [&] { return std::optional(known->value.to_double()); };
  return settled(containers.fits.nearest_to(distance_to_point(space::rounded(p)), query), known, containers.size);
}

TriedAnswer SolidSide::farthest_in_union(const Fit& fit, const RealVector& p) {
  const UnionContainers& containers = *fit.in_union;
  const auto known = in_one_part(containers, p, true);
  Incumbent best;
  if (known) best = [&] { return std::optional(-known->value.to_double()); };
  const auto away = [from = space::rounded(p)](const space::Vector& x) { return space::length(x - from); };
  auto out = settled(containers.fits.farthest_from(away, best), known, containers.size);
  if (out && *out) (*out)->nearest.reset();
  return out;
}

}  // namespace findspace::distance
