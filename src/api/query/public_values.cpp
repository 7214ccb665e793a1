// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Answers at a position in doubles, with the bounds that they have.

#include <cmath>

#include "api/query/world_data.h"
#include "formula/language/text.h"

namespace findspace::api {
namespace {

using exact::Real;

Place place(const distance::Coordinates& p) {
  Place out;
  for (const Real& c : p) out.push_back(c.to_double());
  return out;
}

Feature feature(const formula::FeatureAt& f) {
  static_assert(int(formula::FeatureAt::Kind::kInside) == int(Feature::Kind::kInside));
  Feature out{Feature::Kind(int(f.kind)), f.shape, f.part, {}, f.radius.to_double()};
  for (const distance::Coordinates& p : f.points) out.points.push_back(place(p));
  return out;
}

template <class Value>
void set_bounds(const distance::SceneAnswer& a, Value& out) {
  out.exact = a.proven && !a.minus_infinity;
  if (a.minus_infinity) {
    out.lower = out.upper = -exact::kInfinity;
    return;
  }
  const distance::OutwardEnds ends = distance::outward(a.bounds());
  out.lower = ends.lower;
  out.upper = ends.upper;
}

}  // namespace

std::vector<Feature> features_of(const formula::DistanceAt& d) {
  std::vector<Feature> out;
  if (d.features.size() == 2)
    for (const formula::FeatureAt& f : d.features) out.push_back(feature(f));
  return out;
}

DistanceValue public_value(const formula::DistanceAt& d) {
  if (!d.refused.empty()) throw Error(ErrorCode::kUnsupported, d.text + ": " + d.refused);
  DistanceValue out;
  out.in_degrees = d.in_degrees;
  out.value = d.value();
  if (!d.answer) {
    out.exact = true;
    out.lower = out.upper = exact::kInfinity;
    return out;
  }
  set_bounds(*d.answer, out);
  out.closed_form = d.closed_form().value_or("");
  if (d.answer->nearest) out.nearest = place(*d.answer->nearest);
  if (d.answer->witness.size() == 2)
    for (const auto& w : d.answer->witness) out.points.push_back(place(w.at));
  out.features = features_of(d);
  return out;
}

Optimum public_optimum(const distance::OptimalValue& best, Region at) {
  Optimum out{{}, false, 0, 0, {}, "exact", best.unbounded, best.attained, std::move(at)};
  if (const auto value = best.value()) out.value = value->to_double();
  if (!best.answer) return out;
  set_bounds(*best.answer, out);
  out.closed_form = distance::closed_form(*best.answer).value_or("");
  out.side = distance::name(best.answer->side);
  return out;
}

Check public_check(const formula::Check& check) {
  Check out{check.holds, {}};
  for (const formula::AtomAt& a : check.atoms) {
    formula::DistanceAt value = formula::negated(a.atom.distance) ? formula::minus(a.distance) : a.distance;
    value.refused.clear();  // the truth is known without the value
    out.atoms.push_back({formula::written(a.atom), a.holds, public_value(value), a.lacks});
    if (!a.distance.refused.empty()) {
      out.atoms.back().distance.exact = false;
      out.atoms.back().distance.lower = -exact::kInfinity;
    }
  }
  return out;
}

}  // namespace findspace::api
