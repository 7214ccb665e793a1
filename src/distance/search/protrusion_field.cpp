// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/protrusion_field.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "distance/search/solid_protrusion.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {
namespace {

using space::Vector;

/// To the end of a run; a shorter one is as good.
constexpr int kMostRootSteps = 60;

/// How far a line runs until a convex function, positive at 0, is no longer so: a secant through places before lies
/// below it beyond, so its zero comes no later.
double convex_run(const std::function<double(double)>& f, double size) {
  const double farthest = 4 * size;
  double before = -size * margin::kSecantStart, at = 0;
  double value_before = f(before), value = f(at);
  for (int count = 0; count < kMostRootSteps && value > size * margin::kDistanceNoise; ++count) {
    // With a margin for rounding, so that steps are rather too short.
    const double slope = (value - value_before - size * margin::kDistanceNoise) / (at - before);
    if (slope >= 0 || value > -slope * (farthest - at)) return farthest;
    const double next = at - value / slope;
    if (!(next > at)) break;
    before = at;
    value_before = value;
    at = next;
    value = f(at);
  }
  return at;
}

class PartsField : public ProtrusionField {
 public:
  explicit PartsField(const space::Body& body) : nearest_(distances_to_parts(body)) {
    const space::Bounds3 box = bounds(body);
    size_ = space::length(space::rounded(space::minus(box.high, box.low)));
  }
  double size() const override { return size_; }
  SolidMaxMin max_min(const Solids& solids, double slack, double share) const override {
    return solid_max_min(solids, nearest_, slack, share);
  }
  double run(const Vector& x, const Vector& way, double cut, double size) const override {
    double least = exact::kInfinity;
    for (const ConvexDistance& d : nearest_)
      least =
          std::min(least, convex_run([&](double s) { return d(space::plus(x, space::scaled(s, way))) - cut; }, size));
    return least;
  }

 private:
  std::vector<ConvexDistance> nearest_;
  double size_;
};

}  // namespace

std::unique_ptr<ProtrusionField> field_of_parts(const space::Body& body) { return std::make_unique<PartsField>(body); }

}  // namespace findspace::distance
