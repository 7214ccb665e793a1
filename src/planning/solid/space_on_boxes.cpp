// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "planning/solid/space_on_boxes.h"

#include <algorithm>

namespace findspace::planning {

using exact::Real;
using space::BoxComplex;
using space::Interval;
using space::IntervalBox;
using space::RealVector;

namespace {

using Boxes = std::vector<IntervalBox>;

/// What a goal is at best over some boxes, and the boxes where it is so.
struct Least {
  std::optional<Real> value;
  bool unbounded = false;
  Boxes at;
};

/// The face of a box on which the form is least; nothing where the box goes on for ever.
std::optional<Real> least_of_form(const IntervalBox& box, const RealVector& form, IntervalBox& face, bool& held) {
  Real value;
  face = box;
  held = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const int sign = form[k].sign();
    if (sign == 0) continue;
    const auto& end = sign > 0 ? box[k].from : box[k].to;
    if (!end) return std::nullopt;
    held = held && (sign > 0 ? box[k].from_in : box[k].to_in);
    face[k] = {*end, *end, true, true};
    value += form[k] * *end;
  }
  return value;
}

/// The point of a closed box nearest to p.
std::optional<Real> least_of_distance(const IntervalBox& box, const RealVector& p, IntervalBox& face, bool& held) {
  Real square;
  held = true;
  for (std::size_t k = 0; k < 3; ++k) {
    Real c = p[k];
    if (box[k].from && c <= *box[k].from) {
      c = *box[k].from;
      held = held && box[k].from_in;
    }
    if (box[k].to && *box[k].to <= c) {
      c = *box[k].to;
      held = held && box[k].to_in;
    }
    face[k] = {c, c, true, true};
    square += (c - p[k]) * (c - p[k]);
  }
  return square;
}

Least least(const Boxes& boxes, const SpaceGoal& goal) {
  Least out;
  for (const IntervalBox& box : boxes) {
    IntervalBox face;
    bool held = false;
    const auto value =
        goal.point ? least_of_distance(box, *goal.point, face, held) : least_of_form(box, goal.form, face, held);
    if (!value) {
      out = {{}, true, {}};
      return out;
    }
    const int order = out.value ? compare(*value, *out.value) : -1;
    if (order < 0) out = {value, false, {}};
    if (order <= 0 && held) out.at.push_back(face);
  }
  return out;
}

Real inside(const Interval& i) {
  if (i.from && i.to) return (*i.from + *i.to) / Real(2);
  return i.from ? *i.from + Real(1) : i.to ? *i.to - Real(1) : Real();
}

}  // namespace

Boxes with_fixed(Boxes boxes, const SpaceGoals& goals) {
  if (goals.none) return {};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!goals.fixed[k]) continue;
    const Real& c = *goals.fixed[k];
    std::erase_if(boxes, [&](const IntervalBox& box) {
      const Interval& i = box[k];
      const int low = i.from ? compare(c, *i.from) : 1, high = i.to ? compare(c, *i.to) : -1;
      return low < 0 || high > 0 || (low == 0 && !i.from_in) || (high == 0 && !i.to_in);
    });
    for (IntervalBox& box : boxes) box[k] = {c, c, true, true};
  }
  return boxes;
}

SpaceBest best_on_boxes(const BoxComplex& positions, const SpaceGoals& goals, const Real& step, Pick pick) {
  SpaceBest out;
  Boxes boxes = with_fixed(positions.boxes(), goals);
  for (const auto& f : goals.fixed)
    if (f) out.values.push_back(std::nullopt);
  if (boxes.empty()) return out;
  for (const SpaceGoal& goal : goals.all) {
    Least best = least(boxes, goal);
    out.values.push_back(!best.value ? best.value : goal.point ? sqrt(*best.value) * step : *best.value * step);
    out.unbounded = best.unbounded;
    if (best.at.empty()) {
      out.attained = false;
      if (pick == Pick::kBest) return out;
      break;
    }
    boxes = std::move(best.at);
  }
  for (const RealVector& tie : tie_forms()) {
    Least best = least(boxes, {tie, std::nullopt});
    if (best.at.empty()) break;
    boxes = std::move(best.at);
  }
  const IntervalBox& box = boxes.front();
  out.at = {inside(box[0]), inside(box[1]), inside(box[2])};
  return out;
}

}  // namespace findspace::planning
