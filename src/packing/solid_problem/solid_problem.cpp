// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_problem/solid_problem.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace findspace::packing {
namespace {

void extend(SolidBox& box, bool first, const space::Point& p, int128 steps) {
  const std::int64_t coordinates[] = {p.x, p.y, p.z};
  for (std::size_t k = 0; k < 3; ++k) {
    const Fraction c(coordinates[k], steps);
    box.low[k] = first ? c : std::min(box.low[k], c);
    box.high[k] = first ? c : std::max(box.high[k], c);
  }
}

}  // namespace

std::size_t SolidProblem::items() const {
  std::size_t count = 0;
  for (const SolidPart& part : parts) count += std::size_t(part.demand);
  return count;
}

std::optional<std::int64_t> common_scale(const space::Body& a, const space::Body& b) {
  const int128 common = int128(a.scale) / std::gcd(a.scale, b.scale) * b.scale;
  for (const space::Body* body : {&a, &b})
    for (const space::BodyPart& part : body->parts)
      for (const space::Point& p : part.vertices())
        for (const std::int64_t c : {p.x, p.y, p.z})
          if ((c < 0 ? -int128(c) : int128(c)) > space::kCoordinateLimit / (common / body->scale)) return std::nullopt;
  return std::int64_t(common);
}

exact::Real in_steps(const Fraction& value, int128 steps) {
  return exact::Real(value.numerator()) * exact::Real(steps) / exact::Real(value.denominator());
}

std::vector<AxisRotation> axis_rotations(bool upright) {
  std::vector<AxisRotation> result;
  std::array<std::size_t, 3> axes{0, 1, 2};
  do {
    const bool even = axes[1] == (axes[0] + 1) % 3;
    for (int signs = 0; signs < 8; ++signs) {
      AxisRotation rotation{};
      int sign = even ? 1 : -1;
      for (std::size_t k = 0; k < 3; ++k) {
        rotation[k][axes[k]] = (signs >> k & 1) != 0 ? -1 : 1;
        sign *= rotation[k][axes[k]];
      }
      if (sign == 1 && (!upright || rotation[2][2] == 1)) result.push_back(rotation);
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return result;
}

SolidForm turned(const SolidForm& form, const AxisRotation& rotation) {
  if (rotation == kAsGiven) return form;
  const auto turn = [&](const space::Point& p) {
    const auto row = [&](const std::array<int, 3>& r) { return r[0] * p.x + r[1] * p.y + r[2] * p.z; };
    return space::Point{row(rotation[0]), row(rotation[1]), row(rotation[2])};
  };
  SolidForm result;
  result.rotation = rotation;
  result.body.scale = form.body.scale;
  result.body.rounded = form.body.rounded;
  result.body.moved = form.body.moved;
  for (const space::BodyPart& part : form.body.parts) {
    std::vector<space::Point> corners;
    for (const space::Point& p : part.vertices()) corners.push_back(turn(p));
    result.body.parts.push_back(space::part_of(corners, {}));
  }
  result.surface = form.surface;
  for (space::RaySolid& solid : result.surface)
    for (space::Point& p : solid.surface.points) p = turn(p);
  return result;
}

SolidBox box_of(const SolidProblem& problem, const SolidForm& form) {
  SolidBox box;
  bool first = true;
  if (!form.is_exact()) {
    for (const space::RaySolid& solid : form.surface)
      for (const space::Point& p : solid.surface.points) {
        extend(box, first, p, problem.steps());
        first = false;
      }
    return box;
  }
  const int128 steps = bounded_product(problem.steps(), form.body.scale);
  for (const space::BodyPart& piece : form.body.parts)
    for (const space::Point& p : piece.vertices()) {
      extend(box, first, p, steps);
      first = false;
    }
  return box;
}

bool fits(const SolidProblem& problem, const SolidBox& box) {
  return box.high[0] - box.low[0] + problem.edge + problem.edge <= problem.width &&
         box.high[1] - box.low[1] + problem.edge + problem.edge <= problem.depth;
}

double volume_of(const SolidProblem& problem, const SolidPart& part) {
  const space::Body& body = part.forms[0].body;
  const double steps = double(problem.steps()) * double(body.scale);
  double sum = 0;
  for (const space::BodyPart& piece : body.parts) sum += piece.core ? piece.core->volume() : 0;
  return sum / steps / steps / steps;
}

double volume(const SolidProblem& problem) {
  double sum = 0;
  for (const SolidPart& part : problem.parts) sum += part.demand * volume_of(problem, part);
  return sum;
}

void check(const SolidProblem& problem, const std::string& place) {
  const Fraction width = problem.width - problem.edge - problem.edge,
                 depth = problem.depth - problem.edge - problem.edge;
  if (width <= 0 || depth <= 0) throw Error(ErrorCode::kBadValue, "the floor has no area within its edges", place);
  for (const SolidPart& part : problem.parts) {
    if (part.demand == 0) continue;
    const auto stands = [&](const SolidForm& form) { return fits(problem, box_of(problem, form)); };
    if (std::any_of(part.forms.begin(), part.forms.end(), stands)) continue;
    const SolidBox box = box_of(problem, part.forms[0]);
    throw Error(
        ErrorCode::kBadValue,
        fmt::format("'{}' is {} x {} wide: it does not stand on the floor of {} x {}", part.name,
                    (box.high[0] - box.low[0]).text(), (box.high[1] - box.low[1]).text(), width.text(), depth.text()),
        place);
  }
}

}  // namespace findspace::packing
