// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/solid/optimize_line.h"

#include <algorithm>

#include "findspace/error.h"

namespace findspace::formula {
namespace {

using exact::Real;
using plane::LineInterval;
using space::RealVector;

/// An objective on a line: it grows with `rate` * t, or with |t - projection|.
struct OnLine {
  Real rate;
  std::optional<Real> projection;

  Real order(const Real& t) const { return projection ? abs(t - *projection) : rate * t; }
  /// The sign of what it does for ever: +1 if it grows without bound.
  int far(bool forward) const { return projection ? 1 : forward ? rate.sign() : -rate.sign(); }
};

struct LinePlace {
  Real t;
  bool in = false;
};

/// Where an extremum over one interval can be.
std::vector<LinePlace> candidates(const LineInterval& i, const OnLine& f) {
  std::vector<LinePlace> out;
  if (i.from) out.push_back({*i.from, i.from_in});
  if (i.to) out.push_back({*i.to, i.to_in});
  if (f.projection && (!i.from || *i.from < *f.projection) && (!i.to || *f.projection < *i.to))
    out.push_back({*f.projection, true});
  return out;
}

OnLine on_line(const Objective& objective, const SpaceLine& line, const Real& step) {
  const RealVector along = space::scaled(Real(1) / sqrt(space::dot(line.direction, line.direction)), line.direction);
  switch (objective.kind) {
    case Objective::Kind::kX:
      return {along[0], std::nullopt};
    case Objective::Kind::kY:
      return {along[1], std::nullopt};
    case Objective::Kind::kZ:
      return {along[2], std::nullopt};
    case Objective::Kind::kDistanceToPoint: {
      RealVector off;
      for (std::size_t k = 0; k < 3; ++k) off[k] = objective.point.at(k) / step - line.through[k];
      return {Real(), space::dot(off, along)};
    }
    case Objective::Kind::kSum:  // refused where it is read
    case Objective::Kind::kDistance:
      break;
  }
  throw Error(ErrorCode::kUnsupported, "on a line in 3D the objectives are x, y, z and the distance to a point");
}

Real value_at(const Objective& objective, const SpaceLine& line, const Real& step, const Real& t) {
  const RealVector p = space::along(line.through, t / sqrt(space::dot(line.direction, line.direction)), line.direction);
  if (objective.kind != Objective::Kind::kDistanceToPoint)
    return p[objective.kind == Objective::Kind::kX ? 0 : objective.kind == Objective::Kind::kY ? 1 : 2] * step;
  RealVector off;
  for (std::size_t k = 0; k < 3; ++k) off[k] = objective.point.at(k) - p[k] * step;
  return sqrt(space::dot(off, off));
}

/// The value as far as a set on that side of the true one tells it.
void set_value(LineOptimum& out, const Real& value, Side side) {
  if (side == Side::kExact) return out.set_exact(value, distance::Way::kLines);
  if (side == Side::kInner) return out.set_enclosed(value, std::nullopt, distance::Way::kLines);
  out.set_nearby(value, side == Side::kOuter ? std::optional(value) : std::nullopt, distance::Way::kLines);
  out.attained = false;
}

}  // namespace

LineOptimum optimize(const std::vector<LineInterval>& set, const SpaceLine& line, const Real& step,
                     const Objective& objective, distance::Sense sense, Side side) {
  const OnLine f = on_line(objective, line, step);
  const int way = sense == distance::Sense::kMaximum ? -1 : 1;
  auto out = distance::no_optimum<std::vector<LineInterval>>(sense);
  if (set.empty()) return out;
  if (!f.projection && f.rate.sign() == 0) {  // the same everywhere
    out.attained = true;
    out.at = set;
    set_value(out, value_at(objective, line, step, Real()), side);
    return out;
  }
  std::vector<LinePlace> places;
  for (const LineInterval& i : set) {
    out.unbounded = out.unbounded || (!i.from && f.far(false) == -way) || (!i.to && f.far(true) == -way);
    for (LinePlace& p : candidates(i, f)) places.push_back(std::move(p));
  }
  if (out.unbounded) return out;
  const auto better = [&](const LinePlace& a, const LinePlace& b) {
    return compare(f.order(a.t), f.order(b.t)) * way < 0;
  };
  const LinePlace best = *std::min_element(places.begin(), places.end(), better);
  std::erase_if(places, [&](const LinePlace& p) { return better(best, p); });
  out.attained = std::any_of(places.begin(), places.end(), [](const LinePlace& p) { return p.in; });
  if (out.attained) std::erase_if(places, [](const LinePlace& p) { return !p.in; });
  for (const LinePlace& p : places) {
    if (out.at.empty() || !(*out.at.back().from == p.t)) out.at.push_back({p.t, p.t, true, true});
  }
  set_value(out, value_at(objective, line, step, best.t), side);
  return out;
}

}  // namespace findspace::formula
