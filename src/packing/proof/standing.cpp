// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/proof/standing.h"

#include "packing/problem/pair_formula.h"
#include "packing/proof/interiors.h"

namespace findspace::packing {
namespace {

/// Whether the boxes, the gap wider, have common inner points.
bool meet(const LatticeBox& a, const LatticeBox& b, int128 gap) {
  return a.low.x - gap < b.high.x && b.low.x - gap < a.high.x && a.low.y - gap < b.high.y && b.low.y - gap < a.high.y;
}

}  // namespace

StandingParts::StandingParts(const Problem& problem, const Layout& layout, int digits) : problem_(problem) {
  common_ = common_multiple(problem.steps(),
                            common_multiple(height_of(problem, layout).denominator(), layout.length.denominator()));
  common_ = common_multiple(common_, common_multiple(problem.gap.denominator(), problem.edge.denominator()));
  common_ = common_multiple(common_, power_of_ten(digits));
  for (const PairGap& pair : problem.pair_gaps) common_ = common_multiple(common_, pair.gap.denominator());
  for (const Placed& item : layout.items)
    common_ = common_multiple(common_multiple(common_, item.x.denominator()), item.y.denominator());
  for (const Placed& item : layout.items) {
    const Part& part = problem.parts[item.part];
    items_.push_back(standing(part, item));
    items_.back().set = [&part, &item] { return region_of(part, item.angle, item.mirrored); };
  }
}

Standing StandingParts::standing(const Part& part, const Placed& item) const {
  const LatticePoint at{item.x.over(common_), item.y.over(common_)};
  Standing result;
  result.shape = scaled(rotated(part, item.angle, item.mirrored), at);
  const LatticeBox box = scaled(box_of(part, item.angle, item.mirrored));
  result.box = {box.low + at, box.high + at};
  if (part.round) result.round = &part.round->at(item.angle, item.mirrored);
  result.x = item.x;
  result.y = item.y;
  return result;
}

Standing StandingParts::obstacle(const Part& part) const {
  Standing result = standing(part, {});
  result.set = [part] { return region_of(part, 0, false); };
  return result;
}

LatticePoint StandingParts::scaled(const LatticePoint& p) const {
  const int128 scale = common_ / problem_.steps();
  return {bounded_product(p.x, scale), bounded_product(p.y, scale)};
}

Polygon StandingParts::scaled(Polygon shape, const LatticePoint& at) const {
  for (Ring& ring : shape.rings)
    for (LatticePoint& p : ring) p = scaled(p) + at;
  return shape;
}

Contact StandingParts::contact(const Standing& a, const Standing& b, const Fraction& least) const {
  const int128 gap = least.over(common_);
  if (!meet(a.box, b.box, gap)) return Contact::kNone;
  if (a.round != nullptr || b.round != nullptr) return round_contact(a, b, least);
  if (interiors_meet(a.shape, b.shape)) return Contact::kOverlap;
  return gap > 0 && are_nearer(a.shape, b.shape, gap) ? Contact::kGap : Contact::kNone;
}

Contact StandingParts::round_contact(const Standing& a, const Standing& b, const Fraction& gap) const {
  if (are_apart(a.shape, b.shape, gap.over(common_) + 2 * slack())) return Contact::kNone;
  const plane::SharedRegion first = a.set(), second = b.set();
  const exact::Real step = exact::Real(1) / exact::Real(problem_.steps());
  const auto keep = [&](const Fraction& distance) {
    return PairFormula::apart(first, second, distance, step).holds(b.x - a.x, b.y - a.y);
  };
  if (keep(gap)) return Contact::kNone;
  return gap > 0 && keep(0) ? Contact::kGap : Contact::kOverlap;
}

bool StandingParts::keeps_gap(const Standing& part, const Polygon& polygon, const Fraction& least) const {
  const int128 gap = least.over(common_);
  if (!meet(part.box, box_of(polygon), gap)) return true;
  if (part.round != nullptr) return are_apart(part.shape, polygon, gap + slack());
  return !interiors_meet(part.shape, polygon) && (gap == 0 || !are_nearer(part.shape, polygon, gap));
}

}  // namespace findspace::packing
