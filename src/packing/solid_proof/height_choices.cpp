// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_proof/height_choices.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace findspace::packing {
namespace {

using exact::Interval;

Interval exactly(double x) { return {x, x}; }
Interval enclosure(const Fraction& value) {
  return exact::enclose(value.numerator()) / exact::enclose(value.denominator());
}

}  // namespace

HeightChoices::HeightChoices(const SolidProblem& problem, const SolidTable& table, std::vector<std::size_t> copies,
                             double height)
    : problem_(problem), table_(table), copies_(std::move(copies)), rows_(bounds(height), table.size()) {
  add_lids();
  add_orders();
  add_choices();
}

/// Of the columns.
std::vector<Interval> HeightChoices::bounds(double height) const {
  std::vector<Interval> result;
  double tallest = 0;
  const auto add = [&](const Fraction& low, const Interval& high) {
    result.push_back({enclosure(low).lo, std::max(enclosure(low).lo, high.hi)});
  };
  for (const std::size_t variant : copies_) {
    const SolidBox box = box_of(problem_, form_of(variant));
    const Fraction& edge = problem_.edge;
    add(edge - box.low[0], enclosure(problem_.width - edge - box.high[0]));
    add(edge - box.low[1], enclosure(problem_.depth - edge - box.high[1]));
    add(edge - box.low[2], exactly(height) - enclosure(edge + box.high[2]));
    tallest = std::max(tallest, enclosure(box.high[2] - box.low[2] + edge + edge).lo);
  }
  result.push_back({std::min(tallest, height), height});
  return result;
}

const SolidForm& HeightChoices::form_of(std::size_t variant) const {
  const SolidVariant& v = table_.variants()[variant];
  return problem_.parts[v.part].forms[v.form];
}

void HeightChoices::add_lids() {
  for (std::size_t i = 0; i < copies_.size(); ++i) {
    CertainRow lid;
    lid.add(3 * copies_.size(), exactly(1));
    lid.add(3 * i + 2, exactly(-1));
    lid.set_right(enclosure(box_of(problem_, form_of(copies_[i])).high[2] + problem_.edge));
    always_.push_back(rows_.add(lid));
  }
}

/// Of equal parts the later one is not lower.
void HeightChoices::add_orders() {
  for (std::size_t i = 0; i + 1 < copies_.size(); ++i) {
    if (copies_[i] != copies_[i + 1]) continue;
    CertainRow order;
    order.add(3 * (i + 1) + 2, exactly(1));
    order.add(3 * i + 2, exactly(-1));
    order.set_right(exactly(0));
    always_.push_back(rows_.add(order));
  }
}

void HeightChoices::add_choices() {
  for (std::size_t a = 0; a < copies_.size(); ++a)
    for (std::size_t b = a + 1; b < copies_.size(); ++b) {
      const space::Body &first = form_of(copies_[a]).body, &second = form_of(copies_[b]).body;
      const std::optional<std::int64_t> scale = common_scale(first, second);
      if (!scale) continue;  // fewer rows, a lower bound
      const double unit = double(problem_.steps()) * double(*scale);
      const std::vector<space::BodyPart> others = space::at_scale(second, *scale).parts;
      for (const space::BodyPart& p : space::at_scale(first, *scale).parts)
        for (const space::BodyPart& q : others) add_choice(a, b, space::ContactSurface(*p.core, *q.core), unit);
    }
}

/// normal . (at of b - at of a) x unit + offset >= 0 separates; it is divided by the length of the normal and the unit.
void HeightChoices::add_choice(std::size_t a, std::size_t b, const space::ContactSurface& surface, double unit) {
  Choice choice;
  for (int f = 0; f < surface.facet_count(); ++f) {
    const space::Plane plane = surface.plane(f);
    const Interval normal[] = {exact::enclose(plane.normal.x), exact::enclose(plane.normal.y),
                               exact::enclose(plane.normal.z)};
    const double length = std::hypot(normal[0].lo, normal[1].lo, normal[2].lo);
    const Interval offset = exact::enclose(plane.offset) / exactly(length) / exactly(unit);
    CertainRow row, other;
    for (std::size_t k = 0; k < 3; ++k) {
      const Interval factor = normal[k] / exactly(length);
      row.add(3 * b + k, factor);
      row.add(3 * a + k, -factor);
      other.add(3 * b + k, -factor);
      other.add(3 * a + k, factor);
    }
    row.set_right(-offset);
    other.set_right(offset);
    choice.rows.push_back(rows_.add(row));
    rows_.add(other);
  }
  choices_.push_back(std::move(choice));
}

double HeightChoices::overlap(const Choice& choice, const std::vector<double>& vertex) const {
  double least = exact::kInfinity;
  for (const std::size_t row : choice.rows) least = std::min(least, rows_[row].lack(vertex));
  return least;
}

std::vector<SolidPose> HeightChoices::poses(const std::vector<double>& vertex) const {
  std::vector<SolidPose> result;
  const double edge = table_.edge();
  for (std::size_t i = 0; i < copies_.size(); ++i)
    result.push_back({copies_[i], {vertex[3 * i] - edge, vertex[3 * i + 1] - edge, vertex[3 * i + 2] - edge}});
  return result;
}

}  // namespace findspace::packing
