// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/shape_phi.h"

#include <cmath>
#include <numeric>

#include "plane/complex/overlay.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;

namespace {

/// Nothing for bodies that are not unions of polygons and discs, or whose corners have no common grid.
std::optional<PhiParts> phi_by_parts(const plane::Shape& a, const plane::Shape& b, const Real& step) {
  const auto p = space::planar_parts(a, step.to_double()), q = space::planar_parts(b, step.to_double());
  if (!p || !q) return std::nullopt;
  const exact::int128 multiple = exact::int128(p->scale / std::gcd(p->scale, q->scale)) * q->scale;
  if (multiple > space::kCoordinateLimit) return std::nullopt;
  const auto scale = static_cast<std::int64_t>(multiple);
  const auto ps = space::at_scale(*p, scale), qs = space::at_scale(*q, scale);
  if (!ps || !qs) return std::nullopt;
  return PhiParts{space::PlanarPhiUnion(*ps, *qs), ps->size(), qs->size(), step / Real(scale)};
}

RealPoint in_units(const RealPoint& u, const Real& unit) { return {u.x / unit, u.y / unit}; }

}  // namespace

PhiCurves::PhiCurves(plane::Region a, plane::Region b)
    : a_(plane::closure(std::move(a))), b_(plane::closure(std::move(b))) {}

plane::Region PhiCurves::overlap() const {
  return plane::remark(plane::contact_map(*a_, *b_), [](plane::Mark m) { return plane::Mark(m < 0); });
}

ShapePhi::ShapePhi(const plane::Shape& a, const plane::Shape& b, const Real& step,
                   const std::function<std::array<plane::Region, 2>()>& regions)
    : step_(step), parts_(phi_by_parts(a, b, step)) {
  if (parts_) return;
  auto [first, second] = regions();
  curves_.emplace(std::move(first), std::move(second));
  pair_ = std::make_shared<const AtPosition>(std::make_shared<const ShapePair>(curves_->b(), curves_->a()));
}

PlanarAnswer ShapePhi::gap(const RealPoint& u) const {
  auto found = pair_->measure(Which::kGamma1, u);
  if (!found) throw Error(ErrorCode::kGeometry, "a Phi-function of a shape without a point");
  return *std::move(found);
}

ShapePhi::At ShapePhi::at(const RealPoint& u) const {
  if (parts_) {
    At out = parts_->phi.at(in_units(u, parts_->unit));
    const double unit = parts_->unit.to_double();
    for (double* length : {&out.at.phi, &out.at.normalised, &out.at.distance}) *length *= unit;
    return out;
  }
  const RealPoint p = in_units(u, step_);
  const PlanarAnswer found = gap(p);
  At out;
  const int sign = found.value.sign();
  out.at.state = space::state_of(sign);
  out.at.phi = out.at.normalised = (found.value * step_).to_double();
  out.at.distance = sign > 0 ? out.at.phi : 0;
  if (found.nearest && sign != 0) {
    const double x = (p.x - found.nearest->x).to_double(), y = (p.y - found.nearest->y).to_double();
    const double size = std::hypot(x, y) * sign;
    out.at.gradient = out.at.normalised_gradient = {x / size, y / size};
  }
  return out;
}

int ShapePhi::compare_distance(const RealPoint& u, const Real& rho) const {
  if (parts_) return parts_->phi.compare_distance(in_units(u, parts_->unit), rho / parts_->unit);
  return compare(gap(in_units(u, step_)).value * step_, rho);
}

}  // namespace findspace::distance
